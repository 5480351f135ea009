#include "zero_energy_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stabilised_bar.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/model/builder.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

constexpr const char* source = "Cranfield thesis, sec. 3.7";
constexpr double nothing = 1e-12;  ///< of the largest ω²: round-off
/// A free body may have one elastic mode up to this multiple of its lowest true ω².
constexpr double lowest = 1.05;

struct Setting {
  std::string name;
  std::vector<std::string> overrides;
  double on_torus;  ///< modes without energy beside the translations, by theory
  bool stabilised;
};

double count_up_to(const std::vector<double>& squares, double limit) {
  return static_cast<double>(std::ranges::count_if(squares, [&](double w) { return w <= limit; }));
}

template <int D>
double on_torus(const Discretisation<D>& disc, int nodes) {
  std::vector<double> squares;
  for (const auto& value : eigenvalues(torus_matrix<D>(disc, nodes)))
    squares.push_back(value.real());
  return count_up_to(squares, nothing * squares.front()) - D;
}

void judge(CaseRun& run, const std::string& quantity, bool stabilised, double expected,
           double seen) {
  if (stabilised)
    run.absolute(source, quantity, expected, seen, 0.0);
  else
    run.report(source, quantity, seen, expected);
}

void bars(CaseRun& run) {
  const auto count = [&](const std::string& name, const Discretisation<1>& bar, double on_ring,
                         bool stabilised) {
    run.absolute(source, fmt::format("modes without energy, endless bar, {}", name), on_ring,
                 on_torus<1>(bar, 40), 0.0);
    const double first = std::numbers::pi * std::numbers::pi;  // (cπ/L)²
    judge(run, fmt::format("elastic modes up to 1.025 cπ/L, free bar, {}", name), stabilised, 1.0,
          count_up_to(squared_frequencies<1>(bar), lowest * first) - 1);
  };
  for (const double support : {1.5, 2.5}) {
    const std::vector<std::string> kernel = {fmt::format("kernel.support={}", support)};
    auto bar = build<1>(run.read("free_bar.toml", kernel));
    count(fmt::format("variational, support {}", support), bar, 1.0, false);
    add_one_sided_stabiliser(bar, 4.0 / 3.0);
    count(fmt::format("variational, support {}, one-sided stabiliser", support), bar, 0.0, true);
    auto pair = kernel;
    pair.emplace_back("stabiliser.kind=pair");
    count(fmt::format("variational, support {}, pair stabiliser", support),
          build<1>(run.read("free_bar.toml", pair)), 0.0, true);
  }
  count("stress-point", build<1>(run.read("free_bar.toml", {"formulation=stress-point"})), 0.0,
        true);
}

/// Three rigid motions of a free sheet.
constexpr int rigid = 3;
constexpr int shown = 24;

void sheets(CaseRun& run) {
  const std::vector<Setting> settings = {
      {"stress-point, cell stabiliser", {"formulation=stress-point"}, 0.0, true},
      {"stress-point", {"formulation=stress-point", "stabiliser.kind=none"}, 2.0, false},
      {"variational, pair stabiliser", {"kernel.support=2.5"}, 0.0, true},
      {"variational", {"kernel.support=2.5", "stabiliser.kind=none"}, 6.0, false},
  };
  double first = 0.0;  // of the best operator, which comes first
  std::vector<std::string> columns = {"number"};
  std::vector<std::vector<double>> lists(1);
  for (int k = 1; k <= shown; ++k) lists[0].push_back(k);
  for (const Setting& setting : settings) {
    auto large = setting.overrides;
    large.emplace_back("body.spacing=0.041666666667");
    run.absolute(source, fmt::format("modes without energy, endless sheet, {}", setting.name),
                 setting.on_torus, on_torus<2>(build<2>(run.read("free_sheet.toml", large)), 12),
                 0.0);
    const auto squares =
        squared_frequencies<2>(build<2>(run.read("free_sheet.toml", setting.overrides)));
    if (first == 0.0) first = squares[rigid];
    judge(run, fmt::format("elastic modes up to 1.025 ω₁, free sheet, {}", setting.name),
          setting.stabilised, 1.0, count_up_to(squares, lowest * first) - rigid);
    columns.push_back(setting.name);
    lists.emplace_back();
    for (std::size_t k = 0; k < shown; ++k)
      lists.back().push_back(std::sqrt(std::max(0.0, squares[k] / first)));
  }
  run.table("modes", columns, lists);
}

}  // namespace

void count_zero_energy_modes(CaseRun& run) {
  bars(run);
  sheets(run);
}

}  // namespace tlsph
