#include "tlsph/formulations/ghosts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "ghost_system.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/operators/products.hpp"

namespace tlsph {
namespace {

/// A ghost of one displacement component that is an image of a real node.
struct Extended {
  int ghost = 0;
  int component = 0;
  Image image;
};

/// The η correction of one edge (1D): ghosts' share of W (or X) at the edge node.
struct Eta {
  int edge_node = 0;
  bool dirichlet = true;
  std::size_t target = no_signal;
  std::vector<int> ghosts;
  std::vector<double> shape;  ///< W(x_b − x_q), the form of the correction
  double denominator = 0.0;   ///< D of (2.42) or N of (2.45) over the ghosts
};

template <int D>
bool inside(const GhostLattice<D>& lattice, const std::array<int, D>& at) {
  for (std::size_t a = 0; a < D; ++a)
    if (at[a] < -lattice.layers || at[a] >= lattice.frame.counts[a] - lattice.layers) return false;
  return true;
}

}  // namespace

template <int D>
struct GhostGradient<D>::Impl {
  LatticeFrame<D> real;
  GhostClosure closure;
  std::vector<Extended> extended;
  std::vector<GhostSystem> displacement;  ///< slot = component
  std::vector<GhostSystem> strain;        ///< slot = component of the gradient
  std::vector<Eta> etas;

  /// All systems in this order, that of their workspaces.
  template <class Visit>
  void for_systems(const Visit& visit) const {
    std::ranges::for_each(displacement, visit);
    std::ranges::for_each(strain, visit);
  }
  [[nodiscard]] std::vector<SolveWorkspace> solve_workspaces() const {
    std::vector<SolveWorkspace> result;
    for_systems([&](const GhostSystem& system) { result.push_back(system.workspace()); });
    return result;
  }
};

/// W and X over nodes and ghosts.
template <int D>
void GhostGradient<D>::assemble(const LatticeStencil<D>& stencil) {
  const Index N = lattice_.X.rows();
  OperatorRows rows;
  std::vector<double> values;
  for (Index p = 0; p < N; ++p) {
    std::vector<std::pair<int, std::size_t>> near;
    for (std::size_t k = 0; k < stencil.offset.size(); ++k) {
      auto at = lattice_.coordinates[static_cast<std::size_t>(p)];
      for (std::size_t a = 0; a < D; ++a) at[a] += stencil.offset[k][a];
      if (inside<D>(lattice_, at)) near.emplace_back(lattice_.node(at), k);
    }
    std::ranges::sort(near);
    for (const auto& [q, k] : near) {
      rows.add(q, {stencil.gradient[k].data(), D});
      values.push_back(stencil.value[k]);
    }
    rows.end_row();
  }
  W_ = matrix_of(rows.pattern, N, [&](Index k) { return values[static_cast<std::size_t>(k)]; });
  X_ = VectorOperator<D>(std::move(rows), N);
}

/// Systems for all components of u, and for the strains at natural edges.
template <int D>
void GhostGradient<D>::close_by_systems(const Edges<D>& edges, SolverChoice solver,
                                        const Place& place) {
  using Target = std::optional<std::size_t>;
  // The nodes on and beyond the edges that prescribe a component, and signal(edge, b) of each.
  const auto close = [&](std::vector<GhostSystem>& systems, const std::string& name, int slot,
                         const auto& signal) {
    std::vector<int> nodes;
    std::vector<std::size_t> target;
    for (Index p = 0; p < lattice_.X.rows(); ++p) {
      Target prescribed;
      for_edges<D>(edges, impl_->real, lattice_.coordinates[static_cast<std::size_t>(p)],
                   [&](const Edge<D>& edge, int b) {
                     if (const Target here = signal(edge, b)) prescribed = here;
                   });
      if (!prescribed) continue;
      nodes.push_back(static_cast<int>(p));
      target.push_back(*prescribed);
    }
    if (!nodes.empty())
      systems.emplace_back(W_, name, slot, nodes, std::move(target),
                           impl_->closure == GhostClosure::consistent, solver, place);
    return nodes;
  };
  for (int i = 0; i < D; ++i) {
    const auto component = static_cast<std::size_t>(i);
    const std::vector<int> solved = close(impl_->displacement, fmt::format("u_{}", "xyz"[i]), i,
                                          [&](const Edge<D>& edge, int) -> Target {
                                            if (!edge.prescribed[component]) return std::nullopt;
                                            return edge.displacement[component];
                                          });
    for (int p = static_cast<int>(lattice_.real); p < lattice_.X.rows(); ++p)
      if (!std::ranges::binary_search(solved, p)) {
        const auto& at = lattice_.coordinates[static_cast<std::size_t>(p)];
        impl_->extended.push_back({p, i, displacement_image<D>(impl_->real, edges, at, i)});
      }
  }
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a)
      close(impl_->strain, fmt::format("du_{}/dX_{}", "xyz"[i], "xyz"[a]), i * D + a,
            [&](const Edge<D>& edge, int b) -> Target {
              if (b != a || edge.prescribed[static_cast<std::size_t>(i)]) return std::nullopt;
              return i == b ? edge.gradient : no_signal;
            });
}

