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
  std::array<int, D> limit{};
  LatticeStencil<D> stencil;
  for (int a = 0; a < D; ++a) {
    volume *= frame.spacing[a];
    limit[static_cast<std::size_t>(a)] = static_cast<int>(inside / frame.spacing[a]);
  }
  std::array<int, D> o{};
  for (std::size_t a = 0; a < D; ++a) o[a] = -limit[a];
  double sum = 0.0;
  Vector<D> moment = Vector<D>::Zero();
  std::visit(
      [&](const auto& family) {
        for (;;) {
          Vector<D> arm;
          for (int a = 0; a < D; ++a) arm[a] = o[static_cast<std::size_t>(a)] * frame.spacing[a];
          const double r = arm.norm();
          if (r < inside) {
            Vector<D> gradient = Vector<D>::Zero();
            if (r > 0.0) gradient = -volume * kernel_first<D>(family, r, h) / r * arm;
            stencil.offset.push_back(o);
            stencil.value.push_back(volume * kernel_value<D>(family, r, h));
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
      },
      kernel);
  if (stencil.reach == 0)
    throw InputError(
        fmt::format("kernel.support: {} spacings reach no neighbour; choose more than 1", support));
  for (double& w : stencil.value) w /= sum;
  for (Vector<D>& g : stencil.gradient) g = g.cwiseQuotient(moment);
  return stencil;
}

template LatticeStencil<1> lattice_stencil<1>(const AnyKernel&, double, const LatticeFrame<1>&);
template LatticeStencil<2> lattice_stencil<2>(const AnyKernel&, double, const LatticeFrame<2>&);

}  // namespace tlsph
