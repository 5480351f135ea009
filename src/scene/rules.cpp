#include "rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// The axis a patch of a box (with or without holes) faces, −1 if it is not known before the nodes
/// are.
int normal_axis(const Scene& scene, const std::string& patch) {
  const auto* sheet = std::get_if<Shape<2>>(&scene.body.shape);
  if (sheet && !std::holds_alternative<Box<2>>(base_of(*sheet).form)) return -1;
  if (patch == "left" || patch == "right") return 0;
  if (patch == "top" || patch == "bottom") return 1;
  return -1;
}

void check_ghosts(const Scene& scene, const TableView& root) {
  if (scene.formulation != Formulation::thesis)
    for (const char* name : {"boundary_treatment", "boundary_solver"})
      if (root.has(name))
        throw InputError(root.place_of(name),
                         fmt::format("is for formulation = \"thesis\", not \"{}\"; leave it out",
                                     name_of(scene.formulation)));
  if (scene.ghosts == GhostClosure::eta && scene.dimension != 1)
    throw InputError(root.place_of("boundary_treatment"),
                     "the eta corrections exist in 1D only; allowed in 2D: consistent, as-printed");
  if (scene.ghosts == GhostClosure::eta && root.has("boundary_solver"))
    throw InputError(root.place_of("boundary_solver"),
                     "the eta corrections factorise no matrix; leave it out");
}

/// The mirror extension reflects about straight, axis-aligned edges with loads normal to them.
void check_mirror(const Scene& scene) {
  if (scene.formulation != Formulation::mirror) return;
  if (!is_box(scene))
    throw InputError(scene.formulation_place,
                     "mirror reflects about straight, axis-aligned edges: the shape must be an "
                     "interval or a box; other shapes: " +
                         adjoint_formulations());
  for (const auto& boundary : scene.boundaries)
    for (const auto& load : boundary.traction)
      if (load.component != normal_axis(scene, boundary.where))
        throw InputError(
            boundary.place,
            "mirror takes loads normal to the edge only; shear loads: " + adjoint_formulations());
}

/// Formulations with ghosts know one displacement for a whole edge.
void check_held(const Scene& scene) {
  if (is_adjoint(scene.formulation)) return;
  for (const auto& boundary : scene.boundaries)
    if (!boundary.held.empty())
      throw InputError(boundary.place,
                       fmt::format("{} cannot keep an edge at an initial displacement that differs "
                                   "from node to node; give displacement = {{ x = … }}, or use {}",
                                   name_of(scene.formulation), adjoint_formulations()));
}

void check_kernel(const Scene& scene, const TableView& root) {
  const TableView kernel = root.table("kernel");
  const bool adjoint = is_adjoint(scene.formulation);
  if (!adjoint && scene.kernel.correction != Correction::none)
    throw InputError(kernel.place_of("correction"),
                     fmt::format("{} uses plain SPH sums; allowed: none (corrected gradients: "
                                 "variational)",
                                 name_of(scene.formulation)));
}

/// Gradients of degree two are least-squares fits over a support.
void check_order(const Scene& scene, const TableView& root) {
  if (scene.kernel.order == 1) return;
  const Place place = root.table("kernel").place_of("order");
  if (!is_adjoint(scene.formulation))
    throw InputError(place, fmt::format("{} uses plain SPH sums; allowed: 1 (order 2: {})",
                                        name_of(scene.formulation), adjoint_formulations()));
  if (scene.kernel.correction != Correction::least_squares)
    throw InputError(place, fmt::format("the correction \"{}\" is exact for linear fields only; "
                                        "allowed: 1 (order 2: least-squares)",
                                        name_of(scene.kernel.correction)));
  if (!scene.kernel.support)
    throw InputError(place, "the nodes of a cell determine no quadratic fit; give kernel.support");
}

