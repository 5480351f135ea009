#include "tlsph/simulation/reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tlsph/curves/curve.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/scene/conditions.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

/// A body of 2D on a lattice that is what its shape says: no points of a file, no rows shifted, no
/// random shifts, no patches by name, no parts that start differently.
bool is_plain(const Scene& scene) {
  return scene.dimension == 2 && !scene.body.is_cloud() && scene.body.jitter == 0.0 &&
         scene.body.tags.empty() && scene.initial_regions.empty();
}

// A strip between rollers is a bar.

bool slides(const Scene& scene, const std::string& side) {
  const PatchConditions conditions(scene, side);
  return conditions.has(Kind::fixed, 1) && !conditions.has(Kind::fixed, 0) &&
         !conditions.has(Kind::held) && !conditions.has(Kind::moved) &&
         !conditions.has(Kind::loaded);
}

/// Left and right do to the body what they may do in 1D.
bool acts_along_x(const BoundaryScene& entry) {
  return std::ranges::all_of(conditions_of(entry, 0), [](const Condition& c) {
    return c.kind == Kind::fixed || (c.kind == Kind::moved && c.component == 0) ||
           (c.kind == Kind::loaded && c.across);
  });
}

bool depends_on_x_only(const InitialField& field) {
  if (field.kind == InitialField::Kind::zero) return true;
  if (field.kind != InitialField::Kind::linear || field.constant[1] != 0.0) return false;
  const auto& g = field.gradient;
  return g.empty() || (g[0][1] == 0.0 && g[1][0] == 0.0 && g[1][1] == 0.0);
}

/// Its part along x.
InitialField along_x(const InitialField& field) {
  InitialField bar = field;
  if (field.kind == InitialField::Kind::zero) return bar;
  bar.constant = {field.constant[0]};
  bar.gradient = {{field.gradient.empty() ? 0.0 : field.gradient[0][0]}};
  return bar;
}

/// What left or right does in 1D; nothing where it held y alone.
std::optional<BoundaryScene> end_of_bar(const BoundaryScene& entry) {
  BoundaryScene end = entry;
  const bool holds = std::ranges::find(entry.fixed, 0) != entry.fixed.end();
  if (!holds && !entry.symmetry && entry.motion.empty() && !entry.normal_traction)
    return std::nullopt;
  end.fixed = holds ? std::vector{0} : std::vector<int>{};
  return end;
}

}  // namespace

std::optional<Reduction> to_one_dimension(const Scene& scene) {
  const auto* shape = std::get_if<Shape<2>>(&scene.body.shape);
  const auto* box = shape == nullptr ? nullptr : std::get_if<Box<2>>(&shape->form);
  if (box == nullptr || !is_plain(scene) ||
      scene.materials.front().assumption != Assumption::strain)
    return std::nullopt;
  if (!slides(scene, "top") || !slides(scene, "bottom")) return std::nullopt;
  if (!scene.body_force.empty() && scene.body_force[1] != 0.0) return std::nullopt;
  if (!depends_on_x_only(scene.displacement) || !depends_on_x_only(scene.velocity))
    return std::nullopt;

  Reduction reduction{"1D: nothing depends on y", scene};
  Scene& bar = reduction.scene;
  bar.dimension = 1;
  bar.body.shape = make_interval(box->lower.x(), box->upper.x());
  const BodyScene standard;
  bar.body.fit = standard.fit;
  bar.boundaries.clear();
  for (const BoundaryScene& entry : scene.boundaries) {
    if (entry.where == "top" || entry.where == "bottom") continue;
    if ((entry.where != "left" && entry.where != "right") || !acts_along_x(entry))
      return std::nullopt;
    if (auto end = end_of_bar(entry)) bar.boundaries.push_back(std::move(*end));
  }
  for (std::size_t k = 1; k < bar.materials.size(); ++k) {
    MaterialScene& region = bar.materials[k];
    if (region.lower[1] > box->lower.y() || region.upper[1] < box->upper.y()) return std::nullopt;
    region.lower.resize(1);
    region.upper.resize(1);
  }
  for (ProbeScene& probe : bar.probes) probe.at.resize(1);
  if (!bar.body_force.empty()) bar.body_force.resize(1);
  bar.displacement = along_x(scene.displacement);
  bar.velocity = along_x(scene.velocity);
  return reduction;
}

