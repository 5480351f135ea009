#include "tlsph/geometry/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

TEST(OutlineLoops, RunHeadToTailOuterCounterClockwiseHolesClockwise) {
  const Shape<2> shape = make_difference(make_box<2>({0, 0}, {3, 2}),
                                         {make_disc({1, 1}, 0.5), make_box<2>({2, 0.5}, {2.5, 1})});

  const auto loops = outline_loops(shape);

  ASSERT_EQ(loops.size(), 3u);
  std::vector<double> areas;
  for (const OutlineLoop& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      EXPECT_NEAR((loop[k].to - loop[(k + 1) % loop.size()].from).norm(), 0.0, 1e-12);
    areas.push_back(enclosed_area(loop));
  }
  std::sort(areas.begin(), areas.end());
  EXPECT_NEAR(areas[0], -0.25 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(areas[1], -0.25, 1e-12);
  EXPECT_NEAR(areas[2], 6.0, 1e-12);
}

TEST(OutlineLoops, OfAQuarterRingIsOne) {
  const Shape<2> shape = make_difference(
      make_disc({0, 0}, 2.0),
      {make_disc({0, 0}, 1.0), make_box<2>({-3, -3}, {0, 3}), make_box<2>({-3, -3}, {3, 0})});

  const auto loops = outline_loops(shape);

  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(enclosed_area(loops[0]), 0.75 * std::numbers::pi, 1e-12);
  int corners = 0;
  for (std::size_t k = 0; k < loops[0].size(); ++k)
    corners += is_corner(loops[0][k], loops[0][(k + 1) % loops[0].size()]);
  EXPECT_EQ(corners, 4);
}

TEST(IsCorner, FromTwentyDegreesOn) {
  const OutlinePiece flat{{0, 0}, {1, 0}};
  EXPECT_FALSE(is_corner(flat, {{1, 0}, {2, 0.3}}));  // 17°
  EXPECT_TRUE(is_corner(flat, {{1, 0}, {2, 0.4}}));   // 22°
  EXPECT_TRUE(is_corner(flat, {{1, 0}, {0, 0.1}}));
}

}  // namespace
}  // namespace tlsph
