#pragma once
/// \file
/// The cheapest model of a scene for a wanted error: dimension and symmetries the scene allows,
/// formulation, support, stabiliser, spacing, law and output, chosen by short runs at coarse
/// spacings and extrapolation, then verified by one run.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tlsph/studies/chart.hpp"

namespace tlsph {

struct FitRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, as for a run
  double error = 0.0;                  ///< wanted, relative, in (0, 1)
  std::string quantity;  ///< stress, displacement or velocity; empty: the worst of the three
  std::optional<ChartValue> value;  ///< a number read off a probe instead
};

/// A short run at a coarse spacing.
struct Pilot {
  double spacing = 0.0;                ///< [m]
  double setup = 0.0, stepping = 0.0;  ///< [s]
  double charged = 0.0;  ///< [s]: stepping, and the set-up of formulations that factorise
  Index particles = 0;
  long steps = 0;
  double error = 0.0;  ///< relative, not zero; of a single number with its sign
};

/// A family and what its pilots show.
struct FitFamily {
  std::string label;
  std::vector<std::string> overrides;
  std::vector<Pilot> pilots;  ///< coarse to fine
  bool reaches = false;       ///< the fields below hold
  double order = 0.0, spacing = 0.0, predicted_error = 0.0, predicted_seconds = 0.0;
  std::string note;  ///< why it was left: the scene refuses it, dearer, failed
};

struct FitTable {
  std::string scene, version;
  double wanted = 0.0;
  std::string quantity;
  double answer = 0.0;                  ///< of a value; not a number for fields
  std::vector<std::string> reductions;  ///< of the scene, in words
  std::vector<FitFamily> families;
  // The choice:
  bool reached = false;      ///< else no family is predicted to; the choice is what came nearest
  std::string family, text;  ///< text: the scene, TOML
  bool linear = false;       ///< linear elastic in place of the scene's law
  double spacing = 0.0, predicted_error = 0.0, predicted_seconds = 0.0;
  bool coarsest = false;     ///< there is no coarser spacing at which the family runs
  bool corrected = false;    ///< the first verification missed; what stands here is the second
  double first_error = 0.0;  ///< of the first
  // The verification:
  Index particles = 0;
  long steps = 0;
  double measured_error = 0.0, measured_seconds = 0.0;
  double spent = 0.0;  ///< all of it [s]
  bool interrupted = false;

  /// The verification is as near as wanted.
  [[nodiscard]] bool meets() const { return measured_error <= wanted; }
  /// What `tlsph fit` prints before the verification, and after it.
  [[nodiscard]] std::string choice_text() const;
  [[nodiscard]] std::string verdict_text() const;
  /// Writes fit.json, and fit.csv with a row a pilot.
  void write(const std::filesystem::path& directory) const;
};

/// `out` holds scene.toml, fit.json, fit.csv and what runs leave.
struct FitOptions : StudyOptions {
  int threads = 1;
  std::function<void(const FitTable&)> after_choice;  ///< the scene is chosen and written
};

/// Runs the study. InputError, before anything is written, for an error that is none, a quantity or
/// value the scene does not have, points of a file (their spacing is theirs), and all that is wrong
/// with the scene as it stands; and where no family could be built at any spacing.
[[nodiscard]] FitTable fit(const FitRequest& request, const FitOptions& options);

// From the pilots of one family to the spacing of a wanted error and what it will cost.

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
