// Operators with boundary values folded in, against the reference matrices, entry by entry.

#include <gtest/gtest.h>

#include "reference_matrices.hpp"
#include "tlsph/formulations/extension.hpp"
#include "tlsph/formulations/ghosts.hpp"

namespace tlsph {
namespace {

using reference::Entry;

// Signals of the bar: strain and traction at the left end, displacement of the right end.
constexpr std::size_t strain = 0, displacement = 1, traction = 2;

Particles<1> bar() {
  Particles<1> particles;
  particles.X = reference::matrix("line7/X.mtx");
  particles.V = reference::matrix("line7/V.mtx");
  particles.spacing = 0.25;
  particles.spacings[0] = 0.25;
  particles.frame = LatticeFrame<1>{Vector<1>(0.0), Vector<1>(0.25), {7}};
  return particles;
}

Edges<1> pulled_and_held() {
  Edges<1> edges;
  edges[0][0].traction = traction;
  edges[0][0].gradient = strain;
  edges[0][1].prescribed[0] = true;
  edges[0][1].displacement[0] = displacement;
  return edges;
}

LatticeStencil<1> stencil_of(const Entry& entry) {
  return lattice_stencil<1>(kernel_by_name(entry.kernel).value(), std::stod(entry.support),
                            *bar().frame);
}

/// Columns of the terms of the given signals.
Eigen::MatrixXd load_columns(const std::vector<SignalTerm>& terms,
                             const std::vector<std::size_t>& signals) {
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(7, static_cast<Index>(signals.size()));
  for (const SignalTerm& term : terms)
    for (std::size_t k = 0; k < signals.size(); ++k)
      if (term.signal == signals[k]) columns(term.slot, static_cast<Index>(k)) += term.weight;
  return columns;
}

Eigen::MatrixXd folded(const Entry& entry) {
  const auto operators = folded_operators<1>(stencil_of(entry), *bar().frame, bar().V,
                                             pulled_and_held(), TractionGhost::mirrored);
  if (entry.op == "G_x") return operators.gradient.matrix(0);
  if (entry.op == "D_x") return operators.divergence.matrix(0);
  if (entry.op == "G_load") return load_columns(operators.gradient_terms, {strain, displacement});
  return load_columns(operators.force_terms, {traction});
}

/// The strain of the thesis's ghosts for unit displacements, or unit signals.
Eigen::MatrixXd closed(const Entry& entry) {
  const GhostClosure closure = entry.correction == "consistent"   ? GhostClosure::consistent
                               : entry.correction == "as-printed" ? GhostClosure::as_printed
                                                                  : GhostClosure::eta;
  const GhostGradient<1> gradient(stencil_of(entry), bar(), pulled_and_held(), closure,
                                  SolverChoice::automatic, {});
  auto workspace = gradient.workspace();
  const bool loads = entry.op == "G_load";
  Eigen::MatrixXd columns(7, loads ? 2 : 7);
  for (Index k = 0; k < columns.cols(); ++k) {
    VectorField<1> u = VectorField<1>::Zero(7, 1);
    std::vector<double> signals(3, 0.0);
    (loads ? signals[static_cast<std::size_t>(k)] : u(k, 0)) = 1.0;
    TensorField<1> H(7, 1);
    gradient.apply(u, signals, H, workspace);
    columns.col(k) = H;
  }
  return columns;
}

Eigen::MatrixXd on_ghosts(const Entry& entry) {
  const GhostGradient<1> gradient(stencil_of(entry), bar(), pulled_and_held(),
                                  GhostClosure::consistent, SolverChoice::automatic, {});
  if (entry.op == "W") return gradient.kernel_matrix();
  return gradient.plain_gradient().matrix(0);
}

class ReferenceBoundaries : public testing::TestWithParam<Entry> {};

TEST_P(ReferenceBoundaries, AgreeEntryByEntry) {
  const Entry& entry = GetParam();
  const Eigen::MatrixXd expected = reference::matrix(entry.file);

  const Eigen::MatrixXd actual = entry.formulation == "mirror"   ? folded(entry)
                                 : entry.correction == "lattice" ? on_ghosts(entry)
                                                                 : closed(entry);

  ASSERT_EQ(actual.rows(), expected.rows());
  ASSERT_EQ(actual.cols(), expected.cols());
  const double scale = expected.lpNorm<Eigen::Infinity>();
  EXPECT_LE((actual - expected).lpNorm<Eigen::Infinity>(), reference::tolerance * scale);
}

/// The modified SPH matrix itself stays inside its factorisation; `closed` is what it does.
INSTANTIATE_TEST_SUITE_P(, ReferenceBoundaries,
                         testing::ValuesIn(reference::index([](const Entry& entry) {
                           const bool thesis =
                               entry.formulation == "thesis" && !entry.correction.empty();
                           return (thesis || entry.formulation == "mirror") &&
                                  entry.op != "W_modified";
                         })),
                         reference::Name());

}  // namespace
}  // namespace tlsph
