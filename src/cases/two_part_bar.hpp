#pragma once
/// \file
/// A pulse in a bar of two materials, exactly: every ray that its interface and its ends make of
/// it.

#include <vector>

#include "tlsph/curves/curve.hpp"

namespace tlsph {

/// A bar from 0 to `length`, loaded at 0 from rest. Part A ends at `interface`, where part B
/// begins; all in SI units.
struct TwoPartBar {
  double interface = 0.0, length = 0.0;
  double speed_a = 0.0, speed_b = 0.0;  ///< [m/s]
  double impedance_ratio = 1.0;         ///< ρ_B c_B / ρ_A c_A
  bool fixed_end = true;                ///< else free
  Curve traction;                       ///< at 0 [Pa]

  /// (4.45) of the thesis: the stress sent back over the stress that comes, from A.
  [[nodiscard]] double reflected() const { return (impedance_ratio - 1) / (impedance_ratio + 1); }
  /// (4.46): the stress that goes on into B.
  [[nodiscard]] double transmitted() const { return 2 * impedance_ratio / (impedance_ratio + 1); }
};

/// The stress of a TwoPartBar until a given time.
class TwoPartWave {
 public:
  /// Follows all rays that set out before `end` [s].
  TwoPartWave(const TwoPartBar& bar, double end);
  /// P [Pa] at the place x [m] and time t ≤ end [s].
  [[nodiscard]] double stress(double x, double t) const;

 private:
  struct Ray {
    bool in_b, outward;
    double start;   // when it sets out from its end of its part [s]
    double factor;  // of the traction
  };
  TwoPartBar bar_;
  std::vector<Ray> rays_;
};

}  // namespace tlsph
