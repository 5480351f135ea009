// What SPH sums make of known functions: the thesis's study of interpolation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include "list.hpp"
#include "sampled_line.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace sampling {
namespace {

constexpr double round_off = 1e-11;

double f(double x) {
  return std::pow(x - 0.5, 4);
}
double df(double x) {
  return 4 * std::pow(x - 0.5, 3);
}

/// Largest error, of the largest value.
double error(const ScalarField& seen, const ScalarField& exact) {
  return (seen - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

/// The droop: what is left of a constant at the end of a line without ghosts.
void droop(CaseRun& run) {
  const SampledLine bare(0.0, 1.0, 40, 0);
  SampledLine equal = bare;  // every particle of the same volume
  equal.V.setConstant(equal.spacing);
  for (const double support : supports) {
    const auto at_end = [&](const SampledLine& line) {
      const LineOperators sums = plain_sums(kernel, support, line);
      const ScalarField one = sums.value * ScalarField::Ones(line.X.rows());
      return one[0] / one[line.count / 2];
    };
    run.check("thesis, Fig. 2.10",
              fmt::format("value at a bare end, of that inside, support {}", support), at_end(bare),
              relative(0.5, round_off));
    if (support == supports.back())
      run.check("thesis, Fig. 2.10",
                fmt::format("the same with a full volume at the end, support {}", support),
                at_end(equal), reported(0.5));
  }
}

/// Errors of value and derivative on finer and finer lines, zero of what is not looked at.
struct Study {
  std::string name;
  std::array<double, 2> order;  // of value and derivative
  std::array<double, 2> floor;  // where order 0: what the error ends at, zero if it is no constant
  std::function<std::array<double, 2>(int)> errors;
};

using LineSums = LineOperators(const AnyKernel&, double, const SampledLine&);
std::array<double, 2> with_sums(LineSums* sums, double support, int intervals, int ghosts) {
  const SampledLine line(0.0, 1.0, intervals, ghosts);
  const LineOperators operators = sums(kernel, support, line);
  const ScalarField values = line.sample(f);
  return {error(line.real(operators.value * values), line.real(values)),
          error(line.real(operators.derivative * values), line.real(line.sample(df)))};
}

std::array<double, 2> corrected(Correction correction, int intervals) {
  const SampledLine line(0.0, 1.0, intervals, 0);
  const auto G =
      collocated_gradient<1>(kernel, 2.5 * line.spacing, line.X, line.V, correction).matrix(0);
  return {0.0, error(G * line.sample(f), line.sample(df))};
}

std::array<double, 2> at_stress_points(int intervals) {
  const auto particles =
      make_lattice<1>(Shape<1>{Box<1>{Vector<1>(0.0), Vector<1>(1.0)}}, 1.0 / intervals);
  const auto points = cell_points<1>(particles);
  const ScalarField values = particles.X.col(0).unaryExpr(&f);
  const ScalarField exact = points.X.col(0).unaryExpr(&df);
  return {0.0, error(cell_gradient<1>(particles, points).matrix(0) * values, exact)};
}

void orders(CaseRun& run) {
  const LatticeSums closed(2.5);
  const std::array<double, 2> ends = {std::abs(closed.value(0.0) - 1),
                                      std::abs(closed.slope() - 1)};
  const auto sums = [](LineSums* of, int ghosts) {
    return [of, ghosts](int n) { return with_sums(of, 2.5, n, ghosts); };
  };
  const auto collocated = [](Correction correction) {
    return [correction](int n) { return corrected(correction, n); };
  };
  const std::vector<Study> studies = {
      {"plain sums, no ghosts", {0.0, -1.0}, {0.5, 0.0}, sums(plain_sums, 0)},
      {"plain sums, ghosts", {0.0, 0.0}, ends, sums(plain_sums, layers)},
      {"normalised sums, ghosts", {2.0, 2.0}, {}, sums(normalised_sums, layers)},
      {"gradient correction, no ghosts", {0.0, 1.0}, {}, collocated(Correction::gradient)},
      {"least squares, no ghosts", {0.0, 1.0}, {}, collocated(Correction::least_squares)},
      {"stress points, no ghosts", {0.0, 2.0}, {}, at_stress_points}};
  const std::array intervals = {40, 80, 160, 320, 640, 1280};
  std::vector<CaseColumn> table = {{"spacing"}};
  for (const int n : intervals) add_row(table, {1.0 / n});
  const std::vector<double> spacings = table.front().values;
  for (const Study& study : studies) {
    std::vector<CaseColumn> errors = {{"value, " + study.name}, {"derivative, " + study.name}};
    for (const int n : intervals) {
      const auto [value, derivative] = study.errors(n);
      add_row(errors, {value, derivative});
    }
    for (const std::size_t k : {0U, 1U}) {
      const std::vector<double>& seen = errors[k].values;
      if (seen.front() == 0.0) continue;
      const std::string what =
          std::string("largest error of the ") + (k == 0 ? "value" : "derivative");
      const Checks check(run, ", support 2.5, " + study.name);
      if (study.order[k] == 0.0)
        check("thesis, (2.35)", what + " however fine", seen.back(),
              absolute(study.floor[k], 0.02 * study.floor[k]));
      else
        check("thesis, (2.35)", "order of the " + what, fit_order(spacings, seen).order,
              absolute(study.order[k], 0.1));
      table.push_back(errors[k]);
    }
  }
  run.table("orders", table);
}

/// Figs 2.10–2.12 as drawn: value and derivatives for all supports.
void profiles(CaseRun& run) {
  const SampledLine bare(0.0, 1.0, 40, 0);
  std::vector<CaseColumn> table = {
      {"x", bare.X.col(0)}, {"exact", bare.sample(f)}, {"exact derivative", bare.sample(df)}};
  for (const double support : supports) {
    const LineOperators sums = plain_sums(kernel, support, bare);
    table.emplace_back(fmt::format("{}", support), ScalarField(sums.value * bare.sample(f)));
    if (support != supports.front() && support != supports.back()) continue;
    for (const auto& [name, intervals] : {std::pair{"2.11", 100}, std::pair{"2.12", 10}}) {
      const auto errors = with_sums(plain_sums, support, intervals, layers);
      for (const std::size_t k : {0U, 1U})
        run.check(fmt::format("thesis, Fig. {}", name),
                  fmt::format("largest error of the {}, {} intervals, ghosts, support {}",
                              k == 0 ? "value" : "derivative", intervals, support),
                  errors[k], reported(0.0));
    }
  }
  run.table("bare", table);
}

}  // namespace

void quartic(CaseRun& run) {
  droop(run);
  profiles(run);
  orders(run);
}

void sine(CaseRun& run) {
  using std::numbers::pi;
  double worst = 0.0;
  for (const auto& [figure, end, intervals] :
       {std::tuple{"2.13", 3 * pi, 90}, {"2.14", 3 * pi, 20}, {"2.15", pi, 90}, {"2.16", pi, 20}})
    for (const double support : supports) {
      const SampledLine line(0.0, end, intervals, 2 * layers);
      const LineOperators sums = plain_sums(kernel, support, line);
      const ScalarField values = line.sample([](double x) { return std::sin(x); });
      const ScalarField slopes = line.sample([](double x) { return std::cos(x); });
      const LatticeSums closed(support);
      const double amplitude = closed.value(line.spacing);
      const double slope = closed.derivative(line.spacing);
      const ScalarField first = sums.derivative * values;
      const auto compare = [&](const ScalarField& seen, const ScalarField& expected) {
        worst = std::max(worst, error(line.real(seen), line.real(expected)));
      };
      compare(sums.value * values, amplitude * values);
      compare(first, slope * slopes);
      compare(sums.derivative * first, -slope * slope * values);
      if (support != supports.front() && support != supports.back()) continue;
      run.check(fmt::format("thesis, Fig. {}", figure),
                fmt::format("amplitude of the derivative of sin x, support {}", support), slope,
                reported(1.0));
    }
  run.check("thesis, Figs 2.13–2.16",
            "amplitudes of sin x and two derivatives against Σ W cos jθ, −Σ W' sin jθ", worst,
            at_most(1e-10));
}

}  // namespace sampling

void interpolation(CaseRun& run) {
  sampling::quartic(run);
  sampling::sine(run);
  sampling::edges(run);
  sampling::modified_matrix(run);
}

}  // namespace tlsph
