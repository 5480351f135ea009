/// A stabiliser is a quadratic energy that sees what the gradient does not, and nothing else.

#include <Eigen/Eigenvalues>

#include "property/bodies.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph::property {
namespace {

class StabiliserLaws : public testing::TestWithParam<Variant> {
 protected:
  /// Hands over the matrix of both actions, [N/m] as stiffness and [kg/s] as viscosity.
  template <class Use>
  void for_actions(const Use& use) const {
    for (const std::string action : {"stiffness", "viscosity"}) {
      SCOPED_TRACE(action);
      discretised(scene_of(GetParam(), {"stabiliser.kind=" + GetParam().stabiliser(),
                                        "stabiliser.as=" + action}),
                  [&](const auto& body) {
                    const bool stiff = action == "stiffness";
                    const Eigen::MatrixXd S = stiff ? stabiliser_matrix(body) : body.viscosity;
                    ASSERT_EQ(S.rows(), body.nodes());
                    ASSERT_EQ(stiff ? body.viscosity.nonZeros() > 0 : has_stabiliser(body), false);
                    use(body, S);
                  });
    }
  }
};

TEST_P(StabiliserLaws, IsSymmetric) {
  for_actions([](const auto&, const Eigen::MatrixXd& S) {
    EXPECT_EQ((S - S.transpose()).cwiseAbs().maxCoeff(), 0.0);
  });
}

TEST_P(StabiliserLaws, VanishesOnLinearFields) {
  for_actions([](const auto& body, const Eigen::MatrixXd& S) {
    const double scale = S.cwiseAbs().maxCoeff();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(S.rows());
    EXPECT_LE((S * one).cwiseAbs().maxCoeff(), 1e-12 * scale);
    const Eigen::MatrixXd X = body.particles.X;
    EXPECT_LE((S * X).cwiseAbs().maxCoeff(), 1e-12 * scale * X.cwiseAbs().maxCoeff());
  });
}

TEST_P(StabiliserLaws, IsPositiveSemiDefinite) {
  for_actions([](const auto&, const Eigen::MatrixXd& S) {
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(S).eigenvalues();
    EXPECT_GE(values.minCoeff(), -1e-13 * values.maxCoeff());
    EXPECT_GT(values.maxCoeff(), 0.0);
  });
}

/// Forces, one row of them and the energy are those of the matrix, however it is held.
TEST_P(StabiliserLaws, ActsAsItsMatrix) {
  discretised(scene_of(GetParam(), as_stiffness(GetParam().stabiliser())),
              []<int D>(const Discretisation<D>& body) {
                Random random(5);
                const VectorField<D> u = random.field<D>(body.nodes(), 1.0);
                const Eigen::MatrixXd S = stabiliser_matrix<D>(body);
                const Eigen::MatrixXd expected = S * u;
                VectorField<D> force = VectorField<D>::Zero(body.nodes(), D);

                subtract_stabiliser<D>(body, u, force);

                const double scale = expected.cwiseAbs().maxCoeff();
                EXPECT_LE((force + expected).cwiseAbs().maxCoeff(), 1e-13 * scale);
                for (Index q = 0; q < body.nodes(); ++q)
                  EXPECT_EQ(stabiliser_row<D>(body, q, u), Vector<D>(-force.row(q).transpose()));
                const double energy = 0.5 * u.cwiseProduct(VectorField<D>(expected)).sum();
                EXPECT_NEAR(stabiliser_energy<D>(body, u), energy, 1e-13 * energy);
              });
}

/// With the stabiliser as stiffness nothing but a rigid motion is free of energy.
TEST_P(StabiliserLaws, LeavesRigidMotionsAsOnlyZeroModes) {
  if (!GetParam().linear_exact()) GTEST_SKIP() << "does not see a rotation as one";
  discretised(scene_of(GetParam(), as_stiffness(GetParam().stabiliser())),
              []<int D>(const Discretisation<D>& body) {
                const Eigen::MatrixXd K = dense_stiffness<D>(body);

                const Eigen::VectorXd values =
                    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();

                const Index rigid = D == 1 ? 1 : 3;
                EXPECT_LE(values.head(rigid).cwiseAbs().maxCoeff(), 1e-11 * values.maxCoeff());
                EXPECT_GE(values[rigid], 1e-5 * values.maxCoeff());
              });
}

INSTANTIATE_TEST_SUITE_P(, StabiliserLaws, testing::ValuesIn(adjoint_variants()), ByName());

}  // namespace
}  // namespace tlsph::property
