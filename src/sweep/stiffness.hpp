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

#include "region_laws.hpp"
#include "storage.hpp"

namespace tlsph::sweep {

template <int D>
struct Stiffness {
  /// Runs are ascending, together all nodes, each in one; `column` is `first`. Offsets are from the
  /// node; those with weights that mix components come first. Runs go on over the few nodes between
  /// two rows of a lattice.
  RowStorage rows;
  std::vector<RowRun> patches;  ///< the foreign rows in `runs`, overwritten after them; ascending
  std::vector<int> mixed;       ///< entries of each stencil that mix components
  double multiply_adds = 0.0;   ///< of a node, on average
  double work = 0.0;            ///< those, and differences, loads and stores of doubles

  [[nodiscard]] RowWeights table() const;
  /// That a product reads.
  [[nodiscard]] double bytes() const;
  /// A plan without points. `nodes`: one run of all of them.
  [[nodiscard]] PlanInput plan_input(const std::vector<RowRun>& nodes) const;
};

/// None where a law is not linear or has no loops, forces depend on velocities, or rows share so
/// little that there are more kinds of them than `most_stencils`; and where operators see a
/// translation (rows of G that do not sum to zero). `laws` are those of the regions.
template <int D>
[[nodiscard]] std::optional<Stiffness<D>> stiffness_of(const Discretisation<D>& discretisation,
                                                       const Storage<D>& storage,
                                                       const std::vector<RegionLaw<D>>& laws,
                                                       Index most_stencils);

/// What a step by points and their stress does for a node, on average, in the unit of `work`.
template <int D>
[[nodiscard]] double work_of_points(const Discretisation<D>& discretisation);

}  // namespace tlsph::sweep
