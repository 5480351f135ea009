#include "run_loop.hpp"

#include <fmt/format.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "in_scene.hpp"
#include "parts.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
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
    request.quantities = probe.record;
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
    for (std::string& warning : parts::start_jumps<D>(scene_, disc_, initial))
      summary.warnings.push_back(std::move(warning));
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
    speed_ = state_.v.cwiseAbs().maxCoeff();
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
      if (evaluated_ && state_.step > 0) ledger_.arrive(disc_, state_, clock_.dt);
      observe();
      if (state_.step == clock_.last()) break;
      step();
      if (output_) output_->keep_probes();
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
  if (!sweep_) speed_ = state_.v.cwiseAbs().maxCoeff();
  evaluated_ = !sweep_ || books_due() || frame_due() || alarmed();
  if (!sweep_) {
    evaluate<D>(disc_, state_);
  } else if (evaluated_ || probes_due()) {
    const Stopwatch watch;
    if (evaluated_)
      sweep_->evaluate(state_);
    else
      excerpt_->evaluate(disc_, state_);
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
  speed_ = forces_->largest_speed;
  if (follower_) follower_->travelled(clock_.dt * speed_);
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
  if (!output_ || next_frame_ > frames || growing_ > 0) return false;
  const double frame_time = static_cast<double>(next_frame_) * scene_.time.end /
                            static_cast<double>(std::max(1L, frames));
  return state_.step == clock_.last() || state_.time >= frame_time - 0.5 * clock_.dt;
}

template <int D>
void RunLoop<D>::observe() {
  const bool frame = evaluated_ && frame_due();  // a longer step may just have come near one
  if (books_due() || frame || alarmed()) sample_books();
  if (books_due()) watch_hyperbolicity();
  report_progress();
  if (!probes_due() && !frame) return;
  const Stopwatch watch;
  if (probes_due()) output_->write_probes(disc_, state_, clock_.dt, evaluated_);
  if (frame && growing_ == 0) {
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
void RunLoop<D>::report_progress() {
  if (!options_.progress || state_.step % 16 != 0) return;
  const double now = Stopwatch::now();
  if (now - last_progress_ < 0.1 && state_.step != clock_.last()) return;
  last_progress_ = now;
  options_.progress({state_.time, scene_.time.end, state_.step, clock_.last()});
}

template class RunLoop<1>;
template class RunLoop<2>;

}  // namespace tlsph
