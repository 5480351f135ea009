#include "tlsph/filling/lattice.hpp"

#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tlsph/filling/division.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"

namespace tlsph {
namespace {

/// One side of a cell: the step to its neighbour and the cell corners at its ends.
template <int D>
struct Side {
  std::size_t axis;
  int step;
  std::array<std::size_t, D> corners;
};

template <int D>
struct CellGeometry;  // corners as steps from the lower one, counter-clockwise; sides in the order
                      // of side_names

template <>
struct CellGeometry<1> {
  static constexpr std::array<std::array<int, 1>, 2> corners = {{{0}, {1}}};
  static constexpr std::array<Side<1>, 2> sides = {{{0, -1, {0}}, {0, +1, {1}}}};
};

template <>
struct CellGeometry<2> {
  static constexpr std::array<std::array<int, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  static constexpr std::array<Side<2>, 4> sides = {
      {{0, -1, {3, 0}}, {0, +1, {1, 2}}, {1, -1, {0, 1}}, {1, +1, {2, 3}}}};
};

constexpr int in_body = 0;    // a cell of the body; k ≥ 1: cut away by hole k
constexpr int off_base = -1;  // outside the base
constexpr int none = -1;      // no node here

/// The lattice over the bounding box, and what each of its cells is.
template <int D>
struct Raster {
  Division<D> division;
  LatticeFrame<D> cell_frame, node_frame;
  std::vector<int> kind;                   // per cell
  std::optional<OutlineNames> names = {};  // in 2D

