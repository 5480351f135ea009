#pragma once
/// \file
/// Points as a user's file lists them: comma-separated values under a header line.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "tlsph/core/error.hpp"

namespace tlsph {

/// Rows of a file of points, in its order.
struct PointsTable {
  std::filesystem::path file;
  std::size_t dimension = 0;
  std::vector<double> X;                       ///< N×d row-major [m]
  std::vector<double> V;                       ///< N [m^d]; empty without the column `volume`
  std::vector<std::vector<std::string>> tags;  ///< names of each point; empty without `tag`
  std::vector<int> line;                       ///< where each point stands in the file, from 1

  [[nodiscard]] std::size_t size() const { return line.size(); }
  /// The line of that point, for complaints about it.
  [[nodiscard]] Place place_of(std::size_t point) const {
    return {file.string(), point < line.size() ? line[point] : 1, 1, ""};
  }
  /// The same points, point order[k] the k-th.
  [[nodiscard]] PointsTable in_order(const std::vector<int>& order) const;
};

/// Reads `file`: a header of `x` and, in two dimensions, `y`, then `volume` and `tag` where wanted,
/// in any order; a row per point. Several names in a tag are separated by spaces. Blank lines and
/// those that start with # do not count. InputError, with line and column, for a file that cannot
/// be read, a column that is missing, repeated or unknown, a row of another length, a cell that is
/// no finite number, or no rows at all.
[[nodiscard]] PointsTable read_points(const std::filesystem::path& file, std::size_t dimension);

}  // namespace tlsph
