#include "tlsph/linear/krylov.hpp"

#include <omp.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tlsph/core/error.hpp"
#include "tlsph/core/team.hpp"

namespace tlsph {
namespace {

constexpr int steps_between_looks = 4;
constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();

/// A unit vector with entries from the raw bits of the generator, so that every standard library
/// draws the same.
Eigen::VectorXd random_unit_vector(Index n, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  Eigen::VectorXd v(n);
  for (double& entry : v) entry = std::ldexp(static_cast<double>(bits() >> 11), -52) - 1.0;
  v /= v.norm();
  return v;
}

/// Entries of a chunk: sums are made chunk by chunk and those added in their order, so that they do
/// not depend on the number of threads.
constexpr Index chunk = 8192;

/// Σ part(first, count) over the chunks of n entries.
template <class Part>
double sum_chunks(Index n, std::vector<double>& parts, const Part& part) {
  const Index chunks = (n + chunk - 1) / chunk;
  parts.resize(static_cast<std::size_t>(chunks));
  static TeamChoice choice;  // one for every sum of its kind
  in_parts(choice, static_cast<double>(n), omp_get_max_threads(), static_cast<int>(chunks),
           [&](int c) {
             parts[static_cast<std::size_t>(c)] = part(c * chunk, std::min(chunk, n - c * chunk));
           });
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

void require_finite(bool finite) {
  if (!finite) {
    throw NumericalError("eigenvalue estimate: the operator gave a value that is not finite", 0.0,
                         -1);
  }
}

void require_entries(Index n, int steps) {
  if (n < 1 || steps < 1) {
    throw std::invalid_argument("eigenvalue estimate: wants at least one entry and one step");
  }
}

/// θ and |s_k| of the largest eigenpair of the tridiagonal matrix T.
struct RitzPair {
  double value;
  double last_component;
};

RitzPair largest_ritz_pair(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const auto k = static_cast<Index>(diagonal.size());
  const Eigen::VectorXd alpha = Eigen::Map<const Eigen::VectorXd>(diagonal.data(), k);
  const Eigen::VectorXd beta = Eigen::Map<const Eigen::VectorXd>(beside.data(), k - 1);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(alpha, beta);
  return {solver.eigenvalues()(k - 1), std::abs(solver.eigenvectors()(k - 1, k - 1))};
}

/// From the real Schur form: 1×1 blocks are real eigenvalues, 2×2 blocks conjugate pairs. (Eigen's
/// EigenSolver gives the same and takes four times as long to compile.)
std::vector<std::complex<double>> hessenberg_eigenvalues(const Eigen::MatrixXd& H) {
  const Index n = H.rows();
  Eigen::RealSchur<Eigen::MatrixXd> schur(n);
  schur.computeFromHessenberg(H, Eigen::MatrixXd(), false);
  if (schur.info() != Eigen::Success) {
    throw NumericalError("eigenvalue estimate: the QR iteration does not converge", 0.0, -1);
  }
  const Eigen::MatrixXd& T = schur.matrixT();
  std::vector<std::complex<double>> values;
  for (Index i = 0; i < n; ++i) {
    if (i + 1 < n && T(i + 1, i) != 0.0) {
      const double mean = 0.5 * (T(i, i) + T(i + 1, i + 1));
      const double half = 0.5 * (T(i, i) - T(i + 1, i + 1));
      const double imaginary = std::sqrt(std::abs(half * half + T(i + 1, i) * T(i, i + 1)));
      values.emplace_back(mean, imaginary);
      values.emplace_back(mean, -imaginary);
      ++i;
    } else {
      values.emplace_back(T(i, i), 0.0);
    }
  }
  return values;
}

}  // namespace

LanczosResult largest_eigenvalue(const LinearMap& symmetric, Index n,
                                 const LanczosOptions& options) {
  require_entries(n, options.max_steps);
  Eigen::VectorXd v = random_unit_vector(n, options.seed);
  Eigen::VectorXd previous = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd w(n);
  std::vector<double> alpha;
  std::vector<double> beta;
  std::vector<double> parts;
  LanczosResult result;
  // A V = V T + β_k v_{k+1} e_kᵀ, T tridiagonal: w = A v_k − α_k v_k − β_{k−1} v_{k−1}.
  double scale = 0.0;
  while (result.steps < options.max_steps) {
    symmetric(v, w);
    ++result.steps;
    alpha.push_back(sum_chunks(n, parts, [&](Index first, Index count) {
      auto part = w.segment(first, count);
      if (!beta.empty()) part -= beta.back() * previous.segment(first, count);
      return part.dot(v.segment(first, count));
    }));
    const double next = std::sqrt(sum_chunks(n, parts, [&](Index first, Index count) {
      auto part = w.segment(first, count);
      part -= alpha.back() * v.segment(first, count);
      return part.squaredNorm();
    }));
    require_finite(std::isfinite(next));

    scale = std::max({scale, std::abs(alpha.back()), next});
    const bool closed = next <= rounding * scale;  // the Krylov space is invariant: θ is exact
    // The small eigenproblem costs as much as a product of a small body: not at every step.
    if (closed || result.steps % steps_between_looks == 0 || result.steps == options.max_steps) {
      const RitzPair ritz = largest_ritz_pair(alpha, beta);
      result.value = ritz.value;
      result.residual = next * ritz.last_component;
      result.converged = closed || result.residual <= options.tolerance * std::abs(ritz.value);
      if (result.converged) break;
    }

    beta.push_back(next);
    previous.swap(v);
    sum_chunks(n, parts, [&](Index first, Index count) {
      v.segment(first, count) = w.segment(first, count) / next;
      return 0.0;
    });
  }
  result.upper_bound = result.value + result.residual;
  return result;
}

std::vector<std::complex<double>> arnoldi_eigenvalues(const LinearMap& map, Index n, int steps,
                                                      std::uint64_t seed) {
  require_entries(n, steps);
  const Index most = std::min<Index>(n, steps);
  Eigen::MatrixXd V(n, most + 1);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(most + 1, most);
  V.col(0) = random_unit_vector(n, seed);
  Eigen::VectorXd x(n);
  Eigen::VectorXd w(n);
  Index k = 0;
  while (k < most) {
    x = V.col(k);
    map(x, w);
    require_finite(w.allFinite());
    const double length = w.norm();
    // Gram–Schmidt twice is enough to be orthogonal to rounding (Kahan and Parlett).
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd overlap = V.leftCols(k + 1).transpose() * w;
      w -= V.leftCols(k + 1) * overlap;
      H.col(k).head(k + 1) += overlap;
    }
    const double next = w.norm();
    ++k;
    if (next <= rounding * length) break;  // the Krylov space is invariant
    H(k, k - 1) = next;
    V.col(k) = w / next;
  }
  std::vector<std::complex<double>> sorted = hessenberg_eigenvalues(H.topLeftCorner(k, k));
  std::ranges::stable_sort(sorted, std::ranges::greater{},
                           [](const std::complex<double>& z) { return std::abs(z); });
  return sorted;
}

}  // namespace tlsph
