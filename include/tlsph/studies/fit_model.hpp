#pragma once
/// \file
/// From pilot runs of one family to the spacing of a wanted error and what it will cost.

#include <vector>

#include "tlsph/core/types.hpp"
#include "tlsph/studies/chart_search.hpp"

namespace tlsph {

/// A short run at a coarse spacing.
struct Pilot {
  double spacing = 0.0;                ///< [m]
  double setup = 0.0, stepping = 0.0;  ///< [s]
  double charged = 0.0;  ///< [s]: stepping, and the set-up of formulations that factorise
  Index particles = 0;
  long steps = 0;
  double error = 0.0;  ///< relative, not zero; of a single number with its sign
};

/// Errors of the pilots of a family, coarse to fine, that are to be believed: like a single number
/// of a chart (studies/chart_search.hpp) a coarse field may hit its answer by chance.
[[nodiscard]] std::vector<double> believed_errors(const std::vector<Pilot>& pilots);

/// The order in e = C h^p of the last three pilots, of two if there are no more, within what a
/// prediction believes: 1/2 and 4; 2 where nothing is to be seen. C follows from the last pilot.
[[nodiscard]] double observed_order(const std::vector<Pilot>& pilots,
                                    const std::vector<double>& errors);

/// The error at a spacing: of a pilot its own, between two pilots the straight line in logarithms,
/// beyond the finest C h^p, before the coarsest C h².
[[nodiscard]] double predicted_error(const std::vector<Pilot>& pilots,
                                     const std::vector<double>& errors, double spacing);

/// The largest spacing from which on all finer ones are predicted at most `error`; not above the
/// coarsest pilot.
[[nodiscard]] double spacing_for(const std::vector<Pilot>& pilots,
                                 const std::vector<double>& errors, double error);

/// What a run is charged [s] at a spacing: seconds a particle and step of the pilot nearest to it,
/// times particles (h^−D), times steps (h^−1). A factorisation in 2D grows likewise.
[[nodiscard]] double predicted_seconds(const std::vector<Pilot>& pilots, double spacing,
                                       int dimension);

/// True if the finest pilot meets the error and that is no luck: an answer may be passed from one
/// side to the other, so it must lie on the side of the pilot before and nearer, or the pilot
/// before must meet the error too.
[[nodiscard]] bool is_bracketed(const std::vector<Pilot>& pilots, double error);

/// True if the orders between the last three pilots agree within 0.4 and none is below 1/2: finer
/// ones would show nothing new.
[[nodiscard]] bool has_settled(const std::vector<Pilot>& pilots);

/// True if the last four pilots, fine enough to show something, are equally wrong: within 7 % from
/// each to the next.
[[nodiscard]] bool has_stalled(const std::vector<Pilot>& pilots);

/// A lower bound of what the family would be charged to reach the error: orders up to half a one
/// above the observed are hoped for, 3 before three pilots have shown any.
[[nodiscard]] double hoped_seconds(const std::vector<Pilot>& pilots, double error, int dimension);

}  // namespace tlsph
