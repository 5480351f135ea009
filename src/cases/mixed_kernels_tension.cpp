#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mixed_kernels.hpp"
#include "tlsph/analysis/motion_growth.hpp"
#include "tlsph/contrast/current_lattice.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/operators/gradients.hpp"

namespace tlsph::mixed {
namespace {

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

struct Growth {
  std::vector<double> time, energy;
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

}  // namespace

void tension(CaseRun& run) {
  constexpr double tolerance = 0.03;
  std::vector<std::string> columns = {"time"};
  std::vector<std::vector<double>> lists(1);
  const auto keep = [&](const std::string& name, const Growth& growth) {
    lists[0] = growth.time;
    columns.push_back(name);
    lists.push_back(growth.energy);
  };
  double basic = 0.0;  // of the cubic spline for both
  for (const auto strain : families)
    for (const auto stress : families) {
      const CurrentRun<2> own = pushed(kernel(strain));
      const CurrentBody<2> other = pushed(kernel(stress)).body;
      const Growth growth =
          grow(own, [&](const CurrentState<2>& state) { return acceleration<2>(other, state); });
      run.relative("Cranfield thesis, Fig. 4-5",
                   fmt::format("growth in tension, current configuration, strain {}, stress {}: "
                               "√(2σ₀C/ρ) of the stress kernel [c/Δ]",
                               strain, stress),
                   growth_in_tension(kernel(stress)), growth.rate, tolerance);
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
    run.report(fmt::format("Cranfield thesis, Fig. {}", figure),
               fmt::format("acceleration of the free part at rest, mixed form, secondary {} "
                           "[σ₀/(ρΔ)]",
                           family),
               acceleration<2>(body, whole).cwiseProduct(body.motion).cwiseAbs().maxCoeff() /
                   tension_of_unit,
               0.0);
    run.relative(fmt::format("Cranfield thesis, Fig. {}", figure),
                 fmt::format("growth in tension, mixed form, secondary {}, of that of the basic "
                             "form: √(ΣW_B/ΣW_A)",
                             family),
                 std::sqrt(share_of_constant(secondary, cubic)), growth.rate / basic, 5e-3);
    keep(fmt::format("mixed {}", family), growth);
  }
  run.table("tension", columns, lists);
}

}  // namespace tlsph::mixed
