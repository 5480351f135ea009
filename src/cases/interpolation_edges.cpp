#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "interpolation.hpp"
#include "sampled_line.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph::sampling {
namespace {

/// One until the edge begins at 0, zero from `width` spacings on, linear between.
double edge(double x, double width) {
  return std::clamp(1 - x / width, 0.0, 1.0);
}

/// Its slope; at the two corners the mean of both sides.
double edge_slope(double x, double width) {
  const double near = 1e-9;
  if (std::abs(x) < near || std::abs(x - width) < near) return -0.5 / width;
  return x > 0 && x < width ? -1 / width : 0.0;
}

/// Σ |error| Δ of a slope whose integral is −1.
double missed(const ScalarField& seen, const ScalarField& exact) {
  return (seen - exact).cwiseAbs().sum();
}

}  // namespace

void edges(CaseRun& run) {
  struct Figure {
    const char* name;
    const char* label;
    int width;  // in spacings
  };
  for (const Figure& figure : {Figure{"2.17", "very low", 64}, Figure{"2.18", "low", 16},
                               Figure{"2.19", "high", 4}, Figure{"2.20", "discontinuous", 1}}) {
    const std::string source = fmt::format("thesis, Fig. {}", figure.name);
    const int margin = 12;
    const SampledLine line(-margin, figure.width + margin, figure.width + 2 * margin, layers);
    const ScalarField values = line.sample([&](double x) { return edge(x, figure.width); });
    const ScalarField exact =
        line.real(line.sample([&](double x) { return edge_slope(x, figure.width); }));
    std::vector<std::string> columns = {"x", "exact"};
    std::vector<std::vector<double>> lists(2);
    for (Index p = 0; p < line.count; ++p) {
      lists[0].push_back(line.X(line.first + p, 0));
      lists[1].push_back(exact[p]);
    }
    for (const double support : supports) {
      const ScalarField plain = line.real(plain_sums(kernel, support, line).derivative * values);
      const ScalarField normalised =
          line.real(normalised_sums(kernel, support, line).derivative * values);
      if (figure.width == 64)
        run.relative(source,
                     fmt::format("slope in the middle of the edge, of the true one, support {}, "
                                 "plain sums: −Σ j W'_j",
                                 support),
                     LatticeSums(support).slope(), plain[margin + 32] * -64.0, 1e-10);
      if (support == 1.5 || support == 2.5 || support == 5.5)
        run.report(source,
                   fmt::format("share of a {} gradient that is missed, support {}, plain sums",
                               figure.label, support),
                   missed(plain, exact), 0.0);
      if (support == 1.5)
        run.at_most(source,
                    fmt::format("share of a {} gradient that is missed, support {}, normalised",
                                figure.label, support),
                    1e-12, missed(normalised, exact));
      columns.push_back(fmt::format("plain {}", support));
      lists.emplace_back(plain.begin(), plain.end());
      columns.push_back(fmt::format("normalised {}", support));
      lists.emplace_back(normalised.begin(), normalised.end());
    }
    run.table(fmt::format("edge{}", figure.width), columns, lists);
  }
}

void modified_matrix(CaseRun& run) {
  const SampledLine line(0.0, 1.0, 40, layers);
  const auto quartic = [](double x) { return std::pow(x - 0.5, 4); };
  const auto one = [](double) { return 1.0; };
  const Index N = line.X.rows();
  const Index end = line.first + line.count - 1;
  std::vector<std::string> columns = {"x"};
  std::vector<std::vector<double>> lists(1);
  for (Index p = 0; p < line.count; ++p) lists[0].push_back(line.X(line.first + p, 0));

  double printed = 0.0;
  double consistent = 0.0;
  for (const double support : supports) {
    const SparseMatrix W = plain_sums(kernel, support, line).value;
    // Boundary and ghost particles are unknown, the inner ones known.
    std::vector<int> place(static_cast<std::size_t>(N), -1);
    int unknowns = 0;
    for (Index p = 0; p < N; ++p)
      if (p <= line.first || p >= end) place[static_cast<std::size_t>(p)] = unknowns++;
    std::vector<Eigen::Triplet<double>> entries;
    for (Index p = 0; p < N; ++p)
      for (SparseMatrix::InnerIterator it(W, p); it; ++it) {
        const int row = place[static_cast<std::size_t>(p)];
        const int column = place[static_cast<std::size_t>(it.col())];
        if (row >= 0 && column >= 0) entries.emplace_back(row, column, it.value());
      }
    SparseMatrix block(unknowns, unknowns);
    block.setFromTriplets(entries.begin(), entries.end());
    const SymmetricOrGeneral factor(block);

    /// ⟨f⟩ at all particles once boundary and ghosts are solved for.
    const auto solved = [&](const Function& f, bool coupled) {
      ScalarField values = line.sample(f);
      for (Index p = 0; p < N; ++p)
        if (place[static_cast<std::size_t>(p)] >= 0) values[p] = 0.0;
      const ScalarField inner = W * values;
      ScalarField rhs(unknowns);
      for (Index p = 0; p < N; ++p)
        if (const int row = place[static_cast<std::size_t>(p)]; row >= 0)
          rhs[row] = f(p <= line.first ? 0.0 : 1.0) - (coupled ? inner[p] : 0.0);
      const ScalarField solution = factor.solve(rhs);
      for (Index p = 0; p < N; ++p)
        if (const int row = place[static_cast<std::size_t>(p)]; row >= 0) values[p] = solution[row];
      return line.real(W * values);
    };
    const auto off = [&](const Function& f, bool coupled) {
      return std::abs(solved(f, coupled)[0] / f(0.0) - 1);
    };
    const LatticeSums closed(support);
    const double half =
        0.5 * (closed.value(0.0) - W.coeff(line.first, line.first));  // Σ_{j≥1} W_j, by symmetry
    run.relative("thesis, (2.46)",
                 fmt::format("⟨1⟩_B − 1 as printed, support {}: Σ W_j over inner j", support), half,
                 off(one, false), 1e-8);
    printed = std::max(printed, off(quartic, false));
    consistent = std::max(consistent, off(quartic, true));
    for (const bool coupled : {false, true}) {
      const ScalarField values = solved(quartic, coupled);
      columns.push_back(fmt::format("{} {}", coupled ? "consistent" : "printed", support));
      lists.emplace_back(values.begin(), values.end());
    }
  }
  run.report("thesis, (2.47)", "|⟨f⟩_B/f_B − 1| of (x − ½)⁴ as printed, largest of all supports",
             printed, 0.0);
  run.at_most("thesis, (2.47)", "|⟨f⟩_B/f_B − 1| of (x − ½)⁴, consistent, largest of all supports",
              1e-10, consistent);
  run.table("modified", columns, lists);
}

}  // namespace tlsph::sampling
