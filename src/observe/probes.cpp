#include "tlsph/observe/probes.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/measures.hpp"

namespace tlsph {
namespace {

/// The measures at H and P, which are interpolated between points: at the boundary extrapolated,
/// perhaps to a compression that the law is not made for. Those of the nearest point stand for it
/// then.
template <int D>
StressMeasures<D> measures_at(const Region<D>& region, const State<D>& state, const Tensor<D>& H,
                              const Tensor<D>& P, Index nearest) {
  if ((Tensor<D>::Identity() + H).determinant() > 0.0) {
    const StressMeasures<D> stress = stress_measures<D>(region, H, P, present(state, nearest));
    if (stress.cauchy.allFinite() && std::isfinite(stress.von_mises)) return stress;
  }
  return stress_measures<D>(region, tensor_at<D>(state.H, nearest), tensor_at<D>(state.P, nearest),
                            present(state, nearest));
}

}  // namespace

template <int D>
Probes<D>::Probes(const Discretisation<D>& body, const std::vector<ProbeRequest<D>>& requests) {
  for (const ProbeRequest<D>& request : requests) {
    Probe probe;
    probe.name = request.name;
    probe.at = request.at;
    try {
      probe.nodes = linear_interpolation<D>(body.particles.X, request.at, body.spacing);
      probe.points = linear_interpolation<D>(body.points.X, request.at, body.spacing);
    } catch (const InputError& error) {
      throw InputError(request.place, error.what());
    }
    const auto heaviest = std::max_element(probe.points.weight.begin(), probe.points.weight.end());
    probe.nearest =
        probe.points.node[static_cast<std::size_t>(heaviest - probe.points.weight.begin())];
    probe.region = region_of<D>(body, probe.nearest);
    for (const std::string& name : request.quantities) {
      const Quantity<D>* const quantity = find_quantity<D>(name);
      if (quantity == nullptr)
        throw InputError(fmt::format("probe \"{}\": no quantity {}", request.name, name));
      probe.quantities.push_back(quantity);
      for (const std::string& suffix : component_suffixes<D>(*quantity))
        columns_.push_back(fmt::format("{}.{}{}", request.name, name, suffix));
    }
    probes_.push_back(std::move(probe));
  }
}

template <int D>
void Probes<D>::sample(const Instant<D>& now, std::span<double> row) const {
  std::size_t out = 0;
  for (const Probe& probe : probes_) {
    Observed<D> seen;
    for (std::size_t k = 0; k < probe.nodes.node.size(); ++k)
      seen.add(probe.nodes.weight[k], observed_particle<D>(now, probe.nodes.node[k]));
    for (std::size_t k = 0; k < probe.points.node.size(); ++k)
      seen.add(probe.points.weight[k], observed_strain<D>(now, probe.points.node[k]));
    seen.stress =
        measures_at<D>(now.body.regions[probe.region], now.state, seen.H, seen.P, probe.nearest);
    for (const Quantity<D>* quantity : probe.quantities)
      for_components<D>(quantity->rank, quantity->symmetric,
                        [&](int i, int j) { row[out++] = quantity->value(seen, i, j); });
  }
  assert(out == row.size());
}

template <int D>
std::vector<std::string> Probes<D>::exact_columns() const {
  std::vector<std::string> columns;
  for (const Probe& probe : probes_)
    for (const Quantity<D>* quantity : probe.quantities)
      if (quantity->exact != nullptr)
        for (const std::string& suffix : component_suffixes<D>(*quantity))
          columns.push_back(fmt::format("{}.{}{}", probe.name, quantity->name, suffix));
  return columns;
}

template <int D>
void Probes<D>::sample_exact(const ExactSolution<D>& exact, double time,
                             std::span<double> row) const {
  std::size_t out = 0;
  for (const Probe& probe : probes_)
    for (const Quantity<D>* quantity : probe.quantities)
      if (quantity->exact != nullptr)
        for_components<D>(quantity->rank, quantity->symmetric, [&](int i, int j) {
          row[out++] = quantity->exact(exact, probe.at, time, i, j);
        });
}

template <int D>
std::vector<Index> Probes<D>::nodes() const {
  std::vector<Index> all;
  for (const Probe& probe : probes_)
    all.insert(all.end(), probe.nodes.node.begin(), probe.nodes.node.end());
  return all;
}

template <int D>
std::vector<Index> Probes<D>::points() const {
  std::vector<Index> all;
  for (const Probe& probe : probes_)
    all.insert(all.end(), probe.points.node.begin(), probe.points.node.end());
  return all;
}

template class Probes<1>;
template class Probes<2>;

}  // namespace tlsph
