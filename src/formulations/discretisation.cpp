#include "tlsph/formulations/discretisation.hpp"

#include <algorithm>
#include <cmath>

namespace tlsph {

template <int D>
bool Discretisation<D>::small_strain() const {
  return std::ranges::all_of(
      regions, [](const Region<D>& region) { return tlsph::small_strain<D>(region.law); });
}

template <int D>
int Discretisation<D>::memory() const {
  int most = 0;
  for (const Region<D>& region : regions) most = std::max(most, tlsph::memory<D>(region.law));
  return most;
}

template <int D>
double Discretisation<D>::wave_speed() const {
  double fastest = 0.0;
  for (const Region<D>& region : regions) {
    const double modulus = tangent<D>(region.law, Tensor<D>::Zero())(0, 0);
    fastest = std::max(fastest, std::sqrt(modulus / region.density));
  }
  return fastest;
}

template struct Discretisation<1>;
template struct Discretisation<2>;

}  // namespace tlsph
