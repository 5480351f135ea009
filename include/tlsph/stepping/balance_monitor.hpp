#pragma once
/// \file
/// How far a run departs from its balances of energy and momenta, and whether its motion grows
/// without bound.

#include <optional>
#include <string>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/balance.hpp"

namespace tlsph {

template <int D>
class BalanceMonitor {
 public:
  /// `tolerance`: the largest drift of the energy allowed, over the largest energy. `cure`: what
  /// the message of unbounded growth recommends.
  BalanceMonitor(std::optional<double> tolerance, std::string cure)
      : tolerance_(tolerance), cure_(std::move(cure)) {}

  /// A sample at `now`, evaluated; `counts`: the drifts below follow it. NumericalError where the
  /// energy is not finite, has left the tolerance, or has grown for several samples in sequence
  /// (naming the first of them).
  void add(const Instant<D>& now, const WorkAndImpulse<D>& done, bool counts);
  /// Whether the energy of a sample is far above what the balance explains.
  [[nodiscard]] bool unexplained(const Balance<D>& sample) const;

  [[nodiscard]] const Balance<D>& last() const { return last_; }
  [[nodiscard]] bool growing() const { return growing_ > 0; }
  /// The last state within its balance: step, time, last_dt, u and v; empty before the first
  /// sample.
  [[nodiscard]] const State<D>& balanced() const { return balanced_; }

  /// max|E − E₀ − W + dissipated| / max E, and the drifts of both momenta over their scales.
  [[nodiscard]] double energy_drift() const { return over(drift_, largest_energy_); }
  [[nodiscard]] double linear_momentum_drift() const {
    return over(momentum_drift_, momentum_scale_);
  }
  [[nodiscard]] double angular_momentum_drift() const {
    return over(angular_drift_, angular_scale_);
  }

  /// Calls `visit(name, value)` for all that a checkpoint needs.
  template <class Visit>
  void visit(const Visit& visit) {
    visit("first_energy", first_energy_);
    visit("largest_energy", largest_energy_);
    visit("drift", drift_);
    visit("first_momentum", first_momentum_);
    visit("first_angular", first_angular_);
    visit("momentum_scale", momentum_scale_);
    visit("angular_scale", angular_scale_);
    visit("momentum_drift", momentum_drift_);
    visit("angular_drift", angular_drift_);
    visit("energy_scale", energy_scale_);
  }

 private:
  static double over(double drift, double scale) { return scale > 0.0 ? drift / scale : 0.0; }
  void check_growth(const Instant<D>& now, const WorkAndImpulse<D>& done);
  void count(const Instant<D>& now, const WorkAndImpulse<D>& done);

  std::optional<double> tolerance_;
  std::string cure_;
  Balance<D> last_;
  double first_energy_ = 0.0, largest_energy_ = 0.0, drift_ = 0.0;  ///< [J per thickness]
  Vector<D> first_momentum_ = Vector<D>::Zero();
  double first_angular_ = 0.0, momentum_scale_ = 0.0, angular_scale_ = 0.0;
  double momentum_drift_ = 0.0, angular_drift_ = 0.0;
  double energy_scale_ = 0.0;  ///< largest energy that the balance explains [J per thickness]
  long growing_ = 0;           ///< samples in sequence whose energy it does not explain
  std::optional<NumericalError> growth_;  ///< where that began
  State<D> balanced_;
};

}  // namespace tlsph
