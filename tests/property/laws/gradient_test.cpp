/// What every gradient and its adjoint promise, whatever they act on.

#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

class GradientLaws : public testing::TestWithParam<Variant> {};

TEST_P(GradientLaws, ConstantsHaveNoGradient) {
  discretised(scene_of(GetParam()), [&]<int D>(const Discretisation<D>& body) {
    const VectorField<D> one = VectorField<D>::Ones(body.nodes(), D);
    TensorField<D> H(body.points.size(), D * D);

    body.gradient.gradient(one, H);

    EXPECT_LE(H.cwiseAbs().maxCoeff() * spacing, 1e-12);
  });
}

TEST_P(GradientLaws, PositionsHaveTheIdentityAsGradient) {
  if (!GetParam().linear_exact()) GTEST_SKIP() << "differentiates constants only";
  discretised(scene_of(GetParam()), [&]<int D>(const Discretisation<D>& body) {
    TensorField<D> H(body.points.size(), D * D);

    body.gradient.gradient(body.particles.X, H);

    for (Index s = 0; s < H.rows(); ++s)
      ASSERT_LE((tensor_at<D>(H, s) - Tensor<D>::Identity()).cwiseAbs().maxCoeff(), 1e-12) << s;
  });
}

TEST_P(GradientLaws, ForceOperatorIsTheAdjoint) {
  discretised(scene_of(GetParam()), [&]<int D>(const Discretisation<D>& body) {
    for (int a = 0; a < D; ++a) {
      const Eigen::MatrixXd G = body.gradient.matrix(a);
      const Eigen::MatrixXd expected = -G.transpose() * body.points.V.asDiagonal();

      const Eigen::MatrixXd actual = body.divergence.matrix(a);

      ASSERT_EQ(actual.rows(), expected.rows());
      ASSERT_EQ(actual.cols(), expected.cols());
      EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), 1e-15 * expected.cwiseAbs().maxCoeff());
    }
  });
}

/// The patch test: an affine displacement strains the body evenly, to the stress of the law.
TEST_P(GradientLaws, AffineDisplacementStressesEvenly) {
  if (!GetParam().linear_exact()) GTEST_SKIP() << "differentiates constants only";
  discretised(scene_of(GetParam()), [&]<int D>(Discretisation<D> body) {
    Random random(3);
    for (const Material& material : materials()) {
      set_material<D>(body, material);
      const Tensor<D> A = random.tensor<D>(0.2);
      Vector<D> b;
      for (int i = 0; i < D; ++i) b[i] = random();

      const State<D> state = evaluated<D>(body, affine<D>(body.particles.X, A, b));

      const Tensor<D> expected = pk1<D>(body.regions.front().law, A);
      for (Index s = 0; s < state.P.rows(); ++s)
        ASSERT_LE((tensor_at<D>(state.P, s) - expected).cwiseAbs().maxCoeff(), 1e-11 * young)
            << material.law << ' ' << material.assumption << ", point " << s;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(, GradientLaws, testing::ValuesIn(adjoint_variants()), ByName());

/// Largest |D P + B P| of a constant stress, in units of the stress on the face of a cell.
template <int D>
ScalarField unbalanced(const Discretisation<D>& body, const Tensor<D>& P) {
  TensorField<D> field(body.points.size(), D * D);
  for (Index s = 0; s < field.rows(); ++s) Eigen::Map<Tensor<D>>(field.data() + s * D * D) = P;
  VectorField<D> f(body.nodes(), D);
  body.divergence.divergence(field, f);
  f += body.particles.B * P.transpose();
  return f.rowwise().norm() / std::pow(spacing, D - 1);
}

class CellBalance : public testing::TestWithParam<std::string> {};

/// The divergence theorem holds cell by cell on any quadrilaterals: constant stress and the
/// tractions it exerts on the boundary are in balance at every node.
TEST_P(CellBalance, ConstantStressBalancesItsTractions) {
  const Variant variant{GetParam(), "stress-point", "", "", ""};
  discretised(scene_of(variant), [&]<int D>(const Discretisation<D>& body) {
    Random random(4);
    EXPECT_LE(unbalanced<D>(body, random.tensor<D>(1.0)).maxCoeff(), 1e-12);
  });
}

INSTANTIATE_TEST_SUITE_P(, CellBalance,
                         testing::Values("interval", "box", "jittered", "disc", "hole"), ByName());

class InteriorBalance : public testing::TestWithParam<Variant> {};

/// Collocated and wide operators miss the boundary, but inside a lattice symmetry balances them.
TEST_P(InteriorBalance, ConstantStressIsInBalanceInside) {
  const std::vector<std::string> larger =
      GetParam().one_dimensional()
          ? std::vector<std::string>{}
          : std::vector<std::string>{"body.shape.box=[[0.0, 0.0], [0.26, 0.26]]"};
  discretised(scene_of(GetParam(), larger), [&]<int D>(const Discretisation<D>& body) {
    Random random(5);
    const ScalarField error = unbalanced<D>(body, random.tensor<D>(1.0));
    const Vector<D> lower = body.particles.X.colwise().minCoeff().transpose();
    const Vector<D> upper = body.particles.X.colwise().maxCoeff().transpose();
    int inside = 0;
    for (Index q = 0; q < body.nodes(); ++q) {
      const Vector<D> X = body.particles.X.row(q).transpose();
      if ((X - lower).minCoeff() < 4.5 * spacing || (upper - X).minCoeff() < 4.5 * spacing)
        continue;
      ++inside;
      ASSERT_LE(error[q], 1e-12) << "at " << X.transpose();
    }
    EXPECT_GT(inside, 0);
  });
}

std::vector<Variant> wide_lattices() {
  std::vector<Variant> chosen;
  for (const Variant& variant : adjoint_variants())
    if (!variant.on_cells() && (variant.layout == "interval" || variant.layout == "box"))
      chosen.push_back(variant);
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(, InteriorBalance, testing::ValuesIn(wide_lattices()), ByName());

}  // namespace
}  // namespace tlsph::property
