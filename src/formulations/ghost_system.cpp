#include "ghost_system.hpp"

#include <fmt/format.h>

#include <utility>

#include "tlsph/formulations/extension.hpp"

namespace tlsph {
namespace {

enum class Columns { inner, outer };

/// The rows `nodes` of W: of their columns the inner ones, which are nodes too, in the order of
/// `nodes`; or the outer ones, which are not, where they stand.
SparseMatrix block(const SparseMatrix& W, const std::vector<int>& nodes, Columns wanted) {
  std::vector<int> position(static_cast<std::size_t>(W.rows()), -1);
  for (std::size_t k = 0; k < nodes.size(); ++k)
    position[static_cast<std::size_t>(nodes[k])] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t r = 0; r < nodes.size(); ++r)
    for (SparseMatrix::InnerIterator it(W, nodes[r]); it; ++it) {
      const int inner = position[static_cast<std::size_t>(it.col())];
      if ((inner >= 0) != (wanted == Columns::inner)) continue;
      entries.emplace_back(static_cast<int>(r), inner >= 0 ? inner : static_cast<int>(it.col()),
                           it.value());
    }
  const auto n = static_cast<Index>(nodes.size());
  SparseMatrix result(n, wanted == Columns::inner ? n : W.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double value_of(std::size_t target, const std::vector<double>& signals) {
  return target == no_signal ? 0.0 : signals[target];
}

}  // namespace

GhostSystem::GhostSystem(const SparseMatrix& W, std::string name, int slot, std::vector<int> nodes,
                         std::vector<std::size_t> target, bool coupled, SolverChoice solver,
                         const Place& place)
    : name_(std::move(name)),
      slot_(slot),
      nodes_(std::move(nodes)),
      target_(std::move(target)),
      factor_(block(W, nodes_, Columns::inner), solver, place) {
  if (coupled) coupling_ = block(W, nodes_, Columns::outer);
}

void GhostSystem::solve(const std::vector<double>& signals, double* field, Index stride,
                        Eigen::VectorXd& rhs, Eigen::VectorXd& solution,
                        SolveWorkspace& scratch) const {
  for (Index k = 0; k < size(); ++k)
    rhs[k] = value_of(target_[static_cast<std::size_t>(k)], signals);
  for (Index k = 0; k < coupling_.rows(); ++k)
    for (SparseMatrix::InnerIterator it(coupling_, k); it; ++it)
      rhs[k] -= it.value() * field[it.col() * stride + slot_];
  factor_.solve_into(rhs.data(), solution.data(), scratch);
  for (Index k = 0; k < size(); ++k)
    field[nodes_[static_cast<std::size_t>(k)] * stride + slot_] = solution[k];
}

void GhostSystem::set_targets(const std::vector<double>& signals, double* field, Index stride,
                              Index end) const {
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (nodes_[k] < end) field[nodes_[k] * stride + slot_] = value_of(target_[k], signals);
}

const char* GhostSystem::solver() const {
  return factor_.chosen() == SolverChoice::cholmod ? "cholmod" : "umfpack";
}

std::string GhostSystem::report() const {
  return fmt::format("{}: {} unknowns, {} ({}), condition {:.2e}", name_, nodes_.size(), solver(),
                     factor_.reason(), factor_.condition_estimate());
}

}  // namespace tlsph
