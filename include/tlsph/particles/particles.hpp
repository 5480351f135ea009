#pragma once
/// \file
/// The reference configuration: nodes that carry mass and displacement, material points that carry
/// deformation and stress, the cells between them and the faces of the boundary. Immutable once built.

#include <array>
#include <string>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// A piece of the boundary between neighbouring boundary nodes.
template <int D>
struct Face {
  std::array<int, D> nodes;  ///< its end nodes (twice the same one for cell-centred particles in 2D)
  Vector<D> area;            ///< outward area vector [m^(d−1)], reference configuration
};

/// A named part of the boundary: `left`, `right`, `top`, `bottom`, `hole`, `outer` or a named box.
template <int D>
struct Patch {
  std::string name;
  std::vector<int> nodes;         ///< sorted, each once
  std::vector<Face<D>> faces;     ///< the faces that make it up; empty for a named box of inner nodes
};

/// Corners of one lattice cell in cyclic (counter-clockwise) order; 2 in 1D, 4 in 2D.
template <int D>
using Cell = std::array<int, (1 << D)>;

template <int D>
struct Particles {
  VectorField<D> X;            ///< N×d reference positions [m]
  ScalarField V;               ///< N volumes [m^d], Σ V = |body|
  VectorField<D> B;            ///< N×d lumped outward boundary area vectors [m^(d−1)], zero inside
  double spacing = 0.0;        ///< lattice spacing Δ [m]
  std::vector<Patch<D>> patches;
  std::vector<Cell<D>> cells;  ///< lattice cells inside the body; empty for cell-centred placement

  [[nodiscard]] Index size() const { return X.rows(); }
  /// The patch of that name, nullptr if the body has none.
  [[nodiscard]] const Patch<D>* find(const std::string& name) const {
    for (const auto& patch : patches)
      if (patch.name == name) return &patch;
    return nullptr;
  }
};

/// Where deformation and stress live. Collocated formulations use the nodes themselves.
template <int D>
struct MaterialPoints {
  VectorField<D> X;  ///< M×d reference positions [m]
  ScalarField V;     ///< M volumes [m^d]

  [[nodiscard]] Index size() const { return X.rows(); }
};

}  // namespace tlsph
