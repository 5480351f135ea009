#include "tlsph/core/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tlsph {
namespace {

using testing::ElementsAre;

TEST(Split, GivesThePartsBetweenSeparators) {
  EXPECT_THAT(split("a.bc.d", '.'), ElementsAre("a", "bc", "d"));
  EXPECT_THAT(split("alone", '.'), ElementsAre("alone"));
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_THAT(split(".a..b.", '.'), ElementsAre("", "a", "", "b", ""));
  EXPECT_THAT(split("", '.'), ElementsAre());
}

}  // namespace
}  // namespace tlsph
