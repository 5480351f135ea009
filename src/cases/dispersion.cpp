// Waves on a lattice: how fast each travels, and which of them cost no energy.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/model/builder.hpp"
#include "vibration.hpp"
#include "zero_energy_modes.hpp"

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
  return 2 * std::pow(1 - r / 2, 3) * (2 * r + 1) - 2 * std::pow(1 - r / 2, 4);
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
    run.check(source, fmt::format("(ωΔ/c)² of a row against its closed form, {}", each.name),
              worst_at_centre(each.bar, each.closed), at_most(1e-10));
    const std::vector<double> long_waves = {pi / 8, pi / 12, pi / 16, pi / 24, pi / 32};
    std::vector<double> errors;
    for (const double theta : long_waves)
      errors.push_back(std::abs(std::sqrt(square(theta)) * spacing / theta - 1));
    run.check(source, fmt::format("order of the phase speed in θ, {}", each.name),
              fit_order(long_waves, errors).order, absolute(each.order, 0.05));
    CaseColumn curve(each.name);
    for (const double theta : curves.front().values)
      curve.values.push_back(std::sqrt(std::max(0.0, square(theta))) * spacing);
    curves.push_back(std::move(curve));
  }
  run.table("curves", curves);
}

}  // namespace

void dispersion(CaseRun& run) {
  families(run);
  orders(run);
  count_zero_energy_modes(run);
}

}  // namespace tlsph
