#include "tlsph/analysis/history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<double> mapped(const std::vector<double>& t, auto f) {
  std::vector<double> values;
  for (const double x : t) values.push_back(f(x));
  return values;
}

TEST(Resample, ReproducesCubicsOnUnevenSteps) {
  const std::vector<double> t = {0.0, 0.1, 0.3, 0.35, 0.7, 1.0};
  const std::vector<double> at = {0.0, 0.05, 0.1, 0.2, 0.33, 0.5, 0.69, 0.9, 1.0};
  const auto cubic = [](double x) { return 2.0 - x + 3.0 * x * x - 4.0 * x * x * x; };

  const auto values = resample(t, mapped(t, cubic), at);

  for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(values[k], cubic(at[k]), 1e-14) << at[k];
}

TEST(Resample, ErrsWithTheFourthPower) {
  const auto error = [](int n) {
    std::vector<double> t;
    std::vector<double> at;
    for (int k = 0; k <= n; ++k) t.push_back(k / static_cast<double>(n));
    for (int k = 0; k <= 1000; ++k) at.push_back(k / 1000.0);
    const auto wave = [](double x) { return std::sin(2.0 * std::numbers::pi * x); };
    const auto values = resample(t, mapped(t, wave), at);
    double largest = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k)
      largest = std::max(largest, std::abs(values[k] - wave(at[k])));
    return largest;
  };

  EXPECT_NEAR(std::log2(error(20) / error(40)), 4.0, 0.2);
  EXPECT_LT(error(40), 3e-5);
}

TEST(Resample, TakesWhatThereIsOfFewSamples) {
  const std::vector<double> at = {-1.0, 0.5, 9.0};

  EXPECT_THAT(resample(std::vector{0.0}, std::vector{3.0}, at), ElementsAre(3.0, 3.0, 3.0));
  EXPECT_THAT(resample(std::vector{0.0, 1.0}, std::vector{3.0, 5.0}, at),
              ElementsAre(3.0, 4.0, 5.0));
  EXPECT_THAT(resample(std::vector{0.0, 1.0, 2.0}, std::vector{0.0, 1.0, 4.0}, at),
              ElementsAre(0.0, 0.25, 4.0));
}

TEST(SquaredNorm, IsTheTrapezoidalIntegral) {
  EXPECT_DOUBLE_EQ(squared_norm(std::vector{0.0, 1.0, 3.0}, std::vector{2.0, 1.0, -3.0}),
                   0.5 * (4.0 + 1.0) + 1.0 * (1.0 + 9.0));
}

class HistoryFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) {
    std::ofstream(path) << text;
    return path;
  }
  void TearDown() override { std::filesystem::remove(path); }

  std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) /
      (std::string("tlsph_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
       std::to_string(::getpid()) + ".csv");
};

TEST_F(HistoryFile, IsReadToTheLastBit) {
  const History history = read_history(
      write("time,tip.displacement_x,p2.pk1_xx\n0,0,-1e5\n0.10000000000000001,-1.5e-300,7\n"));

  EXPECT_THAT(history.time, ElementsAre(0.0, 0.1));
  EXPECT_THAT(history.names, ElementsAre("tip.displacement_x", "p2.pk1_xx"));
  EXPECT_THAT(history.values, ElementsAre(ElementsAre(0.0, -1.5e-300), ElementsAre(-1e5, 7.0)));
}

TEST_F(HistoryFile, IsRefusedWithItsPlace) {
  const auto refuses = [&](const std::string& text, const std::string& message) {
    const auto written = write(text);
    EXPECT_THAT([&] { (void)read_history(written); }, ThrowsMessage<InputError>(HasSubstr(message)))
        << text;
  };
  refuses("", "empty");
  refuses("t,a\n0,1\n", ":1:1: the first column must be time");
  refuses("time,a\n", "no rows");
  refuses("time,a\n0,1\n1\n", ":3:1: a row has as many cells");
  refuses("time,a\n0,1x\n", ":2:1: \"1x\" is no number");
  refuses("time,a\n0,\n", "is no number");
  EXPECT_THROW((void)read_history("/no/such/file.csv"), InputError);
}

}  // namespace
}  // namespace tlsph
