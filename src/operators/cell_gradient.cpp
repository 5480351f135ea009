#include <algorithm>
#include <utility>
#include <vector>

#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/delaunay.hpp"

namespace tlsph {
namespace {

template <int D>
using Row = std::vector<std::pair<int, Vector<D>>>;

/// Rows of a gradient over the nodes of cells.
template <int D>
struct Rows {
  Neighbours pattern{{0}, {}};
  std::vector<double> weights;

  /// Room for so many rows of a cell's nodes each.
  void reserve(std::size_t count) {
    pattern.start.reserve(count + 1);
    pattern.column.reserve(count << D);
    weights.reserve((count << D) * D);
  }
  void add(Row<D> row) {
    std::sort(row.begin(), row.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [node, weight] : row) {
      pattern.column.push_back(node);
      for (int a = 0; a < D; ++a) weights.push_back(weight[a]);
    }
    pattern.start.push_back(static_cast<Index>(pattern.column.size()));
  }
};

Row<1> mean_gradient(const Cell<1>& cell, double length) {
  return {{cell[0], Vector<1>(-1.0 / length)}, {cell[1], Vector<1>(1.0 / length)}};
}

/// Mean over the polygon of those nodes, counter-clockwise: ∮ f n dS along its straight edges, over
/// its area.
Row<2> mean_gradient(const VectorField<2>& X, const std::vector<int>& nodes, double area) {
  const std::size_t n = nodes.size();
  Row<2> row;
  for (std::size_t k = 0; k < n; ++k) {
    const auto next = X.row(nodes[(k + 1) % n]), last = X.row(nodes[(k + n - 1) % n]);
    const Vector<2> weight(0.5 * (next[1] - last[1]), -0.5 * (next[0] - last[0]));
    row.emplace_back(nodes[k], weight / area);
  }
  return row;
}

}  // namespace

template <int D>
VectorOperator<D> cell_gradient(const Particles<D>& particles, const MaterialPoints<D>& points) {
  Rows<D> rows;
  rows.reserve(static_cast<std::size_t>(points.size()));
  Index s = 0;
  for (const Cell<D>& cell : particles.cells) {
    if constexpr (D == 1)
      rows.add(mean_gradient(cell, points.V[s++]));
    else
      rows.add(mean_gradient(particles.X, {cell.begin(), cell.end()}, points.V[s++]));
  }
  if constexpr (D == 2)
    for (const auto& [a, b, left, right] : edges_of(particles.triangles)) {
      const auto corners = right < 0 ? std::vector{a, b, left} : std::vector{a, right, b, left};
      rows.add(mean_gradient(particles.X, corners, 3.0 * points.V[s++]));
    }
  return VectorOperator<D>(points.size(), particles.size(), std::move(rows.pattern),
                           std::move(rows.weights));
}

template VectorOperator<1> cell_gradient<1>(const Particles<1>&, const MaterialPoints<1>&);
template VectorOperator<2> cell_gradient<2>(const Particles<2>&, const MaterialPoints<2>&);

}  // namespace tlsph
