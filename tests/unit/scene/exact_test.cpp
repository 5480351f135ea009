// Exact solutions are accepted where they hold.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace tlsph {
namespace {

bool holds(const std::vector<std::string>& bar_changes) {
  try {
    static_cast<void>(bar_with(bar_changes));
  } catch (const InputError&) {
    return false;
  }
  return true;
}

const std::string wave = "reference.exact=bar-wave";
const std::string loaded_left = "boundary[0]={where=\"left\", traction=1e3}";
const std::string loaded_right = "boundary[0]={where=\"right\", traction=[1e3]}";

TEST(BarWave, HasOneLoadedEndAndOneFixedOrFree) {
  EXPECT_TRUE(holds({wave, loaded_left}));
  EXPECT_TRUE(holds({wave, loaded_right}));
  EXPECT_TRUE(holds({wave, loaded_left, "boundary[1]={where=\"right\", fixed=true}"}));
  EXPECT_FALSE(holds({wave}));
  EXPECT_FALSE(holds({wave, loaded_left, "boundary[1]={where=\"right\", traction=1}"}));
  EXPECT_FALSE(holds({wave, loaded_left, "boundary[1]={where=\"right\", displacement={x=1}}"}));
}

TEST(BarWave, StartsAtRestInOneMaterialWithoutGravity) {
  EXPECT_FALSE(holds({wave, loaded_left, "initial.velocity={constant=[1]}"}));
  EXPECT_FALSE(holds({wave, loaded_left, "gravity=[1]"}));
  EXPECT_TRUE(holds({wave, loaded_left, "gravity=[0]"}));
  EXPECT_FALSE(holds({wave, loaded_left, "material.region[0]={box=[0, 0.5], density=5}"}));
}

TEST(BarWave, NeedsRollersIn2D) {
  std::vector<std::string> changes(2, wave);
  changes[1] = loaded_left;
  changes.emplace_back("boundary[1]={where=\"top\", symmetry=true}");
  EXPECT_THROW(static_cast<void>(sheet_with(changes)), InputError);

  changes.emplace_back("boundary[2]={where=\"bottom\", fixed=\"y\"}");
  EXPECT_NO_THROW(static_cast<void>(sheet_with(changes)));

  changes.back() = "boundary[2]={where=\"bottom\", fixed=true}";
  EXPECT_THROW(static_cast<void>(sheet_with(changes)), InputError);
}

TEST(SwingingPlate, IsASquareAtTheOrigin) {
  const std::vector<std::string> plate = {
      "reference.exact=swinging-plate",
      "initial.displacement={field=\"swinging-plate\", amplitude=1}",
      "boundary[0]={where=\"left\", fixed=\"x\"}",
      "boundary[1]={where=\"top\", fixed=\"x\"}",
      "boundary[2]={where=\"right\", fixed=\"y\"}",
      "boundary[3]={where=\"bottom\", fixed=\"y\"}"};
  const auto with_box = [&](const std::string& box) {
    auto changes = plate;
    changes.push_back("body.shape={box=" + box + "}");
    return changes;
  };

  EXPECT_NO_THROW(static_cast<void>(sheet_with(with_box("[[0, 0], [2, 2]]"))));
  EXPECT_THROW(static_cast<void>(sheet_with(with_box("[[0, 0], [2, 1]]"))), InputError);
  EXPECT_THROW(static_cast<void>(sheet_with(with_box("[[1, 1], [2, 2]]"))), InputError);
}

TEST(UniformStretch, HoldsOrMovesBothEnds) {
  const std::string stretch = "reference.exact=uniform-stretch";
  const std::string moved = "boundary[0]={where=\"right\", displacement={x=0.5}}";

  EXPECT_TRUE(holds({stretch, moved, "boundary[1]={where=\"left\", fixed=true}"}));
  EXPECT_TRUE(holds({stretch, moved, "boundary[1]={where=\"left\", displacement={x=-0.5}}"}));
  EXPECT_FALSE(holds({stretch, moved}));
}

}  // namespace
}  // namespace tlsph
