// Irregular particles: gradients whose adjoint is exact converge, others do not.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "list.hpp"
#include "tlsph/analysis/order.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

constexpr const char* exact = "exact solution";
constexpr std::array quantities = {"displacement", "velocity", "stress"};
constexpr std::array cells = {16, 32, 64, 128};
/// How many clouds are drawn at each fineness; the finest costs as much as all others.
constexpr std::array clouds = {5, 5, 3, 1};

std::vector<double> spacings_of(std::size_t count) {
  std::vector<double> spacings;
  for (std::size_t k = 0; k < count; ++k) spacings.push_back(1.0 / cells.at(k));
  return spacings;
}

/// One way to take the gradient, and what is claimed of each quantity: its worst error at 32 and
/// at 64 cells, its order.
struct Method {
  std::string name;
  Settings settings;
  std::array<Claim, 3> at_32, at_64, order;
};

std::vector<Method> methods() {
  constexpr Claim none = at_most(0.5);
  return {{"consistent, degrees (1, 1)",
           {"consistency=[1, 1]", "stabiliser.as=viscosity"},
           {at_most(1e-3), at_most(1e-2), at_most(1.15e-2)},
           {at_most(2.3e-4), at_most(2.7e-3), at_most(5.3e-3)},
           {at_least(1.8), at_least(1.8), at_least(1.0)}},
          {"consistent, degrees (2, 1)",
           {},
           {at_most(1.3e-4), at_most(1.1e-3), at_most(1.1e-3)},
           {at_most(3e-5), at_most(2.4e-4), at_most(3.2e-4)},
           {at_least(1.9), at_least(1.9), at_least(1.4)}},
          {"variational",
           {"formulation=variational", "stabiliser.as=viscosity"},
           {},
           {},
           {none, none, none}}};
}

/// Errors of one quantity on all clouds of each fineness, sorted.
using Errors = std::array<std::vector<double>, cells.size()>;

/// [quantity][fineness]
std::array<Errors, quantities.size()> on_clouds(const CaseRun& run, const Settings& settings) {
  std::array<Errors, quantities.size()> errors;
  for (int seed = 1; seed <= clouds.front(); ++seed) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(clouds, [seed](int drawn) { return drawn >= seed; }));
    const ConvergenceTable table = run.converge(
        "plate.toml", with(settings, {fmt::format("body.seed={}", seed)}), spacings_of(count));
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t q = 0; q < quantities.size(); ++q)
        errors[q][k].push_back(table.rows[k].errors[q]);
  }
  for (Errors& of_quantity : errors)
    for (auto& at : of_quantity) std::ranges::sort(at);
  return errors;
}

void check_quantity(CaseRun& run, const Method& method, std::size_t q, const Errors& errors,
                    std::vector<CaseColumn>& columns) {
  const std::string name = fmt::format("{} {}", method.name, quantities[q]);
  CaseColumn worst(name + " worst"), median(name + " median"), best(name + " best");
  for (const auto& sorted : errors) {
    worst.values.push_back(sorted.back());
    median.values.push_back(sorted[sorted.size() / 2]);
    best.values.push_back(sorted.front());
  }
  for (const auto& [k, claims] : {std::pair{1U, &method.at_32}, {2U, &method.at_64}}) {
    const std::string text =
        fmt::format("{} error, {} cells a side, {}", quantities[q], cells.at(k), method.name);
    run.check(exact, fmt::format("{}, worst of {} clouds", text, clouds.at(k)), worst.values[k],
              (*claims)[q]);
    run.check(exact, text + ", median", median.values[k], reported());
  }
  run.check(method.order[q].criterion == Criterion::at_least ? exact : "does not converge",
            fmt::format("order of the {} error, 16 to 128 cells, {}", quantities[q], method.name),
            fit_order(columns.front().values, median.values).order, method.order[q]);
  for (CaseColumn* column : {&worst, &median, &best}) columns.push_back(std::move(*column));
}

void irregular_plates(CaseRun& run) {
  std::vector<CaseColumn> columns = {{"spacing", spacings_of(cells.size())}};
  for (const Method& method : methods()) {
    const auto errors = on_clouds(run, method.settings);
    for (std::size_t q = 0; q < quantities.size(); ++q)
      check_quantity(run, method, q, errors[q], columns);
  }
  run.table("plate", columns);
}

/// Regular particles: the correction must not cost what they have.
void lattices(CaseRun& run) {
  const std::vector<double> spacings = spacings_of(3);
  const auto study = [&](const Settings& settings) {
    return run.converge("plate.toml", with(settings, {"body.jitter=0"}), spacings);
  };
  const Settings cell = {"formulation=stress-point", "stabiliser.kind=cell",
                         "stabiliser.as=stiffness"};
  const ConvergenceTable points = study(cell);
  const ConvergenceTable corrected = study(with(cell, {"consistency=true"}));
  const ConvergenceTable collocated = study({});
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const Checks of_collocated(run, ", consistent, degrees (2, 1)");
    const Checks of_corrected(run, ", corrected stress points");
    const std::string share = fmt::format(
        "{} error over that of stress points, lattice of 64 cells a side", quantities[q]);
    const double best = points.rows.back().errors[q];
    of_collocated("stress points", share, collocated.rows.back().errors[q] / best, at_most(2.5));
    of_corrected("stress points", share, corrected.rows.back().errors[q] / best,
                 relative(1.0, 0.1));
    const std::string order = fmt::format("order of the {} error, lattice", quantities[q]);
    of_corrected(exact, order, corrected.fits[q].fit.order, at_least(1.95));
    of_collocated(exact, order, collocated.fits[q].fit.order, at_least(1.95));
  }
}

