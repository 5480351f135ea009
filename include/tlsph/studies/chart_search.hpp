#pragma once
/// \file
/// Which configuration to run next: predictions from what has been run, and what they promise.

#include <optional>
#include <vector>

namespace tlsph {

/// What a run of a family at one spacing took and gave.
struct Measured {
  double spacing = 0.0;                ///< [m]
  double setup = 0.0, stepping = 0.0;  ///< [s]
  std::vector<double> errors;
};

/// The same of a run that has not been made.
struct Predicted {
  double setup = 0.0, stepping = 0.0;  ///< [s]
  std::vector<double> errors;
  [[nodiscard]] double cost() const { return setup + stepping; }
};

/// From the last runs of a family, coarse to fine: work grows with h^−(D+1), set-up with h^−D, both
/// faster where they were seen to; errors fall with the order that the last two runs show, 2 before
/// there are two.
[[nodiscard]] Predicted predict(const std::vector<Measured>& runs, double spacing, int dimension);

/// The runs of a family, coarse to fine, with the errors they are to be judged by. A single number
/// may hit its answer by chance, where its error changes sign: for those quantities a run counts no
/// better than the next finer one, no better than order 3 makes it from the next coarser one, and
/// not at all without either.
[[nodiscard]] std::vector<Measured> judged(std::vector<Measured> runs,
                                           const std::vector<bool>& single_number);

/// How far, in natural logarithms of the error, a run would reach beyond what is as fast; the best
/// over the quantities. Not positive: others are as near and not slower. `margin` > 1 is what the
/// prediction may err by, in time and in error.
[[nodiscard]] double promise(const Predicted& run, const std::vector<Measured>& all, double margin);

/// The entry of the largest promise per predicted second among those that fit the time that is
/// left; empty if none promises anything.
struct Prospect {
  double promise = 0.0, cost = 0.0;
};
[[nodiscard]] std::optional<std::size_t> best_prospect(const std::vector<Prospect>& prospects,
                                                       double seconds_left);

}  // namespace tlsph
