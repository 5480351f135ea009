// Curves in a scene: their keys, read and printed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>
#include <variant>

#include "keys.hpp"

namespace tlsph {
namespace {

using Slot = std::variant<double*, std::vector<double>*>;

/// A key of a curve's table, and the member that holds it.
struct CurveKey {
  std::string_view name;
  std::function<Slot(Curve&)> slot;
};
template <class C, class V>
CurveKey key_of(std::string_view name, V C::*member) {
  return {name, [member](Curve& curve) -> Slot { return &(std::get<C>(curve).*member); }};
}

/// A curve that a scene can name, with the keys it needs beside `amplitude`.
struct CurveKind {
  std::string_view name;
  Curve start;  ///< without its keys
  std::vector<CurveKey> needs;

  [[nodiscard]] bool is_table() const { return std::holds_alternative<TableCurve>(start); }
};

const std::vector<CurveKind>& curve_kinds() {
  static const std::vector<CurveKind> kinds = {
      {"constant", ConstantCurve{}, {}},
      {"ramp", RampCurve{}, {key_of("rise", &RampCurve::rise)}},
      {"smooth-ramp", RampCurve{0.0, 0.0, true}, {key_of("rise", &RampCurve::rise)}},
      {"pulse",
       PulseCurve{},
       {key_of("duration", &PulseCurve::duration), key_of("rise", &PulseCurve::rise)}},
      {"sine-squared", SineSquaredCurve{}, {key_of("duration", &SineSquaredCurve::duration)}},
      {"table",
       TableCurve{},
       {key_of("time", &TableCurve::time), key_of("value", &TableCurve::values)}},
  };
  return kinds;
}

const CurveKind& kind_of(const Curve& curve) {
  const auto* ramp = std::get_if<RampCurve>(&curve);
  return *std::ranges::find_if(curve_kinds(), [&](const CurveKind& kind) {
    return kind.start.index() == curve.index() &&
           (ramp == nullptr || std::get<RampCurve>(kind.start).smooth == ramp->smooth);
  });
}

/// A curve of any amplitude.
struct CurveShape {
  Curve curve;
  bool cubic = false;  ///< a table

