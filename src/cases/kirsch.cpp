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

Plate solve(const CaseRun& run, int per_radius, std::vector<std::string> overrides) {
  overrides.push_back(fmt::format("body.spacing={}", radius / per_radius));
  const Discretisation<2> disc = build<2>(run.read("plate.toml", overrides));
  VectorField<2> forces = VectorField<2>::Zero(disc.nodes(), 2);
  for (const char* name : {"right", "top"})
    for (const Face<2>& face : disc.particles.find(name)->faces)
      for (std::size_t k = 0; k < 2; ++k) {
        const int q = face.nodes[k];
        const Vector<2> area = face.share[k] * face.area;
        forces.row(q) += (kirsch(disc.particles.X.row(q).transpose()) * area).transpose();
      }
  const VectorField<2> u = LinearBody(disc).at_rest(forces);
  TensorField<2> H(disc.points.size(), 4);
  disc.gradient.gradient(u, H);
  Plate plate;
  double error = 0.0, norm = 0.0;
  for (Index s = 0; s < disc.points.size(); ++s) {
    const Vector<2> X = disc.points.X.row(s).transpose();
    const Tensor<2> P = pk1<2>(disc.regions.front().law, tensor_at<2>(H, s));
    const Tensor<2> exact = kirsch(X);
    error += disc.points.V[s] * (P - exact).squaredNorm();
    norm += disc.points.V[s] * exact.squaredNorm();
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
  std::vector<std::vector<double>> columns(2);
  for (const auto& [angle, hoop] : plate.hoop) {
    columns[0].push_back(angle);
    columns[1].push_back(hoop);
  }
  run.table("hoop_" + name, {"angle", "hoop"}, columns);
}

/// How a method may err at 20 particles a radius, relative to the peak of three for the hoop
/// stress, and how fast its errors fall at least; zero: reported.
struct Method {
  const char* name;
  std::vector<std::string> overrides;
  /// Of the peak, along the hole, of all stresses: errors at the finest spacing and at the
  /// coarsest, orders.
  std::array<double, 3> within, coarse, order;
};

}  // namespace

void kirsch(CaseRun& run) {
  constexpr const char* source = "Kirsch 1898";
  const std::array methods = {
      Method{"consistent", {}, {0.01, 0.02, 4e-3}, {0.04, 0.05, 0.04}, {0.0, 0.0, 1.5}},
      Method{"consistent, irregular",
             {"body.jitter=0.2"},
             {0.01, 0.02, 4e-3},
             {0.04, 0.05, 0.04},
             {0.0, 0.0, 1.5}},
      Method{"variational", {"formulation=variational"}, {}, {}, {}}};
  std::vector<double> spacings;
  for (const int n : particles) spacings.push_back(radius / n);
  std::vector<std::string> columns = {"spacing"};
  std::vector<std::vector<double>> values = {spacings};
  for (const Method& method : methods) {
    std::array<std::vector<double>, 3> errors;
    for (const int n : particles) {
      const Plate plate = solve(run, n, method.overrides);
      for (const auto& [k, error] :
           {std::pair{0U, std::abs(plate.peak - 3) / 3}, {1U, plate.edge / 3}, {2U, plate.stress}})
        errors.at(k).push_back(error);
      if (n == particles.back()) hoop_table(run, method.name, plate);
    }
    const std::array names = {"peak stress at the top of the hole",
                              "largest error of the hoop stress along the hole",
                              "relative L2 error of the stress"};
    for (std::size_t k = 0; k < errors.size(); ++k) {
      for (std::size_t i = 0; i < particles.size(); ++i) {
        const std::string text =
            fmt::format("{}{}, {} particles a radius, {}", k == 0 ? "error of the " : "", names[k],
                        particles.at(i), method.name);
        const double within = i == 0                      ? method.coarse[k]
                              : i + 1 == particles.size() ? method.within[k]
                                                          : 0.0;
        if (within > 0.0)
          run.at_most(source, text, within, errors[k][i]);
        else
          run.report(source, text, errors[k][i]);
      }
      const std::string text = fmt::format("order of convergence, {}, {}", names[k], method.name);
      const double order = fit_order(spacings, errors[k]).order;
      if (method.order[k] > 0.0)
        run.at_least(source, text, method.order[k], order);
      else
        run.report(source, text, order);
      columns.push_back(fmt::format("{} {}", method.name, k));
      values.push_back(errors[k]);
    }
  }
  run.table("errors", columns, values);
}

}  // namespace tlsph
