#pragma once
/// \file
/// The 1-norm of an inverse that is known only by its solves.

#include <Eigen/Core>
#include <functional>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// x = A⁻¹ b (or A⁻ᵀ b), both of n entries.
using Inverse = std::function<Eigen::VectorXd(const Eigen::VectorXd& b)>;

/// Largest column sum of |A|.
[[nodiscard]] double one_norm(const SparseMatrix& A);

/// A lower bound of ‖A⁻¹‖₁ by at most five pairs of solves (Hager 1984; Higham, ACM TOMS 14, 1988,
/// algorithm 4.1, with his alternating vector against unlucky cancellation).
[[nodiscard]] double inverse_one_norm(const Inverse& solve, const Inverse& solve_transposed,
                                      Index n);

}  // namespace tlsph
