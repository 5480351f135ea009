#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/materials/waves.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

/// Modes below this share of the first true ω² are no vibrations of the body.
constexpr double share_of_first = 0.5;
/// Growth in one critical step below which 20 000 of them do not show it; told in numbers only.
constexpr double slow_growth = 7.5e-4;
/// A mode without energy that a viscosity keeps below this excursion is no failure.
constexpr double damped_excursion = 1.2;

template <int D>
constexpr Index rigid_motions = D*(D + 1) / 2;

template <int D>
double largest_imbalance(const Sample<D>& sample) {
  const Tensor<D> P = pk1<D>(sample.body.regions.front().law, sample.H0);
  const double scale = P.norm() * std::pow(sample.body.spacing, D - 1);
  double largest = 0.0;
  for (Index dof = 0; dof < sample.state.f.size(); ++dof)
    if (sample.body.inverse_mass.data()[dof] != 0.0)
      largest = std::max(largest, std::abs(sample.state.f.data()[dof]));
  return scale > 0.0 ? largest / scale : 0.0;
}

/// Modes without energy of an undeformed body: free where it can be, else with sliding edges.
template <int D>
void count_zero_energy_modes(const StateKey& key, FirstVibration& first, const Sample<D>& sample,
                             const StateSpectrum& spectrum, bool free, AtlasRow& row) {
  const double omega = first.of(key, free ? Support::free : Support::sliding);
  const Index below = spectrum.below(share_of_first * omega * omega);
  row.zero_energy_modes = free ? std::max<Index>(0, below - rigid_motions<D>) : below;
  if (free) row.excursion = free_excursion<D>(sample, 0.9 * spectrum.limit, omega);
}

Verdict verdict_of(const AtlasRow& row) {
  if (!row.refusal.empty()) return Verdict::refused;
  if (row.acoustic <= 0.0) return Verdict::material;
  if (row.negative > 0) return Verdict::negative;
  if (row.growth * row.limit > slow_growth) return Verdict::growing;
  return row.zero_energy_modes > 0 && !(row.excursion < damped_excursion) ? Verdict::zero_energy
                                                                          : Verdict::stable;
}

template <int D>
void examine(const Subject& subject, const StateKey& key, FirstVibration& first, AtlasRow& row) {
  const Sample<D> sample =
      build_sample<D>(subject, key, key.strip > 0 ? Support::free : Support::sliding);
  const Discretisation<D>& body = sample.body;
  const double unit = body.spacing / body.wave_speed();  // Δ/c_p [s]
  const Tangent<D> A = tangent<D>(body.regions.front().law, sample.H0);
  const double modulus = tangent<D>(body.regions.front().law, Tensor<D>::Zero())(0, 0);
  row.particles = body.nodes();
  row.acoustic = smallest_acoustic_eigenvalue<D>(A) / modulus;
  row.imbalance = largest_imbalance<D>(sample);
  const StateSpectrum spectrum = spectrum_of<D>(sample);
  row.bound = spectrum.bound / unit;
  row.limit = spectrum.limit / unit;
  row.negative = body.adjoint ? spectrum.negative : 0;
  row.growth = spectrum.growth * unit;
  if (key.strip > 0) {
    // A thin body is free anyway; modes below its first bending are no vibrations of it.
    count_zero_energy_modes<D>(key, first, sample, spectrum, true, row);
  } else if (key.stretch == 1.0 && body.adjoint) {
    const auto free = build_sample<D>(subject, key, Support::free);
    count_zero_energy_modes<D>(key, first, free, spectrum_of<D>(free), true, row);
  } else if (key.stretch == 1.0) {
    count_zero_energy_modes<D>(key, first, sample, spectrum, false, row);
  }
  row.verdict = verdict_of(row);
  if (key.stretch != 1.0) row.drift = drift_at_rest<D>(sample, 0.9 * spectrum.critical());
  for (const double ratio : {0.95, 1.02})
    row.runs.push_back(
        perturbed_run<D>(sample, spectrum, ratio * spectrum.critical(), fmt::format("{}", ratio)));
  if (key.stretch == 1.0 && !std::isnan(row.support) && key.strip == 0) {
    // The rule of the thesis, (4.47): h over the speed of a thin bar.
    const double rule = row.support * body.spacing / std::sqrt(subject.young / subject.density);
    row.runs.push_back(perturbed_run<D>(sample, spectrum, rule, "h/c"));
  }
  if ((row.verdict == Verdict::stable || row.verdict == Verdict::zero_energy) && body.adjoint) {
    try {
      row.runs.front().energy_drift = energy_drift<D>(sample, 0.95 * spectrum.critical());
    } catch (const NumericalError&) {
      row.runs.front().energy_drift = std::numeric_limits<double>::infinity();
    }
  }
}

}  // namespace

double FirstVibration::of(const StateKey& key, Support support) {
  const std::string name =
      fmt::format("{} {} {}", key.strip, key.poisson, static_cast<int>(support));
  if (const auto found = known_.find(name); found != known_.end()) return found->second;
  StateKey reference = key;
  reference.jitter = 0.0;
  reference.stretch = 1.0;
  reference.method = {};
  reference.method.name = "reference";
  // A strip of particles in the middle of cells is as thick as one of a cell more on the boundary.
  if (key.strip > 0 && key.method.cell_centred) ++reference.strip;
  const auto find = [&]<int D>() {
    const auto spectrum = spectrum_of<D>(build_sample<D>(subject_, reference, support));
    const Index rigid = support == Support::free ? rigid_motions<D> : 0;
    return std::sqrt(spectrum.smallest(rigid));
  };
  const double omega = in_dimension(subject_.dimension, find);
  return known_.emplace(name, omega).first->second;
}

AtlasRow state_row(const Subject& subject, const StateKey& key, FirstVibration& first) {
  AtlasRow row;
  row.name = key.name();
  row.method = key.method.name;
  row.body = key.strip > 0 ? fmt::format("strip of {}", key.strip) : "scene";
  row.jitter = key.jitter;
  row.poisson = key.poisson;
  row.stretch = key.stretch;
  try {
    const Scene scene = scene_of(subject, key, Support::free);
    row.formulation = name_of(scene.formulation);
    row.kernel = scene.formulation == Formulation::stress_point && !scene.kernel.support
                     ? "cell"
                     : scene.kernel.family.get();
    row.support = scene.kernel.support.value_or(not_known);
    in_dimension(subject.dimension, [&]<int D>() { examine<D>(subject, key, first, row); });
  } catch (const InputError& error) {
    row.refusal = error.what();
  } catch (const NumericalError& error) {
    row.refusal = error.what();
  }
  if (!row.refusal.empty()) row.verdict = Verdict::refused;
  return row;
}

}  // namespace tlsph
