/// A stabiliser is a quadratic energy that sees what the gradient does not, and nothing else.

#include <Eigen/Eigenvalues>

#include "property/bodies.hpp"

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
                  [&](const auto& disc) {
                    const bool stiff = action == "stiffness";
                    const Eigen::MatrixXd S = stiff ? disc.stiffness : disc.viscosity;
                    ASSERT_EQ(S.rows(), disc.nodes());
                    ASSERT_EQ((stiff ? disc.viscosity : disc.stiffness).nonZeros(), 0);
                    use(disc, S);
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
  for_actions([](const auto& disc, const Eigen::MatrixXd& S) {
    const double scale = S.cwiseAbs().maxCoeff();
    const Eigen::VectorXd one = Eigen::VectorXd::Ones(S.rows());
    EXPECT_LE((S * one).cwiseAbs().maxCoeff(), 1e-12 * scale);
    const Eigen::MatrixXd X = disc.particles.X;
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

/// With the stabiliser as stiffness nothing but a rigid motion is free of energy.
TEST_P(StabiliserLaws, LeavesRigidMotionsAsOnlyZeroModes) {
  if (!GetParam().linear_exact()) GTEST_SKIP() << "does not see a rotation as one";
  discretised(scene_of(GetParam(), as_stiffness(GetParam().stabiliser())),
              []<int D>(const Discretisation<D>& disc) {
                const Eigen::MatrixXd K = dense_stiffness<D>(disc);

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
