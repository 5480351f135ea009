#include "tlsph/analysis/lattice_symbol.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace tlsph {

template <int D>
Tensor<D> LatticeSymbol<D>::at(const Vector<D>& k) const {
  Tensor<D> sum = Tensor<D>::Zero();
  for (std::size_t q = 0; q < offset.size(); ++q) sum += std::cos(k.dot(offset[q])) * block[q];
  return 0.5 * (sum + sum.transpose().eval());
}

template <int D>
std::array<double, D> squared_frequencies(const LatticeSymbol<D>& symbol, const Vector<D>& k) {
  const Eigen::SelfAdjointEigenSolver<Tensor<D>> solver(symbol.at(k));
  std::array<double, D> squares;
  for (std::size_t i = 0; i < D; ++i) squares[i] = solver.eigenvalues()[static_cast<Index>(i)];
  if constexpr (D == 2) {
    const auto along = [&](Index column) {
      return std::abs(solver.eigenvectors().col(column).dot(k));
    };
    // Equal up to round-off where both waves are the same: keep the order of the eigenvalues.
    if (along(0) > along(1) + 1e-9 * k.norm()) std::swap(squares[0], squares[1]);
  }
  return squares;
}

template <int D>
PhaseSpeeds<D> phase_speeds(const LatticeSymbol<D>& symbol, double spacing,
                            const std::array<double, D>& exact, int radial, int angular) {
  PhaseSpeeds<D> speeds;
  const int last = D == 1 ? 0 : angular;
  for (int direction = 0; direction <= last; ++direction)
    for (int n = 1; n <= radial; ++n) {
      const double length = std::numbers::pi * n / radial;
      const double angle = D == 1 ? 0.0 : 0.5 * std::numbers::pi * direction / angular;
      Vector<D> k;
      k[0] = length * std::cos(angle);
      if constexpr (D == 2) k[1] = length * std::sin(angle);
      const auto squares = squared_frequencies<D>(symbol, k / spacing);
      std::array<double, D> relative;
      for (std::size_t i = 0; i < D; ++i)
        relative[i] = std::sqrt(std::max(0.0, squares[i])) * spacing / (exact[i] * length);
      speeds.k.push_back(k);
      speeds.relative.push_back(relative);
    }
  return speeds;
}

template <int D>
int zero_energy_waves(const LatticeSymbol<D>& symbol, const Vector<D>& spacings, double fastest,
                      double nothing) {
  int count = 0;
  for (int corner = 1; corner < (1 << D); ++corner) {
    Vector<D> k;
    for (int a = 0; a < D; ++a)
      k[a] = ((corner >> a) & 1) == 1 ? std::numbers::pi / spacings[a] : 0.0;
    const double unit = fastest / spacings.minCoeff();
    for (const double square : squared_frequencies<D>(symbol, k))
      if (square <= nothing * unit * unit) ++count;
  }
  return count;
}

#define TLSPH_INSTANTIATE(D)                                                       \
  template struct LatticeSymbol<D>;                                                \
  template std::array<double, D> squared_frequencies<D>(const LatticeSymbol<D>&,   \
                                                        const Vector<D>&);         \
  template PhaseSpeeds<D> phase_speeds<D>(const LatticeSymbol<D>&, double,         \
                                          const std::array<double, D>&, int, int); \
  template int zero_energy_waves<D>(const LatticeSymbol<D>&, const Vector<D>&, double, double);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
