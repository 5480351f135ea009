#include "tlsph/operators/consistency.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "consistency_constraints.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph {
namespace {

constexpr double acceptable = 1e-8;  // residual that is an error above
constexpr double exact_enough = 1e-13;
constexpr double good_enough = 1e-11;  // of the factor of A w Aᵀ; else that of √w Aᵀ is taken
constexpr double gain = 1e-9;          // of a round; the next one starts from the true residual
/// Lifts of the diagonal that are tried in turn, shares of its largest entry.
constexpr std::array lifts = {1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9};
constexpr int most_refinements = 5;
/// Of conjugate gradients in each; where they end there, no other follows.
constexpr int most_iterations = 40;
/// Every entry may change a little, those that are zero too: share of the largest weight.
constexpr double least_weight = 1e-3;

/// The entries of a direction, times Δ.
template <int D>
Eigen::VectorXd entries_of(const VectorOperator<D>& gradient, int a, double spacing) {
  Eigen::VectorXd g(gradient.nonzeros());
  for (Index k = 0; k < g.size(); ++k) g[k] = spacing * gradient.weight(k, a);
  return g;
}

/// The part of x that is orthogonal to the columns of `dependences`.
Eigen::VectorXd without(Eigen::VectorXd x, const Eigen::MatrixXd& dependences) {
  x -= dependences * (dependences.transpose() * x);
  return x;
}

using Solve = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Adds to δ the change w Aᵀλ that takes away what is left of the constraints at g + δ: conjugate
/// gradients among the λ without `dependences`, preconditioned by `inverse`, which is nearly that
/// of A w Aᵀ.
template <int D>
void refine(const ConsistencyConstraints<D>& constraints, const Solve& inverse,
            const Eigen::MatrixXd& dependences, const Eigen::VectorXd& g,
            const Eigen::VectorXd& freedom, int a, Eigen::VectorXd& best) {
  const auto solved = [&](const Eigen::VectorXd& b) { return without(inverse(b), dependences); };
  const Eigen::VectorXd at_zero = constraints.residual(Eigen::VectorXd::Zero(g.size()), a);
  const auto product = [&](const Eigen::VectorXd& lambda) -> Eigen::VectorXd {
    return at_zero - constraints.residual(constraints.change(lambda, freedom), a);
  };
  Eigen::VectorXd left = constraints.residual(g + best, a);
  double size = left.cwiseAbs().maxCoeff();
  for (int round = 0; round < most_refinements && size > exact_enough; ++round) {
    Eigen::VectorXd lambda = Eigen::VectorXd::Zero(left.size());
    Eigen::VectorXd r = without(left, dependences);
    Eigen::VectorXd z = solved(r);
    Eigen::VectorXd direction = z;
    double rho = r.dot(z);
    const double enough = std::max(gain * size, 0.1 * exact_enough);
    int k = 0;
    for (; k < most_iterations && r.cwiseAbs().maxCoeff() > enough && rho > 0; ++k) {
      stop_point();
      const Eigen::VectorXd image = product(direction);
      const double step = rho / direction.dot(image);
      lambda += step * direction;
      r -= step * without(image, dependences);
      z = solved(r);
      const double next = r.dot(z);
      direction = z + next / rho * direction;
      rho = next;
    }
    const Eigen::VectorXd delta = best + constraints.change(lambda, freedom);
    const Eigen::VectorXd now = constraints.residual(g + delta, a);
    const double next = now.cwiseAbs().maxCoeff();
    if (!(next < size)) break;
    best = delta;
    left = now;
    size = next;
    if (k == most_iterations) break;
  }
}

/// As many rows as columns, on which the columns are as independent as can be.
std::vector<Index> strongest_rows(const Eigen::MatrixXd& columns) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.transpose());
  const auto& order = qr.colsPermutation().indices();
  return {order.data(), order.data() + columns.cols()};
}

/// Factorises the matrix (its lower triangle) with what makes it definite: the constraints `pinned`
/// take the dependences away, and a lift of the diagonal as small as rounding allows. False if no
/// lift makes it definite.
bool factorise(std::optional<Cholesky>& factor, SparseMatrix normal,
               const std::vector<Index>& pinned) {
  const auto diagonal = [&](Index row) -> double& {
    return normal.valuePtr()[normal.outerIndexPtr()[row + 1] - 1];
  };
  double largest = 0.0;
  for (Index row = 0; row < normal.rows(); ++row) largest = std::max(largest, diagonal(row));
  for (const Index row : pinned) diagonal(row) += largest;
  double lifted = 0.0;
  for (const double lift : lifts) {
    stop_point();
    for (Index row = 0; row < normal.rows(); ++row) diagonal(row) += (lift - lifted) * largest;
    lifted = lift;
    try {
      if (factor)
        factor->refactorize(normal);
      else
        factor.emplace(normal);
      return true;
    } catch (const NumericalError&) {  // not definite: the next lift
    }
  }
  return false;
}

