// One kernel for strains, another for stresses, and the mixed Hu-Washizu form.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "list.hpp"
#include "tlsph/analysis/history.hpp"
#include "tlsph/analysis/spectrum.hpp"
#include "tlsph/contrast/growth.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/products.hpp"
#include "tlsph/stepping/stepper.hpp"
#include "vibration.hpp"

namespace tlsph {
namespace {

/// The kernels of the Cranfield thesis, table 3, with its smoothing length 1.2 Δ.
constexpr std::array<std::string_view, 3> families = {"quadratic", "cubic-spline", "wendland-c2"};
constexpr double support = 2.4;

AnyKernel kernel(std::string_view family) {
  return *kernel_by_name(family);
}

// A fluid as in the source, in units of spacing, speed of sound and density.
constexpr double tension_of_unit = 0.05;  ///< σ₀/(ρc²)
constexpr int along = 61, across = 21;    ///< particles
constexpr int held = 3;                   ///< layers at every edge
constexpr double dt = 0.25, end = 36.0;
constexpr double fit_from = 1e3, fit_to = 1e7;  ///< kinetic energy, of the first

StressedLattice<2> lattice_of(const AnyKernel& kernel) {
  return {kernel, support, 1.0, {1.0, 0.0}, 1.0, tension_of_unit};
}

/// The wave that grows fastest: k = (π, 0), neighbouring columns against each other. There every
/// gradient vanishes, whatever its kernel.
double growth_in_tension(const AnyKernel& stress_kernel) {
  return growth_rate<2>(lattice_of(stress_kernel), Vector<2>(std::numbers::pi, 0.0));
}

/// The lattice with that wave as its velocity.
CurrentRun<2> pushed(const AnyKernel& kernel) {
  CurrentRun<2> result = current_lattice<2>(lattice_of(kernel), {along, across}, held);
  for (int q = 0; q < along * across; ++q)
    result.state.v(q, 0) = (q / across % 2 == 0 ? 1e-10 : -1e-10) * result.body.motion(q, 0);
  return result;
}

struct Growth : EnergyHistory {
  double rate = 0.0;  ///< of the velocity
};

/// Runs with `accelerate` in the place of the body's own acceleration; rates of density and stress
/// are those of the body.
template <class Accelerate>
Growth grow(CurrentRun<2> run, const Accelerate& accelerate) {
  const CurrentBody<2>& body = run.body;
  CurrentState<2>& state = run.state;
  Growth result;
  while (state.time < end - 0.5 * dt) {
    // `advance` kicks with the body's own acceleration: what it adds is taken off beforehand.
    const VectorField<2> excess = accelerate(state) - acceleration<2>(body, state);
    state.v += dt * body.motion.cwiseProduct(excess);
    advance<2>(body, state, dt);
    result.time.push_back(state.time);
    result.energy.push_back(kinetic_energy<2>(body, state));
  }
  const double first = result.energy.front();
  result.rate = 0.5 * growth_rate(result.time, result.energy, fit_from * first, fit_to * first);
  return result;
}

/// Σ_j W_B / Σ_j W_A over the lattice: what the mixed form makes of a constant.
double share_of_constant(const AnyKernel& of, const AnyKernel& from) {
  const auto sum = [](const AnyKernel& each) {
    return std::visit(
        [](const auto& family) {
          double total = 0.0;
          for (int i = -3; i <= 3; ++i)
            for (int j = -3; j <= 3; ++j)
              total += kernel_value<2>(family, std::hypot(i, j), support);
          return total;
        },
        each);
  };
  return sum(of) / sum(from);
}

/// Stress through the mixed form, solved with one kernel and interpolated with another, at the
/// current positions, as a field.
TensorField<2> passed(const TensorField<2>& stress, const VectorField<2>& x, const AnyKernel& solve,
                      const AnyKernel& interpolate) {
  const ScalarField one = ScalarField::Ones(x.rows());
  const Cholesky factor(kernel_matrix<2>(solve, support, x, one));
  const Eigen::MatrixXd g = factor.solve(Eigen::MatrixXd(stress));
  return kernel_matrix<2>(interpolate, support, x, one) * g;
}

/// The same for a state near the uniform tension σ₀, which becomes what it does in the inside of a
/// body; at its edges the incomplete sums would make forces of the order of σ₀.
CurrentState<2> assumed(const CurrentState<2>& state, const CurrentState<2>& rest,
                        const AnyKernel& solve, const AnyKernel& interpolate) {
  CurrentState<2> result = state;
  result.stress = share_of_constant(interpolate, solve) * rest.stress +
                  passed(TensorField<2>(state.stress - rest.stress), state.x, solve, interpolate);
  return result;
}

/// Figs 4-4, 4-5, 8-5, 8-6: the tensile instability under pairs of kernels.
void tension(CaseRun& run) {
  constexpr double tolerance = 0.03;
  std::vector<CaseColumn> table;
  const auto keep = [&](const std::string& name, const Growth& growth) {
    if (table.empty()) table.emplace_back("time", growth.time);
    table.emplace_back(name, growth.energy);
  };
  double basic = 0.0;  // of the cubic spline for both
  for (const auto strain : families)
    for (const auto stress : families) {
      const CurrentRun<2> own = pushed(kernel(strain));
      const CurrentBody<2> other = pushed(kernel(stress)).body;
      const Growth growth =
          grow(own, [&](const CurrentState<2>& state) { return acceleration<2>(other, state); });
      run.check("Cranfield thesis, Fig. 4-5",
                fmt::format("growth in tension, current configuration, strain {}, stress {}: "
                            "√(2σ₀C/ρ) of the stress kernel [c/Δ]",
                            strain, stress),
                growth.rate, relative(growth_in_tension(kernel(stress)), tolerance));
      keep(fmt::format("{} {}", strain, stress), growth);
      if (strain == "cubic-spline" && stress == strain) basic = growth.rate;
    }
  const AnyKernel cubic = kernel("cubic-spline");
  const CurrentRun<2> own = pushed(cubic);
  const CurrentBody<2>& body = own.body;
  const CurrentState<2>& rest = own.state;
  for (const auto& [family, figure] :
       {std::pair{"cubic-spline", "8-4"}, std::pair{"quadratic", "8-5"},
        std::pair{"wendland-c2", "8-6"}}) {
    const AnyKernel secondary = kernel(family);
    const Growth growth = grow(own, [&](const CurrentState<2>& state) {
      return acceleration<2>(body, assumed(state, rest, cubic, secondary));
    });
    CurrentState<2> whole = rest;
    whole.stress = passed(rest.stress, rest.x, cubic, secondary);
    run.check(fmt::format("Cranfield thesis, Fig. {}", figure),
              fmt::format("acceleration of the free part at rest, mixed form, secondary {} "
                          "[σ₀/(ρΔ)]",
                          family),
              acceleration<2>(body, whole).cwiseProduct(body.motion).cwiseAbs().maxCoeff() /
                  tension_of_unit,
              reported(0.0));
    run.check(fmt::format("Cranfield thesis, Fig. {}", figure),
              fmt::format("growth in tension, mixed form, secondary {}, of that of the basic "
                          "form: √(ΣW_B/ΣW_A)",
                          family),
              growth.rate / basic, relative(std::sqrt(share_of_constant(secondary, cubic)), 5e-3));
    keep(fmt::format("mixed {}", family), growth);
  }
  run.table("tension", table);
}

/// The strong form of Hu and Washizu, (8.61): W_ij V_j α_j = D_i is solved for α, and the field is
/// interpolated from α again. K = W V⁻¹ is symmetric, and g = V α its unknown.
class MixedForm {
 public:
  MixedForm(const AnyKernel& kernel, double h, const VectorField<2>& X)
      : K_(kernel_matrix<2>(kernel, h, X, ScalarField::Ones(X.rows()))), factor_(K_) {}

