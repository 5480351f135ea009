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

std::string first_line(const fs::path& file) {
  std::ifstream text(file);
  std::string line;
  std::getline(text, line);
  return line;
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

}  // namespace

void check_peers(const std::vector<std::string>& names, const std::vector<std::string>& overrides) {
  if (names.empty()) return;
  const std::vector<std::string> known = peer_names();
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      throw InputError(
          {"--peer", 0, 0, ""},
          fmt::format("there is no \"{}\"; choose from {}", name,
                      known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
  for (const std::string& text : overrides) {
    const std::string key = text.substr(0, text.find('='));
    if (key != "time.end" && key != "time.safety" && !key.starts_with("output."))
      throw InputError(
          {"--peer", 0, 0, ""},
          fmt::format("peers know the scene as the examples have it, not with --set {}; "
                      "allowed: time.end, time.safety, output",
                      text));
  }
}

PeerRun run_peer(const PeerVariant& variant, const Scene& scene, double spacing,
                 const ChartTable& table, const fs::path& folder, double seconds,
                 const std::atomic<bool>* stop_requested) {
  make_output_directory(folder);
  std::string stem = fmt::format("{}-{:.4g}", variant.label, spacing);
  std::ranges::replace(stem, ' ', '-');
  ProcessOptions options;
  options.out = folder / (stem + ".json");
  options.err = folder / (stem + ".err");
  options.seconds = seconds;
  options.stop_requested = stop_requested;
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
    const std::string reason = first_line(options.err);
    return {{}, reason.empty() ? fmt::format("{}: exit code {}", name, *status) : reason};
  }
  return {read_point(name, Json::read(options.out), table), ""};
}

}  // namespace tlsph
