#pragma once
/// \file
/// Extreme eigenvalues of an operator known only by what it does to a vector. The critical time
/// step (from the largest eigenvalue of M^-½ K M^-½) and growth rates come from here.

#include <Eigen/Core>
#include <complex>
#include <cstdint>
#include <functional>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// y = A x; both have n entries, `y` comes sized and is to be overwritten.
using LinearMap = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& y)>;

/// How long to iterate, and from which start.
struct LanczosOptions {
  int max_steps = 60;
  /// Relative residual at which the iteration stops.
  double tolerance = 1e-4;
  /// Of the pseudo-random start vector: the same seed gives the same bits.
  std::uint64_t seed = 1;
};

/// What Lanczos knows of the largest eigenvalue λ.
struct LanczosResult {
  /// The largest Ritz value θ ≤ λ.
  double value = 0;
  /// θ + residual: some eigenvalue lies in [θ − residual, θ + residual], and from a random start it
  /// is λ itself in all but contrived cases, so this is the number to be safe with.
  double upper_bound = 0;
  /// ‖A z − θ z‖ of the Ritz vector z, = |β_k s_k|.
  double residual = 0;
  /// Products with A that were needed.
  int steps = 0;
  bool converged = false;
};

/// The largest (rightmost) eigenvalue of a **symmetric** n×n operator by the Lanczos iteration
/// without reorthogonalisation, which costs copies of converged values but never a wrong one;
/// memory is three vectors (Paige 1972; Golub & Van Loan section 10.1). NumericalError if A gives
/// values that are not finite.
[[nodiscard]] LanczosResult largest_eigenvalue(const LinearMap& symmetric, Index n,
                                               const LanczosOptions& options = {});

/// Ritz values of a general n×n operator after at most `steps` Arnoldi steps with full
/// orthogonalisation, largest modulus first; all eigenvalues if the Krylov space closes (at the
/// latest when steps = n). Memory is steps + 1 vectors. NumericalError if A gives values that are
/// not finite.
[[nodiscard]] std::vector<std::complex<double>> arnoldi_eigenvalues(const LinearMap& map, Index n,
                                                                    int steps,
                                                                    std::uint64_t seed = 1);

}  // namespace tlsph
