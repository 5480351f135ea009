#include "tlsph/operators/neighbours.hpp"

#include <algorithm>
#include <nanoflann.hpp>
#include <utility>

namespace tlsph {
namespace {

/// What nanoflann wants to know about a cloud of points.
template <int D>
struct Cloud {
  const VectorField<D>& X;
  [[nodiscard]] std::size_t kdtree_get_point_count() const {
    return static_cast<std::size_t>(X.rows());
  }
  [[nodiscard]] double kdtree_get_pt(std::size_t row, std::size_t axis) const {
    return X(static_cast<Index>(row), static_cast<Index>(axis));
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }
};

}  // namespace

template <int D>
Neighbours find_neighbours(const VectorField<D>& points, const VectorField<D>& nodes,
                           double radius) {
  using Distance = nanoflann::L2_Simple_Adaptor<double, Cloud<D>>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Cloud<D>, D, std::uint32_t>;
  const Cloud<D> cloud{nodes};
  const Tree tree(D, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  const double inside = radius * (1.0 - 1e-9);
  const nanoflann::SearchParams unsorted(32, 0.0F, false);

  Neighbours result;
  result.start.reserve(static_cast<std::size_t>(points.rows()) + 1);
  result.start.push_back(0);
  std::vector<std::pair<std::uint32_t, double>> found;
  std::vector<int> row;
  for (Index s = 0; s < points.rows(); ++s) {
    const Vector<D> centre = points.row(s).transpose();
    tree.radiusSearch(centre.data(), inside * inside, found, unsorted);
    row.clear();
    for (const auto& hit : found) row.push_back(static_cast<int>(hit.first));
    std::sort(row.begin(), row.end());
    result.column.insert(result.column.end(), row.begin(), row.end());
    result.start.push_back(static_cast<Index>(result.column.size()));
  }
  return result;
}

template Neighbours find_neighbours<1>(const VectorField<1>&, const VectorField<1>&, double);
template Neighbours find_neighbours<2>(const VectorField<2>&, const VectorField<2>&, double);

}  // namespace tlsph
