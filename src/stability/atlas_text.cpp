#include <fmt/format.h>

#include "tlsph/stability/atlas.hpp"
#include "verdict_names.hpp"

namespace tlsph {
namespace {

std::string short_number(double value) {
  if (std::isnan(value)) return "-";
  return value == 0.0 || (std::abs(value) >= 1e-2 && std::abs(value) < 1e4)
             ? fmt::format("{:.3f}", value)
             : fmt::format("{:.1e}", value);
}

}  // namespace

std::string Atlas::text() const {
  std::string text = fmt::format("{:<62} {:>8} {:>7} {:>7} {:>5} {:>5} {:>9}\n", "state", "verdict", "bound", "b/limit", "soft", "neg", "growth");
  for (const AtlasRow& row : rows) {
    text += fmt::format("{:<62} {:>8} {:>7} {:>7} {:>5} {:>5} {:>9} imb {} exc {}", row.name, verdict_name(row.verdict),
                        short_number(row.bound), short_number(row.bound / row.limit), row.soft, row.negative, short_number(row.growth), short_number(row.imbalance), short_number(row.excursion));
    for (const auto& run : row.runs)
      text += fmt::format(" | {} exp {} seen {} amp {} drift {} n {} lost {}", run.label, short_number(run.expected), short_number(run.seen), short_number(run.amplitude), short_number(run.energy_drift), run.steps, run.lost_at);
    text += row.refusal.empty() ? "\n" : fmt::format(" {}\n", row.refusal);
  }
  for (const WaveRow& row : waves)
    text += fmt::format("{:<40} zero {} T {} L {} aniso {} slowest {}\n", row.method, row.zero_energy, short_number(row.transverse), short_number(row.longitudinal), short_number(row.anisotropy), short_number(row.slowest));
  for (const ContrastRow& row : contrast)
    text += fmt::format("UL {} expected {} seen {} amp {}\n", row.stress, short_number(row.expected), short_number(row.seen), short_number(row.amplitude));
  return text + fmt::format("{:.1f} s\n", seconds);
}

}  // namespace tlsph
