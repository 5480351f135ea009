/// The consistency correction: constraints met to rounding, as small a change as possible.

#include "tlsph/operators/consistency.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/moments.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

constexpr double node_spacing = 0.1;

Particles<1> bar(std::uint64_t seed) {
  return jittered<1>(
      make_lattice<1>(make_interval(0.0, 3.0), node_spacing, NodePlacement::on_boundary), 0.2,
      seed);
}
Particles<2> square(std::uint64_t seed) {
  const Shape<2> shape = make_box<2>({0.0, 0.0}, {1.2, 1.0});
  return jittered<2>(make_lattice<2>(shape, node_spacing, NodePlacement::on_boundary), 0.2, seed);
}
Shape<2> ring_shape() {
  return make_difference(make_disc({0.0, 0.0}, 1.0), {make_disc({0.2, 0.1}, 0.3)});
}
Particles<2> ring(std::uint64_t seed) {
  const Shape<2> shape = ring_shape();
  return jittered<2>(
      fitted(make_lattice<2>(shape, node_spacing, NodePlacement::on_boundary), shape), 0.2, seed);
}

template <int D>
VectorOperator<D> plain(const Particles<D>& body, double support, int order) {
  return point_gradient<D>(WendlandC2{}, support * node_spacing, body.X, body.X, order);
}

/// f at the nodes that a stress of one constant, or linear, component makes, beside what it should.
template <int D>
double false_force(const VectorOperator<D>& gradient, const Particles<D>& body, bool linear) {
  const auto divergence = gradient.negative_adjoint(body.V);
  double worst = 0.0;
  for (int a = 0; a < D; ++a) {
    TensorField<D> P = TensorField<D>::Zero(body.size(), D * D);
    VectorField<D> expected = VectorField<D>::Zero(body.size(), D);
    for (Index q = 0; q < body.size(); ++q) {
      const double value = linear ? body.X(q, a) : 1.0;
      P(q, a) = value;  // P_xa
      expected(q, 0) = -value * body.B(q, a) + (linear ? body.V[q] : 0.0);
    }
    VectorField<D> f(body.size(), D);
    divergence.divergence(P, f);
    worst = std::max(worst, (f - expected).cwiseAbs().maxCoeff());
  }
  return worst / std::pow(node_spacing, D - 1);
}

/// What is left of the constraints, worked out from their text in consistency.hpp.
template <int D>
double largest_residual(const VectorOperator<D>& gradient, const MaterialPoints<D>& points,
                        const Particles<D>& body, ConsistencyDegrees degrees) {
  const auto slope_at_zero = [](const std::array<int, D>& exponents, int a) {
    std::array<int, D> linear{};
    linear[static_cast<std::size_t>(a)] = 1;
    return exponents == linear ? 1.0 : 0.0;
  };
  const auto row_exponents = monomials<D>(degrees.rows), columns = monomials<D>(degrees.columns);
  const double unit = std::pow(node_spacing, D);
  double worst = 0.0;
  for (int a = 0; a < D; ++a) {
    Eigen::MatrixXd row = Eigen::MatrixXd::Zero(gradient.rows(), Index(row_exponents.size()));
    Eigen::MatrixXd column = Eigen::MatrixXd::Zero(gradient.cols(), Index(columns.size()));
    for (Index s = 0; s < gradient.rows(); ++s)
      for (const Index k : gradient.pattern().entries(s)) {
        const int q = gradient.pattern().column_at(k);
        const Vector<D> arm = (body.X.row(q) - points.X.row(s)).transpose() / node_spacing;
        const double weight = node_spacing * gradient.weight(k, a);
        row.row(s) += weight * monomial_values<D>(row_exponents, arm);
        column.row(q) += points.V[s] / unit * weight * monomial_values<D>(columns, Vector<D>(-arm));
      }
    for (Index j = 0; j < row.cols(); ++j)
      row.col(j).array() -= slope_at_zero(row_exponents[std::size_t(j)], a);
    for (Index j = 0; j < column.cols(); ++j)
      column.col(j) += slope_at_zero(columns[std::size_t(j)], a) / unit * body.V;
    column.col(0) -= body.B.col(a) / std::pow(node_spacing, D - 1);
    worst = std::max({worst, row.cwiseAbs().maxCoeff(), column.cwiseAbs().maxCoeff()});
  }
  return worst;
}

