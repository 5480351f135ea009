// Waves on a lattice: how fast each travels, and which of them cost no energy.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "tlsph/stability/lattice.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

constexpr int cells = 64;
constexpr double pi = std::numbers::pi;
constexpr const char* source = "Cranfield thesis, (7.33)";

/// −dW/dr of each family as its source prints it, but for a factor; q = r/h, h the full support.
double slope(std::string_view family, double q) {
  const double s = 1 - q * q;
  const double r = 2 * q;  // of those printed with a support of 2h
  if (family == "lucy") return 12 * q * (1 - q) * (1 - q);
  if (family == "cubic-spline") return r <= 1 ? 3 * r - 9. / 4 * r * r : 3. / 4 * (2 - r) * (2 - r);
  if (family == "gaussian") return 3 * q * std::exp(-3 * q * 3 * q);
  if (family == "mollifier") return 2 * q / (s * s) * std::exp(-1 / s);
  if (family == "modified-mollifier")
    return (2 * q / (s * s) * std::pow(s, 8) + 16 * q * std::pow(s, 7)) * std::exp(-1 / s);
  if (family == "quadratic") return 3. / 4 - 3. / 8 * r;
  if (family == "wendland-c2")
    return 2 * std::pow(1 - r / 2, 3) * (2 * r + 1) - 2 * std::pow(1 - r / 2, 4);
  throw InputError(fmt::format("no printed slope of the kernel {}", family));
}

/// Δ times the symbol of the gradient that is exact for linear fields, Σ w_j sin jθ / Σ w_j j.
template <class Weight>
double symbol(double support, double theta, const Weight& weight) {
  double sum = 0.0;
  double moment = 0.0;
  for (int j = 1; j < support; ++j) {
    sum += weight(j) * std::sin(j * theta);
    moment += weight(j) * j;
  }
  return sum / moment;
}

double kernel_symbol(std::string_view family, double support, double theta) {
  return symbol(support, theta, [&](int j) { return slope(family, j / support); });
}

/// Σ W_j j sin jθ / Σ W_j j² of the fitted plane, Wendland's kernel.
double plane_symbol(double support, double theta) {
  return symbol(support, theta, [&](int j) {
    const double q = j / support;
    return j * std::pow(1 - q, 4) * (1 + 4 * q);
  });
}

double squared(double x) {
  return x * x;
}

/// The relative size of the worst error at the wave numbers of a bar.
template <class Closed>
double worst_at_centre(const Discretisation<1>& bar, const Closed& closed) {
  const double unit = squared(bar.spacing);
  double worst = 0.0;
  for (int n = 1; n <= cells; ++n) {
    const double theta = n * pi / cells;
    const double seen = unit * squared_frequency(bar, cells / 2, theta / bar.spacing);
    worst = std::max(worst, std::abs(seen - closed(theta)));
  }
  return worst;
}

/// Kernel families: the spectrum of the whole bar, and the row of one particle.
void families(CaseRun& run) {
  constexpr std::array supports = {1.5, 2.5, 3.5, 5.5};
  for (const std::string_view family : kernel_names()) {
    double whole = 0.0;
    double row = 0.0;
    for (const double support : supports) {
      const Settings kernel = {fmt::format("kernel.family={}", family),
                               fmt::format("kernel.support={}", support)};
      const auto bar = build<1>(run.read("bar.toml", kernel));
      std::vector<double> seen = squared_frequencies<1>(bar);
      std::vector<double> closed;
      for (int n = 1; n < cells; ++n)
        closed.push_back(squared(kernel_symbol(family, support, n * pi / cells) / bar.spacing));
      std::ranges::sort(closed);
      for (std::size_t k = 0; k < closed.size(); ++k)
        whole = std::max(whole, std::abs(seen[k] - closed[k]) / closed.back());
      const Settings corrected =
          with(kernel, {"formulation=variational", "kernel.correction=gradient"});
      row = std::max(row, worst_at_centre(build<1>(run.read("bar.toml", corrected)), [&](double t) {
                       return squared(kernel_symbol(family, support, t));
                     }));
    }
    run.check(source, fmt::format("spectrum of a bar against its closed form, {}, mirror", family),
              whole, at_most(1e-10));
    run.check(source,
              fmt::format("(ωΔ/c)² of a row against its closed form, {}, variational", family), row,
              at_most(1e-10));
  }
}

/// Adds ½ κ E Σ V/Δ² ½(e_pq² + e_qp²) over nearest neighbours to the energy of a bar, κ =
/// `coefficient`, with the one-sided errors e_pq = u_q − u_p − (G u)_p (X_q − X_p) of the bar's own
/// gradient. With its three-point gradient and κ = 4/3 the waves travel at
/// ω² = (c/Δ)² [sin²θ + (16/3) sin⁴(θ/2)], θ = kΔ.
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

