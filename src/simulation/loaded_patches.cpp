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
    const Patch<D>& patch = *disc.particles.find(boundary.where);
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

}  // namespace tlsph::parts
