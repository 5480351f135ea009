#include <fmt/format.h>

#include <cmath>

#include "parts.hpp"
#include "tlsph/boundary/mirror.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/operators/consistency.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/local_volumes.hpp"
#include "tlsph/operators/row_storage.hpp"
#include "tlsph/particles/moments.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

/// What integration by parts of the polynomials asks of the quadrature.
QuadratureDegrees moments_of(const ConsistencyScene& degrees) {
  return {degrees.rows + degrees.columns - 1, degrees.rows + degrees.columns};
}

AnyKernel kernel_of(const Scene& scene) {
  const auto kernel = kernel_by_name(scene.kernel.family);
  if (!kernel) throw InputError(scene.kernel.place, "no kernel of that name");
  return *kernel;
}

template <int D>
double tolerance_of(const Particles<D>& particles) {
  return shared_row_tolerance(particles.X.cwiseAbs().maxCoeff(), particles.spacing);
}

/// Natural boundaries: D = −GᵀV.
template <int D>
void add_adjoint_operators(const Scene& scene, Gradients gradients, Discretisation<D>& disc) {
  const Particles<D>& particles = disc.particles;
  const double h = scene.kernel.support.value_or(0.0) * particles.spacing;
  const Correction correction = scene.kernel.correction;
  if (is_collocated(scene.formulation) && correction != Correction::least_squares)
    disc.gradient =
        collocated_gradient<D>(kernel_of(scene), h, particles.X, particles.V, correction);
  else if (scene.kernel.support)
    disc.gradient =
        point_gradient<D>(kernel_of(scene), h, disc.points.X, particles.X, scene.kernel.order);
  else
    disc.gradient = cell_gradient<D>(particles, disc.points);
  stop_point();
  if (scene.consistency && gradients == Gradients::corrected) {
    auto corrected = consistent_gradient<D>(disc.gradient, disc.points, particles,
                                            {scene.consistency->rows, scene.consistency->columns},
                                            scene.consistency->place);
    disc.gradient = std::move(corrected.gradient);
    disc.consistency = corrected.residuals;
  }
  disc.gradient = std::move(disc.gradient).with_shared_rows(tolerance_of(disc.particles));
  disc.divergence = disc.gradient.negative_adjoint(disc.points.V);
}

/// Reactions of moved edges are m ü + Σ w P, each material point counted for the edge node across
/// from it. In `mirror` w = V ∂H/∂ū, the work of the stress in a unit motion of the edge, which
/// closes the balance of energy. In `thesis`, whose forces do no such work, w = Σ_q D_q, what of
/// a stress the forces of all nodes together have, which closes that of momentum.
template <int D>
void add_reactions_of_moved(const Edges<D>& edges, Discretisation<D>& disc) {
  const LatticeFrame<D>& frame = *disc.particles.frame;
  for (std::size_t b = 0; b < D; ++b)
    for (std::size_t side = 0; side < 2; ++side)
      for (int i = 0; i < D; ++i) {
        const std::size_t moving = edges[b][side].displacement[static_cast<std::size_t>(i)];
        if (moving == no_signal) continue;
        const auto across = [&](Index p) {
          auto at = frame.coordinates(static_cast<int>(p));
          at[b] = side == 0 ? 0 : frame.counts[b] - 1;
          return Index{frame.index(at)};
        };
        TensorField<D> w = TensorField<D>::Zero(disc.nodes(), D * D);
        if (disc.ghosts) {
          const Neighbours& rows = disc.divergence.pattern();
          for (std::size_t k = 0; k < rows.column.size(); ++k) {
            const int p = rows.column[k];
            const int at = frame.coordinates(p)[b];
            if ((2 * at < frame.counts[b]) == (side == 0))
              w(p, i * D + static_cast<int>(b)) +=
                  disc.divergence.weight(static_cast<Index>(k), static_cast<int>(b), i);
          }
        } else {
          VectorField<D> u = VectorField<D>::Zero(disc.nodes(), D);
          for (Index p = 0; p < disc.nodes(); ++p) u(across(p), i) = 1.0;
          disc.gradient.gradient(u, w);
          for (const SignalTerm& term : disc.gradient_terms)
            if (term.signal == moving) w.data()[term.slot] += term.weight;
          w.array().colwise() *= disc.points.V.array();
        }
        const double rounding = 1e-14 * w.cwiseAbs().maxCoeff();
        for (Index p = 0; p < disc.nodes(); ++p)
          for (Index slot = p * D * D; slot < (p + 1) * D * D; ++slot)
            if (std::abs(w.data()[slot]) > rounding)
              disc.reactions.push_back({across(p) * D + i, slot, w.data()[slot]});
      }
}

