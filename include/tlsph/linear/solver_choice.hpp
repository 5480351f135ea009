#pragma once
/// \file
/// Which factorisation a square system may use.

namespace tlsph {

/// Cholesky where the matrix allows it and LU elsewhere, or one of them.
enum class SolverChoice { automatic, cholmod, umfpack };

}  // namespace tlsph
