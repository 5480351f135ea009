#define TLSPH_LANES 2
#define TLSPH_LOOPS baseline_loops
#include "loops_body.hpp"
