#pragma once
/// \file
/// Included by one source an instruction set, which defines TLSPH_LANES, the doubles of a vector.
/// Everything is local to that source.

#include "sweep_nodes.hpp"
#include "sweep_points.hpp"
#include "sweep_tangents.hpp"

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

double update(Index size, double kick, double dt, const double* a, double* v, double* u) {
  Index at = 0;
  Real most{};
  for (; at + lanes <= size; at += lanes) {
    const Real velocity = load<Real>(v + at) + kick * load<Real>(a + at);
    store(v + at, velocity);
    store(u + at, load<Real>(u + at) + dt * velocity);
    const Real speed = velocity < 0.0 ? -velocity : velocity;
    most = speed > most ? speed : most;
  }
  double largest = 0.0;
  for (Index lane = 0; lane < lanes; ++lane) largest = most[lane] > largest ? most[lane] : largest;
  for (; at < size; ++at) {
    v[at] += kick * a[at];
    u[at] += dt * v[at];
    const double speed = v[at] < 0.0 ? -v[at] : v[at];
    largest = speed > largest ? speed : largest;
  }
  return largest;
}

template <int D, class Law>
constexpr LawKernels law_kernels() {
  return {apply_law<D, Law>, points<D, D, Law>, points<D, D + 1, Law>, stiffening<D, Law>};
}

template <int D>
constexpr Kernels<D> make_kernels() {
  return {gradient<D, D>,
          gradient<D, D + 1>,
          divergence<D, D>,
          divergence<D, D + 1>,
          move<D, D>,
          move<D, D + 1>,
          differences<D>,
          law_kernels<D, LinearElastic>(),
          law_kernels<D, StVenantKirchhoff>(),
          law_kernels<D, NeoHookean<0>>(),
          law_kernels<D, NeoHookean<3 - D>>(),
          deformation<D>,
          multiply_adds,
          subtract,
          update};
}

#undef TLSPH_INLINE

}  // namespace
}  // namespace tlsph::sweep
