// A plate with a round hole: the stress at its edge against Kirsch's solution.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "linear_body.hpp"
#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

constexpr double radius = 1.0, side = 4.0;
constexpr std::array particles = {5, 10, 20};  // a radius

/// Stress over the remote tension along x, a the radius of the hole (Kirsch 1898; Timoshenko &
/// Goodier, Theory of Elasticity, art. 35), in Cartesian components.
Tensor<2> kirsch(const Vector<2>& X) {
  const double r = X.norm();
  const double q = radius * radius / (r * r);
  const double cos = X[0] / r, sin = X[1] / r;
  const double cos2 = cos * cos - sin * sin, sin2 = 2 * sin * cos;
  const double radial = 0.5 * (1 - q) + 0.5 * (1 - 4 * q + 3 * q * q) * cos2;
  const double hoop = 0.5 * (1 + q) - 0.5 * (1 + 3 * q * q) * cos2;
  const double shear = -0.5 * (1 + 2 * q - 3 * q * q) * sin2;
  Tensor<2> R;
  R << cos, -sin, sin, cos;
  Tensor<2> polar;
  polar << radial, shear, shear, hoop;
  return R * polar * R.transpose();
}

/// Errors of one plate.
struct Plate {
  double peak = 0.0;    ///< σ_θθ at the top of the hole, 3 in the solution
  double edge = 0.0;    ///< largest error of the hoop stress along the hole
  double stress = 0.0;  ///< relative L2 of all components
  std::vector<std::pair<double, double>> hoop;  ///< angle, hoop stress along the hole
};

Plate solve(const CaseRun& run, int per_radius, const Settings& settings) {
  const std::string spacing = fmt::format("body.spacing={}", radius / per_radius);
  const auto body = build<2>(run.read("plate.toml", with(settings, {spacing})));
  VectorField<2> forces = VectorField<2>::Zero(body.nodes(), 2);
  for (const char* name : {"right", "top"})
    for (const Face<2>& face : body.particles.find(name)->faces)
      for (std::size_t k = 0; k < 2; ++k) {
        const int q = face.nodes[k];
        const Vector<2> area = face.share[k] * face.area;
        forces.row(q) += (kirsch(body.particles.X.row(q).transpose()) * area).transpose();
      }
  const VectorField<2> u = LinearBody(body).at_rest(forces);
  TensorField<2> H(body.points.size(), 4);
  body.gradient.gradient(u, H);
  Plate plate;
  double error = 0.0, norm = 0.0;
  for (Index s = 0; s < body.points.size(); ++s) {
    const Vector<2> X = body.points.X.row(s).transpose();
    const Tensor<2> P = pk1<2>(body.regions.front().law, tensor_at<2>(H, s));
    const Tensor<2> exact = kirsch(X);
    error += body.points.V[s] * (P - exact).squaredNorm();
    norm += body.points.V[s] * exact.squaredNorm();
    if (X.norm() > (1 + 1e-9) * radius) continue;
    const Vector<2> along(-X[1] / X.norm(), X[0] / X.norm());
    const double hoop = along.dot(P * along);
    plate.hoop.emplace_back(std::atan2(X[1], X[0]), hoop);
    plate.edge = std::max(plate.edge, std::abs(hoop - along.dot(exact * along)));
    if (X[0] < 1e-9 * radius) plate.peak = hoop;
  }
  std::ranges::sort(plate.hoop);
  plate.stress = std::sqrt(error / norm);
  return plate;
}

/// The hoop stress along the hole, for the figure.
void hoop_table(const CaseRun& run, std::string name, const Plate& plate) {
  std::erase(name, ',');
  std::ranges::replace(name, ' ', '_');
  std::vector<CaseColumn> table = {{"angle"}, {"hoop"}};
  for (const auto& [angle, hoop] : plate.hoop) add_row(table, {angle, hoop});
  run.table("hoop_" + name, table);
}

/// Errors of the hoop stress are relative to its peak of three.
struct Quantity {
  const char *of, *name;
  double (*error)(const Plate&);
  std::array<Claim, particles.size()> claims;  ///< of the consistent operators, irregular too
  Claim order;
};
const std::array quantities = {
    Quantity{"error of the ",
             "peak stress at the top of the hole",
             [](const Plate& plate) { return std::abs(plate.peak - 3) / 3; },
             {at_most(0.04), reported(), at_most(0.01)},
             reported()},
    Quantity{"",
             "largest error of the hoop stress along the hole",
             [](const Plate& plate) { return plate.edge / 3; },
             {at_most(0.05), reported(), at_most(0.02)},
             reported()},
    Quantity{"",
             "relative L2 error of the stress",
             [](const Plate& plate) { return plate.stress; },
             {at_most(0.04), reported(), at_most(4e-3)},
             at_least(1.5)}};

/// All errors of one method on three lattices; the variational one is only reported.
void check_method(CaseRun& run, const std::string& name, const Settings& settings,
                  std::vector<CaseColumn>& table) {
  constexpr const char* source = "Kirsch 1898";
  std::vector<Plate> plates;
  for (const int n : particles) plates.push_back(solve(run, n, settings));
  hoop_table(run, name, plates.back());
  const Checks check(run, ", " + name);
  const bool claimed = name != "variational";
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const auto& [of, what, error, claims, order] = quantities[q];
    std::vector<double>& errors = table.emplace_back(fmt::format("{} {}", name, q)).values;
    for (std::size_t k = 0; k < plates.size(); ++k) {
      errors.push_back(error(plates[k]));
      check(source, fmt::format("{}{}, {} particles a radius", of, what, particles.at(k)),
            errors.back(), claimed ? claims.at(k) : reported());
    }
    check(source, fmt::format("order of convergence, {}", what),
          fit_order(table.front().values, errors).order, claimed ? order : reported());
  }
}

}  // namespace

void kirsch(CaseRun& run) {
  std::vector<CaseColumn> table = {{"spacing"}};
  for (const int n : particles) add_row(table, {radius / n});
  check_method(run, "consistent", {}, table);
  check_method(run, "consistent, irregular", {"body.jitter=0.2"}, table);
  check_method(run, "variational", {"formulation=variational"}, table);
  run.table("errors", table);
}

}  // namespace tlsph
