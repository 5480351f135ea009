#include "quad_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

/// Neighbours along edges and cells around each node.
struct Links {
  std::vector<std::vector<int>> neighbours, boundary_neighbours, cells;

  explicit Links(const QuadMesh& mesh)
      : neighbours(static_cast<std::size_t>(mesh.X.rows())),
        boundary_neighbours(neighbours.size()),
        cells(neighbours.size()) {
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (std::size_t k = 0; k < 4; ++k) {
        const auto node = static_cast<std::size_t>(mesh.cells[c][k]);
        cells[node].push_back(static_cast<int>(c));
        for (const int other : {mesh.cells[c][(k + 1) % 4], mesh.cells[c][(k + 3) % 4]})
          if (std::find(neighbours[node].begin(), neighbours[node].end(), other) ==
              neighbours[node].end())
            neighbours[node].push_back(other);
      }
    for (const auto& [from, to] : free_edges(mesh.cells)) {
      boundary_neighbours[static_cast<std::size_t>(from)].push_back(to);
      boundary_neighbours[static_cast<std::size_t>(to)].push_back(from);
    }
  }
};

double worst_around(const QuadMesh& mesh, const std::vector<int>& cells) {
  double worst = std::numeric_limits<double>::infinity();
  for (const int cell : cells)
    worst = std::min(worst, least_jacobian<2>(mesh.X, mesh.cells[static_cast<std::size_t>(cell)]));
  return worst;
}

}  // namespace

std::vector<DirectedEdge> free_edges(const std::vector<Cell<2>>& cells) {
  // Ends of the directed edges that start at each node, one list after the other: an edge is free
  // if its reverse is in no list. A cell keeps its edges counter-clockwise, so neither comes twice.
  int nodes = 0;
  for (const auto& cell : cells) nodes = std::max(nodes, 1 + *std::ranges::max_element(cell));
  std::vector<std::size_t> first(static_cast<std::size_t>(nodes) + 1, 0);
  for (const auto& cell : cells)
    for (const int node : cell) ++first[static_cast<std::size_t>(node) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> ends(4 * cells.size());
  std::vector<std::size_t> next = first;
  for (const auto& cell : cells)
    for (std::size_t k = 0; k < 4; ++k)
      ends[next[static_cast<std::size_t>(cell[k])]++] = cell[(k + 1) % 4];
  const auto exists = [&](int from, int to) {
    const auto node = static_cast<std::size_t>(from);
    const auto begin = ends.begin() + static_cast<std::ptrdiff_t>(first[node]);
    const auto end = ends.begin() + static_cast<std::ptrdiff_t>(first[node + 1]);
    return std::find(begin, end, to) != end;
  };
  std::vector<DirectedEdge> edges;
  for (const auto& cell : cells)
    for (std::size_t k = 0; k < 4; ++k)
      if (!exists(cell[(k + 1) % 4], cell[k])) edges.push_back({cell[k], cell[(k + 1) % 4]});
  return edges;
}

void count_rings(const std::vector<Cell<2>>& cells, int rounds, std::vector<int>& ring) {
  for (int round = 0; round < rounds; ++round)
    for (const auto& cell : cells)
      for (std::size_t k = 0; k < 4; ++k)
        for (const std::size_t next : {(k + 1) % 4, (k + 3) % 4}) {
          int& mine = ring[static_cast<std::size_t>(cell[k])];
          mine = std::min(mine, ring[static_cast<std::size_t>(cell[next])] + 1);
        }
}

QuadMesh renumbered(const QuadMesh& mesh, double origin, double spacing) {
  const auto column = [&](double x) { return std::lround((x - origin) / spacing); };
  std::vector<int> order;
  for (const auto& cell : mesh.cells) order.insert(order.end(), cell.begin(), cell.end());
  const auto before = [&](const Vector<2>& a, const Vector<2>& b) {
    return std::tuple(column(a.x()), a.y(), a.x()) < std::tuple(column(b.x()), b.y(), b.x());
  };
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return before(mesh.X.row(a).transpose(), mesh.X.row(b).transpose());
  });

  QuadMesh result{mesh.X(order, Eigen::all), mesh.cells};
  std::vector<int> number(static_cast<std::size_t>(mesh.X.rows()), -1);
  for (std::size_t k = 0; k < order.size(); ++k)
    number[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  for (auto& cell : result.cells)
    for (int& node : cell) node = number[static_cast<std::size_t>(node)];
  std::stable_sort(result.cells.begin(), result.cells.end(),
                   [&](const Cell<2>& a, const Cell<2>& b) {
                     return before(cell_centre<2>(result.X, a), cell_centre<2>(result.X, b));
                   });
  return result;
}

