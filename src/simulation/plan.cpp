#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "advice.hpp"
#include "in_scene.hpp"
#include "memory.hpp"
#include "preflight.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/operators/consistency.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/stepping/critical_step.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {
namespace {

std::string operator_line(const char* name, Index rows, Index cols, Index nonzeros,
                          const char* what) {
  return fmt::format("  {:<3} {:>9} x {:<9} {:>10} entries   {}\n", name, rows, cols, nonzeros,
                     what);
}

/// A plan does not wait longer than this for a factorisation [s].
constexpr double longest_correction = 20.0;
/// Passes over the factor in the solves that follow a factorisation, and bytes read a second.
constexpr double passes = 12.0, bandwidth = 8e9;

/// What the correction of the gradient takes.
struct CorrectionCost {
  FactorCost factor;
  double seconds = 0.0;
};

template <int D>
std::optional<CorrectionCost> correction_cost(const Scene& scene) {
  if (!scene.consistency) return std::nullopt;
  const Discretisation<D> body = build<D>(scene, Gradients::fitted);
  CorrectionCost cost;
  cost.factor = consistency_cost<D>(body.gradient, body.points, body.particles,
                                    {scene.consistency->rows, scene.consistency->columns});
  cost.seconds = D * (cost.factor.flops / factorisation_speed() +
                      passes * 8.0 * cost.factor.entries / bandwidth);
  return cost;
}

std::string correction_line(const Scene& scene, const CorrectionCost& cost, int directions) {
  return fmt::format(
      "consistency to degrees ({}, {}): {} unknowns, {:.3g} entries in the factor, {} x {:.3g} "
      "operations: about {:.2g} s on one core, {:.3g} MB\n",
      scene.consistency->rows, scene.consistency->columns, cost.factor.rows, cost.factor.entries,
      directions, cost.factor.flops, cost.seconds, cost.factor.bytes * 1e-6);
}

/// Steps and the time they cover; without an adjoint what may grow.
struct Steps {
  std::string text;
  double critical = 0.0;  ///< [s]; 0: not known
  double number = 0.0;
};

template <int D>
Steps steps_of(const Scene& scene, const Discretisation<D>& body, State<D>& state) {
  InitialState<D> initial = build_initial<D>(scene, body);
  (void)build_exact<D>(scene, body);
  const std::vector<std::string> warnings = start_jumps<D>(scene, body, initial);
  state = make_state<D>(body, std::move(initial.displacement), std::move(initial.velocity));
  evaluate<D>(body, state);
  const CriticalStep critical = critical_step<D>(body, state);
  const double dt = checked_step(scene, critical);
  Steps steps{"", critical.dt, std::ceil(scene.time.end / dt)};
  steps.text = fmt::format(
      "time step {:.4e} s (critical {:.4e} s = {:.3f} spacings/c_p), {:.0f} steps to "
      "{:.4g} s\n",
      dt, critical.dt, critical.scaled, steps.number, scene.time.end);
  for (const std::string& warning : warnings) steps.text += fmt::format("warning: {}\n", warning);
  if (critical.growth)
    steps.text += fmt::format("largest growth rate of a free motion {:.2e} c_p/spacing\n",
                              *critical.growth * body.spacing / body.wave_speed());
  return steps;
}

/// Code and tables of the libraries that write a run's files [bytes].
constexpr double output_libraries = 7.5e6;

/// The most that is resident in a run [bytes]. Its set-up was made here, in the same order, and is
/// measured; steps and output come to that.
template <int D>
double run_bytes(const Scene& scene, const Discretisation<D>& body,
                 const std::optional<CorrectionCost>& missing) {
  const double setup = memory_status("VmHWM:");
  const double now = memory_status("VmRSS:");
  if (missing) return std::max(setup, now + missing->factor.bytes);
  const auto nodes = static_cast<double>(body.nodes());
  const auto points = static_cast<double>(body.points.size());
  const double follower = scene.time.step || body.linear() ? 0.0 : 2.0 * 4.0 * D * D * points;
  // Tags, cells and positions of the nodes in space, when run.h5 is made; later a frame.
  const double start = nodes * (8.0 + 8.0 * 3.0 + 4.0) + points * 4.0 * (1 << D);
  return std::max(setup,
                  now + output_libraries + follower + std::max(start, frame_bytes<D>(scene, body)));
}

/// What a named box holds.
template <int D>
std::string tag_line(const NamedBox& tag, const Particles<D>& particles) {
  const Patch<D>& patch = *particles.find(tag.name);
  const std::size_t nodes = patch.nodes.size();
  const std::string held = fmt::format("{} particle{}", nodes, nodes == 1 ? "" : "s");
  if (D == 1) return fmt::format("  tag {}: {}\n", tag.name, held);
  return fmt::format("  tag {}: {}, {:.6g} m of the boundary\n", tag.name, held,
                     patch_extent(patch));
}

template <int D>
std::string plan_in(const Scene& scene) {
  forget_peak_memory();
  const std::optional<CorrectionCost> correction = correction_cost<D>(scene);
  const bool patient = !correction || correction->seconds <= longest_correction;
  const Discretisation<D> body =
      build<D>(scene, patient ? Gradients::corrected : Gradients::fitted);

  State<D> state;
  Steps steps{"time step: known once the gradient is corrected, in a run\n"};
  if (patient) steps = steps_of<D>(scene, body, state);

  std::string text;
  if (!scene.title.empty()) text += scene.title + "\n";
  text += fmt::format(
      "{} in {}D: {} particles{}, {} material points, spacing {:.4g} m{}\n",
      name_of(scene.formulation), D, body.nodes(),
      body.ghosts ? fmt::format(" and {} ghosts", body.ghosts->lattice().ghosts()) : std::string(),
      body.points.size(), body.spacing,
      scene.body.spacing > 0.0 ? "" : ", estimated from the points");
  text += scene.kernel.support ? fmt::format("kernel {}, support {} spacings\n",
                                             scene.kernel.family.get(), *scene.kernel.support)
                               : std::string(body.particles.triangles.empty()
                                                 ? "gradients from the nodes of each cell\n"
                                                 : "gradients from the triangles beside each "
                                                   "edge\n");
  if (!scene.body.cloud.empty()) text += fmt::format("points of {}\n", scene.body.cloud);
  if (!body.particles.triangles.empty())
    text += fmt::format("triangles between them: {}\n", body.particles.triangles.size());
  text += "operators\n";
  const VectorOperator<D>& G = body.ghosts ? body.ghosts->plain_gradient() : body.gradient;
  text += operator_line("G", G.rows(), G.cols(), G.nonzeros(),
                        D == 1 ? "gradient" : "gradient, all directions together");
  text += operator_line("D", body.divergence.rows(), body.divergence.cols(),
                        body.divergence.nonzeros(), body.adjoint ? "force, -G'V" : "force, V X");
  if (!body.hourglass.empty())
    text += operator_line("A", body.gradient.rows(), body.gradient.cols(),
                          static_cast<Index>(body.hourglass.weights.size()),
                          "stabiliser, as stiffness A'KA");
  if (body.stiffness.nonZeros() > 0)
    text += operator_line("S", body.stiffness.rows(), body.stiffness.cols(),
                          body.stiffness.nonZeros(), "stabiliser, as stiffness");
  if (body.viscosity.nonZeros() > 0)
    text += operator_line("C", body.viscosity.rows(), body.viscosity.cols(),
                          body.viscosity.nonZeros(), "stabiliser, as viscosity");
  if (body.ghosts) {
    const SparseMatrix& W = body.ghosts->kernel_matrix();
    text += operator_line("W", W.rows(), W.cols(), W.nonZeros(), "kernel, with ghosts");
    for (const std::string& line : body.ghosts->report()) text += "  " + line + "\n";
  }
  if (Sweep<D>::possible(body)) {
    const Sweep<D> sweep(body);
    const StorageReport storage = sweep.storage();
    text += fmt::format(
        "storage: {} rows in {} stencils, {} rows of their own, {:.1f} bytes a particle and step\n",
        storage.stencil_rows, storage.distinct_stencils, storage.general_rows,
        storage.bytes / static_cast<double>(body.nodes()));
    if (const auto multiply_adds = sweep.stiffness_multiply_adds())
      text +=
          fmt::format("steps by one product with the stiffness, {:.0f} multiply-adds a particle\n",
                      *multiply_adds);
  }
  const double memory = run_bytes<D>(scene, body, patient ? std::nullopt : correction);
  text += fmt::format("boundary: {} components held, {} moved, {} loads\n",
                      body.constraints.fixed.size() + body.constraints.held.size(),
                      body.constraints.moved.size(), body.loads.size());
  for (const NamedBox& tag : scene.body.tags) text += tag_line<D>(tag, body.particles);
  for (const LoadedPatch& load : loaded_patches<D>(scene, body)) text += "  " + load.text() + "\n";
  if (correction) text += correction_line(scene, *correction, D);
  text += steps.text;
  text += fmt::format("memory about {:.3g} MB\n", 1e-6 * memory);
  for (const std::string& warning : warnings<D>(scene, body)) text += "warning: " + warning + "\n";
  const std::string spare = advise_reduction(scene, body.nodes()) + advise_law(scene) +
                            advise_support<D>(scene, body, steps.critical) +
                            advise_output<D>(scene, body, steps.number);
  if (!spare.empty()) text += "it could do without\n" + spare;
  return text;
}

}  // namespace

Plan plan(const Scene& scene) {
  return {in_scene(scene, [&] {
    return in_dimension(scene.dimension, [&]<int D>() { return plan_in<D>(scene); });
  })};
}

}  // namespace tlsph
