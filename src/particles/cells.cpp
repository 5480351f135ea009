#include "tlsph/particles/cells.hpp"

#include <algorithm>

#include "tlsph/geometry/cross.hpp"

namespace tlsph {
namespace {

Vector<2> corner(const VectorField<2>& X, const Cell<2>& cell, std::size_t k) {
  return X.row(cell[k % 4]).transpose();
}

}  // namespace

template <>
double cell_volume(const VectorField<1>& X, const Cell<1>& cell) {
  return X(cell[1]) - X(cell[0]);
}

template <>
double cell_volume(const VectorField<2>& X, const Cell<2>& cell) {
  // Half the cross product of the diagonals: exact for any quadrilateral.
  return 0.5 *
         cross(corner(X, cell, 2) - corner(X, cell, 0), corner(X, cell, 3) - corner(X, cell, 1));
}

template <>
double least_jacobian(const VectorField<1>& X, const Cell<1>& cell) {
  return cell_volume<1>(X, cell);
}

template <>
double least_jacobian(const VectorField<2>& X, const Cell<2>& cell) {
  double least = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector<2> here = corner(X, cell, k);
    const double jacobian = cross(corner(X, cell, k + 1) - here, corner(X, cell, k + 3) - here);
    least = k == 0 ? jacobian : std::min(least, jacobian);
  }
  return least;
}

template <int D>
Vector<D> cell_centre(const VectorField<D>& X, const Cell<D>& cell) {
  Vector<D> sum = Vector<D>::Zero();
  for (const int node : cell) sum += X.row(node).transpose();
  return sum / static_cast<double>(cell.size());
}

template <>
ScalarField node_volumes(const VectorField<1>& X, const std::vector<Cell<1>>& cells) {
  ScalarField V = ScalarField::Zero(X.rows());
  for (const auto& cell : cells)
    for (const int node : cell) V(node) += 0.5 * cell_volume<1>(X, cell);
  return V;
}

template <>
ScalarField node_volumes(const VectorField<2>& X, const std::vector<Cell<2>>& cells) {
  ScalarField V = ScalarField::Zero(X.rows());
  for (const auto& cell : cells) {
    const Vector<2> centre = cell_centre<2>(X, cell);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector<2> here = corner(X, cell, k);
      const Vector<2> next = 0.5 * (here + corner(X, cell, k + 1));
      const Vector<2> last = 0.5 * (here + corner(X, cell, k + 3));
      V(cell[k]) += 0.5 * cross(centre - here, last - next);
    }
  }
  return V;
}

template Vector<1> cell_centre(const VectorField<1>&, const Cell<1>&);
template Vector<2> cell_centre(const VectorField<2>&, const Cell<2>&);

}  // namespace tlsph
