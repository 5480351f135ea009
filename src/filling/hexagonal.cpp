#include "tlsph/filling/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

#include "tlsph/filling/cloud.hpp"
#include "tlsph/filling/division.hpp"
#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/polygon.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// Height of a row in spacings.
const double row_height = 0.5 * std::numbers::sqrt3;
/// Distance inner nodes keep from the boundary, in spacings: the half ones at the ends of the
/// shifted rows of a box stay.
constexpr double row_clearance = 0.45;
/// Boundary nodes stand at least that close, in spacings, or the spacing is too coarse.
constexpr double least_step = 0.4;
constexpr double largest_part = std::numbers::pi / 3.0;
constexpr double smoothed_distance = 2.7;
constexpr int row_rounds = 12;

/// The rows over the bounding box.
struct Rows {
  Box<2> box;
  int columns = 1, count = 1;
  double dx = 0.0, dy = 0.0;

  Rows(const Shape<2>& shape, double spacing, const Place& place) : box(bounding_box(shape)) {
    const Box<1> width{Vector<1>(box.lower.x()), Vector<1>(box.upper.x())};
    columns = divide<1>(width, spacing, place).cells[0];
    const Vector<2> lengths = box.upper - box.lower;
    dx = lengths.x() / columns;
    count = std::max(1, static_cast<int>(std::lround(lengths.y() / (row_height * dx))));
    dy = lengths.y() / count;
  }
  [[nodiscard]] double y(int row) const {
    return row == count ? box.upper.y() : box.lower.y() + row * dy;
  }
  [[nodiscard]] double shift(int row) const { return row % 2 == 0 ? 0.0 : 0.5; }
  [[nodiscard]] double spacing() const { return std::sqrt(dx * dy / row_height); }
  /// Does x lie on a row, at one of its nodes or at its end?
  [[nodiscard]] bool on_lattice(const Vector<2>& x) const {
    const double tolerance = 1e-6 * dx;
    const double row = std::round((x.y() - box.lower.y()) / dy);
    if (std::abs(x.y() - box.lower.y() - row * dy) > tolerance) return false;
    if (std::min(x.x() - box.lower.x(), box.upper.x() - x.x()) < tolerance) return true;
    const double along = (x.x() - box.lower.x()) / dx - shift(static_cast<int>(row));
    return std::abs(along - std::round(along)) * dx < tolerance;
  }
};

bool on_side(const OutlineLoop& section, const Rows& rows) {
  const double tolerance = 1e-9 * rows.dx;
  return section.size() == 1 && !section[0].is_arc() &&
         std::abs(section[0].to.x() - section[0].from.x()) < tolerance &&
         (std::abs(section[0].to.x() - rows.box.lower.x()) < tolerance ||
          std::abs(section[0].to.x() - rows.box.upper.x()) < tolerance);
}

/// Nodes of the section, its end left to the next one.
void divide_section(const OutlineLoop& section, const Rows& rows, const Place& place,
                    std::vector<Vector<2>>& nodes) {
  const double target = on_side(section, rows) ? rows.dy : rows.dx;
  double length = 0.0, parts = 1.0;
  for (const OutlinePiece& piece : section) {
    length += piece.length();
    parts += std::abs(piece.sweep) / largest_part;
  }
  const bool closed = (section.front().from - section.back().to).norm() < 1e-9 * length;
  const double count =
      std::max({1.0, std::round(length / target), std::floor(parts), closed ? 3.0 : 1.0});
  if (length / count < least_step * rows.dx)
    throw InputError(
        place, fmt::format("spacing {:.6g} is too coarse for the edge of length {:.6g} "
                           "at ({:.6g}, {:.6g}); choose a finer one",
                           rows.dx, length, section.front().from.x(), section.front().from.y()));
  for (double k = 0.0; k < count; k += 1.0)
    nodes.push_back(point_along(section, length * k / count));
}

/// Nodes that follow the boundary: those near a part of it that is off the lattice.
std::vector<char> near_curve(const VectorField<2>& X, Index boundary, const Rows& rows) {
  std::vector<char> mark(static_cast<std::size_t>(X.rows()), 0);
  const double reach = smoothed_distance * rows.dx;
  for (Index b = 0; b < boundary; ++b) {
    if (rows.on_lattice(X.row(b).transpose())) continue;
    for (Index q = boundary; q < X.rows(); ++q)
      if ((X.row(q) - X.row(b)).squaredNorm() < reach * reach)
        mark[static_cast<std::size_t>(q)] = 1;
  }
  return mark;
}

/// Moves the marked nodes to the centres of area of the triangles around them, round by round.
void smooth(VectorField<2>& X, const std::vector<char>& marked, const std::vector<Face<2>>& faces,
            const NodePlaces& places) {
  if (std::ranges::count(marked, 0) == std::ssize(marked)) return;
  for (int round = 0; round < row_rounds; ++round) {
    VectorField<2> sum = VectorField<2>::Zero(X.rows(), 2);
    ScalarField weight = ScalarField::Zero(X.rows());
    for (const Triangle& triangle : triangulate(X, faces, places)) {
      const double area = triangle_area(X, triangle);
      const Vector<2> centre = triangle_centre(X, triangle);
      for (const int node : triangle) {
        sum.row(node) += area * centre.transpose();
        weight[node] += area;
      }
    }
    for (Index q = 0; q < X.rows(); ++q)
      if (marked[static_cast<std::size_t>(q)]) X.row(q) = sum.row(q) / weight[q];
  }
}

/// Column by column, y fastest, as nearly as the places of the nodes allow.
VectorField<2> in_columns(const VectorField<2>& X, const Rows& rows) {
  std::vector<Index> order(static_cast<std::size_t>(X.rows()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index q) {
    const double column = std::floor((X(q, 0) - rows.box.lower.x()) / rows.dx + 0.25);
    return std::tuple(column, X(q, 1), X(q, 0));
  });
  return X(order, Eigen::all);
}

}  // namespace

Particles<2> hexagonal_lattice(const Shape<2>& shape, double spacing, const Place& place) {
  validate(shape, place);
  const Rows rows(shape, spacing, place);
  std::vector<Vector<2>> nodes;
  for (const OutlineLoop& loop : outline_loops(shape))
    for (const OutlineLoop& section : sections(loop)) divide_section(section, rows, place, nodes);
  const auto boundary = static_cast<Index>(nodes.size());
  for (int row = 0; row <= rows.count; ++row)
    for (int i = 0; i <= rows.columns; ++i) {
      const Vector<2> x(rows.box.lower.x() + (i + rows.shift(row)) * rows.dx, rows.y(row));
      if (depth(shape, x) > row_clearance * rows.dx) nodes.push_back(x);
    }
  VectorField<2> X = as_rows(nodes);
  const NodePlaces here = [&](Index) { return place; };
  std::vector<Face<2>> faces;
  for (const auto& labelled : outline_faces(X, shape, boundary_tolerance * rows.dx, here))
    faces.push_back(labelled.face);
  smooth(X, near_curve(X, boundary, rows), faces, here);
  return make_cloud<2>(in_columns(X, rows), shape, rows.spacing(), here);
}

}  // namespace tlsph
