#pragma once
/// \file
/// The studies whose rows are the tables of the atlas.

#include <map>

#include "sample.hpp"

namespace tlsph {

/// The first true vibration [1/s] of the free body at a Poisson ratio, on stress points in cells
/// with their hourglass stiffness, which have no modes but true ones. Kept, as many rows need it.
class FirstVibration {
 public:
  explicit FirstVibration(const Subject& subject) : subject_(subject) {}
  [[nodiscard]] double of(const StateKey& key, Support support);

 private:
  const Subject& subject_;
  std::map<std::string, double> known_;
};

/// Builds the state, takes its spectrum, confirms it by runs, gives the verdict.
[[nodiscard]] AtlasRow state_row(const Subject& subject, const StateKey& key,
                                 FirstVibration& first);

/// Waves on the undeformed lattice, far from any boundary: dispersion, its anisotropy, and the
/// waves without energy. InputError where the method cannot be built.
[[nodiscard]] WaveRow wave_row(const Subject& subject, const Method& method);

/// The updated-Lagrangian counter-example in the material and dimension of the atlas: one particle
/// of a lattice pushed, at a few uniform stresses.
[[nodiscard]] std::vector<ContrastRow> contrast_rows(const Subject& subject);

/// Fast compression: an edge of the body moves in at a share of the speed of sound until the
/// stretch is 0.2, and the critical step falls to a fraction. Does the step follow, how closely,
/// and at what cost?
struct Compression {
  Method method;
  bool impact = false;    ///< the body is at rest at first: a shock runs through it; else it moves
                          ///< homogeneously and no wave is sent
  double speed = 0.0;     ///< of the edge, over c_p
  bool adaptive = false;  ///< the step follows the deformation, as in runs
  /// Divides the spacing. A finer body shows the cost; it is not compared with the true limit.
  int finer = 1;

  [[nodiscard]] std::string name() const;
};
[[nodiscard]] std::vector<Compression> compressions(int dimension);
[[nodiscard]] CompressionRow compression_row(const Subject& subject, const Compression& study);

/// The failures of an atlas as text.
[[nodiscard]] std::vector<Failure> failures_of(const Atlas& atlas);

}  // namespace tlsph
