#pragma once
/// \file
/// The boundary of a 2D body as runs of faces between its corners, with what a chord does not tell
/// of the curve it spans.

#include <vector>

#include "tlsph/particles/particles.hpp"

namespace tlsph {

/// Consecutive faces that meet at less than 30°, in the order of travel with the body on the left.
struct BoundaryRun {
  bool closed = false;            ///< the last face ends where the first begins
  std::vector<std::size_t> face;  ///< rows of the faces it was made from
  std::vector<int> node;          ///< where they begin and, unless closed, where the last one ends
  std::vector<double> chord;      ///< length of each face [m]
  /// Half the angle the curve turns by along each face, positive to the left, from the angles
  /// between faces; zero on a straight edge. Its arc is chord·φ/sin φ.
  std::vector<double> half_turn;

  /// Arc length of face k [m].
  [[nodiscard]] double arc(std::size_t k) const;
  /// Begin (0) or end (1) of face k, as a position in `node`.
  [[nodiscard]] std::size_t at(std::size_t k, std::size_t end) const {
    return (k + end) % node.size();
  }
};

/// The runs of all faces, each face in exactly one.
[[nodiscard]] std::vector<BoundaryRun> boundary_runs(const VectorField<2>& X,
                                                     const std::vector<Face<2>>& faces);

/// Shares of the faces [face][end] by which nodes integrate along each run as the cubic through the
/// four nodes around a face does: area vectors B_q = w_q n_q with w exact for cubics of the arc
/// length. On a straight edge polynomials of degree three are integrated exactly, each face by its
/// neighbours alone. Runs of fewer than three faces keep the shares they have.
void make_shares_cubic(const VectorField<2>& X, std::vector<Face<2>>& faces);

}  // namespace tlsph
