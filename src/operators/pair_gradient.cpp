#include "tlsph/operators/pair_gradient.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/operators/neighbours.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

/// The first support, in spacings, reaches the diagonal neighbours of a lattice. The next ones are
/// wider by this ratio; beyond the widest the best row so far is taken.
constexpr double narrowest = 1.515, ratio = 1.15, widest = 4.0;
/// Largest size Σ_q |G_pq| Δ of a row, on which the critical step depends. In the corner of a
/// lattice it is 2 + √2 for differences of first order, 5 + 1.5 √2 for those of second order.
constexpr double largest_linear = 5.0, largest_quadratic = 9.0;
/// Error of a derivative, relative, below which a row counts as exact.
constexpr double exact = 1e-11;
constexpr double none = std::numeric_limits<double>::infinity();

/// The gradient at one node: the nodes around it, itself among them, and their weights.
template <int D>
struct Row {
  std::vector<int> nodes;
  std::vector<Vector<D>> weights;
  double size = none;  ///< Σ |weight| [1/m]; infinite without a gradient
};

/// The gradients at the nodes X (N×d) with volumes V (N) over the nodes within h [m].
template <int D>
class Fit {
 public:
  Fit(const VectorField<D>& X, const ScalarField& V, double spacing)
      : X_(X), V_(V), spacing_(spacing) {}

  /// V_q L ∇W, L = (Σ V ∇W ⊗ (X_q − X_p))⁻¹: exact for linear fields.
  [[nodiscard]] Row<D> linear(Index p, std::vector<int> nodes, double h) const {
    const auto slope = [&](int q) -> Vector<D> {
      const double r = arm(p, q).norm();
      if (r == 0.0) return Vector<D>::Zero();
      return kernel_first<D>(WendlandC2{}, r, h) / r * -arm(p, q);
    };
    Tensor<D> moment = Tensor<D>::Zero();
    for (const int q : nodes) moment += V_[q] * slope(q) * arm(p, q).transpose();
    const Tensor<D> L = moment.inverse();
    Row<D> row{std::move(nodes), {}};
    for (const int q : row.nodes) row.weights.push_back(V_[q] * L * slope(q));
    return closed(p, std::move(row), 1);
  }

  /// The first derivatives of the polynomial of degree two fitted with the weights V W.
  [[nodiscard]] Row<D> quadratic(Index p, std::vector<int> nodes, double h) const {
    constexpr int terms = (D + 1) * (D + 2) / 2;
    const auto count = static_cast<Index>(nodes.size());
    Eigen::Matrix<double, Eigen::Dynamic, terms> f(count, terms);
    Eigen::VectorXd w(count);
    for (Index k = 0; k < count; ++k) {
      const int q = nodes[static_cast<std::size_t>(k)];
      f.row(k) = monomial_values<D>(quadratics_, arm(p, q) / h).transpose();
      w[k] = V_[q] * kernel_value<D>(WendlandC2{}, arm(p, q).norm(), h);
    }
    const Eigen::LDLT<Eigen::Matrix<double, terms, terms>> moment(f.transpose() * w.asDiagonal() *
                                                                  f);
    Eigen::Matrix<double, terms, D> derivatives = Eigen::Matrix<double, terms, D>::Zero();
    for (int a = 0; a < D; ++a) derivatives(1 + a, a) = 1.0 / h;
    Eigen::Matrix<double, Eigen::Dynamic, D> weights = VectorField<D>::Zero(count, D);
    for (int pass = 0; pass < 2; ++pass)  // the second takes out the round-off of the first
      weights += w.asDiagonal() * f * moment.solve(derivatives - f.transpose() * weights);
    Row<D> row{std::move(nodes), {}};
    for (Index k = 0; k < count; ++k) row.weights.emplace_back(weights.row(k).transpose());
    return closed(p, std::move(row), 2);
  }

