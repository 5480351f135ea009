#include "preflight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/measures.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

/// The amplitude of a curve, of a table the value farthest from zero; a scene gives no others.
double peak(const Curve& curve) {
  return std::visit(
      [](const auto& form) {
        if constexpr (requires { form.amplitude; })
          return form.amplitude;
        else if constexpr (requires { form.curvature; })
          return *std::ranges::max_element(form.values, {}, [](double v) { return std::abs(v); });
        else
          return std::numeric_limits<double>::quiet_NaN();
      },
      curve);
}

template <int D>
Vector<D> resultant(const Load& load) {
  Vector<D> sum = Vector<D>::Zero();
  for (std::size_t k = 0; k < load.dof.size(); ++k) sum[load.dof[k] % D] += load.weight[k];
  return (peak(load.curve) * sum).array() + 0.0;  // no −0
}

}  // namespace

template <int D>
std::vector<LoadedPatch> loaded_patches(const Scene& scene, const Discretisation<D>& body) {
  std::vector<LoadedPatch> loads;
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>& patch = *body.particles.find(boundary.where);
    Vector<D> sum = Vector<D>::Zero();
    bool loaded = false;
    for (const Condition& condition : conditions_on<D>(patch, boundary)) {
      if (condition.kind != Condition::Kind::loaded) continue;
      sum += resultant<D>(load_of<D>(patch, condition));
      loaded = true;
    }
    if (loaded) loads.push_back({boundary.where, patch_extent(patch), {sum.begin(), sum.end()}});
  }
  return loads;
}

template std::vector<LoadedPatch> loaded_patches<1>(const Scene&, const Discretisation<1>&);
template std::vector<LoadedPatch> loaded_patches<2>(const Scene&, const Discretisation<2>&);

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
std::vector<std::string> warnings(const Scene& scene, const Discretisation<D>& body) {
  std::vector<std::string> texts;
  const auto add = [&](const std::optional<std::string>& text) {
    if (text) texts.push_back(*text);
  };
  add(locking(scene));
  if constexpr (D == 2) add(emptiness(scene, body.particles));
  return texts;
}

template std::vector<std::string> warnings<1>(const Scene&, const Discretisation<1>&);
template std::vector<std::string> warnings<2>(const Scene&, const Discretisation<2>&);

namespace {

/// Strain, and velocity in c_p, too small for a warning.
constexpr double negligible = 1e-6;

/// The largest stress |A : G j| [Pa] of displacements j of the undeformed body; of the thesis's
/// gradient, which is no matrix, about that.
template <int D>
double stress_of(const Discretisation<D>& body, const VectorField<D>& jump) {
  TensorField<D> H = TensorField<D>::Zero(body.points.size(), D * D);
  if (body.ghosts)
    H.row(0).setConstant(jump.cwiseAbs().maxCoeff() / body.spacing);
  else
    body.gradient.gradient(jump, H);
  double largest = 0.0;
  for (Index s = 0; s < H.rows(); ++s) {
    if ((H.row(s).array() == 0.0).all()) continue;
    const Tangent<D> A =
        tangent<D>(body.regions[region_of<D>(body, s)].law, Tensor<D>(Tensor<D>::Zero()));
    largest = std::max(largest, (A * H.row(s).transpose()).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

template <int D>
std::vector<std::string> start_jumps(const Scene& scene, const Discretisation<D>& body,
                                     const InitialState<D>& initial) {
  std::vector<std::string> remarks;
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>* patch = body.particles.find(boundary.where);
    const auto look_at = [&](int i, const std::string& key, double target, const char* cure) {
      VectorField<D> jump = VectorField<D>::Zero(body.nodes(), D);
      for (const int q : patch->nodes) jump(q, i) = target - initial.displacement(q, i);
      const double size = jump.cwiseAbs().maxCoeff();
      if (size <= negligible * body.spacing) return;
      remarks.push_back(fmt::format(
          "{}{}: {:.4g} m at t = 0, up to {:.4g} m off the initial displacement; the jump makes a "
          "stress of about {:.2g} Pa; {}",
          boundary.place.prefix(), key, target, size, stress_of<D>(body, jump), cure));
    };
    for (const Condition& condition : conditions_on<D>(*patch, boundary)) {
      const int i = condition.component;
      if (condition.kind == Condition::Kind::fixed)
        look_at(i, condition.across ? "symmetry" : fmt::format("fixed {}", "xy"[i]), 0.0,
                "\"held\" stays where the body starts");
      if (condition.kind != Condition::Kind::moved) continue;
      const std::string key = fmt::format("displacement.{}", "xy"[i]);
      look_at(i, key, value(*condition.curve, 0.0),
              "start the curve there, or give initial.displacement");
      const double speed = rate(*condition.curve, 0.0);
      double jump = 0.0;
      for (const int q : patch->nodes)
        jump = std::max(jump, std::abs(speed - initial.velocity(q, i)));
      if (jump <= negligible * body.wave_speed()) continue;
      const Region<D>& region = body.regions.front();
      const double modulus = tangent<D>(region.law, Tensor<D>(Tensor<D>::Zero()))(0, 0);
      remarks.push_back(fmt::format(
          "{}{}: {:.4g} m/s at t = 0, up to {:.4g} m/s off the initial velocity; the jump sends a "
          "wave of about {:.2g} Pa; a smooth start (\"smooth-ramp\") or initial.velocity avoids it",
          boundary.place.prefix(), key, speed, jump, std::sqrt(modulus * region.density) * jump));
    }
  }
  return remarks;
}

template std::vector<std::string> start_jumps<1>(const Scene&, const Discretisation<1>&,
                                                 const InitialState<1>&);
template std::vector<std::string> start_jumps<2>(const Scene&, const Discretisation<2>&,
                                                 const InitialState<2>&);

namespace {

/// Limits are computed to a part of a thousand, from the safe side; beyond this share motion grows.
constexpr double largest_share = 1.005;
/// At 10 ns a step and particle a run of a hundred particles would take two weeks.
constexpr double most_steps = 1e12;

}  // namespace

double checked_step(const Scene& scene, const CriticalStep& critical) {
  const TimeScene& time = scene.time;
  if (time.step && *time.step > largest_share * critical.dt && !time.allow_unstable)
    throw InputError(
        time.step_place,
        fmt::format(
            "{:.6g} s exceeds the critical step of this body, {:.6g} s, by {:.2g} %: motion "
            "would grow beyond all bounds; take {:.4g} s or less, leave it out for {:g} of "
            "the critical step, or say time.allow_unstable = true to see what grows",
            *time.step, critical.dt, 100.0 * (*time.step / critical.dt - 1.0), 0.9 * critical.dt,
            time.safety));
  const double dt = time.step.value_or(time.safety * critical.dt);
  const double count = std::ceil(time.end / dt);
  if (!(count <= most_steps))
    throw InputError(
        time.end_place,
        fmt::format("{:g} s take {:.3g} steps of {:.4g} s; a run makes at most {:g}: an end of at "
                    "most {:.3g} s, or steps that are longer",
                    time.end, count, dt, most_steps, most_steps * dt));
  return dt;
}

}  // namespace tlsph
