#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/points.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

/// A trapezium: 4 m below, 2 m above, 3 m high.
VectorField<2> trapezium() {
  return (VectorField<2>(4, 2) << 0, 0, 4, 0, 3, 3, 1, 3).finished();
}
constexpr Cell<2> all_four = {0, 1, 2, 3};

TEST(Cells, MeasuresOfATrapezium) {
  EXPECT_DOUBLE_EQ(cell_volume<2>(trapezium(), all_four), 9.0);
  EXPECT_DOUBLE_EQ(least_jacobian<2>(trapezium(), all_four), 6.0);  // at the upper corners
  EXPECT_EQ(cell_centre<2>(trapezium(), all_four), Vector<2>(2, 1.5));
}

TEST(Cells, LeastJacobianSeesALostShape) {
  VectorField<2> X = trapezium();
  X.row(2) << 1, 1;  // inside the triangle of the others
  EXPECT_LT(least_jacobian<2>(X, all_four), 0.0);
  EXPECT_GT(cell_volume<2>(X, all_four), 0.0);
}

TEST(Cells, NodeVolumesOfATrapezium) {
  // Centre (2, 1.5), middles (2, 0), (3.5, 1.5), (2, 3), (0.5, 1.5): below the middle line each
  // half has (2 + 1.5)/2 · 1.5, above it (1.5 + 1)/2 · 1.5.
  const ScalarField V = node_volumes<2>(trapezium(), {all_four});
  EXPECT_DOUBLE_EQ(V(0), 2.625);
  EXPECT_DOUBLE_EQ(V(1), 2.625);
  EXPECT_DOUBLE_EQ(V(2), 1.875);
  EXPECT_DOUBLE_EQ(V(3), 1.875);
}

TEST(Cells, NodeVolumesOfUnequalIntervals) {
  const VectorField<1> X = (VectorField<1>(3, 1) << 0, 1, 3).finished();
  const ScalarField V = node_volumes<1>(X, {{0, 1}, {1, 2}});
  EXPECT_EQ(V, (ScalarField(3) << 0.5, 1.5, 1.0).finished());
}

TEST(Points, LieInTheMiddleOfTheCells) {
  const auto bar = cell_points(make_lattice(make_interval(0.0, 2.0), 1.0));
  EXPECT_EQ(bar.X, (VectorField<1>(2, 1) << 0.5, 1.5).finished());
  EXPECT_EQ(bar.V, (ScalarField(2) << 1, 1).finished());
  const auto plate = cell_points(make_lattice(make_box<2>({0, 0}, {1, 2}), 1.0));
  EXPECT_EQ(plate.X, (VectorField<2>(2, 2) << 0.5, 0.5, 0.5, 1.5).finished());
  EXPECT_EQ(plate.V, (ScalarField(2) << 1, 1).finished());
}

TEST(Points, OfCollocatedBodiesAreTheNodes) {
  const auto body = make_lattice(make_disc({0, 0}, 1.0), 0.25);
  const auto points = node_points(body);
  EXPECT_EQ(points.X, body.X);
  EXPECT_EQ(points.V, body.V);
}

TEST(Points, NeedCells) {
  const auto centred = make_lattice(make_interval(0, 1), 0.5, NodePlacement::cell_centred);
  EXPECT_THAT(refusal([&] { (void)cell_points(centred); }), testing::HasSubstr("on-boundary"));
}

}  // namespace
}  // namespace tlsph
