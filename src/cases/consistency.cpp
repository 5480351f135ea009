// Irregular particles: gradients whose adjoint is exact converge, others do not.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {
namespace {

constexpr const char* exact = "exact solution";
constexpr std::array quantities = {"displacement", "velocity", "stress"};
constexpr std::array cells = {16, 32, 64, 128};
/// How many clouds are drawn at each fineness; the finest costs as much as all others.
constexpr std::array clouds = {5, 5, 3, 1};

/// One way to take the gradient, and what its worst cloud must not exceed.
struct Method {
  const char* name;
  std::vector<std::string> overrides;
  std::array<double, 3> at_32, at_64, order;  ///< limits by quantity; zero: reported
};

const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      {"consistent, degrees (1, 1)",
       {"consistency=[1, 1]", "stabiliser.as=viscosity"},
       {1e-3, 1e-2, 1.15e-2},
       {2.3e-4, 2.7e-3, 5.3e-3},
       {1.8, 1.8, 1.0}},
      {"consistent, degrees (2, 1)",
       {},
       {1.3e-4, 1.1e-3, 1.1e-3},
       {3e-5, 2.4e-4, 3.2e-4},
       {1.9, 1.9, 1.4}},
      {"variational", {"formulation=variational", "stabiliser.as=viscosity"}, {}, {}, {}}};
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

std::vector<double> spacings_of(std::size_t count) {
  std::vector<double> spacings;
  for (std::size_t k = 0; k < count; ++k) spacings.push_back(1.0 / cells.at(k));
  return spacings;
}

/// Errors of one quantity on all clouds of each fineness, sorted.
using Errors = std::array<std::vector<double>, cells.size()>;

/// [quantity][fineness]
std::array<Errors, quantities.size()> on_clouds(const CaseRun& run, const Method& method) {
  std::array<Errors, quantities.size()> errors;
  for (int seed = 1; seed <= clouds.front(); ++seed) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(clouds, [seed](int drawn) { return drawn >= seed; }));
    auto overrides = method.overrides;
    overrides.push_back(fmt::format("body.seed={}", seed));
    const ConvergenceTable table =
        study(run.folder() / "plate.toml", overrides, spacings_of(count));
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t q = 0; q < quantities.size(); ++q)
        errors[q][k].push_back(table.rows[k].errors[q]);
  }
  for (Errors& of_quantity : errors)
    for (auto& at : of_quantity) std::ranges::sort(at);
  return errors;
}

double median(const std::vector<double>& sorted) {
  return sorted[sorted.size() / 2];
}

/// A limit, or a report where there is none.
void judge(CaseRun& run, const std::string& text, double limit, double observed) {
  if (limit > 0.0)
    run.at_most(exact, text, limit, observed);
  else
    run.report(exact, text, observed);
}

void irregular_plates(CaseRun& run) {
  std::vector<std::string> columns = {"spacing"};
  const std::vector<double> spacings = spacings_of(cells.size());
  std::vector<std::vector<double>> values = {spacings};
  for (const Method& method : methods()) {
    const auto errors = on_clouds(run, method);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      std::vector<double> worst, middle, best;
      for (const auto& at : errors[q]) {
        worst.push_back(at.back());
        middle.push_back(median(at));
        best.push_back(at.front());
      }
      for (const auto& [k, limits] : {std::pair{1U, &method.at_32}, {2U, &method.at_64}}) {
        const std::string text =
            fmt::format("{} error, {} cells a side, {}", quantities[q], cells.at(k), method.name);
        judge(run, fmt::format("{}, worst of {} clouds", text, clouds.at(k)), (*limits)[q],
              worst[k]);
        run.report(exact, text + ", median", middle[k]);
      }
      const std::string text =
          fmt::format("order of the {} error, 16 to 128 cells, {}", quantities[q], method.name);
      const double order = fit_order(spacings, middle).order;
      if (method.order[q] > 0.0)
        run.at_least(exact, text, method.order[q], order);
      else
        run.at_most("does not converge", text, 0.5, order);
      columns.push_back(fmt::format("{} {} worst", method.name, quantities[q]));
      values.push_back(worst);
      columns.push_back(fmt::format("{} {} median", method.name, quantities[q]));
      values.push_back(middle);
      columns.push_back(fmt::format("{} {} best", method.name, quantities[q]));
      values.push_back(best);
    }
  }
  run.table("plate", columns, values);
}