template <int D>
void GhostGradient<D>::close_by_eta(const Edges<D>& edges) {
  for (int side = 0; side < 2; ++side) {
    const Edge<D>& edge = edges[0][static_cast<std::size_t>(side)];
    Eta eta;
    eta.edge_node = side == 0 ? 0 : impl_->real.counts[0] - 1;
    eta.dirichlet = edge.prescribed[0];
    eta.target = eta.dirichlet ? edge.displacement[0] : edge.gradient;
    const SparseMatrix derivative = X_.matrix(0);
    for (SparseMatrix::InnerIterator it(W_, eta.edge_node); it; ++it) {
      if (it.col() < lattice_.real) continue;
      eta.ghosts.push_back(static_cast<int>(it.col()));
      eta.shape.push_back(it.value());
      const double weight = eta.dirichlet ? it.value() : derivative.coeff(eta.edge_node, it.col());
      eta.denominator += weight * it.value();
    }
    impl_->etas.push_back(std::move(eta));
  }
}

/// Ghosts carry the value of their edge, corrected by η W in the ghosts ("set G", Algorithm 4.1).
template <int D>
void GhostGradient<D>::apply_eta(const std::vector<double>& signals, Workspace& work) const {
  for (Index p = lattice_.real; p < lattice_.X.rows(); ++p) {
    const bool lower = lattice_.coordinates[static_cast<std::size_t>(p)][0] < 0;
    work.u(p, 0) = work.u(lower ? 0 : impl_->real.counts[0] - 1, 0);
  }
  for (const Eta& eta : impl_->etas) {
    double now = 0.0;
    if (eta.dirichlet) {
      for (SparseMatrix::InnerIterator it(W_, eta.edge_node); it; ++it)
        now += it.value() * work.u(it.col(), 0);
    } else {
      for (const Index k : X_.pattern().entries(eta.edge_node))
        now += X_.weight(k, 0) * work.u(X_.pattern().column_at(k), 0);
    }
    const double factor = (value_of(eta.target, signals) - now) / eta.denominator;
    for (std::size_t k = 0; k < eta.ghosts.size(); ++k)
      work.u(eta.ghosts[k], 0) += factor * eta.shape[k];
  }
}

