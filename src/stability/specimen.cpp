#include "specimen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

/// Particles of a small body: dense spectra take milliseconds.
constexpr Index enough_particles = 260;
constexpr int cells_of_a_bar = 60;
constexpr int cells_of_a_strip = 20;

/// What belongs to the run of the scene, not to its body and material.
const std::vector<std::string> bare_scene = {
    "boundary=[]", "initial={}", "probe=[]", "reference={}", "output={}", "time={end=1.0}",
};

std::vector<std::string> with(std::vector<std::string> first,
                              const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

template <int D>
Box<D> extent(const Scene& scene) {
  return bounding_box<D>(std::get<Shape<D>>(scene.body.shape));
}

/// The scene's spacing, or the finest division of its length with few enough particles.
template <int D>
std::vector<std::string> small_body(const Subject& subject, const Scene& scene) {
  if (build_particles<D>(scene).size() <= (D == 1 ? cells_of_a_bar + 1 : enough_particles))
    return {};
  const double length = subject.upper[0] - subject.lower[0];
  for (int cells = D == 1 ? cells_of_a_bar : 60; cells >= 2; --cells) {
    const std::string spacing = fmt::format("body.spacing={:.17g}", length / cells);
    try {
      const Scene coarse = subject.read(with(subject.overrides, {spacing}));
      if (build_particles<D>(coarse).size() <= (D == 1 ? cells_of_a_bar + 1 : enough_particles))
        return {spacing};
    } catch (const InputError&) {
      continue;  // no division of the other direction
    }
  }
  throw InputError(scene.body.spacing_place,
                   fmt::format("the atlas needs a body of at most {} particles, and no spacing "
                               "below half the length divides this one; give one that does",
                               enough_particles));
}

std::string number(double value) {
  return fmt::format("{:.17g}", value);
}

/// The edges of a box slide along themselves, a stretch apart.
std::string edges(const Subject& subject, double stretch) {
  if (!subject.box) return R"(boundary=[{where="boundary", held=true}])";
  const double move = (stretch - 1.0) * (subject.upper[0] - subject.lower[0]);
  if (subject.dimension == 1)
    return fmt::format(
        R"(boundary=[{{where="left", fixed=true}}, {{where="right", displacement={{x={}}}}}])",
        number(move));
  return fmt::format(R"(boundary=[{{where="left", fixed="x"}}, {{where="bottom", fixed="y"}}, )"
                     R"({{where="top", fixed="y"}}, {{where="right", displacement={{x={}}}}}])",
                     number(move));
}

}  // namespace

Scene Subject::read(const std::vector<std::string>& settings) const {
  return read_scene_text(text, name, settings);
}

Subject read_subject(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  Subject subject;
  const Scene asked = read_scene(file, overrides);
  subject.name = asked.file;
  subject.text = asked.text;
  if (!asked.body.cloud.empty())
    throw InputError(asked.body.cloud_place,
                     "the atlas has lattices and jitters of its own, and points of a file stay "
                     "where they are: leave the cloud out, the shape is filled");
  if (asked.materials.size() != 1)
    throw InputError(asked.materials.back().place,
                     "the atlas varies the material of a body of one; leave the other regions out");
  subject.overrides = bare_scene;
  subject.overrides.insert(subject.overrides.end(),
                           {"formulation=variational", "kernel={}", "stabiliser={}",
                            "body.jitter=0", R"(body.placement="on-boundary")"});
  const Scene scene = subject.read(subject.overrides);
  subject.dimension = scene.dimension;
  subject.spacing = scene.body.spacing;
  const MaterialScene& material = scene.materials.front();
  if (!material.constant("poisson"))
    throw InputError(material.place,
                     "the atlas varies material.poisson; choose a law that has this constant");
  subject.poisson = *material.constant("poisson");
  subject.young = material.moduli().young;
  subject.density = material.density;
  const auto look = [&]<int D>() {
    const Box<D> box = extent<D>(scene);
    subject.lower = {box.lower.begin(), box.lower.end()};
    subject.upper = {box.upper.begin(), box.upper.end()};
    subject.overrides = with(subject.overrides, small_body<D>(subject, scene));
    const Particles<D> particles = build_particles<D>(subject.read(subject.overrides));
    subject.spacing = particles.spacing;
    subject.box = particles.frame.has_value();
  };
  in_dimension(scene.dimension, look);
  return subject;
}

Scene scene_of(const Subject& subject, const StateKey& key, Support support) {
  Subject body = subject;
  std::vector<std::string> set = subject.overrides;
  if (key.strip > 0) {
    const bool centred = key.method.cell_centred;
    const double height = (centred ? key.strip : key.strip - 1) * subject.spacing;
    const double length = cells_of_a_strip * subject.spacing;
    set.push_back(
        fmt::format("body.shape={{box=[[0.0, 0.0], [{}, {}]]}}", number(length), number(height)));
    set.push_back("body.spacing=" + number(subject.spacing));
    if (centred) set.emplace_back(R"(body.placement="cell-centred")");
    body.lower = {0.0, 0.0};
    body.upper = {length, height};
    body.box = true;
  }
  set = with(set, key.method.settings);
  set.push_back("body.jitter=" + number(key.jitter));
  set.push_back("material.poisson=" + number(key.poisson));
  if (support == Support::sliding) set.push_back(edges(body, key.stretch));
  return subject.read(set);
}

template <int D>
Specimen<D> build_specimen(const Subject& subject, const StateKey& key, Support support) {
  const Scene scene = scene_of(subject, key, support);
  Specimen<D> specimen;
  specimen.disc = build<D>(scene);
  specimen.H0(0, 0) = key.stretch - 1.0;
  const Vector<D> origin = extent<D>(scene).lower;
  const Index N = specimen.disc.nodes();
  VectorField<D> u(N, D);
  for (Index q = 0; q < N; ++q) {
    const Vector<D> X = specimen.disc.particles.X.row(q).transpose();
    u.row(q) = (specimen.H0 * (X - origin)).transpose();
  }
  specimen.state = make_state<D>(specimen.disc, u, VectorField<D>::Zero(N, D));
  evaluate<D>(specimen.disc, specimen.state);
  return specimen;
}

template Specimen<1> build_specimen<1>(const Subject&, const StateKey&, Support);
template Specimen<2> build_specimen<2>(const Subject&, const StateKey&, Support);

}  // namespace tlsph
