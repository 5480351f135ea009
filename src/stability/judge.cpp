#include "judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perturbed.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/materials/waves.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

constexpr double soft_share = 0.5;  ///< of the first true ω²: a mode below is none of the body
/// Growth in one critical step below which 20 000 of them do not show it; told in numbers only.
constexpr double slow_growth = 7.5e-4;
/// A soft mode that a viscosity keeps below this excursion is no failure.
constexpr double damped_excursion = 1.2;

template <int D>
constexpr Index rigid_motions = D*(D + 1) / 2;

template <int D>
double largest_imbalance(const Specimen<D>& specimen) {
  const Tensor<D> P = pk1<D>(specimen.disc.regions.front().law, specimen.H0);
  const double scale = P.norm() * std::pow(specimen.disc.spacing, D - 1);
  double largest = 0.0;
  for (Index dof = 0; dof < specimen.state.f.size(); ++dof)
    if (specimen.disc.inverse_mass.data()[dof] != 0.0)
      largest = std::max(largest, std::abs(specimen.state.f.data()[dof]));
  return scale > 0.0 ? largest / scale : 0.0;
}

/// Modes without energy of the undeformed body: free where a method can be, else with sliding
/// edges.
template <int D>
void count_soft(const Subject& subject, const StateKey& key, FirstVibration& first,
                const Specimen<D>& sliding, const StateSpectrum& held, AtlasRow& row) {
  const bool free = sliding.disc.adjoint;
  const double omega = first.of(key, free ? Support::free : Support::sliding);
  if (!free) {
    row.soft = held.below(soft_share * omega * omega);
    return;
  }
  const auto specimen = build_specimen<D>(subject, key, Support::free);
  const StateSpectrum spectrum = spectrum_of<D>(specimen);
  row.soft = std::max<Index>(0, spectrum.below(soft_share * omega * omega) - rigid_motions<D>);
  row.excursion = free_excursion<D>(specimen, 0.9 * spectrum.limit, omega);
}

Verdict verdict_of(const AtlasRow& row) {
  if (!row.refusal.empty()) return Verdict::refused;
  if (row.acoustic <= 0.0) return Verdict::material;
  if (row.negative > 0) return Verdict::negative;
  if (row.growth * row.limit > slow_growth) return Verdict::growing;
  return row.soft > 0 && !(row.excursion < damped_excursion) ? Verdict::soft : Verdict::stable;
}

template <int D>
void look_at(const Subject& subject, const StateKey& key, FirstVibration& first, AtlasRow& row) {
  const Specimen<D> specimen =
      build_specimen<D>(subject, key, key.strip > 0 ? Support::free : Support::sliding);
  const Discretisation<D>& disc = specimen.disc;
  const double unit = disc.spacing / disc.wave_speed();  // Δ/c_p [s]
  const Tangent<D> A = tangent<D>(disc.regions.front().law, specimen.H0);
  const double modulus = tangent<D>(disc.regions.front().law, Tensor<D>::Zero())(0, 0);
  row.particles = disc.nodes();
  row.acoustic = smallest_acoustic_eigenvalue<D>(A) / modulus;
  row.imbalance = largest_imbalance<D>(specimen);
  const StateSpectrum spectrum = spectrum_of<D>(specimen);
  row.bound = spectrum.bound / unit;
  row.limit = spectrum.limit / unit;
  row.negative = disc.adjoint ? spectrum.negative : 0;
  row.growth = spectrum.growth * unit;
  if (key.strip > 0) {
    // A thin body is looked at as it is, free; what it has below its first bending is no mode of
    // it.
    const double omega = first.of(key, Support::free);
    row.soft = std::max<Index>(0, spectrum.below(soft_share * omega * omega) - rigid_motions<D>);
    row.excursion = free_excursion<D>(specimen, 0.9 * spectrum.limit, omega);
  } else if (key.stretch == 1.0) {
    count_soft<D>(subject, key, first, specimen, spectrum, row);
  }
  row.verdict = verdict_of(row);
  if (key.stretch != 1.0) row.unrest = unrest<D>(specimen, 0.9 * spectrum.critical());
  for (const double ratio : {0.95, 1.02})
    row.runs.push_back(perturbed_run<D>(specimen, spectrum, ratio * spectrum.critical(),
                                        fmt::format("{}", ratio)));
  if (key.stretch == 1.0 && !std::isnan(row.support) && key.strip == 0) {
    // The rule of the thesis, (4.47): h over the speed of a thin bar.
    const double rule = row.support * disc.spacing / std::sqrt(subject.young / subject.density);
    row.runs.push_back(perturbed_run<D>(specimen, spectrum, rule, "h/c"));
  }
  if ((row.verdict == Verdict::stable || row.verdict == Verdict::soft) && disc.adjoint) {
    try {
      row.runs.front().energy_drift = energy_drift<D>(specimen, 0.95 * spectrum.critical());
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
    const auto spectrum = spectrum_of<D>(build_specimen<D>(subject_, reference, support));
    const Index rigid = support == Support::free ? rigid_motions<D> : 0;
    return std::sqrt(smallest_square(spectrum, rigid));
  };
  const double omega = in_dimension(subject_.dimension, find);
  return known_.emplace(name, omega).first->second;
}

AtlasRow judge(const Subject& subject, const StateKey& key, FirstVibration& first) {
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
    in_dimension(subject.dimension, [&]<int D>() { look_at<D>(subject, key, first, row); });
  } catch (const InputError& error) {
    row.refusal = error.what();
    row.verdict = Verdict::refused;
  } catch (const NumericalError& error) {
    row.refusal = error.what();
    row.verdict = Verdict::refused;
  }
  return row;
}

}  // namespace tlsph
