// Irregular particles: gradients whose adjoint is exact converge, others do not.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "list.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/simulation/builder.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

constexpr std::array cells = {16, 32, 64};
constexpr std::array seeds = {1, 2, 3};
constexpr std::array quantities = {"displacement", "velocity", "stress"};

/// One way to take the gradient, and what its worst seed must not exceed.
struct Method {
  const char* name;
  std::vector<std::string> overrides;
  std::array<double, 3> at_32, at_64, order;  ///< limits by quantity; zero: reported
};

const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      {"consistent, degrees (1, 1)",
       {"consistency=[1, 1]"},
       {1e-3, 1e-2, 1.15e-2},
       {2.3e-4, 2.7e-3, 5.3e-3},
       {1.8, 1.8, 1.0}},
      {"consistent, degrees (2, 1)",
       {},
       {2e-4, 1.7e-3, 2.3e-3},
       {5e-5, 4e-4, 9e-4},
       {1.9, 1.9, 1.4}},
      {"variational", {"formulation=variational"}, {}, {}, {}}};
  return list;
}

ConvergenceTable study(const std::filesystem::path& scene, std::vector<std::string> overrides,
                       std::vector<double> spacings) {
  ConvergenceRequest request;
  request.scene = scene;
  request.overrides = std::move(overrides);
  request.spacings = std::move(spacings);
  ConvergenceOptions options;
  options.threads = 1;
  ConvergenceTable table = converge(request, options);
  for (const ConvergenceRow& row : table.rows)
    if (!row.failure.empty()) throw NumericalError(row.failure, 0.0, -1);
  return table;
}

/// Errors of all seeds, [seed][spacing][quantity], and the columns of the figure.
void swinging_plates(CaseRun& run) {
  constexpr const char* source = "exact solution";
  std::vector<std::string> columns = {"spacing"};
  std::vector<std::vector<double>> values(1);
  std::vector<double> spacings;
  for (const int n : cells) spacings.push_back(1.0 / n);
  values[0] = spacings;
  for (const Method& method : methods()) {
    std::vector<ConvergenceTable> tables;
    for (const int seed : seeds) {
      auto overrides = method.overrides;
      overrides.push_back(fmt::format("body.seed={}", seed));
      tables.push_back(study(run.folder() / "plate.toml", overrides, spacings));
    }
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      std::array<double, cells.size()> worst{};
      std::array<double, cells.size()> best{};
      std::vector<double> orders;
      for (const ConvergenceTable& table : tables) {
        orders.push_back(table.fits[q].fit.order);
        for (std::size_t k = 0; k < cells.size(); ++k) {
          const double error = table.rows[k].errors[q];
          worst[k] = std::max(worst[k], error);
          best[k] = best[k] == 0.0 ? error : std::min(best[k], error);
        }
      }
      std::ranges::sort(orders);
      const double order = orders[orders.size() / 2];
      columns.push_back(fmt::format("{} {} worst", method.name, quantities[q]));
      values.emplace_back(worst.begin(), worst.end());
      columns.push_back(fmt::format("{} {} best", method.name, quantities[q]));
      values.emplace_back(best.begin(), best.end());
      for (const auto& [k, limits] : {std::pair{1, &method.at_32}, std::pair{2, &method.at_64}}) {
        const auto at = static_cast<std::size_t>(k);
        const std::string text = fmt::format("{} error, worst of {} seeds, {} cells a side, {}",
                                             quantities[q], seeds.size(), cells[at], method.name);
        if ((*limits)[q] > 0.0)
          run.at_most(source, text, (*limits)[q], worst[at]);
        else
          run.report(source, text, worst[at]);
      }
      const std::string text =
          fmt::format("order of the {} error, median, {}", quantities[q], method.name);
      if (method.order[q] > 0.0)
        run.at_least(source, text, method.order[q], order);
      else
        run.report(source, text, order);
    }
  }
  run.table("plate", columns, values);
}

/// Largest acceleration that a constant stress with its own tractions causes, over |P|/(ρΔ).
template <int D>
double false_acceleration(const Scene& scene) {
  const Discretisation<D> disc = build<D>(scene);
  double worst = 0.0;
  for (int component = 0; component < D * D; ++component) {
    TensorField<D> P = TensorField<D>::Zero(disc.points.size(), D * D);
    P.col(component).setOnes();
    VectorField<D> f(disc.nodes(), D);
    disc.divergence.divergence(P, f);
    f.col(component / D) += disc.particles.B.col(component % D);
    for (Index q = 0; q < disc.nodes(); ++q)
      worst = std::max(worst, f.row(q).norm() / disc.mass[q]);
  }
  return worst * scene.materials.front().density * disc.spacing;
}

void constant_stress(CaseRun& run) {
  constexpr const char* source = "equilibrium of constant stress";
  const auto text = [](const char* body, const char* method) {
    return fmt::format("acceleration over |P|/(ρΔ), {}, {}", body, method);
  };
  run.at_most(source, text("disc with a hole", "consistent"), 1e-9,
              false_acceleration<2>(run.read("ring.toml")));
  run.at_most(source, text("bar", "consistent"), 1e-9, false_acceleration<1>(run.read("bar.toml")));
  run.report(source, text("disc with a hole", "variational"),
             false_acceleration<2>(run.read("ring.toml", {"formulation=variational"})));
  run.report(source, text("bar", "variational"),
             false_acceleration<1>(run.read("bar.toml", {"formulation=variational"})));
}

void bars(CaseRun& run) {
  constexpr const char* source = "d'Alembert";
  const std::vector<double> spacings = {5e-4, 2.5e-4, 1.25e-4};
  const ConvergenceTable table = study(run.folder() / "bar.toml", {}, spacings);
  run.absolute(source, "order of the stress error, bar, consistent", 2.0, table.fits[2].fit.order,
               0.1);
  run.at_most(source, "stress error, bar of 1200 cells, consistent", 1.5e-3,
              table.rows.back().errors[2]);
  const ConvergenceTable plain =
      study(run.folder() / "bar.toml", {"formulation=variational"}, spacings);
  run.report(source, "stress error, bar of 1200 cells, variational", plain.rows.back().errors[2]);
}

}  // namespace

void consistency(CaseRun& run) {
  constant_stress(run);
  bars(run);
  swinging_plates(run);
}

}  // namespace tlsph
