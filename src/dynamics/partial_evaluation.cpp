#include "tlsph/dynamics/partial_evaluation.hpp"

#include <algorithm>
#include <iterator>

#include "tlsph/dynamics/measures.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

void sort_unique(std::vector<Index>& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

template <int D>
PartialEvaluation<D>::PartialEvaluation(const Discretisation<D>& disc, std::vector<Index> nodes,
                                        std::vector<Index> points)
    : nodes_(std::move(nodes)), points_(std::move(points)) {
  sort_unique(nodes_);
  for (const Index q : nodes_)
    std::ranges::copy(disc.divergence.pattern().of(q), std::back_inserter(points_));
  sort_unique(points_);
  for (const Index s : points_) region_.push_back(region_of<D>(disc, s));
  for (std::size_t l = 0; l < disc.loads.size(); ++l)
    for (std::size_t k = 0; k < disc.loads[l].dof.size(); ++k)
      if (std::ranges::binary_search(nodes_, disc.loads[l].dof[k] / D))
        loads_.push_back({l, disc.loads[l].dof[k], disc.loads[l].weight[k]});
}

template <int D>
void PartialEvaluation<D>::evaluate(const Discretisation<D>& disc, State<D>& state) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Index s = points_[k];
    disc.gradient.gradient_row(s, state.u, state.H);
    Eigen::Map<Tensor<D>>(state.P.data() + s * D * D) =
        pk1<D>(disc.regions[region_[k]].law, tensor_at<D>(state.H, s));
  }
  for (const Index q : nodes_) disc.divergence.divergence_row(q, state.P, state.f);
  for (const NodeLoad& load : loads_)
    state.f.data()[load.dof] += value(disc.loads[load.load].curve, state.time) * load.weight;
  for (const Index q : nodes_) {
    if (disc.has_body_force()) state.f.row(q) += disc.mass[q] * disc.body_force.transpose();
    if (has_stabiliser(disc)) state.f.row(q) -= stabiliser_row<D>(disc, q, state.u).transpose();
    if (disc.viscosity.nonZeros() > 0) {
      state.viscous.row(q) = differences_row<D>(disc.viscosity, q, state.v).transpose();
      state.f.row(q) -= state.viscous.row(q);
    }
  }
}

template class PartialEvaluation<1>;
template class PartialEvaluation<2>;

}  // namespace tlsph