struct Problem {
  const char* name;
  double support;
  int order;
  ConsistencyDegrees degrees;
};
void PrintTo(const Problem& problem, std::ostream* out) {
  *out << problem.name;
}

class Consistency : public testing::TestWithParam<Problem> {
 protected:
  template <int D>
  void check(Particles<D> body, const Shape<D>* shape = nullptr) {
    const auto& [name, support, order, degrees] = GetParam();
    body = with_exact_moments<D>(
        std::move(body), {degrees.rows + degrees.columns - 1, degrees.rows + degrees.columns},
        shape);
    const MaterialPoints<D> points{body.X, body.V};
    const VectorOperator<D> before = plain<D>(body, support, order);

    const auto [gradient, residuals] = consistent_gradient<D>(before, points, body, degrees);

    EXPECT_LE(residuals.row, 1e-12);
    EXPECT_LE(residuals.column, 1e-12);
    EXPECT_LE(largest_residual<D>(gradient, points, body, degrees), 1e-12);
    EXPECT_EQ(gradient.pattern().column, before.pattern().column) << "no entry is added";
    EXPECT_GE(false_force<D>(before, body, false), 1e-3);
    EXPECT_LE(false_force<D>(gradient, body, false), 1e-12) << "constant stress";
    if (degrees.columns > 0) {
      EXPECT_LE(false_force<D>(gradient, body, true), 1e-12) << "linear";
    }
  }
};

TEST_P(Consistency, MakesRowsAndAdjointExactIn2D) {
  check<2>(square(1));
  check<2>(square(2));
}

TEST_P(Consistency, HoldsRoundAHoleAndOnACurve) {
  const Shape<2> shape = ring_shape();
  check<2>(ring(1), &shape);
}

TEST_P(Consistency, MakesRowsAndAdjointExactIn1D) {
  if (GetParam().order > 1) GTEST_SKIP() << "degrees (2, 1) leave a bar too little freedom";
  check<1>(bar(1));
  check<1>(bar(2));
}

INSTANTIATE_TEST_SUITE_P(Degrees, Consistency,
                         testing::Values(Problem{"one_zero", 2.6, 1, {1, 0}},
                                         Problem{"one_one", 3.1, 1, {1, 1}},
                                         Problem{"two_one", 3.6, 2, {2, 1}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(ConsistentGradient, DifferentiatesQuadraticsWhereItsRowsAreOfDegreeTwo) {
  const Particles<2> body = with_exact_moments<2>(square(3), {2, 3});
  const auto [gradient, residuals] =
      consistent_gradient<2>(plain<2>(body, 3.6, 2), {body.X, body.V}, body, {2, 1});
  VectorField<2> u(body.size(), 2);
  for (Index q = 0; q < body.size(); ++q) {
    const double x = body.X(q, 0);
    const double y = body.X(q, 1);
    u.row(q) << x * x - 3 * x * y, 2 * y * y + x;
  }

  TensorField<2> H(body.size(), 4);
  gradient.gradient(u, H);

  for (Index q = 0; q < body.size(); ++q) {
    const double x = body.X(q, 0);
    const double y = body.X(q, 1);
    EXPECT_NEAR(H(q, 0), 2 * x - 3 * y, 1e-11);
    EXPECT_NEAR(H(q, 1), -3 * x, 1e-11);
    EXPECT_NEAR(H(q, 2), 1.0, 1e-11);
    EXPECT_NEAR(H(q, 3), 4 * y, 1e-11);
  }
}

TEST(ConsistentGradient, LeavesAloneWhatIsConsistent) {
  const Particles<2> body = square(4);
  const MaterialPoints<2> points = cell_points<2>(body);
  const VectorOperator<2> cells = cell_gradient<2>(body, points);

  const auto [gradient, residuals] = consistent_gradient<2>(cells, points, body, {1, 0});

  EXPECT_LE(residuals.change, 1e-12);
}

TEST(ConsistentGradient, RefusesAQuadratureThatContradictsIt) {
  const Particles<2> body = square(5);  // volumes exact to degree zero only

  try {
    static_cast<void>(
        consistent_gradient<2>(plain<2>(body, 2.6, 1), {body.X, body.V}, body, {1, 1}));
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("degrees (1, 1)"), std::string::npos);
  }
}

}  // namespace
}  // namespace tlsph
