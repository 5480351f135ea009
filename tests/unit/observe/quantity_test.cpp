#include "tlsph/observe/quantity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tlsph {
namespace {

using testing::ElementsAre;

std::vector<std::string> suffixes(std::string_view name) {
  return component_suffixes<2>(*find_quantity<2>(name));
}

TEST(Quantities, NameTheirComponents) {
  EXPECT_THAT(suffixes("velocity"), ElementsAre("_x", "_y"));
  EXPECT_THAT(suffixes("pk1"), ElementsAre("_xx", "_xy", "_yx", "_yy"));
  EXPECT_THAT(suffixes("cauchy"), ElementsAre("_xx", "_xy", "_yy"));
  EXPECT_THAT(suffixes("pressure"), ElementsAre(""));
  EXPECT_THAT(component_suffixes<1>(*find_quantity<1>("cauchy")), ElementsAre("_xx"));
  EXPECT_EQ(find_quantity<2>("temperature"), nullptr);
}

TEST(Quantities, AreTheComponentsOfWhatIsObserved) {
  Observed<2> seen;
  seen.u = {1, 2};
  seen.H << 0.1, 0.2, 0.3, 0.4;
  seen.P << 1, 2, 3, 4;
  seen.stress.pressure = 7;
  const auto value = [&](std::string_view name, int i, int j) {
    return find_quantity<2>(name)->value(seen, i, j);
  };

  EXPECT_EQ(value("displacement", 1, 0), 2);
  EXPECT_EQ(value("deformation_gradient", 0, 0), 1.1);
  EXPECT_EQ(value("deformation_gradient", 1, 0), 0.3);
  EXPECT_EQ(value("pk1", 0, 1), 2);
  EXPECT_EQ(value("pressure", 0, 0), 7);
}

}  // namespace
}  // namespace tlsph
