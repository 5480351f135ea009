#pragma once
/// \file
/// The thesis's boundary treatment: ghost particles whose values are solved for each step, so that
/// the SPH approximation takes the prescribed value on boundary and ghosts ("modified SPH
/// matrix", 2.46), factorised once; or, in 1D, the η corrections (2.42), (2.45).
///
/// Erratum of the source: (2.46) as printed drops the coupling W_(BG)I f_I, so that
/// ⟨f⟩_B ≠ f̄_B against its own claim (2.47). The consistent system is
///
///     [W_BB W_BG; W_GB W_GG] [f_B; f_G] = f̄ − W_(BG)I f_I.

#include <memory>
#include <string>
#include <vector>

#include "tlsph/formulations/extension.hpp"
#include "tlsph/formulations/formulation.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/operators/lattice_stencil.hpp"
#include "tlsph/operators/vector_operator.hpp"
#include "tlsph/particles/ghosts.hpp"

namespace tlsph {

/// Strain of the thesis: ghosts of u, ⟨u⟩ = W u, X⟨u⟩, ghosts of the strain, H = W(X⟨u⟩).
template <int D>
class GhostGradient {
 public:
  /// What the factorisations write to, one each. A copy is without, and takes its own as it is
  /// first used.
  struct Scratch {
    std::vector<SolveWorkspace> solves;
    Scratch() = default;
    Scratch(const Scratch&) {}
    Scratch(Scratch&&) noexcept = default;
    Scratch& operator=(const Scratch&) { return *this; }
    Scratch& operator=(Scratch&&) noexcept = default;
    ~Scratch() = default;
  };
  /// The fields over nodes and ghosts of one evaluation, which the next one overwrites.
  struct Workspace {
    VectorField<D> u;       // all nodes
    VectorField<D> smooth;  // all nodes
    TensorField<D> strain;  // all nodes
    Eigen::VectorXd rhs, solution;
    Scratch scratch;
  };

  GhostGradient(const LatticeStencil<D>& stencil, const Particles<D>& particles,
                const Edges<D>& edges, GhostClosure closure, SolverChoice solver,
                const Place& solver_place);
  ~GhostGradient();
  GhostGradient(const GhostGradient&) = delete;
  GhostGradient& operator=(const GhostGradient&) = delete;

  [[nodiscard]] Workspace workspace() const;
  /// H (N×d²) at the real nodes from u (N×d) there and the signals. Takes nothing from the heap,
  /// but for a workspace that is a copy, the first time.
  void apply(const VectorField<D>& u, const std::vector<double>& signals, TensorField<D>& H,
             Workspace& workspace) const;

  /// Kernel matrix and plain gradient over real nodes (first) and ghosts.
  [[nodiscard]] const SparseMatrix& kernel_matrix() const { return W_; }
  [[nodiscard]] const VectorOperator<D>& plain_gradient() const { return X_; }
  [[nodiscard]] const GhostLattice<D>& lattice() const { return lattice_; }
  /// One line a system: name, size, factorisation and why, condition estimate.
  [[nodiscard]] std::vector<std::string> report() const;
  /// "cholmod", "umfpack" or "cholmod+umfpack".
  [[nodiscard]] std::string solver() const;

 private:
  void assemble(const LatticeStencil<D>& stencil);
  void close_by_systems(const Edges<D>& edges, SolverChoice solver, const Place& place);
  void close_by_eta(const Edges<D>& edges);
  void apply_eta(const std::vector<double>& signals, Workspace& work) const;

  GhostLattice<D> lattice_;
  SparseMatrix W_;
  VectorOperator<D> X_;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tlsph
