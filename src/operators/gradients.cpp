#include "tlsph/operators/gradients.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <utility>

#include "tlsph/core/error.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

/// Reciprocal condition below which a moment matrix counts as singular.
constexpr double singular = 1e-10;

template <int D>
[[noreturn]] void too_few_neighbours(const Vector<D>& at, Index count, double h) {
  std::string where;
  for (int a = 0; a < D; ++a) where += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", at[a]);
  throw InputError(
      fmt::format("kernel.support: the {} neighbours of the particle at ({}) within {:.6g} m do "
                  "not determine a "
                  "gradient; choose a larger support or a thicker body",
                  count, where, h));
}

/// ∇_p W(X_p − X_q); zero for the particle itself.
template <int D, class Family>
Vector<D> kernel_gradient(const Family& family, const Vector<D>& difference, double h) {
  const double r = difference.norm();
  if (r == 0.0) return Vector<D>::Zero();
  return kernel_first<D>(family, r, h) / r * difference;
}

template <int D>
Vector<D> position(const VectorField<D>& X, Index row) {
  return X.row(row).transpose();
}

/// Calls `entry(k, q, X_p − X_q)` for the entries of row p.
template <int D, class Entry>
void for_row(const Neighbours& near, const VectorField<D>& points, const VectorField<D>& X, Index p,
             const Entry& entry) {
  for (Index k = near.start[static_cast<std::size_t>(p)];
       k < near.start[static_cast<std::size_t>(p) + 1]; ++k) {
    const Index q = near.column[static_cast<std::size_t>(k)];
    const Vector<D> difference = (points.row(p) - X.row(q)).transpose();
    entry(k, q, difference);
  }
}

template <int D>
void store(std::vector<double>& weights, Index k, const Vector<D>& value) {
  for (int a = 0; a < D; ++a) weights[static_cast<std::size_t>(k * D + a)] = value[a];
}

/// Inverse of the moment matrix of row p, or the error that it has none.
template <int D>
Tensor<D> inverse_moment(const Tensor<D>& moment, double scale, const Vector<D>& at, Index count,
                         double h) {
  const double det = moment.determinant();
  double limit = singular;
  for (int a = 0; a < D; ++a) limit *= scale;
  if (!(std::abs(det) > limit)) too_few_neighbours<D>(at, count, h);
  return moment.inverse();
}

/// Row s of the fit c·p(X_q − X_s), p the monomials up to degree 2 in units of h: the weights of
/// the first derivatives.
template <int D, class Family>
void fit_row(const Family& family, const Neighbours& near, const VectorField<D>& points,
             const VectorField<D>& X, Index s, double h, int order, std::vector<double>& weights) {
  const auto exponents = monomials<D>(order);
  const auto terms = static_cast<Index>(exponents.size());
  const auto values = [&](const Vector<D>& difference) {
    return monomial_values<D>(exponents, Vector<D>(-difference / h));
  };
  Eigen::MatrixXd moment = Eigen::MatrixXd::Zero(terms, terms);
  for_row<D>(near, points, X, s, [&](Index, Index, const Vector<D>& difference) {
    const Eigen::VectorXd p = values(difference);
    moment += kernel_value<D>(family, difference.norm(), h) * p * p.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(moment);
  const auto row = static_cast<std::size_t>(s);
  if (!(spectrum.eigenvalues()[0] > singular * spectrum.eigenvalues()[terms - 1]))
    too_few_neighbours<D>(position<D>(points, s), near.start[row + 1] - near.start[row], h);
  // The coefficients of the first derivatives are rows 1 … D of M⁻¹ Σ w p.
  const Eigen::MatrixXd inverse =
      moment.ldlt().solve(Eigen::MatrixXd::Identity(terms, terms)).middleRows(1, D) / h;
  for_row<D>(near, points, X, s, [&](Index k, Index, const Vector<D>& difference) {
    const double w = kernel_value<D>(family, difference.norm(), h);
    store<D>(weights, k, Vector<D>(w * (inverse * values(difference))));
  });
}

}  // namespace

template <int D>
SparseMatrix kernel_matrix(const AnyKernel& kernel, double h, const VectorField<D>& X,
                           const ScalarField& V) {
  const Neighbours near = find_neighbours<D>(X, X, h);
  SparseMatrix W(X.rows(), X.rows());
  W.resizeNonZeros(near.size());
  for (Index p = 0; p <= X.rows(); ++p)
    W.outerIndexPtr()[p] = static_cast<int>(near.start[static_cast<std::size_t>(p)]);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p)
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            W.innerIndexPtr()[k] = static_cast<int>(q);
            W.valuePtr()[k] = V[q] * kernel_value<D>(family, difference.norm(), h);
          });
      },
      kernel);
  return W;
}

