#include "tlsph/linear/blas_threads.hpp"

#include <cstdlib>
#include <new>

#include "suitesparse.hpp"

// Weak: there only if the BLAS that was linked is OpenBLAS.
extern "C" __attribute__((weak)) void openblas_set_num_threads(int);
extern "C" __attribute__((weak)) void dpotrf_(const char*, const int*, double*, const int*, int*);

namespace tlsph {
namespace {

/// OpenBLAS, as Debian builds it, takes this much at the first call of a thread.
constexpr std::size_t work_space = (std::size_t{128} << 20) + (std::size_t{1} << 20);

}  // namespace

void set_blas_threads(int threads) {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(threads);
}

void reserve_blas_memory() {
  static const bool reserved = [] {
    if (openblas_set_num_threads == nullptr || dpotrf_ == nullptr) return false;
    void* volatile block = std::malloc(work_space);  // volatile: or no compiler would try
    if (block == nullptr) throw std::bad_alloc();
    std::free(block);
    const int one = 1;
    double entry = 1.0;
    int info = 0;
    dpotrf_("L", &one, &entry, &one, &info);
    return info == 0;
  }();
  (void)reserved;
}

}  // namespace tlsph