struct Operator {
  std::string name;
  Discretisation<1> bar;
  std::function<double(double)> closed;  // (ωΔ/c)² of θ
  double order;
};

/// What is left of the dispersion error, and how fast it falls.
void orders(CaseRun& run) {
  const auto variational = [&](double support) {
    return build<1>(run.read(
        "bar.toml", {"formulation=variational", fmt::format("kernel.support={}", support)}));
  };
  std::vector<Operator> operators;
  for (const double support : {1.5, 2.5, 5.5})
    operators.push_back({fmt::format("variational, support {}", support), variational(support),
                         [=](double t) { return squared(plane_symbol(support, t)); }, 2.0});
  operators.push_back({"stress-point", build<1>(run.read("bar.toml", {"formulation=stress-point"})),
                       [](double t) { return 4 * squared(std::sin(t / 2)); }, 2.0});
  operators.push_back(
      {"variational + one-sided stabiliser 4/3", variational(1.5),
       [](double t) { return squared(std::sin(t)) + 16. / 3 * std::pow(std::sin(t / 2), 4); },
       4.0});
  add_one_sided_stabiliser(operators.back().bar, 4.0 / 3.0);

  std::vector<CaseColumn> curves = {{"theta"}};
  for (int n = 1; n <= cells; ++n) add_row(curves, {n * pi / cells});
  for (const Operator& each : operators) {
    const double spacing = each.bar.spacing;
    const auto square = [&](double theta) {
      return squared_frequency(each.bar, cells / 2, theta / spacing);
    };
    const Checks check(run, ", " + each.name);
    check(source, "(ωΔ/c)² of a row against its closed form",
          worst_at_centre(each.bar, each.closed), at_most(1e-10));
    const std::vector<double> long_waves = {pi / 8, pi / 12, pi / 16, pi / 24, pi / 32};
    std::vector<double> errors;
    for (const double theta : long_waves)
      errors.push_back(std::abs(std::sqrt(square(theta)) * spacing / theta - 1));
    check(source, "order of the phase speed in θ", fit_order(long_waves, errors).order,
          absolute(each.order, 0.05));
    CaseColumn curve(each.name);
    for (const double theta : curves.front().values)
      curve.values.push_back(std::sqrt(std::max(0.0, square(theta))) * spacing);
    curves.push_back(std::move(curve));
  }
  run.table("curves", curves);
}

constexpr const char* modes = "Cranfield thesis, sec. 3.7";
constexpr double nothing = 1e-12;  ///< of the largest ω²: round-off
/// A free body may have one elastic mode up to this multiple of its lowest true ω².
constexpr double lowest = 1.05;

double count_up_to(const std::vector<double>& squares, double limit) {
  return static_cast<double>(std::ranges::count_if(squares, [&](double w) { return w <= limit; }));
}

/// Modes without energy beside the translations of a body without boundary, periodic after `nodes`
/// nodes a direction: what it answers to waves is that of the middle of `body`.
template <int D>
double on_torus(const Discretisation<D>& body, int nodes) {
  const auto symbol = lattice_symbol<D>(body, state_at_rest<D>(body));
  std::vector<double> squares;
  for (int wave = 0; wave < std::pow(nodes, D); ++wave) {
    Vector<D> k;
    for (int a = 0, number = wave; a < D; ++a, number /= nodes)
      k[a] = 2 * pi * (number % nodes) / (nodes * body.particles.spacings[a]);
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
    const Checks check(run, ", " + name);
    check(modes, "modes without energy, endless bar", on_torus<1>(bar, 40), absolute(on_ring, 0.0));
    const double first = pi * pi;  // (cπ/L)²
    check(modes, "elastic modes up to 1.025 cπ/L, free bar",
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
  struct Method {
    const char* name;
    Settings settings;
    double endless;  ///< modes without energy beside the translations, by theory
    bool stabilised;
  };
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
    const Checks check(run, fmt::format(", {}", name));
    check(modes, "modes without energy, endless sheet", on_torus<2>(build<2>(large), 12),
          absolute(endless, 0.0));
    const auto squares = squared_frequencies<2>(build<2>(run.read("free_sheet.toml", settings)));
    if (first == 0.0) first = squares[rigid];
    check(modes, "elastic modes up to 1.025 ω₁, free sheet",
          count_up_to(squares, lowest * first) - rigid, one_mode(stabilised));
    CaseColumn& frequencies = table.emplace_back(name);
    for (std::size_t k = 0; k < shown; ++k)
      frequencies.values.push_back(std::sqrt(std::max(0.0, squares[k] / first)));
  }
  run.table("modes", table);
}

}  // namespace

void dispersion(CaseRun& run) {
  families(run);
  orders(run);
  bars(run);
  sheets(run);
}

}  // namespace tlsph
