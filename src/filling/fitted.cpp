#include "tlsph/filling/fitted.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "outline_sections.hpp"
#include "quad_mesh.hpp"
#include "tlsph/filling/division.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

/// Distance that core nodes keep from the curve, in spacings: the layer is 0.8 to
/// about 2.2 thick before the smoothing. Of 0.4 … 0.8 this gave the best worst corners.
constexpr double clearance = 0.8;
/// Of every cell (`cell_quality`): no corner Jacobian below that share of Δ², nor sine of a corner
/// below it.
constexpr double least_quality = 0.1;
/// In spacings: longer cells of a layer leave sharp corners to too few nodes.
constexpr double largest_edge = 4.0;
/// Moves that leave at least this share of the lattice's Jacobian are always allowed.
constexpr double enough_share = 0.6;
constexpr int smoothing_rounds = 20;
/// Nodes that many edges from the curve take part in the smoothing.
constexpr int smoothed_rings = 3;

/// Cells of the lattice far enough from the curve, without corners where two cells touch in a
/// point.
std::vector<Cell<2>> core_cells(const Particles<2>& lattice, const SplitOutline& boundary) {
  std::vector<char> near(static_cast<std::size_t>(lattice.size()));
  for (Index q = 0; q < lattice.size(); ++q)
    near[static_cast<std::size_t>(q)] =
        boundary.distance_to_curve(lattice.X.row(q).transpose()) < clearance * lattice.spacing;
  std::vector<Cell<2>> core;
  const auto clear = [&](int node) { return !near[static_cast<std::size_t>(node)]; };
  std::copy_if(lattice.cells.begin(), lattice.cells.end(), std::back_inserter(core),
               [&](const auto& cell) { return std::all_of(cell.begin(), cell.end(), clear); });
  for (;;) {
    std::map<int, int> starts;
    for (const auto& [from, to] : free_edges(core)) ++starts[from];
    const auto pinched = [&](int node) {
      const auto found = starts.find(node);
      return found != starts.end() && found->second > 1;
    };
    if (std::erase_if(core, [&](const auto& cell) {
          return std::any_of(cell.begin(), cell.end(), pinched);
        }) == 0)
      return core;
  }
}

/// The nodes added on the curve.
struct Layer {
  std::vector<int> nodes;
  std::set<int> pinned;  ///< those on kinks
};