void smooth(QuadMesh& mesh, const std::vector<Freedom>& freedom, int rounds, double enough,
            const std::function<Vector<2>(const Vector<2>&)>& back) {
  const Links links(mesh);
  for (int round = 0; round < rounds; ++round)
    for (Index q = 0; q < mesh.X.rows(); ++q) {
      const auto node = static_cast<std::size_t>(q);
      if (freedom[node] == Freedom::none) continue;
      const auto& around = freedom[node] == Freedom::inner ? links.neighbours[node]
                                                           : links.boundary_neighbours[node];
      Vector<2> mean = Vector<2>::Zero();
      for (const int other : around) mean += mesh.X.row(other).transpose();
      mean /= static_cast<double>(around.size());
      const Vector<2> here = mesh.X.row(q).transpose();
      if (freedom[node] == Freedom::along_x) mean.y() = here.y();
      if (freedom[node] == Freedom::along_y) mean.x() = here.x();
      if (freedom[node] == Freedom::on_curve) mean = back(mean);
      const double worst = worst_around(mesh, links.cells[node]);
      mesh.X.row(q) = mean.transpose();
      // Nodes gathered in one point of the curve have to part first, whatever that does to corners.
      const bool parting = freedom[node] == Freedom::on_curve && round < 3;
      if (!parting && worst_around(mesh, links.cells[node]) < std::min(worst, enough))
        mesh.X.row(q) = here.transpose();
    }
}

double cell_quality(const VectorField<2>& X, const Cell<2>& cell, double size) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 4; ++k) {
    const auto here = X.row(cell[k]);
    const auto e = X.row(cell[(k + 1) % 4]) - here, f = X.row(cell[(k + 3) % 4]) - here;
    const double jacobian = e(0) * f(1) - e(1) * f(0);
    least = std::min(
        least, jacobian / std::max(std::sqrt(e.squaredNorm() * f.squaredNorm()), size * size));
  }
  return least;
}

void improve(QuadMesh& mesh, const std::vector<Track>& tracks, int rounds, double size,
             double enough) {
  constexpr double steepness = 20.0;
  constexpr double least_gain = 1e-3;
  const Links links(mesh);
  double worst = 0.0;
  const auto badness = [&](std::size_t node) {
    double sum = 0.0;
    worst = 1.0;
    for (const int cell : links.cells[node]) {
      const double quality = cell_quality(mesh.X, mesh.cells[static_cast<std::size_t>(cell)], size);
      worst = std::min(worst, quality);
      sum += std::exp(-steepness * quality);
    }
    return sum;
  };
  // A node is tried again only after one of the cells around it has changed.
  std::vector<char> waits(tracks.size(), 1);
  for (int round = 0; round < rounds; ++round) {
    bool any = false;
    for (std::size_t node = 0; node < tracks.size(); ++node) {
      if (!tracks[node] || !waits[node]) continue;
      waits[node] = 0;
      bool moved = false;
      const auto q = static_cast<Index>(node);
      double least = badness(node);
      if (worst > enough) continue;
      const auto attempt = [&](const Vector<2>& target) {
        const Vector<2> here = mesh.X.row(q).transpose();
        mesh.X.row(q) = tracks[node](target).transpose();
        const double now = badness(node);
        if (now < least * (1.0 - least_gain)) {
          least = now;
          return moved = true;
        }
        mesh.X.row(q) = here.transpose();
        return false;
      };
      Vector<2> mean = Vector<2>::Zero();
      for (const int other : links.neighbours[node]) mean += mesh.X.row(other).transpose();
      attempt(mean / static_cast<double>(links.neighbours[node].size()));
      for (double step = 0.25 * size; step > 0.01 * size; step *= 0.5)
        for (int direction = 0; direction < 8; ++direction) {
          const double angle = 0.25 * std::numbers::pi * direction;
          const Vector<2> by = step * Vector<2>(std::cos(angle), std::sin(angle));
          while (attempt(mesh.X.row(q).transpose() + by)) {
          }
        }
      if (!moved) continue;
      any = true;
      for (const int cell : links.cells[node])
        for (const int other : mesh.cells[static_cast<std::size_t>(cell)])
          waits[static_cast<std::size_t>(other)] = 1;
    }
    if (!any) return;
  }
}

}  // namespace tlsph
