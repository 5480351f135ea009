#include "crush.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/step_follower.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"

namespace tlsph {
namespace {

constexpr double stretch = 0.2;
constexpr long compare_every = 3;  ///< steps between comparisons with the true limit

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

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
  State<D> state = make_state<D>(disc, VectorField<D>::Zero(disc.nodes(), D), v);
  evaluate<D>(disc, state);
  StepFollower<D> follower(disc, state, row.safety);
  std::optional<Sweep<D>> sweep;  // as runs do
  if (Sweep<D>::possible(disc)) {
    sweep.emplace(disc);
    follower.read_by(*sweep);
  }
  BoundaryForces<D> forces(disc);
  double dt = follower.step();
  double stepping = 0.0;
  double following = 0.0;
  row.closest = 0.0;
  row.smallest = 1.0;
  start<D>(disc, state, dt);
  try {
    while (state.time < scene.time.end) {
      auto begin = Clock::now();
      if (!sweep) evaluate<D>(disc, state);
      stepping += seconds_since(begin);
      if (follow == Follow::follower) {
        begin = Clock::now();
        if (follower.follow(state)) dt = follower.step();
        following += seconds_since(begin);
      }
      if (compare && state.step % compare_every == 0) {
        if (sweep) evaluate<D>(disc, state);
        if (const auto limit = critical_step_if_any<D>(disc, state))
          row.closest = std::max(row.closest, dt / limit->dt);
        row.smallest = std::min(row.smallest, smallest_volume<D>(state));
      }
      begin = Clock::now();
      if (sweep) {
        sweep->step(state, dt, state.time + dt, forces);
        follower.travelled(dt * forces.largest_speed);
      } else {
        advance<D>(disc, state, dt, state.time + dt);
      }
      stepping += seconds_since(begin);
    }
    evaluate<D>(disc, state);
  } catch (const NumericalError& failure) {
    row.failure = failure.what();
  }
  row.particles = disc.nodes();
  row.smallest = std::min(row.smallest, smallest_volume<D>(state));
  if (!compare) row.closest = not_known;
  row.steps = state.step;
  row.estimates = follower.estimates();
  row.bounds = follower.bounds();
  row.looks = follower.looks();
  row.share = following / (stepping + following);
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
