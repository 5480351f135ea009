/// The swinging plate on nodes that stand on no lattice of squares: orders and bounds.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <unistd.h>
#include <cmath>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <ostream>

#include "lesson.hpp"

namespace tlsph::lessons {
namespace {

/// Nodes of a plate of n spacings a side, shifted rows pulled about by a smooth map: nowhere a
/// lattice, distances from 0.8 to 1.2 spacings.
std::filesystem::path graded_plate(int n) {
  auto path =
      std::filesystem::temp_directory_path() / fmt::format("tlsph_plate_{}_{}.csv", n, ::getpid());
  std::ofstream file(path);
  file << "x,y\n";
  const auto pull = [](double s) { return s + 0.03 * std::sin(2.0 * std::numbers::pi * s); };
  const int rows = static_cast<int>(std::lround(n / 0.866));
  for (int j = 0; j <= rows; ++j) {
    const bool shifted = j % 2 == 1 && j < rows;
    for (int i = 0; i <= n + (shifted ? 1 : 0); ++i) {
      const double s = std::clamp((i - (shifted ? 0.5 : 0.0)) / n, 0.0, 1.0);
      const double t = static_cast<double>(j) / rows;
      file << fmt::format("{:.12g},{:.12g}\n", pull(s), pull(t));
    }
  }
  return path;
}

struct CloudCase {
  const char* name;
  std::vector<std::string> overrides;
  std::array<double, 3>
      order;  ///< at least, from 16 to 64 spacings: displacement, velocity, stress
  std::array<double, 3> error;  ///< at most, at 64
};

void PrintTo(const CloudCase& one, std::ostream* out) {
  *out << one.name;
}

class SwingingCloud : public testing::TestWithParam<CloudCase> {};

TEST_P(SwingingCloud, Converges) {
  std::vector<std::array<double, 3>> errors;
  for (const int n : {16, 32, 64}) {
    std::vector<std::string> overrides = GetParam().overrides;
    overrides.push_back(fmt::format("body.spacing={:.17g}", 1.0 / n));
    std::filesystem::path file;
    for (std::string& entry : overrides)
      if (entry == "cloud") {
        file = graded_plate(n);
        entry = "body.cloud=" + file.string();
      }
    const Lesson lesson("swinging_plate", overrides);
    const auto& found = *lesson.summary().errors;
    errors.push_back({found.displacement, found.velocity, found.stress});
    fmt::print("{} {}: {:.2e} {:.2e} {:.2e}\n", GetParam().name, n, found.displacement,
               found.velocity, found.stress);
    if (!file.empty()) std::filesystem::remove(file);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(0.5 * std::log2(errors[0][k] / errors[2][k]), GetParam().order[k]) << k;
    EXPECT_LE(errors[2][k], GetParam().error[k]) << k;
  }
}

const std::string consistent = "formulation=consistent", pair = "stabiliser.kind=pair",
                  hexagonal = "body.layout=hexagonal", jitter = "body.jitter=0.2";

INSTANTIATE_TEST_SUITE_P(
    , SwingingCloud,
    testing::Values(
        CloudCase{"HexagonalConsistent",
                  {consistent, pair, hexagonal},
                  {1.9, 1.9, 1.8},
                  {2.1e-5, 3.0e-4, 2.6e-4}},
        CloudCase{"JitteredConsistent",
                  {consistent, pair, hexagonal, jitter},
                  {1.9, 1.8, 1.9},
                  {5.0e-6, 2.5e-4, 1.6e-4}},
        CloudCase{"FileConsistent",
                  {consistent, pair, "cloud"},
                  {1.9, 1.45, 1.65},
                  {3.5e-5, 9.5e-4, 6.0e-4}},
        CloudCase{"HexagonalEdges", {hexagonal}, {1.9, 1.3, 1.4}, {1.3e-5, 9.0e-4, 1.35e-3}},
        CloudCase{"JitteredEdges", {hexagonal, jitter}, {1.8, 1.0, 1.0}, {3.4e-5, 3.7e-3, 4.7e-3}},
        CloudCase{"FileEdges", {"cloud"}, {1.9, 1.5, 1.3}, {2.4e-5, 1.1e-3, 1.9e-3}}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace tlsph::lessons
