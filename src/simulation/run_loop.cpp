#include "run_loop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "in_scene.hpp"
#include "preflight.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/observe/errors.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

/// Rows of energies a run has by default, and the steps between them at least: a sample of all
/// energies costs as much as some twenty steps.
constexpr long default_balance_rows = 200;
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
RunLoop<D>::RunLoop(const Scene& scene, const RunOptions& options, const Discretisation<D>& body,
                    Summary& summary)
    : scene_(scene),
      options_(options),
      body_(body),
      summary_(summary),
      exact_(build_exact<D>(scene, body)),
      probes_(body, probe_requests<D>(scene)),
      recorded_{
          History(probes_.columns()),
          History(exact_.displacement ? probes_.exact_columns() : std::vector<std::string>())},
      probe_row_(1 + recorded_.computed.names.size()),
      exact_row_(1 + recorded_.exact.names.size()) {
  if (options_.histories != nullptr) *options_.histories = recorded_;
}

template <int D>
void RunLoop<D>::start() {
  const Stopwatch watch;
  InitialState<D> initial = build_initial<D>(scene_, body_);
  for (std::string& warning : start_jumps<D>(scene_, body_, initial))
    summary_.warnings.push_back(std::move(warning));
  stepper_.emplace(body_, std::move(initial.displacement), std::move(initial.velocity),
                   StepperOptions<D>{.end = scene_.time.end,
                                     .safety = scene_.time.safety,
                                     .step = scene_.time.step,
                                     .single_weights = scene_.precision == Precision::mixed,
                                     .energy_tolerance = scene_.time.energy_tolerance});
  const CriticalStep& critical = stepper_->critical();
  checked_step(scene_, critical);
  stop_point();
  stepper_->start(options_.resume);
  stepper_->set_balance_every(
      scene_.output.energy_every > 0
          ? scene_.output.energy_every
          : std::max(fewest_steps_between, stepper_->steps() / default_balance_rows));
  summary_.dt = stepper_->dt();
  summary_.dt_critical = critical.dt;
  summary_.dt_critical_scaled = critical.scaled;
  summary_.growth_rate = critical.growth;
  summary_.threads = stepper_->threads();
  if (stepper_->sweep() != nullptr) {
    summary_.storage = stepper_->sweep()->storage();
    if (!probes_.columns().empty()) probed_.emplace(body_, probes_.nodes(), probes_.points());
  }
  summary_.wall_setup += watch.seconds();
}

template <int D>
void RunLoop<D>::open_files() {
  const Stopwatch watch;
  may_end_at_once() = false;
  if (options_.resume) {
    resume_from(read_checkpoint(options_.out / "checkpoint.h5"));
  } else if (!options_.out.empty()) {
    output_.emplace(options_.out, scene_, body_, recorded_, std::nullopt);
    save_checkpoint();
  }
  summary_.wall_setup += watch.seconds();
}

template <int D>
void RunLoop<D>::run() {
  in_scene(scene_, [&] { start(); });
  open_files();
  const Stopwatch watch;
  const double output_before = output_seconds_;
  const long first_step = state().step;
  std::optional<NumericalError> failure;
  try {
    while (true) {
      stepper_->prepare(frame_due());
      if (probed_ && probes_due()) stepper_->evaluate(*probed_);
      observe();
      if (stepper_->done()) break;
      stepper_->step();
      keep_probes();
      // A checkpoint holds a state that is not observed yet: the loop, or a resumed one, does that
      // next.
      summary_.interrupted = options_.stop_requested != nullptr && *options_.stop_requested;
      if (summary_.interrupted || checkpoint_due()) save_checkpoint();
      if (!summary_.interrupted) continue;
      stepper_->evaluate();
      break;
    }
    if (exact_.displacement && !summary_.interrupted) measure_errors();
  } catch (const NumericalError& error) {
    summary_.failure = error.what();
    if (const auto& lost = stepper_->hyperbolicity_lost())
      summary_.failure += "; before that, " + lost->text();
    keep_last_good_state();
    failure.emplace(summary_.failure, error.time(), error.particle());
  }
  summary_.wall_output = output_seconds_ + stepper_->observing_seconds();
  summary_.wall_stepping = watch.seconds() - (summary_.wall_output - output_before);
  finish();
  const auto done = static_cast<double>(state().step - first_step);
  if (done > 0)
    summary_.ns_per_particle_step =
        summary_.wall_stepping * 1e9 / done / static_cast<double>(body_.nodes());
  if (failure) throw std::move(*failure);
}

template <int D>
void RunLoop<D>::measure_errors() {
  const Stopwatch watch;
  const RelativeErrors errors = errors_against<D>(exact_, stepper_->instant());
  summary_.errors = FieldErrors{errors.displacement, errors.velocity, errors.stress};
  output_seconds_ += watch.seconds();
}