/// Regular particles: the correction must not cost what they have.
void lattices(CaseRun& run) {
  constexpr std::size_t count = 3;
  const auto errors = [&](std::vector<std::string> overrides) {
    overrides.emplace_back("body.jitter=0");
    return study(run.folder() / "plate.toml", overrides, spacings_of(count));
  };
  const std::vector<std::string> cell = {"formulation=stress-point", "stabiliser.kind=cell",
                                         "stabiliser.as=stiffness"};
  auto corrected_cell = cell;
  corrected_cell.emplace_back("consistency=true");
  const ConvergenceTable points = errors(cell);
  const ConvergenceTable corrected = errors(corrected_cell);
  const ConvergenceTable collocated = errors({});
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const double reference = points.rows.back().errors[q];
    const auto text = [&](const char* of) {
      return fmt::format("{} error over that of stress points, lattice of {} cells a side, {}",
                         quantities[q], cells.at(count - 1), of);
    };
    run.at_most("stress points", text("consistent, degrees (2, 1)"), 2.5,
                collocated.rows.back().errors[q] / reference);
    run.relative("stress points", text("corrected stress points"), 1.0,
                 corrected.rows.back().errors[q] / reference, 0.1);
    run.at_least(
        exact,
        fmt::format("order of the {} error, lattice, corrected stress points", quantities[q]), 1.95,
        corrected.fits[q].fit.order);
    run.at_least(
        exact,
        fmt::format("order of the {} error, lattice, consistent, degrees (2, 1)", quantities[q]),
        1.95, collocated.fits[q].fit.order);
  }
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

/// A free body on irregular particles flies, turns and vibrates.
void momenta(CaseRun& run) {
  constexpr const char* source = "objective energy, G 1 = 0, G X = I";
  const std::vector<std::string> rubber = {"material.law=neo-hookean"};
  auto thrown = rubber;
  thrown.emplace_back("time.end=0.5");
  const auto judge_drift = [&](const char* body, const Summary& summary, bool turns) {
    run.at_most(source, fmt::format("drift of linear momentum, {}", body), 1e-12,
                summary.linear_momentum_drift);
    if (turns)
      run.at_most(source, fmt::format("drift of angular momentum, {}", body), 1e-12,
                  summary.angular_momentum_drift);
  };
  thrown.emplace_back(
      "initial.velocity={constant=[1.0, -2.0], gradient=[[2.0, 1.0], [-3.0, -1.5]]}");
  thrown.emplace_back("stabiliser.as=stiffness");
  judge_drift("disc with a hole", run.scene("flight", "ring.toml", thrown).summary, true);
  thrown.back() = "stabiliser.as=viscosity";
  run.report(source, "drift of angular momentum, disc with a hole, stabiliser as viscosity",
             run.scene("damped", "ring.toml", thrown).summary.angular_momentum_drift);
  judge_drift("bar",
              run.scene("shot", "bar.toml",
                        {"boundary=[]", "reference.exact=none",
                         "initial.velocity={constant=[1.0], gradient=[[20.0]]}"})
                  .summary,
              false);

  const Discretisation<2> ring = build<2>(run.read("ring.toml", rubber));
  const double angle = 2.4;
  Tensor<2> H;
  H << std::cos(angle) - 1, -std::sin(angle), std::sin(angle), std::cos(angle) - 1;
  State<2> state =
      make_state<2>(ring, ring.particles.X * H.transpose(), VectorField<2>::Zero(ring.nodes(), 2));
  evaluate<2>(ring, state);
  run.at_most(source, "stress over Young's modulus, disc with a hole, turned by 137 degrees", 1e-12,
              state.P.cwiseAbs().maxCoeff() / 1e6);
}

/// The viscous matrix counts: a run just below the computed step stays, one just above does not.
void step_limits(CaseRun& run) {
  constexpr const char* source = "computed critical step";
  for (const auto& [degrees, action] :
       {std::pair{"[1, 1]", "viscosity"}, {"[2, 1]", "stiffness"}}) {
    std::vector<std::string> overrides = {
        std::string("consistency=") + degrees, std::string("stabiliser.as=") + action,
        "time.allow_unstable=true", "body.spacing=0.015625", "time.end=2e-4"};
    const double critical = run.scene("step", "plate.toml", overrides).summary.dt_critical;
    overrides.back() = "time.end=3e-2";
    for (const double share : {0.99, 1.03}) {
      overrides.push_back(fmt::format("time.step={:.17g}", share * critical));
      const CaseScene end = run.scene("limit", "plate.toml", overrides);
      overrides.pop_back();
      // A run that is ended for its growth counts as an error beyond all others (JSON has no
      // infinity).
      const double error =
          end.failed_at ? std::numeric_limits<double>::max() : end.summary.errors->displacement;
      const std::string text = fmt::format(
          "displacement error after 30 ms at {} of the critical step, 64 cells a side, degrees {}",
          share, degrees);
      if (share < 1.0)
        run.at_most(source, text, 5e-3, error);
      else
        run.at_least(source, text, 1e3, error);
    }
  }
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
  momenta(run);
  bars(run);
  step_limits(run);
  lattices(run);
  irregular_plates(run);
}

}  // namespace tlsph
