#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parts.hpp"
#include "tlsph/dynamics/measures.hpp"

namespace tlsph::parts {
namespace {

/// Strain, and velocity in c_p, too small for a warning.
constexpr double negligible = 1e-6;

/// The largest stress |A : G j| [Pa] of displacements j of the undeformed body; of the thesis's
/// gradient, which is no matrix, about that.
template <int D>
double stress_of(const Discretisation<D>& disc, const VectorField<D>& jump) {
  TensorField<D> H = TensorField<D>::Zero(disc.points.size(), D * D);
  if (disc.ghosts)
    H.row(0).setConstant(jump.cwiseAbs().maxCoeff() / disc.spacing);
  else
    disc.gradient.gradient(jump, H);
  double largest = 0.0;
  for (Index s = 0; s < H.rows(); ++s) {
    if ((H.row(s).array() == 0.0).all()) continue;
    const Tangent<D> A =
        tangent<D>(disc.regions[region_of<D>(disc, s)].law, Tensor<D>(Tensor<D>::Zero()));
    largest = std::max(largest, (A * H.row(s).transpose()).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

template <int D>
std::vector<std::string> start_jumps(const Scene& scene, const Discretisation<D>& disc,
                                     const InitialState<D>& initial) {
  std::vector<std::string> remarks;
  for (const BoundaryScene& boundary : scene.boundaries) {
    const Patch<D>* patch = disc.particles.find(boundary.where);
    const auto look_at = [&](int i, const std::string& key, double target, const char* cure) {
      VectorField<D> jump = VectorField<D>::Zero(disc.nodes(), D);
      for (const int q : patch->nodes) jump(q, i) = target - initial.displacement(q, i);
      const double size = jump.cwiseAbs().maxCoeff();
      if (size <= negligible * disc.spacing) return;
      remarks.push_back(fmt::format(
          "{}{}: {:.4g} m at t = 0, up to {:.4g} m off the initial displacement; the jump makes a "
          "stress of about {:.2g} Pa; {}",
          boundary.place.prefix(), key, target, size, stress_of<D>(disc, jump), cure));
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
      if (jump <= negligible * disc.wave_speed()) continue;
      const Region<D>& region = disc.regions.front();
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

}  // namespace tlsph::parts
