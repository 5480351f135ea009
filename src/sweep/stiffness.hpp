#pragma once
/// \file
/// The accelerations of a body of linear laws as one product, for steps that need no stress: the
/// block rows of −M⁻¹K, K = −D A G + S, put together from the shared rows of the operators, so that
/// no matrix is ever assembled.
///
///     a_q = Σ_r B_qr (u_r − u_q)
///     B_qr = M_q⁻¹ (Σ_s [λ d gᵀ + μ (d·g + g dᵀ) − κ γ_q γ_r] − S_qr)
///
/// with d = D_qs, g = G_sr and γ the row of the cell stabiliser. As differences, since K moves
/// nothing rigid: what a translation leaves of a sum that cancels would be a force from nowhere.

#include <optional>
#include <vector>

#include "loops.hpp"
#include "plan.hpp"
#include "region_laws.hpp"
#include "storage.hpp"
#include "tlsph/formulations/discretisation.hpp"

namespace tlsph::sweep {

template <int D>
struct Stiffness {
  /// Ascending; together all nodes, each in one; `column` is `first`. They run on over the few
  /// nodes between two rows of a lattice.
  std::vector<RowRun> runs;
  std::vector<RowRun> patches;  ///< the foreign rows in `runs`, overwritten after them; ascending
  std::vector<int> stencil_start = {0};
  std::vector<int> offset;     ///< from the node; those with weights that mix components come first
  std::vector<int> mixed;      ///< entries of each stencil that do
  std::vector<int> reach;      ///< largest offset of each stencil, at least zero
  std::vector<double> weight;  ///< `block_weights<D>` an entry
  double multiply_adds = 0.0;  ///< of a node, on average
  double work = 0.0;           ///< those, and differences, loads and stores of doubles

  [[nodiscard]] int stencils() const { return static_cast<int>(stencil_start.size()) - 1; }
  [[nodiscard]] BlockWeights table() const;
  /// That a product reads.
  [[nodiscard]] double bytes() const;
  /// Joins runs of one stencil with few rows between them: a long run costs less than several, the
  /// rows between, computed in vain, included.
  void run_on();
  /// Nodes that rows read, and nothing else.
  [[nodiscard]] Dependences dependences() const;
};

/// None where a law is not linear or has no loops, forces depend on velocities, or rows share so
/// little that there are more kinds of them than `most_stencils`; and where operators see a
/// translation (rows of G that do not sum to zero). `laws` are those of the regions.
template <int D>
[[nodiscard]] std::optional<Stiffness<D>> stiffness_of(const Discretisation<D>& discretisation,
                                                       const Storage<D>& storage,
                                                       const std::vector<RegionLaw<D>>& laws,
                                                       Index most_stencils);

/// What a step by points and their stress does for a node, on average, in the same unit.
template <int D>
[[nodiscard]] double work_of_points(const Discretisation<D>& discretisation);

}  // namespace tlsph::sweep
