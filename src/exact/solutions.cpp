#include "tlsph/exact/solutions.hpp"

#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

/// The wave along the distance ξ from the loaded end.
class Reflections {
 public:
  explicit Reflections(const BarWave& bar)
      : bar_(bar),
        speed_(std::sqrt(bar.modulus / bar.density)),
        impedance_(bar.density * speed_),
        mirror_(bar.far_end == BarWave::Support::fixed ? -1.0 : 1.0) {}

  /// u [m], towards growing coordinate.
  [[nodiscard]] double displacement(double x, double t) const {
    const auto integrated = [&](double s) { return integral(bar_.traction, s); };
    return -sense() / impedance_ * sum(x, t, integrated, mirror_);
  }

  /// ∂u/∂t [m/s].
  [[nodiscard]] double velocity(double x, double t) const {
    const auto load = [&](double s) { return value(bar_.traction, s); };
    return -sense() / impedance_ * sum(x, t, load, mirror_);
  }

  /// P_xx [Pa].
  [[nodiscard]] double stress(double x, double t) const {
    const auto load = [&](double s) { return value(bar_.traction, s); };
    return sum(x, t, load, -mirror_);
  }

  /// P_yy/P_xx.
  [[nodiscard]] double lateral_share() const { return bar_.lateral_modulus / bar_.modulus; }

 private:
  /// +1 if ξ grows with the coordinate. Mirroring the bar turns u round and leaves P.
  [[nodiscard]] double sense() const { return bar_.loaded == BarWave::Side::lower ? 1.0 : -1.0; }

  /// Σ_k mirror^k [f(t − (2kL + ξ)/c) + back · f(t − (2(k+1)L − ξ)/c)] over all arrivals up to t.
  template <class Wave>
  [[nodiscard]] double sum(double x, double t, Wave f, double back) const {
    const double from_lower = x - bar_.lower;
    const double distance = sense() > 0 ? from_lower : bar_.length - from_lower;
    const double round_trip = 2 * bar_.length / speed_;
    const double delay = distance / speed_;
    double total = 0.0, factor = 1.0;
    for (int k = 0; k * round_trip + delay <= t; ++k) {
      total +=
          factor * (f(t - (k * round_trip + delay)) + back * f(t - ((k + 1) * round_trip - delay)));
      factor *= mirror_;
    }
    return total;
  }

  BarWave bar_;
  double speed_;
  double impedance_;
  double mirror_;
};

template <int D>
Vector<D> along_x(double component) {
  return component * Vector<D>::Unit(0);
}

double wave_number(const SwingingPlate& plate) {
  return std::numbers::pi / (2 * plate.length);
}

/// [−sin(kX) cos(kY), cos(kX) sin(kY)].
Vector<2> shape(const SwingingPlate& plate, const Vector<2>& X) {
  const Vector<2> phase = wave_number(plate) * (X - plate.corner);
  return {-std::sin(phase[0]) * std::cos(phase[1]), std::cos(phase[0]) * std::sin(phase[1])};
}

}  // namespace

template <int D>
ExactSolution<D> bar_wave(const BarWave& bar) {
  if (!(bar.length > 0 && bar.modulus > 0 && bar.density > 0))
    throw InputError("a bar wave needs a positive length, modulus and density");
  const Reflections wave(bar);
  return {[wave](const Vector<D>& X, double t) { return along_x<D>(wave.displacement(X[0], t)); },
          [wave](const Vector<D>& X, double t) { return along_x<D>(wave.velocity(X[0], t)); },
          [wave](const Vector<D>& X, double t) {
            Tensor<D> P = Tensor<D>::Zero();
            P(0, 0) = wave.stress(X[0], t);
            if constexpr (D == 2) P(1, 1) = wave.lateral_share() * P(0, 0);
            return P;
          }};
}

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

double cantilever_mode(double xi) {
  constexpr double kappa = cantilever_wave_number;
  const double sigma = (std::cosh(kappa) + std::cos(kappa)) / (std::sinh(kappa) + std::sin(kappa));
  const double s = kappa * xi;
  return 0.5 * (std::cosh(s) - std::cos(s) - sigma * (std::sinh(s) - std::sin(s)));
}

#define TLSPH_INSTANTIATE(D)                             \
  template ExactSolution<D> bar_wave<D>(const BarWave&); \
  template ExactSolution<D> uniform_stretch<D>(const UniformStretch&, const AnyLaw<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
