// Corrected SPH: what the corrections reproduce, and which pairs of operators keep momentum.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "kernel_corrections.hpp"
#include "list.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/stepping/stepper.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

constexpr double round_off = 1e-12;

PlainGradient plain(const VectorOperator<2>& G) {
  return {G.matrix(0), G.matrix(1)};
}

/// The gradient of constants and of linear fields, at every particle of a cloud with boundary.
void conditions(CaseRun& run) {
  const Scene scene = run.read("disc.toml");
  const auto particles = build_particles<2>(scene);
  const AnyKernel kernel = *kernel_by_name(scene.kernel.family);
  const double h = *scene.kernel.support * particles.spacing;
  const auto corrected = [&](Correction correction) {
    return plain(collocated_gradient<2>(kernel, h, particles.X, particles.V, correction));
  };
  const LinearKernel linear = linear_kernel(kernel, h, particles);
  struct Row {
    const char* source;
    const char* name;
    PlainGradient G;
    bool constants;  // what it must reproduce
    bool linears;
  };
  const std::vector<Row> rows = {
      {"(40)", "none", corrected(Correction::none), true, false},
      {"(42)–(45)", "gradient", corrected(Correction::gradient), true, true},
      {"(46)–(52)", "linear kernel", linear.gradient, true, true},
      {"(53)", "constant kernel", shepard_gradient(kernel, h, particles), true, false},
      {"(54)–(58)", "mixed", corrected(Correction::mixed), true, true},
      {"(57)", "constant kernel as printed", shepard_gradient(kernel, h, particles, Gamma::nothing),
       false, false},
      {"(41)", "least squares", corrected(Correction::least_squares), true, true}};
  std::vector<CaseColumn> table = {{"constant"}, {"linear"}};
  for (const Row& row : rows) {
    const std::string source = fmt::format("Bonet & Lok, {}", row.source);
    const double constants = constant_residual(row.G, particles);
    const double linears = linear_residual(row.G, particles).maxCoeff();
    const Checks check(run, fmt::format(", correction {}", row.name));
    check(source, "gradient of a constant, times Δ", constants,
          row.constants ? at_most(round_off) : reported(0.0));
    check(source, "residual of (41)", linears, row.linears ? at_most(round_off) : reported(0.0));
    add_row(table, {constants, linears});
  }
  const ScalarField sum = linear.value * ScalarField::Ones(particles.size());
  const VectorField<2> moved = linear.value * particles.X;
  run.check("Bonet & Lok, (49)", "Σ V W̃ − 1, linear kernel", (sum.array() - 1).abs().maxCoeff(),
            at_most(round_off));
  run.check("Bonet & Lok, (50)", "Σ V W̃ (x − x_b), linear kernel [m]",
            (moved - particles.X).cwiseAbs().maxCoeff(), at_most(round_off));
  run.table("residuals", table);
  run.table("cloud", {{"x", particles.X.col(0)},
                      {"y", particles.X.col(1)},
                      {"residual", linear_residual(rows.front().G, particles)}});
}

/// A gradient and the force operator that goes with it, or does not.
struct Pair {
  std::string name;
  Discretisation<2> body;
  bool linear_momentum;  // must be kept
  bool angular_momentum;
};

std::vector<Pair> pairs(CaseRun& run) {
  const auto consistent = [&](const char* correction) {
    return build<2>(run.read("disc.toml", {fmt::format("kernel.correction={}", correction)}));
  };
  std::vector<Pair> result = {
      {"consistent, gradient", consistent("gradient"), true, true},
      {"consistent, mixed", consistent("mixed"), true, true},
      {"consistent, least squares", consistent("least-squares"), true, true},
      {"consistent, none", consistent("none"), true, false}};
  Pair foreign{"G gradient, D of none", consistent("gradient"), true, false};
  foreign.body.divergence = result.back().body.divergence;
  // The plain sum Σ V_a V_b P_b ∇W, as of a body whose stress ends at its surface.
  Pair strong{"G mixed, D = VX", consistent("mixed"), false, false};
  const Scene scene = run.read("disc.toml");
  const Particles<2>& particles = strong.body.particles;
  strong.body.divergence =
      plain_gradient<2>(*kernel_by_name(scene.kernel.family),
                        *scene.kernel.support * particles.spacing, particles.X, particles.V)
          .row_scaled(particles.V);
  for (Pair* pair : {&foreign, &strong}) {
    pair->body.adjoint = false;
    result.push_back(std::move(*pair));
  }
  return result;
}

