#include <algorithm>
#include <cmath>

#include "sample.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/stepping/critical_step.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph {
namespace {

/// Eigenvalues of n² products are known to this share of the largest.
constexpr double round_off = 1e-11;
/// Roots of a defective matrix, as one of ghosts can be, to the square root of that.
constexpr double defective = 1e-7;

/// λ_max(Δt²K + 2ΔtC) = 4 by bisection between the two steps that bracket it.
double damped_limit(const SparseMatrix& K, const SparseMatrix& C, double undamped) {
  double low = 0.0;
  double high = undamped;
  while (high - low > 1e-4 * high) {
    const double dt = low == 0.0 ? 0.5 * high : 0.5 * (low + high);
    const SparseMatrix sum = dt * dt * K + 2.0 * dt * C;
    double largest = 0.0;
    for (const auto& value : eigenvalues(sum)) largest = std::max(largest, value.real());
    (largest > 4.0 ? high : low) = dt;
  }
  return low;
}

}  // namespace

Index StateSpectrum::below(double square) const {
  return static_cast<Index>(
      std::ranges::count_if(squares, [&](const auto& value) { return std::abs(value) < square; }));
}

double StateSpectrum::smallest(Index count) const {
  std::vector<double> sizes;
  for (const auto& square : squares) sizes.push_back(std::abs(square));
  std::ranges::sort(sizes);
  return sizes.at(static_cast<std::size_t>(count));
}

template <int D>
StateSpectrum spectrum_of(const Sample<D>& sample) {
  LinearisedForces<D> forces(sample.body, sample.state);
  const SparseMatrix K = forces.dynamical_matrix();
  StateSpectrum result;
  result.squares = eigenvalues(K);
  const double largest = result.squares.empty() ? 0.0 : std::abs(result.squares.front());
  result.limit = 2.0 / std::sqrt(largest);
  if (sample.body.viscosity.nonZeros() > 0)
    result.limit = damped_limit(K, forces.damping_matrix(), result.limit);
  const double nothing = (sample.body.adjoint ? round_off : defective) * largest;
  for (auto& square : result.squares) {
    // Pairs of a double root leave the axis by the square root of round-off: no growth of a motion.
    if (std::abs(square.imag()) <= nothing) square.imag(0.0);
    if (square.real() < -nothing && square.imag() == 0.0) ++result.negative;
  }
  std::vector<std::complex<double>> true_ones;
  for (const auto& square : result.squares)
    if (std::abs(square) > nothing) true_ones.push_back(square);
  result.growth = growth_rate(true_ones);
  if (const auto critical = critical_step_if_any<D>(sample.body, sample.state))
    result.bound = critical->dt;
  return result;
}

template StateSpectrum spectrum_of<1>(const Sample<1>&);
template StateSpectrum spectrum_of<2>(const Sample<2>&);

}  // namespace tlsph
