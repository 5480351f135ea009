#pragma once
/// \file
/// The reference configuration: nodes that carry mass and displacement, material points that carry
/// deformation and stress, the cells between them and the faces of the boundary. Immutable once
/// built.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Where nodes sit on a lattice: at the corners of its cells, so that some lie on the boundary, or
/// at the centres of the cells.
enum class NodePlacement { on_boundary, cell_centred };

/// A full interval or box of nodes in rows: node (i, j) at origin + (i Δ_x, j Δ_y).
template <int D>
struct LatticeFrame {
  Vector<D> origin;           ///< position of node (0, 0) [m]
  Vector<D> spacing;          ///< Δ per direction [m]
  std::array<int, D> counts;  ///< nodes per direction

  /// Row of the node, along the longer side of the lattice and of equal ones along the last: i in
  /// 1D; i + n_x j in 2D where n_x > n_y, else i n_y + j. What is equal from node to node then
  /// comes in few long pieces.
  [[nodiscard]] int index(const std::array<int, D>& coordinates) const {
    if constexpr (D == 1)
      return coordinates[0];
    else if (counts[0] > counts[1])
      return coordinates[0] + counts[0] * coordinates[1];
    else
      return coordinates[0] * counts[1] + coordinates[1];
  }
  /// Lattice coordinates of a row, the inverse of `index`.
  [[nodiscard]] std::array<int, D> coordinates(int row) const {
    if constexpr (D == 1)
      return {row};
    else if (counts[0] > counts[1])
      return {row % counts[0], row / counts[0]};
    else
      return {row / counts[1], row % counts[1]};
  }
};

/// A piece of the boundary between neighbouring boundary nodes.
template <int D>
struct Face {
  std::array<int, D>
      nodes;       ///< its end nodes (twice the same one for cell-centred particles in 2D)
  Vector<D> area;  ///< outward area vector [m^(d−1)], reference configuration
  /// Part of the area that each end node stands for; equal ones are the trapezoidal rule.
  std::array<double, D> share = [] {
    std::array<double, D> shares{};
    shares.fill(1.0 / D);
    return shares;
  }();
  /// A piece of a face, or a face of an edge that is taken in part: `area` is that of the piece,
  /// the shares are those of linear functions and keep their values.
  bool cut = false;
};

/// A named part of the boundary (`left`, `right`, `bottom`, `top`: the outermost straight edges
/// that face −x, +x, −y, +y; `hole`: what holes leave, without these; `hole1`, `hole2` …: all that
/// one of them leaves; `outer`: all but `hole`; `boundary`: all; `edge1` …: one edge) or a named
/// box.
template <int D>
struct Patch {
  std::string name;
  std::vector<int> nodes;      ///< sorted, each once
  std::vector<Face<D>> faces;  ///< the faces that make it up; empty for a named box of inner nodes
};

/// Length of a patch in 2D [m], number of its ends in 1D.
template <int D>
[[nodiscard]] double patch_extent(const Patch<D>& patch) {
  double sum = 0.0;
  for (const Face<D>& face : patch.faces) sum += face.area.norm();
  return sum;
}

/// Corners of one lattice cell in cyclic (counter-clockwise) order; 2 in 1D, 4 in 2D.
template <int D>
using Cell = std::array<int, (1 << D)>;

/// Nodes of a triangle, counter-clockwise.
using Triangle = std::array<int, 3>;

template <int D>
struct Particles {
  VectorField<D> X;      ///< N×d reference positions [m]
  ScalarField V;         ///< N volumes [m^d], Σ V = |body|
  VectorField<D> B;      ///< N×d lumped outward boundary area vectors [m^(d−1)], zero inside
  double spacing = 0.0;  ///< lattice spacing Δ [m], geometric mean over the directions
  std::vector<Patch<D>> patches;
  std::vector<Cell<D>> cells;  ///< lattice cells inside the body; empty for cell-centred placement
                               ///< and for clouds in 2D
  std::vector<Triangle> triangles = {};    ///< of 2D clouds: they fill the body; else empty
  Vector<D> spacings = Vector<D>::Zero();  ///< Δ per direction [m], within 1 % of another
  NodePlacement placement = NodePlacement::on_boundary;
  std::optional<LatticeFrame<D>>
      frame;                   ///< only if the body is an undisturbed full interval or box
  std::vector<int> line = {};  ///< N lines of the file that listed them, from 1; else empty
  std::vector<Patch<D>> edges =
      {};  ///< in 2D the boundary from corner to corner: `edge1` … (particles/boundary_faces.hpp)

  [[nodiscard]] Index size() const { return X.rows(); }
  /// The patch of that name, nullptr if the body has none.
  [[nodiscard]] const Patch<D>* find(const std::string& name) const {
    for (const auto* list : {&patches, &edges})
      for (const auto& patch : *list)
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
