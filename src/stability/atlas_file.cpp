#include <optional>

#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/io/record.hpp"
#include "tlsph/stability/atlas.hpp"
#include "verdict_names.hpp"

namespace tlsph {
namespace {

/// −1 stands for a count that is not known.
std::optional<Index> known(Index count) {
  return count < 0 ? std::nullopt : std::optional(count);
}

Record state_record(const AtlasRow& row) {
  Record record;
  record.set("name", row.name);
  record.set("method", row.method);
  record.set("formulation", row.formulation);
  record.set("kernel", row.kernel);
  record.set("support", row.support);
  record.set("body", row.body);
  record.set("jitter", row.jitter);
  record.set("poisson", row.poisson);
  record.set("stretch", row.stretch);
  record.set("particles", known(row.particles));
  record.set("verdict", verdict_name(row.verdict));
  record.set("refusal", row.refusal);
  record.set("acoustic", row.acoustic);
  record.set("imbalance", row.imbalance);
  record.set("unrest", row.unrest);
  record.set("critical_step", row.bound);
  record.set("true_limit", row.limit);
  record.set("soft_modes", known(row.soft));
  record.set("excursion", row.excursion);
  record.set("negative", known(row.negative));
  record.set("growth", row.growth);
  return record;
}

Record run_record(const PerturbedRun& run) {
  Record record;
  record.set("label", run.label);
  record.set("dt_ratio", run.ratio);
  record.set("growth_expected", run.expected);
  record.set("growth_seen", run.seen);
  record.set("amplitude", run.amplitude);
  record.set("energy_drift", run.energy_drift);
  record.set("steps", run.steps);
  record.set("lost_at", known(run.lost_at));
  return record;
}

/// A line a run; a state without runs has one line too.
void write_rows(const Atlas& atlas, const std::filesystem::path& path) {
  const auto line = [](const AtlasRow& row, const PerturbedRun& run) {
    Record record = state_record(row);
    record.append(run_record(run));
    return record;
  };
  std::string csv = csv_line(line({}, {}).names());
  const std::vector<PerturbedRun> none(1);
  for (const AtlasRow& row : atlas.rows)
    for (const PerturbedRun& run : row.runs.empty() ? none : row.runs)
      csv += csv_line(line(row, run).cells());
  write_text_file(path, csv);
}

void write_waves(const Atlas& atlas, const std::filesystem::path& path) {
  const std::vector<std::string> names =
      atlas.dimension == 1 ? std::vector<std::string>{"method", "poisson", "k_x", "longitudinal"}
                           : std::vector<std::string>{"method", "poisson",    "k_x",
                                                      "k_y",    "transverse", "longitudinal"};
  std::string csv = csv_line(names);
  for (const WaveRow& row : atlas.waves)
    for (const std::vector<double>& line : row.map) {
      std::vector<std::string> cells = {row.method, csv_number(row.poisson)};
      for (const double value : line) cells.push_back(csv_number(value));
      csv += csv_line(cells);
    }
  write_text_file(path, csv);
}

Json row_json(const AtlasRow& row) {
  Json json = state_record(row).json();
  json.make_list("runs");
  for (const PerturbedRun& run : row.runs) json.append("runs", run_record(run).json());
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
