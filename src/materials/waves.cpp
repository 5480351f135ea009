#include "tlsph/materials/waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tlsph {

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

}  // namespace

template <>
double smallest_acoustic_eigenvalue<1>(const Tangent<1>& A) {
  return A(0, 0);
}

template <>
double smallest_acoustic_eigenvalue<2>(const Tangent<2>& A) {
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

}  // namespace tlsph