/// The least change δ, Σ δ²/freedom, that makes the entries g of direction a consistent. `factor`
/// keeps its symbolic analysis for the next direction.
template <int D>
Eigen::VectorXd least_change(const ConsistencyConstraints<D>& constraints,
                             const Eigen::MatrixXd& dependences, const std::vector<Index>& pinned,
                             const Eigen::VectorXd& g, const Eigen::VectorXd& freedom, int a,
                             std::optional<Cholesky>& factor) {
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(g.size());
  if (factorise(factor, constraints.normal(freedom), pinned)) {
    SolveWorkspace scratch = factor->workspace();
    const Solve inverse = [&](const Eigen::VectorXd& b) {
      Eigen::VectorXd x(b.size());
      factor->solve_into(b.data(), x.data(), scratch);
      return x;
    };
    refine<D>(constraints, inverse, dependences, g, freedom, a, delta);
  }
  Eigen::VectorXd left = constraints.residual(g + delta, a);
  if (left.cwiseAbs().maxCoeff() <= good_enough) return delta;
  // In a long strip A w Aᵀ has eigenvalues below the rounding of its entries; √w Aᵀ has not.
  stop_point();
  try {
    LeastNorm solver(constraints.root(freedom, pinned));
    for (int round = 0; round < most_refinements; ++round) {
      stop_point();
      const Eigen::VectorXd roots = solver.solve(without(left, dependences));
      const Eigen::VectorXd next = delta + freedom.cwiseSqrt().cwiseProduct(roots.head(g.size()));
      const Eigen::VectorXd now = constraints.residual(g + next, a);
      if (!(now.cwiseAbs().maxCoeff() < left.cwiseAbs().maxCoeff())) break;
      delta = next;
      left = now;
    }
  } catch (const NumericalError&) {
    // Constraints that depend on each other: the residual left decides.
  }
  return delta;
}

}  // namespace

template <int D>
ConsistentGradient<D> consistent_gradient(const VectorOperator<D>& gradient,
                                          const MaterialPoints<D>& points,
                                          const Particles<D>& particles, ConsistencyDegrees degrees,
                                          const Place& place) {
  const ConsistencyConstraints<D> constraints(gradient, points, particles, degrees);
  ConsistentGradient<D> result;
  std::vector<double> weights(static_cast<std::size_t>(gradient.nonzeros() * D));
  std::optional<Cholesky> factor;
  const Eigen::MatrixXd dependences = constraints.dependences(points, particles);
  const std::vector<Index> pinned = strongest_rows(dependences);
  for (int a = 0; a < D; ++a) {
    const Eigen::VectorXd g = entries_of<D>(gradient, a, particles.spacing);
    const Eigen::VectorXd freedom = g.cwiseAbs().array() + least_weight * g.cwiseAbs().maxCoeff();
    const Eigen::VectorXd delta =
        least_change<D>(constraints, dependences, pinned, g, freedom, a, factor);
    const Eigen::VectorXd left = constraints.residual(g + delta, a);
    const Index rows = constraints.row_size();
    auto& [row, column, change] = result.residuals;
    row = std::max(row, left.head(rows).cwiseAbs().maxCoeff());
    column = std::max(column, left.tail(left.size() - rows).cwiseAbs().maxCoeff());
    change = std::max(change, delta.cwiseAbs().maxCoeff());
    for (Index k = 0; k < g.size(); ++k)
      weights[static_cast<std::size_t>(k * D + a)] = (g[k] + delta[k]) / particles.spacing;
  }
  const double worst = std::max(result.residuals.row, result.residuals.column);
  if (!(worst <= acceptable))
    throw InputError(place, fmt::format("the gradient cannot be made consistent to degrees ({}, "
                                        "{}): a residual of {:.1e} is left; "
                                        "choose a larger kernel.support or lower degrees",
                                        degrees.rows, degrees.columns, worst));
  result.gradient =
      VectorOperator<D>(gradient.rows(), gradient.cols(), gradient.pattern(), std::move(weights));
  return result;
}

template <int D>
FactorCost consistency_cost(const VectorOperator<D>& gradient, const MaterialPoints<D>& points,
                            const Particles<D>& particles, ConsistencyDegrees degrees) {
  const ConsistencyConstraints<D> constraints(gradient, points, particles, degrees);
  const SparseMatrix normal = constraints.normal(Eigen::VectorXd::Ones(gradient.nonzeros()));
  FactorCost cost = factor_cost(normal);
  const auto vectors = static_cast<double>(constraints.dependence_count() + 12);
  cost.bytes += constraints.bytes() + 12.0 * static_cast<double>(normal.nonZeros()) +
                8.0 * vectors * static_cast<double>(constraints.size());
  return cost;
}

#define TLSPH_INSTANTIATE(D)                                                                       \
  template ConsistentGradient<D> consistent_gradient<D>(                                           \
      const VectorOperator<D>&, const MaterialPoints<D>&, const Particles<D>&, ConsistencyDegrees, \
      const Place&);                                                                               \
  template FactorCost consistency_cost<D>(const VectorOperator<D>&, const MaterialPoints<D>&,      \
                                          const Particles<D>&, ConsistencyDegrees);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph
