#include "run_loop.hpp"

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "in_scene.hpp"
#include "stopwatch.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/dynamics/hyperbolicity.hpp"
#include "tlsph/observe/errors.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

/// Rows of the energy ledger a run has by default, and the steps between them at least: a look at
/// all energies costs as much as some twenty steps.
constexpr long default_book_rows = 200;
constexpr long fewest_steps_between = 50;

template <int D>
std::vector<ProbeRequest<D>> probe_requests(const Scene& scene) {
  std::vector<ProbeRequest<D>> requests;
  for (const ProbeScene& probe : scene.probes) {
    ProbeRequest<D> request{
        probe.name, Eigen::Map<const Vector<D>>(probe.at.data()), {}, probe.place};
    for (const Quantity quantity : probe.record) request.quantities.emplace_back(name_of(quantity));
    requests.push_back(std::move(request));
  }
  return requests;
}

}  // namespace

template <int D>
RunLoop<D>::RunLoop(const Scene& scene, const RunOptions& options, const Discretisation<D>& disc)
    : scene_(scene),
      options_(options),
      disc_(disc),
      exact_(build_exact<D>(scene, disc)),
      probes_(disc, probe_requests<D>(scene)) {}

template <int D>
void RunLoop<D>::plan_sweep(Summary& summary) {
  SweepOptions options;
  options.threads = worth_threads(disc_.nodes()) ? omp_get_max_threads() : 1;
  summary.threads = options.threads;
  if (!Sweep<D>::possible(disc_)) {
    if (worth_threads(disc_.points.size())) summary.threads = omp_get_max_threads();
    return;
  }
  options.single_weights = scene_.precision == Precision::mixed;
  sweep_.emplace(disc_, options);
  summary.storage = sweep_->storage();
  forces_ = sweep_->boundary_forces();
  if (follower_) follower_->read_by(*sweep_);
  if (!probes_.columns().empty()) excerpt_.emplace(disc_, probes_.nodes(), probes_.points());
}

template <int D>
void RunLoop<D>::run(Summary& summary) {
  const Stopwatch setup;
  in_scene(scene_, [&] {
    InitialState<D> initial = build_initial<D>(scene_, disc_);
    state_ = make_state<D>(disc_, std::move(initial.displacement), std::move(initial.velocity));
    evaluate<D>(disc_, state_);
    choose_step(summary);
    stop_point();
    plan_sweep(summary);
  });
  books_every_ = scene_.output.energy_every > 0
                     ? scene_.output.energy_every
                     : std::max(fewest_steps_between, clock_.count / default_book_rows);
  may_end_at_once() = false;
  if (options_.resume) {
    resume_from(read_checkpoint(options_.out / "checkpoint.h5"));
  } else {
    if (!options_.out.empty())
      output_.emplace(options_.out, scene_, disc_, probes_, exact_, std::nullopt);
    start<D>(disc_, state_, clock_.dt);
    save_checkpoint();
  }
  summary.wall_setup += setup.seconds();

  const Stopwatch loop;
  const double output_before = output_seconds_;
  const long first_step = state_.step;
  const auto close_books = [&] {
    summary.wall_output = output_seconds_;
    summary.wall_stepping = loop.seconds() - (output_seconds_ - output_before);
    finish(summary);
    const auto done = static_cast<double>(state_.step - first_step);
    if (done > 0)
      summary.ns_per_particle_step =
          summary.wall_stepping * 1e9 / done / static_cast<double>(disc_.nodes());
  };
  try {
    while (true) {
      evaluate_for_observers();
      follow_deformation();
      observe();
      if (state_.step == clock_.last()) break;
      step();
      // A checkpoint holds a step that is not booked yet: the loop, or a resumed one, does that
      // next.
      if (options_.stop_requested != nullptr && *options_.stop_requested) {
        summary.interrupted = true;
        save_checkpoint();
        evaluate<D>(disc_, state_);
        break;
      }
      if (checkpoint_due()) save_checkpoint();
    }
  } catch (const NumericalError& failure) {
    summary.failure = failure.what();
    if (hyperbolicity_lost_) summary.failure += "; before that, " + hyperbolicity_lost_->text();
    keep_last_good_state();
    close_books();
    throw NumericalError(summary.failure, failure.time(), failure.particle());
  }
  if (exact_.displacement && !summary.interrupted) {
    const Stopwatch watch;
    const RelativeErrors errors = errors_against<D>(exact_, disc_, state_, clock_.dt);
    summary.errors = FieldErrors{errors.displacement, errors.velocity, errors.stress};
    output_seconds_ += watch.seconds();
  }
  close_books();
}

/// A sweep needs no evaluated state; observers do, all of it or the part that probes see. Without a
/// sweep every step does.
template <int D>
void RunLoop<D>::evaluate_for_observers() {
  evaluated_ = !sweep_ || books_due() || frame_due();
  if (!sweep_) {
    evaluate<D>(disc_, state_);
    if (state_.step > 0) ledger_.arrive(disc_, state_, clock_.dt);
  } else if (evaluated_ || probes_due()) {
    const Stopwatch watch;
    if (evaluated_)
      sweep_->evaluate(state_);
    else
      excerpt_->evaluate(disc_, state_);
    if (evaluated_ && state_.step > 0) ledger_.arrive(disc_, state_, clock_.dt);
    output_seconds_ += watch.seconds();
  }
}

template <int D>
void RunLoop<D>::step() {
  const double next = clock_.time(state_.step + 1);
  if (!sweep_) {
    ledger_.depart(disc_, state_, clock_.dt);
    advance<D>(disc_, state_, clock_.dt, next);
    return;
  }
  const double time = state_.time;
  const double way = state_.last_dt;
  const bool arrived = evaluated_ || state_.step == 0;
  sweep_->step(state_, clock_.dt, next, *forces_);
  if (follower_) follower_->travelled(clock_.dt * forces_->largest_speed);
  ledger_.book(disc_, *forces_, state_, time, way, clock_.dt, arrived);
}

