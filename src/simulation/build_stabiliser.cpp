#include <cmath>

#include "parts.hpp"
#include "tlsph/materials/lame.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph::parts {
namespace {

/// Multiples of the modulus (stiffness) or of ρ c_p Δ (viscosity) that `coefficient = "auto"`
/// means.
constexpr double auto_cell_stiffness = 4.0 / 3.0;  // of E/(1−ν²): exact bending of a rectangle
constexpr double auto_pair_stiffness = 0.1;        // of μ
constexpr double auto_viscosity = 0.2;             // of ρ c_p Δ
constexpr double auto_viscosity_quadratic = 0.1;   // the same beside gradients of order two

/// Support of the narrow linear gradient the pair error is measured with, in spacings: it reaches
/// the diagonal neighbours of a lattice.
constexpr double pair_support = 1.515;

/// E/(1−ν²) in plane strain, E in plane stress: the modulus of a fibre that bends.
double bending_modulus(const MaterialScene& material) {
  return material.assumption == AssumptionKind::stress
             ? material.young
             : material.young / (1.0 - material.poisson * material.poisson);
}

template <int D>
double unit(const Scene& scene, const Discretisation<D>& disc, std::size_t k) {
  const MaterialScene& material = scene.materials[k];
  if (scene.stabiliser.action == StabiliserAction::viscosity) {
    const double modulus = tangent<D>(disc.regions[k].law, Tensor<D>::Zero())(0, 0);
    return material.density * std::sqrt(modulus / material.density) * disc.spacing;
  }
  return scene.stabiliser.kind == StabiliserKind::cell
             ? bending_modulus(material)
             : material.young / (2.0 * (1.0 + material.poisson));
}

double automatic(const Scene& scene) {
  if (scene.stabiliser.action == StabiliserAction::viscosity)
    return scene.kernel.order > 1 ? auto_viscosity_quadratic : auto_viscosity;
  return scene.stabiliser.kind == StabiliserKind::cell ? auto_cell_stiffness : auto_pair_stiffness;
}

template <int D>
ScalarField strengths(const Scene& scene, const Discretisation<D>& disc, const VectorField<D>& at) {
  const double coefficient = scene.stabiliser.coefficient.value_or(automatic(scene));
  ScalarField result(at.rows());
  for (Index s = 0; s < at.rows(); ++s) {
    const Vector<D> x = at.row(s).transpose();
    result[s] = coefficient * unit<D>(scene, disc, material_at<D>(scene, x, 1e-9 * disc.spacing));
  }
  return result;
}

}  // namespace

template <int D>
void add_stabiliser(const Scene& scene, Discretisation<D>& disc) {
  const StabiliserScene& stabiliser = scene.stabiliser;
  if (stabiliser.kind == StabiliserKind::none) return;
  if (!disc.adjoint)
    throw InputError(stabiliser.place, "a stabiliser goes with formulation = " +
                                           adjoint_formulations() + "; use kind = \"none\"");
  SparseMatrix S;
  if (stabiliser.kind == StabiliserKind::cell) {
    if constexpr (D == 2) {
      if (scene.formulation != Formulation::stress_point || scene.kernel.support)
        throw InputError(stabiliser.place,
                         "kind = \"cell\" goes with formulation \"stress-point\" on the nodes of a "
                         "cell (no kernel.support); use \"pair\" or \"none\"");
      ScalarField modulus = strengths<2>(scene, disc, disc.points.X);
      if (stabiliser.action == StabiliserAction::stiffness) {
        disc.hourglass = {hourglass_weights(disc.particles, disc.gradient), std::move(modulus)};
        return;
      }
      S = normal_matrix(hourglass_rows(disc.particles, disc.gradient), modulus);
    } else {
      throw InputError(
          stabiliser.place,
          "kind = \"cell\" is for two dimensions: a cell of two nodes has no hourglass; "
          "use \"none\"");
    }
  } else {
    const auto narrow =
        collocated_gradient<D>(WendlandC2{}, pair_support * disc.spacing, disc.particles.X,
                               disc.particles.V, Correction::gradient);
    S = pair_stabiliser<D>(narrow, disc.particles.X, disc.particles.V, disc.spacing,
                           strengths<D>(scene, disc, disc.particles.X));
  }
  (stabiliser.action == StabiliserAction::stiffness ? disc.stiffness : disc.viscosity) =
      std::move(S);
}

template void add_stabiliser<1>(const Scene&, Discretisation<1>&);
template void add_stabiliser<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
