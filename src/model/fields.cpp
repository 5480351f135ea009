#include "parts.hpp"
#include "tlsph/exact/solutions.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

template <int D>
Box<D> body_box(const Scene& scene) {
  return bounding_box<D>(std::get<Shape<D>>(scene.body.shape));
}

SwingingPlate plate_of(const Scene& scene, double amplitude) {
  const Box<2> box = body_box<2>(scene);
  const MaterialScene& material = scene.materials.front();
  SwingingPlate plate;
  plate.corner = box.lower;
  plate.length = box.upper[0] - box.lower[0];
  plate.shear_modulus = material.moduli().shear;
  plate.density = material.density;
  plate.amplitude = amplitude;
  return plate;
}

/// One vector field of the initial state.
template <int D>
VectorField<D> initial_field(const Scene& scene, const InitialField& field,
                             const Particles<D>& particles) {
  VectorField<D> result = VectorField<D>::Zero(particles.size(), D);
  const Box<D> box = body_box<D>(scene);
  switch (field.kind) {
    case InitialField::Kind::zero:
      break;
    case InitialField::Kind::linear:
      for (Index q = 0; q < particles.size(); ++q)
        for (std::size_t i = 0; i < D; ++i) {
          double value = field.constant.empty() ? 0.0 : field.constant[i];
          for (std::size_t a = 0; a < D && !field.gradient.empty(); ++a)
            value += field.gradient[i][a] * particles.X(q, static_cast<Index>(a));
          result(q, static_cast<Index>(i)) = value;
        }
      break;
    case InitialField::Kind::swinging_plate:
      if constexpr (D == 2) {
        const auto exact = swinging_plate(plate_of(scene, field.amplitude));
        for (Index q = 0; q < particles.size(); ++q)
          result.row(q) = exact.displacement(particles.X.row(q).transpose(), 0.0).transpose();
      } else {
        throw InputError(field.place, "\"swinging-plate\" is a field of two dimensions");
      }
      break;
    case InitialField::Kind::cantilever_mode:
      if constexpr (D == 2) {
        const double length = box.upper[0] - box.lower[0];
        for (Index q = 0; q < particles.size(); ++q)
          result(q, 1) =
              field.amplitude * cantilever_mode((particles.X(q, 0) - box.lower[0]) / length);
      } else {
        throw InputError(field.place, "\"cantilever-mode\" is a field of two dimensions");
      }
      break;
  }
  return result;
}

/// The fields of the regions in place of those of the whole body.
template <int D>
void start_regions(const Scene& scene, const Particles<D>& particles, InitialState<D>& initial) {
  const double tolerance = 1e-6 * particles.spacing;
  for (const InitialRegion& region : scene.initial_regions) {
    const Vector<D> lower = Eigen::Map<const Vector<D>>(region.lower.data());
    const Vector<D> upper = Eigen::Map<const Vector<D>>(region.upper.data());
    std::vector<Index> members;
    for (Index q = 0; q < particles.size(); ++q) {
      const Vector<D> X = particles.X.row(q).transpose();
      if (((X - lower).array() >= -tolerance).all() && ((upper - X).array() >= -tolerance).all())
        members.push_back(q);
    }
    if (members.empty())
      throw InputError(region.place,
                       "the region holds no particle; move or enlarge its box, or leave it out");
    const auto replace = [&](const std::optional<InitialField>& field, VectorField<D>& target) {
      if (!field) return;
      const VectorField<D> source = initial_field<D>(scene, *field, particles);
      for (const Index q : members) target.row(q) = source.row(q);
    };
    replace(region.displacement, initial.displacement);
    replace(region.velocity, initial.velocity);
  }
}

template <int D>
ExactSolution<D> bar_wave_of(const Scene& scene, const Discretisation<D>& disc) {
  const Box<D> box = body_box<D>(scene);
  const Tangent<D> A = tangent<D>(disc.regions.front().law, Tensor<D>::Zero());
  BarWave bar;
  bar.lower = box.lower[0];
  bar.length = box.upper[0] - box.lower[0];
  bar.modulus = A(0, 0);
  if constexpr (D == 2) bar.lateral_modulus = A(3, 0);
  bar.density = disc.regions.front().density;
  const PatchConditions left(scene, "left"), right(scene, "right");
  const Condition* pull = left.find(Kind::loaded, 0);  // the rules of a scene leave one of the two
  const bool lower = pull != nullptr;
  if (!lower) pull = right.find(Kind::loaded, 0);
  bar.traction = tension(*pull, lower ? -1.0 : 1.0);
  bar.loaded = lower ? BarWave::Side::lower : BarWave::Side::upper;
  const bool fixed = (lower ? right : left).has(Kind::fixed, 0);
  bar.far_end = fixed ? BarWave::Support::fixed : BarWave::Support::free;
  return bar_wave<D>(bar);
}

template <int D>
ExactSolution<D> uniform_stretch_of(const Scene& scene, const Discretisation<D>& disc) {
  const Box<D> box = body_box<D>(scene);
  const double length = box.upper[0] - box.lower[0];
  const PatchConditions left(scene, "left"), right(scene, "right");
  const Condition* moved = right.find(Kind::moved, 0);  // the rules leave one of the two at least
  const bool upper = moved != nullptr;
  if (!upper) moved = left.find(Kind::moved, 0);
  return uniform_stretch<D>(
      {upper ? box.lower[0] : box.upper[0], upper ? length : -length, *moved->curve},
      disc.regions.front().law);
}

}  // namespace

template <int D>
InitialState<D> build_initial(const Scene& scene, const Discretisation<D>& disc) {
  InitialState<D> initial{initial_field<D>(scene, scene.displacement, disc.particles),
                          initial_field<D>(scene, scene.velocity, disc.particles)};
  parts::refuse_imbalance<D>(scene, disc, initial.displacement);
  start_regions<D>(scene, disc.particles, initial);
  return initial;
}

template <int D>
ExactSolution<D> build_exact(const Scene& scene, const Discretisation<D>& disc) {
  switch (scene.exact) {
    case ExactKind::none:
      break;
    case ExactKind::bar_wave:
      return bar_wave_of<D>(scene, disc);
    case ExactKind::swinging_plate:
      if constexpr (D == 2) {
        if (scene.displacement.kind != InitialField::Kind::swinging_plate)
          throw InputError(scene.exact_place,
                           "\"swinging-plate\" needs initial.displacement = { field = "
                           "\"swinging-plate\", amplitude = … }");
        return swinging_plate(plate_of(scene, scene.displacement.amplitude));
      }
      break;
    case ExactKind::uniform_stretch:
      return uniform_stretch_of<D>(scene, disc);
  }
  return {};
}

template InitialState<1> build_initial<1>(const Scene&, const Discretisation<1>&);
template InitialState<2> build_initial<2>(const Scene&, const Discretisation<2>&);
template ExactSolution<1> build_exact<1>(const Scene&, const Discretisation<1>&);
template ExactSolution<2> build_exact<2>(const Scene&, const Discretisation<2>&);

}  // namespace tlsph
