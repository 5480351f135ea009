#include "bar_wave_run.hpp"

#include <algorithm>

#include "signals.hpp"

namespace tlsph {

BarWaveRun::BarWaveRun(CaseRun& run, const std::string& label, const std::string& file,
                       const std::vector<std::string>& overrides)
    : scene(run.scene(label, file, overrides)) {}

std::span<const double> BarWaveRun::stress(const std::string& probe) const {
  return scene.probe(probe + ".pk1_xx");
}

std::span<const double> BarWaveRun::exact_stress(const std::string& probe) const {
  const History& exact = scene.probes.exact;
  const auto found = std::ranges::find(exact.names, probe + ".pk1_xx");
  return exact.values.at(static_cast<std::size_t>(found - exact.names.begin()));
}

double BarWaveRun::error(const std::string& probe) const {
  return relative_error(time(), stress(probe), exact_stress(probe));
}

}  // namespace tlsph
