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
#include "tlsph/studies/fit_model.hpp"

namespace tlsph {

struct FitRequest {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, as for a run
  double error = 0.0;                  ///< wanted, relative, in (0, 1)
  std::string quantity;  ///< stress, displacement or velocity; empty: the worst of the three
  std::optional<ChartValue> value;  ///< a number read off a probe instead
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

}  // namespace tlsph
