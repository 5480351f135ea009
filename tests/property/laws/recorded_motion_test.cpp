/// A body that is moved by samples of a smooth motion is accelerated as by the motion itself.

#include <numbers>

#include "property/bodies.hpp"

namespace tlsph::property {
namespace {

/// A packet of 2 Hz about t = 0.6 s.
double motion(double t) {
  const double s = t - 0.6;
  return 0.01 * std::sin(4.0 * std::numbers::pi * s) * std::exp(-s * s / 0.02);
}

struct Peaks {
  double foot = 0.0, top = 0.0;  ///< largest accelerations [m/s²]
};

/// A bar of 4 m with a first period of 0.18 s, its foot moved by samples at that rate [Hz].
Peaks peaks(int rate, bool smooth) {
  Discretisation<1> body = build<1>(read_scene_text(R"(
dimension = 1
[body]
shape = { interval = [0.0, 4.0] }
spacing = 0.05
[material]
law = "linear-elastic"
assumption = "stress"
young = 2e7
poisson = 0.2
density = 2400
[[boundary]]
where = "left"
displacement = { x = { curve = "ramp", amplitude = 1.0, rise = 1.0 } }
[time]
end = 1.2
)",
                                                    "column", {}));
  TableCurve table;
  for (int k = 0; k <= 12 * rate / 10; ++k) {
    table.time.push_back(static_cast<double>(k) / rate);
    table.values.push_back(motion(table.time.back()));
  }
  body.constraints.curves.front() = smooth ? cubic_spline(table) : table;
  State<1> state = make_state<1>(body, VectorField<1>::Zero(body.nodes(), 1),
                                 VectorField<1>::Zero(body.nodes(), 1));
  evaluate<1>(body, state);
  const double dt = 0.9 * critical_step<1>(body, state).dt;
  Peaks result;
  const auto acceleration = [&](const State<1>& now, Index dof) {
    return std::abs(next_velocity<1>(body, now, dt, dof) - now.v.data()[dof]) / dt;
  };
  march<1>(body, state, dt, static_cast<long>(1.2 / dt), 1,
           [&](const State<1>& now, const WorkAndImpulse<1>&) {
             if (now.step == 0) return;
             result.foot = std::max(result.foot, acceleration(now, 0));
             result.top = std::max(result.top, acceleration(now, body.nodes() - 1));
           });
  return result;
}

TEST(RecordedMotion, AcceleratesAsTheMotionItself) {
  const Peaks exact = peaks(2000, true);
  const Peaks sampled = peaks(100, true);
  const Peaks broken = peaks(100, false);

  EXPECT_NEAR(sampled.foot, exact.foot, 0.01 * exact.foot);
  EXPECT_NEAR(sampled.top, exact.top, 0.01 * exact.top);
  EXPECT_GT(broken.foot, 3.0 * exact.foot);  // lines have no acceleration but at their ends
}

}  // namespace
}  // namespace tlsph::property
