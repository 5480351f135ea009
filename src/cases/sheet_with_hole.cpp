// A sheet with a hole under load: does the peak of the stress converge, and where to?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/stress.hpp"

namespace tlsph {
namespace {

constexpr double young = 70e6, poisson = 0.49;
constexpr double radius = 0.01;
constexpr std::array spacings = {5e-3, 2.5e-3, 1.25e-3, 6.25e-4};
constexpr double small_load = 1e3, load = 5e6;  // [Pa]

/// Finite elements of the same laws at rest, printed by stress_concentration.py: stress at the top
/// of the hole over the load at small strains, and under `load` that stress [Pa] and the way of
/// the middle of the pulled edge [m].
constexpr double concentration = 3.3600, peak_stress = 16.738e6, way = 3.5336e-3;

/// Cauchy stress along a free edge that is stretched by 1 + `strain` [Pa]: P_22 = 0 gives the
/// stretch across.
double edge_stress(const AnyLaw<2>& law, double strain) {
  Tensor<2> H = Tensor<2>::Zero();
  H(0, 0) = strain;
  double lower = -0.9, upper = 1.0;
  while (upper - lower > 1e-15) {
    H(1, 1) = 0.5 * (lower + upper);
    (pk1<2>(law, H)(1, 1) < 0 ? lower : upper) = H(1, 1);
  }
  return cauchy<2>(law, H, pk1<2>(law, H))(0, 0);
}

/// A run at rest: its nodes, their displacements and the stresses of its material points.
class AtRest {
 public:
  explicit AtRest(const CaseScene& scene)
      : X_(scene.data("particles/X")),
        u_(scene.frame("displacement", 1).value()),
        sigma_(scene.frame("cauchy", 1).value()) {}

  /// The stress at the top of the hole, from the stretch of the edge: even in the angle, it is the
  /// parabola through the middles of the first two chords.
  [[nodiscard]] double at_the_top(const AnyLaw<2>& law) const {
    std::vector<std::pair<double, Index>> ring;  // angle from the top, node
    for (Index q = 0; q < static_cast<Index>(X_.size()) / 2; ++q)
      if (const Vector<2> X = place(q); std::abs(X.norm() - radius) < 1e-9 * radius)
        ring.emplace_back(std::atan2(X[0], X[1]), q);
    std::ranges::sort(ring);
    std::array<double, 2> square{}, stress{};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [from, a] = ring.at(k);
      const auto [to, b] = ring.at(k + 1);
      square[k] = std::pow(0.5 * (from + to), 2);
      const Vector<2> chord = place(b) - place(a);
      const Vector<2> change = moved(b) - moved(a);
      const double strain = small_strain<2>(law) ? chord.dot(change) / chord.squaredNorm()
                                                 : (chord + change).norm() / chord.norm() - 1;
      stress[k] = edge_stress(law, strain);
    }
    return stress[0] - square[0] * (stress[1] - stress[0]) / (square[1] - square[0]);
  }

  /// The largest principal stress of any material point, as the source reads it.
  [[nodiscard]] double largest() const {
    double result = 0.0;
    for (std::size_t s = 0; s < sigma_.size(); s += 4) {
      const double half = 0.5 * (sigma_[s] - sigma_[s + 3]);
      result =
          std::max(result, 0.5 * (sigma_[s] + sigma_[s + 3]) + std::hypot(half, sigma_[s + 1]));
    }
    return result;
  }

 private:
  [[nodiscard]] Vector<2> place(Index q) const { return Eigen::Map<const Vector<2>>(&X_[at(q)]); }
  [[nodiscard]] Vector<2> moved(Index q) const { return Eigen::Map<const Vector<2>>(&u_[at(q)]); }
  static std::size_t at(Index q) { return 2 * static_cast<std::size_t>(q); }