/// How much of both momenta is lost in a run, over time.
std::vector<CaseColumn> drift(CaseRun& run, const Discretisation<2>& body, double dt) {
  const Scene scene = run.read("disc.toml");
  const auto initial = build_initial<2>(scene, body);
  std::vector<CaseColumn> result = {{"time"}, {"linear"}, {"angular"}};
  try {
    Stepper<2> stepper(body, initial.displacement, initial.velocity,
                       {.step = dt, .sweep = false, .balance_every = 0});
    stepper.evaluate();
    const Balance<2> first = balance<2>(stepper.instant());
    const auto steps = static_cast<long>(scene.time.end / dt);
    for (long n = 0; n <= steps; ++n) {
      stepper.evaluate();
      const Balance<2> now = balance<2>(stepper.instant());
      add_row(result,
              {stepper.state().time,
               (now.linear_momentum - first.linear_momentum).norm() / first.momentum_scale,
               std::abs(now.angular_momentum - first.angular_momentum) / first.angular_scale});
      stepper.step();
    }
  } catch (const NumericalError&) {
    // A pair without an energy may end in det F ≤ 0; what it lost until then has been recorded.
  }
  return result;
}

/// Largest |f + ∂U/∂u| over some degrees of freedom, relative to the largest force, by a central
/// difference of fourth order at a deformed state.
double force_error(const Discretisation<2>& body) {
  const double step = 1e-3 * body.spacing;
  VectorField<2> u(body.nodes(), 2);
  std::mt19937_64 random(7);
  const auto noise = [&] { return 2.0 * std::ldexp(static_cast<double>(random() >> 11), -53) - 1; };
  for (Index q = 0; q < body.nodes(); ++q) {
    const Vector<2> X = body.particles.X.row(q).transpose();
    u.row(q) << 0.05 * X[0] * X[1] + 0.02 * body.spacing * noise(),
        0.08 * X[0] - 0.04 * X[1] + 0.02 * body.spacing * noise();
  }
  State<2> state = make_state<2>(body, u, VectorField<2>::Zero(body.nodes(), 2));
  const auto energy = [&](Index dof, double shift) {
    state.u = u;
    state.u.data()[dof] += shift;
    evaluate<2>(body, state);
    return elastic_energy<2>(body, state);
  };
  evaluate<2>(body, state);
  const VectorField<2> force = state.f;
  double worst = 0.0;
  for (Index dof = 0; dof < force.size(); dof += force.size() / 40) {
    const double slope = (8 * (energy(dof, step) - energy(dof, -step)) -
                          (energy(dof, 2 * step) - energy(dof, -2 * step))) /
                         (12 * step);
    worst = std::max(worst, std::abs(force.data()[dof] + slope));
  }
  return worst / force.cwiseAbs().maxCoeff();
}

void momenta(CaseRun& run) {
  const auto all = pairs(run);
  // One step for all: half of what the first pair allows.
  const Discretisation<2>& first = all.front().body;
  const double dt = 0.5 * critical_step<2>(first, state_at_rest<2>(first)).dt;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Pair& pair = all[k];
    const std::vector<CaseColumn> lost = drift(run, pair.body, dt);
    const Checks check(run, ", " + pair.name);
    for (const auto& [column, kept] :
         {std::pair{1U, pair.linear_momentum}, {2U, pair.angular_momentum}})
      check("Bonet & Lok, sec. 3", lost[column].name + " momentum lost, of its scale",
            std::ranges::max(lost[column].values), kept ? at_most(round_off) : at_least(1e-4));
    check("Bonet & Lok, sec. 2", "|f + ∂U/∂u|, of the largest force", force_error(pair.body),
          pair.body.adjoint ? at_most(1e-9) : at_least(1e-3));
    run.table(fmt::format("pair{}", k), lost);
  }
}

}  // namespace

void corrections(CaseRun& run) {
  conditions(run);
  momenta(run);
}

}  // namespace tlsph
