#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "tlsph/filling/cloud.hpp"
#include "tlsph/filling/fitted.hpp"
#include "tlsph/filling/jitter.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/io/points_table.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {

namespace {

/// Entries of the factor a particle over unknowns · support, for each doubling of the particles
/// after the first few hundred: measured on plates of 1e3 to 1e5 particles.
constexpr double fill = 30.0, first_doublings = 8.3;

/// Whether a run keeps the strains of its last estimate and bound of the critical step.
bool follows_deformation(const Scene& scene) {
  return !scene.time.step && std::ranges::any_of(scene.materials, [](const MaterialScene& m) {
    return m.law != LawName::linear_elastic;
  });
}

}  // namespace

double machine_bytes() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

double operator_bytes(const Scene& scene, double particles) {
  const int d = scene.dimension;
  const bool stress_points = !is_collocated(scene.formulation);
  const bool cells = stress_points && !scene.kernel.support;
  const double support = scene.kernel.support.value_or(0.0);
  double neighbours = 1 << d;
  if (!cells) neighbours = d == 1 ? 2.0 * support : std::numbers::pi * support * support;
  const double weights = is_adjoint(scene.formulation) ? d : d * d;  // or one a component
  // A cloud has a point per edge of its triangles.
  const double points = stress_points && d == 2 && scene.body.is_cloud() ? 3.0 : 1.0;
  const double row = 8.0 + points * neighbours * (4.0 + 8.0 * weights);
  const StabiliserScene& stabiliser = scene.stabiliser;
  const bool modes =
      stabiliser.kind == StabiliserKind::cell && stabiliser.action == StabiliserAction::stiffness;
  double rows_of_stabiliser = 0.0, pair_errors = 0.0;
  if (modes)
    rows_of_stabiliser = 8.0 * (neighbours + 1.0);
  else if (stabiliser.kind != StabiliserKind::none)
    rows_of_stabiliser = (d == 1 ? 5.0 : 25.0) * 12.0;
  if (stabiliser.kind == StabiliserKind::pair) {
    // Half of the neighbours make a pair with a particle, and its error is a row on the neighbours
    // of both: lists of triplets, which grow by doubling, and four sparse matrices at once.
    const double pairs = d == 1 ? 1.0 : 4.0, row_entries = d == 1 ? 4.0 : 12.0;
    pair_errors = pairs * (1.5 * 16.0 * 2.0 * (1 + d) + 4.0 * 12.0 * row_entries);
  }
  const double tensor = 8.0 * d * d * points;
  const double vector = 8.0 * d;
  const double body = 2.0 * vector + 8.0 + 4.0 * (1 << d) + points * (vector + 8.0) + vector + 16.0;
  const double state = 4.0 * vector + 2.0 * tensor;  // u, v, f, C v or a frame's velocity; H, P
  const double follower = follows_deformation(scene) ? tensor : 0.0;  // two in single precision
  // What comes and goes beside these: at set-up pattern, weights and transposed at once, then the
  // pair errors and the products that make a stabiliser of them; in a run six vectors of an
  // eigenvalue's estimate and its stresses.
  const double setup =
      cells ? row + 2.0 * rows_of_stabiliser
            : std::max(2.0 * row + 12.0 * vector, row + 3.0 * rows_of_stabiliser + pair_errors);
  const double estimate = 6.0 * vector + tensor + (modes ? vector : 0.0) + 8.0;
  return particles *
         (2.0 * row + rows_of_stabiliser + body + std::max(setup, state + follower + estimate));
}

double correction_bytes(const Scene& scene, double particles) {
  if (!scene.consistency) return 0.0;
  const int d = scene.dimension;
  const auto monomials = [d](int degree) {
    return d == 1 ? degree + 1.0 : (degree + 1.0) * (degree + 2.0) / 2.0;
  };
  const double unknowns =
      monomials(scene.consistency->rows) + monomials(scene.consistency->columns);
  const double support = scene.kernel.support.value_or(1.0);
  const double neighbours = d == 1 ? 2.0 * support : std::numbers::pi * support * support;
  // By nested dissection a sheet is cut along lines, as wide as the support: N log N. A bar has a
  // band.
  const double doublings = std::max(std::log2(std::max(particles, 2.0)) - first_doublings, 3.0);
  const double entries = unknowns * support * (d == 1 ? 2.0 * unknowns : fill * doublings);
  return particles * (8.0 * entries + 12.0 * unknowns * unknowns * neighbours / 4.0 +
                      8.0 * (unknowns * neighbours + 24.0 * unknowns));
}

