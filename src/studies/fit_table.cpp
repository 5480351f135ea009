// A fit on the screen and in its files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/io/record.hpp"
#include "tlsph/studies/fit.hpp"

namespace tlsph {
namespace {

/// The scene without what a reader of a terminal does not look for: blank first lines.
std::string indented(const std::string& text) {
  std::string result;
  std::string line;
  for (const char c : text + (text.ends_with('\n') ? "" : "\n")) {
    if (c != '\n') {
      line += c;
      continue;
    }
    result.append(line.empty() ? "" : "    ").append(line).append("\n");
    line.clear();
  }
  return result;
}

Record pilot_record(const Pilot& pilot) {
  Record record;
  record.set("spacing", pilot.spacing);
  record.set("particles", pilot.particles);
  record.set("steps", pilot.steps);
  record.set("setup_seconds", pilot.setup);
  record.set("stepping_seconds", pilot.stepping);
  record.set("charged_seconds", pilot.charged);
  record.set("error", pilot.error);
  return record;
}

/// A line a pilot.
void write_pilots(const std::vector<FitFamily>& families, const std::filesystem::path& path) {
  const auto line = [](const std::string& family, const Pilot& pilot) {
    Record record;
    record.set("family", family);
    record.append(pilot_record(pilot));
    return record;
  };
  std::string csv = csv_line(line("", {}).names());
  for (const FitFamily& each : families)
    for (const Pilot& pilot : each.pilots) csv += csv_line(line(each.label, pilot).cells());
  write_text_file(path, csv);
}

Json family_json(const FitFamily& family) {
  Json json;
  json.set("family", family.label);
  json.set("set", family.overrides);
  json.set("note", family.note);
  json.set("reaches", family.reaches);
  json.make_list("pilots");
  for (const Pilot& pilot : family.pilots) json.append("pilots", pilot_record(pilot).json());
  if (!family.reaches) return json;
  json.set("order", family.order);
  json.set("spacing", family.spacing);
  json.set("predicted_error", family.predicted_error);
  json.set("predicted_seconds", family.predicted_seconds);
  return json;
}

}  // namespace

std::string FitTable::choice_text() const {
  std::string lines = fmt::format("{}, wanted to {:.3g}", quantity, wanted);
  if (std::isfinite(answer)) lines += fmt::format(" of {:.6g}", answer);
  lines += "\n";
  for (const std::string& what : reductions) lines += what + "\n";
  if (linear) lines += "linear elastic: the law of the scene comes out the same\n";
  lines += fmt::format("\n{:>12} {:>12} {:>7} {:>8}  {}\n", "time [s]", "spacing [m]", "order",
                       "pilots", "reaches it");
  std::vector<const FitFamily*> reaching;
  for (const FitFamily& each : families)
    if (each.reaches) reaching.push_back(&each);
  std::ranges::sort(reaching, {}, &FitFamily::predicted_seconds);
  for (const FitFamily* each : reaching)
    lines += fmt::format("{:>12.3g} {:>12.5g} {:>7.2f} {:>8}  {}\n", each->predicted_seconds,
                         each->spacing, each->order, each->pilots.size(), each->label);
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
  write_pilots(families, directory / "fit.csv");
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
  json.make_list("families");
  for (const FitFamily& each : families) json.append("families", family_json(each));
  json.write(directory / "fit.json");
}

}  // namespace tlsph
