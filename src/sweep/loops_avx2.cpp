#define TLSPH_LANES 4
#include "loops_body.hpp"

namespace tlsph::sweep {

extern const Loops<1> avx2_loops_1d;
extern const Loops<2> avx2_loops_2d;
const Loops<1> avx2_loops_1d = make_loops<1>();
const Loops<2> avx2_loops_2d = make_loops<2>();

}  // namespace tlsph::sweep