namespace {

/// InputError if so many particles do not fit in this machine.
void require_memory(const Scene& scene, double count) {
  const double need = operator_bytes(scene, count) + correction_bytes(scene, count);
  const double have = machine_bytes();
  if (need <= 0.9 * have) return;
  const std::string remedy =
      scene.body.cloud.empty()
          ? fmt::format("a spacing above {:.2g}",
                        scene.body.spacing * std::pow(need / (0.9 * have), 1.0 / scene.dimension))
          : std::string("fewer points");
  throw InputError(scene.body.spacing_place,
                   fmt::format("{:.3g} particles would need about {:.3g} GB of memory, this "
                               "machine has {:.3g} GB; choose {}",
                               count, need * 1e-9, have * 1e-9, remedy));
}

/// The points of body.cloud, with its volumes and tags.
template <int D>
Particles<D> imported(const Scene& scene, const Shape<D>& shape) {
  const std::filesystem::path file =
      std::filesystem::path(scene.file).parent_path() / scene.body.cloud;
  std::error_code unreadable;  // a name too long, a folder that may not be entered: no file either
  if (!std::filesystem::exists(file, unreadable))
    throw InputError(scene.body.cloud_place,
                     fmt::format("there is no file {}; the path is relative to the scene's folder",
                                 file.string()));
  PointsTable table = read_points(file, D);
  require_memory(scene, static_cast<double>(table.size()));
  const auto order = local_order<D>(
      Eigen::Map<const VectorField<D>>(table.X.data(), static_cast<Index>(table.size()), D));
  if (!order.empty()) table = table.in_order(order);
  const NodePlaces places = [&](Index q) { return table.place_of(static_cast<std::size_t>(q)); };
  const auto count = static_cast<Index>(table.size());
  Particles<D> particles = make_cloud<D>(Eigen::Map<const VectorField<D>>(table.X.data(), count, D),
                                         shape, scene.body.spacing, places);
  if (!table.V.empty())
    particles = with_volumes<D>(
        std::move(particles), Eigen::Map<const ScalarField>(table.V.data(), count), shape, places);
  std::map<std::string, std::vector<int>> named;
  for (std::size_t q = 0; q < table.tags.size(); ++q)
    for (const std::string& tag : table.tags[q]) named[tag].push_back(static_cast<int>(q));
  for (auto& [name, nodes] : named) {
    const Place place = places(nodes.front());
    particles = with_named_nodes<D>(std::move(particles), name, std::move(nodes), place);
  }
  particles.line = table.line;
  return particles;
}

/// The nodes of a lattice, jittered where wanted.
template <int D>
Particles<D> on_lattice(const Scene& scene, const Shape<D>& shape) {
  const BodyScene& body = scene.body;
  // Rows of a hexagonal lattice are √3/2 spacings apart.
  const double density = body.layout == Layout::hexagonal ? 2.0 / std::numbers::sqrt3 : 1.0;
  require_memory(scene, density * lattice_size_estimate<D>(shape, body.spacing, body.placement));
  Particles<D> particles;
  if constexpr (D == 2) {
    if (body.layout == Layout::hexagonal)
      particles = hexagonal_lattice(shape, body.spacing, body.spacing_place);
    else if (body.fit)
      particles = fitted(shape, body.spacing, body.spacing_place);
  }
  if (particles.size() == 0)
    particles = make_lattice<D>(shape, body.spacing, body.placement, body.spacing_place);
  if (body.jitter > 0.0)
    particles = jittered<D>(std::move(particles), body.jitter, body.seed, body.place);
  return particles;
}

}  // namespace

template <int D>
Particles<D> build_particles(const Scene& scene) {
  const auto& shape = std::get<Shape<D>>(scene.body.shape);
  Particles<D> particles =
      scene.body.cloud.empty() ? on_lattice<D>(scene, shape) : imported<D>(scene, shape);
  for (const NamedBox& box : scene.body.tags)
    particles = with_named_box<D>(std::move(particles), box.name,
                                  Eigen::Map<const Vector<D>>(box.lower.data()),
                                  Eigen::Map<const Vector<D>>(box.upper.data()), box.place,
                                  scene.body.fit ? &shape : nullptr);
  return particles;
}

template Particles<1> build_particles<1>(const Scene&);
template Particles<2> build_particles<2>(const Scene&);

}  // namespace tlsph
