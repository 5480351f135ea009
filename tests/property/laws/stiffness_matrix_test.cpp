/// The assembled stiffness is −∂f/∂u of the products a step makes.

#include "tlsph/dynamics/stiffness_matrix.hpp"
#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

class StiffnessMatrix : public testing::TestWithParam<Variant> {};

TEST_P(StiffnessMatrix, IsTheDerivativeOfTheForce) {
  discretised(scene_of(GetParam(), as_stiffness(GetParam().stabiliser())),
              []<int D>(const Discretisation<D>& disc) {
                const Eigen::MatrixXd expected = dense_stiffness<D>(disc);

                const SparseMatrix K =
                    stiffness_matrix<D>(disc, TensorField<D>::Zero(disc.points.size(), D * D));

                EXPECT_LE((Eigen::MatrixXd(K) - expected).cwiseAbs().maxCoeff(),
                          1e-12 * expected.cwiseAbs().maxCoeff());
                EXPECT_EQ(SparseMatrix(K - SparseMatrix(K.transpose())).norm(), 0.0);
              });
}

/// Away from rest it is that of the deformed body.
TEST_P(StiffnessMatrix, FollowsTheTangent) {
  discretised(
      scene_of(GetParam(), {"material.law=neo-hookean"}), []<int D>(const Discretisation<D>& disc) {
        Random random(21);
        const VectorField<D> u = deformed<D>(disc, random);
        const VectorField<D> du = random.field<D>(disc.nodes(), 1.0);
        const double h = 1e-6 * disc.spacing;
        const State<D> up = evaluated<D>(disc, u + h * du);
        const State<D> down = evaluated<D>(disc, u - h * du);
        const State<D> at = evaluated<D>(disc, u);
        const Index dofs = disc.nodes() * D;

        const Eigen::VectorXd image =
            stiffness_matrix<D>(disc, at.H) * Eigen::Map<const Eigen::VectorXd>(du.data(), dofs);

        const VectorField<D> slope = (down.f - up.f) / (2 * h);
        EXPECT_LE(
            (image - Eigen::Map<const Eigen::VectorXd>(slope.data(), dofs)).cwiseAbs().maxCoeff(),
            1e-5 * image.cwiseAbs().maxCoeff());
      });
}

INSTANTIATE_TEST_SUITE_P(, StiffnessMatrix, testing::ValuesIn(adjoint_variants()), ByName());

}  // namespace
}  // namespace tlsph::property