// A body that is its own mirror image is twice its half.
namespace {

constexpr std::array<std::array<const char*, 2>, 2> sides = {
    {{"left", "right"}, {"bottom", "top"}}};
/// Lengths that differ by less, of the size of the body, are the same; so are loads and motions, of
/// their largest value.
constexpr double same = 1e-9;

/// The plane X_axis = position, and how far lengths may be off.
struct Mirror {
  int axis = 0;
  double position = 0.0, tolerance = 0.0;
  [[nodiscard]] bool twins(double a, double b) const {
    return std::abs(a + b - 2.0 * position) <= tolerance;
  }
  [[nodiscard]] bool equal(double a, double b) const { return std::abs(a - b) <= tolerance; }
};

/// What one side does, summed over its entries: components held, and histories by component, at
/// instants all over the run.
struct Action {
  std::array<bool, 2> held{};
  std::array<std::vector<double>, 2> motion, load;
};

/// `outward`: the sign of the outer normal.
Action action_of(const Scene& scene, const std::string& side, double outward) {
  constexpr std::size_t instants = 97;
  Action action;
  for (auto* histories : {&action.motion[0], &action.motion[1], &action.load[0], &action.load[1]})
    histories->assign(instants, 0.0);
  const auto add = [&](std::vector<double>& history, const Curve& curve, double factor = 1.0) {
    for (std::size_t k = 0; k < instants; ++k)
      history[k] += factor * value(curve, scene.time.end * static_cast<double>(k) / (instants - 1));
  };
  const PatchConditions conditions(scene, side);
  for (const Condition& condition : conditions.all()) {
    const auto c = static_cast<std::size_t>(condition.component);
    if (condition.kind == Kind::fixed) action.held[c] = true;
    if (condition.kind == Kind::moved) add(action.motion[c], *condition.curve);
    if (condition.kind == Kind::loaded)
      add(action.load[c], *condition.curve, condition.across ? outward : 1.0);
  }
  return action;
}

bool equal(const std::vector<double>& a, const std::vector<double>& b, double sign) {
  double largest = 0.0;
  double difference = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max({largest, std::abs(a[k]), std::abs(b[k])});
    difference = std::max(difference, std::abs(a[k] - sign * b[k]));
  }
  return difference <= same * largest;
}

bool mirrored_conditions(const Scene& scene, const Mirror& mirror) {
  const auto normal = static_cast<std::size_t>(mirror.axis);
  const std::size_t along = 1 - normal;
  const Action low = action_of(scene, sides[normal][0], -1.0);
  const Action high = action_of(scene, sides[normal][1], 1.0);
  if (low.held != high.held) return false;
  for (const auto& [a, b] : {std::pair(low.motion, high.motion), std::pair(low.load, high.load)})
    if (!equal(a[normal], b[normal], -1.0) || !equal(a[along], b[along], 1.0)) return false;
  return std::ranges::all_of(scene.boundaries, [&](const BoundaryScene& entry) {
    const auto conditions = conditions_of(entry, patch_axis(scene, entry.where));
    const auto acts_across = [&](const Condition& c) {
      return c.component == mirror.axis && !c.across && c.kind != Kind::fixed;
    };
    const auto is = [&](const char* patch) { return entry.where == patch; };
    if (std::ranges::find(conditions, Kind::held, &Condition::kind) != conditions.end())
      return false;
    if (std::ranges::any_of(sides[normal], is)) return true;
    return (std::ranges::any_of(sides[along], is) || entry.where == "hole") &&
           std::ranges::none_of(conditions, acts_across);
  });
}

bool mirrored(const InitialField& field, const Mirror& mirror) {
  if (field.kind == InitialField::Kind::zero) return true;
  if (field.kind != InitialField::Kind::linear) return false;
  const auto n = static_cast<std::size_t>(mirror.axis);
  const std::size_t t = 1 - n;
  const auto& g = field.gradient;
  if (g.empty()) return field.constant[n] == 0.0;
  return g[n][t] == 0.0 && g[t][n] == 0.0 &&
         std::abs(field.constant[n] + g[n][n] * mirror.position) <=
             std::abs(g[n][n]) * mirror.tolerance;
}