/// Joins the core to the curve by one layer of cells; nothing where a wall ends without meeting the
/// curve: it bounds a gap narrower than the layer.
std::optional<Layer> add_layer(QuadMesh& mesh, const SplitOutline& boundary) {
  std::vector<DirectedEdge> front;
  std::set<int> wall;  // nodes on straight pieces that stay boundary
  for (const auto& edge : free_edges(mesh.cells)) {
    const Vector<2> a = mesh.X.row(edge[0]).transpose(), b = mesh.X.row(edge[1]).transpose();
    if (boundary.on_straight(a) && boundary.on_straight(b) && boundary.on_straight(0.5 * (a + b)))
      wall.insert({edge[0], edge[1]});
    else
      front.push_back(edge);
  }
  if (front.empty()) return {};
  std::map<int, int> partner;
  int count = static_cast<int>(mesh.X.rows());
  for (const auto& edge : front)
    for (const int node : edge)
      if (partner.try_emplace(node, count).second) ++count;
  mesh.X.conservativeResize(count, Eigen::NoChange);

  Layer layer;
  for (const auto& [node, outer] : partner) {
    const Vector<2> x = mesh.X.row(node).transpose();
    const auto place =
        wall.contains(node) ? boundary.junction(x) : std::optional(boundary.closest_on_curve(x));
    if (!place) return {};
    mesh.X.row(outer) = place->transpose();
    layer.nodes.push_back(outer);
  }
  for (const auto& kink : boundary.kinks()) {
    // Of the partners closest to the kink (all that a re-entrant corner collects), that of the
    // closest front node takes it; the others slide away while the mesh is smoothed.
    const auto distance = [&](const auto& pair) {
      return (mesh.X.row(pair.second).transpose() - kink).norm() +
             1e-3 * (mesh.X.row(pair.first).transpose() - kink).norm();
    };
    const auto closest =
        std::min_element(partner.begin(), partner.end(),
                         [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    mesh.X.row(closest->second) = kink.transpose();
    layer.pinned.insert(closest->second);
  }
  for (const auto& [from, to] : front)
    mesh.cells.push_back({to, from, partner.at(from), partner.at(to)});
  return layer;
}

/// What each node may do: those within a few rings of the curve move, the others stay.
std::vector<Freedom> freedoms(const QuadMesh& mesh, const SplitOutline& boundary,
                              const Layer& layer) {
  std::vector<int> ring(static_cast<std::size_t>(mesh.X.rows()), smoothed_rings + 1);
  for (const int node : layer.nodes) ring[static_cast<std::size_t>(node)] = 0;
  count_rings(mesh.cells, smoothed_rings, ring);
  std::vector<Freedom> result(ring.size(), Freedom::none);
  for (std::size_t q = 0; q < ring.size(); ++q)
    if (ring[q] <= smoothed_rings) result[q] = Freedom::inner;
  std::map<int, std::array<bool, 2>> lines;  // does a wall along x, y pass through the node
  for (const auto& edge : free_edges(mesh.cells))
    for (const int node : edge) {
      const auto q = static_cast<std::size_t>(node);
      const Vector<2> x = mesh.X.row(node).transpose();
      const Vector<2> along = (mesh.X.row(edge[1]) - mesh.X.row(edge[0])).transpose();
      if (boundary.on_straight(x)) {
        lines[node][std::abs(along.x()) > std::abs(along.y()) ? 0 : 1] = true;
        const bool corner = (lines[node][0] && lines[node][1]) || ring[q] == 0;
        const bool moves = !corner && ring[q] <= smoothed_rings;
        result[q] = !moves ? Freedom::none : lines[node][0] ? Freedom::along_x : Freedom::along_y;
      } else {
        result[q] = layer.pinned.contains(node) ? Freedom::none : Freedom::on_curve;
      }
    }
  return result;
}

/// Does an edge of the mesh's boundary run across a gap between two curves or the root of a part
/// too thin for the lattice, instead of along the shape's boundary?
bool has_stray_edge(const QuadMesh& mesh, const SplitOutline& boundary) {
  return std::ranges::any_of(free_edges(mesh.cells), [&](const DirectedEdge& edge) {
    const Vector<2> a = mesh.X.row(edge[0]).transpose(), b = mesh.X.row(edge[1]).transpose();
    return boundary.normal(0.5 * (a + b)).dot(face_area(a, b)) < 0.5 * (b - a).norm();
  });
}

/// Is a corner no node, or has another point of the outline no boundary node within two spacings:
/// is a part of the body without core cells lost?
bool forgets_a_point(const QuadMesh& mesh, const SplitOutline& boundary, double spacing) {
  std::set<int> nodes;
  for (const auto& edge : free_edges(mesh.cells)) nodes.insert(edge.begin(), edge.end());
  const auto far_from = [&](double distance) {
    return [&nodes, &mesh, distance](const Vector<2>& point) {
      return std::ranges::none_of(nodes, [&](int node) {
        return (mesh.X.row(node).transpose() - point).norm() <= distance;
      });
    };
  };
  return std::ranges::any_of(boundary.corners(), far_from(boundary.tolerance())) ||
         std::ranges::any_of(boundary.samples(spacing), far_from(2.0 * spacing));
}

double longest_edge(const QuadMesh& mesh) {
  double longest = 0.0;
  for (const auto& cell : mesh.cells)
    for (std::size_t k = 0; k < 4; ++k)
      longest = std::max(longest, (mesh.X.row(cell[k]) - mesh.X.row(cell[(k + 1) % 4])).norm());
  return longest;
}

/// The lattice's own cells up to a layer of others that joins them to the curve; nothing where the
/// layer does not fit.
std::optional<QuadMesh> layered(const Particles<2>& lattice, const SplitOutline& boundary) {
  QuadMesh mesh{lattice.X, core_cells(lattice, boundary)};
  if (mesh.cells.empty()) return {};
  const std::optional<Layer> layer = add_layer(mesh, boundary);
  if (!layer) return {};
  const double jacobian = lattice.spacings.prod();
  smooth(mesh, freedoms(mesh, boundary, *layer), smoothing_rounds, enough_share * jacobian,
         [&](const Vector<2>& x) { return boundary.closest_on_curve(x); });
  if (has_stray_edge(mesh, boundary) || forgets_a_point(mesh, boundary, lattice.spacing) ||
      longest_edge(mesh) > largest_edge * lattice.spacing)
    return {};
  for (const auto& cell : mesh.cells)
    if (cell_quality(mesh.X, cell, lattice.spacing) < least_quality) return {};
  return mesh;
}

QuadMesh blocks(const Shape<2>& shape, double spacing, const Place& place) {
  BlockFill fill = fill_with_blocks(shape, spacing);
  if (fill.quality < least_quality)
    throw InputError(
        place,
        fmt::format("spacing {:.6g} is too coarse to follow the boundary near ({:.6g}, {:.6g}): "
                    "the cells there have a quality of {:.2g}, allowed: at least {}; choose a "
                    "finer spacing, body.layout = \"hexagonal\" or body.fit = false",
                    spacing, fill.worst.x(), fill.worst.y(), fill.quality, least_quality));
  return std::move(fill.mesh);
}

Particles<2> as_particles(QuadMesh mesh, const Shape<2>& shape, double spacing,
                          const Vector<2>& spacings) {
  mesh = renumbered(mesh, bounding_box(shape).lower.x(), spacings.x());
  Particles<2> particles;
  particles.spacing = spacing;
  particles.spacings = spacings;
  particles.V = node_volumes<2>(mesh.X, mesh.cells);
  particles.X = std::move(mesh.X);
  const OutlineNames names(shape);
  std::vector<LabelledFace<2>> faces;
  for (const auto& [from, to] : free_edges(mesh.cells))
    faces.push_back(names.labelled(particles.X, from, to, 1e-8 * spacings.minCoeff()));
  set_boundary(particles, faces, holes_of(shape).size());
  particles.cells = std::move(mesh.cells);
  return particles;
}

}  // namespace

Particles<2> fitted(const Particles<2>& lattice, const Shape<2>& shape, const Place& place) {
  if (lattice.cells.empty())
    throw InputError(place, "only a lattice with nodes on the boundary can be fitted to it");
  const SplitOutline boundary(lattice, shape);
  if (!boundary.has_curve()) return lattice;
  std::optional<QuadMesh> mesh = layered(lattice, boundary);
  if (!mesh) mesh = blocks(shape, lattice.spacing, place);
  return as_particles(std::move(*mesh), shape, lattice.spacing, lattice.spacings);
}

Particles<2> fitted(const Shape<2>& shape, double spacing, const Place& place) {
  validate(shape, place);
  const bool positive = spacing > 0.0 && std::isfinite(spacing);  // else the lattice refuses it
  if (!positive || std::holds_alternative<Box<2>>(base_of(shape).form) ||
      divides(bounding_box(shape), spacing))
    return fitted(make_lattice(shape, spacing, NodePlacement::on_boundary, place), shape, place);
  return as_particles(blocks(shape, spacing, place), shape, spacing, Vector<2>::Constant(spacing));
}

}  // namespace tlsph
