#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "parts.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph::parts {
namespace {

/// Three stress points a node, on the edges of triangles: too many volumes to keep in plane strain.
/// A cantilever 8 (4) spacings high, of these and of a square lattice: deflections differ by 0.1 %
/// (0.4 %) at a Poisson's ratio of 0.3, 0.4 % (1.4 %) at 0.45, 1.5 % (5.4 %) at 0.49, 8.8 % (28 %)
/// at 0.499; in plane stress by 0.4 % at most with 4.
constexpr double locks_from = 0.45, rounding = 1e-9;

std::optional<std::string> locking(const Scene& scene) {
  const bool edge_points = scene.dimension == 2 && scene.body.is_cloud() &&
                           scene.formulation == Formulation::stress_point;
  double poisson = 0.0;
  for (const MaterialScene& material : scene.materials)
    if (material.assumption == Assumption::strain)
      poisson = std::max(poisson, material.moduli().poisson);
  if (!edge_points || poisson < locks_from - rounding) return std::nullopt;
  return fmt::format(
      "stress points on the edges of triangles lock in plane strain as poisson nears 0.5, here it "
      "is "
      "{:.6g}: the deflection of a cantilever 8 spacings high comes out 0.4 % too small at 0.45, "
      "1.5 % "
      "at 0.49, 9 % at 0.499, and three times that with 4 spacings; a square lattice does not "
      "(body.layout = \"square\"; body.spacing in place of body.cloud)",
      poisson);
}

/// A disc without nodes, larger than supports allow for.
struct Void {
  Vector<2> centre;
  double radius = 0.0;
};

/// The largest disc about a point of the body that no node lies in: about the centre of the circle
/// through the corners of a triangle.
Void largest_void(const Particles<2>& particles, const Shape<2>& shape) {
  Void largest{Vector<2>::Zero()};
  for (const Triangle& triangle : particles.triangles) {
    const Vector<2> a = particles.X.row(triangle[0]).transpose();
    const Vector<2> b = particles.X.row(triangle[1]).transpose() - a;
    const Vector<2> c = particles.X.row(triangle[2]).transpose() - a;
    const double twice = 2.0 * (b.x() * c.y() - b.y() * c.x());
    const Vector<2> arm = Vector<2>(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                                    b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                          twice;
    if (arm.norm() > largest.radius && contains(shape, Vector<2>(a + arm)))
      largest = {a + arm, arm.norm()};
  }
  return largest;
}

std::optional<std::string> emptiness(const Scene& scene, const Particles<2>& particles) {
  constexpr double too_wide = 1.5;  // of the spacing; in a square lattice 0.71, one point out 1
  if (scene.body.cloud.empty()) return std::nullopt;
  const Void found = largest_void(particles, std::get<Shape<2>>(scene.body.shape));
  if (found.radius <= too_wide * particles.spacing) return std::nullopt;
  return fmt::format(
      "no point of {} lies within {:.4g} m, {:.2g} spacings, of ({:.4g}, {:.4g}), which is in the "
      "body; add points there, or take a hole out of body.shape",
      scene.body.cloud, found.radius, found.radius / particles.spacing, found.centre.x(),
      found.centre.y());
}

}  // namespace

template <int D>
std::vector<std::string> warnings(const Scene& scene, const Discretisation<D>& disc) {
  std::vector<std::string> texts;
  const auto add = [&](const std::optional<std::string>& text) {
    if (text) texts.push_back(*text);
  };
  add(locking(scene));
  if constexpr (D == 2) add(emptiness(scene, disc.particles));
  return texts;
}

template std::vector<std::string> warnings<1>(const Scene&, const Discretisation<1>&);
template std::vector<std::string> warnings<2>(const Scene&, const Discretisation<2>&);

}  // namespace tlsph::parts
