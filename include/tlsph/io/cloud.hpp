#pragma once
/// \file
/// Particles and material points as the files hold them: plain arrays that the caller keeps alive.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tlsph/io/hdf5.hpp"

namespace tlsph {

/// Reference positions and volumes of N nodes or material points in d dimensions.
struct CloudView {
  std::size_t dimension = 0;
  std::span<const double> X;  ///< N×d row-major [m]
  std::span<const double> V;  ///< N [m^d]
  std::span<const std::int64_t> tag =
      {};  ///< N sets of patches, bit k = patch k; empty: none written
  std::vector<std::string> patches = {};  ///< names of the patches, in the order of the bits

  [[nodiscard]] std::size_t size() const { return V.size(); }
};

/// Writes the data sets X (N×d), V (N) and, where there are tags, tag (N, with an attribute
/// `patches`) into `group`, with their units.
void write_cloud(Hdf5File& file, const std::string& group, const CloudView& cloud);

}  // namespace tlsph
