#include "tlsph/stability/atlas.hpp"

#include <fmt/format.h>

#include <regex>

#include "contrast.hpp"
#include "crush.hpp"
#include "evidence.hpp"
#include "failure.hpp"
#include "judge.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/core/thread_count.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/simulation/version.hpp"
#include "waves.hpp"

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

/// One of the pieces the atlas is drawn of.
struct Piece {
  std::string name;
  double weight = 1.0;  ///< of the progress
  std::function<void(Atlas&)> draw;
};

std::vector<Piece> pieces_of(const Subject& subject, FirstVibration& first) {
  std::vector<Piece> pieces;
  for (const StateKey& key : atlas_states(subject.dimension, subject.poisson))
    pieces.push_back({key.name(), 1.0, [&subject, &first, key](Atlas& atlas) {
                        atlas.rows.push_back(judge(subject, key, first));
                      }});
  for (const Method& method : atlas_methods(subject.dimension))
    pieces.push_back({"waves of " + method.name, 1.0, [&subject, method](Atlas& atlas) {
                        try {
                          atlas.waves.push_back(in_dimension(subject.dimension, [&]<int D>() {
                            return wave_row<D>(subject, method, subject.poisson);
                          }));
                        } catch (const InputError&) {
                          // The rows of the method say why it cannot be built.
                        }
                      }});
  pieces.push_back({"updated Lagrangian", 10.0,
                    [&subject](Atlas& atlas) { atlas.contrast = contrast_rows(subject); }});
  if (!subject.box) return pieces;
  for (const Method& method : crushed_methods(subject.dimension))
    for (const auto& [motion, speed] : {std::pair{Motion::pressed, 0.02},
                                        {Motion::pressed, 0.4},
                                        {Motion::struck, 0.02},
                                        {Motion::struck, 0.1}})
      for (const Follow follow : {Follow::never, Follow::follower})
        pieces.push_back({fmt::format("crush of {} at {} c", method.name, speed), 5.0,
                          [&subject, method, motion = motion, speed = speed, follow](Atlas& atlas) {
                            atlas.crush.push_back(
                                crush_row(subject, method, motion, speed, 0.95, follow));
                          }});
  const Method plain = crushed_methods(subject.dimension).front();
  const int finer = subject.dimension == 1 ? 16 : 4;
  pieces.push_back(
      {"crush of a fine body, " + plain.name, 30.0, [&subject, plain, finer](Atlas& atlas) {
         atlas.crush.push_back(
             crush_row(subject, plain, Motion::pressed, 0.02, 0.95, Follow::follower, finer));
       }});
  return pieces;
}

}  // namespace

Safety Atlas::safety() const {
  Safety safety;
  for (const AtlasRow& row : rows) {
    if (!(row.bound > 0.0) || row.verdict == Verdict::material) continue;
    safety.smallest_share = std::min(safety.smallest_share, row.bound / row.limit);
    safety.largest_share = std::max(safety.largest_share, row.bound / row.limit);
    if (row.verdict != Verdict::stable && row.verdict != Verdict::soft) continue;
    ++safety.stable_states;
    const PerturbedRun* run = run_of(row, "0.95");
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
  std::vector<Piece> pieces = pieces_of(subject, first);
  std::erase_if(pieces, [&](const Piece& piece) { return !std::regex_search(piece.name, only); });
  if (pieces.empty())
    throw InputError(
        fmt::format("--only: \"{}\" matches no row of the atlas; names look like "
                    "\"{}\"",
                    request.only, "variational 2.5 + S, jitter 0.2, nu 0.3, stretch 0.5"));
  if (!options.out.empty()) make_output_directory(options.out);
  double total = 0.0;
  for (const Piece& piece : pieces) total += piece.weight;
  double done = 0.0;
  for (const Piece& piece : pieces) {
    if (options.stop_requested != nullptr && *options.stop_requested) {
      atlas.interrupted = true;
      break;
    }
    if (options.progress) options.progress(done / total, piece.name);
    try {
      piece.draw(atlas);
    } catch (const Stopped&) {
      atlas.interrupted = true;
      break;
    }
    done += piece.weight;
  }
  atlas.failures = failures_of(atlas);
  atlas.seconds = watch.seconds();
  return atlas;
}

}  // namespace tlsph
