#include "tlsph/filling/cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

constexpr double largest_volume_error = 0.01;

template <int D>
void refuse_repeats(const VectorField<D>& X, double least, const NodePlaces& places) {
  const std::vector<int> order = by_place<D>(X);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (X(order[j], 0) - X(order[i], 0) > least) break;
      if ((X.row(order[j]) - X.row(order[i])).norm() > least) continue;
      const auto [first, second] = std::minmax(order[i], order[j]);
      const Place place = places(first);
      throw InputError(places(second),
                       fmt::format("the point {} stands where {} does{}; one of them must go",
                                   position_text(X.row(second).transpose()),
                                   position_text(X.row(first).transpose()),
                                   place.line > 0 ? fmt::format(", on line {}", place.line) : ""));
    }
}

/// Distance [m] of neighbours in the square lattice that fills the shape with as many nodes, of
/// which so many lie on the boundary.
double square_spacing(const Shape<2>& shape, Index nodes, std::size_t on_boundary) {
  // Pick's theorem: so many cells has a lattice with these nodes.
  const double cells = static_cast<double>(nodes) - 0.5 * static_cast<double>(on_boundary) - 1.0;
  return std::sqrt(area(shape) / std::max(1.0, cells));
}

/// Faces much longer than the distance of the nodes beside them: the boundary was forgotten.
void refuse_long_faces(const VectorField<2>& X, const std::vector<Triangle>& triangles,
                       const NodePlaces& places) {
  constexpr double least_cosine = -0.866;  // 150° at the node beside the face
  for (const TriangleEdge& edge : edges_of(triangles)) {
    if (edge.right >= 0) continue;
    const Vector<2> u = (X.row(edge.a) - X.row(edge.left)).transpose();
    const Vector<2> v = (X.row(edge.b) - X.row(edge.left)).transpose();
    if (u.dot(v) < least_cosine * u.norm() * v.norm())
      throw InputError(places(edge.a),
                       fmt::format("too few points on the boundary: the next ones, {} and {}, are "
                                   "far apart, seen from {} beside them; add some between",
                                   position_text(X.row(edge.a).transpose()),
                                   position_text(X.row(edge.b).transpose()),
                                   position_text(X.row(edge.left).transpose())));
  }
}

/// Of nodes that fill their bounding box.
template <int D>
double mean_distance(const VectorField<D>& X) {
  const Vector<D> extent = (X.colwise().maxCoeff() - X.colwise().minCoeff()).transpose();
  return std::pow(extent.prod() / static_cast<double>(X.rows()), 1.0 / D);
}

/// Rows of a lattice end, and so do strips: a quarter of the nodes may start anew.
template <int D>
bool is_local(const VectorField<D>& X, double distance) {
  constexpr double near = 3.0;
  Index jumps = 0;
  for (Index q = 1; q < X.rows(); ++q)
    if ((X.row(q) - X.row(q - 1)).norm() > near * distance) ++jumps;
  return 4 * jumps <= X.rows();
}

}  // namespace

template <>
Particles<1> make_cloud(VectorField<1> X, const Shape<1>& shape, double spacing,
                        const NodePlaces& places) {
  if (X.rows() < 2)
    throw InputError(places(0), "a body needs at least two points, one at each end");
  Particles<1> particles;
  particles.spacing = spacing > 0.0 ? spacing : area(shape) / static_cast<double>(X.rows() - 1);
  particles.spacings[0] = particles.spacing;
  const double tolerance = boundary_tolerance * particles.spacing;
  const Box<1> ends = bounding_box(shape);
  for (Index q = 0; q < X.rows(); ++q)
    if (!(depth(shape, Vector<1>(X.row(q).transpose())) >= -tolerance))
      throw InputError(places(q), fmt::format("the point {} lies outside the shape",
                                              position_text(X.row(q).transpose())));
  refuse_repeats<1>(X, tolerance, places);
  const std::vector<int> order = by_place<1>(X);
  std::vector<LabelledFace<1>> faces;
  for (int side = 0; side < 2; ++side) {
    const int node = side == 0 ? order.front() : order.back();
    const double bound = side == 0 ? ends.lower[0] : ends.upper[0];
    if (std::abs(X(node, 0) - bound) > tolerance)
      throw InputError(places(node),
                       fmt::format("the shape ends at {:.6g}, the nearest point is {}; both ends "
                                   "must be points",
                                   bound, position_text(X.row(node).transpose())));
    X(node, 0) = bound;
    faces.push_back({Face<1>{{node}, Vector<1>(side == 0 ? -1.0 : 1.0)}, side});
  }
  for (std::size_t k = 1; k < order.size(); ++k)
    particles.cells.push_back({order[k - 1], order[k]});
  particles.V = node_volumes<1>(X, particles.cells);
  particles.X = std::move(X);
  set_boundary(particles, faces, 0);
  return particles;
}

