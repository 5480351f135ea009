#include "zero_energy_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tlsph/model/builder.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "tlsph/stability/lattice.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

constexpr const char* source = "Cranfield thesis, sec. 3.7";
constexpr double nothing = 1e-12;  ///< of the largest ω²: round-off
/// A free body may have one elastic mode up to this multiple of its lowest true ω².
constexpr double lowest = 1.05;

struct Method {
  const char* name;
  Settings settings;
  double on_torus;  ///< modes without energy beside the translations, by theory
  bool stabilised;
};

double count_up_to(const std::vector<double>& squares, double limit) {
  return static_cast<double>(std::ranges::count_if(squares, [&](double w) { return w <= limit; }));
}

/// Modes without energy beside the translations of a body without boundary, periodic after `nodes`
/// nodes a direction: what it answers to waves is that of the middle of `disc`.
template <int D>
double on_torus(const Discretisation<D>& disc, int nodes) {
  const auto symbol = lattice_symbol<D>(disc, state_at_rest<D>(disc));
  std::vector<double> squares;
  for (int wave = 0; wave < std::pow(nodes, D); ++wave) {
    Vector<D> k;
    for (int a = 0, number = wave; a < D; ++a, number /= nodes)
      k[a] = 2 * std::numbers::pi * (number % nodes) / (nodes * disc.particles.spacings[a]);
    for (const double square : squared_frequencies<D>(symbol, k)) squares.push_back(square);
  }
  return count_up_to(squares, nothing * std::ranges::max(squares)) - D;
}

/// A free body: without a stabiliser what should come out is shown only.
Claim one_mode(bool stabilised) {
  return stabilised ? absolute(1.0, 0.0) : reported(1.0);
}

void bars(CaseRun& run) {
  const auto count = [&](const std::string& name, const Discretisation<1>& bar, double on_ring,
                         bool stabilised) {
    run.check(source, fmt::format("modes without energy, endless bar, {}", name),
              on_torus<1>(bar, 40), absolute(on_ring, 0.0));
    const double first = std::numbers::pi * std::numbers::pi;  // (cπ/L)²
    run.check(source, fmt::format("elastic modes up to 1.025 cπ/L, free bar, {}", name),
              count_up_to(squared_frequencies<1>(bar), lowest * first) - 1, one_mode(stabilised));
  };
  for (const double support : {1.5, 2.5}) {
    const Settings kernel = {fmt::format("kernel.support={}", support)};
    const std::string name = fmt::format("variational, support {}", support);
    auto bar = build<1>(run.read("free_bar.toml", kernel));
    count(name, bar, 1.0, false);
    add_one_sided_stabiliser(bar, 4.0 / 3.0);
    count(name + ", one-sided stabiliser", bar, 0.0, true);
    count(name + ", pair stabiliser",
          build<1>(run.read("free_bar.toml", with(kernel, {"stabiliser.kind=pair"}))), 0.0, true);
  }
  count("stress-point", build<1>(run.read("free_bar.toml", {"formulation=stress-point"})), 0.0,
        true);
}

/// Three rigid motions of a free sheet.
constexpr int rigid = 3;
constexpr int shown = 24;

void sheets(CaseRun& run) {
  const std::vector<Method> methods = {
      {"stress-point, cell stabiliser", {"formulation=stress-point"}, 0.0, true},
      {"stress-point", {"formulation=stress-point", "stabiliser.kind=none"}, 2.0, false},
      {"variational, pair stabiliser", {"kernel.support=2.5"}, 0.0, true},
      {"variational", {"kernel.support=2.5", "stabiliser.kind=none"}, 6.0, false},
  };
  double first = 0.0;  // of the best operator, which comes first
  std::vector<CaseColumn> table = {{"number"}};
  for (int k = 1; k <= shown; ++k) add_row(table, {static_cast<double>(k)});
  for (const auto& [name, settings, endless, stabilised] : methods) {
    const Scene large =
        run.read("free_sheet.toml", with(settings, {"body.spacing=0.041666666667"}));
    run.check(source, fmt::format("modes without energy, endless sheet, {}", name),
              on_torus<2>(build<2>(large), 12), absolute(endless, 0.0));
    const auto squares = squared_frequencies<2>(build<2>(run.read("free_sheet.toml", settings)));
    if (first == 0.0) first = squares[rigid];
    run.check(source, fmt::format("elastic modes up to 1.025 ω₁, free sheet, {}", name),
              count_up_to(squares, lowest * first) - rigid, one_mode(stabilised));
    CaseColumn& frequencies = table.emplace_back(name);
    for (std::size_t k = 0; k < shown; ++k)
      frequencies.values.push_back(std::sqrt(std::max(0.0, squares[k] / first)));
  }
  run.table("modes", table);
}

}  // namespace

void add_one_sided_stabiliser(Discretisation<1>& bar, double coefficient) {
  const Index N = bar.nodes();
  std::vector<Eigen::Triplet<double>> difference;
  std::vector<Eigen::Triplet<double>> arm;
  std::vector<double> strength;
  const double modulus = tangent<1>(bar.regions.front().law, Tensor<1>::Zero())(0, 0);
  for (Index p = 0; p < N; ++p)
    for (const Index q : {p - 1, p + 1}) {
      if (q < 0 || q >= N) continue;
      const auto row = static_cast<int>(strength.size());
      const double distance = bar.particles.X(q, 0) - bar.particles.X(p, 0);
      difference.emplace_back(row, static_cast<int>(q), 1.0);
      difference.emplace_back(row, static_cast<int>(p), -1.0);
      arm.emplace_back(row, static_cast<int>(p), distance);
      strength.push_back(0.5 * coefficient * modulus * bar.spacing / (distance * distance));
    }
  const auto rows = static_cast<Index>(strength.size());
  SparseMatrix errors(rows, N);
  SparseMatrix arms(rows, N);
  errors.setFromTriplets(difference.begin(), difference.end());
  arms.setFromTriplets(arm.begin(), arm.end());
  errors -= SparseMatrix(arms * bar.gradient.matrix(0));
  const SparseMatrix S =
      normal_matrix(errors, Eigen::Map<const ScalarField>(strength.data(), rows));
  bar.stiffness = bar.stiffness.size() == 0 ? S : SparseMatrix(bar.stiffness + S);
}

void count_zero_energy_modes(CaseRun& run) {
  bars(run);
  sheets(run);
}

}  // namespace tlsph
