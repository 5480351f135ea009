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

/// Corners of a cell as steps from the lower one, counter-clockwise; the first two in 1D.
constexpr std::array<std::array<int, 2>, 4> corner_steps = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Corners at the ends of each side of a cell, sides in the order of side_names: those along −x,
/// +x, −y and +y.
template <int D>
constexpr std::array<std::array<std::size_t, D>, 2 * D> side_corners;
template <>
constexpr std::array<std::array<std::size_t, 1>, 2> side_corners<1> = {{{0}, {1}}};
template <>
constexpr std::array<std::array<std::size_t, 2>, 4> side_corners<2> = {
    {{3, 0}, {1, 2}, {0, 1}, {2, 3}}};

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
  std::size_t node_count() const {
    std::size_t count = 1;
    for (const int n : node_frame.counts) count *= static_cast<std::size_t>(n);
    return count;
  }
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

/// Rows of the corners of a cell in the frame of the nodes.
template <int D>
Cell<D> corner_rows(const Raster<D>& raster, int cell) {
  Cell<D> rows{};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    auto corner = raster.cell_frame.coordinates(cell);
    for (std::size_t a = 0; a < D; ++a) corner[a] += corner_steps[k][a];
    rows[k] = raster.node_frame.index(corner);
  }
  return rows;
}

/// Appends the sides of that cell that have no cell of the body beyond them; `nodes` are its
/// corners.
template <int D>
void append_faces(const Raster<D>& raster, int cell, const Cell<D>& nodes,
                  std::vector<LabelledFace<D>>& faces) {
  const auto at = raster.cell_frame.coordinates(cell);
  const Vector<D>& spacing = raster.cell_frame.spacing;
  for (int s = 0; s < 2 * D; ++s) {
    const int axis = s / 2, step = s % 2 == 0 ? -1 : +1;
    auto beyond = at;
    const int position = beyond[static_cast<std::size_t>(axis)] += step;
    const bool on_box =
        position < 0 || position >= raster.cell_frame.counts[static_cast<std::size_t>(axis)];
    const int kind =
        on_box ? off_base : raster.kind[static_cast<std::size_t>(raster.cell_frame.index(beyond))];
    if (kind == in_body) continue;
    Face<D> face{{}, Vector<D>::Zero()};
    face.area(axis) = step * spacing.prod() / spacing(axis);
    for (std::size_t k = 0; k < D; ++k)
      face.nodes[k] = nodes[side_corners<D>[static_cast<std::size_t>(s)][k]];
    LabelledFace<D> labelled{face, on_box ? s : no_side, kind == off_base ? 0 : kind};
    if constexpr (D == 2) {
      Vector<2> middle = raster.centre(at);
      middle(axis) += 0.5 * step * spacing(axis);
      const NamedPiece& edge = raster.names->closest(middle, face.area);
      if (edge.side == s) labelled.side = s;
      labelled.edge = edge.edge;
    }
    faces.push_back(labelled);
  }
}

template <int D>
void fill_on_boundary(const Raster<D>& raster, Particles<D>& particles,
                      std::vector<LabelledFace<D>>& faces) {
  // The corners of the body's cells are numbered in lattice order.
  std::vector<int> number(raster.node_count(), none);
  for (int cell = 0; cell < raster.cells(); ++cell)
    if (raster.inside(cell))
      for (const int row : corner_rows(raster, cell)) number[static_cast<std::size_t>(row)] = 0;
  int count = 0;
  for (int& entry : number)
    if (entry != none) entry = count++;
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
    Cell<D> nodes = corner_rows(raster, cell);
    for (int& node : nodes) {
      node = number[static_cast<std::size_t>(node)];
      particles.V(node) += share;
    }
    particles.cells.push_back(nodes);
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
  set_boundary(particles, faces, holes_of(shape).size());
  if (std::holds_alternative<Box<D>>(shape.form))
    particles.frame = centred ? raster.cell_frame : raster.node_frame;
  return particles;
}

#define TLSPH_INSTANTIATE(D) \
  template Particles<D> make_lattice(const Shape<D>&, double, NodePlacement, const Place&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
