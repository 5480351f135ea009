#include "parts.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/formulations/operators.hpp"
#include "tlsph/operators/local_volumes.hpp"
#include "tlsph/operators/row_storage.hpp"
#include "tlsph/particles/moments.hpp"

namespace tlsph {
namespace {

/// What integration by parts of the polynomials asks of the quadrature.
QuadratureDegrees moments_of(const ConsistencyScene& degrees) {
  return {degrees.rows + degrees.columns - 1, degrees.rows + degrees.columns};
}

/// Particles whose volumes are the quadrature of a consistent gradient at the nodes.
template <int D>
Particles<D> with_moments(Particles<D> particles, const Scene& scene) {
  const QuadratureDegrees degrees = moments_of(*scene.consistency);
  // Scattered points do better with their Voronoi cells, and a file may bring volumes of its own.
  if (degrees.volume > 1 && scene.body.cloud.empty()) particles.V = local_volumes<D>(particles);
  return with_exact_moments<D>(std::move(particles), degrees,
                               scene.body.fit ? &std::get<Shape<D>>(scene.body.shape) : nullptr,
                               scene.consistency->place);
}

OperatorChoices choices_of(const Scene& scene, Gradients gradients) {
  const auto kernel = kernel_by_name(scene.kernel.family);
  if (!kernel) throw InputError(scene.kernel.place, "no kernel of that name");
  OperatorChoices choices{.kernel = *kernel,
                          .support = scene.kernel.support,
                          .order = scene.kernel.order,
                          .correction = scene.kernel.correction,
                          .ghosts = scene.ghosts,
                          .solver = scene.boundary_solver,
                          .solver_place = scene.boundary_solver_place};
  if (scene.consistency && gradients == Gradients::corrected) {
    choices.consistency = {scene.consistency->rows, scene.consistency->columns};
    choices.consistency_place = scene.consistency->place;
  }
  return choices;
}

}  // namespace

template <int D>
Discretisation<D> build(const Scene& scene, Gradients gradients) {
  Eigen::setNbThreads(1);  // its products would wait for their threads where cores are taken
  Discretisation<D> body;
  body.particles = build_particles<D>(scene);
  stop_point();
  if (scene.consistency && is_collocated(scene.formulation))
    body.particles = with_moments<D>(std::move(body.particles), scene);
  stop_point();
  body.spacing = body.particles.spacing;
  body.points = stress_points<D>(scene.formulation, body.particles);
  body.adjoint = is_adjoint(scene.formulation);
  parts::add_materials<D>(scene, body);
  body.mass = with_shared_values(std::move(body.mass), rounding_of<D>(body.particles));
  parts::add_conditions<D>(scene, body);
  Edges<D> edges;
  if (!body.adjoint) edges = parts::build_edges<D>(scene, body);
  add_operators<D>(scene.formulation, choices_of(scene, gradients), edges, body);
  parts::add_stabiliser<D>(scene, body);
  stop_point();
  return body;
}

template Discretisation<1> build<1>(const Scene&, Gradients);
template Discretisation<2> build<2>(const Scene&, Gradients);

}  // namespace tlsph
