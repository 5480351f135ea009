#include "simple_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tlsph/materials/uniaxial.hpp"

namespace tlsph {
namespace {

constexpr int states = 4000;  // of the load that are followed

Tensor<1> scalar(double value) {
  return Tensor<1>::Constant(value);
}

}  // namespace

SimpleWave::SimpleWave(AnyLaw<1> law, double density, Curve load, double duration)
    : law_(law), density_(density), load_(std::move(load)), duration_(duration) {}

double SimpleWave::speed(double H) const {
  return std::sqrt(tangent<1>(law_, scalar(H))(0, 0) / density_);
}

double SimpleWave::invariant(double H) const {
  constexpr int panels = 64;  // of Simpson's rule: c is smooth, the rest is round-off
  const double width = H / panels;
  double sum = 0.0;
  for (int k = 0; k < panels; ++k)
    sum += speed(k * width) + 4.0 * speed((k + 0.5) * width) + speed((k + 1) * width);
  return sum * width / 6.0;
}

double SimpleWave::gradient_of(double value) const {
  double H = value / speed(0.0);
  for (int k = 0; k < 50; ++k) {
    const double step = (invariant(H) - value) / speed(H);
    H -= step;
    if (std::abs(step) < 1e-14) break;
  }
  return H;
}

double SimpleWave::gradient_under(double traction) const {
  return uniaxial_gradient<1>(law_, traction);
}

double SimpleWave::stress(double H) const {
  return pk1<1>(law_, scalar(H))(0, 0);
}

double SimpleWave::breaking_distance() const {
  double distance = std::numeric_limits<double>::infinity();
  const double step = duration_ / states;
  for (int k = 0; k < states; ++k) {
    const double before = speed(gradient_under(value(load_, k * step)));
    const double after = speed(gradient_under(value(load_, (k + 1) * step)));
    // Sent out a step apart, the second catches up after this way.
    if (after > before) distance = std::min(distance, step * before * after / (after - before));
  }
  return distance;
}

History SimpleWave::history(double X) const {
  History result;
  result.names = {"stress", "velocity"};
  result.values.resize(2);
  for (int k = 0; k <= states; ++k) {
    const double sent = k * duration_ / states;
    const double H = gradient_under(value(load_, sent));
    result.time.push_back(sent + X / speed(H));
    result.values[0].push_back(stress(H));
    result.values[1].push_back(-invariant(H));
  }
  return result;
}

}  // namespace tlsph
