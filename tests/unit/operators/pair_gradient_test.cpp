/// The gradient of pair errors is determined, and of bounded size, on any nodes of a plane.

#include "tlsph/operators/stabilisers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/operators/gradients.hpp"

namespace tlsph {
namespace {

constexpr double lattice_spacing = 0.05;

using Points = std::vector<Vector<2>>;

VectorField<2> field_of(const Points& points) {
  VectorField<2> X(static_cast<Index>(points.size()), 2);
  for (std::size_t q = 0; q < points.size(); ++q)
    X.row(static_cast<Index>(q)) = points[q].transpose();
  return X;
}

VectorField<2> lattice(int columns, int rows) {
  Points points;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      points.emplace_back(0.3 + lattice_spacing * i, -0.1 + lattice_spacing * j);
  return field_of(points);
}

ScalarField volumes(const VectorField<2>& X) {
  return ScalarField::Constant(X.rows(), lattice_spacing * lattice_spacing);
}

/// Σ_q |G_pq| Δ, the largest of all rows.
double largest_size(const VectorOperator<2>& G) {
  double largest = 0.0;
  for (Index p = 0; p < G.rows(); ++p) {
    double size = 0.0;
    for (Index k = G.pattern().start[static_cast<std::size_t>(p)];
         k < G.pattern().start[static_cast<std::size_t>(p) + 1]; ++k)
      size += std::hypot(G.weight(k, 0), G.weight(k, 1));
    largest = std::max(largest, size * lattice_spacing);
  }
  return largest;
}

/// Largest error of the gradient of x², x y and y² at nodes, over the length of X − c, c the node.
double error_of_quadratics(const VectorOperator<2>& G, const VectorField<2>& X) {
  double worst = 0.0;
  for (const auto& [a, b] : {std::pair{0, 0}, {0, 1}, {1, 1}}) {
    VectorField<2> f = VectorField<2>::Zero(X.rows(), 2);
    f.col(0) = X.col(a).cwiseProduct(X.col(b));
    TensorField<2> H(X.rows(), 4);
    G.gradient(f, H);
    for (Index p = 0; p < X.rows(); ++p) {
      Vector<2> exact = Vector<2>::Zero();
      exact[a] += X(p, b);
      exact[b] += X(p, a);
      worst = std::max(worst, (Vector<2>(H(p, 0), H(p, 1)) - exact).norm());
    }
  }
  return worst;
}

/// Where the neighbourhood of 1.515 spacings does, its kernel gradient is taken as it is.
TEST(PairGradient, OfALatticeIsTheNarrowKernelGradient) {
  const VectorField<2> X = lattice(9, 6);
  const auto expected = collocated_gradient<2>(WendlandC2{}, 1.515 * lattice_spacing, X, volumes(X),
                                               Correction::gradient);

  const auto linear = pair_gradient<2>(X, volumes(X), lattice_spacing, 1);
  const auto quadratic = pair_gradient<2>(X, volumes(X), lattice_spacing, 2);

  ASSERT_EQ(linear.pattern().column, expected.pattern().column);
  for (std::size_t k = 0; k < expected.weights().size(); ++k)
    EXPECT_EQ(linear.weights()[k], expected.weights()[k]);
  const auto row = [](const VectorOperator<2>& G, Index p) {
    const auto start = 2 * G.pattern().start[static_cast<std::size_t>(p)];
    const auto end = 2 * G.pattern().start[static_cast<std::size_t>(p) + 1];
    return std::vector<double>(G.weights().begin() + start, G.weights().begin() + end);
  };
  for (int j = 1; j < 5; ++j)
    for (int i = 1; i < 8; ++i) EXPECT_EQ(row(quadratic, 9 * j + i), row(expected, 9 * j + i));
}

/// Random nodes between the edges of a wedge, divided evenly, no two nearer than `nearest`.
VectorField<2> wedge(double angle, double nearest, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Vector<2> side(std::cos(angle), std::sin(angle));
  Points points;
  const int edge = static_cast<int>(1.0 / lattice_spacing);
  for (int k = 0; k <= edge; ++k) {
    points.emplace_back(k * lattice_spacing, 0.0);
    if (k > 0) points.emplace_back(k * lattice_spacing * side);
  }
  const auto own = points.size();
  for (int tries = 0; tries < 4000; ++tries) {
    const double r = std::sqrt(uniform(generator)), t = angle * uniform(generator);
    const Vector<2> X(r * std::cos(t), r * std::sin(t));
    const bool edges =
        X.y() < 0.5 * lattice_spacing || (X - X.dot(side) * side).norm() < 0.5 * lattice_spacing;
    if (!edges && std::ranges::all_of(points, [&](const Vector<2>& other) {
          return (other - X).norm() >= nearest;
        }))
      points.push_back(X);
  }
  EXPECT_GT(points.size(), own);
  return field_of(points);
}

/// A sheet whose nodes are moved at random by up to `jitter` spacings, cut by a round hole.
VectorField<2> sheet(double jitter, double radius, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(-jitter, jitter);
  Points points;
  for (int j = 0; j <= 16; ++j)
    for (int i = 0; i <= 16; ++i) {
      Vector<2> X(lattice_spacing * i, lattice_spacing * j);
      if (X.norm() < radius - 0.5 * lattice_spacing) continue;
      if (X.norm() < radius + 0.5 * lattice_spacing)
        X *= radius / X.norm();
      else if (i % 16 != 0 && j % 16 != 0)
        X += lattice_spacing * Vector<2>(uniform(generator), uniform(generator));
      points.push_back(X);
    }
  return field_of(points);
}

/// TLSPH_CLOUDS sets how many sets of nodes are drawn; 60 take a second.
TEST(PairGradient, IsExactAndBoundedOnAnyNodes) {
  const char* wanted = std::getenv("TLSPH_CLOUDS");
  const int count = wanted != nullptr ? std::atoi(wanted) : 60;
  std::mt19937_64 generator(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int k = 0; k < count; ++k) {
    const double angle = (20.0 + 70.0 * uniform(generator)) * std::numbers::pi / 180.0;
    const VectorField<2> X =
        k % 2 == 0 ? wedge(angle, (0.5 + 0.4 * uniform(generator)) * lattice_spacing, generator)
                   : sheet(0.3 * uniform(generator), 0.1 + 0.5 * uniform(generator), generator);
    SCOPED_TRACE("set " + std::to_string(k) + ", " + std::to_string(X.rows()) + " nodes");
    for (const int degree : {1, 2}) {
      const auto G = pair_gradient<2>(X, volumes(X), lattice_spacing, degree);

      EXPECT_LE(largest_size(G), degree == 1 ? 5.0 : 9.0) << "degree " << degree;
      TensorField<2> H(X.rows(), 4);
      G.gradient(X, H);
      for (Index p = 0; p < X.rows(); ++p)
        EXPECT_LE((tensor_at<2>(H, p) - Tensor<2>::Identity()).cwiseAbs().maxCoeff(), 1e-11);
      // In the tip of a wedge all nodes stand on its two edges, which are a curve of degree two.
      if (degree > 1 && k % 2 == 1) {
        EXPECT_LE(error_of_quadratics(G, X), 1e-11);
      }
    }
  }
}

TEST(PairGradient, OfTwoRowsIsLinear) {
  const VectorField<2> X = lattice(20, 2);

  const auto G = pair_gradient<2>(X, volumes(X), lattice_spacing, 2);

  EXPECT_LE(largest_size(G), 9.0);
  TensorField<2> H(X.rows(), 4);
  G.gradient(X, H);
  for (Index p = 0; p < X.rows(); ++p)
    EXPECT_LE((tensor_at<2>(H, p) - Tensor<2>::Identity()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(PairGradient, RefusesNodesOnALine) {
  const VectorField<2> X = lattice(20, 1);

  EXPECT_THROW((void)pair_gradient<2>(X, volumes(X), lattice_spacing, 1), InputError);
}

}  // namespace
}  // namespace tlsph
