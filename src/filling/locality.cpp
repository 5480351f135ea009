#include "tlsph/filling/locality.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tlsph {
namespace {

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

template std::vector<int> local_order<1>(const VectorField<1>&);
template std::vector<int> local_order<2>(const VectorField<2>&);

}  // namespace tlsph