  std::vector<double> X_, u_, sigma_;
};

/// Cells along a side.
int cells(double spacing) {
  return static_cast<int>(std::lround(0.05 / spacing));
}

CaseScene pull(CaseRun& run, const std::string& label, const std::string& formulation,
               double spacing, const Settings& settings) {
  return run.scene(
      fmt::format("{}-{}", label, cells(spacing)), "sheet.toml",
      with(settings, {"formulation=" + formulation, fmt::format("body.spacing={}", spacing)}));
}

/// How values at `spacings` converge, and whether to `reference`.
void check_limit(CaseRun& run, const std::string& text, double reference,
                 const std::vector<double>& values) {
  constexpr const char* source = "finite elements at rest";
  std::vector<double> differences;
  for (std::size_t k = 1; k < values.size(); ++k) differences.push_back(values[k] - values[k - 1]);
  const double order = fit_order_of_differences(spacings, differences).order;
  for (std::size_t k = 0; k < values.size(); ++k)
    run.check(source, fmt::format("{0}, {1} x {1} cells", text, cells(spacings.at(k))), values[k],
              k + 1 < values.size() ? reported(reference) : relative(reference, 4e-3));
  run.check(source, text + ", order of convergence", order, at_least(1.4));
  run.check(source, text + ", Richardson limit", richardson_limit(values[2], values[3], 2.0, order),
            relative(reference, 3e-3));
}

/// Boundary-fitted cells.
void converge(CaseRun& run, std::vector<CaseColumn>& columns) {
  const auto linear = make_law<2>(LawName::linear_elastic, Assumption::strain, young, poisson);
  const auto rubber = make_law<2>(LawName::neo_hookean, Assumption::strain, young, poisson);
  std::vector<CaseColumn> peaks = {{"linear"}, {"fitted"}};
  double end = 0.0, restless = 0.0;
  for (const double spacing : spacings) {
    const CaseScene small = pull(run, "linear", "stress-point", spacing,
                                 {"material.law=linear-elastic",
                                  fmt::format("boundary[2].traction.amplitude={}", small_load)});
    const CaseScene large = pull(run, "fitted", "stress-point", spacing, {});
    add_row(peaks,
            {AtRest(small).at_the_top(linear) / small_load, AtRest(large).at_the_top(rubber)});
    end = large.probe("edge.displacement_x").back();
    restless = std::max(restless, large.summary.energy.kinetic / large.summary.energy.elastic);
  }
  check_limit(run, "peak stress over the load, linear, stress-point", concentration,
              peaks[0].values);
  check_limit(run, "peak stress, stress-point [Pa]", peak_stress, peaks[1].values);
  run.check("finite elements at rest", "way of the pulled edge, stress-point [m]", end,
            relative(way, 1e-3));
  run.check("", "kinetic over elastic energy at the end", restless, at_most(1e-5));
  columns.insert(columns.end(), peaks.begin(), peaks.end());
}

/// Stairs as in the source, and the collocated operators on both: the largest value there is.
void step(CaseRun& run, std::vector<CaseColumn>& columns) {
  const auto series = [&](const std::string& name, const char* formulation, const char* fit) {
    std::string label = name;
    std::ranges::replace(label, ' ', '-');
    CaseColumn& largest = columns.emplace_back(name);
    for (const double spacing : spacings)
      largest.values.push_back(AtRest(pull(run, label, formulation, spacing, {fit})).largest());
    return largest.values;
  };
  const auto stairs = series("stairs", "stress-point", "body.fit=false");
  const auto collocated_stairs = series("variational stairs", "variational", "body.fit=false");
  const auto collocated = series("variational fitted", "variational", "body.fit=true");
  run.check("corners of stairs", "growth of the peak from 40 to 80 cells, stairs, stress-point",
            stairs[3] / stairs[2], at_least(1.1));
  run.check("corners of stairs", "growth of the peak from 40 to 80 cells, stairs, variational",
            collocated_stairs[3] / collocated_stairs[2], at_least(1.1));
  run.check("thesis, Fig. 5.15", "peak stress, stairs of 21 x 21, stress-point [Pa]", stairs[1],
            reported(60e6));
  run.check("thesis, Fig. 5.15", "peak stress, stairs of 21 x 21, variational [Pa]",
            collocated_stairs[1], reported(60e6));
  for (std::size_t k = 0; k < spacings.size(); ++k)
    run.check("finite elements at rest",
              fmt::format("peak stress, fitted, variational, {0} x {0} cells [Pa]",
                          cells(spacings.at(k))),
              collocated[k], reported(peak_stress));
}

}  // namespace

void sheet_with_hole(CaseRun& run) {
  std::vector<CaseColumn> columns = {{"spacing", spacings}};
  converge(run, columns);
  step(run, columns);
  run.table("peaks", columns);
}

}  // namespace tlsph
