#include "tlsph/linear/blas_threads.hpp"

// Weak: there only if the BLAS that was linked is OpenBLAS.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int);

namespace tlsph {

void set_blas_threads(int threads) {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(threads);
}

}  // namespace tlsph
