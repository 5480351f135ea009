#include "crush.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/stepping/stepper.hpp"

namespace tlsph {
namespace {

constexpr double stretch = 0.2;
constexpr long compare_every = 3;  ///< steps between comparisons with the true limit

/// The right edge moves in at `speed` [m/s], from one instant to the next.
Scene crushing(const Subject& subject, const Method& method, double speed) {
  const double way = (1.0 - stretch) * (subject.upper[0] - subject.lower[0]);
  Scene scene = subject.scene;
  method.apply_to(scene);
  scene.boundaries = sliding_edges(subject.dimension, RampCurve{-way, way / speed});
  scene.time.end = way / speed;
  return completed(scene);
}

template <int D>
double smallest_volume(const State<D>& state) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Index s = 0; s < state.H.rows(); ++s)
    smallest = std::min(smallest, 1.0 + volume_change<D>(tensor_at<D>(state.H, s)));
  return smallest;
}

template <int D>
void crush(const Subject& subject, const Method& method, Motion motion, double speed, Follow follow,
           bool compare, CrushRow& row) {
  const double c = [&] {
    const auto still = build<D>(crushing(subject, method, 1.0));
    return still.wave_speed();
  }();
  const Scene scene = crushing(subject, method, speed * c);
  const auto disc = build<D>(scene);
  VectorField<D> v = VectorField<D>::Zero(disc.nodes(), D);
  if (motion == Motion::pressed)
    v.col(0) = -speed * c / (subject.upper[0] - subject.lower[0]) *
               (disc.particles.X.col(0).array() - subject.lower[0]);
  Stepper<D> stepper(disc, VectorField<D>::Zero(disc.nodes(), D), v,
                     {.safety = row.safety,
                      .adaptive = follow == Follow::follower,
                      .rehearse = false,
                      .threads = 1,
                      .balance_every = 0});
  const State<D>& state = stepper.state();
  double stepping = 0.0;
  row.closest = 0.0;
  row.smallest = 1.0;
  try {
    while (state.time < scene.time.end) {
      Stopwatch watch;
      stepper.prepare();
      stepping += watch.seconds();
      if (compare && state.step % compare_every == 0) {
        stepper.evaluate();
        if (const auto limit = critical_step_if_any<D>(disc, state))
          row.closest = std::max(row.closest, stepper.dt() / limit->dt);
        row.smallest = std::min(row.smallest, smallest_volume<D>(state));
      }
      watch = {};
      stepper.step();
      stepping += watch.seconds();
    }
    stepper.evaluate();
  } catch (const NumericalError& failure) {
    row.failure = failure.what();
  }
  row.particles = disc.nodes();
  row.smallest = std::min(row.smallest, smallest_volume<D>(state));
  if (!compare) row.closest = not_known;
  row.steps = state.step;
  row.estimates = 1;
  if (const AdaptiveStep<D>* adaptive = stepper.adaptive()) {
    row.estimates = adaptive->estimates();
    row.bounds = adaptive->bounds();
    row.looks = adaptive->checks();
    row.share = adaptive->seconds() / stepping;
  }
}

}  // namespace

std::vector<Method> crushed_methods(int dimension) {
  std::vector<Method> chosen;
  constexpr std::array<std::string_view, 6> names = {"stress-point",      "stress-point cells + S",
                                                     "variational 2.5",   "variational 2.5 + S",
                                                     "consistent [1, 1]", "mirror 2.5"};
  for (Method& method : atlas_methods(dimension))
    if (std::ranges::count(names, method.name) > 0) chosen.push_back(std::move(method));
  return chosen;
}

CrushRow crush_row(const Subject& subject, const Method& method, Motion motion, double speed,
                   double safety, Follow follow, int finer) {
  Subject body = subject;
  body.scene.body.spacing = subject.spacing / finer;
  CrushRow row;
  row.method = method.name;
  row.follow = follow == Follow::never ? "the first step" : "followed";
  row.motion = motion == Motion::pressed ? "pressed" : "struck";
  row.speed = speed;
  row.safety = safety;
  in_dimension(subject.dimension,
               [&]<int D>() { crush<D>(body, method, motion, speed, follow, finer == 1, row); });
  return row;
}

}  // namespace tlsph
