#pragma once
/// \file
/// Included by one source an instruction set, which defines TLSPH_LANES, the doubles of a vector.
/// Everything is local to that source.

#include "blocks.hpp"
#include "nodes.hpp"
#include "points.hpp"
#include "strains.hpp"

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
    return {apply_law<D, Law>, points<D, D, Law>, points<D, D + 1, Law>, apply_tangent<D, Law>,
            stiffening<D, Law>};
}

template <int D, class... Law>
constexpr Loops<D> make_loops(laws::List<Law...>) {
  return {gradient<D, D>, gradient<D, D + 1>, divergence<D, D>, divergence<D, D + 1>,
          move<D, D>,     move<D, D + 1>,     differences<D>,   {law_loops<D, Law>()...},
          deformation<D>, multiply_adds,      subtract,         accelerations<D>,
          move_on<D>};
}

template <int D>
constexpr Loops<D> make_loops() {
  return make_loops<D>(laws::Listed<D>());
}

#undef TLSPH_INLINE

}  // namespace
}  // namespace tlsph::sweep
