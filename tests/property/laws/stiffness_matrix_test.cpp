/// The assembled stiffness is −∂f/∂u of the products a step makes.

#include "tlsph/dynamics/stiffness_matrix.hpp"
#include "property/bodies.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph::property {
namespace {

class StiffnessMatrix : public testing::TestWithParam<Variant> {};

TEST_P(StiffnessMatrix, IsTheDerivativeOfTheForce) {
  discretised(scene_of(GetParam(), as_stiffness(GetParam().stabiliser())),
              []<int D>(const Discretisation<D>& body) {
                const Eigen::MatrixXd expected = dense_stiffness<D>(body);

                const SparseMatrix K =
                    stiffness_matrix<D>(body, TensorField<D>::Zero(body.points.size(), D * D));

                EXPECT_LE((Eigen::MatrixXd(K) - expected).cwiseAbs().maxCoeff(),
                          1e-12 * expected.cwiseAbs().maxCoeff());
                EXPECT_EQ(SparseMatrix(K - SparseMatrix(K.transpose())).norm(), 0.0);
              });
}

/// Away from rest it is that of the deformed body.
TEST_P(StiffnessMatrix, FollowsTheTangent) {
  discretised(
      scene_of(GetParam(), {"material.law=neo-hookean"}), []<int D>(const Discretisation<D>& body) {
        Random random(21);
        const VectorField<D> u = deformed<D>(body, random);
        const VectorField<D> du = random.field<D>(body.nodes(), 1.0);
        const double h = 1e-6 * body.spacing;
        const State<D> up = evaluated<D>(body, u + h * du);
        const State<D> down = evaluated<D>(body, u - h * du);
        const State<D> at = evaluated<D>(body, u);
        const Index dofs = body.nodes() * D;

        const Eigen::VectorXd image =
            stiffness_matrix<D>(body, at.H) * Eigen::Map<const Eigen::VectorXd>(du.data(), dofs);

        const VectorField<D> slope = (down.f - up.f) / (2 * h);
        EXPECT_LE(
            (image - Eigen::Map<const Eigen::VectorXd>(slope.data(), dofs)).cwiseAbs().maxCoeff(),
            1e-5 * image.cwiseAbs().maxCoeff());
      });
}

/// Bodies of more than ten thousand particles, whose products are made by the loops of a sweep.
struct LargeBody {
  std::string name;
  Variant variant;
  std::vector<std::string> overrides;
};

void PrintTo(const LargeBody& body, std::ostream* out) {
  *out << body.name;
}

std::vector<LargeBody> large_bodies() {
  const std::string neo = "material.law=neo-hookean";
  const Variant cells{"box", "stress-point", "", "", ""};
  const Variant quads{"jittered", "stress-point", "", "", ""};
  const Variant nodes{"hole", "variational", "gradient", "wendland-c2", "2.5"};
  const Variant bar{"interval", "stress-point", "", "", ""};
  return {{"cells", cells, {neo, "body.spacing=0.001"}},
          {"stiffened", cells, {neo, "body.spacing=0.001", "stabiliser.kind=cell"}},
          {"quads", quads, {neo, "body.spacing=0.001", "stabiliser.kind=cell"}},
          {"two_laws", cells, {neo, "body.spacing=0.001", "stabiliser.kind=cell"}},
          {"plane_stress",
           cells,
           {neo, "material.assumption=stress", "body.spacing=0.001", "stabiliser.kind=cell"}},
          {"nodes", nodes, {neo, "body.spacing=0.0012", "stabiliser.kind=pair"}},
          {"bar", bar, {neo, "body.spacing=0.00004"}}};
}

/// Every fourth run of seven points of another law.
template <int D>
void mix_in_another_law(Discretisation<D>& body) {
  body.regions.push_back({make_law<D>(LawName::st_venant_kirchhoff, Assumption::strain, young, 0.2),
                          2.0 * density,
                          {}});
  for (int s = 0; s < body.points.size(); ++s)
    body.regions[s / 7 % 4 == 0 ? 1 : 0].points.push_back(s);
}

class LargeBodies : public testing::TestWithParam<LargeBody> {};

TEST_P(LargeBodies, HaveTheProductsOfTheirStiffnessMatrix) {
  discretised(
      scene_of(GetParam().variant, GetParam().overrides), []<int D>(Discretisation<D> body) {
        ASSERT_GE(body.nodes(), 10'000);
        if (GetParam().name == "two_laws") mix_in_another_law<D>(body);
        Random random(21);
        const State<D> at = evaluated<D>(body, deformed<D>(body, random));
        const VectorField<D> du = random.field<D>(body.nodes(), 1.0);
        const Eigen::VectorXd expected = -(stiffness_matrix<D>(body, at.H) *
                                           Eigen::Map<const Eigen::VectorXd>(du.data(), du.size()));
        LinearisedForces<D> forces(body, at);
        VectorField<D> product = VectorField<D>::Zero(body.nodes(), D);

        forces.product(du, product);

        EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(product.data(), product.size()) - expected)
                      .cwiseAbs()
                      .maxCoeff(),
                  1e-12 * expected.cwiseAbs().maxCoeff());
      });
}

INSTANTIATE_TEST_SUITE_P(, LargeBodies, testing::ValuesIn(large_bodies()), ByName());
INSTANTIATE_TEST_SUITE_P(, StiffnessMatrix, testing::ValuesIn(adjoint_variants()), ByName());

}  // namespace
}  // namespace tlsph::property
