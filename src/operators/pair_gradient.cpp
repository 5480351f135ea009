#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>
#include <numeric>
#include <utility>

#include "support.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/operators/stabilisers.hpp"

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

/// Whether a row differentiates the monomials up to that degree exactly.
template <int D>
bool is_exact(const Support<D>& support, const std::vector<Vector<D>>& weights, double spacing,
              int degree) {
  const Index terms = degree > 1 ? Support<D>::terms : 1 + D;
  const auto values = support.quadratics(spacing);
  Eigen::MatrixXd error = Eigen::MatrixXd::Zero(D, terms);
  for (int a = 0; a < D; ++a) error(a, 1 + a) = -1.0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    error += spacing * weights[k] * values.col(static_cast<Index>(k)).head(terms).transpose();
  return error.cwiseAbs().maxCoeff() <= exact;
}

/// The row with minus the sum of the others as the weight of the node itself, and its size.
template <int D>
Row<D> closed(const Support<D>& support, std::vector<Vector<D>> weights, Index p, double spacing,
              int degree) {
  const double size = support.close(weights, p);
  const bool good = is_exact<D>(support, weights, spacing, degree);
  return {{support.nodes.begin(), support.nodes.end()}, std::move(weights), good ? size : none};
}

/// V_q L ∇W, L = (Σ V ∇W ⊗ (X_q − X_p))⁻¹: exact for linear fields.
template <int D>
std::vector<Vector<D>> linear(const Support<D>& support, const ScalarField& V) {
  std::vector<Vector<D>> weights;
  for (std::size_t k = 0; k < support.nodes.size(); ++k)
    weights.push_back(support.pull(k) * -support.arm[k]);
  support.weigh(weights, support.moment(weights, V).inverse(), V);
  return weights;
}

/// The first derivatives of the polynomial of degree two fitted with the weights V W.
template <int D>
std::vector<Vector<D>> quadratic(const Support<D>& support, const ScalarField& V) {
  constexpr int terms = Support<D>::terms;
  const Index count = support.size();
  const Eigen::Matrix<double, Eigen::Dynamic, terms> f = support.quadratics(support.h).transpose();
  Eigen::VectorXd w(count);
  for (Index k = 0; k < count; ++k)
    w[k] = V[support.nodes[static_cast<std::size_t>(k)]] * support.value[k];
  const Eigen::LDLT<typename Support<D>::Moment> moment(f.transpose() * w.asDiagonal() * f);
  Eigen::Matrix<double, terms, D> derivatives = Eigen::Matrix<double, terms, D>::Zero();
  for (int a = 0; a < D; ++a) derivatives(1 + a, a) = 1.0 / support.h;
  Eigen::Matrix<double, Eigen::Dynamic, D> fitted = VectorField<D>::Zero(count, D);
  for (int pass = 0; pass < 2; ++pass)  // the second takes out the round-off of the first
    fitted += w.asDiagonal() * f * moment.solve(derivatives - f.transpose() * fitted);
  std::vector<Vector<D>> weights;
  for (Index k = 0; k < count; ++k) weights.emplace_back(fitted.row(k).transpose());
  return weights;
}

}  // namespace

template <int D>
VectorOperator<D> pair_gradient(const VectorField<D>& X, const ScalarField& V, double spacing,
                                int degree) {
  const AnyKernel kernel = WendlandC2{};
  const double largest = (degree > 1 ? largest_quadratic : largest_linear) / spacing;
  std::vector<Row<D>> rows(static_cast<std::size_t>(X.rows()));
  std::vector<Index> open(rows.size());
  std::iota(open.begin(), open.end(), Index{0});
  for (double width = narrowest; !open.empty(); width *= ratio) {
    const double h = width * spacing;
    const Neighbours near = find_neighbours<D>(X(open, Eigen::all), X, h);
    std::vector<Index> left;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const Index p = open[k];
      const Support<D> support(kernel, h, X.row(p).transpose(), near.of(static_cast<Index>(k)), X);
      Row<D> row = closed<D>(support, linear<D>(support, V), p, spacing, 1);
      // Nodes that do not determine a polynomial of degree two at any support determine a plane.
      if (degree > 1 && width <= widest &&
          !(row.size <= largest && is_exact<D>(support, row.weights, spacing, 2)))
        row = closed<D>(support, quadratic<D>(support, V), p, spacing, 2);
      Row<D>& best = rows[static_cast<std::size_t>(p)];
      if (best.nodes.empty() || row.size < best.size) best = std::move(row);
      if (best.size <= largest || (width > widest && best.size < none)) continue;
      if (support.size() == X.rows() && width > widest)
        throw InputError(
            "stabiliser.kind: the particles stand on a line, where no gradient across it is "
            "determined; choose a thicker body or a finer spacing");
      left.push_back(p);
    }
    open = std::move(left);
  }
  OperatorRows operators;
  for (const Row<D>& row : rows)
    operators.add_row(row.nodes, {row.weights.front().data(), row.weights.size() * D});
  return VectorOperator<D>(std::move(operators), X.rows());
}

#define TLSPH_INSTANTIATE(D)                                                                     \
  template VectorOperator<D> pair_gradient<D>(const VectorField<D>&, const ScalarField&, double, \
                                              int);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph
