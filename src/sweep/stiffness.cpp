#include "stiffness.hpp"

#include <algorithm>
#include <utility>

namespace tlsph::sweep {

template <int D>
BlockWeights Stiffness<D>::table() const {
  return {stencil_start.data(), offset.data(), weight.data(), mixed.data(), reach.data()};
}

template <int D>
double Stiffness<D>::bytes() const {
  return static_cast<double>((runs.size() + patches.size()) * sizeof(RowRun) +
                             offset.size() * sizeof(int) + weight.size() * sizeof(double));
}

template <int D>
Dependences Stiffness<D>::dependences() const {
  Dependences dep;
  dep.nodes = runs.empty() ? 0 : runs.back().first + runs.back().count;
  const auto n = static_cast<std::size_t>(dep.nodes);
  dep.divergence_low.assign(n, 0);
  dep.divergence_high.assign(n, -1);
  dep.point_readers.assign(n, -1);
  dep.rows_low.assign(n, static_cast<int>(n));
  dep.rows_high.assign(n, 0);
  dep.row_readers.assign(n, -1);
  const auto at_least = [](int& value, int other) { value = std::max(value, other); };
  for (const auto* list : {&runs, &patches})
    for (const RowRun& run : *list) {
      const auto s = static_cast<std::size_t>(run.stencil);
      const auto first = offset.begin() + stencil_start[s];
      const auto last = offset.begin() + stencil_start[s + 1];
      const int low = first == last ? 0 : std::min(0, *std::min_element(first, last));
      for (int q = run.first; q < run.first + run.count; ++q) {
        const auto row = static_cast<std::size_t>(q);
        dep.rows_low[row] = std::min(dep.rows_low[row], q + low);
        at_least(dep.rows_high[row], q + reach[s]);
        at_least(dep.row_readers[row], q);
        for (auto at = first; at != last; ++at)
          at_least(dep.row_readers[static_cast<std::size_t>(Index{q} + *at)], q);
      }
    }
  return dep;
}

template <int D>
void Stiffness<D>::run_on() {
  constexpr int most_between = 4;
  std::vector<RowRun> joined;
  for (std::size_t k = 0; k < runs.size();) {
    RowRun run = runs[k++];
    for (std::size_t next = k; next < runs.size();) {
      const int between = runs[next].first - (run.first + run.count);
      if (between > most_between) break;
      if (runs[next].stencil != run.stencil || runs[next].count < between) {
        ++next;
        continue;
      }
      patches.insert(patches.end(), runs.begin() + static_cast<Index>(k),
                     runs.begin() + static_cast<Index>(next));
      run.count = runs[next].first + runs[next].count - run.first;
      k = ++next;
    }
    joined.push_back(run);
  }
  runs = std::move(joined);
}

template <int D>
double work_of_points(const Discretisation<D>& disc) {
  constexpr double law = D == 1 ? 1.0 : 6.0;
  const double directions = disc.hourglass.empty() ? D : D + 1;
  const auto gradient = static_cast<double>(disc.gradient.nonzeros());
  const auto divergence = static_cast<double>(disc.divergence.nonzeros());
  const auto points = static_cast<double>(disc.points.size());
  const auto pairs = static_cast<double>(disc.stiffness.nonZeros());
  const double rows = pairs > 0.0 ? 3.0 * static_cast<double>(disc.nodes()) : 0.0;
  return (gradient * (1.0 + directions) * D + points * (directions * D + law) +
          divergence * 2.0 * directions * D + (3.0 * pairs + rows) * D) /
         static_cast<double>(disc.nodes());
}

#define TLSPH_INSTANTIATE(D)    \
  template struct Stiffness<D>; \
  template double work_of_points<D>(const Discretisation<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph::sweep
