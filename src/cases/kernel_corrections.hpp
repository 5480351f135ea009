#pragma once
/// \file
/// The corrections of Bonet & Lok (CMAME 180, 1999) that this project has no use for in a run, as
/// plain matrices, to show what they keep and what they do not.

#include <array>

#include "tlsph/kernels/families.hpp"
#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Gradient matrices of a sheet, one a direction.
using PlainGradient = std::array<SparseMatrix, 2>;

/// What γ of (57) is multiplied by: W_b, as the derivative of (54) has it, or nothing, as printed.
enum class Gamma { kernel, nothing };

/// Gradient of Shepard's interpolation (53): (∇W_b − γ W_b)/Σ V W, γ = Σ V ∇W / Σ V W.
[[nodiscard]] PlainGradient shepard_gradient(const AnyKernel& kernel, double h,
                                             const Particles<2>& particles,
                                             Gamma gamma_times = Gamma::kernel);

/// The linear kernel correction (46)–(52): values W̃ and their full gradient, α and β
/// differentiated too, which the source calls cumbersome and leaves out.
struct LinearKernel {
  SparseMatrix value;
  PlainGradient gradient;
};
[[nodiscard]] LinearKernel linear_kernel(const AnyKernel& kernel, double h,
                                         const Particles<2>& particles);

/// Largest |Σ_b G_ab| Δ over particles and directions: what the gradient of a constant is.
[[nodiscard]] double constant_residual(const PlainGradient& G, const Particles<2>& particles);

/// Per particle the largest entry of |Σ_b (X_b − X_a) ⊗ G_ab − I|, (41).
[[nodiscard]] ScalarField linear_residual(const PlainGradient& G, const Particles<2>& particles);

}  // namespace tlsph
