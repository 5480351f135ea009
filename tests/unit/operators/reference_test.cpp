// Operators against the reference matrices, entry by entry.

#include <gtest/gtest.h>

#include "reference_matrices.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/stabilisers.hpp"

namespace tlsph {
namespace {

using reference::Entry;

template <int D>
Particles<D> particles_of(const std::string& layout) {
  Particles<D> particles;
  particles.X = reference::matrix(layout + "/X.mtx");
  particles.V = reference::matrix(layout + "/V.mtx");
  particles.spacing = 0.25;
  const Eigen::MatrixXd cells = reference::matrix(layout + "/cells.mtx");
  for (Index s = 0; s < cells.rows(); ++s) {
    Cell<D> cell;
    for (std::size_t c = 0; c < cell.size(); ++c)
      cell[c] = static_cast<int>(cells(s, static_cast<Index>(c)));
    particles.cells.push_back(cell);
  }
  return particles;
}

template <int D>
VectorOperator<D> gradient_of(const Entry& entry, const Particles<D>& particles,
                              const MaterialPoints<D>& points) {
  if (entry.formulation == "stress-point" && entry.correction.empty())
    return cell_gradient<D>(particles, points);
  const AnyKernel kernel = kernel_by_name(entry.kernel).value();
  const double h = entry.radius();
  if (entry.formulation == "stress-point")
    return point_gradient<D>(kernel, h, points.X, particles.X);
  if (entry.formulation == "thesis") return plain_gradient<D>(kernel, h, particles.X, particles.V);
  const Correction correction = entry.correction == "none"       ? Correction::none
                                : entry.correction == "gradient" ? Correction::gradient
                                                                 : Correction::mixed;
  return collocated_gradient<D>(kernel, h, particles.X, particles.V, correction);
}

template <int D>
Eigen::MatrixXd built(const Entry& entry) {
  const auto particles = particles_of<D>(entry.layout);
  const MaterialPoints<D> points{reference::matrix(entry.layout + "/points_X.mtx"),
                                 reference::matrix(entry.layout + "/points_V.mtx")};
  if (entry.op == "W")
    return kernel_matrix<D>(kernel_by_name(entry.kernel).value(), entry.radius(), particles.X,
                            particles.V);
  const auto G = gradient_of<D>(entry, particles, points);
  if (entry.op.starts_with("G_")) return G.matrix(entry.direction());
  if (entry.op.starts_with("D_"))
    return G.negative_adjoint(entry.formulation == "stress-point" ? points.V : particles.V)
        .matrix(entry.direction());
  if (entry.op == "S_pair")
    return pair_stabiliser<D>(G, particles.X, particles.V, particles.spacing,
                              ScalarField::Ones(particles.size()));
  if constexpr (D == 2) {
    const SparseMatrix A = hourglass_rows(particles, G);
    if (entry.op == "A_cell") return A;
    if (entry.op == "S_cell") return normal_matrix(A, ScalarField::Ones(A.rows()));
  }
  throw std::runtime_error("no such operator: " + entry.op);
}

class ReferenceMatrices : public testing::TestWithParam<Entry> {};

TEST_P(ReferenceMatrices, AgreeEntryByEntry) {
  const Entry& entry = GetParam();
  const Eigen::MatrixXd expected = reference::matrix(entry.file);

  const Eigen::MatrixXd actual = entry.dimension == "1" ? built<1>(entry) : built<2>(entry);

  ASSERT_EQ(actual.rows(), expected.rows());
  ASSERT_EQ(actual.cols(), expected.cols());
  const double scale = expected.lpNorm<Eigen::Infinity>();
  EXPECT_LE((actual - expected).lpNorm<Eigen::Infinity>(), reference::tolerance * scale);
}

/// All but those with boundary values folded in, which are the boundary room's.
INSTANTIATE_TEST_SUITE_P(, ReferenceMatrices,
                         testing::ValuesIn(reference::index([](const Entry& entry) {
                           const bool bare =
                               entry.formulation != "thesis" || entry.correction.empty();
                           return bare && entry.formulation != "mirror";
                         })),
                         reference::Name());

}  // namespace
}  // namespace tlsph
