#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <numbers>

#include "tlsph/particles/fitted.hpp"
#include "tlsph/particles/jitter.hpp"
#include "tlsph/particles/lattice.hpp"
#include "tlsph/simulation/builder.hpp"

namespace tlsph {

double machine_bytes() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double estimated_bytes(const Scene& scene, double particles) {
  const int d = scene.dimension;
  const bool cells = scene.formulation == Formulation::stress_point && !scene.kernel.support;
  const double support = scene.kernel.support.value_or(0.0);
  double neighbours = 1 << d;
  if (!cells) neighbours = d == 1 ? 2.0 * support : std::numbers::pi * support * support;
  const bool per_component =
      scene.formulation == Formulation::mirror || scene.formulation == Formulation::thesis;
  const double weights = per_component ? d * d : d;
  const double row = 8.0 + neighbours * (4.0 + 8.0 * weights);
  const double stabiliser =
      scene.stabiliser.kind == StabiliserKind::none ? 0.0 : (d == 1 ? 5.0 : 25.0) * 12.0;
  const double fields = 8.0 * (8.0 * d + 2.0 * d * d + 4.0);
  // Set-up holds pattern, weights and transposed at once, and lists of triplets for a stabiliser.
  const double setup = 2.0 * row + 3.0 * stabiliser + 120.0 * d;
  return particles * (2.0 * row + stabiliser + fields + setup);
}

template <int D>
Particles<D> build_particles(const Scene& scene) {
  const auto& shape = std::get<Shape<D>>(scene.body.shape);
  const auto placement = scene.body.placement == Placement::on_boundary
                             ? NodePlacement::on_boundary
                             : NodePlacement::cell_centred;
  const double count = lattice_size_estimate<D>(shape, scene.body.spacing, placement);
  const double need = estimated_bytes(scene, count);
  const double have = machine_bytes();
  if (!(need <= 0.9 * have)) {
    const double factor = std::pow(need / (0.9 * have), 1.0 / D);
    throw InputError(
        scene.body.spacing_place,
        fmt::format(
            "{:.3g} particles would need about {:.3g} GB of memory, this machine has {:.3g} "
            "GB; choose a spacing above {:.2g}",
            count, need * 1e-9, have * 1e-9, scene.body.spacing * factor));
  }
  Particles<D> particles =
      make_lattice<D>(shape, scene.body.spacing, placement, scene.body.spacing_place);
  if constexpr (D == 2)
    if (scene.body.fit) particles = fitted(particles, shape, scene.body.place);
  if (scene.body.jitter > 0.0)
    particles =
        jittered<D>(std::move(particles), scene.body.jitter, scene.body.seed, scene.body.place);
  for (const NamedBox& box : scene.body.tags)
    particles = with_named_box<D>(std::move(particles), box.name,
                                  Eigen::Map<const Vector<D>>(box.lower.data()),
                                  Eigen::Map<const Vector<D>>(box.upper.data()), box.place);
  return particles;
}

template Particles<1> build_particles<1>(const Scene&);
template Particles<2> build_particles<2>(const Scene&);

}  // namespace tlsph