template <int D>
bool RunLoop<D>::probes_due() const {
  return (output_ || options_.histories != nullptr) && !probes_.columns().empty() &&
         (state().step % scene_.output.probe_every == 0 || stepper_->done());
}

/// Of the next frame [s].
template <int D>
double RunLoop<D>::frame_time() const {
  return static_cast<double>(next_frame_) * scene_.time.end /
         static_cast<double>(std::max(1, scene_.output.frames));
}

template <int D>
bool RunLoop<D>::frame_due() const {
  if (!output_ || next_frame_ > scene_.output.frames || stepper_->balance().growing()) return false;
  return stepper_->done() || state().time >= frame_time() - 0.5 * stepper_->dt();
}

template <int D>
void RunLoop<D>::observe() {
  // A longer step may just have come near a frame.
  const bool frame = stepper_->evaluated() && frame_due();
  const bool sampled = stepper_->sample_balance(frame);
  const Stopwatch watch;
  if (sampled && output_) write_series();
  report_progress();
  if (probes_due()) sample_probes();
  if (frame && !stepper_->balance().growing()) {
    output_->write_frame(stepper_->instant());
    while (next_frame_ <= scene_.output.frames &&
           state().time >= frame_time() - 0.5 * stepper_->dt())
      ++next_frame_;
  }
  output_seconds_ += watch.seconds();
}

/// A row of the probes. Of a state that may turn out to be lost, as long as it is not evaluated
/// everywhere, it is kept only when a step has gone on from it.
template <int D>
void RunLoop<D>::sample_probes() {
  probe_row_[0] = exact_row_[0] = state().time;
  probes_.sample(stepper_->instant(), std::span(probe_row_).subspan(1));
  row_waits_ = true;
  if (stepper_->evaluated()) keep_probes();
}

template <int D>
void RunLoop<D>::keep_probes() {
  if (!row_waits_) return;
  row_waits_ = false;
  const std::span<const double> row(probe_row_), exact_row(exact_row_);
  if (!recorded_.exact.names.empty())
    probes_.sample_exact(exact_, row[0], std::span(exact_row_).subspan(1));
  if (output_) output_->write_probes(row, exact_row);
  if (options_.histories == nullptr) return;
  options_.histories->computed.add(row[0], row.subspan(1));
  if (!recorded_.exact.names.empty()) options_.histories->exact.add(row[0], exact_row.subspan(1));
}

template <int D>
void RunLoop<D>::write_series() {
  const Balance<D>& now = stepper_->balance().last();
  const WorkAndImpulse<D>& work = stepper_->work();
  std::array<double, 6 + D> row{now.kinetic, now.elastic, work.external_work + now.gravity,
                                work.dissipated + now.dissipated};
  for (std::size_t i = 0; i < D; ++i) row[4 + i] = now.linear_momentum[static_cast<Index>(i)];
  row[4 + D] = now.angular_momentum;
  row[5 + D] = stepper_->dt();
  output_->write_series(state().time, row);
}

template <int D>
void RunLoop<D>::report_progress() {
  if (!options_.progress || state().step % 16 != 0) return;
  const double now = Stopwatch::now();
  if (now - last_progress_ < 0.1 && !stepper_->done()) return;
  last_progress_ = now;
  options_.progress({state().time, scene_.time.end, state().step, stepper_->steps()});
}

/// Frames of the lost state itself do not exist, for `evaluate` throws first.
template <int D>
void RunLoop<D>::keep_last_good_state() {
  if (!output_) return;
  try {
    if (stepper_->restore_last_good() && !output_->has_frame(state().time, 0.5 * state().last_dt))
      output_->write_frame(stepper_->instant());
  } catch (const NumericalError&) {
    // Lost for more than a step without notice; the frames before stand.
  }
}

template <int D>
void RunLoop<D>::finish() {
  const Balance<D> now = balance<D>(stepper_->instant());
  if (output_) {
    const Stopwatch watch;
    output_->flush();
    summary_.wall_output += watch.seconds();
  }
  const WorkAndImpulse<D>& work = stepper_->work();
  const BalanceMonitor<D>& monitor = stepper_->balance();
  summary_.hyperbolicity_lost = stepper_->hyperbolicity_lost();
  summary_.steps = state().step;
  summary_.end_time = state().time;
  summary_.energy = {now.kinetic, now.elastic, work.external_work + now.gravity,
                     work.dissipated + now.dissipated, monitor.energy_drift()};
  summary_.linear_momentum_drift = monitor.linear_momentum_drift();
  summary_.angular_momentum_drift = monitor.angular_momentum_drift();
}

template class RunLoop<1>;
template class RunLoop<2>;

}  // namespace tlsph
