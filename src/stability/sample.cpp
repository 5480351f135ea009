#include "sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

/// Particles of a small body: dense spectra take milliseconds.
constexpr Index enough_particles = 260;
constexpr int cells_of_a_bar = 60;
constexpr int cells_of_a_strip = 20;

/// The body and the material of the scene: nothing of its run, and operators that build with any.
Scene bare(const Scene& asked) {
  Scene scene = asked;
  scene.boundaries.clear();
  scene.displacement = scene.velocity = {};
  scene.initial_regions.clear();
  scene.probes.clear();
  scene.exact = ExactKind::none;
  scene.output = {};
  scene.time = {};
  scene.time.end = 1.0;
  scene.formulation = Formulation::variational;
  scene.kernel = {};
  scene.stabiliser = {};
  scene.body.jitter = 0.0;
  scene.body.placement = NodePlacement::on_boundary;
  return completed(scene);
}

template <int D>
Box<D> extent(const Scene& scene) {
  return bounding_box<D>(std::get<Shape<D>>(scene.body.shape));
}

/// The scene at its spacing, or at the finest division of its length with few enough particles.
template <int D>
Scene small(const Scene& scene, double length) {
  const auto is_small = [](const Scene& one) {
    return build_particles<D>(one).size() <= (D == 1 ? cells_of_a_bar + 1 : enough_particles);
  };
  if (is_small(scene)) return scene;
  for (int cells = D == 1 ? cells_of_a_bar : 60; cells >= 2; --cells) {
    Scene coarse = scene;
    coarse.body.spacing = length / cells;
    coarse.body.spacing_place = {};
    try {
      coarse = completed(coarse);
      if (is_small(coarse)) return coarse;
    } catch (const InputError&) {
      continue;  // no division of the other direction
    }
  }
  throw InputError(scene.body.spacing_place,
                   fmt::format("the atlas needs a body of at most {} particles, and no spacing "
                               "below half the length divides this one; give one that does",
                               enough_particles));
}

BoundaryScene condition(const char* where) {
  BoundaryScene entry;
  entry.where = where;
  return entry;
}

BoundaryScene fixed(const char* where, int component) {
  BoundaryScene entry = condition(where);
  entry.fixed = {component};
  return entry;
}

/// Every edge stays where the uniform stretch puts it, the edges of a box along themselves only.
std::vector<BoundaryScene> edges(const Subject& subject, double stretch) {
  if (subject.box)
    return sliding_edges(subject.dimension,
                         ConstantCurve{(stretch - 1.0) * (subject.upper[0] - subject.lower[0])});
  BoundaryScene all = condition("boundary");
  for (int component = 0; component < subject.dimension; ++component) all.held.push_back(component);
  return {all};
}

}  // namespace

std::vector<BoundaryScene> sliding_edges(int dimension, const Curve& right) {
  std::vector<BoundaryScene> edges = {fixed("left", 0)};
  if (dimension == 2) {
    edges.push_back(fixed("bottom", 1));
    edges.push_back(fixed("top", 1));
  }
  edges.push_back(condition("right"));
  edges.back().motion = {{0, right}};
  return edges;
}

Subject read_subject(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  Subject subject;
  const Scene asked = read_scene(file, overrides);
  if (!asked.body.cloud.empty())
    throw InputError(asked.body.cloud_place,
                     "the atlas has lattices and jitters of its own, and points of a file stay "
                     "where they are: leave the cloud out, the shape is filled");
  if (asked.materials.size() != 1)
    throw InputError(asked.materials.back().place,
                     "the atlas varies the material of a body of one; leave the other regions out");
  subject.scene = bare(asked);
  subject.dimension = asked.dimension;
  const MaterialScene& material = asked.materials.front();
  if (!material.constant("poisson"))
    throw InputError(material.place,
                     "the atlas varies material.poisson; choose a law that has this constant");
  subject.poisson = *material.constant("poisson");
  subject.young = material.moduli().young;
  subject.density = material.density;
  const auto measure = [&]<int D>() {
    const Box<D> box = extent<D>(asked);
    subject.lower = {box.lower.begin(), box.lower.end()};
    subject.upper = {box.upper.begin(), box.upper.end()};
    subject.scene = small<D>(subject.scene, subject.upper[0] - subject.lower[0]);
    const Particles<D> particles = build_particles<D>(subject.scene);
    subject.spacing = particles.spacing;
    subject.box = particles.frame.has_value();
  };
  in_dimension(asked.dimension, measure);
  return subject;
}

Scene scene_of(const Subject& subject, const StateKey& key, Support support) {
  Subject body = subject;
  Scene& scene = body.scene;
  if (key.strip > 0) {
    const bool centred = key.method.cell_centred;
    const double height = (centred ? key.strip : key.strip - 1) * subject.spacing;
    const double length = cells_of_a_strip * subject.spacing;
    scene.body.shape = make_box<2>({0.0, 0.0}, {length, height});
    scene.body.spacing = subject.spacing;
    scene.body.spacing_place = {};
    if (centred) scene.body.placement = NodePlacement::cell_centred;
    body.lower = {0.0, 0.0};
    body.upper = {length, height};
    body.box = true;
  }
  key.method.apply_to(scene);
  scene.body.jitter = key.jitter;
  MaterialScene& material = scene.materials.front();
  const auto constants = constants_of(material.law);
  const auto poisson = std::ranges::find(constants, "poisson", &LawConstant::name);
  material.constants[static_cast<std::size_t>(poisson - constants.begin())] = key.poisson;
  if (support == Support::sliding) scene.boundaries = edges(body, key.stretch);
  return completed(scene);
}

template <int D>
Sample<D> build_sample(const Subject& subject, const StateKey& key, Support support) {
  const Scene scene = scene_of(subject, key, support);
  Sample<D> sample;
  sample.body = build<D>(scene);
  sample.H0(0, 0) = key.stretch - 1.0;
  const Vector<D> origin = extent<D>(scene).lower;
  const Index N = sample.body.nodes();
  VectorField<D> u(N, D);
  for (Index q = 0; q < N; ++q) {
    const Vector<D> X = sample.body.particles.X.row(q).transpose();
    u.row(q) = (sample.H0 * (X - origin)).transpose();
  }
  sample.state = make_state<D>(sample.body, u, VectorField<D>::Zero(N, D));
  evaluate<D>(sample.body, sample.state);
  return sample;
}

template Sample<1> build_sample<1>(const Subject&, const StateKey&, Support);
template Sample<2> build_sample<2>(const Subject&, const StateKey&, Support);

}  // namespace tlsph