  Vector<D> centre(const std::array<int, D>& at) const {
    Vector<D> x;
    for (int a = 0; a < D; ++a) {
      const int i = at[static_cast<std::size_t>(a)];
      x(a) = 0.5 * (division.line(a, i) + division.line(a, i + 1));
    }
    return x;
  }
  int cells() const { return static_cast<int>(kind.size()); }
  bool inside(int cell) const { return kind[static_cast<std::size_t>(cell)] == in_body; }
};

template <int D>
Raster<D> rasterise(const Shape<D>& shape, double spacing, const Place& place) {
  const Division<D> division = divide(bounding_box(shape), spacing, place);
  Raster<D> raster{division, {}, {}, {}};
  raster.cell_frame = {division.box.lower + 0.5 * division.spacing(), division.spacing(),
                       division.cells};
  raster.node_frame = {division.box.lower, division.spacing(), division.cells};
  std::size_t total = 1;
  for (std::size_t a = 0; a < D; ++a) {
    ++raster.node_frame.counts[a];
    total *= static_cast<std::size_t>(division.cells[a]);
  }
  raster.kind.assign(total, in_body);
  if constexpr (D == 2) raster.names.emplace(shape);

  const Shape<D> base = base_of(shape);
  const std::vector<Shape<D>> holes = holes_of(shape);
  const double tolerance = 1e-10 * (division.box.upper - division.box.lower).norm();
  std::vector<char> cuts(holes.size(), 0);
  bool any = false;
  for (int cell = 0; cell < raster.cells(); ++cell) {
    const Vector<D> x = raster.centre(raster.cell_frame.coordinates(cell));
    int& kind = raster.kind[static_cast<std::size_t>(cell)];
    if (depth(base, x) < -tolerance) {
      kind = off_base;
      continue;
    }
    for (std::size_t k = holes.size(); k-- > 0;) {
      if (depth(holes[k], x) <= tolerance) continue;
      kind = static_cast<int>(k) + 1;
      cuts[k] = 1;
    }
    any = any || kind == in_body;
  }
  if (!any)
    throw InputError(place,
                     fmt::format("no cell of the lattice lies in the body; spacing {:.6g} is "
                                 "too coarse for it",
                                 spacing));
  for (std::size_t k = 0; k < holes.size(); ++k)
    if (!cuts[k])
      throw InputError(place,
                       fmt::format("hole {} is lost between the cells of the lattice; spacing "
                                   "{:.6g} is too coarse for it",
                                   k + 1, spacing));
  return raster;
}

/// Numbers the corners of the body's cells, in lattice order; `none` elsewhere.
template <int D>
std::vector<int> number_nodes(const Raster<D>& raster, int& count) {
  std::size_t total = 1;
  for (const int n : raster.node_frame.counts) total *= static_cast<std::size_t>(n);
  std::vector<int> number(total, none);
  for (int cell = 0; cell < raster.cells(); ++cell) {
    if (!raster.inside(cell)) continue;
    const auto at = raster.cell_frame.coordinates(cell);
    for (const auto& step : CellGeometry<D>::corners) {
      auto corner = at;
      for (std::size_t a = 0; a < D; ++a) corner[a] += step[a];
      number[static_cast<std::size_t>(raster.node_frame.index(corner))] = 0;
    }
  }
  count = 0;
  for (int& entry : number)
    if (entry != none) entry = count++;
  return number;
}

template <int D>
Cell<D> corners_of(const Raster<D>& raster, const std::vector<int>& number, int cell) {
  const auto at = raster.cell_frame.coordinates(cell);
  Cell<D> nodes{};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    auto corner = at;
    for (std::size_t a = 0; a < D; ++a) corner[a] += CellGeometry<D>::corners[k][a];
    nodes[k] = number[static_cast<std::size_t>(raster.node_frame.index(corner))];
  }
  return nodes;
}

/// Outward area vector of a side of any cell: ±1 in 1D, length of the edge in 2D.
template <int D>
Vector<D> side_area(const Side<D>& side, const Vector<D>& spacing) {
  Vector<D> area = Vector<D>::Zero();
  const auto axis = static_cast<int>(side.axis);
  area(axis) = side.step * spacing.prod() / spacing(axis);
  return area;
}

/// Appends the sides of that cell that have no cell of the body beyond them; `nodes` are its
/// corners.
template <int D>
void append_faces(const Raster<D>& raster, int cell, const Cell<D>& nodes,
                  std::vector<LabelledFace<D>>& faces) {
  const auto at = raster.cell_frame.coordinates(cell);
  for (std::size_t s = 0; s < 2 * D; ++s) {
    const auto& side = CellGeometry<D>::sides[s];
    auto beyond = at;
    beyond[side.axis] += side.step;
    const bool on_box =
        beyond[side.axis] < 0 || beyond[side.axis] >= raster.cell_frame.counts[side.axis];
    const int kind =
        on_box ? off_base : raster.kind[static_cast<std::size_t>(raster.cell_frame.index(beyond))];
    if (kind == in_body) continue;
    Face<D> face{{}, side_area<D>(side, raster.cell_frame.spacing)};
    for (std::size_t k = 0; k < D; ++k) face.nodes[k] = nodes[side.corners[k]];
    LabelledFace<D> labelled{face, on_box ? static_cast<int>(s) : no_side,
                             kind == off_base ? 0 : kind};
    if constexpr (D == 2) {
      Vector<2> middle = raster.centre(at);
      const auto axis = static_cast<int>(side.axis);
      middle(axis) += 0.5 * side.step * raster.cell_frame.spacing(axis);
      const NamedPiece& edge = raster.names->closest(middle, face.area);
      if (edge.side == static_cast<int>(s)) labelled.side = edge.side;
      labelled.edge = edge.edge;
    }
    faces.push_back(labelled);
  }
}

template <int D>
void fill_on_boundary(const Raster<D>& raster, Particles<D>& particles,
                      std::vector<LabelledFace<D>>& faces) {
  int count = 0;
  const std::vector<int> number = number_nodes(raster, count);
  particles.X.resize(count, D);
  particles.V = ScalarField::Zero(count);
  for (std::size_t row = 0; row < number.size(); ++row) {
    if (number[row] == none) continue;
    const auto at = raster.node_frame.coordinates(static_cast<int>(row));
    for (int a = 0; a < D; ++a)
      particles.X(number[row], a) = raster.division.line(a, at[static_cast<std::size_t>(a)]);
  }
  const double share = particles.spacings.prod() / (1 << D);
  particles.cells.reserve(static_cast<std::size_t>(count));
  for (int cell = 0; cell < raster.cells(); ++cell) {
    if (!raster.inside(cell)) continue;
    const Cell<D> nodes = corners_of(raster, number, cell);
    particles.cells.push_back(nodes);
    for (const int node : nodes) particles.V(node) += share;
    append_faces(raster, cell, nodes, faces);
  }
}

template <int D>
void fill_cell_centred(const Raster<D>& raster, Particles<D>& particles,
                       std::vector<LabelledFace<D>>& faces) {
  int count = 0;
  for (int cell = 0; cell < raster.cells(); ++cell) count += raster.inside(cell);
  particles.X.resize(count, D);
  particles.V = ScalarField::Constant(count, particles.spacings.prod());
  int node = 0;
  for (int cell = 0; cell < raster.cells(); ++cell) {
    if (!raster.inside(cell)) continue;
    particles.X.row(node) = raster.centre(raster.cell_frame.coordinates(cell)).transpose();
    Cell<D> itself;
    itself.fill(node++);
    append_faces(raster, cell, itself, faces);
  }
}

}  // namespace

template <int D>
Particles<D> make_lattice(const Shape<D>& shape, double spacing, NodePlacement placement,
                          const Place& place) {
  validate(shape, place);
  const Raster<D> raster = rasterise(shape, spacing, place);
  Particles<D> particles;
  particles.placement = placement;
  particles.spacings = raster.cell_frame.spacing;
  particles.spacing = D == 1 ? particles.spacings(0) : std::sqrt(particles.spacings.prod());

  const bool centred = placement == NodePlacement::cell_centred;
  std::vector<LabelledFace<D>> faces;
  if (centred)
    fill_cell_centred(raster, particles, faces);
  else
    fill_on_boundary(raster, particles, faces);
  particles.patches = make_patches(faces, holes_of(shape).size());
  particles.edges = make_edges(faces);
  particles.B = lumped_areas<D>(particles.size(), particles.find("boundary")->faces);
  if (std::holds_alternative<Box<D>>(shape.form))
    particles.frame = centred ? raster.cell_frame : raster.node_frame;
  return particles;
}

template Particles<1> make_lattice(const Shape<1>&, double, NodePlacement, const Place&);
template Particles<2> make_lattice(const Shape<2>&, double, NodePlacement, const Place&);

}  // namespace tlsph