template <int D>
GhostGradient<D>::GhostGradient(const LatticeStencil<D>& stencil, const Particles<D>& particles,
                                const Edges<D>& edges, GhostClosure closure, SolverChoice solver,
                                const Place& solver_place)
    : impl_(std::make_unique<Impl>()) {
  if (!particles.frame)
    throw InputError("formulation: \"thesis\" needs an undisturbed interval or box of particles");
  for (const int count : particles.frame->counts)
    if (count - 1 < 2 * stencil.reach)
      throw InputError(
          fmt::format("kernel.support: the ghosts reach {} particles, but the body is only {} "
                      "cells thick; choose "
                      "a smaller support or spacing",
                      2 * stencil.reach, count - 1));
  if (closure == GhostClosure::eta && D != 1)
    throw InputError("boundary_treatment: \"eta\" exists in 1D only; use \"consistent\"");
  lattice_ = ghost_layers<D>(particles, 2 * stencil.reach);
  impl_->real = *particles.frame;
  impl_->closure = closure;
  assemble(stencil);
  if (closure == GhostClosure::eta)
    close_by_eta(edges);
  else
    close_by_systems(edges, solver, solver_place);
}

template <int D>
GhostGradient<D>::~GhostGradient() = default;

template <int D>
typename GhostGradient<D>::Workspace GhostGradient<D>::workspace() const {
  Workspace work;
  const Index N = lattice_.X.rows();
  work.u = VectorField<D>::Zero(N, D);
  work.smooth = VectorField<D>::Zero(N, D);
  work.strain = TensorField<D>::Zero(N, D * D);
  Index largest = 0;
  impl_->for_systems(
      [&](const GhostSystem& system) { largest = std::max(largest, system.size()); });
  work.scratch.solves = impl_->solve_workspaces();
  work.rhs = Eigen::VectorXd::Zero(largest);
  work.solution = work.rhs;
  return work;
}

template <int D>
void GhostGradient<D>::apply(const VectorField<D>& u, const std::vector<double>& signals,
                             TensorField<D>& H, Workspace& work) const {
  const Impl& self = *impl_;
  work.u.topRows(lattice_.real) = u;
  if (self.closure == GhostClosure::eta) {
    apply_eta(signals, work);
    X_.gradient(work.u, work.strain);
    H = work.strain.topRows(lattice_.real);
    return;
  }
  for (const Extended& ghost : self.extended) {
    double value = ghost.image.sign * u(ghost.image.node, ghost.component);
    for (std::size_t k = 0; k < ghost.image.count; ++k)
      value += ghost.image.terms[k].weight * signals[ghost.image.terms[k].signal];
    work.u(ghost.ghost, ghost.component) = value;
  }
  if (work.scratch.solves.empty()) work.scratch.solves = self.solve_workspaces();
  auto scratch = work.scratch.solves.begin();
  for (const GhostSystem& system : self.displacement)
    system.solve(signals, work.u.data(), D, work.rhs, work.solution, *scratch++);
  multiply<D>(W_, work.u, work.smooth);
  for (const GhostSystem& system : self.displacement)
    system.set_targets(signals, work.smooth.data(), D, work.smooth.rows());

  X_.gradient(work.smooth, work.strain);
  for (const GhostSystem& system : self.strain)
    system.solve(signals, work.strain.data(), D * D, work.rhs, work.solution, *scratch++);
  // H = W strain on the real nodes, all components at once.
  for (Index p = 0; p < lattice_.real; ++p) {
    double sum[D * D] = {};
    for (SparseMatrix::InnerIterator it(W_, p); it; ++it)
      for (int c = 0; c < D * D; ++c) sum[c] += it.value() * work.strain(it.col(), c);
    for (int c = 0; c < D * D; ++c) H(p, c) = sum[c];
  }
  for (const GhostSystem& system : self.strain)
    system.set_targets(signals, H.data(), D * D, lattice_.real);
}

template <int D>
std::vector<std::string> GhostGradient<D>::report() const {
  std::vector<std::string> lines;
  impl_->for_systems([&](const GhostSystem& system) { lines.push_back(system.report()); });
  return lines;
}

template <int D>
std::string GhostGradient<D>::solver() const {
  std::set<std::string> used;
  impl_->for_systems([&](const GhostSystem& system) { used.insert(system.solver()); });
  return fmt::format("{}", fmt::join(used, "+"));
}

template class GhostGradient<1>;
template class GhostGradient<2>;

}  // namespace tlsph
