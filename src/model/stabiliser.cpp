#include <cmath>
#include <vector>

#include "parts.hpp"
#include "tlsph/materials/lame.hpp"
#include "tlsph/operators/stabilisers.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph::parts {
namespace {

/// Multiples of the modulus (stiffness) or of ρ c_s Δ (viscosity) that `coefficient = "auto"`
/// means.
constexpr double auto_cell_stiffness = 4.0 / 3.0;  // of E/(1−ν²): exact bending of a rectangle
constexpr double auto_pair_stiffness = 0.1;        // of μ
constexpr double auto_viscosity = 0.4;             // of ρ c_s Δ
constexpr double auto_viscosity_quadratic = 0.2;   // the same beside gradients of order two

/// E/(1−ν²) in plane strain, E in plane stress: the modulus of a fibre that bends.
double bending_modulus(const MaterialScene& material) {
  const Moduli moduli = material.moduli();
  return material.assumption == Assumption::stress
             ? moduli.young
             : moduli.young / (1.0 - moduli.poisson * moduli.poisson);
}

/// [Pa] as stiffness, ρ c_s Δ [Pa s] as viscosity: of shear, which the modes of a stabiliser are,
/// so that it stays in proportion as ν nears ½.
double unit(const Scene& scene, const MaterialScene& material, double spacing) {
  const double mu = material.moduli().shear;
  if (scene.stabiliser.action == StabiliserAction::viscosity)
    return std::sqrt(material.density * mu) * spacing;
  return scene.stabiliser.kind == StabiliserKind::cell ? bending_modulus(material) : mu;
}

double automatic(const Scene& scene) {
  const bool quadratic = scene.kernel.order > 1;
  if (scene.stabiliser.action == StabiliserAction::viscosity)
    return quadratic ? auto_viscosity_quadratic : auto_viscosity;
  if (scene.stabiliser.kind == StabiliserKind::cell) return auto_cell_stiffness;
  return quadratic ? traits_of(scene.formulation).pair_beside_quadratic : auto_pair_stiffness;
}

template <int D>
ScalarField strengths(const Scene& scene, const Discretisation<D>& body, const VectorField<D>& at) {
  const double coefficient = scene.stabiliser.coefficient.value_or(automatic(scene));
  std::vector<double> units;
  for (const MaterialScene& material : scene.materials)
    units.push_back(unit(scene, material, body.spacing));
  ScalarField result(at.rows());
  for (Index s = 0; s < at.rows(); ++s) {
    const Vector<D> x = at.row(s).transpose();
    const std::size_t material = material_at<D>(scene, x, 1e-9 * body.spacing);
    result[s] = coefficient * units[material];
  }
  return result;
}

}  // namespace

template <int D>
void add_stabiliser(const Scene& scene, Discretisation<D>& body) {
  const StabiliserScene& stabiliser = scene.stabiliser;
  if (stabiliser.kind == StabiliserKind::none) return;
  SparseMatrix S;
  if (stabiliser.kind == StabiliserKind::cell) {
    if constexpr (D == 2) {
      ScalarField modulus = strengths<2>(scene, body, body.points.X);
      if (stabiliser.action == StabiliserAction::stiffness) {
        body.hourglass = {hourglass_weights(body.particles, body.gradient), std::move(modulus)};
        return;
      }
      S = normal_matrix(hourglass_rows(body.particles, body.gradient), modulus);
    }
  } else {
    const auto narrow =
        pair_gradient<D>(body.particles.X, body.particles.V, body.spacing, scene.kernel.order);
    S = pair_stabiliser<D>(narrow, body.particles.X, body.particles.V, body.spacing,
                           strengths<D>(scene, body, body.particles.X));
  }
  (stabiliser.action == StabiliserAction::stiffness ? body.stiffness : body.viscosity) =
      std::move(S);
}

template void add_stabiliser<1>(const Scene&, Discretisation<1>&);
template void add_stabiliser<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
