#include "tlsph/filling/jitter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/points.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

Shape<2> plate() {
  return make_difference(make_box<2>({0, 0}, {2, 1}), {make_disc({0, 0}, 0.4)});
}

TEST(Jitter, TheSameSeedGivesTheSameCloud) {
  const auto lattice = make_lattice(plate(), 0.1);
  const auto one = jittered(lattice, 0.2, 7), same = jittered(lattice, 0.2, 7);
  const auto other = jittered(lattice, 0.2, 8);
  EXPECT_EQ(one.X, same.X);
  EXPECT_EQ(one.V, same.V);
  EXPECT_GT((one.X - other.X).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Jitter, NumbersAreThoseOfTheStandardGenerator) {
  // The 10000th number of a default-seeded mt19937_64 is fixed by the C++ standard; the one inner
  // coordinate here takes the first one of the seed.
  const auto bar = jittered(make_lattice(make_interval(0, 2), 1.0), 0.25, 5489);
  std::mt19937_64 generator(5489);
  const double r = static_cast<double>(generator() >> 11) / 4503599627370496.0 - 1.0;
  EXPECT_DOUBLE_EQ(bar.X(1), 1.0 + 0.25 * r);
  EXPECT_DOUBLE_EQ(bar.V(0), bar.X(1) / 2.0);
  EXPECT_DOUBLE_EQ(bar.V(1), 1.0);
}

class Shares : public testing::TestWithParam<double> {};

TEST_P(Shares, MoveInnerNodesOnlyAndNeverFurther) {
  const double share = GetParam();
  const auto lattice = make_lattice(plate(), 0.05);
  const auto cloud = jittered(lattice, share, 1);
  const VectorField<2> moves = cloud.X - lattice.X;
  for (const int node : lattice.find("boundary")->nodes) EXPECT_EQ(moves.row(node).norm(), 0.0);
  EXPECT_LE(moves.cwiseAbs().maxCoeff(), share * 0.05 * (1 + 1e-12));
  EXPECT_GT(moves.cwiseAbs().maxCoeff(), 0.95 * share * 0.05);
  EXPECT_NEAR(moves.mean(), 0.0, 0.1 * share * 0.05);
}

TEST_P(Shares, KeepVolumesCellsAndFaces) {
  const auto lattice = make_lattice(plate(), 0.05);
  const auto cloud = jittered(lattice, GetParam(), 3);
  const double size = lattice.V.sum();
  EXPECT_NEAR(cloud.V.sum(), size, 1e-12 * size);
  EXPECT_NEAR(cell_points(cloud).V.sum(), size, 1e-12 * size);
  EXPECT_GT(cloud.V.minCoeff(), 0.0);
  for (const auto& cell : cloud.cells)
    EXPECT_GT(least_jacobian<2>(cloud.X, cell), 0.1 * 0.05 * 0.05);
  EXPECT_EQ(cloud.B, lattice.B);
}

INSTANTIATE_TEST_SUITE_P(UpToTheLimit, Shares, testing::Values(0.05, 0.2, 0.4));

TEST(Jitter, SmallSharesAreNotDamped) {
  // Below 0.225 no cell can lose its shape, so the moves are the drawn numbers, untouched: with
  // twice the share every move doubles.
  const auto lattice = make_lattice(plate(), 0.05);
  const VectorField<2> once = jittered(lattice, 0.11, 2).X - lattice.X;
  const VectorField<2> twice = jittered(lattice, 0.22, 2).X - lattice.X;
  EXPECT_NEAR((twice - 2.0 * once).cwiseAbs().maxCoeff(), 0.0, 1e-15);
}

TEST(Jitter, OfCellCentredNodesKeepsTheirVolumes) {
  const auto lattice = make_lattice(make_box<2>({0, 0}, {1, 1}), 0.25, NodePlacement::cell_centred);
  const auto cloud = jittered(lattice, 0.3, 1);
  EXPECT_EQ(cloud.V, lattice.V);
  EXPECT_EQ(cloud.X.row(0), lattice.X.row(0));
  EXPECT_NE(cloud.X.row(5), lattice.X.row(5));
}

TEST(Jitter, ZeroChangesNothingAndDisorderHasNoFrame) {
  const auto lattice = make_lattice(make_box<2>({0, 0}, {1, 1}), 0.25);
  EXPECT_EQ(jittered(lattice, 0.0, 1).X, lattice.X);
  EXPECT_TRUE(jittered(lattice, 0.0, 1).frame.has_value());
  EXPECT_FALSE(jittered(lattice, 0.1, 1).frame.has_value());
}

TEST(Jitter, RefusesSharesThatDestroyCells) {
  const auto lattice = make_lattice(make_interval(0, 1), 0.25);
  for (const double share : {-0.1, 0.41, std::nan("")})
    EXPECT_THAT(refusal([&] {
                  (void)jittered(lattice, share, 1, {"a.toml", 3, 1, "body.jitter"});
                }),
                testing::HasSubstr("body.jitter: jitter must lie between 0 and 0.4"));
}

}  // namespace
}  // namespace tlsph
