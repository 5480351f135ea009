#define TLSPH_LANES 4
#include "sweep_kernels_body.hpp"

namespace tlsph::sweep {

extern const Kernels<1> avx2_kernels_1d;
extern const Kernels<2> avx2_kernels_2d;
const Kernels<1> avx2_kernels_1d = make_kernels<1>();
const Kernels<2> avx2_kernels_2d = make_kernels<2>();

}  // namespace tlsph::sweep
