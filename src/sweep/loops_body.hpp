#pragma once
/// \file
/// Included by one source an instruction set, which defines TLSPH_LANES, the doubles of a vector,
/// and TLSPH_LOOPS, the name of what it defines. All else is local to that source.

#include "blocks.hpp"
#include "nodes.hpp"
#include "points.hpp"

namespace tlsph::sweep {
namespace {

Index multiply_adds(Index count, double& sum) {
  constexpr int chains = 12;  // enough to hide the latency of any processor of today
  Real value[chains];
  for (int k = 0; k < chains; ++k) value[k] = all(1.0 + k);
  const Real factor = all(0.999);
  const Real term = all(0.001);
  for (Index n = 0; n < count; ++n)
    for (Real& chain : value) chain = chain * factor + term;
  for (const Real& chain : value)
    for (Index lane = 0; lane < lanes; ++lane) sum += chain[lane];
  return count * chains * lanes;
}

void subtract(Index size, const double* r, double* a) {
  Index at = 0;
  for (; at + lanes <= size; at += lanes) store(a + at, load<Real>(a + at) - load<Real>(r + at));
  for (; at < size; ++at) a[at] -= r[at];
}

/// None for a law with a memory, which is not swept.
template <int D, class Law>
constexpr LawLoops law_loops() {
  if constexpr (requires { Law::memory; })
    return {};
  else
    return {apply_law<D, Law>,
            {points<D, D, Law>, points<D, D + 1, Law>},
            apply_tangent<D, Law>,
            stiffening<D, Law>};
}

template <int D, int Directions>
constexpr Products products = {gradient<D, Directions>, divergence<D, Directions>,
                               move<D, Directions>};

template <int D, class... Law>
constexpr Loops<D> make_loops(laws::List<Law...>) {
  return {{products<D, D>, products<D, D + 1>},
          differences<D>,
          {law_loops<D, Law>()...},
          deformation<D>,
          multiply_adds,
          subtract,
          accelerations<D>,
          move_on<D>};
}

#undef TLSPH_INLINE

template <int D>
constexpr Loops<D> own_loops = make_loops<D>(laws::Listed<D>());

}  // namespace

template <>
const Loops<1>& TLSPH_LOOPS<1>() {
  return own_loops<1>;
}
template <>
const Loops<2>& TLSPH_LOOPS<2>() {
  return own_loops<2>;
}

}  // namespace tlsph::sweep