/// Largest acceleration that a constant stress with its own tractions causes, over |P|/(ρΔ).
template <int D>
double false_acceleration(const Scene& scene) {
  const Discretisation<D> body = build<D>(scene);
  double worst = 0.0;
  for (int component = 0; component < D * D; ++component) {
    TensorField<D> P = TensorField<D>::Zero(body.points.size(), D * D);
    P.col(component).setOnes();
    VectorField<D> f(body.nodes(), D);
    body.divergence.divergence(P, f);
    f.col(component / D) += body.particles.B.col(component % D);
    for (Index q = 0; q < body.nodes(); ++q)
      worst = std::max(worst, f.row(q).norm() / body.mass[q]);
  }
  return worst * scene.materials.front().density * body.spacing;
}

void constant_stress(CaseRun& run) {
  for (const auto& [method, claim] :
       {std::pair{"consistent", at_most(1e-9)}, {"variational", reported()}}) {
    const Settings settings = {fmt::format("formulation={}", method)};
    const auto check = [&, &claim = claim, &method = method](const char* body, double seen) {
      run.check("equilibrium of constant stress",
                fmt::format("acceleration over |P|/(ρΔ), {}, {}", body, method), seen, claim);
    };
    check("disc with a hole", false_acceleration<2>(run.read("ring.toml", settings)));
    check("bar", false_acceleration<1>(run.read("bar.toml", settings)));
  }
}

/// A free body on irregular particles flies, turns and vibrates.
void momenta(CaseRun& run) {
  constexpr const char* source = "objective energy, G 1 = 0, G X = I";
  const Settings rubber = {"material.law=neo-hookean"};
  const Settings thrown = with(
      rubber, {"time.end=0.5",
               "initial.velocity={constant=[1.0, -2.0], gradient=[[2.0, 1.0], [-3.0, -1.5]]}"});
  const auto drift = [&](const std::string& of, double seen, const Claim& claim) {
    run.check(source, "drift of " + of, seen, claim);
  };
  const Summary flight =
      run.scene("flight", "ring.toml", with(thrown, {"stabiliser.as=stiffness"})).summary;
  drift("linear momentum, disc with a hole", flight.linear_momentum_drift, at_most(1e-12));
  drift("angular momentum, disc with a hole", flight.angular_momentum_drift, at_most(1e-12));
  const Summary damped =
      run.scene("damped", "ring.toml", with(thrown, {"stabiliser.as=viscosity"})).summary;
  drift("angular momentum, disc with a hole, stabiliser as viscosity",
        damped.angular_momentum_drift, reported());
  const Summary shot = run.scene("shot", "bar.toml",
                                 {"boundary=[]", "reference.exact=none",
                                  "initial.velocity={constant=[1.0], gradient=[[20.0]]}"})
                           .summary;
  drift("linear momentum, bar", shot.linear_momentum_drift, at_most(1e-12));

  const Discretisation<2> ring = build<2>(run.read("ring.toml", rubber));
  const double angle = 2.4;
  Tensor<2> H;
  H << std::cos(angle) - 1, -std::sin(angle), std::sin(angle), std::cos(angle) - 1;
  State<2> state =
      make_state<2>(ring, ring.particles.X * H.transpose(), VectorField<2>::Zero(ring.nodes(), 2));
  evaluate<2>(ring, state);
  run.check(source, "stress over Young's modulus, disc with a hole, turned by 137 degrees",
            state.P.cwiseAbs().maxCoeff() / 1e6, at_most(1e-12));
}

/// The viscous matrix counts: a run just below the computed step stays, one just above does not.
void step_limits(CaseRun& run) {
  constexpr const char* source = "computed critical step";
  for (const auto& [degrees, action] :
       {std::pair{"[1, 1]", "viscosity"}, {"[2, 1]", "stiffness"}}) {
    const Settings settings = {std::string("consistency=") + degrees,
                               std::string("stabiliser.as=") + action, "time.allow_unstable=true",
                               "body.spacing=0.015625"};
    const double critical =
        run.scene("step", "plate.toml", with(settings, {"time.end=2e-4"})).summary.dt_critical;
    for (const double share : {0.99, 1.03}) {
      const CaseScene end = run.scene(
          "limit", "plate.toml",
          with(settings, {"time.end=3e-2", fmt::format("time.step={:.17g}", share * critical)}));
      // A run that is ended for its growth counts as an error beyond all others (JSON has no
      // infinity).
      const double error =
          end.failed_at ? std::numeric_limits<double>::max() : end.summary.errors->displacement;
      run.check(source,
                fmt::format("displacement error after 30 ms at {} of the critical step, 64 cells a "
                            "side, degrees {}",
                            share, degrees),
                error, share < 1.0 ? at_most(5e-3) : at_least(1e3));
    }
  }
}

void bars(CaseRun& run) {
  constexpr const char* source = "d'Alembert";
  const std::vector<double> spacings = {5e-4, 2.5e-4, 1.25e-4};
  const ConvergenceTable table = run.converge("bar.toml", {}, spacings);
  run.check(source, "order of the stress error, bar, consistent", table.fits[2].fit.order,
            absolute(2.0, 0.1));
  run.check(source, "stress error, bar of 1200 cells, consistent", table.rows.back().errors[2],
            at_most(1.5e-3));
  const ConvergenceTable plain = run.converge("bar.toml", {"formulation=variational"}, spacings);
  run.check(source, "stress error, bar of 1200 cells, variational", plain.rows.back().errors[2],
            reported());
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
