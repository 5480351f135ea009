#include "tlsph/formulations/discretisation.hpp"

#include <algorithm>
#include <cmath>

namespace tlsph {

template <int D>
bool Discretisation<D>::linear() const {
  return std::all_of(regions.begin(), regions.end(),
                     [](const Region<D>& region) { return small_strain<D>(region.law); });
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