void check_consistency(const Scene& scene) {
  if (!scene.consistency) return;
  const Place& place = scene.consistency->place;
  if (!is_adjoint(scene.formulation))
    throw InputError(place, fmt::format("{} has no adjoint to make exact; leave it out, or use "
                                        "formulation = \"consistent\"",
                                        name_of(scene.formulation)));
  if (scene.formulation == Formulation::variational)
    throw InputError(place,
                     "variational gradients stay as they are; a corrected one is "
                     "formulation = \"consistent\"");
  if (scene.formulation == Formulation::stress_point &&
      (scene.consistency->rows != 1 || scene.consistency->columns != 0))
    throw InputError(place,
                     "stress points are corrected to degrees [1, 0]; higher ones: "
                     "formulation = \"consistent\"");
}

void check_placement(const Scene& scene, const TableView& root) {
  const TableView body = root.table("body");
  if (scene.formulation == Formulation::variational) return;
  const auto name = name_of(scene.formulation);
  if (scene.body.placement == NodePlacement::cell_centred)
    throw InputError(body.place_of("placement"),
                     fmt::format("{} needs nodes on the boundary; allowed: on-boundary "
                                 "(cell-centred nodes: variational)",
                                 name));
  if (scene.body.jitter > 0.0 && !is_adjoint(scene.formulation))
    throw InputError(body.place_of("jitter"),
                     fmt::format("{} needs nodes on a lattice; allowed: 0 (irregular nodes: {})",
                                 name, adjoint_formulations()));
}

void check_stabiliser(const Scene& scene, const TableView& root) {
  const TableView stabiliser = root.table("stabiliser");
  const Place place = stabiliser.place_of("kind");
  if (scene.stabiliser.kind == StabiliserKind::none) {
    for (const char* name : {"coefficient", "as"})
      if (stabiliser.has(name))
        throw InputError(stabiliser.place_of(name),
                         "there is no stabiliser here to apply it to; set kind to pair or cell, or "
                         "leave it out");
    return;
  }
  if (scene.stabiliser.kind == StabiliserKind::cell) {
    if (scene.formulation != Formulation::stress_point || scene.dimension != 2)
      throw InputError(place,
                       "cell holds the hourglass mode of one stress point per cell: it needs "
                       "formulation = \"stress-point\" in 2D; allowed here: none, pair");
    if (scene.kernel.support)
      throw InputError(place,
                       "cell goes with the gradient over the nodes of each cell; leave "
                       "kernel.support out, or use pair");
    if (scene.body.is_cloud())
      throw InputError(place,
                       "cell holds the hourglass mode of quadrilaterals, which the triangles of "
                       "a cloud do not have; allowed: none, pair");
  } else if (!is_adjoint(scene.formulation)) {
    throw InputError(
        place, fmt::format("{} takes no stabiliser; allowed: none", name_of(scene.formulation)));
  }
}

template <int D>
Vector<D> point(const std::vector<double>& x) {
  return Eigen::Map<const Vector<D>>(x.data());
}

template <int D>
void check_positions_in(const Scene& scene) {
  const auto& shape = std::get<Shape<D>>(scene.body.shape);
  const Box<D> bounds = bounding_box(shape);
  const auto extent = [&](int a) {
    return fmt::format("[{}, {}]", bounds.lower(a), bounds.upper(a));
  };
  std::string whole = extent(0);
  for (int a = 1; a < D; ++a) whole += " x " + extent(a);
  for (const auto& probe : scene.probes)
    if (!contains(shape, point<D>(probe.at)))
      throw InputError(probe.place, fmt::format("probe {} at [{}] is outside the body, which fills "
                                                "{}{}",
                                                probe.name, fmt::join(probe.at, ", "),
                                                is_box(scene) ? "" : "part of ", whole));
  const auto apart = [&](const std::vector<double>& lower, const std::vector<double>& upper) {
    for (int a = 0; a < D; ++a)
      if (lower[static_cast<std::size_t>(a)] > bounds.upper(a) ||
          upper[static_cast<std::size_t>(a)] < bounds.lower(a))
        return true;
    return false;
  };
  for (const auto& material : scene.materials)
    if (!material.lower.empty() && apart(material.lower, material.upper))
      throw InputError(
          material.place,
          fmt::format("empty region: its box lies outside the body, which fills {}", whole));
  for (const auto& region : scene.initial_regions)
    if (apart(region.lower, region.upper))
      throw InputError(
          region.place,
          fmt::format("empty region: its box lies outside the body, which fills {}", whole));
  for (const auto& tag : scene.body.tags)
    if (apart(tag.lower, tag.upper))
      throw InputError(tag.place,
                       fmt::format("tag {} is empty: its box lies outside the body, which "
                                   "fills {}",
                                   tag.name, whole));
}

