#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "evidence.hpp"
#include "verdict_names.hpp"

namespace tlsph {
namespace {

std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  return size >= 1e-2 && size < 1e4 ? fmt::format("{:.3f}", value) : fmt::format("{:.1e}", value);
}

std::string spread(double low, double high) {
  return low == high ? short_number(low)
                     : fmt::format("{} - {}", short_number(low), short_number(high));
}

/// The range of a quantity over the rows of a method.
template <class Quantity>
std::string range_of(const std::vector<const AtlasRow*>& rows, const Quantity& quantity) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const AtlasRow* row : rows) {
    const double value = quantity(*row);
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return low > high ? "-" : spread(low, high);
}

/// A letter a state: the stretches of one layout and Poisson ratio side by side.
std::string letters(const std::vector<const AtlasRow*>& rows) {
  std::string text;
  const AtlasRow* last = nullptr;
  for (const AtlasRow* row : rows) {
    if (last != nullptr && row->jitter != last->jitter)
      text += " | ";
    else if (last != nullptr && row->poisson != last->poisson)
      text += ' ';
    text += verdict_letter(row->verdict);
    last = row;
  }
  return text;
}

template <class Value>
std::vector<double> values_of(const std::vector<AtlasRow>& rows, const Value& value) {
  std::vector<double> values;
  for (const AtlasRow& row : rows)
    if (row.body == "scene") values.push_back(value(row));
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::string table_of_states(const Atlas& atlas) {
  std::vector<std::pair<std::string, std::vector<const AtlasRow*>>> methods;
  for (const AtlasRow& row : atlas.rows) {
    const std::string name = row.body == "scene" ? row.method : row.method + ", " + row.body;
    if (methods.empty() || methods.back().first != name) methods.push_back({name, {}});
    methods.back().second.push_back(&row);
  }
  if (methods.empty()) return "";
  std::string text = fmt::format(
      "States: a letter each, stretches {:g} side by side, then Poisson ratios {:g}, then layouts "
      "(jitter {:g});\nnot every method has all of them.  . stable  m material not hyperbolic  "
      "N ω² < 0  G growing  s modes without energy  R refused\n\n"
      "{:<40} {:>15} {:>15}  states\n",
      fmt::join(values_of(atlas.rows, [](const AtlasRow& row) { return row.stretch; }), " "),
      fmt::join(values_of(atlas.rows, [](const AtlasRow& row) { return row.poisson; }), " "),
      fmt::join(values_of(atlas.rows, [](const AtlasRow& row) { return row.jitter; }), " "),
      "method", "c_p dt_crit/Δ", "of true limit");
  for (const auto& [name, rows] : methods)
    text += fmt::format(
        "{:<40} {:>15} {:>15}  {}\n", name,
        range_of(rows,
                 [](const AtlasRow& row) { return row.stretch == 1.0 ? row.bound : not_known; }),
        range_of(rows,
                 [](const AtlasRow& row) {
                   return row.verdict == Verdict::material ? not_known : row.bound / row.limit;
                 }),
        letters(rows));
  return text;
}

std::string table_of_waves(const Atlas& atlas) {
  if (atlas.waves.empty()) return "";
  std::string text = fmt::format(
      "\nWaves on the lattice, 8 spacings long: |c/c0 - 1| and its spread over directions; slowest "
      "c/c0 and waves without energy of the zone\n\n{:<40} {:>10} {:>12} {:>10} {:>9} {:>11}\n",
      "method", "transverse", "longitudinal", "anisotropy", "slowest", "zero energy");
  for (const WaveRow& row : atlas.waves)
    text += fmt::format("{:<40} {:>10} {:>12} {:>10} {:>9} {:>11}\n", row.method,
                        short_number(row.transverse), short_number(row.longitudinal),
                        short_number(row.anisotropy), short_number(row.slowest), row.zero_energy);
  return text;
}

std::string table_of_contrast(const Atlas& atlas) {
  if (atlas.contrast.empty()) return "";
  std::string text = fmt::format(
      "\nUpdated Lagrangian, {}D, cubic spline, support 2.4\n\n{:>12} {:>16} {:>10} {:>22}\n",
      atlas.dimension, "stress [ρc²]", "expected [c/Δ]", "seen", "largest energy/first");
  for (const ContrastRow& row : atlas.contrast)
    text += fmt::format("{:>12} {:>16} {:>10} {:>22}\n", fmt::format("{:g}", row.stress),
                        short_number(row.expected), short_number(row.seen),
                        short_number(row.amplitude));
  return text;
}

std::string table_of_crush(const Atlas& atlas) {
  if (atlas.crush.empty()) return "";
  std::string text = fmt::format(
      "\nCompression to a stretch of 0.2 at 0.95 of the critical step\n\n{:<26} {:>9} {:<8} {:>6} "
      "{:<15} {:>7} {:>7} {:>7} {:>10} {:>9} {:>14} {:>7}\n",
      "method", "particles", "motion", "edge", "step", "steps", "looks", "bounds", "estimates",
      "share", "dt/dt_crit <=", "det F");
  for (const CrushRow& row : atlas.crush)
    text += fmt::format(
        "{:<26} {:>9} {:<8} {:>6} {:<15} {:>7} {:>7} {:>7} {:>10} {:>8.1f}% {:>14} {:>7}{}\n",
        row.method, row.particles, row.motion, fmt::format("{:g}c", row.speed), row.follow,
        row.steps, row.looks, row.bounds, row.estimates, 100.0 * row.share,
        short_number(row.closest), short_number(row.smallest), row.failure.empty() ? "" : "  lost");
  return text;
}

}  // namespace

Safety Atlas::safety() const {
  Safety safety;
  for (const AtlasRow& row : rows) {
    if (!(row.bound > 0.0) || row.verdict == Verdict::material) continue;
    safety.smallest_share = std::min(safety.smallest_share, row.bound / row.limit);
    safety.largest_share = std::max(safety.largest_share, row.bound / row.limit);
    if (row.verdict != Verdict::stable && row.verdict != Verdict::soft) continue;
    ++safety.stable_states;
    const PerturbedRun* run = run_of(row, "0.95");
    if (run == nullptr || !run->bounded() ||
        !(run->energy_drift < 0.1 || std::isnan(run->energy_drift)))
      ++safety.lost_runs;
  }
  return safety;
}

std::string Atlas::text() const {
  std::string text = table_of_states(*this) + table_of_waves(*this) + table_of_contrast(*this) +
                     table_of_crush(*this);
  const Safety safe = safety();
  if (safe.stable_states > 0)
    text += fmt::format(
        "\nThe computed critical step is {:.3f} to {:.3f} of the true limit; of {} states that are "
        "stable below it, {} were lost at 0.95 of it.\n",
        safe.smallest_share, safe.largest_share, safe.stable_states, safe.lost_runs);
  for (const Failure& failure : failures)
    text += fmt::format(
        "\n{} ({} state{})\n  fails: {}\n  why:   {}\n  cure:  {}\n  run:   {}\n  "
        "cured: {}\n",
        failure.where, failure.states, failure.states == 1 ? "" : "s", failure.what, failure.why,
        failure.cure, failure.evidence, failure.cured);
  return text + fmt::format("\n{} states, {} methods' waves, {:.0f} s{}\n", rows.size(),
                            waves.size(), seconds, interrupted ? ", interrupted" : "");
}

}  // namespace tlsph