/// Boxes with ghosts: eliminated (`mirror`) or solved for each step (`thesis`).
template <int D>
void add_ghost_operators(const Scene& scene, Discretisation<D>& disc) {
  const Edges<D> edges = parts::build_edges<D>(scene, disc);
  const LatticeStencil<D> stencil = lattice_stencil<D>(
      kernel_of(scene), scene.kernel.support.value_or(2.5), *disc.particles.frame);
  const bool thesis = scene.formulation == Formulation::thesis;
  const bool eta = scene.ghosts == GhostClosure::eta;
  auto folded =
      folded_operators<D>(stencil, *disc.particles.frame, disc.particles.V, edges,
                          thesis && !eta ? TractionGhost::target : TractionGhost::mirrored);
  disc.divergence = std::move(folded.divergence);
  disc.force_terms = std::move(folded.force_terms);
  disc.stress_values = std::move(folded.stress_values);
  if (thesis) {
    disc.ghosts = std::make_shared<const GhostGradient<D>>(stencil, disc.particles, edges,
                                                           scene.ghosts, scene.boundary_solver,
                                                           scene.boundary_solver_place);
  } else {
    disc.gradient = std::move(folded.gradient);
    disc.gradient_terms = std::move(folded.gradient_terms);
  }
  add_reactions_of_moved<D>(edges, disc);
}

}  // namespace

template <int D>
Discretisation<D> build(const Scene& scene, Gradients gradients) {
  Eigen::setNbThreads(1);  // its products would wait for their threads where cores are taken
  Discretisation<D> disc;
  disc.particles = build_particles<D>(scene);
  stop_point();
  if (scene.consistency && is_collocated(scene.formulation)) {
    const QuadratureDegrees degrees = moments_of(*scene.consistency);
    // Scattered points do better with their Voronoi cells, and a file may bring volumes of its own.
    if (degrees.volume > 1 && scene.body.cloud.empty())
      disc.particles.V = local_volumes<D>(disc.particles);
    disc.particles = with_exact_moments<D>(
        std::move(disc.particles), degrees,
        scene.body.fit ? &std::get<Shape<D>>(scene.body.shape) : nullptr, scene.consistency->place);
  }
  stop_point();
  disc.spacing = disc.particles.spacing;
  disc.points = scene.formulation == Formulation::stress_point ? cell_points<D>(disc.particles)
                                                               : node_points<D>(disc.particles);
  disc.points.V = with_shared_values(std::move(disc.points.V), tolerance_of(disc.particles));
  disc.adjoint = is_adjoint(scene.formulation);
  parts::add_materials<D>(scene, disc);
  disc.mass = with_shared_values(std::move(disc.mass), tolerance_of(disc.particles));
  parts::add_conditions<D>(scene, disc);
  if (disc.adjoint)
    add_adjoint_operators<D>(scene, gradients, disc);
  else
    add_ghost_operators<D>(scene, disc);
  stop_point();
  parts::add_stabiliser<D>(scene, disc);
  stop_point();
  return disc;
}

template Discretisation<1> build<1>(const Scene&, Gradients);
template Discretisation<2> build<2>(const Scene&, Gradients);

}  // namespace tlsph
