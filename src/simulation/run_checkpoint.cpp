#include <fmt/format.h>

#include <bit>

#include "run_loop.hpp"
#include "stopwatch.hpp"
#include "tlsph/io/check_sum.hpp"

namespace tlsph {
namespace {

/// Doubles of a run that are no fields, in the order in which a checkpoint holds them.
template <int D>
constexpr std::size_t numbers = 19 + 2 * D;

std::span<const double> flat(const auto& matrix) {
  return {matrix.data(), static_cast<std::size_t>(matrix.size())};
}

/// What a state belongs to: nodes, volumes and the patches that carry the conditions.
template <int D>
std::int64_t check_sum(const Particles<D>& particles) {
  CheckSum sum;
  const auto add = [&sum](std::span<const double> values) {
    sum.add(values.data(), values.size_bytes());
  };
  add(flat(particles.X));
  add(flat(particles.V));
  for (const Patch<D>& patch : particles.patches) {
    sum.add(patch.name.data(), patch.name.size());
    sum.add(patch.nodes.data(), patch.nodes.size() * sizeof(int));
  }
  return std::bit_cast<std::int64_t>(sum.value());
}

/// InputError unless the checkpoint is one of this scene on these particles: the points of a cloud
/// stand in a file of their own, which the text of the scene knows by name only.
template <int D>
void require_own(const Checkpoint& checkpoint, const Scene& scene, const Particles<D>& particles) {
  const Place here{checkpoint.path.string(), 0, 0, {}};
  if (checkpoint.text("scene") != scene.text)
    throw InputError(
        here,
        "belongs to another scene or other overrides; resume with the same, or run anew "
        "without --resume");
  if (checkpoint.integer("particles") == check_sum(particles)) return;
  if (scene.body.cloud.empty())
    throw InputError(here,
                     "belongs to other particles, those of another version of the program; run "
                     "anew without --resume");
  throw InputError(scene.body.cloud_place,
                   fmt::format("the points of {} are no longer those that {} belongs to; bring "
                               "them back, or run anew without --resume",
                               scene.body.cloud, here.file));
}

}  // namespace

template <int D>
bool RunLoop<D>::checkpoint_due() const {
  if (!output_ || state_.step == 0 || growing_ > 0) return false;
  if (scene_.output.checkpoint_steps > 0) return state_.step % scene_.output.checkpoint_steps == 0;
  return state_.step % 16 == 0 && Stopwatch::now() - last_checkpoint_ > scene_.output.checkpoint;
}

template <int D>
void RunLoop<D>::save_checkpoint() {
  if (!output_) return;
  const Stopwatch watch;
  last_checkpoint_ = Stopwatch::now();
  output_->flush();
  const OutputCounts counts = output_->counts();
  CheckpointView view;
  view.arrays["u"] = flat(state_.u);
  view.arrays["v"] = flat(state_.v);
  std::vector<double> values = {state_.time,
                                state_.last_dt,
                                clock_.start,
                                clock_.end,
                                clock_.dt,
                                critical_.dt,
                                critical_.scaled,
                                ledger_.external_work,
                                ledger_.dissipated,
                                ledger_.angular_impulse,
                                first_energy_,
                                largest_energy_,
                                drift_,
                                first_angular_,
                                momentum_scale_,
                                angular_scale_,
                                energy_scale_,
                                speed_,
                                known_speed_};
  for (int i = 0; i < D; ++i) values.push_back(ledger_.impulse[i]);
  for (int i = 0; i < D; ++i) values.push_back(first_momentum_[i]);
  values.push_back(momentum_drift_);
  values.push_back(angular_drift_);
  view.arrays["numbers"] = values;
  std::vector<double> followed, estimated_at, checked_at;
  if (follower_) {
    followed = follower_->numbers();
    estimated_at.assign(follower_->estimated_at().begin(), follower_->estimated_at().end());
    checked_at.assign(follower_->checked_at().begin(), follower_->checked_at().end());
    view.arrays["follower"] = followed;
    view.arrays["estimated_at"] = estimated_at;
    view.arrays["checked_at"] = checked_at;
  }
  std::vector<double> lost;
  if (hyperbolicity_lost_) {
    lost = {hyperbolicity_lost_->time, hyperbolicity_lost_->acoustic_eigenvalue};
    lost.insert(lost.end(), hyperbolicity_lost_->position.begin(),
                hyperbolicity_lost_->position.end());
    lost.insert(lost.end(), hyperbolicity_lost_->stretches.begin(),
                hyperbolicity_lost_->stretches.end());
    view.arrays["hyperbolicity_lost"] = lost;
  }
  view.integers = {{"step", state_.step},
                   {"clock_first", clock_.first},
                   {"clock_count", clock_.count},
                   {"books_every", books_every_},
                   {"next_frame", next_frame_},
                   {"hyperbolicity_lost_at", hyperbolicity_lost_ ? hyperbolicity_lost_->point : -1},
                   {"frames", static_cast<std::int64_t>(counts.run.frames)},
                   {"series", static_cast<std::int64_t>(counts.run.series)},
                   {"run_sum", std::bit_cast<std::int64_t>(counts.run.check_sum)},
                   {"probes", static_cast<std::int64_t>(counts.probes.count)},
                   {"probes_sum", std::bit_cast<std::int64_t>(counts.probes.sum.value())},
                   {"exact_sum", std::bit_cast<std::int64_t>(counts.exact.sum.value())},
                   {"particles", check_sum(disc_.particles)},
                   {"threads", threads_}};
  view.texts = {{"scene", scene_.text}};
  write_checkpoint(options_.out / "checkpoint.h5", view);
  output_seconds_ += watch.seconds();
}

template <int D>
void RunLoop<D>::resume_from(const Checkpoint& checkpoint) {
  require_own(checkpoint, scene_, disc_.particles);
  const auto fill = [&](const char* name, auto& field) {
    const auto& values = checkpoint.array(name, static_cast<std::size_t>(field.size()));
    std::copy(values.begin(), values.end(), field.data());
  };
  fill("u", state_.u);
  fill("v", state_.v);
  const std::vector<double>& n = checkpoint.array("numbers", numbers<D> + 2);
  std::size_t k = 0;
  for (double* slot :
       {&state_.time, &state_.last_dt, &clock_.start, &clock_.end, &clock_.dt, &critical_.dt,
        &critical_.scaled, &ledger_.external_work, &ledger_.dissipated, &ledger_.angular_impulse,
        &first_energy_, &largest_energy_, &drift_, &first_angular_, &momentum_scale_,
        &angular_scale_, &energy_scale_, &speed_, &known_speed_})
    *slot = n[k++];
  for (int i = 0; i < D; ++i) ledger_.impulse[i] = n[k++];
  for (int i = 0; i < D; ++i) first_momentum_[i] = n[k++];
  momentum_drift_ = n[k++];
  angular_drift_ = n[k++];
  if (follower_) {
    const auto size = static_cast<std::size_t>(state_.H.size());
    follower_->restore(checkpoint.array("follower", StepFollower<D>::number_count),
                       checkpoint.array("estimated_at", size),
                       checkpoint.array("checked_at", size));
  }
  state_.step = checkpoint.integer("step");
  clock_.first = checkpoint.integer("clock_first");
  clock_.count = checkpoint.integer("clock_count");
  books_every_ = checkpoint.integer("books_every");
  next_frame_ = checkpoint.integer("next_frame");
  if (const Index point = checkpoint.integer("hyperbolicity_lost_at"); point >= 0) {
    const std::vector<double>& lost = checkpoint.array("hyperbolicity_lost", 2 + 2 * D);
    hyperbolicity_lost_ = {
        lost[0], point, {&lost[2], &lost[2] + D}, {&lost[2] + D, &lost[2] + 2 * D}, lost[1]};
  }
  const auto count = [&](const char* name) {
    return static_cast<std::size_t>(checkpoint.integer(name));
  };
  const auto sum = [&](const char* name) {
    return std::bit_cast<std::uint64_t>(checkpoint.integer(name));
  };
  const OutputCounts counts{{count("frames"), count("series"), sum("run_sum")},
                            {count("probes"), CheckSum(sum("probes_sum"))},
                            {count("probes"), CheckSum(sum("exact_sum"))}};
  output_.emplace(options_.out, scene_, disc_, probes_, exact_, counts);
  last_checkpoint_ = Stopwatch::now();
}

template void RunLoop<1>::save_checkpoint();
template void RunLoop<2>::save_checkpoint();
template void RunLoop<1>::resume_from(const Checkpoint&);
template void RunLoop<2>::resume_from(const Checkpoint&);
template bool RunLoop<1>::checkpoint_due() const;
template bool RunLoop<2>::checkpoint_due() const;

}  // namespace tlsph
