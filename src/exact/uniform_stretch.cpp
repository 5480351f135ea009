#include "tlsph/exact/uniform_stretch.hpp"

#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {

template <int D>
ExactSolution<D> uniform_stretch(const UniformStretch& stretch, const AnyLaw<D>& law) {
  if (!(std::abs(stretch.length) > 0))
    throw InputError("a uniform stretch needs a body of some length");
  const auto along = [stretch](const Vector<D>& X, double end) -> Vector<D> {
    return end * (X[0] - stretch.fixed_end) / stretch.length * Vector<D>::Unit(0);
  };
  return {[along, stretch](const Vector<D>& X, double t) {
            return along(X, value(stretch.elongation, t));
          },
          [along, stretch](const Vector<D>& X, double t) {
            return along(X, rate(stretch.elongation, t));
          },
          [law, stretch](const Vector<D>&, double t) {
            Tensor<D> H = Tensor<D>::Zero();
            H(0, 0) = value(stretch.elongation, t) / stretch.length;
            return pk1<D>(law, H);
          }};
}

template ExactSolution<1> uniform_stretch<1>(const UniformStretch&, const AnyLaw<1>&);
template ExactSolution<2> uniform_stretch<2>(const UniformStretch&, const AnyLaw<2>&);

}  // namespace tlsph
