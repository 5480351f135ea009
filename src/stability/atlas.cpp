#include "tlsph/stability/atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "studies.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/core/thread_count.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

std::regex pattern_of(const std::string& only) {
  try {
    return std::regex(only);
  } catch (const std::regex_error&) {
    throw InputError(fmt::format("--only: \"{}\" is no regular expression", only));
  }
}

/// One thread as long as it lives: bodies are small, and times are to mean something.
class OneThread {
 public:
  OneThread() { set_blas_threads(1); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
  ~OneThread() { set_blas_threads(count_.before()); }

 private:
  ThreadCount count_{1};
};

/// A study whose rows the atlas takes.
struct Study {
  std::string name;
  double weight = 1.0;  ///< of the progress
  std::function<void(Atlas&)> run;
};

std::vector<Study> studies_of(const Subject& subject, FirstVibration& first) {
  std::vector<Study> studies;
  for (const StateKey& key : atlas_states(subject.dimension, subject.poisson))
    studies.push_back({key.name(), 1.0, [&subject, &first, key](Atlas& atlas) {
                         atlas.rows.push_back(state_row(subject, key, first));
                       }});
  for (const Method& method : atlas_methods(subject.dimension))
    studies.push_back({"waves of " + method.name, 1.0, [&subject, method](Atlas& atlas) {
                         try {
                           atlas.waves.push_back(wave_row(subject, method));
                         } catch (const InputError&) {
                           // The rows of the method say why it cannot be built.
                         }
                       }});
  studies.push_back({"updated Lagrangian", 10.0,
                     [&subject](Atlas& atlas) { atlas.contrast = contrast_rows(subject); }});
  if (!subject.box) return studies;
  for (const Compression& study : compressions(subject.dimension))
    studies.push_back({study.name(), study.finer > 1 ? 30.0 : 5.0, [&subject, study](Atlas& atlas) {
                         atlas.compression.push_back(compression_row(subject, study));
                       }});
  return studies;
}

}  // namespace

const PerturbedRun* AtlasRow::run(std::string_view label) const {
  const auto found = std::ranges::find(runs, label, &PerturbedRun::label);
  return found == runs.end() ? nullptr : &*found;
}

Safety Atlas::safety() const {
  Safety safety;
  for (const AtlasRow& row : rows) {
    if (!(row.bound > 0.0) || row.verdict == Verdict::material) continue;
    safety.smallest_share = std::min(safety.smallest_share, row.bound / row.limit);
    safety.largest_share = std::max(safety.largest_share, row.bound / row.limit);
    if (row.verdict != Verdict::stable && row.verdict != Verdict::zero_energy) continue;
    ++safety.stable_states;
    const PerturbedRun* run = row.run("0.95");
    if (run == nullptr || !run->bounded() ||
        !(run->energy_drift < 0.1 || std::isnan(run->energy_drift)))
      ++safety.lost_runs;
  }
  return safety;
}

Atlas draw_atlas(const AtlasRequest& request, const AtlasOptions& options) {
  const Stopwatch watch;
  const OneThread one;
  const std::regex only = pattern_of(request.only);
  const Subject subject = read_subject(request.scene, request.overrides);
  Atlas atlas;
  atlas.scene = request.scene.string();
  atlas.version = version();
  atlas.dimension = subject.dimension;
  FirstVibration first(subject);
  std::vector<Study> studies = studies_of(subject, first);
  std::erase_if(studies, [&](const Study& study) { return !std::regex_search(study.name, only); });
  if (studies.empty())
    throw InputError(
        fmt::format("--only: \"{}\" matches no row of the atlas; names look like "
                    "\"{}\"",
                    request.only, "variational 2.5 + S, jitter 0.2, nu 0.3, stretch 0.5"));
  if (!options.out.empty()) make_output_directory(options.out);
  double total = 0.0;
  for (const Study& study : studies) total += study.weight;
  double done = 0.0;
  for (const Study& study : studies) {
    if (options.stop_requested != nullptr && *options.stop_requested) {
      atlas.interrupted = true;
      break;
    }
    if (options.progress) options.progress(done / total, study.name);
    try {
      study.run(atlas);
    } catch (const Stopped&) {
      atlas.interrupted = true;
      break;
    }
    done += study.weight;
  }
  atlas.failures = failures_of(atlas);
  atlas.seconds = watch.seconds();
  return atlas;
}

}  // namespace tlsph
