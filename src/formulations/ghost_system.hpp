#pragma once
/// \file
/// One modified SPH matrix (2.46): values on boundary and ghost nodes such that ⟨f⟩ = W f takes
/// prescribed values there.

#include <cstddef>
#include <string>
#include <vector>

#include "tlsph/core/types.hpp"
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
              const Place& place);

  /// Sets its component of a field (one node after the other, `stride` numbers each) on the nodes,
  /// so that W times the field hits the targets there. `rhs` and `solution` have room for size()
  /// numbers at least; nothing is taken from the heap.
  void solve(const std::vector<double>& signals, double* field, Index stride, Eigen::VectorXd& rhs,
             Eigen::VectorXd& solution, SolveWorkspace& scratch) const;
  /// Sets the component itself to the targets, on those of the nodes that lie below `end`.
  void set_targets(const std::vector<double>& signals, double* field, Index stride,
                   Index end) const;

  [[nodiscard]] Index size() const { return static_cast<Index>(nodes_.size()); }
  [[nodiscard]] SolveWorkspace workspace() const { return factor_.workspace(); }
  /// "cholmod" or "umfpack".
  [[nodiscard]] const char* solver() const;
  /// Name, size, factorisation and why, condition estimate.
  [[nodiscard]] std::string report() const;

 private:
  std::string name_;
  int slot_;  ///< component of the field
  std::vector<int> nodes_;
  std::vector<std::size_t> target_;
  SparseMatrix coupling_;  ///< W_(BG)I, zero on the nodes themselves; 0×0 uncoupled
  SymmetricOrGeneral factor_;
};

}  // namespace tlsph
