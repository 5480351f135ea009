#include "tlsph/operators/neighbours.hpp"

#include <algorithm>
#include <nanoflann.hpp>
#include <numeric>
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

ByColumns by_columns(const Neighbours& pattern, Index columns) {
  ByColumns result;
  std::vector<Index>& start = result.rows.start;
  start.assign(static_cast<std::size_t>(columns) + 1, 0);
  for (const int q : pattern.column) ++start[static_cast<std::size_t>(q) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  result.rows.column.resize(pattern.column.size());
  result.entry.resize(pattern.column.size());
  std::vector<Index> next = start;
  for (Index s = 0; s < pattern.rows(); ++s)
    for (const Index k : pattern.entries(s)) {
      const auto place =
          static_cast<std::size_t>(next[static_cast<std::size_t>(pattern.column_at(k))]++);
      result.rows.column[place] = static_cast<int>(s);
      result.entry[place] = k;
    }
  return result;
}

#define TLSPH_INSTANTIATE(D) \
  template Neighbours find_neighbours<D>(const VectorField<D>&, const VectorField<D>&, double);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)

}  // namespace tlsph
