#include "tlsph/particles/ghosts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "unit/particles/refusal.hpp"

namespace tlsph {
namespace {

TEST(Ghosts, OfABarContinueItAtBothEnds) {
  const auto bar = make_lattice(make_interval(1.0, 3.0), 1.0);
  const auto lattice = ghost_layers(bar, 2);
  EXPECT_EQ(lattice.real, 3);
  EXPECT_EQ(lattice.ghosts(), 4);
  EXPECT_EQ(lattice.X, (VectorField<1>(7, 1) << 1, 2, 3, -1, 0, 4, 5).finished());
  EXPECT_EQ(lattice.node({-1}), 4);
  EXPECT_EQ(lattice.node({2}), 2);
  EXPECT_EQ(lattice.node({3}), 5);
}

TEST(Ghosts, OfAPlateIncludeTheCorners) {
  const auto plate = make_lattice(make_box<2>({0, 0}, {2, 1}), 0.5);
  const auto lattice = ghost_layers(plate, 2);
  ASSERT_EQ(lattice.X.rows(), 9 * 7);
  EXPECT_EQ(lattice.X.topRows(plate.size()), plate.X);
  EXPECT_EQ(lattice.X.row(lattice.node({-2, -1})), Eigen::RowVector2d(-1.0, -0.5));
  std::set<int> seen;
  for (int i = -2; i < 7; ++i)
    for (int j = -2; j < 5; ++j) {
      const int node = lattice.node({i, j});
      seen.insert(node);
      EXPECT_EQ(lattice.coordinates[static_cast<std::size_t>(node)], (std::array<int, 2>{i, j}));
      EXPECT_NEAR((lattice.X.row(node) - Eigen::RowVector2d(0.5 * i, 0.5 * j)).norm(), 0.0, 1e-15);
      EXPECT_EQ(node < lattice.real, i >= 0 && i < 5 && j >= 0 && j < 3);
    }
  EXPECT_EQ(seen.size(), 63u);
}

TEST(Ghosts, NoLayersAreTheBodyItself) {
  const auto plate = make_lattice(make_box<2>({0, 0}, {2, 1}), 1.0);
  EXPECT_EQ(ghost_layers(plate, 0).X, plate.X);
}

TEST(Ghosts, NeedAFullLattice) {
  const auto disc = make_lattice(make_disc({0, 0}, 1.0), 0.25);
  const auto cloud = jittered(make_lattice(make_box<2>({0, 0}, {1, 1}), 0.25), 0.1, 1);
  const auto bar = make_lattice(make_interval(0, 1), 0.5);
  EXPECT_THAT(refusal([&] { (void)ghost_layers(disc, 1); }),
              testing::HasSubstr("full interval or box"));
  EXPECT_THAT(refusal([&] { (void)ghost_layers(cloud, 1); }), testing::HasSubstr("without jitter"));
  EXPECT_THAT(refusal([&] { (void)ghost_layers(bar, -1); }), testing::HasSubstr("not -1"));
  EXPECT_THAT(refusal([&] { (void)ghost_layers(bar, 2000000000); }),
              testing::HasSubstr("can be numbered"));
}

}  // namespace
}  // namespace tlsph
