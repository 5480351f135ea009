#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "tlsph/core/error.hpp"
#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {

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
  const History& history = probes.computed;
  const auto found = std::ranges::find(history.names, name);
  if (found == history.names.end())
    throw InputError({(directory / "probes.csv").string(), 0, 0, ""},
                     "no column \"" + std::string(name) + "\"");
  return history.values[static_cast<std::size_t>(found - history.names.begin())];
}

CaseRun::CaseRun(std::filesystem::path folder, std::filesystem::path out)
    : folder_(std::move(folder)), out_(std::move(out)) {
  make_output_directory(out_);
}

Scene CaseRun::read(const std::string& file, const std::vector<std::string>& overrides) const {
  return read_scene(folder_ / file, overrides);
}

CaseScene CaseRun::scene(const std::string& label, const std::string& file,
                         const std::vector<std::string>& overrides) {
  const Scene described = read(file, overrides);
  CaseScene result;
  result.directory = out_ / label;
  RunOptions options;
  options.out = result.directory;
  options.threads = 1;
  options.histories = &result.probes;
  try {
    result.summary = tlsph::run(described, options);
  } catch (const NumericalError& error) {
    result.failed_at = error.time();
    result.failure = error.what();
  }
  return result;
}

void CaseRun::relative(std::string source, std::string quantity, double reference, double observed,
                       double tolerance) {
  checks_.push_back({std::move(source), std::move(quantity), Criterion::relative, reference,
                     observed, tolerance});
}

void CaseRun::absolute(std::string source, std::string quantity, double reference, double observed,
                       double tolerance) {
  checks_.push_back({std::move(source), std::move(quantity), Criterion::absolute, reference,
                     observed, tolerance});
}

void CaseRun::at_most(std::string source, std::string quantity, double limit, double observed) {
  checks_.push_back(
      {std::move(source), std::move(quantity), Criterion::at_most, limit, observed, 0.0});
}

void CaseRun::at_least(std::string source, std::string quantity, double limit, double observed) {
  checks_.push_back(
      {std::move(source), std::move(quantity), Criterion::at_least, limit, observed, 0.0});
}

void CaseRun::report(std::string source, std::string quantity, double observed,
                     std::optional<double> claimed) {
  checks_.push_back({std::move(source), std::move(quantity), Criterion::reported,
                     claimed.value_or(std::numeric_limits<double>::quiet_NaN()), observed, 0.0});
}

void CaseRun::table(const std::string& name, const std::vector<std::string>& columns,
                    const std::vector<std::vector<double>>& values) const {
  assert(columns.size() == values.size());
  CsvWriter csv(out_ / (name + ".csv"), columns);
  std::vector<double> row(columns.size());
  const std::size_t rows = values.empty() ? 0 : values.front().size();
  for (std::size_t k = 0; k < rows; ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c) row[c] = values[c].at(k);
    csv.row(std::span<const double>(row));
  }
  csv.close();
}

}  // namespace tlsph
