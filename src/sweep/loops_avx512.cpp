#define TLSPH_LANES 8
#define TLSPH_LOOPS avx512_loops
#include "loops_body.hpp"