template <int D>
VectorOperator<D> plain_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                 const ScalarField& V) {
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights(near.column.size() * D);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p)
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            store<D>(weights, k, V[q] * kernel_gradient<D>(family, difference, h));
          });
      },
      kernel);
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> collocated_gradient(const AnyKernel& kernel, double h, const VectorField<D>& X,
                                      const ScalarField& V, Correction correction) {
  if (correction == Correction::least_squares) return point_gradient<D>(kernel, h, X, X);
  Neighbours near = find_neighbours<D>(X, X, h);
  std::vector<double> weights(near.column.size() * D);
  std::visit(
      [&](const auto& family) {
        for (Index p = 0; p < X.rows(); ++p) {
          // Shepard's constant correction (53), (57): γ = Σ V ∇W / Σ V W; zero for the others.
          double sum = 1.0;
          Vector<D> gamma = Vector<D>::Zero();
          if (correction == Correction::mixed) {
            sum = 0.0;
            for_row<D>(near, X, X, p, [&](Index, Index q, const Vector<D>& difference) {
              sum += V[q] * kernel_value<D>(family, difference.norm(), h);
              gamma += V[q] * kernel_gradient<D>(family, difference, h);
            });
            gamma /= sum;
          }
          const auto gradient = [&](const Vector<D>& difference) -> Vector<D> {
            Vector<D> plain = kernel_gradient<D>(family, difference, h);
            if (correction != Correction::mixed) return plain;
            return (plain - gamma * kernel_value<D>(family, difference.norm(), h)) / sum;
          };
          // L = (Σ V ∇W ⊗ (X_q − X_p))⁻¹, (45) and (58).
          Tensor<D> L = Tensor<D>::Identity();
          if (correction != Correction::none) {
            Tensor<D> moment = Tensor<D>::Zero();
            for_row<D>(near, X, X, p, [&](Index, Index q, const Vector<D>& difference) {
              moment -= V[q] * gradient(difference) * difference.transpose();
            });
            const auto row = static_cast<std::size_t>(p);
            L = inverse_moment<D>(moment, 1.0, position<D>(X, p),
                                  near.start[row + 1] - near.start[row], h);
          }
          Vector<D> others = Vector<D>::Zero();
          Index self = -1;
          for_row<D>(near, X, X, p, [&](Index k, Index q, const Vector<D>& difference) {
            if (q == p) {
              self = k;
              return;
            }
            const Vector<D> weight = V[q] * L * gradient(difference);
            others += weight;
            store<D>(weights, k, weight);
          });
          store<D>(weights, self, -others);
        }
      },
      kernel);
  return VectorOperator<D>(X.rows(), X.rows(), std::move(near), std::move(weights));
}

template <int D>
VectorOperator<D> point_gradient(const AnyKernel& kernel, double h, const VectorField<D>& points,
                                 const VectorField<D>& X, int order) {
  Neighbours near = find_neighbours<D>(points, X, h);
  std::vector<double> weights(near.column.size() * D);
  std::visit(
      [&](const auto& family) {
        for (Index s = 0; s < points.rows(); ++s) {
          if (order > 1) {
            fit_row<D>(family, near, points, X, s, h, order, weights);
            continue;
          }
          // Centred on the weighted mean, the fit of c + g·(X − X̄) decouples: g = M⁻¹ Σ w (X − X̄)
          // f.
          double sum = 0.0;
          Vector<D> mean = Vector<D>::Zero();
          for_row<D>(near, points, X, s, [&](Index, Index, const Vector<D>& difference) {
            const double w = kernel_value<D>(family, difference.norm(), h);
            sum += w;
            mean -= w * difference;
          });
          mean /= sum;
          Tensor<D> moment = Tensor<D>::Zero();
          for_row<D>(near, points, X, s, [&](Index, Index, const Vector<D>& difference) {
            const double w = kernel_value<D>(family, difference.norm(), h) / sum;
            const Vector<D> arm = -difference - mean;
            moment += w * arm * arm.transpose();
          });
          const auto row = static_cast<std::size_t>(s);
          const Tensor<D> inverse = inverse_moment<D>(moment, h * h, position<D>(points, s),
                                                      near.start[row + 1] - near.start[row], h);
          for_row<D>(near, points, X, s, [&](Index k, Index, const Vector<D>& difference) {
            const double w = kernel_value<D>(family, difference.norm(), h) / sum;
            const Vector<D> weight = w * inverse * (-difference - mean);
            store<D>(weights, k, weight);
          });
        }
      },
      kernel);
  return VectorOperator<D>(points.rows(), X.rows(), std::move(near), std::move(weights));
}

#define TLSPH_INSTANTIATE(D)                                                                    \
  template SparseMatrix kernel_matrix<D>(const AnyKernel&, double, const VectorField<D>&,       \
                                         const ScalarField&);                                   \
  template VectorOperator<D> plain_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const ScalarField&);                             \
  template VectorOperator<D> collocated_gradient<D>(                                            \
      const AnyKernel&, double, const VectorField<D>&, const ScalarField&, Correction);         \
  template VectorOperator<D> point_gradient<D>(const AnyKernel&, double, const VectorField<D>&, \
                                               const VectorField<D>&, int);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
