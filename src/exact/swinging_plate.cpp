#include "tlsph/exact/swinging_plate.hpp"

#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"

namespace tlsph {

namespace {

double wave_number(const SwingingPlate& plate) {
  return std::numbers::pi / (2 * plate.length);
}

/// [−sin(kX) cos(kY), cos(kX) sin(kY)].
Vector<2> shape(const SwingingPlate& plate, const Vector<2>& X) {
  const Vector<2> phase = wave_number(plate) * (X - plate.corner);
  return {-std::sin(phase[0]) * std::cos(phase[1]), std::cos(phase[0]) * std::sin(phase[1])};
}

}  // namespace

double swinging_plate_frequency(const SwingingPlate& plate) {
  return wave_number(plate) * std::sqrt(2 * plate.shear_modulus / plate.density);
}

ExactSolution<2> swinging_plate(const SwingingPlate& plate) {
  if (!(plate.length > 0 && plate.shear_modulus > 0 && plate.density > 0))
    throw InputError("a swinging plate needs a positive length, shear modulus and density");
  const double frequency = swinging_plate_frequency(plate);
  return {[plate, frequency](const Vector<2>& X, double t) -> Vector<2> {
            return plate.amplitude * std::cos(frequency * t) * shape(plate, X);
          },
          [plate, frequency](const Vector<2>& X, double t) -> Vector<2> {
            return -frequency * plate.amplitude * std::sin(frequency * t) * shape(plate, X);
          },
          [plate, frequency](const Vector<2>& X, double t) {
            // the shear strains sin(kX) sin(kY) − sin(kX) sin(kY) cancel
            const double k = wave_number(plate);
            const Vector<2> phase = k * (X - plate.corner);
            const double strain = k * plate.amplitude * std::cos(frequency * t) *
                                  std::cos(phase[0]) * std::cos(phase[1]);
            Tensor<2> P = Tensor<2>::Zero();
            P(0, 0) = -2 * plate.shear_modulus * strain;
            P(1, 1) = 2 * plate.shear_modulus * strain;
            return P;
          }};
}

}  // namespace tlsph
