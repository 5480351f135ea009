#pragma once
/// \file
/// Histories at a spacing of zero, by Richardson from those of two spacings.

#include <filesystem>
#include <string>
#include <vector>

#include "tlsph/observe/history.hpp"

namespace tlsph {

/// The finer history plus (fine − coarse)/(ratio^p − 1) at its own instants, ratio =
/// h_coarse/h_fine and p the order of the quantity that a column belongs to. Columns of quantities
/// without a positive order are left out.
[[nodiscard]] History extrapolated(const History& coarse, const History& fine, double ratio,
                                   const std::vector<std::string>& quantities,
                                   const std::vector<double>& orders);

/// Writes `history` as probes.csv is written. OutputError.
void write_history(const std::filesystem::path& file, const History& history);

}  // namespace tlsph