/// What one entry demands of one component.
enum class Claim { held, kept, moved, loaded };

struct Claims {
  std::array<const BoundaryScene*, 2> by = {nullptr, nullptr};
  std::array<Claim, 2> kind = {Claim::held, Claim::held};
  const BoundaryScene* normal_load = nullptr;
};

std::string words(Claim claim, const char* component) {
  switch (claim) {
    case Claim::held:
      return fmt::format("holds {} at zero", component);
    case Claim::kept:
      return fmt::format("keeps {} where it starts", component);
    case Claim::moved:
      return fmt::format("moves {}", component);
    default:
      return fmt::format("loads {}", component);
  }
}

void claim(Claims& claims, const BoundaryScene& entry, int component, Claim kind) {
  const auto c = static_cast<std::size_t>(component);
  const char* name = component == 0 ? "x" : "y";
  const BoundaryScene* other = claims.by[c];
  if (other && !(claims.kind[c] == Claim::held && kind == Claim::held))
    throw InputError(
        entry.place,
        fmt::format("contradiction on \"{}\": {} {}, and {} {}; one condition for each "
                    "component",
                    entry.where, other == &entry ? "this entry" : other->place.key,
                    words(claims.kind[c], name), other == &entry ? "also" : "this entry",
                    words(kind, name)));
  claims.by[c] = &entry;
  claims.kind[c] = kind;
}

}  // namespace

void check_formulation(const Scene& scene, const TableView& root) {
  check_ghosts(scene, root);
  check_mirror(scene);
  check_held(scene);
  check_kernel(scene, root);
  check_order(scene, root);
  check_consistency(scene);
  check_placement(scene, root);
  check_stabiliser(scene, root);
}

void check_positions(const Scene& scene) {
  in_dimension(scene.dimension, [&]<int D>() { check_positions_in<D>(scene); });
}

void check_boundaries(const Scene& scene) {
  std::map<std::string, Claims> patches;
  for (const auto& entry : scene.boundaries) {
    Claims& claims = patches[entry.where];
    const int normal = normal_axis(scene, entry.where);
    for (const int component : entry.fixed) claim(claims, entry, component, Claim::held);
    for (const int component : entry.held) claim(claims, entry, component, Claim::kept);
    if (entry.symmetry && normal >= 0) claim(claims, entry, normal, Claim::held);
    for (const auto& motion : entry.motion) claim(claims, entry, motion.component, Claim::moved);
    for (const auto& load : entry.traction) claim(claims, entry, load.component, Claim::loaded);
    if (!entry.normal_traction) continue;
    if (entry.symmetry || claims.normal_load)
      throw InputError(
          entry.place,
          fmt::format("contradiction on \"{}\": a normal traction, but {}; one "
                      "condition for each component",
                      entry.where,
                      entry.symmetry ? "symmetry holds the normal displacement"
                                     : claims.normal_load->place.key + " gives one too"));
    claims.normal_load = &entry;
    if (normal >= 0) claim(claims, entry, normal, Claim::loaded);
  }
  // Where the normal is not known yet, a normal load still needs a component that is free to move.
  for (const auto& [where, claims] : patches) {
    const auto constrained = [&, n = claims](std::size_t c) {
      return n.by[c] && n.kind[c] != Claim::loaded;
    };
    if (claims.normal_load && constrained(0) && (scene.dimension == 1 || constrained(1)))
      throw InputError(
          claims.normal_load->place,
          fmt::format("contradiction on \"{}\": a traction where every component of the "
                      "displacement is given",
                      where));
  }
}

}  // namespace tlsph
