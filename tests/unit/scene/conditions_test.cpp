/// What [[boundary]] does to a patch, by component.

#include <gtest/gtest.h>

#include "scenes.hpp"
#include "tlsph/scene/conditions.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

TEST(Conditions, OfAnEntryAreThoseOfItsKeys) {
  const Scene scene = sheet_with({"boundary[0]={where=\"left\", fixed=\"y\", displacement={x=0.5}}",
                                  "boundary[1]={where=\"top\", symmetry=true}",
                                  "boundary[2]={where=\"right\", traction=-5}"});

  const auto left = conditions_of(scene.boundaries[0], 0);
  const auto top = conditions_of(scene.boundaries[1], 1);
  const auto right = conditions_of(scene.boundaries[2], unknown_axis);

  ASSERT_EQ(left.size(), 2U);
  EXPECT_EQ(left[0].kind, Kind::fixed);
  EXPECT_EQ(left[0].component, 1);
  EXPECT_FALSE(left[0].across);
  EXPECT_EQ(left[1].kind, Kind::moved);
  EXPECT_EQ(left[1].component, 0);
  EXPECT_EQ(value(*left[1].curve, 1.0), 0.5);
  ASSERT_EQ(top.size(), 1U);
  EXPECT_EQ(top[0].kind, Kind::fixed);
  EXPECT_EQ(top[0].component, 1);
  EXPECT_TRUE(top[0].across);
  ASSERT_EQ(right.size(), 1U);
  EXPECT_EQ(right[0].kind, Kind::loaded);
  EXPECT_EQ(right[0].component, unknown_axis);
  EXPECT_TRUE(right[0].across);
}

TEST(Conditions, OfAPatchAreThoseOfAllItsEntries) {
  const Scene scene = sheet_with({"boundary[0]={where=\"left\", fixed=\"y\"}",
                                  "boundary[1]={where=\"right\", fixed=true}",
                                  "boundary[2]={where=\"left\", traction=[3, 0]}"});
  const PatchConditions left(scene, "left"), right(scene, "right"), top(scene, "top");

  EXPECT_TRUE(left.has(Kind::fixed, 1));
  EXPECT_FALSE(left.has(Kind::fixed, 0));
  EXPECT_TRUE(left.has(Kind::loaded, 0));
  EXPECT_FALSE(left.has(Kind::moved));
  EXPECT_TRUE(right.has(Kind::fixed, 0) && right.has(Kind::fixed, 1));
  EXPECT_TRUE(top.all().empty());
}

/// A vector along the axis pulls at the upper side and pushes at the lower one.
TEST(Conditions, OfLoadsAreTensionsAcrossASide) {
  const Scene scene = sheet_with({"boundary[0]={where=\"left\", traction=[3, 0]}",
                                  "boundary[1]={where=\"right\", traction=[3, 0]}",
                                  "boundary[2]={where=\"top\", traction=3}"});
  const auto load = [&](std::size_t k) {
    return conditions_of(scene.boundaries[k], unknown_axis).front();
  };

  EXPECT_EQ(value(tension(load(0), -1.0), 1.0), -3.0);
  EXPECT_EQ(value(tension(load(1), 1.0), 1.0), 3.0);
  EXPECT_EQ(value(tension(load(2), 1.0), 1.0), 3.0);
  EXPECT_EQ(value(tension(load(2), -1.0), 1.0), 3.0);
}

TEST(Conditions, KnowTheAxisOfTheSidesOfABox) {
  const Scene box = sheet_with({});
  const Scene body = sheet_with({"body.shape={disc={centre=[0.5, 0.5], radius=1.0}}"});

  EXPECT_EQ(patch_axis(box, "left"), 0);
  EXPECT_EQ(patch_axis(box, "top"), 1);
  EXPECT_EQ(patch_axis(box, "hole"), unknown_axis);
  EXPECT_EQ(patch_axis(body, "left"), unknown_axis);
}

}  // namespace
}  // namespace tlsph
