#pragma once
/// \file
/// Self-convergence: how far the probes of runs of falling spacing are apart, and what they tend
/// to.

#include <filesystem>
#include <string>
#include <vector>

#include "tlsph/observe/history.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

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
