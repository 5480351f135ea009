#include <algorithm>
#include <cmath>

#include "studies.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/contrast/growth.hpp"
#include "tlsph/core/dimensions.hpp"

namespace tlsph {
namespace {

constexpr double step = 0.05;      ///< [Δ/c]
constexpr double duration = 70.0;  ///< of a run that need not grow [Δ/c]
constexpr int held = 3;            ///< layers, so that every free particle has all its neighbours

template <int D>
ContrastRow at_stress(const Subject& subject, double ratio) {
  // A plane wave sees λ + 2μ; in one dimension there is no shear.
  const double lambda =
      subject.young * subject.poisson / ((1.0 + subject.poisson) * (1.0 - 2.0 * subject.poisson));
  const double mu = 0.5 * subject.young / (1.0 + subject.poisson);
  const double modulus = lambda + 2.0 * mu;
  const Lame moduli = D == 1 ? Lame{modulus, 0.0} : Lame{lambda, mu};
  const double unit = subject.spacing / std::sqrt(modulus / subject.density);
  const StressedLattice<D> lattice{CubicSpline{}, 2.4 * subject.spacing, subject.spacing,
                                   moduli,        subject.density,       ratio * modulus};
  std::array<int, D> counts;
  counts.fill(D == 1 ? 101 : 19);
  CurrentRun<D> run = current_lattice<D>(lattice, counts, held);
  ContrastRow row;
  row.dimension = D;
  row.stress = ratio;
  row.expected = linear_growth_rate<D>(run) * unit;
  if (row.expected < 1e-3) row.expected = 0.0;
  run.state.v(run.state.v.rows() / 2, 0) = 1e-10 * subject.spacing / unit;
  const double end = row.expected > 0.0 ? 22.0 / row.expected : duration;
  EnergyHistory history = step_until<D>(run, step * unit, end * unit);
  for (double& time : history.time) time /= unit;
  row.amplitude = std::ranges::max(history.energy);
  row.seen =
      row.amplitude < 10.0 ? 0.0 : 0.5 * growth_rate(history.time, history.energy, 1e6, 1e12);
  return row;
}

}  // namespace

std::vector<ContrastRow> contrast_rows(const Subject& subject) {
  std::vector<ContrastRow> rows;
  for (const double ratio : {-0.05, 0.0, 0.05, 0.1})
    rows.push_back(
        in_dimension(subject.dimension, [&]<int D>() { return at_stress<D>(subject, ratio); }));
  return rows;
}

}  // namespace tlsph
