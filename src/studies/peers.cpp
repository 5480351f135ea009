#include "peers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "process.hpp"
#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/studies/chart_search.hpp"
#include "tlsph/studies/figure.hpp"

namespace tlsph {
namespace {

namespace fs = std::filesystem;

/// What the scripts share is no peer.
constexpr std::array<std::string_view, 2> modules = {"peer", "scenes"};

std::vector<std::string> peer_names() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(validation_folder() / "peers", ignored)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() == ".py" && std::ranges::find(modules, name) == modules.end())
      names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

/// A value is judged by the answer of the chart, a field by what the peer says.
double error_of(const Json& result, const ChartTable& table, std::size_t q) {
  // Names of values have dots, which a path would split.
  const std::string& quantity = table.quantities[q];
  for (const Json& entry : result.list("quantities"))
    if (entry.text("name") == quantity) {
      if (std::isfinite(table.answers[q]) && !entry.is_null("value"))
        return std::abs(entry.number("value") / table.answers[q] - 1.0);
      if (!std::isfinite(table.answers[q]) && !entry.is_null("error"))
        return std::abs(entry.number("error"));
    }
  return not_known;
}

ChartPoint read_point(const std::string& name, const Json& result, const ChartTable& table) {
  ChartPoint point;
  point.peer = name;
  point.family = result.text("note");
  point.spacing = result.number("spacing");
  point.particles = static_cast<Index>(result.integer("particles"));
  point.steps = static_cast<long>(result.integer("steps"));
  if (result.has("law") && !result.is_null("law")) point.law = result.text("law");
  if (result.has("step_share") && !result.is_null("step_share"))
    point.step_share = result.number("step_share");
  point.seconds = result.numbers("repetitions");
  for (std::size_t q = 0; q < table.quantities.size(); ++q)
    point.errors.push_back(error_of(result, table, q));
  return point;
}

/// A peer as it is to run.
struct PeerVariant {
  std::string script;  // its name
  std::string label;   // the same and what is not the scene's
  double share = 0.9;  // of the critical step
  std::string law;     // empty: the scene's
};

struct PeerRun {
  ChartPoint point;
  std::string unable;  // why there is no point
};

/// One run of a peer, killed after `seconds`; its streams go into files in `out`/peers.
PeerRun run_peer(const PeerVariant& variant, const ChartStudy& study, double spacing,
                 double seconds) {
  const fs::path folder = study.options.out / "peers";
  make_output_directory(folder);
  std::string stem = fmt::format("{}-{:.4g}", variant.label, spacing);
  std::ranges::replace(stem, ' ', '-');
  const ProcessOptions options{folder / (stem + ".json"), folder / (stem + ".err"), seconds,
                               study.options.stop_requested};
  const Scene& scene = study.plan.scene;
  const fs::path script = validation_folder() / "peers" / (variant.script + ".py");
  std::vector<std::string> command = {python(),        "-B",
                                      script.string(), fs::path(scene.file).stem().string(),
                                      "--spacing",     fmt::format("{:.17g}", spacing),
                                      "--end",         fmt::format("{:.17g}", scene.time.end),
                                      "--share",       fmt::format("{}", variant.share)};
  if (!variant.law.empty()) command.insert(command.end(), {"--law", variant.law});
  const std::optional<int> status = run_process(command, options);
  const std::string& name = variant.label;
  if (!status) return {{}, fmt::format("{}: took more than {:.3g} s", name, seconds)};
  if (*status != 0) {
    std::string reason;
    std::ifstream errors(options.err);
    std::getline(errors, reason);
    return {{}, reason.empty() ? fmt::format("{}: exit code {}", name, *status) : reason};
  }
  return {read_point(name, Json::read(options.out), study.table), ""};
}

constexpr std::size_t repetitions = 3;

/// Of its next run: most of a short one is its start, which does not grow until it is seen to.
double next_cost(const std::vector<Measured>& runs, double spacing, int dimension) {
  const double before = runs.size() > 1 ? runs[runs.size() - 2].setup : runs.back().setup;
  const double growth = std::clamp(runs.back().setup / before, 1.0, 10.0);
  return growth * runs.back().setup + predict(runs, spacing, dimension).stepping;
}

/// What the scene allows of law and step and the peer, by its first answer, can be given.
std::vector<PeerVariant> others(const PeerVariant& own, const ChartPoint& first,
                                const ChartVariation& variation) {
  std::vector<std::string> laws = {""};
  std::vector<double> shares = {own.share};
  const std::string linear(name_of(LawName::linear_elastic));
  if (!first.law.empty() && first.law != linear && !variation.linear.empty())
    laws.push_back(linear);
  if (first.step_share && !variation.shares.empty() && variation.own_share < largest_share)
    shares.push_back(largest_share);
  std::vector<PeerVariant> all;
  for (const std::string& law : laws)
    for (const double share : shares)
      if (!law.empty() || share != own.share)
        all.push_back({own.script,
                       own.script + variant_label(!law.empty(), share, variation.own_share), share,
                       law});
  return all;
}

/// A variant of a peer at one spacing after the other for half of its share of the time that is
/// left; then its times once more.
class Ladder {
 public:
  Ladder(ChartStudy& study, double all_until) : study_(study), all_until_(all_until) {}

