#include "tlsph/dynamics/hyperbolicity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/SVD>
#include <type_traits>

#include "tlsph/core/parallel.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/waves.hpp"

namespace tlsph {
namespace {

/// Looks at all points of a region, and closer only if one of them is beyond the limit.
template <int D, class Law>
void look_at(const Region<D>& region, const Law& law, const State<D>& state,
             std::optional<HyperbolicityLoss>& worst) {
  const auto tangent_at = [&](Index k) {
    const Index s = region.point(k);
    return law.at(present(state, s)).tangent(tensor_at<D>(state.H, s));
  };
  const Index count = region.size(state.H.rows());
  const double unstable =
      sum_rows(count, [&](Index k) { return is_hyperbolic<D>(tangent_at(k)) ? 0.0 : 1.0; });
  if (unstable == 0.0) return;
  for (Index k = 0; k < count; ++k) {
    const double eigenvalue = smallest_acoustic_eigenvalue<D>(tangent_at(k));
    if (eigenvalue <= 0.0 && (!worst || eigenvalue < worst->acoustic_eigenvalue))
      worst = {state.time, region.point(k), {}, {}, eigenvalue};
  }
}

}  // namespace

std::string HyperbolicityLoss::text() const {
  return fmt::format(
      "the material, not the method, lost stability at t = {:.6g} s: material point {} at ({:.6g}) "
      "m has stretch {:.4g} and carries no waves any more (acoustic eigenvalue {:.3g} Pa); such a "
      "body separates into phases that depend on the spacing",
      time, point, fmt::join(position, ", "), fmt::join(stretches, " x "), acoustic_eigenvalue);
}

template <int D>
std::optional<HyperbolicityLoss> most_unstable_point(const Discretisation<D>& body,
                                                     const State<D>& state) {
  std::optional<HyperbolicityLoss> worst;
  for (const Region<D>& region : body.regions)
    std::visit(
        [&](const auto& law) {
          if constexpr (!std::decay_t<decltype(law)>::small_strain)
            look_at<D>(region, law, state, worst);
        },
        region.law);
  if (worst) {
    const auto X = body.points.X.row(worst->point);
    worst->position.assign(X.begin(), X.end());
    const Tensor<D> F = deformation_gradient<D>(tensor_at<D>(state.H, worst->point));
    const Vector<D> stretches = Eigen::JacobiSVD<Tensor<D>>(F).singularValues();
    worst->stretches.assign(stretches.begin(), stretches.end());
  }
  return worst;
}

#define TLSPH_INSTANTIATE(D)                                                                 \
  template std::optional<HyperbolicityLoss> most_unstable_point<D>(const Discretisation<D>&, \
                                                                   const State<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
