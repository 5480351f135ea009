#include "tlsph/operators/lattice_stencil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "tlsph/core/error.hpp"

namespace tlsph {

template <int D>
LatticeStencil<D> lattice_stencil(const AnyKernel& kernel, double support,
                                  const LatticeFrame<D>& frame) {
  const double h = support * frame.spacing.mean();
  const double inside = h * (1.0 - 1e-9);
  double volume = 1.0;
  std::array<int, D> limit{}, o{};
  for (std::size_t a = 0; a < D; ++a) {
    const double spacing = frame.spacing[static_cast<Index>(a)];
    volume *= spacing;
    limit[a] = static_cast<int>(inside / spacing);
    o[a] = -limit[a];
  }
  LatticeStencil<D> stencil;
  double sum = 0.0;
  Vector<D> moment = Vector<D>::Zero();
  for (;;) {
    Vector<D> arm;
    for (int a = 0; a < D; ++a) arm[a] = o[static_cast<std::size_t>(a)] * frame.spacing[a];
    const double r = arm.norm();
    if (r < inside) {
      Vector<D> gradient = Vector<D>::Zero();
      if (r > 0.0) gradient = -volume * kernel_first<D>(kernel, r, h) / r * arm;
      stencil.offset.push_back(o);
      stencil.value.push_back(volume * kernel_value<D>(kernel, r, h));
      stencil.gradient.push_back(gradient);
      sum += stencil.value.back();
      moment += gradient.cwiseProduct(arm);
      for (const int step : o) stencil.reach = std::max(stencil.reach, std::abs(step));
    }
    int a = D - 1;
    for (; a >= 0; --a) {
      const auto d = static_cast<std::size_t>(a);
      if (++o[d] <= limit[d]) break;
      o[d] = -limit[d];
    }
    if (a < 0) break;
  }
  if (stencil.reach == 0)
    throw InputError(
        fmt::format("kernel.support: {} spacings reach no neighbour; choose more than 1", support));
  for (double& w : stencil.value) w /= sum;
  for (Vector<D>& g : stencil.gradient) g = g.cwiseQuotient(moment);
  return stencil;
}

#define TLSPH_INSTANTIATE(D) \
  template LatticeStencil<D> lattice_stencil<D>(const AnyKernel&, double, const LatticeFrame<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph
