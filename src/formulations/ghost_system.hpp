#pragma once
/// \file
/// One modified SPH matrix (2.46): values on boundary and ghost nodes such that ⟨f⟩ = W f takes
/// prescribed values there.

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "tlsph/formulations/extension.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph {

/// [W_BB W_BG; W_GB W_GG] [f_B; f_G] = f̄ − W_(BG)I f_I, factorised once; `nodes` are B and G.
class GhostSystem {
 public:
  /// `slot` is the component of the field it closes; `target` is the signal f̄ takes at each node,
  /// no_signal for zero. Uncoupled, the system lacks W_(BG)I f_I, as the source prints it. `place`
  /// is for complaints about the solver.
  GhostSystem(const SparseMatrix& W, std::string name, int slot, std::vector<int> nodes,
              std::vector<std::size_t> target, bool coupled, SolverChoice solver,
              const Place& place)
      : name_(std::move(name)),
        slot_(slot),
        nodes_(std::move(nodes)),
        target_(std::move(target)),
        factor_(block(W, nodes_, Columns::inner), solver, place) {
    if (coupled) coupling_ = block(W, nodes_, Columns::outer);
  }

  /// Sets its component of a field (one node after the other, `stride` numbers each) on the nodes,
  /// so that W times the field hits the targets there. `rhs` and `solution` have room for size()
  /// numbers at least; nothing is taken from the heap.
  void solve(const std::vector<double>& signals, double* field, Index stride, Eigen::VectorXd& rhs,
             Eigen::VectorXd& solution, SolveWorkspace& scratch) const {
    for (Index k = 0; k < size(); ++k) rhs[k] = target(k, signals);
    for (Index k = 0; k < coupling_.rows(); ++k)
      for (SparseMatrix::InnerIterator it(coupling_, k); it; ++it)
        rhs[k] -= it.value() * field[it.col() * stride + slot_];
    factor_.solve_into(rhs.data(), solution.data(), scratch);
    for (Index k = 0; k < size(); ++k) field[node(k) * stride + slot_] = solution[k];
  }
  /// Sets the component itself to the targets, on those of the nodes that lie below `end`.
  void set_targets(const std::vector<double>& signals, double* field, Index stride,
                   Index end) const {
    for (Index k = 0; k < size(); ++k)
      if (node(k) < end) field[node(k) * stride + slot_] = target(k, signals);
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(nodes_.size()); }
  [[nodiscard]] SolveWorkspace workspace() const { return factor_.workspace(); }
  /// "cholmod" or "umfpack".
  [[nodiscard]] const char* solver() const {
    return factor_.chosen() == SolverChoice::cholmod ? "cholmod" : "umfpack";
  }
  /// Name, size, factorisation and why, condition estimate.
  [[nodiscard]] std::string report() const {
    return fmt::format("{}: {} unknowns, {} ({}), condition {:.2e}", name_, nodes_.size(), solver(),
                       factor_.reason(), factor_.condition_estimate());
  }

 private:
  enum class Columns { inner, outer };

  /// The rows `nodes` of W: of their columns the inner ones, which are nodes too, in the order of
  /// `nodes`; or the outer ones, which are not, where they stand.
  static SparseMatrix block(const SparseMatrix& W, const std::vector<int>& nodes, Columns wanted) {
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

  [[nodiscard]] Index node(Index k) const { return nodes_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] double target(Index k, const std::vector<double>& signals) const {
    return value_of(target_[static_cast<std::size_t>(k)], signals);
  }

  std::string name_;
  int slot_;  ///< component of the field
  std::vector<int> nodes_;
  std::vector<std::size_t> target_;
  SparseMatrix coupling_;  ///< W_(BG)I, zero on the nodes themselves; 0×0 uncoupled
  SymmetricOrGeneral factor_;
};

}  // namespace tlsph
