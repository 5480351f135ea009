/// Internal forces come from an energy that rigid motions do not change.

#include <numbers>

#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

/// All materials on one body, without and with its stabiliser as stiffness.
template <class Use>
void for_materials(const Variant& variant, const Use& use) {
  for (const std::string& kind : {std::string("none"), variant.stabiliser()})
    discretised(scene_of(variant, as_stiffness(kind)), [&](auto body) {
      for (const Material& material : materials()) {
        SCOPED_TRACE(std::string(material.law) + ' ' + material.assumption + ", stabiliser " +
                     kind);
        set_material(body, material);
        use(body, material);
      }
    });
}

template <int D>
double energy_at(const Discretisation<D>& body, State<D>& state, const VectorField<D>& u) {
  state.u = u;
  evaluate<D>(body, state);
  return elastic_energy<D>(body, state);
}

class ForceLaws : public testing::TestWithParam<Variant> {};

/// f = −∂U/∂u by central differences, at some degrees of freedom and in some directions.
TEST_P(ForceLaws, ForceIsMinusTheGradientOfTheEnergy) {
  for_materials(GetParam(), [&]<int D>(const Discretisation<D>& body, const Material&) {
    Random random(11);
    const VectorField<D> u = deformed<D>(body, random);
    State<D> state = evaluated<D>(body, u);
    const VectorField<D> f = state.f;
    const double scale = f.cwiseAbs().maxCoeff();
    const double h = 1e-5 * spacing;
    const auto slope = [&](const VectorField<D>& direction) {
      const double up = energy_at<D>(body, state, u + h * direction);
      return (up - energy_at<D>(body, state, u - h * direction)) / (2.0 * h);
    };

    for (int k = 0; k < 10; ++k) {
      VectorField<D> unit = VectorField<D>::Zero(body.nodes(), D);
      const auto dof = static_cast<Index>(0.5 * (random() + 1.0) * static_cast<double>(u.size()));
      unit.data()[dof] = 1.0;
      EXPECT_NEAR(slope(unit), -f.data()[dof], 1e-6 * scale) << "degree of freedom " << dof;
    }
    for (int k = 0; k < 3; ++k) {
      const VectorField<D> direction = random.field<D>(body.nodes(), 1.0);
      EXPECT_NEAR(slope(direction), -f.cwiseProduct(direction).sum(), 1e-6 * f.norm()) << k;
    }
  });
}

TEST_P(ForceLaws, ForcesHaveNoResultant) {
  for_materials(GetParam(), [&]<int D>(const Discretisation<D>& body, const Material&) {
    Random random(12);
    const State<D> state = evaluated<D>(body, deformed<D>(body, random));

    const Vector<D> sum = state.f.colwise().sum().transpose();

    EXPECT_LE(sum.norm(), 1e-12 * state.f.rowwise().norm().sum());
  });
}

/// Σ x × f = 0; linear elasticity, which does not know the deformed configuration, has Σ X × f = 0.
TEST_P(ForceLaws, ForcesHaveNoMoment) {
  if (GetParam().one_dimensional()) GTEST_SKIP() << "a bar has no moments";
  if (!GetParam().linear_exact()) GTEST_SKIP() << "does not see a rotation as one";
  for_materials(GetParam(), [&]<int D>(const Discretisation<D>& body, const Material& material) {
    if constexpr (D == 2) {
      Random random(13);
      const State<D> state = evaluated<D>(body, deformed<D>(body, random));
      VectorField<D> x = body.particles.X;
      if (!material.linear()) x += state.u;

      const double moment =
          (x.col(0).cwiseProduct(state.f.col(1)) - x.col(1).cwiseProduct(state.f.col(0))).sum();

      const double scale = x.rowwise().norm().cwiseProduct(state.f.rowwise().norm()).sum();
      EXPECT_LE(std::abs(moment), 1e-12 * scale);
    }
  });
}

TEST_P(ForceLaws, RigidRotationCausesNoStress) {
  if (GetParam().one_dimensional() || !GetParam().linear_exact()) GTEST_SKIP() << "no rotations";
  for_materials(GetParam(), [&]<int D>(const Discretisation<D>& body, const Material& material) {
    if constexpr (D == 2) {
      if (material.linear()) return;
      for (const double degrees : {90.0, 137.0, 180.0, -120.0}) {
        const Tensor<2> R = rotation(degrees * std::numbers::pi / 180.0);

        const State<D> state = evaluated<D>(
            body, affine<D>(body.particles.X, R - Tensor<2>::Identity(), Vector<2>(0.4, -0.7)));

        EXPECT_LE(state.P.cwiseAbs().maxCoeff(), 1e-11 * young) << degrees;
        EXPECT_LE(state.f.cwiseAbs().maxCoeff(), 1e-11 * young * spacing) << degrees;
      }
    }
  });
}

/// A rigid motion after the deformation changes no energy and turns the forces with the body;
/// linear elasticity allows displacements W X + b with W = −Wᵀ on top instead.
TEST_P(ForceLaws, EnergyIsInvariantUnderRigidMotion) {
  if (!GetParam().linear_exact()) GTEST_SKIP() << "does not see a rotation as one";
  for_materials(GetParam(), [&]<int D>(const Discretisation<D>& body, const Material& material) {
    Random random(14);
    const VectorField<D> u = deformed<D>(body, random);
    const State<D> before = evaluated<D>(body, u);
    const VectorField<D> x = body.particles.X + u;
    const Vector<D> b = Vector<D>::Constant(0.05);
    Tensor<D> R = Tensor<D>::Identity();
    if constexpr (D == 2) R = rotation(2.0);
    Tensor<D> W = Tensor<D>::Zero();
    if constexpr (D == 2) W << 0.0, -0.6, 0.6, 0.0;

    const State<D> after = evaluated<D>(
        body, material.linear() ? VectorField<D>(u + affine<D>(body.particles.X, W, b))
                                : VectorField<D>(affine<D>(x, R, b) - body.particles.X));

    const double energy = elastic_energy<D>(body, before);
    EXPECT_NEAR(elastic_energy<D>(body, after), energy, 1e-12 * energy);
    const VectorField<D> turned =
        material.linear() ? before.f : VectorField<D>(before.f * R.transpose());
    EXPECT_LE((after.f - turned).cwiseAbs().maxCoeff(), 1e-11 * before.f.cwiseAbs().maxCoeff());
  });
}

INSTANTIATE_TEST_SUITE_P(, ForceLaws, testing::ValuesIn(adjoint_variants()), ByName());

}  // namespace
}  // namespace tlsph::property
