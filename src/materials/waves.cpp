#include "tlsph/materials/waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"

namespace tlsph {

Lame lame(double young, double poisson) {
  if (!(young > 0) || !std::isfinite(young))
    throw InputError(fmt::format("Young's modulus is {} Pa; it must be positive", young));
  if (!(poisson > -1 && poisson < 0.5))
    throw InputError(
        fmt::format("Poisson's ratio is {}; it must lie between -1 and 0.5 (0.5, incompressible, "
                    "has no finite wave speed)",
                    poisson));
  return {young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

double p_modulus(int dimension, Assumption assumption, double young, double poisson) {
  const Lame constants = lame(young, poisson);
  return reduced_lambda(constants, dimension, assumption) + 2 * constants.mu;
}

double wave_speed(double modulus, double density) {
  return std::sqrt(modulus / density);
}

namespace {

/// Smaller eigenvalue of the acoustic tensor of the direction (cos θ, sin θ).
double acoustic_eigenvalue(const Tangent<2>& A, double angle) {
  const Vector<2> N(std::cos(angle), std::sin(angle));
  Tensor<2> Q;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) Q(i, j) = N.dot(A.block<2, 2>(2 * i, 2 * j) * N);
  const double mean = 0.5 * (Q(0, 0) + Q(1, 1));
  return mean - std::hypot(0.5 * (Q(0, 0) - Q(1, 1)), 0.5 * (Q(0, 1) + Q(1, 0)));
}

/// Golden-section search of the smallest value between two angles.
double smallest_between(const Tangent<2>& A, double lower, double upper) {
  constexpr double ratio = 1 / std::numbers::phi;
  double left = upper - ratio * (upper - lower), right = lower + ratio * (upper - lower);
  double at_left = acoustic_eigenvalue(A, left), at_right = acoustic_eigenvalue(A, right);
  // the minimum is flat: angles nearer than √ε give the same value
  while (upper - lower > 1e-8) {
    if (at_left < at_right) {
      upper = right;
      right = left;
      at_right = at_left;
      left = upper - ratio * (upper - lower);
      at_left = acoustic_eigenvalue(A, left);
    } else {
      lower = left;
      left = right;
      at_left = at_right;
      right = lower + ratio * (upper - lower);
      at_right = acoustic_eigenvalue(A, right);
    }
  }
  return std::min(at_left, at_right);
}

/// α cos²θ + β cosθ sinθ + γ sin²θ, a component of the acoustic tensor.
struct Quadratic {
  double alpha, beta, gamma;
};

Quadratic acoustic_component(const Tangent<2>& A, int i, int j) {
  return {A(2 * i, 2 * j), A(2 * i, 2 * j + 1) + A(2 * i + 1, 2 * j), A(2 * i + 1, 2 * j + 1)};
}

/// True only if det Q(N) > 0 for every N, by a sum of squares: det Q is p₀ + p₁t + … + p₄t⁴ times
/// cos⁴θ, t = tan θ, and is positive if the form of (1, t, t²) with the matrix
/// [p₀ p₁/2 0; p₁/2 p₂ p₃/2; 0 p₃/2 p₄] is. For an isotropic tangent, and for Neo-Hookean at any
/// deformation, where det Q is a product of two quadratics and one of them is |N|², the two are
/// the same.
bool certainly_positive_determinant(const Quadratic& a, const Quadratic& b, const Quadratic& c) {
  const double p0 = a.alpha * b.alpha - c.alpha * c.alpha;
  const double p1 = a.alpha * b.beta + a.beta * b.alpha - 2 * c.alpha * c.beta;
  const double p2 = a.alpha * b.gamma + a.beta * b.beta + a.gamma * b.alpha -
                    2 * c.alpha * c.gamma - c.beta * c.beta;
  const double p3 = a.beta * b.gamma + a.gamma * b.beta - 2 * c.beta * c.gamma;
  const double p4 = a.gamma * b.gamma - c.gamma * c.gamma;
  const double minor = p0 * p2 - 0.25 * p1 * p1;
  return p0 > 0 && minor > 0 && p4 * minor > 0.25 * p0 * p3 * p3;
}

}  // namespace

template <int D>
double smallest_acoustic_eigenvalue(const Tangent<D>& A) {
  if constexpr (D == 1) {
    return A(0, 0);
  } else {
    constexpr int samples = 180;
    constexpr double step = std::numbers::pi / samples;  // N and −N are the same direction
    double smallest = acoustic_eigenvalue(A, 0.0);
    int best = 0;
    for (int i = 1; i < samples; ++i) {
      const double value = acoustic_eigenvalue(A, i * step);
      if (value < smallest) {
        smallest = value;
        best = i;
      }
    }
    return std::min(smallest, smallest_between(A, (best - 1) * step, (best + 1) * step));
  }
}

/// Q(N) is positive for every N if it is for one and its determinant for all.
template <int D>
bool is_hyperbolic(const Tangent<D>& A) {
  if constexpr (D == 2) {
    const Quadratic q00 = acoustic_component(A, 0, 0);
    const Quadratic q11 = acoustic_component(A, 1, 1);
    const Quadratic q01 = acoustic_component(A, 0, 1);
    if (q00.alpha > 0 && certainly_positive_determinant(q00, q11, q01)) return true;
  }
  return smallest_acoustic_eigenvalue<D>(A) > 0;
}

#define TLSPH_INSTANTIATE(D)                                          \
  template double smallest_acoustic_eigenvalue<D>(const Tangent<D>&); \
  template bool is_hyperbolic<D>(const Tangent<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