/// A hole that is its own image; or, among `all`, has one.
bool has_twin(const Shape<2>& hole, const std::vector<Shape<2>>& all, const Mirror& mirror) {
  const int n = mirror.axis;
  const int t = 1 - n;
  return std::ranges::any_of(all, [&](const Shape<2>& other) {
    if (const auto* a = std::get_if<Disc>(&hole.form)) {
      const auto* b = std::get_if<Disc>(&other.form);
      return b != nullptr && mirror.equal(a->radius, b->radius) &&
             mirror.twins(a->centre(n), b->centre(n)) && mirror.equal(a->centre(t), b->centre(t));
    }
    const auto* a = std::get_if<Box<2>>(&hole.form);
    const auto* b = std::get_if<Box<2>>(&other.form);
    return a != nullptr && b != nullptr && mirror.twins(a->lower(n), b->upper(n)) &&
           mirror.twins(a->upper(n), b->lower(n)) && mirror.equal(a->lower(t), b->lower(t)) &&
           mirror.equal(a->upper(t), b->upper(t));
  });
}

/// The half box without the holes that reach into it.
Shape<2> half_shape(const Box<2>& half, const std::vector<Shape<2>>& holes, int axis) {
  std::vector<Shape<2>> inside;
  for (const Shape<2>& hole : holes) {
    const Box<2> around = bounding_box(hole);
    if (around.lower(axis) < half.upper(axis) && around.upper(axis) > half.lower(axis))
      inside.push_back(hole);
  }
  const Shape<2> base = make_box<2>(half.lower, half.upper);
  return inside.empty() ? base : make_difference(base, std::move(inside));
}

}  // namespace

std::optional<Reduction> to_half(const Scene& scene, int axis) {
  if (!is_plain(scene) || (scene.exact != ExactKind::none && axis == 0)) return std::nullopt;
  const auto& shape = std::get<Shape<2>>(scene.body.shape);
  const auto* box = std::get_if<Box<2>>(&base_of(shape).form);
  if (box == nullptr) return std::nullopt;
  const Mirror mirror{axis, 0.5 * (box->lower(axis) + box->upper(axis)),
                      same * (box->upper - box->lower).maxCoeff()};
  const std::vector<Shape<2>> holes = holes_of(shape);
  if (!std::ranges::all_of(holes, [&](const auto& h) { return has_twin(h, holes, mirror); }) ||
      !mirrored_conditions(scene, mirror) || !mirrored(scene.displacement, mirror) ||
      !mirrored(scene.velocity, mirror))
    return std::nullopt;
  const auto n = static_cast<std::size_t>(axis);
  if (!scene.body_force.empty() && scene.body_force[n] != 0.0) return std::nullopt;
  for (std::size_t k = 1; k < scene.materials.size(); ++k)
    if (!mirror.twins(scene.materials[k].lower[n], scene.materials[k].upper[n]))
      return std::nullopt;
  const auto on_side = [&](double sign) {
    return std::ranges::all_of(scene.probes, [&](const ProbeScene& probe) {
      return sign * (probe.at[n] - mirror.position) <= mirror.tolerance;
    });
  };
  const bool lower = on_side(1.0);
  if (!lower && !on_side(-1.0)) return std::nullopt;

  Box<2> half = *box;
  (lower ? half.upper : half.lower)(axis) = mirror.position;
  const char* cut = sides[n][lower ? 1 : 0];
  Reduction reduction{
      fmt::format("half of it: {} = {:.6g} m is a plane of symmetry", "xy"[axis], mirror.position),
      scene};
  reduction.scene.body.shape = half_shape(half, holes, axis);
  auto& boundaries = reduction.scene.boundaries;
  std::erase_if(boundaries, [&](const BoundaryScene& entry) { return entry.where == cut; });
  BoundaryScene& roller = boundaries.emplace_back();
  roller.where = cut;
  roller.symmetry = true;
  return reduction;
}

}  // namespace tlsph