template <int D>
bool RunLoop<D>::books_due() const {
  return state_.step % books_every_ == 0 || state_.step == clock_.last();
}

template <int D>
bool RunLoop<D>::probes_due() const {
  return output_ && !probes_.columns().empty() &&
         (state_.step % scene_.output.probe_every == 0 || state_.step == clock_.last());
}

template <int D>
bool RunLoop<D>::frame_due() const {
  const long frames = scene_.output.frames;
  if (!output_ || next_frame_ > frames) return false;
  const double frame_time = static_cast<double>(next_frame_) * scene_.time.end /
                            static_cast<double>(std::max(1L, frames));
  return state_.step == clock_.last() || state_.time >= frame_time - 0.5 * clock_.dt;
}

template <int D>
void RunLoop<D>::observe() {
  if (books_due()) {
    sample_books();
    watch_hyperbolicity();
  }
  report_progress();
  if (!probes_due() && !frame_due()) return;
  const Stopwatch watch;
  if (probes_due()) output_->write_probes(disc_, state_, clock_.dt);
  if (frame_due()) {
    output_->write_frame(disc_, state_, clock_.dt);
    while (next_frame_ <= scene_.output.frames &&
           state_.time >= static_cast<double>(next_frame_) * scene_.time.end /
                                  static_cast<double>(std::max(1, scene_.output.frames)) -
                              0.5 * clock_.dt)
      ++next_frame_;
  }
  output_seconds_ += watch.seconds();
}

template <int D>
void RunLoop<D>::sample_books() {
  const Stopwatch watch;
  const Balance<D> now = balance<D>(disc_, state_, clock_.dt);
  const double energy = now.kinetic + now.elastic;
  const double work = ledger_.external_work + now.gravity;
  const Vector<D> momentum = now.linear_momentum - ledger_.impulse;
  const double angular = now.angular_momentum - ledger_.angular_impulse;
  if (state_.step == 0) {
    first_energy_ = energy;
    first_momentum_ = momentum;
    first_angular_ = angular;
  }
  largest_energy_ = std::max(largest_energy_, std::abs(energy));
  drift_ = std::max(drift_, std::abs(energy - first_energy_ - work + ledger_.dissipated));
  momentum_scale_ = std::max(momentum_scale_, now.momentum_scale);
  angular_scale_ = std::max(angular_scale_, now.angular_scale);
  momentum_drift_ = std::max(momentum_drift_, (momentum - first_momentum_).norm());
  angular_drift_ = std::max(angular_drift_, std::abs(angular - first_angular_));
  if (output_) {
    std::array<double, 6 + D> row{now.kinetic, now.elastic, work, ledger_.dissipated};
    for (std::size_t i = 0; i < D; ++i) row[4 + i] = now.linear_momentum[static_cast<Index>(i)];
    row[4 + D] = now.angular_momentum;
    row[5 + D] = clock_.dt;
    output_->write_series(state_.time, row);
  }
  output_seconds_ += watch.seconds();
}

template <int D>
void RunLoop<D>::watch_hyperbolicity() {
  if (hyperbolicity_lost_ || disc_.linear()) return;
  const Stopwatch watch;
  const auto worst = most_unstable_point<D>(disc_, state_);
  output_seconds_ += watch.seconds();
  if (!worst) return;
  const auto X = disc_.points.X.row(worst->point);
  hyperbolicity_lost_ = {state_.time,
                         worst->point,
                         {X.begin(), X.end()},
                         {worst->stretches.begin(), worst->stretches.end()},
                         worst->acoustic_eigenvalue};
}

template <int D>
void RunLoop<D>::keep_last_good_state() {
  if (!output_ || state_.step == 0) return;
  // One step back: u_n = u_{n−1} + Δt v_{n−½}. Frames written at the lost state itself do not
  // exist, for evaluate throws first.
  state_.u -= state_.last_dt * state_.v;
  state_.time -= state_.last_dt;
  --state_.step;
  try {
    evaluate<D>(disc_, state_);
    if (!output_->has_frame(state_.time, 0.5 * state_.last_dt))
      output_->write_frame(disc_, state_, clock_.dt);
  } catch (const NumericalError&) {
    // Lost for more than a step without notice; the frames before stand.
  }
}

template <int D>
void RunLoop<D>::report_progress() {
  if (!options_.progress || state_.step % 16 != 0) return;
  const double now = Stopwatch::now();
  if (now - last_progress_ < 0.1 && state_.step != clock_.last()) return;
  last_progress_ = now;
  options_.progress({state_.time, scene_.time.end, state_.step, clock_.last()});
}

template <int D>
void RunLoop<D>::finish(Summary& summary) {
  const Balance<D> now = balance<D>(disc_, state_, clock_.dt);
  if (output_) {
    const Stopwatch watch;
    output_->flush();
    summary.wall_output += watch.seconds();
  }
  summary.hyperbolicity_lost = hyperbolicity_lost_;
  summary.steps = state_.step;
  summary.end_time = state_.time;
  summary.energy = {now.kinetic, now.elastic, ledger_.external_work + now.gravity,
                    ledger_.dissipated, largest_energy_ > 0.0 ? drift_ / largest_energy_ : 0.0};
  summary.linear_momentum_drift = momentum_scale_ > 0.0 ? momentum_drift_ / momentum_scale_ : 0.0;
  summary.angular_momentum_drift = angular_scale_ > 0.0 ? angular_drift_ / angular_scale_ : 0.0;
}

template class RunLoop<1>;
template class RunLoop<2>;

}  // namespace tlsph