  /// `sharers` of the time, this one among them. The first run of a peer may take all of it: a slow
  /// peer has one point; it also tells which variants there are, and share the time of their peer.
  std::vector<PeerVariant> run(const PeerVariant& variant, double sharers, bool own) {
    const double begin = study_.spent();
    double share = std::max(0.0, all_until_ - begin) / sharers;
    std::vector<PeerVariant> more;
    const std::size_t first = study_.table.points.size();
    std::vector<Measured> runs;
    for (const double spacing : study_.plan.ladder) {
      const double cost =
          runs.empty() ? 0.0 : next_cost(runs, spacing, study_.plan.scene.dimension);
      if (!runs.empty() && study_.spent() + cost > begin + 0.5 * share) break;
      const double before = study_.spent();
      PeerRun run = call(variant, spacing, runs.empty() && own ? all_until_ : begin + share);
      if (!run.unable.empty()) {
        if (runs.empty()) study_.table.notes.push_back(run.unable);
        break;
      }
      ChartPoint& point = run.point;
      point.setup_seconds = std::max(0.0, study_.spent() - before - point.time());
      runs.push_back({spacing, point.setup_seconds, point.time(), point.errors});
      if (runs.size() == 1 && own) {
        more = others(variant, point, study_.variation);
        share /= static_cast<double>(more.size() + 1);
      }
      study_.add(std::move(point));
    }
    repeat(variant, first, begin + share);
    return more;
  }

 private:
  void repeat(const PeerVariant& variant, std::size_t first, double until) const {
    for (std::size_t round = 1; round < repetitions; ++round)
      for (std::size_t k = first; k < study_.table.points.size(); ++k) {
        ChartPoint& point = study_.table.points[k];
        if (study_.spent() + point.setup_seconds + point.time() > until) continue;
        const PeerRun again = call(variant, point.spacing, until);
        if (again.unable.empty()) point.seconds.push_back(again.point.time());
      }
  }

  [[nodiscard]] PeerRun call(const PeerVariant& variant, double spacing, double until) const {
    study_.show(fmt::format("{} at {:.4g} m", variant.label, spacing));
    return run_peer(variant, study_, spacing, until - study_.spent());
  }

  ChartStudy& study_;
  double all_until_;
};

}  // namespace

void check_peers(const std::vector<std::string>& names, const std::vector<std::string>& overrides) {
  if (names.empty()) return;
  const Place option{"--peer", 0, 0, ""};
  const std::vector<std::string> known = peer_names();
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(
          option, fmt::format("there is no \"{}\"; choose from {}", name,
                              known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
  for (const std::string& text : overrides) {
    const std::string key = text.substr(0, text.find('='));
    if (key != "time.end" && key != "time.safety" && !key.starts_with("output."))
      throw InputError(
          option, fmt::format("peers know the scene as the examples have it, not with --set {}; "
                              "allowed: time.end, time.safety, output",
                              text));
  }
}

void run_peers(ChartStudy& study, double until) {
  const std::vector<std::string>& peers = study.request.peers;
  const double share = study.variation.own_share;
  Ladder ladder(study, until);
  for (std::size_t k = 0; k < peers.size(); ++k) {
    const auto left = static_cast<double>(peers.size() - k);
    const double begin = study.spent();
    Ladder mine(study, begin + std::max(0.0, until - begin) / left);
    const std::vector<PeerVariant> more = ladder.run({peers[k], peers[k], share, ""}, left, true);
    for (std::size_t m = 0; m < more.size(); ++m)
      (void)mine.run(more[m], static_cast<double>(more.size() - m), false);
  }
}

}  // namespace tlsph
