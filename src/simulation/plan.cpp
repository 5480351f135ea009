#include <fmt/format.h>

#include <cmath>

#include "tlsph/dynamics/critical_step.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/builder.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

std::string operator_line(const char* name, Index rows, Index cols, Index nonzeros,
                          const char* what) {
  return fmt::format("  {:<3} {:>9} x {:<9} {:>10} entries   {}\n", name, rows, cols, nonzeros,
                     what);
}

template <int D>
std::string plan_in(const Scene& scene) {
  const Discretisation<D> disc = build<D>(scene);
  InitialState<D> initial = build_initial<D>(scene, disc);
  (void)build_exact<D>(scene, disc);
  State<D> state =
      make_state<D>(disc, std::move(initial.displacement), std::move(initial.velocity));
  evaluate<D>(disc, state);
  const CriticalStep critical = critical_step<D>(disc, state);
  const double dt = scene.time.step.value_or(scene.time.safety * critical.dt);
  const double steps = std::ceil(scene.time.end / dt);

  std::string text;
  if (!scene.title.empty()) text += scene.title + "\n";
  text += fmt::format(
      "{} in {}D: {} particles{}, {} material points, spacing {:.4g} m\n",
      name_of(scene.formulation), D, disc.nodes(),
      disc.ghosts ? fmt::format(" and {} ghosts", disc.ghosts->lattice().ghosts()) : std::string(),
      disc.points.size(), disc.spacing);
  text += scene.kernel.support ? fmt::format("kernel {}, support {} spacings\n",
                                             scene.kernel.family, *scene.kernel.support)
                               : std::string(disc.particles.triangles.empty()
                                                 ? "gradients from the nodes of each cell\n"
                                                 : "gradients from the triangles beside each "
                                                   "edge\n");
  if (!scene.body.cloud.empty()) text += fmt::format("points of {}\n", scene.body.cloud);
  if (!disc.particles.triangles.empty())
    text += fmt::format("triangles between them: {}\n", disc.particles.triangles.size());
  text += "operators\n";
  const VectorOperator<D>& G = disc.ghosts ? disc.ghosts->plain_gradient() : disc.gradient;
  text += operator_line("G", G.rows(), G.cols(), G.nonzeros(),
                        D == 1 ? "gradient" : "gradient, all directions together");
  text += operator_line("D", disc.divergence.rows(), disc.divergence.cols(),
                        disc.divergence.nonzeros(), disc.adjoint ? "force, -G'V" : "force, V X");
  if (disc.stiffness.nonZeros() > 0)
    text += operator_line("S", disc.stiffness.rows(), disc.stiffness.cols(),
                          disc.stiffness.nonZeros(), "stabiliser, as stiffness");
  if (disc.viscosity.nonZeros() > 0)
    text += operator_line("C", disc.viscosity.rows(), disc.viscosity.cols(),
                          disc.viscosity.nonZeros(), "stabiliser, as viscosity");
  if (disc.ghosts) {
    const SparseMatrix& W = disc.ghosts->kernel_matrix();
    text += operator_line("W", W.rows(), W.cols(), W.nonZeros(), "kernel, with ghosts");
    for (const std::string& line : disc.ghosts->report()) text += "  " + line + "\n";
  }
  text += fmt::format("boundary: {} components held, {} moved, {} loads\n",
                      disc.constraints.fixed.size() + disc.constraints.held.size(),
                      disc.constraints.moved.size(), disc.loads.size());
  text += fmt::format(
      "time step {:.4e} s (critical {:.4e} s = {:.3f} spacings/c_p), {:.0f} steps to "
      "{:.4g} s\n",
      dt, critical.dt, critical.scaled, steps, scene.time.end);
  if (critical.growth)
    text += fmt::format("largest growth rate of a free motion {:.2e} c_p/spacing\n",
                        *critical.growth * disc.spacing / disc.wave_speed());
  text += fmt::format("memory about {:.3g} MB\n",
                      estimated_bytes(scene, static_cast<double>(disc.nodes())) * 1e-6);
  return text;
}

}  // namespace

Plan plan(const Scene& scene) {
  return {scene.dimension == 1 ? plan_in<1>(scene) : plan_in<2>(scene)};
}

}  // namespace tlsph
