#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph::parts {
namespace {

/// Forces below this share of |P₀| Δ^(d−1) are round-off, or what a fit to boundaries leaves.
constexpr double negligible = 1e-6;

/// Largest entry at a degree of freedom that is free to follow it, and its node.
template <int D>
std::pair<double, Index> largest_free(const Discretisation<D>& disc, const VectorField<D>& force) {
  std::pair<double, Index> largest{0.0, 0};
  for (Index dof = 0; dof < force.size(); ++dof)
    if (disc.inverse_mass.data()[dof] != 0.0 && std::abs(force.data()[dof]) > largest.first)
      largest = {std::abs(force.data()[dof]), dof / D};
  return largest;
}

/// What the loads leave of P₀ N at the boundary, as a force on each node.
template <int D>
VectorField<D> boundary_residual(const Discretisation<D>& disc, const Tensor<D>& P0) {
  VectorField<D> residual = -disc.particles.B * P0.transpose();
  for (const Load& load : disc.loads) {
    const double pressure = value(load.curve, 0.0);
    for (std::size_t k = 0; k < load.dof.size(); ++k)
      residual.data()[load.dof[k]] += pressure * load.weight[k];
  }
  return residual;
}

}  // namespace

template <int D>
void refuse_imbalance(const Scene& scene, const Discretisation<D>& disc,
                      const VectorField<D>& displacement) {
  const InitialField& field = scene.displacement;
  if (field.kind != InitialField::Kind::linear || field.gradient.empty() || !disc.adjoint ||
      disc.regions.size() > 1 || disc.has_body_force())
    return;
  Tensor<D> H0;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a)
      H0(i, a) = field.gradient[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)];
  const Tensor<D> P0 = pk1<D>(disc.regions.front().law, H0);
  const double scale = P0.norm() * std::pow(disc.spacing, D - 1);
  if (!(scale > 0.0)) return;

  State<D> state = make_state<D>(disc, displacement, VectorField<D>::Zero(disc.nodes(), D));
  // Supports that start elsewhere, or boundaries whose stress nothing balances, are meant to move.
  if ((state.u - displacement).cwiseAbs().maxCoeff() > 1e-9 * H0.norm() * disc.spacing) return;
  if (largest_free<D>(disc, boundary_residual<D>(disc, P0)).first > negligible * scale) return;

  evaluate<D>(disc, state);
  const auto [force, node] = largest_free<D>(disc, state.f);
  if (force <= negligible * scale) return;
  std::string at;
  for (int a = 0; a < D; ++a)
    at += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", disc.particles.X(node, a));
  throw InputError(
      field.place,
      fmt::format("a body stretched like this and held or loaded at its boundary is in "
                  "equilibrium, but not as {} sees it: its gradients near the boundary leave a "
                  "force of {:.2g} times the stress on the particle at ({}); hold layers at least "
                  "{:.3g} spacings thick, twice the support, on a regular lattice ([[body.tags]] "
                  "and held = true), or use stress-point with the nodes of each cell",
                  name_of(scene.formulation), force / scale, at,
                  2.0 * scene.kernel.support.value_or(1.0)));
}

template void refuse_imbalance<1>(const Scene&, const Discretisation<1>&, const VectorField<1>&);
template void refuse_imbalance<2>(const Scene&, const Discretisation<2>&, const VectorField<2>&);

}  // namespace tlsph::parts
