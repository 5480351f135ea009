#pragma once
/// \file
/// Validation: problems with known answers, the numbers that are seen beside those that must come
/// out, and one verdict. A case is a function that runs its problem and hands over checks; the
/// cases themselves are in the room `cases`.
///
///     void bar_pulse(CaseRun& run) {
///       const CaseScene scene = run.scene("mirror", "bar.toml", {"formulation=mirror"});
///       const double seen = arrival(scene.samples("p3.pk1_xx"));
///       run.check("Fig. 4.9", "arrival at 0.10 m, mirror [s]", seen, relative(0.10 / c, 2e-3));
///     }

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/observe/history.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {

class Json;

/// How an observed number is held against its reference.
enum class Criterion {
  relative,  ///< |observed − reference| ≤ tolerance |reference|
  absolute,  ///< |observed − reference| ≤ tolerance
  at_most,   ///< observed ≤ reference
  at_least,  ///< observed ≥ reference
  reported,  ///< shown without a verdict: what a source's own method does
};

/// What an observed number is held against.
struct Claim {
  Criterion criterion = Criterion::reported;
  double reference = not_known;
  double tolerance = 0.0;
};
[[nodiscard]] constexpr Claim relative(double reference, double tolerance) {
  return {Criterion::relative, reference, tolerance};
}
[[nodiscard]] constexpr Claim absolute(double reference, double tolerance) {
  return {Criterion::absolute, reference, tolerance};
}
[[nodiscard]] constexpr Claim at_most(double limit) {
  return {Criterion::at_most, limit, 0.0};
}
[[nodiscard]] constexpr Claim at_least(double limit) {
  return {Criterion::at_least, limit, 0.0};
}
/// No verdict; beside what the source claims, if it claims anything.
[[nodiscard]] constexpr Claim reported(double claimed = not_known) {
  return {Criterion::reported, claimed, 0.0};
}

struct Check {
  std::string source;    ///< where it is claimed: work, figure or equation
  std::string quantity;  ///< what is measured, of which formulation, with its unit
  Criterion criterion = Criterion::relative;
  double reference = 0.0;  ///< not a number for `reported` without one
  double observed = 0.0;
  double tolerance = 0.0;  ///< of `relative` and `absolute`
  /// False too where `observed` is not a number.
  [[nodiscard]] bool holds() const;
};

/// A column of numbers and the times of its samples [s].
struct Samples {
  std::span<const double> time, values;
};

/// What a run of a scene left: its summary, and what its probes recorded.
struct CaseScene {
  Summary summary;
  History history;  ///< probes.csv; empty without probes
  History exact;    ///< probes_exact.csv: the same of the scene's exact solution, if it has one
  std::filesystem::path directory;  ///< run.h5, probes.csv, …
  std::optional<double> failed_at;  ///< [s] when it lost its physics; `summary` is empty then
  std::string failure;              ///< and how

  /// The column `name` of the probes, "p2.pk1_xx", computed and exact. InputError if there is none.
  [[nodiscard]] std::span<const double> probe(std::string_view name) const;
  [[nodiscard]] Samples samples(std::string_view name) const;
  [[nodiscard]] Samples exact_samples(std::string_view name) const;
  /// A data set of run.h5, "particles/X" or "series/kinetic".
  [[nodiscard]] std::vector<double> data(const std::string& item) const;
  /// A field of frame `k`, "displacement"; empty if the run did not come so far.
  [[nodiscard]] std::optional<std::vector<double>> frame(const std::string& field,
                                                         std::size_t k) const;
};

/// Keys of a scene, `key=value` as for a run.
using Settings = std::vector<std::string>;
[[nodiscard]] Settings with(Settings settings, const Settings& more);

/// A column of a table for the figure of a case.
struct CaseColumn {
  std::string name;
  std::vector<double> values;

  // NOLINTNEXTLINE(google-explicit-constructor): {{"time"}, {"stress"}} is a table without rows
  CaseColumn(std::string column) : name(std::move(column)) {}
  template <class Numbers>
  CaseColumn(std::string column, const Numbers& numbers)
      : name(std::move(column)), values(numbers.begin(), numbers.end()) {}
};

void add_row(std::vector<CaseColumn>& table, const std::vector<double>& row);

/// What a case works with: where its files are, and where its checks go.
class CaseRun {
 public:
  /// `folder` holds the scenes and reference data of the case, `out` takes what it leaves.
  CaseRun(std::filesystem::path folder, std::filesystem::path out);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] const std::filesystem::path& out() const { return out_; }
  [[nodiscard]] const std::vector<Check>& checks() const { return checks_; }

  /// The scene of `file` (in the folder), overrides applied, not run.
  [[nodiscard]] Scene read(const std::string& file, const Settings& overrides = {}) const;
  /// Runs it on one thread with its files in out()/`label`. A numerical failure is in the result.
  CaseScene scene(const std::string& label, const std::string& file,
                  const Settings& overrides = {});

  /// The errors of the scene, which has an exact solution, at spacings [m] from coarse to fine.
  /// NumericalError if a run fails.
  [[nodiscard]] ConvergenceTable converge(const std::string& file, const Settings& overrides,
                                          const std::vector<double>& spacings) const;

  void check(std::string source, std::string quantity, double observed, const Claim& claim);

  /// Writes out()/`name`.csv for the figure of the case, columns of equal length.
  void table(const std::string& name, const std::vector<CaseColumn>& columns) const;

 private:
  std::filesystem::path folder_, out_;
  std::vector<Check> checks_;
};

struct Case {
  std::string_view name;   ///< of its folder
  std::string_view title;  ///< the problem in a few words
  double seconds = 1.0;    ///< about how long it takes on one core; the longest start first
  bool quick = true;       ///< part of --quick
  void (*run)(CaseRun&) = nullptr;
};

struct CaseResult {
  std::string name, title;
  std::vector<Check> checks;
  std::string failure;         ///< why it came to no end, else empty
  std::filesystem::path file;  ///< of its figure, empty if none was drawn
  std::string undrawn;         ///< what would draw it, where that did not work
  double seconds = 0.0;
  [[nodiscard]] bool holds() const;

  /// How the process of a case hands it over; an entry of validation.json.
  [[nodiscard]] Json json() const;
  /// InputError if the document is no such thing.
  [[nodiscard]] static CaseResult read(const Json& json);
};

struct ValidationTable {
  std::string version;
  std::vector<CaseResult> cases;  ///< in the order of the list, those that were done
  bool interrupted = false;

  /// True if every case came to its end and every check holds.
  [[nodiscard]] bool holds() const;
  /// What `tlsph validate` prints.
  [[nodiscard]] std::string text() const;
  /// The same as a page, with the figures; the numbers of two machines agree to what is shown.
  [[nodiscard]] std::string markdown() const;
  /// Writes validation.json and validation.md.
  void write(const std::filesystem::path& directory) const;
};

/// `out` holds <case>/… and figures/<case>.png.
struct ValidationOptions : StudyOptions {
  std::vector<std::string> only;  ///< names; empty: all
  bool quick = false;             ///< of these, those that are quick
  int at_once = 0;                ///< cases side by side, a process each; 0: one a core
  bool figures = true;
  /// Called when a case ends, with the share of the work that is done.
  std::function<void(const CaseResult&, double share)> after_case;
};

/// Runs cases side by side, each in a process of its own, so that one that crashes is one that
/// failed. Scenes and figure script of a case are in `validation_folder()`/<case>. InputError for a
/// name that is none. Must be called before this process has threads.
[[nodiscard]] ValidationTable validate(std::span<const Case> cases,
                                       const ValidationOptions& options);

}  // namespace tlsph
