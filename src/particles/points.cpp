#include "tlsph/particles/points.hpp"

#include <algorithm>

#include "tlsph/core/error.hpp"
#include "tlsph/geometry/polygon.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

Vector<2> corner(const VectorField<2>& X, const Cell<2>& cell, std::size_t k) {
  return X.row(cell[k % 4]).transpose();
}

/// One point per edge: a third of the triangles on both sides, at the centre of area of the two.
MaterialPoints<2> edge_points(const VectorField<2>& X, const std::vector<Triangle>& triangles) {
  const std::vector<TriangleEdge> edges = edges_of(triangles);
  const auto count = static_cast<Index>(edges.size());
  MaterialPoints<2> points{VectorField<2>(count, 2), ScalarField(count)};
  for (Index s = 0; s < count; ++s) {
    const auto& [a, b, left, right] = edges[static_cast<std::size_t>(s)];
    double area = triangle_area(X, {a, b, left});
    Vector<2> first = area * triangle_centre(X, {a, b, left});
    if (right >= 0) {
      const Triangle other = {b, a, right};
      area += triangle_area(X, other);
      first += triangle_area(X, other) * triangle_centre(X, other);
    }
    points.X.row(s) = (first / area).transpose();
    points.V[s] = area / 3.0;
  }
  return points;
}

}  // namespace

template <>
double cell_volume(const VectorField<1>& X, const Cell<1>& cell) {
  return X(cell[1]) - X(cell[0]);
}

template <>
double cell_volume(const VectorField<2>& X, const Cell<2>& cell) {
  // Half the cross product of the diagonals: exact for any quadrilateral.
  return 0.5 *
         cross(corner(X, cell, 2) - corner(X, cell, 0), corner(X, cell, 3) - corner(X, cell, 1));
}

template <>
double least_jacobian(const VectorField<1>& X, const Cell<1>& cell) {
  return cell_volume<1>(X, cell);
}

template <>
double least_jacobian(const VectorField<2>& X, const Cell<2>& cell) {
  double least = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector<2> here = corner(X, cell, k);
    const double jacobian = cross(corner(X, cell, k + 1) - here, corner(X, cell, k + 3) - here);
    least = k == 0 ? jacobian : std::min(least, jacobian);
  }
  return least;
}

template <int D>
Vector<D> cell_centre(const VectorField<D>& X, const Cell<D>& cell) {
  Vector<D> sum = Vector<D>::Zero();
  for (const int node : cell) sum += X.row(node).transpose();
  return sum / static_cast<double>(cell.size());
}

template <int D>
ScalarField node_volumes(const VectorField<D>& X, const std::vector<Cell<D>>& cells) {
  ScalarField V = ScalarField::Zero(X.rows());
  for (const auto& cell : cells) {
    if constexpr (D == 1) {
      for (const int node : cell) V(node) += 0.5 * cell_volume<1>(X, cell);
    } else {
      const Vector<2> centre = cell_centre<2>(X, cell);
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector<2> here = corner(X, cell, k);
        const Vector<2> next = 0.5 * (here + corner(X, cell, k + 1));
        const Vector<2> last = 0.5 * (here + corner(X, cell, k + 3));
        V(cell[k]) += 0.5 * cross(centre - here, last - next);
      }
    }
  }
  return V;
}

template <int D>
MaterialPoints<D> cell_points(const Particles<D>& particles) {
  if constexpr (D == 2)
    if (!particles.triangles.empty()) return edge_points(particles.X, particles.triangles);
  if (particles.cells.empty())
    throw InputError(
        "stress points need the cells between nodes, which cell-centred placement does not have; "
        "use placement \"on-boundary\"");
  const auto count = static_cast<Index>(particles.cells.size());
  MaterialPoints<D> points{VectorField<D>(count, D), ScalarField(count)};
  for (Index s = 0; s < count; ++s) {
    const auto& cell = particles.cells[static_cast<std::size_t>(s)];
    points.X.row(s) = cell_centre<D>(particles.X, cell).transpose();
    points.V(s) = cell_volume<D>(particles.X, cell);
  }
  return points;
}

template <int D>
MaterialPoints<D> node_points(const Particles<D>& particles) {
  return {particles.X, particles.V};
}

#define TLSPH_INSTANTIATE(D)                                                             \
  template Vector<D> cell_centre(const VectorField<D>&, const Cell<D>&);                 \
  template ScalarField node_volumes(const VectorField<D>&, const std::vector<Cell<D>>&); \
  template MaterialPoints<D> cell_points(const Particles<D>&);                           \
  template MaterialPoints<D> node_points(const Particles<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
