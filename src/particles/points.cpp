#include "tlsph/particles/points.hpp"

#include "tlsph/core/error.hpp"
#include "tlsph/particles/cells.hpp"

namespace tlsph {

template <int D>
MaterialPoints<D> cell_points(const Particles<D>& particles) {
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