  /// Whether a row differentiates the monomials up to that degree exactly.
  [[nodiscard]] bool is_exact(Index p, const Row<D>& row, int degree) const {
    const auto terms = degree > 1 ? static_cast<Index>(quadratics_.size()) : 1 + D;
    Eigen::MatrixXd error = Eigen::MatrixXd::Zero(D, terms);
    for (int a = 0; a < D; ++a) error(a, 1 + a) = -1.0;
    for (std::size_t k = 0; k < row.nodes.size(); ++k)
      error +=
          spacing_ * row.weights[k] *
          monomial_values<D>(quadratics_, arm(p, row.nodes[k]) / spacing_).head(terms).transpose();
    return error.cwiseAbs().maxCoeff() <= exact;
  }

 private:
  [[nodiscard]] Vector<D> arm(Index p, int q) const { return (X_.row(q) - X_.row(p)).transpose(); }

  /// The row with minus the sum of the others as the weight of the node itself, and its size.
  [[nodiscard]] Row<D> closed(Index p, Row<D> row, int degree) const {
    Vector<D> others = Vector<D>::Zero();
    double size = 0.0;
    for (std::size_t k = 0; k < row.nodes.size(); ++k) {
      if (row.nodes[k] == p) continue;
      others += row.weights[k];
      size += row.weights[k].norm();
    }
    for (std::size_t k = 0; k < row.nodes.size(); ++k)
      if (row.nodes[k] == p) row.weights[k] = -others;
    if (is_exact(p, row, degree)) row.size = size + others.norm();
    return row;
  }

  const VectorField<D>& X_;
  const ScalarField& V_;
  double spacing_;
  std::vector<std::array<int, D>> quadratics_ = monomials<D>(2);
};

}  // namespace

template <int D>
VectorOperator<D> pair_gradient(const VectorField<D>& X, const ScalarField& V, double spacing,
                                int degree) {
  const Fit<D> fit(X, V, spacing);
  const double largest = (degree > 1 ? largest_quadratic : largest_linear) / spacing;
  std::vector<Row<D>> rows(static_cast<std::size_t>(X.rows()));
  std::vector<Index> open;
  for (Index p = 0; p < X.rows(); ++p) open.push_back(p);
  for (double support = narrowest; !open.empty(); support *= ratio) {
    const double h = support * spacing;
    VectorField<D> points(static_cast<Index>(open.size()), D);
    for (Index k = 0; k < points.rows(); ++k)
      points.row(k) = X.row(open[static_cast<std::size_t>(k)]);
    const Neighbours near = find_neighbours<D>(points, X, h);
    std::vector<Index> left;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Index p = open[k];
      const std::vector<int> nodes(near.column.begin() + near.start[k],
                                   near.column.begin() + near.start[k + 1]);
      Row<D> row = fit.linear(p, nodes, h);
      // Nodes that do not determine a polynomial of degree two at any support determine a plane.
      if (degree > 1 && support <= widest && !(row.size <= largest && fit.is_exact(p, row, 2)))
        row = fit.quadratic(p, nodes, h);
      Row<D>& best = rows[static_cast<std::size_t>(p)];
      if (best.nodes.empty() || row.size < best.size) best = std::move(row);
      if (best.size <= largest || (support > widest && best.size < none)) continue;
      if (static_cast<Index>(nodes.size()) == X.rows() && support > widest)
        throw InputError(
            "stabiliser.kind: the particles stand on a line, where no gradient across it is "
            "determined; choose a thicker body or a finer spacing");
      left.push_back(p);
    }
    open = std::move(left);
  }
  Neighbours pattern;
  pattern.start.push_back(0);
  std::vector<double> weights;
  for (const Row<D>& row : rows) {
    pattern.column.insert(pattern.column.end(), row.nodes.begin(), row.nodes.end());
    pattern.start.push_back(static_cast<Index>(pattern.column.size()));
    for (const Vector<D>& weight : row.weights)
      weights.insert(weights.end(), weight.data(), weight.data() + D);
  }
  return VectorOperator<D>(X.rows(), X.rows(), std::move(pattern), std::move(weights));
}

template VectorOperator<1> pair_gradient<1>(const VectorField<1>&, const ScalarField&, double, int);
template VectorOperator<2> pair_gradient<2>(const VectorField<2>&, const ScalarField&, double, int);

}  // namespace tlsph
