#define TLSPH_LANES 4
#define TLSPH_LOOPS avx2_loops
#include "loops_body.hpp"
