#include "tlsph/contrast/growth.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tlsph {
namespace {

/// ∇W and ∇∇W at the offset d of one neighbour.
template <int D>
struct Neighbour {
  Vector<D> d, slope;
  Tensor<D> curvature;
};

template <int D>
std::vector<Neighbour<D>> neighbours_of(const StressedLattice<D>& lattice) {
  const int reach = static_cast<int>(std::ceil(lattice.h / lattice.spacing));
  std::vector<Neighbour<D>> list;
  const auto add = [&](const Vector<D>& d) {
    const double r = d.norm();
    if (r == 0.0 || r >= lattice.h) return;
    const auto [first, second] = std::visit(
        [&](const auto& kernel) {
          return std::pair{kernel_first<D>(kernel, r, lattice.h),
                           kernel_second<D>(kernel, r, lattice.h)};
        },
        lattice.kernel);
    const Vector<D> n = d / r;
    const Tensor<D> along = n * n.transpose();
    list.push_back({d, first * n, second * along + first / r * (Tensor<D>::Identity() - along)});
  };
  for (int i = -reach; i <= reach; ++i) {
    if constexpr (D == 1) {
      add(Vector<1>(i * lattice.spacing));
    } else {
      for (int j = -reach; j <= reach; ++j) add(Vector<2>(i, j) * lattice.spacing);
    }
  }
  return list;
}

template <int D>
Tensor<D> symbol_over(const std::vector<Neighbour<D>>& neighbours,
                      const StressedLattice<D>& lattice, const Vector<D>& k) {
  const double volume = std::pow(lattice.spacing, D);
  Tensor<D> C = Tensor<D>::Zero();
  Vector<D> g = Vector<D>::Zero();
  for (const Neighbour<D>& near : neighbours) {
    const double phase = k.dot(near.d);
    C += volume * (1.0 - std::cos(phase)) * near.curvature;
    g += volume * std::sin(phase) * near.slope;
  }
  const auto [lambda, mu] = lattice.moduli;
  const double sigma = lattice.stress;
  return (2.0 * sigma * C - (lambda + 2.0 * sigma + mu) * (g * g.transpose()) -
          mu * g.squaredNorm() * Tensor<D>::Identity()) /
         lattice.density;
}

template <int D>
double growth_of(const Tensor<D>& symbol) {
  const Eigen::SelfAdjointEigenSolver<Tensor<D>> solver(symbol, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

}  // namespace

template <int D>
Tensor<D> symbol(const StressedLattice<D>& lattice, const Vector<D>& k) {
  return symbol_over<D>(neighbours_of<D>(lattice), lattice, k);
}

template <int D>
double growth_rate(const StressedLattice<D>& lattice, const Vector<D>& k) {
  return growth_of<D>(symbol<D>(lattice, k));
}

template <int D>
GrowingWave<D> fastest_growth(const StressedLattice<D>& lattice) {
  constexpr int intervals = 64;
  const auto neighbours = neighbours_of<D>(lattice);
  GrowingWave<D> fastest;
  const int last = D == 1 ? 0 : intervals;
  for (int i = 0; i <= intervals; ++i)
    for (int j = 0; j <= last; ++j) {
      Vector<D> k;
      k[0] = i;
      k[D - 1] = D == 1 ? i : j;
      k *= std::numbers::pi / (intervals * lattice.spacing);
      const double rate = growth_of<D>(symbol_over<D>(neighbours, lattice, k));
      if (rate > fastest.rate) fastest = {k, rate};
    }
  return fastest;
}

#define TLSPH_INSTANTIATE(D)                                                   \
  template Tensor<D> symbol<D>(const StressedLattice<D>&, const Vector<D>&);   \
  template double growth_rate<D>(const StressedLattice<D>&, const Vector<D>&); \
  template GrowingWave<D> fastest_growth<D>(const StressedLattice<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
