#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "advice.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/curves/curve.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/simulation/linear_law.hpp"
#include "tlsph/simulation/reduction.hpp"

namespace tlsph {
namespace {

/// Loads that come suddenly strain twice as much as those that come slowly.
constexpr double sudden = 2.0;
constexpr int instants = 256;
/// Laws differ by about three times the strain: below this, by less than a run resolves.
constexpr double small_strain_limit = 1e-4;

double largest(const Curve& curve, double end) {
  double most = 0.0;
  for (int k = 0; k <= instants; ++k)
    most = std::max(most, std::abs(value(curve, end * k / instants)));
  return most;
}

/// Length and height of the body, as of a beam; a body in 1D, or one that behaves so, is no beam.
struct Size {
  double length = 0.0, slenderness = 1.0;
  bool bends = false;
};

template <int D>
Size box_size(const Scene& scene) {
  const Box<D> box = bounding_box(std::get<Shape<D>>(scene.body.shape));
  const Vector<D> lengths = box.upper - box.lower;
  return {lengths.maxCoeff(), lengths.maxCoeff() / lengths.minCoeff(), D == 2};
}

Size size_of(const Scene& scene) {
  Size size = in_dimension(scene.dimension, [&]<int D>() { return box_size<D>(scene); });
  if (size.bends && to_one_dimension(scene)) size.bends = false;
  return size;
}

/// Of a start: gradients of the displacement, or velocity over wave speed.
double gradient_of(const InitialField& field, const Size& size) {
  switch (field.kind) {
    case InitialField::Kind::zero:
      return 0.0;
    case InitialField::Kind::swinging_plate:
      return field.amplitude * std::numbers::pi / (2.0 * size.length);
    case InitialField::Kind::cantilever_mode:
      return 1.38 * field.amplitude / size.length;  // its slope at the tip
    case InitialField::Kind::linear:
      break;
  }
  double most = 0.0;
  for (const auto& row : field.gradient)
    for (const double g : row) most = std::max(most, std::abs(g));
  return most;
}

double speed_of(const InitialField& field, const Size& size) {
  if (field.kind == InitialField::Kind::zero) return 0.0;
  if (field.kind != InitialField::Kind::linear) return std::abs(field.amplitude);
  double most = gradient_of(field, size) * size.length;
  for (const double c : field.constant) most = std::max(most, std::abs(c));
  return most;
}

/// The largest strain or rotation the scene can be expected to cause, an estimate on the safe side
/// from its loads, its prescribed motions and its start: of a slender body as if it bent.
double strain_estimate(const Scene& scene) {
  const Size size = size_of(scene);
  const double ratio = size.bends ? size.slenderness : 1.0;
  double young = scene.materials.front().moduli().young;
  double density = scene.materials.front().density;
  for (const MaterialScene& region : scene.materials) {
    young = std::min(young, region.moduli().young);
    density = std::max(density, region.density);
  }
  const double speed = std::sqrt(young / density);
  double strain = gradient_of(scene.displacement, size);
  double start = speed_of(scene.velocity, size);
  for (const InitialRegion& region : scene.initial_regions) {
    if (region.displacement) strain += gradient_of(*region.displacement, size);
    if (region.velocity) start = std::max(start, speed_of(*region.velocity, size));
    // Between parts that start differently the displacement jumps.
    if (region.displacement && !region.displacement->constant.empty())
      for (const double c : region.displacement->constant)
        strain += std::abs(c) / scene.body.spacing;
  }
  strain += start / speed * ratio;
  // The slope at the tip of a cantilever under a load along it: 2 (L/H)³ p/E.
  const double bending = size.bends ? 2.0 * std::pow(ratio, 3) : 1.0;
  for (const BoundaryScene& entry : scene.boundaries)
    for (const Condition& condition : conditions_of(entry, unknown_axis)) {
      if (condition.curve == nullptr) continue;
      const double most = largest(*condition.curve, scene.time.end);
      strain += condition.kind == Condition::Kind::loaded ? sudden * bending * most / young
                                                          : sudden * most / (size.length / ratio);
    }
  for (const double g : scene.body_force)
    strain += sudden * bending * std::abs(g) * density * size.length / ratio / young;
  return strain;
}

}  // namespace

std::string advise_law(const Scene& scene) {
  const LawName law = scene.materials.front().law;
  // Gradients from two or four nodes leave the law a part of the step that shows.
  if (law == LawName::linear_elastic || scene.kernel.support) return "";
  const double strain = strain_estimate(scene);
  if (strain >= small_strain_limit) return "";
  const double share = scene.dimension == 1 ? 0.4 : 0.8;  // as runs of the examples show
  return fmt::format(
      "  {} at strains of at most about {:.1e}: law = \"linear-elastic\" differs by as little, at "
      "about {} of the time of a step\n",
      name_of(law), strain, share);
}

std::vector<std::string> linear_law(const Scene& scene) {
  const auto is_linear = [](const MaterialScene& material) {
    return material.law == LawName::linear_elastic;
  };
  // Constants of another law's own would have no meaning for the linear one.
  const auto has_its_constants = [](const MaterialScene& material) {
    return std::ranges::equal(constants_of(material.law), constants_of(LawName::linear_elastic), {},
                              &LawConstant::name, &LawConstant::name);
  };
  if (std::ranges::all_of(scene.materials, is_linear) ||
      !std::ranges::all_of(scene.materials, has_its_constants) ||
      scene.exact == ExactKind::uniform_stretch)
    return {};
  std::vector<std::string> overrides = {"material.law=linear-elastic"};
  for (std::size_t k = 1; k < scene.materials.size(); ++k)
    overrides.push_back(fmt::format("material.region[{}].law=linear-elastic", k - 1));
  return overrides;
}

}  // namespace tlsph
