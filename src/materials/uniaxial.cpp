#include "tlsph/materials/uniaxial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {

namespace {

/// P_11 and its slope along H = x e₁⊗e₁.
template <int D, class Law>
struct Path {
  const Law& law;

  static Tensor<D> gradient(double x) {
    Tensor<D> H = Tensor<D>::Zero();
    H(0, 0) = x;
    return H;
  }
  double stress(double x) const { return law.pk1(gradient(x))(0, 0); }
  double slope(double x) const { return law.dpk1(gradient(x), gradient(1.0))(0, 0); }
};

/// Newton steps kept inside the bracket [inner, outer], which the root leaves neither end of.
template <class P>
double solve_between(const P& path, double traction, double inner, double outer) {
  double x = inner + (traction - path.stress(inner)) / path.slope(inner);
  for (int iteration = 0; iteration < 200; ++iteration) {
    if (!(x > std::min(inner, outer) && x < std::max(inner, outer))) x = 0.5 * (inner + outer);
    const double excess = path.stress(x) - traction;
    if (excess == 0) return x;
    // beyond the traction on the way out: the root is nearer to the undeformed state
    ((excess > 0) == (traction > 0) ? outer : inner) = x;
    const double next = x - excess / path.slope(x);
    if (std::abs(next - x) <= 4e-16 * std::abs(x)) return next;
    if (std::abs(outer - inner) <= 4e-16 * std::abs(x)) return x;
    x = next;
  }
  return x;
}

/// Where the slope, positive at inner and not at outer, vanishes.
template <class P>
double end_of_branch(const P& path, double inner, double outer) {
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = 0.5 * (inner + outer);
    (path.slope(middle) > 0 ? inner : outer) = middle;
  }
  return inner;
}

template <int D, class Law>
double uniaxial(const Law& law, double traction) {
  const Path<D, Law> path{law};
  if (traction == 0) return 0.0;
  if constexpr (Law::small_strain) return traction / path.slope(0.0);

  const auto reaches = [&](double x) {
    return traction > 0 ? path.stress(x) >= traction : path.stress(x) <= traction;
  };
  // outwards from the undeformed state, two per cent of stretch at a time, up to e^±14
  double inner = 0.0;
  for (int step = 1; step <= 700; ++step) {
    double outer = std::expm1(std::copysign(0.02 * step, traction));
    const bool last = !(path.slope(outer) > 0);
    if (last) outer = end_of_branch(path, inner, outer);
    if (reaches(outer)) return solve_between(path, traction, inner, outer);
    inner = outer;
    if (last) break;
  }
  throw InputError(
      fmt::format("a traction of {} Pa is more than the {} law carries in uniaxial stretch; it "
                  "reaches {} Pa at "
                  "F = {}",
                  traction, Law::name, path.stress(inner), 1 + inner));
}

}  // namespace

template <int D>
double uniaxial_gradient(const AnyLaw<D>& law, double traction) {
  if (!std::isfinite(traction))
    throw InputError(fmt::format("a traction of {} Pa has no stretch", traction));
  return std::visit([&](const auto& held) { return uniaxial<D>(held, traction); }, law);
}

template double uniaxial_gradient<1>(const AnyLaw<1>&, double);
template double uniaxial_gradient<2>(const AnyLaw<2>&, double);

}  // namespace tlsph
