#include "tlsph/exact/bar_wave.hpp"

#include <cmath>

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

template ExactSolution<1> bar_wave<1>(const BarWave&);
template ExactSolution<2> bar_wave<2>(const BarWave&);

}  // namespace tlsph
