#include "tlsph/filling/division.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

constexpr double largest_change = 0.01;
constexpr const char* axis_names[] = {"x", "y", "z"};

double whole_cells(double length, double spacing) {
  return std::max(1.0, std::round(length / spacing));
}

/// Share by which the spacing changes when the length is divided into whole cells.
double change(double length, double spacing) {
  return std::abs(length / whole_cells(length, spacing) / spacing - 1.0);
}

template <int D>
bool fits(const Vector<D>& lengths, double spacing) {
  for (int a = 0; a < D; ++a)
    if (change(lengths(a), spacing) > largest_change) return false;
  return true;
}

/// The whole division of one of the lengths that fits all of them and is closest to the spacing.
/// There is one within a few hundred cells: beyond 50 cells per length everything fits.
template <int D>
double nearest_fit(const Vector<D>& lengths, double spacing) {
  double best = std::numeric_limits<double>::infinity();
  for (int a = 0; a < D; ++a) {
    const double middle = whole_cells(lengths(a), spacing);
    for (double n = std::max(1.0, middle - 1000.0); n <= middle + 1000.0; n += 1.0) {
      const double candidate = lengths(a) / n;
      if (fits(lengths, candidate) && std::abs(candidate - spacing) < std::abs(best - spacing))
        best = candidate;
    }
  }
  return best;
}

}  // namespace

template <int D>
Vector<D> Division<D>::spacing() const {
  Vector<D> result = box.upper - box.lower;
  for (int a = 0; a < D; ++a) result(a) /= cells[static_cast<std::size_t>(a)];
  return result;
}

template <int D>
double Division<D>::line(int a, int i) const {
  const int n = cells[static_cast<std::size_t>(a)];
  if (i == n) return box.upper(a);
  return box.lower(a) + (box.upper(a) - box.lower(a)) * i / n;
}

template <int D>
Division<D> divide(const Box<D>& box, double spacing, const Place& place) {
  if (!(spacing > 0.0) || !std::isfinite(spacing))
    throw InputError(place, fmt::format("spacing must be greater than 0, not {}", spacing));
  const Vector<D> lengths = box.upper - box.lower;
  double nodes = 1.0;
  for (int a = 0; a < D; ++a) {
    const double n = whole_cells(lengths(a), spacing);
    nodes *= n + 1.0;
    if (change(lengths(a), spacing) <= largest_change) continue;
    throw InputError(
        place, fmt::format("spacing {:.6g} does not divide the body: along {} (length {:.6g}) the "
                           "nearest division is {} x {:.6g}, a change of {:.2g} % where 1 % is "
                           "allowed; the nearest spacing that fits is {:.6g}",
                           spacing, axis_names[a], lengths(a), n, lengths(a) / n,
                           100.0 * change(lengths(a), spacing), nearest_fit(lengths, spacing)));
  }
  if (nodes > std::numeric_limits<int>::max())
    throw InputError(place, fmt::format("spacing {:.6g} asks for {:.3g} particles, more than the "
                                        "{} that can be numbered; choose a larger one",
                                        spacing, nodes, std::numeric_limits<int>::max()));
  Division<D> division{box, {}};
  for (int a = 0; a < D; ++a)
    division.cells[static_cast<std::size_t>(a)] =
        static_cast<int>(whole_cells(lengths(a), spacing));
  return division;
}

bool divides(const Box<2>& box, double spacing) {
  return fits<2>(box.upper - box.lower, spacing);
}

template <int D>
double lattice_size_estimate(const Shape<D>& shape, double spacing, NodePlacement placement,
                             const Place& place) {
  validate(shape, place);
  if (!(spacing > 0.0))
    throw InputError(place, fmt::format("spacing must be greater than 0, not {}", spacing));
  const double more = placement == NodePlacement::on_boundary ? 1.0 : 0.0;
  if (const auto* box = std::get_if<Box<D>>(&shape.form)) {
    double nodes = 1.0;
    for (int a = 0; a < D; ++a) nodes *= whole_cells(box->upper(a) - box->lower(a), spacing) + more;
    return nodes;
  }
  // Lattice polygons have exactly that many nodes (Pick's theorem, one hole fewer or more apart).
  return area(shape) / std::pow(spacing, D) +
         more * (boundary_measure(shape) / (2.0 * spacing) + 1.0);
}

#define TLSPH_INSTANTIATE(D)                                        \
  template struct Division<D>;                                      \
  template Division<D> divide(const Box<D>&, double, const Place&); \
  template double lattice_size_estimate(const Shape<D>&, double, NodePlacement, const Place&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
