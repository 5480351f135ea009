#include "read_body.hpp"

#include <fmt/format.h>

#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

std::string per_dimension(int dimension) {
  return dimension == 1 ? "x, as dimension = 1" : "x and y, as dimension = 2";
}

Vector<2> read_point(const Node& node) {
  const auto x = read_vector(node, 2, "x and y");
  return {x[0], x[1]};
}

/// The one key of a shape table.
const Node& only_form(const TableView& view, int dimension) {
  const auto& entries = *view.node()->table();
  const char* allowed = dimension == 1 ? "interval" : "box, disc, polygon or difference";
  if (entries.size() != 1)
    throw InputError(view.place(), fmt::format("must have exactly one of {}, not {}", allowed,
                                               entries.empty() ? "none" : "several"));
  if ((dimension == 1) != (entries.front().name == "interval"))
    throw InputError(entries.front().place,
                     fmt::format("no shape in dimension {}; allowed: {}", dimension, allowed));
  return entries.front().value;
}

Shape<1> read_shape_1d(const TableView& view) {
  const Node& node = only_form(view, 1);
  const auto ends = read_vector(node, 2, "from and to");
  auto shape = make_interval(ends[0], ends[1]);
  validate(shape, node.place);
  return shape;
}

Shape<2> read_shape_2d(const TableView& view);

Shape<2> read_difference(const TableView& view, const Node& node) {
  const auto parts = view.tables("difference");
  if (parts.size() < 2)
    throw InputError(node.place, "must be [shape, hole, …], a shape and at least one hole");
  std::vector<Shape<2>> holes;
  for (std::size_t i = 1; i < parts.size(); ++i) holes.push_back(read_shape_2d(parts[i]));
  return make_difference(read_shape_2d(parts[0]), std::move(holes));
}

Shape<2> read_shape_2d(const TableView& view) {
  const Node& node = only_form(view, 2);
  Shape<2> shape;
  if (view.has("box")) {
    const auto [lower, upper] = read_box(node, 2);
    shape = make_box<2>({lower[0], lower[1]}, {upper[0], upper[1]});
  } else if (view.has("disc")) {
    const TableView disc = view.table("disc");
    shape = make_disc(read_point(disc.require("centre")), disc.number("radius"));
  } else if (view.has("polygon")) {
    std::vector<Vector<2>> corners;
    for (const Node& corner : *node.list()) corners.push_back(read_point(corner));
    shape = make_polygon(std::move(corners));
  } else {
    shape = read_difference(view, node);
  }
  validate(shape, node.place);
  return shape;
}

NamedBox read_tag(const TableView& view, int dimension) {
  NamedBox tag{view.text("name"), {}, {}, view.place()};
  const auto corners = read_box(view.require("box"), dimension);
  tag.lower = corners.lower;
  tag.upper = corners.upper;
  if (tag.name.empty())
    throw InputError(view.place_of("name"), "must not be empty: [[boundary]] where refers to it");
  return tag;
}

/// What goes with scattered nodes.
void check_cloud(const BodyScene& body, const TableView& view, int dimension,
                 Formulation formulation) {
  if (body.layout == Layout::hexagonal && dimension == 1)
    throw InputError(view.place_of("layout"), "nodes in 1D stand in one row; allowed: square");
  if (!body.cloud.empty() && view.has("layout"))
    throw InputError(view.place_of("layout"),
                     "the nodes come from body.cloud as they are; leave it out");
  if (!body.cloud.empty() && body.jitter > 0.0)
    throw InputError(view.place_of("jitter"),
                     "the nodes come from body.cloud as they are; allowed: 0");
  if (!body.is_cloud()) return;
  const char* key = body.cloud.empty() ? "layout" : "cloud";
  if (!is_adjoint(formulation))
    throw InputError(view.place_of(key),
                     fmt::format("{} needs nodes on a square lattice; irregular and hexagonal "
                                 "ones: {}",
                                 name_of(formulation), adjoint_formulations()));
  if (body.placement == NodePlacement::cell_centred)
    throw InputError(view.place_of("placement"),
                     fmt::format("body.{} puts nodes on the boundary; allowed: on-boundary", key));
  if (dimension == 2 && !body.fit)
    throw InputError(view.place_of("fit"),
                     fmt::format("body.{} makes nodes follow the boundary; allowed: true", key));
}

}  // namespace

CornerPair read_box(const Node& node, int dimension) {
  const auto& list = *node.list();
  if (list.size() != 2)
    throw InputError(node.place,
                     fmt::format("must be two corners, [lower, upper], not {}", list.size()));
  CornerPair corners;
  if (list[0].is_number() && dimension != 1)
    throw InputError(node.place, "must be [[x0, y0], [x1, y1]], as dimension = 2");
  if (list[0].is_number()) {
    corners = {{list[0].number()}, {list[1].number()}};
  } else {
    corners = {read_vector(list[0], dimension, per_dimension(dimension)),
               read_vector(list[1], dimension, per_dimension(dimension))};
  }
  for (int a = 0; a < dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (!(corners.lower[axis] <= corners.upper[axis]))
      throw InputError(node.place, fmt::format("the lower corner must not be above the upper one, "
                                               "but in {} {} > {}",
                                               "xy"[a], corners.lower[axis], corners.upper[axis]));
  }
  return corners;
}

BodyScene read_body(const TableView& view, int dimension, Formulation formulation) {
  BodyScene body;
  body.place = view.place();
  view.require("shape");
  if (dimension == 1)
    body.shape = read_shape_1d(view.table("shape"));
  else
    body.shape = read_shape_2d(view.table("shape"));
  if (view.has("cloud")) {
    body.cloud = view.text("cloud");
    body.cloud_place = view.place_of("cloud");
    if (body.cloud.empty())
      throw InputError(body.cloud_place, "must name a file of points, relative to the scene");
  } else {
    view.require("spacing");
  }
  if (view.has("spacing")) body.spacing = view.number("spacing");
  body.spacing_place = view.place_of("spacing");
  body.layout = view.choice<Layout>("layout");
  body.placement = view.choice<NodePlacement>("placement");
  const bool may_fit =
      is_adjoint(formulation) && dimension == 2 && body.placement == NodePlacement::on_boundary;
  body.fit = view.has("fit") ? view.flag("fit") : may_fit;
  if (body.fit && !may_fit)
    throw InputError(
        view.place_of("fit"),
        fmt::format(
            "nodes can follow the boundary in 2D, placed on it, with formulation = {} only; "
            "allowed here: false",
            adjoint_formulations()));
  body.jitter = view.number("jitter");
  body.seed = static_cast<std::uint64_t>(view.integer("seed"));
  check_cloud(body, view, dimension, formulation);
  for (const TableView& tag : view.tables("tags")) {
    for (const NamedBox& other : body.tags)
      if (other.name == tag.text("name"))
        throw InputError(tag.place_of("name"),
                         fmt::format("\"{}\" is already the name of another tag", other.name));
    body.tags.push_back(read_tag(tag, dimension));
  }
  return body;
}

}  // namespace tlsph
