#include "rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

void check_ghosts(const Scene& scene, const TableView& root) {
  const auto has_ghosts = [](const FormulationTraits& row) {
    return row.closure == Closure::ghosts;
  };
  if (!has_ghosts(traits_of(scene.formulation)))
    for (const char* name : {"boundary_treatment", "boundary_solver"})
      if (root.has(name))
        fail_at(root.place_of(name), "is for formulation = \"{}\", not \"{}\"; leave it out",
                formulations_where(has_ghosts), name_of(scene.formulation));
  if (scene.ghosts == GhostClosure::eta && scene.dimension != 1)
    throw InputError(root.place_of("boundary_treatment"),
                     "the eta corrections exist in 1D only; allowed in 2D: consistent, as-printed");
  if (scene.ghosts == GhostClosure::eta && root.has("boundary_solver"))
    throw InputError(root.place_of("boundary_solver"),
                     "the eta corrections factorise no matrix; leave it out");
}

/// Fields that go on beyond a box know one displacement for each side, and loads normal to it.
void check_sides(const Scene& scene) {
  if (is_adjoint(scene.formulation)) return;
  const auto refuse = [&](const Place& place, std::string_view what) {
    fail_at(place, "{} {}: {}", name_of(scene.formulation), what, adjoint_formulations());
  };
  if (!is_box(scene))
    refuse(scene.formulation_place,
           "reflects about straight, axis-aligned edges: the shape must be an interval or a box, "
           "undisturbed; other shapes");
  for (const BoundaryScene& entry : scene.boundaries) {
    const int axis = patch_axis(scene, entry.where);
    if (axis == unknown_axis)
      refuse(entry.place, "knows whole edges only, left, right, bottom and top; parts of them");
    for (const Condition& condition : conditions_of(entry, axis)) {
      if (condition.kind == Condition::Kind::held)
        refuse(entry.place,
               "cannot keep an edge at an initial displacement that differs from node to node; "
               "give displacement = { x = … }, or use another formulation");
      if (condition.kind == Condition::Kind::loaded && condition.component != axis)
        refuse(entry.place, "takes loads normal to the edge only; shear loads");
    }
  }
}

/// Gradients of degree two are least-squares fits over a support.
void check_kernel(const Scene& scene, const TableView& root) {
  const TableView kernel = root.table("kernel");
  const auto refuse_sums = [&](const char* key, std::string_view allowed, std::string_view others) {
    if (is_adjoint(scene.formulation)) return;
    fail_at(kernel.place_of(key), "{} uses plain SPH sums; allowed: {} ({}: {})",
            name_of(scene.formulation), allowed, others, adjoint_formulations());
  };
  if (scene.kernel.correction != Correction::none)
    refuse_sums("correction", "none", "corrected gradients");
  if (scene.kernel.order == 1) return;
  refuse_sums("order", "1", "order 2");
  const Place place = kernel.place_of("order");
  if (scene.kernel.correction != Correction::least_squares)
    fail_at(place,
            "the correction \"{}\" is exact for linear fields only; "
            "allowed: 1 (order 2: least-squares)",
            name_of(scene.kernel.correction));
  if (!scene.kernel.support)
    throw InputError(place, "the nodes of a cell determine no quadratic fit; give kernel.support");
}

void check_consistency(const Scene& scene) {
  if (!scene.consistency) return;
  const FormulationTraits& traits = traits_of(scene.formulation);
  const auto refuse = [&](const std::string& what) {
    fail_at(scene.consistency->place, "{} {} formulation = \"{}\"", traits.name, what,
            formulations_where(
                [](const FormulationTraits& row) { return row.corrected == Corrected::always; }));
  };
  if (traits.closure != Closure::natural)
    refuse("has no adjoint to make exact; leave it out, or use");
  if (traits.corrected == Corrected::never)
    refuse("gradients stay as they are; a corrected one is");
  const auto [rows, columns] = traits.highest;
  if (scene.consistency->rows > rows || scene.consistency->columns > columns)
    refuse(fmt::format("is corrected to degrees [{}, {}]; higher ones:", rows, columns));
}

