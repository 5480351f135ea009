#include "read_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "curve_kinds.hpp"

namespace tlsph {
namespace {

/// A curve without its amplitude.
struct CurveShape {
  const CurveKind* kind = nullptr;
  CurveValues values;

  [[nodiscard]] Curve times(double amplitude) const {
    CurveValues scaled = values;
    scaled.amplitude = amplitude;
    return kind->make(scaled);
  }
};

std::vector<double> numbers_of(const Node& node) {
  return read_vector(node, static_cast<int>(node.list()->size()), "");
}

void check_history(const TableView& view, const CurveValues& values) {
  if (values.time.empty())
    throw InputError(view.place_of("time"), "must have at least one instant");
  if (values.time.size() != values.value.size())
    throw InputError(view.place_of("value"),
                     fmt::format("must have as many entries as time, {}, not {}",
                                 values.time.size(), values.value.size()));
  for (std::size_t i = 1; i < values.time.size(); ++i)
    if (!(values.time[i - 1] < values.time[i]))
      throw InputError(view.place_of("time"), fmt::format("must increase, but {} follows {}",
                                                          values.time[i], values.time[i - 1]));
}

/// What a curve drives; a motion must be smooth: where its rate jumps, so does the velocity.
enum class Drives { motion, load };

CurveShape read_curve_shape(const TableView& view, Drives drives) {
  const std::string name = view.text("curve");
  CurveShape shape;
  for (const CurveKind& kind : curve_kinds())
    if (kind.name == name) shape.kind = &kind;
  const auto& needs = shape.kind->needs;
  const bool table = std::ranges::find(needs, "value") != needs.end();
  for (const Entry& entry : *view.node()->table())
    if (entry.name != "curve" && entry.name != "amplitude" &&
        !(table && entry.name == "interpolation") &&
        std::find(needs.begin(), needs.end(), entry.name) == needs.end())
      throw InputError(
          entry.place,
          fmt::format("does not belong to a {} curve, which takes {}", name,
                      needs.empty() ? "amplitude only"
                                    : fmt::format("amplitude, {}{}", fmt::join(needs, ", "),
                                                  table ? ", interpolation" : "")));
  for (const auto need : needs) view.require(need);
  shape.values.rise = view.has("rise") ? view.number("rise") : 0.0;
  shape.values.duration = view.has("duration") ? view.number("duration") : 0.0;
  if (const Node* time = view.find("time")) shape.values.time = numbers_of(*time);
  if (const Node* value = view.find("value")) shape.values.value = numbers_of(*value);
  if (view.has("time")) check_history(view, shape.values);
  shape.values.cubic =
      view.has("interpolation") ? view.text("interpolation") == "cubic" : drives == Drives::motion;
  return shape;
}

/// The amplitude; a table curve already has values and takes 1.
Node amplitude_of(const TableView& view) {
  if (!view.has("amplitude") && view.has("value"))
    return Node{1.0, view.place_of("amplitude"), view.path()};
  return view.require("amplitude");
}

/// The motion of a component: a number, or a curve with a number as amplitude.
Curve read_scalar_curve(const Node& node, const std::string& group) {
  if (node.is_number()) return ConstantCurve{node.number()};
  const TableView view(node, group);
  const CurveShape shape = read_curve_shape(view, Drives::motion);
  const Node amplitude = amplitude_of(view);
  if (!amplitude.is_number())
    throw InputError(amplitude.place, "must be a number: the motion of one component");
  return shape.times(amplitude.number());
}

void read_traction(const TableView& view, int dimension, BoundaryScene& boundary) {
  const Node& node = view.require("traction");
  if (node.is_number()) {
    boundary.normal_traction = ConstantCurve{node.number()};
    return;
  }
  CurveShape shape{&curve_kinds().front(), {}};
  Node amplitude = node;
  if (node.table()) {
    const TableView curve = view.table("traction");
    shape = read_curve_shape(curve, Drives::load);
    amplitude = amplitude_of(curve);
  }
  if (amplitude.is_number()) {
    boundary.normal_traction = shape.times(amplitude.number());
    return;
  }
  const auto vector = read_vector(amplitude, dimension, "one per dimension");
  for (int i = 0; i < dimension; ++i)
    if (const double t = vector[static_cast<std::size_t>(i)]; t != 0.0)
      boundary.traction.push_back({i, shape.times(t)});
}

int component(const std::string& axis, int dimension, const Place& place) {
  if (axis == "y" && dimension == 1)
    throw InputError(place, "there is no y where dimension = 1; allowed: x");
  return axis == "x" ? 0 : 1;
}

/// true, a component or a list of them; none if the key is not there.
std::vector<int> read_components(const TableView& view, std::string_view key, int dimension) {
  std::vector<int> components;
  if (!view.has(key)) return components;
  const Node& node = view.require(key);
  if (const bool* all = node.flag()) {
    for (int i = 0; *all && i < dimension; ++i) components.push_back(i);
  } else if (const auto* axis = node.text()) {
    components.push_back(component(*axis, dimension, node.place));
  } else {
    for (const Node& item : *node.list())
      components.push_back(component(*item.text(), dimension, item.place));
    std::sort(components.begin(), components.end());
    if (std::adjacent_find(components.begin(), components.end()) != components.end())
      throw InputError(node.place, "names a component twice");
  }
  return components;
}

}  // namespace

BoundaryScene read_boundary(const TableView& view, int dimension) {
  BoundaryScene boundary;
  boundary.place = view.place();
  boundary.where = view.text("where");
  boundary.symmetry = view.flag("symmetry");
  boundary.fixed = read_components(view, "fixed", dimension);
  boundary.held = read_components(view, "held", dimension);
  if (view.has("displacement")) {
    const TableView motion = view.table("displacement");
    for (const Entry& entry : *motion.node()->table())
      boundary.motion.push_back(
          {component(entry.name, dimension, entry.place), read_scalar_curve(entry.value, "curve")});
    if (boundary.motion.empty())
      throw InputError(motion.place(), "must say which component moves: { x = … }");
  }
  if (view.has("traction")) read_traction(view, dimension, boundary);
  if (!view.has("fixed") && !view.has("held") && !view.has("symmetry") &&
      !view.has("displacement") && !view.has("traction"))
    throw InputError(
        view.place(),
        "says nothing about its patch; give fixed, held, symmetry, displacement or traction");
  return boundary;
}

}  // namespace tlsph
