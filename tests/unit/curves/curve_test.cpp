#include "tlsph/curves/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tlsph {
namespace {

struct Case {
  std::string name;
  Curve curve;
  std::vector<double> kinks;  ///< times where value or rate may jump, in order
  double end;                 ///< the curve is watched on [0, end]
};

/// Composite Simpson rule between the kinks.
double quadrature(const Case& c, double t) {
  double sum = 0, from = 0;
  std::vector<double> stops;
  for (const double kink : c.kinks)
    if (kink > 0 && kink < t) stops.push_back(kink);
  stops.push_back(t);
  for (const double to : stops) {
    constexpr int panels = 2000;
    // stay inside the piece, where one-sided values agree with the piece
    const double inset = 1e-13 * (to - from), step = (to - from - 2 * inset) / (2 * panels);
    double piece = 0;
    for (int i = 0; i <= 2 * panels; ++i) {
      const double weight = i == 0 || i == 2 * panels ? 1 : i % 2 == 1 ? 4 : 2;
      piece += weight * value(c.curve, from + inset + i * step);
    }
    sum += piece * step / 3;
    from = to;
  }
  return sum;
}

class CurveForms : public testing::TestWithParam<Case> {};

TEST_P(CurveForms, RateIsTheSlopeOfTheValue) {
  const Case& c = GetParam();
  const double step = 1e-4 * c.end;
  for (int i = 1; i < 60; ++i) {
    const double t = c.end * i / 60 + 0.37 * step;
    if (std::any_of(c.kinks.begin(), c.kinks.end(),
                    [&](double kink) { return std::abs(kink - t) < 3 * step; }))
      continue;
    const double near_change = value(c.curve, t + step) - value(c.curve, t - step);
    const double far_change = value(c.curve, t + 2 * step) - value(c.curve, t - 2 * step);
    EXPECT_NEAR(rate(c.curve, t) * c.end, (8 * near_change - far_change) / 12e-4, 1e-6)
        << "t = " << t;
  }
}

TEST_P(CurveForms, IntegralIsTheAreaUnderTheValue) {
  const Case& c = GetParam();
  for (int i = 1; i <= 24; ++i) {
    const double t = c.end * i / 20;  // a little past the end, too
    EXPECT_NEAR(integral(c.curve, t), quadrature(c, t), 1e-11 * c.end) << "t = " << t;
  }
}

TEST_P(CurveForms, NothingHappensBeforeTimeZero) {
  const Case& c = GetParam();
  EXPECT_EQ(value(c.curve, -1e-12), 0.0);
  EXPECT_EQ(rate(c.curve, -1e-12), 0.0);
  EXPECT_EQ(integral(c.curve, -1.0), 0.0);
  EXPECT_EQ(integral(c.curve, 0.0), 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    All, CurveForms,
    testing::Values(
        Case{"constant", ConstantCurve{-1.5}, {0}, 1},
        Case{"ramp", RampCurve{2, 0.4, false}, {0, 0.4}, 1},
        Case{"smooth", RampCurve{-2, 0.7, true}, {0, 0.7}, 1},
        Case{"step", RampCurve{1, 0, false}, {0}, 1},
        Case{"pulse", PulseCurve{-1, 8e-6, 1e-6}, {0}, 20e-6},
        Case{"square", PulseCurve{1, 0.5, 0}, {0, 0.5}, 1},
        Case{"sine", SineSquaredCurve{1.3, 0.6}, {0, 0.6}, 1},
        Case{"table", TableCurve{{0.1, 0.3, 0.6}, {1, -2, 0.5}, {}}, {0, 0.1, 0.3, 0.6}, 1},
        Case{"early", TableCurve{{-1, 0.5}, {0, 3}, {}}, {0, 0.5}, 1},
        Case{"jump", TableCurve{{0, 0.4, 0.4, 0.8}, {0, 1, 2, 2}, {}}, {0, 0.4, 0.8}, 1},
        Case{"single", TableCurve{{0.4}, {0.7}, {}}, {0}, 1},
        Case{"spline",
             cubic_spline({{-0.1, 0.3, 0.45, 0.6}, {1, -2, 0.5, 0}, {}}),
             {0, 0.3, 0.45, 0.6},
             1},
        Case{"given",
             GivenCurve{[](double x) { return std::cos(3 * x); },
                        [](double x) { return -3 * std::sin(3 * x); },
                        [](double x) { return std::sin(3 * x) / 3; }},
             {0},
             1},
        Case{"late", cubic_spline({{0.3, 0.5, 0.8}, {1, 0, 0.5}, {}}), {0, 0.3, 0.5, 0.8}, 1},
        Case{"pieces",
             cubic_spline({{0, 0.2, 0.4, 0.4, 0.6, 0.8}, {0, 1, 1, 2, 0, 3}, {}}),
             {0, 0.2, 0.4, 0.6, 0.8},
             1}),
    [](const auto& test) { return test.param.name; });

TEST(CurveByHand, SmoothRampMeetsItsEndsFlat) {
  const Curve ramp = RampCurve{3, 2, true};
  EXPECT_EQ(value(ramp, 0), 0.0);
  EXPECT_DOUBLE_EQ(value(ramp, 1), 1.5);
  EXPECT_DOUBLE_EQ(value(ramp, 2), 3.0);
  EXPECT_DOUBLE_EQ(rate(ramp, 1), 3 * 30.0 / 16 / 2);
  EXPECT_EQ(rate(ramp, 0), 0.0);
  EXPECT_EQ(rate(ramp, 2), 0.0);
  EXPECT_DOUBLE_EQ(integral(ramp, 2), 3.0);
  EXPECT_DOUBLE_EQ(integral(ramp, 5), 12.0);
}

TEST(CurveByHand, PulseIsTheFormula) {
  const double r = 1e-6, T = 8e-6;
  const Curve pulse = PulseCurve{-100e3, T, r};
  for (const double t : {0.0, 2e-6, 3e-6, 7e-6, 11e-6, 13e-6, 16e-6})
    EXPECT_NEAR(value(pulse, t),
                -50e3 * (std::erf((t - 3 * r) / r) - std::erf((t - 3 * r - T) / r)), 1e-10)
        << "t = " << t;
  EXPECT_NEAR(value(pulse, 0.0), -50e3 * std::erfc(3.0), 1e-15 * 50e3);
  // far behind the pulse: its area A T, less the tail before t = 0, A r/2 (e⁻⁹/√π − 3 erfc 3)
  const double tail = 0.5 * r * (std::exp(-9.0) / std::sqrt(std::acos(-1.0)) - 3 * std::erfc(3.0));
  EXPECT_NEAR(integral(pulse, 1.0) / (-100e3 * (T - tail)), 1.0, 1e-9);
}

TEST(CurveByHand, PulseKeepsSmallIntegralsJustAfterTheStart) {
  const Curve pulse = PulseCurve{1, 8e-6, 1e-6};
  const double t = 1e-11;
  EXPECT_NEAR(integral(pulse, t) / (t * 0.5 * std::erfc(3.0)), 1.0, 1e-4);
}

TEST(CurveByHand, RatesAreRightSidedAtKinks) {
  EXPECT_DOUBLE_EQ(rate(RampCurve{2, 4, false}, 0.0), 0.5);
  EXPECT_EQ(rate(RampCurve{2, 4, false}, 4.0), 0.0);
  const Curve table = TableCurve{{0, 1, 1, 3}, {0, 2, 5, 1}, {}};
  EXPECT_DOUBLE_EQ(rate(table, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(value(table, 1.0), 5.0);
  EXPECT_DOUBLE_EQ(rate(table, 1.0), -2.0);
  EXPECT_EQ(rate(table, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(integral(table, 3.0), 1.0 + 6.0);
}

/// sin(πt) has no curvature at either end, as the spline.
TEST(CurveByHand, SplineOfASineIsOfFourthOrderAndTwiceDifferentiable) {
  const auto error = [](int entries) {
    TableCurve table;
    for (int k = 0; k <= entries; ++k) {
      table.time.push_back(3.0 * k / entries);
      table.values.push_back(std::sin(std::acos(-1.0) * table.time.back()));
    }
    const Curve curve = cubic_spline(table);
    double largest = 0.0;
    for (int k = 0; k <= 1000; ++k)
      largest = std::max(largest,
                         std::abs(value(curve, 0.003 * k) - std::sin(std::acos(-1.0) * 0.003 * k)));
    for (int k = 1; k < entries; ++k) {
      const double t = table.time[static_cast<std::size_t>(k)], step = 1e-4;
      const double before = (rate(curve, t - step) - rate(curve, t - 2 * step)) / step;
      const double after = (rate(curve, t + 2 * step) - rate(curve, t + step)) / step;
      EXPECT_NEAR(rate(curve, t - 1e-12), rate(curve, t), 1e-9) << "t = " << t;
      EXPECT_NEAR(before, after, 0.1) << "t = " << t;  // of π², third derivatives times 3 steps
    }
    return largest;
  };
  const double coarse = error(30), fine = error(60);
  EXPECT_LT(fine, 2e-6);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
}

TEST(CurveByHand, SplineOfTwoEntriesIsALine) {
  const Curve curve = cubic_spline({{0, 2}, {1, 5}, {}});
  EXPECT_DOUBLE_EQ(value(curve, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(rate(curve, 0.0), 2.0);
}

/// 4 y″ = 6 (0 − 1 − 1): the value in the middle of either half is ½ + y″/6 (⅛ − ½) = 11/16.
TEST(CurveByHand, SplineOfThreeEntries) {
  const Curve curve = cubic_spline({{0, 1, 2}, {0, 1, 0}, {}});
  EXPECT_DOUBLE_EQ(value(curve, 0.5), 0.6875);
  EXPECT_DOUBLE_EQ(value(curve, 1.5), 0.6875);
  EXPECT_DOUBLE_EQ(rate(curve, 0.0), 1.5);
  EXPECT_DOUBLE_EQ(rate(curve, 1.0), 0.0);
}

TEST(CurveByHand, AnEmptyTableIsZero) {
  const Curve table = TableCurve{};
  EXPECT_EQ(value(table, 1.0), 0.0);
  EXPECT_EQ(rate(table, 1.0), 0.0);
  EXPECT_EQ(integral(table, 1.0), 0.0);
}

}  // namespace
}  // namespace tlsph
