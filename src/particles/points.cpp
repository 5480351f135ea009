#include "tlsph/particles/points.hpp"

#include "tlsph/core/error.hpp"
#include "tlsph/particles/cells.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {

namespace {

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

template MaterialPoints<1> cell_points(const Particles<1>&);
template MaterialPoints<2> cell_points(const Particles<2>&);
template MaterialPoints<1> node_points(const Particles<1>&);
template MaterialPoints<2> node_points(const Particles<2>&);

}  // namespace tlsph
