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
PartialEvaluation<D>::PartialEvaluation(const Discretisation<D>& body, std::vector<Index> nodes,
                                        std::vector<Index> points)
    : nodes_(std::move(nodes)), points_(std::move(points)) {
  sort_unique(nodes_);
  for (const Index q : nodes_)
    std::ranges::copy(body.divergence.pattern().of(q), std::back_inserter(points_));
  sort_unique(points_);
  for (const Index s : points_) region_.push_back(region_of<D>(body, s));
  for (std::size_t l = 0; l < body.loads.size(); ++l)
    for (std::size_t k = 0; k < body.loads[l].dof.size(); ++k)
      if (std::ranges::binary_search(nodes_, body.loads[l].dof[k] / D))
        loads_.push_back({l, body.loads[l].dof[k], body.loads[l].weight[k]});
}

template <int D>
void PartialEvaluation<D>::evaluate(const Discretisation<D>& body, State<D>& state) const {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Index s = points_[k];
    body.gradient.gradient_row(s, state.u, state.H);
    Eigen::Map<Tensor<D>>(state.P.data() + s * D * D) =
        pk1<D>(body.regions[region_[k]].law, tensor_at<D>(state.H, s));
  }
  for (const Index q : nodes_) body.divergence.divergence_row(q, state.P, state.f);
  for (const NodeLoad& load : loads_)
    state.f.data()[load.dof] += value(body.loads[load.load].curve, state.time) * load.weight;
  for (const Index q : nodes_) {
    if (body.has_body_force()) state.f.row(q) += body.mass[q] * body.body_force.transpose();
    if (has_stabiliser(body)) state.f.row(q) -= stabiliser_row<D>(body, q, state.u).transpose();
    if (body.viscosity.nonZeros() > 0) {
      state.viscous.row(q) = differences_row<D>(body.viscosity, q, state.v).transpose();
      state.f.row(q) -= state.viscous.row(q);
    }
  }
}

template class PartialEvaluation<1>;
template class PartialEvaluation<2>;

}  // namespace tlsph
