#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/edit.hpp"
#include "tlsph/stepping/stepper.hpp"

namespace tlsph {
namespace {

constexpr double last_stretch = 0.2;
constexpr double safety = 0.95;
constexpr long compare_every = 3;  ///< steps between comparisons with the true limit

/// The right edge moves in at `speed` [m/s], from one instant to the next.
Scene compressed(const Subject& subject, const Method& method, double speed) {
  const double way = (1.0 - last_stretch) * (subject.upper[0] - subject.lower[0]);
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
void compress(const Subject& subject, const Compression& study, CompressionRow& row) {
  const double c = build<D>(compressed(subject, study.method, 1.0)).wave_speed();
  const Scene scene = compressed(subject, study.method, study.speed * c);
  const auto body = build<D>(scene);
  VectorField<D> v = VectorField<D>::Zero(body.nodes(), D);
  if (!study.impact)
    v.col(0) = -study.speed * c / (subject.upper[0] - subject.lower[0]) *
               (body.particles.X.col(0).array() - subject.lower[0]);
  Stepper<D> stepper(body, VectorField<D>::Zero(body.nodes(), D), v,
                     {.safety = safety,
                      .adaptive = study.adaptive,
                      .rehearse = false,
                      .threads = 1,
                      .balance_every = 0});
  const State<D>& state = stepper.state();
  const bool compare = study.finer == 1;
  double stepping = 0.0;
  row.closest = compare ? 0.0 : not_known;
  row.smallest = 1.0;
  try {
    while (state.time < scene.time.end) {
      Stopwatch watch;
      stepper.prepare();
      stepping += watch.seconds();
      if (compare && state.step % compare_every == 0) {
        stepper.evaluate();
        if (const auto limit = critical_step_if_any<D>(body, state))
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
  row.particles = body.nodes();
  row.smallest = std::min(row.smallest, smallest_volume<D>(state));
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

std::string Compression::name() const {
  return finer > 1 ? "crush of a fine body, " + method.name
                   : fmt::format("crush of {} at {} c", method.name, speed);
}

std::vector<Compression> compressions(int dimension) {
  constexpr std::array names = {"stress-point",        "stress-point cells + S", "variational 2.5",
                                "variational 2.5 + S", "consistent [1, 1]",      "mirror 2.5"};
  std::vector<Compression> list;
  for (const Method& method : atlas_methods(dimension)) {
    if (std::ranges::find(names, method.name) == names.end()) continue;
    for (const auto& [impact, speed] :
         {std::pair{false, 0.02}, {false, 0.4}, {true, 0.02}, {true, 0.1}})
      for (const bool adaptive : {false, true}) list.push_back({method, impact, speed, adaptive});
  }
  list.push_back({list.front().method, false, 0.02, true, dimension == 1 ? 16 : 4});
  return list;
}

CompressionRow compression_row(const Subject& subject, const Compression& study) {
  Subject body = subject;
  body.scene.body.spacing = subject.spacing / study.finer;
  CompressionRow row;
  row.method = study.method.name;
  row.step = study.adaptive ? "followed" : "the first step";
  row.motion = study.impact ? "struck" : "pressed";
  row.speed = study.speed;
  row.safety = safety;
  in_dimension(subject.dimension, [&]<int D>() { compress<D>(body, study, row); });
  return row;
}

}  // namespace tlsph
