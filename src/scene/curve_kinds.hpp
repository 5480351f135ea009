#pragma once
/// \file
/// The load curves a scene can name, each with the keys it needs.

#include <string_view>
#include <utility>
#include <vector>

#include "tlsph/curves/curve.hpp"

namespace tlsph {

/// The keys of a curve's table, zero or empty where not given.
struct CurveValues {
  double amplitude = 0.0;
  double rise = 0.0;
  double duration = 0.0;
  std::vector<double> time, value;
  bool cubic = false;
};

struct CurveKind {
  std::string_view name;
  std::vector<std::string_view> needs;  ///< beside `amplitude`
  Curve (*make)(const CurveValues&);
};

[[nodiscard]] inline const std::vector<CurveKind>& curve_kinds() {
  using Values = const CurveValues&;
  static const std::vector<CurveKind> kinds = {
      {"constant", {}, [](Values v) -> Curve { return ConstantCurve{v.amplitude}; }},
      {"ramp",
       {"rise"},
       [](Values v) -> Curve {
         return RampCurve{v.amplitude, v.rise, false};
       }},
      {"smooth-ramp",
       {"rise"},
       [](Values v) -> Curve {
         return RampCurve{v.amplitude, v.rise, true};
       }},
      {"pulse",
       {"duration", "rise"},
       [](Values v) -> Curve {
         return PulseCurve{v.amplitude, v.duration, v.rise};
       }},
      {"sine-squared",
       {"duration"},
       [](Values v) -> Curve {
         return SineSquaredCurve{v.amplitude, v.duration};
       }},
      {"table",
       {"time", "value"},
       [](Values v) -> Curve {
         TableCurve curve{v.time, v.value, {}};
         for (double& x : curve.value) x *= v.amplitude;
         return v.cubic ? cubic_spline(std::move(curve)) : curve;
       }},
  };
  return kinds;
}

}  // namespace tlsph
