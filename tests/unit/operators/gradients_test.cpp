/// Gradients where a support of the usual size holds too few nodes.

#include "tlsph/operators/gradients.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

constexpr double mesh = 0.1;

/// A lattice of `columns` × `rows` nodes and a point that stands alone on its right, `gap` away.
VectorField<2> with_a_tip(Index columns, Index rows, double gap) {
  VectorField<2> X(columns * rows + 1, 2);
  for (Index i = 0; i < columns; ++i)
    for (Index j = 0; j < rows; ++j)
      X.row(i * rows + j) << mesh * static_cast<double>(i), mesh * static_cast<double>(j);
  X.row(columns * rows) << mesh * static_cast<double>(columns - 1) + gap,
      0.5 * mesh * static_cast<double>(rows - 1);
  return X;
}

/// (∂f/∂x, ∂f/∂y) of f = 1 + 2x − 3y + 4x² − 5xy + 6y².
Eigen::RowVector2d slope(double x, double y) {
  return {2 + 8 * x - 5 * y, -3 - 5 * x + 12 * y};
}

TEST(PointGradient, TakesMoreNodesWhereASupportHoldsTooFew) {
  const VectorField<2> X = with_a_tip(8, 5, 0.17);  // five nodes within 2.5 spacings of the tip
  const auto G = point_gradient<2>(WendlandC2{}, 2.5 * mesh, X, X, 2);

  VectorField<2> u(X.rows(), 2);
  for (Index q = 0; q < X.rows(); ++q) {
    const double x = X(q, 0), y = X(q, 1);
    u.row(q).setConstant(1 + 2 * x - 3 * y + 4 * x * x - 5 * x * y + 6 * y * y);
  }
  TensorField<2> H(X.rows(), 4);
  G.gradient(u, H);
  for (Index q = 0; q < X.rows(); ++q)
    EXPECT_LT((H.row(q).head(2) - slope(X(q, 0), X(q, 1))).cwiseAbs().maxCoeff(), 1e-9) << q;
}

TEST(PointGradient, RefusesABodyTooThinForItsDegree) {
  const VectorField<2> X = with_a_tip(20, 2, 0.1);
  EXPECT_THAT([&] { (void)point_gradient<2>(WendlandC2{}, 3.6 * mesh, X, X, 2); },
              testing::ThrowsMessage<InputError>(
                  testing::AllOf(testing::HasSubstr("do not determine a polynomial of degree 2"),
                                 testing::HasSubstr("a lower degree"))));
  EXPECT_NO_THROW((void)point_gradient<2>(WendlandC2{}, 3.6 * mesh, X, X, 1));
}

/// The refusal names how much larger a support must be, and that works.
TEST(CollocatedGradient, NamesASupportThatIsLargeEnough) {
  const VectorField<2> X = with_a_tip(8, 5, 0.2);
  const ScalarField V = ScalarField::Constant(X.rows(), mesh * mesh);
  const auto refusal = [&](double h) -> std::string {
    try {
      (void)collocated_gradient<2>(WendlandC2{}, h, X, V, Correction::gradient);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };

  const std::string message = refusal(2.1 * mesh);

  std::smatch factor;
  ASSERT_TRUE(std::regex_search(message, factor, std::regex("([0-9.]+) times as large")))
      << message;
  EXPECT_EQ(refusal(std::stod(factor[1]) * 2.1 * mesh), "");
}

}  // namespace
}  // namespace tlsph
