#include <fmt/format.h>

#include <array>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/stability/atlas.hpp"
#include "verdict_names.hpp"

namespace tlsph {
namespace {

std::string cell(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.17g}", value);
}

std::string count(Index value) {
  return value < 0 ? "" : std::to_string(value);
}

const std::vector<std::string> columns = {
    "name",      "method",    "formulation",  "kernel",    "support",  "body",
    "jitter",    "poisson",   "stretch",      "particles", "verdict",  "refusal",
    "acoustic",  "imbalance", "unrest",       "bound",     "limit",    "soft",
    "excursion", "negative",  "growth",       "run",       "dt_ratio", "expected",
    "seen",      "amplitude", "energy_drift", "steps",     "lost_at"};

std::vector<std::string> state_cells(const AtlasRow& row) {
  return {row.name,
          row.method,
          row.formulation,
          row.kernel,
          cell(row.support),
          row.body,
          cell(row.jitter),
          cell(row.poisson),
          cell(row.stretch),
          count(row.particles),
          std::string(verdict_name(row.verdict)),
          row.refusal,
          cell(row.acoustic),
          cell(row.imbalance),
          cell(row.unrest),
          cell(row.bound),
          cell(row.limit),
          count(row.soft),
          cell(row.excursion),
          count(row.negative),
          cell(row.growth)};
}

std::vector<std::string> run_cells(const PerturbedRun& run) {
  return {
      run.label,           cell(run.ratio),        cell(run.expected),        cell(run.seen),
      cell(run.amplitude), cell(run.energy_drift), std::to_string(run.steps), count(run.lost_at)};
}

void write_rows(const Atlas& atlas, const std::filesystem::path& path) {
  CsvWriter csv(path, columns);
  for (const AtlasRow& row : atlas.rows) {
    const std::vector<PerturbedRun> none(1);
    for (const PerturbedRun& run : row.runs.empty() ? none : row.runs) {
      std::vector<std::string> cells = state_cells(row);
      for (std::string& text : run_cells(run)) cells.push_back(std::move(text));
      csv.row(cells);
    }
  }
  csv.close();
}

void write_waves(const Atlas& atlas, const std::filesystem::path& path) {
  const std::vector<std::string> names =
      atlas.dimension == 1 ? std::vector<std::string>{"method", "poisson", "k_x", "longitudinal"}
                           : std::vector<std::string>{"method", "poisson",    "k_x",
                                                      "k_y",    "transverse", "longitudinal"};
  CsvWriter csv(path, names);
  for (const WaveRow& row : atlas.waves)
    for (const std::vector<double>& line : row.map) {
      std::vector<std::string> cells = {row.method, cell(row.poisson)};
      for (const double value : line) cells.push_back(cell(value));
      csv.row(cells);
    }
  csv.close();
}

Json run_json(const PerturbedRun& run) {
  Json json;
  json.set("label", run.label);
  json.set("dt_ratio", run.ratio);
  json.set("growth_expected", run.expected);
  json.set("growth_seen", run.seen);
  json.set("amplitude", run.amplitude);
  json.set("energy_drift", run.energy_drift);
  json.set("steps", run.steps);
  json.set("lost_at", run.lost_at);
  return json;
}

Json row_json(const AtlasRow& row) {
  Json json;
  json.set("name", row.name);
  json.set("method", row.method);
  json.set("formulation", row.formulation);
  json.set("kernel", row.kernel);
  json.set("support", row.support);
  json.set("body", row.body);
  json.set("jitter", row.jitter);
  json.set("poisson", row.poisson);
  json.set("stretch", row.stretch);
  json.set("particles", row.particles);
  json.set("verdict", verdict_name(row.verdict));
  json.set("refusal", row.refusal);
  json.set("acoustic", row.acoustic);
  json.set("imbalance", row.imbalance);
  json.set("unrest", row.unrest);
  json.set("critical_step", row.bound);
  json.set("true_limit", row.limit);
  json.set("soft_modes", row.soft);
  json.set("excursion", row.excursion);
  json.set("negative", row.negative);
  json.set("growth", row.growth);
  json.make_list("runs");
  for (const PerturbedRun& run : row.runs) json.append("runs", run_json(run));
  return json;
}

Json wave_json(const WaveRow& row) {
  Json json;
  json.set("method", row.method);
  json.set("poisson", row.poisson);
  json.set("zero_energy_waves", row.zero_energy);
  json.set("transverse", row.transverse);
  json.set("longitudinal", row.longitudinal);
  json.set("anisotropy", row.anisotropy);
  json.set("slowest", row.slowest);
  return json;
}

Json contrast_json(const ContrastRow& row) {
  Json json;
  json.set("dimension", row.dimension);
  json.set("stress", row.stress);
  json.set("growth_expected", row.expected);
  json.set("growth_seen", row.seen);
  json.set("amplitude", row.amplitude);
  return json;
}

Json crush_json(const CrushRow& row) {
  Json json;
  json.set("method", row.method);
  json.set("particles", row.particles);
  json.set("motion", row.motion);
  json.set("follow", row.follow);
  json.set("speed", row.speed);
  json.set("safety", row.safety);
  json.set("steps", row.steps);
  json.set("estimates", row.estimates);
  json.set("looks", row.looks);
  json.set("bounds", row.bounds);
  json.set("share", row.share);
  json.set("closest", row.closest);
  json.set("smallest_det_F", row.smallest);
  json.set("failure", row.failure);
  return json;
}

Json failure_json(const Failure& failure) {
  Json json;
  json.set("where", failure.where);
  json.set("what", failure.what);
  json.set("why", failure.why);
  json.set("cure", failure.cure);
  json.set("states", failure.states);
  json.set("evidence", failure.evidence);
  json.set("cured", failure.cured);
  return json;
}

template <class Row, class Make>
void append_all(Json& json, const char* list, const std::vector<Row>& rows, const Make& make) {
  json.make_list(list);
  for (const Row& row : rows) json.append(list, make(row));
}

}  // namespace

void Atlas::write(const std::filesystem::path& directory) const {
  make_output_directory(directory);
  write_rows(*this, directory / "stability.csv");
  write_waves(*this, directory / "waves.csv");
  Json json;
  json.set("scene", scene);
  json.set("version", version);
  json.set("dimension", dimension);
  json.set("seconds", seconds);
  json.set("interrupted", interrupted);
  const Safety safe = safety();
  json.set("step.smallest_share", safe.smallest_share);
  json.set("step.largest_share", safe.largest_share);
  json.set("step.stable_states", safe.stable_states);
  json.set("step.lost_runs", safe.lost_runs);
  append_all(json, "failures", failures, failure_json);
  append_all(json, "waves", waves, wave_json);
  append_all(json, "contrast", contrast, contrast_json);
  append_all(json, "crush", crush, crush_json);
  append_all(json, "rows", rows, row_json);
  json.write(directory / "stability.json");
}

}  // namespace tlsph
