#pragma once
/// \file
/// The constraints behind operators/consistency.hpp, on the entries of one direction of a gradient.

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <vector>

#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/consistency.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {

inline double binomial(int n, int k) {
  double result = 1.0;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

/// x^exponents.
template <int D>
double power(const Vector<D>& x, const std::array<int, D>& exponents) {
  return monomial_values<D>({exponents}, x)[0];
}

/// All constraints on the entries of one direction, in units of Δ: the polynomials of each entry,
/// and how constraints number. Rows come first: s·m_r + j, then M·m_r + q·m_c + j.
template <int D>
class ConsistencyConstraints {
 public:
  ConsistencyConstraints(const VectorOperator<D>& gradient, const MaterialPoints<D>& points,
                         const Particles<D>& particles, ConsistencyDegrees degrees)
      : pattern_(gradient.pattern()),
        spacing_(particles.spacing),
        row_exponents_(monomials<D>(degrees.rows)),
        column_exponents_(monomials<D>(degrees.columns)),
        mr_(static_cast<Index>(row_exponents_.size())),
        mc_(static_cast<Index>(column_exponents_.size())),
        rows_(gradient.rows()),
        cols_(gradient.cols()),
        by_node_(by_columns(pattern_, cols_)) {
    row_value_.resize(static_cast<std::size_t>(pattern_.size() * mr_));
    column_value_.resize(static_cast<std::size_t>(pattern_.size() * mc_));
    const double unit = std::pow(spacing_, D);
    for_rows(rows_, [&](Index s) {
      for (const Index k : pattern_.entries(s)) {
        const Vector<D> arm = (particles.X.row(column(k)) - points.X.row(s)).transpose() / spacing_;
        Eigen::Map<Eigen::VectorXd>(row_value_.data() + k * mr_, mr_) =
            monomial_values<D>(row_exponents_, arm);
        Eigen::Map<Eigen::VectorXd>(column_value_.data() + k * mc_, mc_) =
            points.V[s] / unit * monomial_values<D>(column_exponents_, Vector<D>(-arm));
      }
    });
    targets(particles);
  }

  [[nodiscard]] Index size() const { return rows_ * mr_ + cols_ * mc_; }
  [[nodiscard]] Index row_size() const { return rows_ * mr_; }
  [[nodiscard]] Index entries() const { return pattern_.size(); }

  /// Combinations of constraints that vanish identically.
  [[nodiscard]] Index dependence_count() const { return mr_ * mc_; }
  /// Bytes of the polynomials and of the pattern by nodes.
  [[nodiscard]] double bytes() const {
    return 8.0 * static_cast<double>(entries() * (mr_ + mc_ + 2) + size());
  }

  /// target − A g for direction a, g in units of 1/Δ.
  [[nodiscard]] Eigen::VectorXd residual(const Eigen::VectorXd& g, int a) const {
    Eigen::VectorXd left(size());
    for_rows(rows_, [&](Index s) {
      for (Index j = 0; j < mr_; ++j) {
        double sum = is_first(row_exponents_[static_cast<std::size_t>(j)], a) ? 1.0 : 0.0;
        for (const Index k : pattern_.entries(s)) sum -= row_polynomial(k)[j] * g[k];
        left[s * mr_ + j] = sum;
      }
    });
    for_rows(cols_, [&](Index q) {
      for (Index j = 0; j < mc_; ++j) {
        double sum = column_target_(q * mc_ + j, a);
        for (const Index t : by_node_.rows.entries(q))
          sum -= column_polynomial(entry(t))[j] * g[entry(t)];
        left[row_size() + q * mc_ + j] = sum;
      }
    });
    return left;
  }

  /// w Aᵀ λ.
  [[nodiscard]] Eigen::VectorXd change(const Eigen::VectorXd& lambda,
                                       const Eigen::VectorXd& weight) const {
    Eigen::VectorXd delta(entries());
    for_rows(rows_, [&](Index s) {
      for (const Index k : pattern_.entries(s)) {
        double sum = 0.0;
        for (Index j = 0; j < mr_; ++j) sum += row_polynomial(k)[j] * lambda[s * mr_ + j];
        const Index first = row_size() + column(k) * mc_;
        for (Index j = 0; j < mc_; ++j) sum += column_polynomial(k)[j] * lambda[first + j];
        delta[k] = weight[k] * sum;
      }
    });
    return delta;
  }

  /// Orthonormal combinations of constraints that vanish on every δ, one a column. For polynomials
  /// m and p of degrees k_c and k_r the rows at s, expanded for V_s m(X_s) p, and the columns at q,
  /// expanded for −p(X_q) m, are the same sum: integration by parts over the body.
  [[nodiscard]] Eigen::MatrixXd dependences(const MaterialPoints<D>& points,
                                            const Particles<D>& particles) const {
    const Vector<D> lower = particles.X.colwise().minCoeff().transpose();
    const Vector<D> upper = particles.X.colwise().maxCoeff().transpose();
    const Vector<D> middle = 0.5 * (lower + upper);
    const double length = 0.5 * (upper - lower).maxCoeff();
    Eigen::MatrixXd all(size(), mr_ * mc_);
    for (Index i = 0; i < mr_; ++i)
      for (Index j = 0; j < mc_; ++j) {
        const auto& p = row_exponents_[static_cast<std::size_t>(i)];
        const auto& m = column_exponents_[static_cast<std::size_t>(j)];
        const Index vector = i * mc_ + j;
        for (Index s = 0; s < rows_; ++s) {
          const Vector<D> at = (points.X.row(s).transpose() - middle) / length;
          const double scale = points.V[s] / std::pow(spacing_, D) * power<D>(at, m);
          all.col(vector).segment(s * mr_, mr_) =
              scale * shifted(row_exponents_, p, at, spacing_ / length);
        }
        for (Index q = 0; q < cols_; ++q) {
          const Vector<D> at = (particles.X.row(q).transpose() - middle) / length;
          all.col(vector).segment(row_size() + q * mc_, mc_) =
              -power<D>(at, p) * shifted(column_exponents_, m, at, spacing_ / length);
        }
      }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(all);
    return qr.householderQ() * Eigen::MatrixXd::Identity(size(), all.cols());
  }

  /// √w Aᵀ and below it a row e_cᵀ for each of the constraints c.
  [[nodiscard]] SparseMatrix root(const Eigen::VectorXd& w,
                                  const std::vector<Index>& constraints) const {
    SparseMatrix B(entries() + static_cast<Index>(constraints.size()), size());
    B.reserve(Eigen::VectorXi::Constant(B.rows(), static_cast<int>(mr_ + mc_)));
    for_rows(rows_, [&](Index s) {
      for (const Index k : pattern_.entries(s)) {
        for (Index j = 0; j < mr_; ++j)
          B.insert(k, s * mr_ + j) = std::sqrt(w[k]) * row_polynomial(k)[j];
        for (Index j = 0; j < mc_; ++j)
          B.insert(k, row_size() + column(k) * mc_ + j) = std::sqrt(w[k]) * column_polynomial(k)[j];
      }
    });
    for (std::size_t i = 0; i < constraints.size(); ++i)
      B.insert(entries() + static_cast<Index>(i), constraints[i]) = 1.0;
    B.makeCompressed();
    return B;
  }

  /// The lower triangle of A w Aᵀ; its pattern does not depend on the weights.
  [[nodiscard]] SparseMatrix normal(const Eigen::VectorXd& weight) const {
    SparseMatrix S(size(), size());
    const Index in_rows = rows_ * mr_ * (mr_ + 1) / 2;
    const Index in_columns = cols_ * mc_ * (mc_ + 1) / 2;
    S.resizeNonZeros(in_rows + in_columns + entries() * mr_ * mc_);
    int* start = S.outerIndexPtr();
    start[0] = 0;
    for (Index s = 0; s < rows_; ++s)
      for (Index j = 0; j < mr_; ++j)
        start[s * mr_ + j + 1] = start[s * mr_ + j] + static_cast<int>(j + 1);
    for (Index q = 0; q < cols_; ++q)
      for (Index j = 0; j < mc_; ++j) {
        const Index row = row_size() + q * mc_ + j;
        const auto points = static_cast<Index>(by_node_.rows.of(q).size());
        start[row + 1] = start[row] + static_cast<int>(points * mr_ + j + 1);
      }
    int* index = S.innerIndexPtr();
    double* value = S.valuePtr();
    for_rows(rows_, [&](Index s) {
      for (Index j = 0; j < mr_; ++j)
        for (Index i = 0; i <= j; ++i) {
          double sum = 0.0;
          for (const Index k : pattern_.entries(s))
            sum += weight[k] * row_polynomial(k)[i] * row_polynomial(k)[j];
          const Index slot = start[s * mr_ + j] + i;
          index[slot] = static_cast<int>(s * mr_ + i);
          value[slot] = sum;
        }
    });
    for_rows(cols_, [&](Index q) {
      for (Index j = 0; j < mc_; ++j) {
        Index slot = start[row_size() + q * mc_ + j];
        for (const Index t : by_node_.rows.entries(q)) {
          const Index k = entry(t);
          const double scale = weight[k] * column_polynomial(k)[j];
          for (Index i = 0; i < mr_; ++i, ++slot) {
            index[slot] = static_cast<int>(by_node_.rows.column_at(t) * mr_ + i);
            value[slot] = scale * row_polynomial(k)[i];
          }
        }
        for (Index i = 0; i <= j; ++i, ++slot) {
          double sum = 0.0;
          for (const Index t : by_node_.rows.entries(q)) {
            const Index k = entry(t);
            sum += weight[k] * column_polynomial(k)[i] * column_polynomial(k)[j];
          }
          index[slot] = static_cast<int>(row_size() + q * mc_ + i);
          value[slot] = sum;
        }
      }
    });
    return S;
  }

 private:
  [[nodiscard]] Index column(Index k) const { return pattern_.column_at(k); }
  /// Position in the pattern of the t-th entry by nodes.
  [[nodiscard]] Index entry(Index t) const { return by_node_.entry[static_cast<std::size_t>(t)]; }
  [[nodiscard]] const double* row_polynomial(Index k) const { return row_value_.data() + k * mr_; }
  [[nodiscard]] const double* column_polynomial(Index k) const {
    return column_value_.data() + k * mc_;
  }
  /// Coefficients in y of (at + scale y)^exponents.
  [[nodiscard]] static Eigen::VectorXd shifted(const std::vector<std::array<int, D>>& basis,
                                               const std::array<int, D>& exponents,
                                               const Vector<D>& at, double scale) {
    Eigen::VectorXd result(static_cast<Index>(basis.size()));
    for (Index j = 0; j < result.size(); ++j) {
      double product = 1.0;
      for (std::size_t b = 0; b < D; ++b) {
        const int power = basis[static_cast<std::size_t>(j)][b];
        const int rest = exponents[b] - power;
        if (rest < 0) {
          product = 0.0;
          break;
        }
        product *= binomial(exponents[b], power) * std::pow(at[static_cast<Index>(b)], rest) *
                   std::pow(scale, power);
      }
      result[j] = product;
    }
    return result;
  }

  /// Whether the monomial is x_a.
  [[nodiscard]] static bool is_first(const std::array<int, D>& exponents, int a) {
    for (std::size_t b = 0; b < D; ++b)
      if (exponents[b] != (static_cast<int>(b) == a ? 1 : 0)) return false;
    return true;
  }

  void targets(const Particles<D>& particles) {
    column_target_.setZero(cols_ * mc_, D);
    for (Index q = 0; q < cols_; ++q)
      for (int a = 0; a < D; ++a) {
        column_target_(q * mc_, a) = particles.B(q, a) / std::pow(spacing_, D - 1);
        for (Index j = 1; j < mc_; ++j)
          if (is_first(column_exponents_[static_cast<std::size_t>(j)], a))
            column_target_(q * mc_ + j, a) = -particles.V[q] / std::pow(spacing_, D);
      }
  }

  const Neighbours& pattern_;
  double spacing_;
  std::vector<std::array<int, D>> row_exponents_, column_exponents_;
  Index mr_, mc_, rows_, cols_;
  std::vector<double> row_value_, column_value_;
  ByColumns by_node_;
  Eigen::MatrixXd column_target_;  // (N·m_c)×d
};

}  // namespace tlsph
