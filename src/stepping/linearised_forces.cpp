#include "tlsph/stepping/linearised_forces.hpp"

#include <omp.h>

#include <cmath>

#include "tlsph/core/parallel.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph {
namespace {

/// Nodes of a body for which planning a sweep costs less than it brings.
constexpr Index worth_a_sweep = 10'000;

/// Entries of `inverse_mass` that are not zero, ascending.
template <int D>
std::vector<Index> free_dofs(const Discretisation<D>& body) {
  std::vector<Index> free;
  for (Index dof = 0; dof < body.inverse_mass.size(); ++dof)
    if (body.inverse_mass.data()[dof] != 0.0) free.push_back(dof);
  return free;
}

}  // namespace

template <int D>
LinearisedForces<D>::LinearisedForces(const Discretisation<D>& body, const State<D>& state,
                                      const Sweep<D>* sweep)
    : body_(body), state_(&state) {
  const bool by_points = body.viscosity.nonZeros() > 0;
  const bool large = body.nodes() >= worth_a_sweep && Sweep<D>::possible(body);
  if (by_points || (sweep == nullptr && !large)) {
    prepare();
    return;
  }
  if (sweep != nullptr || (!body.linear() && !(state.H.array() == 0.0).all())) {
    tangent_.emplace(body, state, sweep);
    return;
  }
  SweepOptions options;
  options.threads = omp_get_max_threads();
  options.linearised = true;
  sweep_.emplace(body, options);
  moved_.signals.assign(body.signals.size(), 0.0);
}

template <int D>
LinearisedForces<D>::LinearisedForces(const Discretisation<D>& body, const Sweep<D>* sweep)
    : body_(body) {
  if (sweep != nullptr)
    tangent_.emplace(body, *sweep);
  else
    prepare();
}

template <int D>
void LinearisedForces<D>::prepare() {
  zero_.assign(body_.signals.size(), 0.0);
  H_ = TensorField<D>::Zero(body_.points.size(), D * D);
  if (body_.ghosts) workspace_ = body_.ghosts->workspace();
}

template <int D>
void LinearisedForces<D>::product(const VectorField<D>& x, VectorField<D>& force) {
  if (sweep_) {
    moved_.u = x;
    moved_.f.swap(force);  // all of it is written
    moved_.f.resizeLike(x);
    sweep_->evaluate(moved_);
    moved_.f.swap(force);
    return;
  }
  if (tangent_) return tangent_->product(x, force);
  if (body_.ghosts)
    body_.ghosts->apply(x, zero_, H_, workspace_);
  else
    body_.gradient.gradient(x, H_);
  if (state_ != nullptr) apply_tangents();
  for (const SignalTerm& term : body_.stress_values) H_.data()[term.slot] = 0.0;
  body_.divergence.divergence(H_, force);
  if (state_ != nullptr) subtract_stabiliser<D>(body_, x, force);
}

template <int D>
void LinearisedForces<D>::apply_tangents() {
  for (const Region<D>& region : body_.regions)
    std::visit(
        [&](const auto& law) {
          for_rows(region.size(H_.rows()), [&](Index k) {
            const Index s = region.point(k);
            const Tensor<D> dP =
                law.at(present(*state_, s)).dpk1(tensor_at<D>(state_->H, s), tensor_at<D>(H_, s));
            Eigen::Map<Tensor<D>>(H_.data() + s * D * D) = dP;
          });
        },
        region.law);
}

template <int D>
SparseMatrix LinearisedForces<D>::dynamical_matrix() {
  const std::vector<Index> free = free_dofs<D>(body_);
  const auto n = static_cast<Index>(free.size());
  const auto root = [&](Index dof) { return std::sqrt(body_.inverse_mass.data()[dof]); };
  VectorField<D> x = VectorField<D>::Zero(body_.nodes(), D);
  VectorField<D> force = x;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index column = 0; column < n; ++column) {
    const Index dof = free[static_cast<std::size_t>(column)];
    x.data()[dof] = 1.0;
    product(x, force);
    x.data()[dof] = 0.0;
    for (Index row = 0; row < n; ++row) {
      const Index other = free[static_cast<std::size_t>(row)];
      if (const double change = force.data()[other]; change != 0.0)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column),
                             -root(other) * change * root(dof));
    }
  }
  SparseMatrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  if (!body_.adjoint) return result;
  // Symmetric but for round-off, and better solved as such.
  const SparseMatrix transposed = result.transpose();
  return 0.5 * (result + transposed);
}

template <int D>
SparseMatrix LinearisedForces<D>::damping_matrix() const {
  if (body_.viscosity.nonZeros() == 0) return {};
  const std::vector<Index> free = free_dofs<D>(body_);
  std::vector<int> place(static_cast<std::size_t>(body_.inverse_mass.size()), -1);
  for (std::size_t k = 0; k < free.size(); ++k)
    place[static_cast<std::size_t>(free[k])] = static_cast<int>(k);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index p = 0; p < body_.viscosity.outerSize(); ++p)
    for (SparseMatrix::InnerIterator entry(body_.viscosity, p); entry; ++entry)
      for (int i = 0; i < D; ++i) {
        const Index row = entry.row() * D + i;
        const Index column = entry.col() * D + i;
        const int to = place[static_cast<std::size_t>(row)];
        const int from = place[static_cast<std::size_t>(column)];
        if (to >= 0 && from >= 0)
          entries.emplace_back(to, from,
                               entry.value() * std::sqrt(body_.inverse_mass.data()[row] *
                                                         body_.inverse_mass.data()[column]));
      }
  const auto n = static_cast<Index>(free.size());
  SparseMatrix result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

template class LinearisedForces<1>;
template class LinearisedForces<2>;

}  // namespace tlsph