  [[nodiscard]] Curve times(double amplitude) const {
    Curve scaled = curve;
    auto* table = std::get_if<TableCurve>(&scaled);
    if (table == nullptr) {
      std::visit(
          [&](auto& c) {
            if constexpr (requires { c.amplitude; }) c.amplitude = amplitude;
          },
          scaled);
      return scaled;
    }
    for (double& x : table->values) x *= amplitude;
    return cubic ? cubic_spline(std::move(*table)) : scaled;
  }
};

/// A table has 1.
double amplitude_of(const Curve& curve) {
  return std::visit(
      [](const auto& c) {
        if constexpr (requires { c.amplitude; }) return c.amplitude;
        return 1.0;
      },
      curve);
}

void check_history(const TableView& view, const TableCurve& table) {
  if (table.time.empty()) throw InputError(view.place_of("time"), "must have at least one instant");
  if (table.time.size() != table.values.size())
    fail_at(view.place_of("value"), "must have as many entries as time, {}, not {}",
            table.time.size(), table.values.size());
  for (std::size_t i = 1; i < table.time.size(); ++i)
    if (!(table.time[i - 1] < table.time[i]))
      fail_at(view.place_of("time"), "must increase, but {} follows {}", table.time[i],
              table.time[i - 1]);
}

/// What a curve drives; a motion must be smooth: where its rate jumps, so does the velocity.
enum class Drives { motion, load };

CurveShape read_curve_shape(const TableView& view, Drives drives) {
  const std::string name = *view.require("curve").text();
  const CurveKind& kind = *std::ranges::find(curve_kinds(), name, &CurveKind::name);
  std::vector<std::string_view> takes = {"amplitude"};
  for (const CurveKey& need : kind.needs) takes.push_back(need.name);
  if (kind.is_table()) takes.emplace_back("interpolation");
  for (const Entry& entry : *view.node()->table())
    if (entry.name != "curve" && std::ranges::find(takes, entry.name) == takes.end())
      fail_at(entry.place, "does not belong to a {} curve, which takes {}{}", name,
              fmt::join(takes, ", "), takes.size() == 1 ? " only" : "");
  CurveShape shape{kind.start};
  for (const CurveKey& need : kind.needs) {
    const Node& node = view.require(need.name);
    const Slot slot = need.slot(shape.curve);
    if (node.is_number())
      *std::get<double*>(slot) = node.number();
    else
      *std::get<1>(slot) = read_vector(node, static_cast<int>(node.list()->size()), "");
  }
  if (kind.is_table()) check_history(view, std::get<TableCurve>(shape.curve));
  const Node* interpolation = view.find("interpolation");
  shape.cubic =
      interpolation != nullptr ? *interpolation->text() == "cubic" : drives == Drives::motion;
  return shape;
}

/// The amplitude; a table curve already has values and takes 1.
Node read_amplitude(const TableView& view) {
  if (!view.has("amplitude") && view.has("value"))
    return Node{1.0, view.place_of("amplitude"), view.path()};
  return view.require("amplitude");
}

Node print_table_of(Curve curve, Node amplitude) {
  const CurveKind& kind = kind_of(curve);
  std::vector<Entry> entries = {entry_of("curve", node_of(std::string(kind.name))),
                                entry_of("amplitude", std::move(amplitude))};
  for (const CurveKey& need : kind.needs) {
    const Slot slot = need.slot(curve);
    const auto* const* number = std::get_if<double*>(&slot);
    entries.push_back(
        entry_of(need.name, number ? node_of(**number) : print_list(*std::get<1>(slot))));
  }
  if (const auto* table = std::get_if<TableCurve>(&curve))
    entries.push_back(entry_of(
        "interpolation", node_of(std::string(table->curvature.empty() ? "linear" : "cubic"))));
  return node_of(std::move(entries));
}

/// The factor from the first curve to the second, which differs in its amplitude only.
double ratio(const Curve& first, const Curve& second) {
  const auto* table = std::get_if<TableCurve>(&first);
  if (table == nullptr) return amplitude_of(second);
  const auto largest =
      std::ranges::max_element(table->values, {}, [](double x) { return std::abs(x); });
  return std::get<TableCurve>(second)
             .values[static_cast<std::size_t>(largest - table->values.begin())] /
         *largest;
}

}  // namespace

Curve read_motion_curve(const Node& node) {
  if (node.is_number()) return ConstantCurve{node.number()};
  const TableView view(node, "curve");
  const CurveShape shape = read_curve_shape(view, Drives::motion);
  const Node amplitude = read_amplitude(view);
  if (!amplitude.is_number())
    throw InputError(amplitude.place, "must be a number: the motion of one component");
  return shape.times(amplitude.number());
}

void read_load(const Node& node, int dimension, std::optional<Curve>& normal,
               std::vector<ComponentCurve>& components) {
  CurveShape shape{ConstantCurve{}};
  Node amplitude = node;
  if (node.table()) {
    const TableView view(node, "curve");
    shape = read_curve_shape(view, Drives::load);
    amplitude = read_amplitude(view);
  }
  if (amplitude.is_number()) {
    normal = shape.times(amplitude.number());
    return;
  }
  const auto vector = read_vector(amplitude, dimension, "one per dimension");
  for (int i = 0; i < dimension; ++i)
    if (const double t = vector[static_cast<std::size_t>(i)]; t != 0.0)
      components.push_back({i, shape.times(t)});
}

Node print_curve(const Curve& curve) {
  Node amplitude = node_of(amplitude_of(curve));
  return std::holds_alternative<ConstantCurve>(curve) ? amplitude
                                                      : print_table_of(curve, amplitude);
}

Node print_vector_load(const std::vector<ComponentCurve>& load, int dimension) {
  const Curve& first = load.front().curve;
  std::vector<double> amplitude(static_cast<std::size_t>(dimension), 0.0);
  for (const auto& [component, curve] : load)
    amplitude[static_cast<std::size_t>(component)] = ratio(first, curve);
  Node list = print_list(amplitude);
  return std::holds_alternative<ConstantCurve>(first) ? list : print_table_of(first, list);
}

std::vector<Key> curve_keys() {
  const Allowed any;
  std::vector<std::string> kinds;
  for (const auto& kind : curve_kinds()) kinds.emplace_back(kind.name);
  return {
      {"motion", "x", number | Form::table, "m", any, "displacement in x", "curve"},
      {"motion", "y", number | Form::table, "m", any, "displacement in y", "curve"},

      {"curve", "curve", text, "", Allowed(kinds),
       "value over time, zero before t = 0; pulse: A/2 [erf((t-3r)/r) - erf((t-3r-T)/r)], r the "
       "rise, T the duration",
       "", ""},
      {"curve", "amplitude", number | numbers, "", any,
       "largest value, in the unit of what the curve drives; of a table: a factor", "",
       "(of a table: 1)"},
      {"curve", "rise", number, "s", above(0.0), "ramp, smooth-ramp, pulse: time of rise"},
      {"curve", "duration", number, "s", above(0.0), "pulse, sine-squared: length"},
      {"curve", "time", numbers, "s", any, "table: instants, increasing"},
      {"curve", "value", numbers, "", any, "table: the values then"},
      {"curve", "interpolation", text, "", Allowed({"linear", "cubic"}),
       "table: lines between the values, or a natural cubic spline: velocity and acceleration of "
       "the motion are continuous, but it overshoots where values stop changing",
       "", "(of a motion: cubic, of a load: linear)"},
  };
}

}  // namespace tlsph