  [[nodiscard]] TensorField<2> pass(const TensorField<2>& field) const {
    const Eigen::MatrixXd g = factor_.solve(Eigen::MatrixXd(field));
    return K_ * g;
  }
  [[nodiscard]] const SymmetricOrGeneral& factor() const { return factor_; }

 private:
  SparseMatrix K_;
  SymmetricOrGeneral factor_;
};

/// `evaluate`, with strain and stress passed through the mixed form.
void evaluate_mixed(const Discretisation<2>& discretisation, const MixedForm& form,
                    State<2>& state) {
  evaluate<2>(discretisation, state);
  state.H = form.pass(state.H);
  std::visit(
      [&](const auto& law) {
        for (Index s = 0; s < state.H.rows(); ++s) {
          const Tensor<2> P = law.pk1(tensor_at<2>(state.H, s));
          Eigen::Map<Tensor<2>>(state.P.row(s).data()) = P;
        }
      },
      discretisation.regions.front().law);
  state.P = form.pass(state.P);
  discretisation.divergence.divergence(state.P, state.f);
}

/// The same pairs as operators of the reference configuration.
void reference_pairs(CaseRun& run) {
  const auto base = build<2>(run.read("free_sheet.toml"));
  const double h = support * base.spacing;
  const double unit = base.spacing / base.wave_speed();
  std::vector<VectorOperator<2>> G;
  for (const auto family : families)
    G.push_back(collocated_gradient<2>(kernel(family), h, base.particles.X, base.particles.V,
                                       Correction::gradient));
  std::vector<CaseColumn> rates;
  for (const auto family : families) rates.emplace_back(std::string(family));
  for (std::size_t strain = 0; strain < families.size(); ++strain)
    for (std::size_t stress = 0; stress < families.size(); ++stress) {
      Discretisation<2> discretisation = base;
      discretisation.gradient = G[strain];
      discretisation.divergence = G[stress].negative_adjoint(discretisation.points.V);
      discretisation.adjoint = strain == stress;
      const double rate = growth_rate(eigenvalues(dynamical_matrix<2>(discretisation))) * unit;
      rates[stress].values.push_back(rate);
      const auto quantity =
          fmt::format("growth at rest in the reference configuration, strain {}, stress {} [c/Δ]",
                      families[strain], families[stress]);
      run.check("Cranfield thesis, sec. 4.2", quantity, rate,
                strain == stress ? at_most(1e-6) : at_least(1e-4));
    }
  run.table("pairs", rates);
}

/// Fig. 8-4: a run whose strains and stresses pass through the mixed form.
void reinterpolated(CaseRun& run) {
  const Scene scene = run.read("sheet.toml");
  const auto discretisation = build<2>(scene);
  const MixedForm form(kernel(scene.kernel.family), support * discretisation.spacing,
                       discretisation.particles.X);
  const auto initial = build_initial<2>(scene, discretisation);
  Stepper<2> basic(discretisation, initial.displacement, initial.velocity,
                   {.safety = 0.8, .adaptive = false, .sweep = false, .balance_every = 0});
  const double step = 0.8 * basic.critical().dt;
  Stepper<2> passed(discretisation, initial.displacement, initial.velocity,
                    {.step = step,
                     .balance_every = 0,
                     .evaluate = [&form](const Discretisation<2>& body, State<2>& state) {
                       evaluate_mixed(body, form, state);
                     }});
  std::vector<CaseColumn> table = {{"time"}, {"displacement"}, {"stress"}};
  const auto apart = [](const auto& field, const auto& reference) {
    return (field - reference).cwiseAbs().maxCoeff() / reference.cwiseAbs().maxCoeff();
  };
  const auto steps = static_cast<long>(scene.time.end / step);
  for (long n = 0; n < steps; ++n) {
    for (Stepper<2>* stepper : {&basic, &passed}) {
      stepper->step();
      stepper->evaluate();
    }
    const State<2>& state = basic.state();
    add_row(table,
            {state.time, apart(passed.state().u, state.u), apart(passed.state().P, state.P)});
  }
  const std::string source = "Cranfield thesis, Fig. 8-4";
  run.check(source, "displacement of the re-interpolated run, relative difference",
            std::ranges::max(table[1].values), at_most(1e-9));
  run.check(source, "stress of the re-interpolated run, relative difference",
            std::ranges::max(table[2].values), at_most(1e-9));
  run.check(source, "W V⁻¹ of the cubic spline is factorised by Cholesky (1: yes)",
            form.factor().chosen() == SolverChoice::cholmod ? 1.0 : 0.0, absolute(1.0, 0.0));
  run.check(source, "condition of W V⁻¹, an estimate from below",
            form.factor().condition_estimate(), reported());
  run.table("reinterpolated", table);
}

}  // namespace

void mixed_kernels(CaseRun& run) {
  tension(run);
  reference_pairs(run);
  reinterpolated(run);
}

}  // namespace tlsph
