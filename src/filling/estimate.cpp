#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/region.hpp"

namespace tlsph {

template <int D>
double lattice_size_estimate(const Shape<D>& shape, double spacing, NodePlacement placement,
                             const Place& place) {
  validate(shape, place);
  if (!(spacing > 0.0))
    throw InputError(place, fmt::format("spacing must be greater than 0, not {}", spacing));
  const double more = placement == NodePlacement::on_boundary ? 1.0 : 0.0;
  if (const auto* box = std::get_if<Box<D>>(&shape.form)) {
    double nodes = 1.0;
    for (int a = 0; a < D; ++a)
      nodes *= std::max(1.0, std::round((box->upper(a) - box->lower(a)) / spacing)) + more;
    return nodes;
  }
  // Lattice polygons have exactly that many nodes (Pick's theorem, one hole fewer or more apart).
  return area(shape) / std::pow(spacing, D) +
         more * (boundary_measure(shape) / (2.0 * spacing) + 1.0);
}

template double lattice_size_estimate(const Shape<1>&, double, NodePlacement, const Place&);
template double lattice_size_estimate(const Shape<2>&, double, NodePlacement, const Place&);

}  // namespace tlsph