void check_placement(const Scene& scene, const TableView& root) {
  const TableView body = root.table("body");
  const FormulationTraits& traits = traits_of(scene.formulation);
  if (scene.body.placement == NodePlacement::cell_centred && traits.nodes != NodeSites::anywhere)
    fail_at(body.place_of("placement"),
            "{} needs nodes on the boundary; allowed: on-boundary "
            "(cell-centred nodes: {})",
            traits.name, formulations_where([](const FormulationTraits& row) {
              return row.nodes == NodeSites::anywhere;
            }));
  if (scene.body.jitter > 0.0 && traits.nodes == NodeSites::lattice)
    fail_at(body.place_of("jitter"),
            "{} needs nodes on a lattice; allowed: 0 (irregular nodes: {})", traits.name,
            adjoint_formulations());
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
    if (is_collocated(scene.formulation) || scene.dimension != 2)
      fail_at(place,
              "cell holds the hourglass mode of one stress point per "
              "cell: it needs formulation = \"{}\" in 2D; allowed "
              "here: none, pair",
              formulations_where(
                  [](const FormulationTraits& row) { return row.sites == StressSites::cells; }));
    if (scene.kernel.support)
      throw InputError(place,
                       "cell goes with the gradient over the nodes of each cell; leave "
                       "kernel.support out, or use pair");
    if (scene.body.is_cloud())
      throw InputError(place,
                       "cell holds the hourglass mode of quadrilaterals, which the triangles of "
                       "a cloud do not have; allowed: none, pair");
  } else if (!is_adjoint(scene.formulation)) {
    fail_at(place, "{} takes no stabiliser; allowed: none", name_of(scene.formulation));
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
      fail_at(probe.place,
              "probe {} at [{}] is outside the body, which fills "
              "{}{}",
              probe.name, fmt::join(probe.at, ", "), is_box(scene) ? "" : "part of ", whole);
  const auto check_box = [&](const auto& part, const std::string& what) {
    for (int a = 0; a < D && !part.lower.empty(); ++a)
      if (part.lower[static_cast<std::size_t>(a)] > bounds.upper(a) ||
          part.upper[static_cast<std::size_t>(a)] < bounds.lower(a))
        fail_at(part.place, "{}: its box lies outside the body, which fills {}", what, whole);
  };
  for (const auto& material : scene.materials) check_box(material, "empty region");
  for (const auto& region : scene.initial_regions) check_box(region, "empty region");
  for (const auto& tag : scene.body.tags) check_box(tag, fmt::format("tag {} is empty", tag.name));
}

/// The condition that rules a component of a patch so far, and whose it is.
struct Claim {
  const BoundaryScene* by = nullptr;
  Condition condition;
};
/// Of the components of a patch; the last is the one across it where its axis is not known.
using Claims = std::array<Claim, 3>;

std::string words(const Condition& condition) {
  using Kind = Condition::Kind;
  if (condition.across && condition.kind == Kind::fixed)
    return "by symmetry holds the normal displacement";
  const std::string_view name =
      condition.component == unknown_axis
          ? "the normal component"
          : std::string_view("xy").substr(static_cast<std::size_t>(condition.component), 1);
  switch (condition.kind) {
    case Kind::fixed:
      return fmt::format("holds {} at zero", name);
    case Kind::held:
      return fmt::format("keeps {} where it starts", name);
    case Kind::moved:
      return fmt::format("moves {}", name);
    case Kind::loaded:
      break;
  }
  return fmt::format("loads {}", name);
}

void claim(Claims& claims, const BoundaryScene& entry, const Condition& condition) {
  const bool known = condition.component != unknown_axis;
  Claim& now = claims[known ? static_cast<std::size_t>(condition.component) : 2];
  const auto fixes = [](const Condition& c) { return c.kind == Condition::Kind::fixed; };
  if (now.by && !(fixes(now.condition) && fixes(condition)))
    fail_at(entry.place,
            "contradiction on \"{}\": {} {}, and {} {}; one condition for each component",
            entry.where, now.by == &entry ? "this entry" : now.by->place.key, words(now.condition),
            now.by == &entry ? "also" : "this entry", words(condition));
  now = {&entry, condition};
}

}  // namespace

void check_formulation(const Scene& scene, const TableView& root) {
  check_ghosts(scene, root);
  check_sides(scene);
  check_kernel(scene, root);
  check_consistency(scene);
  check_placement(scene, root);
  check_stabiliser(scene, root);
}

void check_positions(const Scene& scene) {
  in_dimension(scene.dimension, [&]<int D>() { check_positions_in<D>(scene); });
}

void check_boundaries(const Scene& scene) {
  std::map<std::string, Claims> patches;
  for (const BoundaryScene& entry : scene.boundaries)
    for (const Condition& condition : conditions_of(entry, patch_axis(scene, entry.where)))
      claim(patches[entry.where], entry, condition);
  // Where the normal is not known yet, a normal load still needs a component that is free to move.
  for (const auto& [where, claims] : patches) {
    const auto loaded = [](const Claim& c) { return c.condition.kind == Condition::Kind::loaded; };
    const auto constrained = [&](const Claim& c) { return c.by && !loaded(c); };
    const Claim& across = claims[2];
    if (across.by && loaded(across) && constrained(claims[0]) &&
        (scene.dimension == 1 || constrained(claims[1])))
      fail_at(across.by->place,
              "contradiction on \"{}\": a traction where every component of the "
              "displacement is given",
              where);
  }
}

}  // namespace tlsph
