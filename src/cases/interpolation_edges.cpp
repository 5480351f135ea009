// Edges of all widths, and the modified SPH matrix at the ends of a line.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "linear_body.hpp"
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
  for (const auto& [figure, name, spacings] : {std::tuple{"2.17", "very low", 64},
                                               {"2.18", "low", 16},
                                               {"2.19", "high", 4},
                                               {"2.20", "discontinuous", 1}}) {
    const std::string source = fmt::format("thesis, Fig. {}", figure);
    const int margin = 12;
    const int width = spacings;
    const SampledLine line(-margin, width + margin, width + 2 * margin, layers);
    const ScalarField values = line.sample([width](double x) { return edge(x, width); });
    const ScalarField exact =
        line.real(line.sample([width](double x) { return edge_slope(x, width); }));
    std::vector<CaseColumn> table = {{"x", line.real(line.X.col(0))}, {"exact", exact}};
    for (const double support : supports) {
      const ScalarField plain = line.real(plain_sums(kernel, support, line).derivative * values);
      const ScalarField normalised =
          line.real(normalised_sums(kernel, support, line).derivative * values);
      if (width == 64)
        run.check(source,
                  fmt::format("slope in the middle of the edge, of the true one, support {}, "
                              "plain sums: −Σ j W'_j",
                              support),
                  plain[margin + 32] * -64.0, relative(LatticeSums(support).slope(), 1e-10));
      const std::string share =
          fmt::format("share of a {} gradient that is missed, support {}", name, support);
      if (support == 1.5 || support == 2.5 || support == 5.5)
        run.check(source, share + ", plain sums", missed(plain, exact), reported(0.0));
      if (support == 1.5)
        run.check(source, share + ", normalised", missed(normalised, exact), at_most(1e-12));
      table.emplace_back(fmt::format("plain {}", support), plain);
      table.emplace_back(fmt::format("normalised {}", support), normalised);
    }
    run.table(fmt::format("edge{}", width), table);
  }
}

void modified_matrix(CaseRun& run) {
  const SampledLine line(0.0, 1.0, 40, layers);
  const auto quartic = [](double x) { return std::pow(x - 0.5, 4); };
  const auto one = [](double) { return 1.0; };
  // Boundary and ghost particles are unknown, the inner ones known.
  std::vector<Index> unknown;
  for (Index p = 0; p < line.X.rows(); ++p)
    if (p <= line.first || p + 1 >= line.first + line.count) unknown.push_back(p);
  std::vector<CaseColumn> table = {{"x", line.real(line.X.col(0))}};
  double printed = 0.0;
  double consistent = 0.0;
  for (const double support : supports) {
    const SparseMatrix W = plain_sums(kernel, support, line).value;
    const SymmetricOrGeneral factor(among(W, unknown));

    /// ⟨f⟩ at all particles once boundary and ghosts are solved for.
    const auto solved = [&](const Function& f, bool coupled) {
      ScalarField values = line.sample(f);
      values(unknown).setZero();
      ScalarField rhs = line.X.col(0)(unknown).unaryExpr(
          [&](double x) { return f(std::round(x)); });  // at the nearer end
      if (coupled) rhs -= ScalarField(W * values)(unknown);
      values(unknown) = factor.solve(rhs);
      return line.real(W * values);
    };
    const auto off = [&](const Function& f, bool coupled) {
      return std::abs(solved(f, coupled)[0] / f(0.0) - 1);
    };
    const LatticeSums closed(support);
    const double half =
        0.5 * (closed.value(0.0) - W.coeff(line.first, line.first));  // Σ_{j≥1} W_j, by symmetry
    run.check("thesis, (2.46)",
              fmt::format("⟨1⟩_B − 1 as printed, support {}: Σ W_j over inner j", support),
              off(one, false), relative(half, 1e-8));
    printed = std::max(printed, off(quartic, false));
    consistent = std::max(consistent, off(quartic, true));
    for (const bool coupled : {false, true}) {
      const char* of = coupled ? "consistent" : "printed";
      table.emplace_back(fmt::format("{} {}", of, support), solved(quartic, coupled));
    }
  }
  run.check("thesis, (2.47)", "|⟨f⟩_B/f_B − 1| of (x − ½)⁴ as printed, largest of all supports",
            printed, reported(0.0));
  run.check("thesis, (2.47)", "|⟨f⟩_B/f_B − 1| of (x − ½)⁴, consistent, largest of all supports",
            consistent, at_most(1e-10));
  run.table("modified", table);
}

}  // namespace tlsph::sampling
