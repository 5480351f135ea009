#pragma once
/// \file
/// The files of a run: run.h5, run.xdmf, probes.csv, probes_exact.csv, checkpoint.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "tlsph/dynamics/state.hpp"
#include "tlsph/io/checkpoint.hpp"
#include "tlsph/io/csv.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/run_file.hpp"
#include "tlsph/io/xdmf.hpp"
#include "tlsph/observe/history.hpp"
#include "tlsph/observe/quantity.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Rows written so far, for a checkpoint.
struct OutputCounts {
  RunRows run;
  CsvRows probes, exact;
};

template <int D>
class RunOutput {
 public:
  /// New files in `directory` (`columns`: the names of the probes' values), or those of a run that
  /// goes on after `resumed`. InputError, with nothing changed, if those are not there or not as
  /// they were written.
  RunOutput(const std::filesystem::path& directory, const Scene& scene,
            const Discretisation<D>& discretisation, const ProbeHistories& columns,
            const std::optional<OutputCounts>& resumed);

  void write_frame(const Instant<D>& now);
  void write_series(double time, std::span<const double> values) {
    run_file_->write_series(time, values);
  }
  /// A row of probes.csv, and of probes_exact.csv if there is one.
  void write_probes(std::span<const double> row, std::span<const double> exact_row) {
    probe_file_->row(row);
    if (exact_file_) exact_file_->row(exact_row);
  }
  /// Whether a frame of this time or a later one is there, to within `tolerance` [s].
  [[nodiscard]] bool has_frame(double time, double tolerance) const {
    const std::vector<double>& times = run_file_->frame_times();
    return !times.empty() && times.back() > time - tolerance;
  }
  /// Everything written reaches the system.
  void flush();
  [[nodiscard]] OutputCounts counts() const;

 private:
  std::span<const double> field(const std::string& name, const Instant<D>& now);

  std::filesystem::path directory_;
  RunLayout layout_;
  DirectoryLock lock_;
  std::optional<RunFile> run_file_;
  std::size_t views_ = 0;  // frames that the file of views shows
  std::optional<CsvWriter> probe_file_, exact_file_;
  std::map<std::string, std::vector<double>> scratch_;
};

}  // namespace tlsph
