#include "tlsph/studies/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tlsph {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// A pilot that is charged so many seconds.
Pilot pilot(double spacing, double error, double charged = 1.0, Index particles = 100) {
  return {spacing, 0.0, charged, charged, particles, 10, error};
}

TEST(FitModel, OrderIsThatOfTheLastThreePilots) {
  const std::vector<Pilot> pilots = {pilot(0.8, 0.9), pilot(0.4, 0.16), pilot(0.2, 0.04),
                                     pilot(0.1, 0.01)};

  EXPECT_NEAR(observed_order(pilots, believed_errors(pilots)), 2.0, 1e-12);
}

TEST(FitModel, OrderStaysWithinWhatIsBelieved) {
  const auto order = [](std::vector<double> errors) {
    return observed_order({pilot(0.2, errors[0]), pilot(0.1, errors[1])}, errors);
  };

  EXPECT_NEAR(order({0.8, 0.1}), 3.0, 1e-12);
  EXPECT_EQ(order({0.8, 1e-6}), 4.0);
  EXPECT_EQ(order({0.1, 0.2}), 0.5);
  EXPECT_EQ(observed_order({pilot(0.2, 0.1)}, {0.1}), 2.0);  // nothing to be seen
}

TEST(FitModel, ErrorIsStraightInLogarithms) {
  const std::vector<Pilot> pilots = {pilot(0.4, 0.16), pilot(0.2, 0.04), pilot(0.1, 0.02)};
  const std::vector<double> errors = {0.16, 0.04, 0.02};

  EXPECT_NEAR(predicted_error(pilots, errors, 0.8), 0.64, 1e-12);              // h²
  EXPECT_NEAR(predicted_error(pilots, errors, 0.4), 0.16, 1e-12);              // its own
  EXPECT_NEAR(predicted_error(pilots, errors, std::sqrt(0.08)), 0.08, 1e-12);  // half way
  EXPECT_NEAR(predicted_error(pilots, errors, 0.1), 0.02, 1e-12);
  // Beyond: order 1.5, the least squares through slopes of 2 and 1.
  EXPECT_NEAR(predicted_error(pilots, errors, 0.025), 0.02 / 8.0, 1e-12);
}

TEST(FitModel, SpacingIsTheInverseOfTheError) {
  const std::vector<Pilot> pilots = {pilot(0.4, 0.16), pilot(0.2, 0.04), pilot(0.1, 0.02)};
  const std::vector<double> errors = {0.16, 0.04, 0.02};

  EXPECT_NEAR(spacing_for(pilots, errors, 0.08), std::sqrt(0.08), 1e-12);
  EXPECT_NEAR(spacing_for(pilots, errors, 0.02 / 8.0), 0.025, 1e-12);
  EXPECT_EQ(spacing_for(pilots, errors, 0.5), 0.4);  // nothing is known of coarser ones
}

TEST(FitModel, SpacingIsNotAboveAnErrorThatComesBack) {
  const std::vector<Pilot> pilots = {pilot(0.8, 0.01), pilot(0.4, 0.16), pilot(0.2, 0.04)};

  EXPECT_NEAR(spacing_for(pilots, {0.01, 0.16, 0.04}, 0.08), std::sqrt(0.08), 1e-12);
}

TEST(FitModel, LuckIsNotBelieved) {
  const std::vector<Pilot> pilots = {pilot(0.4, 1e-9), pilot(0.2, -0.04), pilot(0.1, -0.01)};

  EXPECT_THAT(believed_errors(pilots), ElementsAre(0.04, 0.04, 0.01));
  // A coarse error that falls by more than 2³ at once is luck of the finer one.
  EXPECT_THAT(believed_errors({pilot(0.2, 0.08), pilot(0.1, 1e-5)}),
              ElementsAre(0.08, DoubleNear(0.01, 1e-15)));
}

TEST(FitModel, IsBracketedOnceMetWithoutLuck) {
  EXPECT_FALSE(is_bracketed({}, 0.05));
  EXPECT_FALSE(is_bracketed({pilot(0.4, 0.01)}, 0.05));                    // nothing beside it
  EXPECT_FALSE(is_bracketed({pilot(0.4, 0.2), pilot(0.2, 0.06)}, 0.05));   // not met
  EXPECT_FALSE(is_bracketed({pilot(0.4, 0.2), pilot(0.2, -0.01)}, 0.05));  // passed it
  EXPECT_TRUE(is_bracketed({pilot(0.4, 0.2), pilot(0.2, 0.04)}, 0.05));
  EXPECT_TRUE(is_bracketed({pilot(0.4, 0.04), pilot(0.2, -0.01)}, 0.05));
}

TEST(FitModel, SettlesAndStalls) {
  const std::vector<Pilot> second = {pilot(0.4, 0.16), pilot(0.2, 0.04), pilot(0.1, 0.012)};
  const std::vector<Pilot> early = {pilot(0.4, 0.16), pilot(0.2, 0.15), pilot(0.1, 0.04)};
  const std::vector<Pilot> flat = {pilot(0.8, 0.5), pilot(0.4, 0.49), pilot(0.2, 0.5),
                                   pilot(0.1, 0.5)};

  EXPECT_TRUE(has_settled(second));  // 2 and 1.74
  EXPECT_FALSE(has_settled(early));  // 0.09 and 1.9
  EXPECT_FALSE(has_settled({second[0], second[1]}));
  EXPECT_TRUE(has_stalled(flat));
  EXPECT_FALSE(has_stalled({flat[1], flat[2], flat[3]}));
  EXPECT_FALSE(has_stalled(second));
  auto few = flat;
  few.back().particles = 20;
  EXPECT_FALSE(has_stalled(few));  // too coarse to show anything
}

TEST(FitModel, TimeGrowsWithParticlesAndSteps) {
  const std::vector<Pilot> pilots = {pilot(0.4, 0.1, 3.0), pilot(0.1, 0.01, 40.0)};

  EXPECT_DOUBLE_EQ(predicted_seconds(pilots, 0.05, 2), 320.0);  // 2³ of the finer one
  EXPECT_DOUBLE_EQ(predicted_seconds(pilots, 0.05, 1), 160.0);
  EXPECT_DOUBLE_EQ(predicted_seconds(pilots, 0.3, 1), 3.0 / 0.5625);  // of the coarser
}

TEST(FitModel, HopesForNoMoreThanThirdOrderAtFirst) {
  EXPECT_DOUBLE_EQ(hoped_seconds({pilot(0.4, 0.8, 1.0)}, 0.1, 1), 4.0);  // half the spacing
  EXPECT_EQ(hoped_seconds({pilot(0.4, 0.05)}, 0.1, 1), 0.0);
  // Order 1 seen: 1.5 hoped for, so 0.2 to 0.025 takes a quarter of the spacing.
  const std::vector<Pilot> first = {pilot(0.4, 0.8), pilot(0.2, 0.4), pilot(0.1, 0.2)};
  EXPECT_NEAR(hoped_seconds(first, 0.025, 1), 16.0, 1e-12);
}

}  // namespace
}  // namespace tlsph
