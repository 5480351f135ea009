#pragma once
/// \file
/// The checks of one variant of a case.

#include "tlsph/studies/validation.hpp"

namespace tlsph {

/// Names the variant in each of its checks, behind the quantity and before its unit:
///
///     const Checks check(run, ", mirror");
///     check("thesis, Fig. 5.7", "speed of the wave [m/s]", seen, relative(c, 2e-3));
///
/// checks "speed of the wave, mirror [m/s]".
class Checks {
 public:
  Checks(CaseRun& run, std::string variant) : run_(run), variant_(std::move(variant)) {}

  void operator()(const std::string& source, std::string quantity, double observed,
                  const Claim& claim) const {
    const auto end = quantity.ends_with(']') ? quantity.rfind(" [") : quantity.size();
    run_.check(source, quantity.insert(end, variant_), observed, claim);
  }

 private:
  CaseRun& run_;
  std::string variant_;
};

}  // namespace tlsph