template <>
Particles<2> make_cloud(VectorField<2> X, const Shape<2>& shape, double spacing,
                        const NodePlaces& places) {
  if (X.rows() < 3) throw InputError(places(0), "a body needs at least three points");
  const double estimate = spacing > 0.0 ? spacing : square_spacing(shape, X.rows(), 0);
  const double tolerance = boundary_tolerance * estimate;
  refuse_repeats<2>(X, tolerance, places);
  const std::vector<LabelledFace<2>> faces = outline_faces(X, shape, tolerance, places);
  Particles<2> particles;
  particles.X = std::move(X);
  set_boundary(particles, faces, holes_of(shape).size());
  const Patch<2>& boundary = *particles.find("boundary");
  particles.triangles = triangulate(particles.X, boundary.faces, places);
  refuse_long_faces(particles.X, particles.triangles, places);
  particles.V = voronoi_volumes(particles.X, boundary.faces);
  particles.spacing =
      spacing > 0.0 ? spacing : square_spacing(shape, particles.size(), boundary.nodes.size());
  particles.spacings.setConstant(particles.spacing);
  return particles;
}

template <int D>
Particles<D> with_volumes(Particles<D> particles, ScalarField V, const Shape<D>& shape,
                          const NodePlaces& places) {
  for (Index q = 0; q < V.size(); ++q)
    if (!(V[q] > 0.0))
      throw InputError(places(q), fmt::format("a volume must be greater than 0, not {:.6g}", V[q]));
  // Either may be meant: the shape, or what the points enclose of it.
  const double sum = V.sum(), whole = area(shape), enclosed = particles.V.sum();
  if (!(sum >= (1.0 - largest_volume_error) * std::min(whole, enclosed)) ||
      !(sum <= (1.0 + largest_volume_error) * std::max(whole, enclosed)))
    throw InputError(places(0), fmt::format("the volumes sum to {:.6g}, but the shape has {:.6g}; "
                                            "they must agree within {:.0f} %, or be left out",
                                            sum, whole, 100.0 * largest_volume_error));
  particles.V = std::move(V);
  return particles;
}

template <int D>
std::vector<int> local_order(const VectorField<D>& X) {
  if (X.rows() < 2) return {};
  const double distance = mean_distance<D>(X);
  if (!(distance > 0.0) || is_local<D>(X, distance)) return {};
  std::vector<double> strip(static_cast<std::size_t>(X.rows()), 0.0);
  if constexpr (D > 1) {
    const double start = X.col(0).minCoeff();
    for (Index q = 0; q < X.rows(); ++q)
      strip[static_cast<std::size_t>(q)] = std::round((X(q, 0) - start) / distance);
  }
  std::vector<int> order(static_cast<std::size_t>(X.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(
      order, {}, [&](int q) { return std::pair(strip[static_cast<std::size_t>(q)], X(q, D - 1)); });
  return order;
}

template <int D>
std::vector<int> by_place(const VectorField<D>& X) {
  std::vector<int> order(static_cast<std::size_t>(X.rows()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](int p, int q) {
    return std::ranges::lexicographical_compare(X.row(p), X.row(q));
  });
  return order;
}

#define TLSPH_INSTANTIATE(D)                                                     \
  template Particles<D> with_volumes(Particles<D>, ScalarField, const Shape<D>&, \
                                     const NodePlaces&);                         \
  template std::vector<int> by_place<D>(const VectorField<D>&);                  \
  template std::vector<int> local_order<D>(const VectorField<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
