#define TLSPH_LANES 2
#include "loops_body.hpp"

namespace tlsph::sweep {

extern const Loops<1> baseline_loops_1d;
extern const Loops<2> baseline_loops_2d;
const Loops<1> baseline_loops_1d = make_loops<1>();
const Loops<2> baseline_loops_2d = make_loops<2>();

}  // namespace tlsph::sweep
