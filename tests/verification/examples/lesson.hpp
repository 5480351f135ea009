#pragma once
/// \file
/// A scene of examples/, run as a user runs it: the very file, files written, then read back.

#include <string>
#include <vector>

#include "tlsph/core/types.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph::lessons {

/// A column of probes.csv against its time column.
struct History {
  std::vector<double> time;   ///< [s]
  std::vector<double> value;  ///< SI units

  [[nodiscard]] double last() const { return value.back(); }
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double largest_magnitude() const;
};

/// Runs `examples/<name>.toml` in one thread with overrides `key=value`; what it writes lives in a
/// folder of its own for as long as this does.
class Lesson {
 public:
  explicit Lesson(const std::string& name, const std::vector<std::string>& overrides = {});
  Lesson(const Lesson&) = delete;
  Lesson& operator=(const Lesson&) = delete;
  ~Lesson();

  [[nodiscard]] const Summary& summary() const { return summary_; }
  /// `column` as in the header of probes.csv: `tip.displacement_y`.
  [[nodiscard]] History history(const std::string& column) const;
  /// Reference positions of the nodes (N×2), from run.h5.
  [[nodiscard]] VectorField<2> nodes() const;
  /// Their displacements in the last frame.
  [[nodiscard]] VectorField<2> last_displacement() const;

 private:
  std::filesystem::path folder_;
  Summary summary_;
};

}  // namespace tlsph::lessons
