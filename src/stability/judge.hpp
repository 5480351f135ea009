#pragma once
/// \file
/// One row of the atlas: build the state, take its spectrum, confirm it by runs, give the verdict.

#include <map>

#include "specimen.hpp"
#include "tlsph/stability/atlas.hpp"

namespace tlsph {

/// The first true vibration [1/s] of the free body at a Poisson ratio, on stress points in cells
/// with their hourglass stiffness, which have no modes but true ones. Kept, for many rows ask.
class FirstVibration {
 public:
  explicit FirstVibration(const Subject& subject) : subject_(subject) {}
  [[nodiscard]] double of(const StateKey& key, Support support);

 private:
  const Subject& subject_;
  std::map<std::string, double> known_;
};

[[nodiscard]] AtlasRow judge(const Subject& subject, const StateKey& key, FirstVibration& first);

}  // namespace tlsph
