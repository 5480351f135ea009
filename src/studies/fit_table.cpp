// A fit on the screen and in its files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <sstream>

#include "tlsph/io/files.hpp"
#include "tlsph/io/table.hpp"
#include "tlsph/studies/fit.hpp"

namespace tlsph {
namespace {

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result.append(line.empty() ? "" : "    ").append(line).append("\n");
  return result;
}

Table<Pilot> pilot_table() {
  return {
      {"spacing", &Pilot::spacing},
      {"particles", &Pilot::particles},
      {"steps", &Pilot::steps},
      {"setup_seconds", &Pilot::setup},
      {"stepping_seconds", &Pilot::stepping},
      {"charged_seconds", &Pilot::charged},
      {"error", &Pilot::error},
  };
}

/// A line a pilot.
std::string pilots_csv(const std::vector<FitFamily>& families) {
  struct Line {
    std::string family;
    Pilot pilot;
  };
  std::vector<Line> lines;
  for (const FitFamily& each : families)
    for (const Pilot& pilot : each.pilots) lines.push_back({each.label, pilot});
  return (Table<Line>{{"family", &Line::family}} + pilot_table().of(&Line::pilot)).csv(lines);
}

/// A prediction, of a family that reaches the wanted error.
auto predicted(double FitFamily::*value) {
  return [value](const FitFamily& family) {
    return family.reaches ? std::optional(family.*value) : std::nullopt;
  };
}

Table<FitFamily> family_table() {
  using Row = FitFamily;
  return {
      {"family", &Row::label},
      {"set", &Row::overrides},
      {"note", &Row::note},
      {"reaches", &Row::reaches},
      {"predicted_seconds", predicted(&Row::predicted_seconds), {"time [s]", ">12.3g"}},
      {"predicted_error", predicted(&Row::predicted_error)},
      {"spacing", predicted(&Row::spacing), {"spacing [m]", " >12.5g"}},
      {"order", predicted(&Row::order), {"order", " >7.2f"}},
      {"", [](const Row& row) { return row.pilots.size(); }, {"pilots", " >8"}},
      {"pilots", [](const Row& row) { return pilot_table().json(row.pilots); }},
      {"", &Row::label, {"reaches it", "  <"}},
  };
}

}  // namespace

std::string FitTable::choice_text() const {
  std::string lines = fmt::format("{}, wanted to {:.3g}", quantity, wanted);
  if (std::isfinite(answer)) lines += fmt::format(" of {:.6g}", answer);
  lines += "\n";
  for (const std::string& what : reductions) lines += what + "\n";
  if (linear) lines += "linear elastic: the law of the scene comes out the same\n";
  std::vector<FitFamily> reaching;
  std::ranges::copy_if(families, std::back_inserter(reaching), &FitFamily::reaches);
  std::ranges::sort(reaching, {}, &FitFamily::predicted_seconds);
  lines += '\n';
  lines += family_table().text(reaching);
  const auto noted = [&](const char* note) {
    return std::ranges::count(families, std::string(note), &FitFamily::note);
  };
  const auto dearer = noted("dearer");
  const auto refused = noted("refused");
  const auto others = std::ssize(families) - std::ssize(reaching) - dearer - refused;
  lines +=
      fmt::format("{} other ways are dearer, {} do not go with the scene, {} came to nothing\n",
                  dearer, refused, others);
  if (!reached) lines += "no way is known to reach it; what came nearest:\n";
  return lines + fmt::format("\n{}\npredicted: error {:.3g} in {:.3g} s\n", indented(text),
                             predicted_error, predicted_seconds);
}

std::string FitTable::verdict_text() const {
  if (interrupted) return "interrupted: what was done\n";
  std::string verdict;
  if (corrected)
    verdict += fmt::format(
        "measured: error {:.3g}, so the spacing is corrected to {:.5g} m; predicted: error {:.3g} "
        "in "
        "{:.3g} s\n",
        first_error, spacing, predicted_error, predicted_seconds);
  verdict += fmt::format("measured: error {:.3g} in {:.3g} s, {} particles, {} steps: {} {:.3g}\n",
                         measured_error, measured_seconds, particles, steps,
                         meets() ? "meets" : "misses", wanted);
  if (coarsest && measured_error < 0.2 * wanted) verdict += "there is no coarser spacing\n";
  return verdict;
}

void FitTable::write(const std::filesystem::path& directory) const {
  write_text_file(directory / "fit.csv", pilots_csv(families));
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("quantity", quantity);
  json.set("wanted", wanted);
  json.set("answer", answer);
  json.set("reductions", reductions);
  json.set("family", family);
  json.set("reached", reached);
  json.set("linear", linear);
  json.set("spacing", spacing);
  json.set("predicted_error", predicted_error);
  json.set("predicted_seconds", predicted_seconds);
  json.set("measured_error", measured_error);
  json.set("measured_seconds", measured_seconds);
  json.set("particles", particles);
  json.set("steps", steps);
  json.set("coarsest", coarsest);
  json.set("corrected", corrected);
  json.set("meets", !interrupted && meets());
  json.set("interrupted", interrupted);
  json.set("spent", spent);
  json.set("families", family_table().json(families));
  json.write(directory / "fit.json");
}

}  // namespace tlsph
