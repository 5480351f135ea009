#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>

#include "flat.hpp"
#include "run_loop.hpp"
#include "stopwatch.hpp"
#include "tlsph/io/check_sum.hpp"

namespace tlsph {
namespace {

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

/// The values of a run by name, as `visit` hands them out.
class SavedValues {
 public:
  void operator()(const std::string& name, double value) { arrays_[name] = {value}; }
  void operator()(const std::string& name, long value) { integers_[name] = value; }
  void operator()(const std::string& name, bool value) { integers_[name] = value ? 1 : 0; }
  void operator()(const std::string& name, const std::optional<double>& value) {
    arrays_[name].assign(value ? 1 : 0, value.value_or(0.0));
  }
  void operator()(const std::string& name, const std::vector<float>& values) {
    arrays_[name].assign(values.begin(), values.end());
  }
  void operator()(const std::string& name, const std::optional<HyperbolicityLoss>& loss) {
    std::vector<double>& values = arrays_[name];
    if (!loss) return;
    values = {loss->time, static_cast<double>(loss->point), loss->acoustic_eigenvalue};
    values.insert(values.end(), loss->position.begin(), loss->position.end());
    values.insert(values.end(), loss->stretches.begin(), loss->stretches.end());
  }
  template <class Derived>
  void operator()(const std::string& name, const Eigen::PlainObjectBase<Derived>& field) {
    fields_[name] = flat(field);
  }

  [[nodiscard]] CheckpointView view() const {
    CheckpointView view{fields_, integers_, {}};
    for (const auto& [name, values] : arrays_) view.arrays[name] = values;
    return view;
  }

 private:
  std::map<std::string, std::span<const double>> fields_;  ///< of the state itself
  std::map<std::string, std::vector<double>> arrays_;
  std::map<std::string, std::int64_t> integers_;
};

/// Takes them back.
struct RestoredValues {
  const Checkpoint& checkpoint;

  void operator()(const std::string& name, double& value) const { value = checkpoint.number(name); }
  void operator()(const std::string& name, long& value) const { value = checkpoint.integer(name); }
  void operator()(const std::string& name, bool& value) const {
    value = checkpoint.integer(name) != 0;
  }
  void operator()(const std::string& name, std::optional<double>& value) const {
    value.reset();
    if (const auto& values = checkpoint.array(name); !values.empty()) value = values.front();
  }
  void operator()(const std::string& name, std::optional<HyperbolicityLoss>& loss) const {
    loss.reset();
    const std::vector<double>& values = checkpoint.array(name);
    if (values.empty()) return;
    if (values.size() < 5 || values.size() % 2 == 0)
      throw InputError(Place{checkpoint.path.string(), 0, 0, ""},
                       "\"" + name + "\" is damaged; start without --resume");
    const auto position = values.begin() + 3;
    const auto stretches = position + (values.end() - position) / 2;
    loss = {values[0],
            static_cast<Index>(values[1]),
            {position, stretches},
            {stretches, values.end()},
            values[2]};
  }
  void operator()(const std::string& name, std::vector<float>& values) const {
    std::ranges::transform(checkpoint.array(name, values.size()), values.begin(),
                           [](double value) { return static_cast<float>(value); });
  }
  template <class Derived>
  void operator()(const std::string& name, Eigen::PlainObjectBase<Derived>& field) const {
    std::ranges::copy(checkpoint.array(name, static_cast<std::size_t>(field.size())), field.data());
  }
};

}  // namespace

template <int D>
bool RunLoop<D>::checkpoint_due() const {
  if (!output_ || state_.step == 0 || growing_ > 0) return false;
  if (scene_.output.checkpoint_steps > 0) return state_.step % scene_.output.checkpoint_steps == 0;
  return state_.step % 16 == 0 && Stopwatch::now() - last_checkpoint_ > scene_.output.checkpoint;
}

template <int D>
template <class Visit>
void RunLoop<D>::visit(const Visit& visit) {
  visit("u", state_.u);
  visit("v", state_.v);
  if (state_.past.size() > 0) visit("past", state_.past);
  visit("step", state_.step);
  visit("time", state_.time);
  visit("last_dt", state_.last_dt);
  visit("clock.start", clock_.start);
  visit("clock.first", clock_.first);
  visit("clock.count", clock_.count);
  visit("clock.end", clock_.end);
  visit("clock.dt", clock_.dt);
  visit("critical.dt", critical_.dt);
  visit("critical.scaled", critical_.scaled);
  visit("ledger.external_work", ledger_.external_work);
  visit("ledger.dissipated", ledger_.dissipated);
  visit("ledger.impulse", ledger_.impulse);
  visit("ledger.angular_impulse", ledger_.angular_impulse);
  visit("first_energy", first_energy_);
  visit("largest_energy", largest_energy_);
  visit("drift", drift_);
  visit("first_momentum", first_momentum_);
  visit("first_angular", first_angular_);
  visit("momentum_scale", momentum_scale_);
  visit("angular_scale", angular_scale_);
  visit("momentum_drift", momentum_drift_);
  visit("angular_drift", angular_drift_);
  visit("energy_scale", energy_scale_);
  visit("speed", speed_);
  visit("known_speed", known_speed_);
  visit("hyperbolicity_lost", hyperbolicity_lost_);
  visit("books_every", books_every_);
  visit("next_frame", next_frame_);
  if (follower_)
    follower_->visit(
        [&](const std::string& name, auto& value) { visit("follower." + name, value); });
}

template <int D>
void RunLoop<D>::save_checkpoint() {
  if (!output_) return;
  const Stopwatch watch;
  last_checkpoint_ = Stopwatch::now();
  output_->flush();
  const OutputCounts counts = output_->counts();
  SavedValues saved;
  visit([&](const std::string& name, const auto& value) { saved(name, value); });
  CheckpointView view = saved.view();
  view.integers.insert({{"frames", static_cast<std::int64_t>(counts.run.frames)},
                        {"series", static_cast<std::int64_t>(counts.run.series)},
                        {"run_sum", std::bit_cast<std::int64_t>(counts.run.check_sum)},
                        {"probes", static_cast<std::int64_t>(counts.probes.count)},
                        {"probes_sum", std::bit_cast<std::int64_t>(counts.probes.sum.value())},
                        {"exact_sum", std::bit_cast<std::int64_t>(counts.exact.sum.value())},
                        {"particles", check_sum(disc_.particles)},
                        {"threads", threads_}});
  view.texts = {{"scene", scene_.text}};
  write_checkpoint(options_.out / "checkpoint.h5", view);
  output_seconds_ += watch.seconds();
}

template <int D>
void RunLoop<D>::resume_from(const Checkpoint& checkpoint) {
  require_own(checkpoint, scene_, disc_.particles);
  visit(RestoredValues{checkpoint});
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
