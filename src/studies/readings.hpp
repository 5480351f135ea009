#pragma once
/// \file
/// One run of a scene in a study, and what is read off it: errors of fields, values of the probes,
/// and how far the probes of runs of falling spacing are apart. `tip.displacement_y.period` is the
/// period of that column of probes.csv about zero, `….max` and `….min` its largest and smallest
/// value, `….peak` the larger of their sizes, `….end` its last value.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tlsph/simulation/simulation.hpp"

namespace tlsph {

struct ProbedRun {
  Summary summary;
  History history;  ///< of the probes, where it was asked for
};

/// Runs the scene. Empty if the run was stopped before its end. InputError, NumericalError.
[[nodiscard]] std::optional<ProbedRun> run_probed(const Scene& scene, RunOptions options,
                                                  bool with_history);

/// A field whose error against the exact solution a run reports.
struct ErrorField {
  const char* name;
  double FieldErrors::*error;
};
inline constexpr std::array<ErrorField, 3> error_fields = {
    {{"displacement", &FieldErrors::displacement},
     {"velocity", &FieldErrors::velocity},
     {"stress", &FieldErrors::stress}}};
[[nodiscard]] std::vector<std::string> error_field_names();
/// One a field; empty without an exact solution.
[[nodiscard]] std::vector<double> errors_of(const Summary& summary);

/// InputError, naming `--value`, for a name that ends in none of the words, names no probe of the
/// scene or a quantity it does not record.
void check_value_names(const std::vector<std::string>& names, const Scene& scene);

/// One a name; not a number where a column has no period. InputError for a column that is not
/// there.
[[nodiscard]] std::vector<double> read_values(const std::vector<std::string>& names,
                                              const History& history);

/// Names of the values that a history offers: the peak of every column that is not zero, the period
/// of every one that oscillates about zero.
[[nodiscard]] std::vector<std::string> telling_values(const History& history);

/// Quantities the scene's probes record, in their first order, each once.
[[nodiscard]] std::vector<std::string> recorded_quantities(const Scene& scene);

/// Entry (q, k): ‖a_k − a_{k+1}‖ / ‖a_n‖ of quantity q over all probes and components, for n
/// histories from coarse to fine, all brought to the times of the last. n − 1 entries a quantity;
/// not a number where the last vanishes.
[[nodiscard]] std::vector<std::vector<double>> probe_differences(
    const std::vector<std::string>& quantities, const std::vector<History>& histories);

/// The finer history plus (fine − coarse)/(ratio^p − 1) at its own instants, ratio =
/// h_coarse/h_fine and p the order of the quantity that a column belongs to. Columns of quantities
/// without a positive order are left out.
[[nodiscard]] History extrapolated(const History& coarse, const History& fine, double ratio,
                                   const std::vector<std::string>& quantities,
                                   const std::vector<double>& orders);

/// Writes columns of equal length as comma-separated values. OutputError.
void write_columns(const std::filesystem::path& file, const std::vector<std::string>& names,
                   const std::vector<std::vector<double>>& columns);
/// Writes `history` as probes.csv is written. OutputError.
void write_history(const std::filesystem::path& file, const History& history);

}  // namespace tlsph
