#pragma once
/// \file
/// How many threads the BLAS behind the factorisations may use.

namespace tlsph {

/// Limits the BLAS to `threads`, where it is OpenBLAS; another BLAS follows its own environment
/// variables. Several processes that factorise side by side would otherwise wait for each other.
void set_blas_threads(int threads);

}  // namespace tlsph
