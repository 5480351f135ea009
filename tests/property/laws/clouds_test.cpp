/// What bodies of scattered nodes promise: quadrature, the patch test, constant stress in balance.

#include "property/bodies.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph::property {
namespace {

class CloudLaws : public testing::TestWithParam<Variant> {};

/// Σ V is the area of the shape itself, arcs included, and B closes over it.
TEST_P(CloudLaws, VolumesIntegrateWhatTheCorrectionNeeds) {
  if (GetParam().formulation != "consistent") GTEST_SKIP() << "volumes stay Voronoi cells";
  const Scene scene = scene_of(GetParam());
  const auto& shape = std::get<Shape<2>>(scene.body.shape);
  const Discretisation<2> body = build<2>(scene);
  const ScalarField& V = body.particles.V;

  EXPECT_NEAR(V.sum() / area(shape), 1.0, 1e-12);
  EXPECT_GT(V.minCoeff(), 0.0);
  const Tensor<2> first = body.particles.B.transpose() * body.particles.X;
  EXPECT_LE((first - V.sum() * Tensor<2>::Identity()).norm(), 1e-12 * V.sum());
  EXPECT_LE(body.particles.B.colwise().sum().norm(), 1e-12 * boundary_measure(shape));
}

/// Under the same stress everywhere and the tractions that belong to it no particle accelerates.
TEST_P(CloudLaws, ConstantStressIsInBalance) {
  if (GetParam().formulation == "variational") GTEST_SKIP() << "its adjoint is not exact";
  const Discretisation<2> body = build<2>(scene_of(GetParam()));
  if (!GetParam().on_cells() && GetParam().consistency.empty())
    GTEST_SKIP() << "its adjoint is not exact";
  Tensor<2> P0;
  P0 << 1.0, -0.4, 0.7, 0.5;
  TensorField<2> P(body.points.size(), 4);
  for (Index s = 0; s < P.rows(); ++s) Eigen::Map<Tensor<2>>(P.row(s).data()) = P0;

  VectorField<2> force = VectorField<2>::Zero(body.nodes(), 2);
  for (int a = 0; a < 2; ++a) {
    const SparseMatrix D = body.divergence.matrix(a);
    for (int i = 0; i < 2; ++i) force.col(i) += D * P.col(2 * i + a);
  }
  force += body.particles.B * P0.transpose();

  for (Index q = 0; q < body.nodes(); ++q)
    EXPECT_LE(force.row(q).norm() / body.mass[q], 1e-9 * P0.norm() / (density * body.spacing))
        << body.particles.X.row(q);
}

std::vector<Variant> clouds() {
  std::vector<Variant> chosen;
  for (const Variant& variant : adjoint_variants())
    if (variant.on_triangles()) chosen.push_back(variant);
  return chosen;
}

INSTANTIATE_TEST_SUITE_P(, CloudLaws, testing::ValuesIn(clouds()), ByName());

}  // namespace
}  // namespace tlsph::property
