#pragma once
/// \file
/// The stiffness of a body as one sparse matrix: for solutions at rest and natural frequencies of
/// the very operators a run steps with.

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

/// K = Σ_ab G_aᵀ V A_ab G_b + S at the displacement gradients H (M×d²), A the tangent of the law at
/// each point; (N d)×(N d) [N/m per thickness], degrees of freedom node·d + component, constrained
/// ones included; symmetric to the last bit. Adjoint formulations only.
template <int D>
[[nodiscard]] SparseMatrix stiffness_matrix(const Discretisation<D>& discretisation,
                                            const TensorField<D>& H);

}  // namespace tlsph
