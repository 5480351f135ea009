// [body] and the names of its parts.
#include "keys.hpp"

namespace tlsph {
namespace {

/// Where nodes can follow the boundary.
bool may_fit(const BodyScene& body, const Scene& scene) {
  return is_adjoint(scene.formulation) && scene.dimension == 2 &&
         body.placement == NodePlacement::on_boundary;
}

/// What goes with scattered nodes.
void check_cloud(const BodyScene& body, const TableView& view, const Scene& scene) {
  if (view.has("cloud") && body.cloud.empty())
    throw InputError(body.cloud_place, "must name a file of points, relative to the scene");
  if (body.cloud.empty()) view.require("spacing");
  if (body.layout == Layout::hexagonal && scene.dimension == 1)
    throw InputError(view.place_of("layout"), "nodes in 1D stand in one row; allowed: square");
  if (!body.cloud.empty() && view.has("layout"))
    throw InputError(view.place_of("layout"),
                     "the nodes come from body.cloud as they are; leave it out");
  if (!body.cloud.empty() && body.jitter > 0.0)
    throw InputError(view.place_of("jitter"),
                     "the nodes come from body.cloud as they are; allowed: 0");
  if (!body.is_cloud()) return;
  const char* key = body.cloud.empty() ? "layout" : "cloud";
  if (!is_adjoint(scene.formulation))
    fail_at(view.place_of(key),
            "{} needs nodes on a square lattice; irregular and hexagonal "
            "ones: {}",
            name_of(scene.formulation), adjoint_formulations());
  if (body.placement == NodePlacement::cell_centred)
    fail_at(view.place_of("placement"), "body.{} puts nodes on the boundary; allowed: on-boundary",
            key);
  if (scene.dimension == 2 && !body.fit)
    fail_at(view.place_of("fit"), "body.{} makes nodes follow the boundary; allowed: true", key);
}

void check_body(BodyScene& body, const TableView& view, const Scene& scene) {
  if (body.fit && !may_fit(body, scene))
    fail_at(view.place_of("fit"),
            "nodes can follow the boundary in 2D, placed on it, with formulation = {} only; "
            "allowed here: false",
            adjoint_formulations());
  check_cloud(body, view, scene);
}

void check_tag(NamedBox& tag, const TableView& view, const Scene& scene) {
  if (tag.name.empty())
    throw InputError(view.place_of("name"), "must not be empty: [[boundary]] where refers to it");
  for (const NamedBox& other : scene.body.tags)
    if (&other != &tag && other.name == tag.name)
      fail_at(view.place_of("name"), "\"{}\" is already the name of another tag", other.name);
}

}  // namespace

const Table<BodyScene>& body_keys() {
  static const Table<BodyScene> keys = {
      "body",
      {
          key(&BodyScene::shape, "shape", "m", {},
              "an interval in 1D; a box, disc, polygon or difference of them in 2D")
              .required(),
          key(&BodyScene::cloud, "cloud", "", {},
              "file of points instead of a lattice, path relative to the scene's folder: a header "
              "line x,y[,volume][,tag] (1D: x[,volume][,tag]), then a line per node. They fill the "
              "shape, its corners among them; those on its outline make the boundary. Without "
              "volumes each node has its Voronoi cell; a tag names nodes for [[boundary]] where, "
              "several separated by spaces. Nodes in an order that jumps about are put in strips; "
              "run.h5 says which line each is. For " +
                  adjoint_formulations() +
                  " (one point per edge of the triangles between them; locks as poisson nears "
                  "0.5). One kernel.support serves them all, so their distances should not differ "
                  "by more than about half")
              .otherwise("(none)")
              .at(&BodyScene::cloud_place),
          key(&BodyScene::spacing, "spacing", "m", above(0.0),
              "distance of neighbouring nodes, taken to the nearest division of the body; a change "
              "of more than 1 % is refused, but for fitted discs and polygons. Of a cloud: the "
              "unit "
              "of kernel.support")
              .otherwise("(required; of a cloud: estimated)")
              .at(&BodyScene::spacing_place),
          key(&BodyScene::layout, "layout", "", {},
              "rows and columns, or rows shifted by half a spacing so that each node has six "
              "neighbours (2D, " +
                  adjoint_formulations() + "; see cloud)"),
          key(&BodyScene::placement, "placement", "", {},
              "nodes on the boundary (with half and quarter volumes), or at the centres of the "
              "cells"),
          key(&BodyScene::fit, "fit", "", {},
              "nodes follow curved and slanted edges instead of approaching them in stairs. "
              "Polygons with angles from 20 to 340 degrees, edges of two spacings and parts two "
              "spacings wide are always filled, by cells whose corners have a sine >= 0.1 and a "
              "Jacobian >= 0.1 spacing^2",
              "(true for " + adjoint_formulations() + ", on-boundary, 2D)", may_fit),
          key(&BodyScene::jitter, "jitter", "spacings", closed(0.0, 0.4),
              "largest random shift of interior nodes"),
          key(&BodyScene::seed, "seed", "", not_below(0.0), "of the random shifts"),
          list_key(&BodyScene::tags, tag_keys(), "tags",
                   "names for parts of the body, beside those that boundary.where lists"),
      },
      check_body};
  return keys;
}

const Table<NamedBox>& tag_keys() {
  static const Table<NamedBox> keys = {
      "tag",
      {
          key(&NamedBox::name, "name", "", {}, "what [[boundary]] where calls this part")
              .required(),
          box_key<NamedBox>(
              "[[x0, y0], [x1, y1]], in 1D [from, to]: fixed, held, symmetry and displacement act "
              "on the nodes in it, traction on all of the boundary in it, cut where it leaves the "
              "box (plan says how much of both). A box around one node loads the edges next to "
              "that node as far as the box reaches"),
      },
      check_tag};
  return keys;
}

}  // namespace tlsph
