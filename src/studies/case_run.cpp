#include <algorithm>
#include <cmath>

#include "readings.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/hdf5.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {
namespace {

Samples column(const History& history, std::string_view name, const std::filesystem::path& file) {
  const auto found = std::ranges::find(history.names, name);
  if (found == history.names.end())
    throw InputError({file, 0, 0, ""}, "no column \"" + std::string(name) + "\"");
  return {history.time, history.values[static_cast<std::size_t>(found - history.names.begin())]};
}

}  // namespace

bool Check::holds() const {
  switch (criterion) {
    case Criterion::relative:
      return std::abs(observed - reference) <= tolerance * std::abs(reference);
    case Criterion::absolute:
      return std::abs(observed - reference) <= tolerance;
    case Criterion::at_most:
      return observed <= reference;
    case Criterion::at_least:
      return observed >= reference;
    case Criterion::reported:
      return !std::isnan(observed);
  }
  return false;
}

std::span<const double> CaseScene::probe(std::string_view name) const {
  return samples(name).values;
}

Samples CaseScene::samples(std::string_view name) const {
  return column(history, name, directory / "probes.csv");
}

Samples CaseScene::exact_samples(std::string_view name) const {
  return column(exact, name, directory / "probes_exact.csv");
}

std::vector<double> CaseScene::data(const std::string& item) const {
  return Hdf5File::open_read_only(directory / "run.h5").read_doubles(item).values;
}

std::optional<std::vector<double>> CaseScene::frame(const std::string& field, std::size_t k) const {
  const auto file = Hdf5File::open_read_only(directory / "run.h5");
  const std::string item = "frames/" + field;
  if (file.rows(item) <= k) return std::nullopt;
  return file.read_rows(item, k, 1).values;
}

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

void add_row(std::vector<CaseColumn>& table, const std::vector<double>& row) {
  for (std::size_t c = 0; c < table.size(); ++c) table[c].values.push_back(row.at(c));
}

CaseRun::CaseRun(std::filesystem::path folder, std::filesystem::path out)
    : folder_(std::move(folder)), out_(std::move(out)) {
  make_output_directory(out_);
}

Scene CaseRun::read(const std::string& file, const Settings& overrides) const {
  return read_scene(folder_ / file, overrides);
}

CaseScene CaseRun::scene(const std::string& label, const std::string& file,
                         const Settings& overrides) {
  const Scene described = read(file, overrides);
  CaseScene result;
  result.directory = out_ / label;
  RunOptions options;
  options.out = result.directory;
  options.threads = 1;
  ProbeHistories probes;
  options.histories = &probes;
  try {
    result.summary = tlsph::run(described, options);
  } catch (const NumericalError& error) {
    result.failed_at = error.time();
    result.failure = error.what();
  }
  result.history = std::move(probes.computed);
  result.exact = std::move(probes.exact);
  return result;
}

ConvergenceTable CaseRun::converge(const std::string& file, const Settings& overrides,
                                   const std::vector<double>& spacings) const {
  ConvergenceRequest request;
  request.scene = folder_ / file;
  request.overrides = overrides;
  request.spacings = spacings;
  ConvergenceOptions options;
  options.threads = 1;
  ConvergenceTable table = tlsph::converge(request, options);
  for (const ConvergenceRow& row : table.rows)
    if (!row.failure.empty()) throw NumericalError(row.failure, 0.0, -1);
  return table;
}

void CaseRun::check(std::string source, std::string quantity, double observed, const Claim& claim) {
  checks_.push_back({std::move(source), std::move(quantity), claim.criterion, claim.reference,
                     observed, claim.tolerance});
}

void CaseRun::table(const std::string& name, const std::vector<CaseColumn>& columns) const {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  for (const CaseColumn& column : columns) {
    names.push_back(column.name);
    values.push_back(column.values);
  }
  write_columns(out_ / (name + ".csv"), names, values);
}

}  // namespace tlsph
