#include <algorithm>
#include <cmath>

#include "parts.hpp"

namespace tlsph::parts {
namespace {

/// The value of the curve that is farthest from zero.
double peak(const Curve& curve, double end) {
  constexpr int instants = 256;
  double most = 0.0;
  for (int k = 0; k <= instants; ++k)
    if (const double v = value(curve, end * k / instants); std::abs(v) > std::abs(most)) most = v;
  return most;
}

template <int D>
Vector<D> resultant(const Load& load, double end) {
  Vector<D> sum = Vector<D>::Zero();
  for (std::size_t k = 0; k < load.dof.size(); ++k) sum[load.dof[k] % D] += load.weight[k];
  return peak(load.curve, end) * sum;
}

}  // namespace

template <int D>
std::vector<LoadedPatch> loaded_patches(const Scene& scene, const Discretisation<D>& disc) {
  std::vector<LoadedPatch> loads;
  for (const BoundaryScene& boundary : scene.boundaries) {
    if (!boundary.normal_traction && boundary.traction.empty()) continue;
    const Patch<D>& patch = *disc.particles.find(boundary.where);
    Vector<D> sum = Vector<D>::Zero();
    if (boundary.normal_traction)
      sum += resultant<D>(normal_traction<D>(patch, *boundary.normal_traction), scene.time.end);
    for (const ComponentCurve& traction : boundary.traction)
      sum += resultant<D>(component_traction<D>(patch, traction.component, traction.curve),
                          scene.time.end);
    loads.push_back({boundary.where, patch_extent(patch), {sum.begin(), sum.end()}});
  }
  return loads;
}

template std::vector<LoadedPatch> loaded_patches<1>(const Scene&, const Discretisation<1>&);
template std::vector<LoadedPatch> loaded_patches<2>(const Scene&, const Discretisation<2>&);

}  // namespace tlsph::parts
