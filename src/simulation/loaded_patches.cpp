#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "parts.hpp"

namespace tlsph::parts {
namespace {

/// The amplitude of a curve, of a table the value farthest from zero; a scene gives no others.
double peak(const Curve& curve) {
  return std::visit(
      [](const auto& form) {
        if constexpr (requires { form.amplitude; })
          return form.amplitude;
        else if constexpr (requires { form.curvature; })
          return *std::ranges::max_element(form.value, {}, [](double v) { return std::abs(v); });
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
std::vector<LoadedPatch> loaded_patches(const Scene& scene, const Discretisation<D>& disc) {
  std::vector<LoadedPatch> loads;
  for (const BoundaryScene& boundary : scene.boundaries) {
    if (!boundary.normal_traction && boundary.traction.empty()) continue;
    const Patch<D>& patch = *disc.particles.find(boundary.where);
    Vector<D> sum = Vector<D>::Zero();
    if (boundary.normal_traction)
      sum += resultant<D>(normal_traction<D>(patch, *boundary.normal_traction));
    for (const ComponentCurve& traction : boundary.traction)
      sum += resultant<D>(component_traction<D>(patch, traction.component, traction.curve));
    loads.push_back({boundary.where, patch_extent(patch), {sum.begin(), sum.end()}});
  }
  return loads;
}

template std::vector<LoadedPatch> loaded_patches<1>(const Scene&, const Discretisation<1>&);
template std::vector<LoadedPatch> loaded_patches<2>(const Scene&, const Discretisation<2>&);

}  // namespace tlsph::parts
