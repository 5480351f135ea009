#include "tlsph/formulations/ghosts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "ghost_matrices.hpp"
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

}  // namespace

template <int D>
struct GhostGradient<D>::Impl {
  GhostLattice<D> lattice;
  LatticeFrame<D> real;
  GhostClosure closure;
  SparseMatrix W;
  VectorOperator<D> X;
  std::vector<Extended> extended;
  std::vector<GhostSystem> displacement;  ///< slot = component
  std::vector<GhostSystem> strain;        ///< slot = component of the gradient
  std::vector<Eta> etas;

  Impl(const LatticeStencil<D>& stencil, const Particles<D>& particles, GhostClosure how)
      : lattice(ghost_layers<D>(particles, 2 * stencil.reach)),
        real(*particles.frame),
        closure(how),
        W(lattice_kernel<D>(stencil, lattice)),
        X(lattice_gradient<D>(stencil, lattice)) {}

  void add_system(std::vector<GhostSystem>& systems, const std::string& name, int slot,
                  std::vector<int> nodes, std::vector<std::size_t> target, SolverChoice solver,
                  const Place& place) {
    if (nodes.empty()) return;
    const bool coupled = closure == GhostClosure::consistent;
    systems.emplace_back(W, name, slot, std::move(nodes), std::move(target), coupled, solver,
                         place);
  }

  /// Of the displacements' systems, then of the strains'.
  [[nodiscard]] std::vector<SolveWorkspace> solve_workspaces() const {
    std::vector<SolveWorkspace> result;
    for (const auto* systems : {&displacement, &strain})
      for (const GhostSystem& system : *systems) result.push_back(system.workspace());
    return result;
  }

  void close_displacements(const Edges<D>& edges, SolverChoice solver, const Place& place) {
    for (int i = 0; i < D; ++i) {
      std::vector<int> nodes;
      std::vector<std::size_t> target;
      for (Index p = 0; p < lattice.X.rows(); ++p) {
        const auto& at = lattice.coordinates[static_cast<std::size_t>(p)];
        bool prescribed = false;
        std::size_t signal = no_signal;
        for_edges<D>(edges, real, at, [&](const Edge<D>& edge, int) {
          if (!edge.prescribed[static_cast<std::size_t>(i)]) return;
          prescribed = true;
          signal = edge.displacement[static_cast<std::size_t>(i)];
        });
        if (prescribed) {
          nodes.push_back(static_cast<int>(p));
          target.push_back(signal);
        } else if (p >= lattice.real) {
          extended.push_back({static_cast<int>(p), i, displacement_image<D>(real, edges, at, i)});
        }
      }
      add_system(displacement, fmt::format("u_{}", "xyz"[i]), i, std::move(nodes),
                 std::move(target), solver, place);
    }
  }

  void close_strains(const Edges<D>& edges, SolverChoice solver, const Place& place) {
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) {
        std::vector<int> nodes;
        std::vector<std::size_t> target;
        for (Index p = 0; p < lattice.X.rows(); ++p) {
          bool natural = false;
          std::size_t signal = no_signal;
          for_edges<D>(edges, real, lattice.coordinates[static_cast<std::size_t>(p)],
                       [&](const Edge<D>& edge, int b) {
                         if (b != a || edge.prescribed[static_cast<std::size_t>(i)]) return;
                         natural = true;
                         if (i == b) signal = edge.gradient;
                       });
          if (!natural) continue;
          nodes.push_back(static_cast<int>(p));
          target.push_back(signal);
        }
        add_system(strain, fmt::format("du_{}/dX_{}", "xyz"[i], "xyz"[a]), i * D + a,
                   std::move(nodes), std::move(target), solver, place);
      }
  }

  void close_by_eta(const Edges<D>& edges) {
    for (int side = 0; side < 2; ++side) {
      const Edge<D>& edge = edges[0][static_cast<std::size_t>(side)];
      Eta eta;
      eta.edge_node = side == 0 ? 0 : real.counts[0] - 1;
      eta.dirichlet = edge.prescribed[0];
      eta.target = eta.dirichlet ? edge.displacement[0] : edge.gradient;
      const SparseMatrix derivative = X.matrix(0);
      for (SparseMatrix::InnerIterator it(W, eta.edge_node); it; ++it) {
        if (it.col() < lattice.real) continue;
        eta.ghosts.push_back(static_cast<int>(it.col()));
        eta.shape.push_back(it.value());
        const double weight =
            eta.dirichlet ? it.value() : derivative.coeff(eta.edge_node, it.col());
        eta.denominator += weight * it.value();
      }
      etas.push_back(std::move(eta));
    }
  }

  /// Ghosts carry the value of their edge, corrected by η W in the ghosts ("set G", Algorithm 4.1).
  void apply_eta(const std::vector<double>& signals, Workspace& work) const {
    for (Index p = lattice.real; p < lattice.X.rows(); ++p) {
      const bool lower = lattice.coordinates[static_cast<std::size_t>(p)][0] < 0;
      work.u(p, 0) = work.u(lower ? 0 : real.counts[0] - 1, 0);
    }
    for (const Eta& eta : etas) {
      const double target = eta.target == no_signal ? 0.0 : signals[eta.target];
      double now = 0.0;
      if (eta.dirichlet) {
        for (SparseMatrix::InnerIterator it(W, eta.edge_node); it; ++it)
          now += it.value() * work.u(it.col(), 0);
      } else {
        const auto row = static_cast<std::size_t>(eta.edge_node);
        for (Index k = X.pattern().start[row]; k < X.pattern().start[row + 1]; ++k)
          now += X.weight(k, 0) * work.u(X.pattern().column[static_cast<std::size_t>(k)], 0);
      }
      const double factor = (target - now) / eta.denominator;
      for (std::size_t k = 0; k < eta.ghosts.size(); ++k)
        work.u(eta.ghosts[k], 0) += factor * eta.shape[k];
    }
  }
};

template <int D>
GhostGradient<D>::GhostGradient(const LatticeStencil<D>& stencil, const Particles<D>& particles,
                                const Edges<D>& edges, GhostClosure closure, SolverChoice solver,
                                const Place& solver_place) {
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
  impl_ = std::make_unique<Impl>(stencil, particles, closure);
  if (closure == GhostClosure::eta) {
    impl_->close_by_eta(edges);
  } else {
    impl_->close_displacements(edges, solver, solver_place);
    impl_->close_strains(edges, solver, solver_place);
  }
}

template <int D>
GhostGradient<D>::~GhostGradient() = default;

template <int D>
typename GhostGradient<D>::Workspace GhostGradient<D>::workspace() const {
  Workspace work;
  const Index N = impl_->lattice.X.rows();
  work.u = VectorField<D>::Zero(N, D);
  work.smooth = VectorField<D>::Zero(N, D);
  work.strain = TensorField<D>::Zero(N, D * D);
  Index largest = 0;
  for (const auto* systems : {&impl_->displacement, &impl_->strain})
    for (const GhostSystem& system : *systems) largest = std::max(largest, system.size());
  work.scratch.solves = impl_->solve_workspaces();
  work.rhs = Eigen::VectorXd::Zero(largest);
  work.solution = work.rhs;
  return work;
}

template <int D>
void GhostGradient<D>::apply(const VectorField<D>& u, const std::vector<double>& signals,
                             TensorField<D>& H, Workspace& work) const {
  const Impl& self = *impl_;
  work.u.topRows(self.lattice.real) = u;
  if (self.closure == GhostClosure::eta) {
    self.apply_eta(signals, work);
    self.X.gradient(work.u, work.strain);
    H = work.strain.topRows(self.lattice.real);
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
  multiply<D>(self.W, work.u, work.smooth);
  for (const GhostSystem& system : self.displacement)
    system.set_targets(signals, work.smooth.data(), D, work.smooth.rows());

  self.X.gradient(work.smooth, work.strain);
  for (const GhostSystem& system : self.strain)
    system.solve(signals, work.strain.data(), D * D, work.rhs, work.solution, *scratch++);
  // H = W strain on the real nodes, all components at once.
  for (Index p = 0; p < self.lattice.real; ++p) {
    double sum[D * D] = {};
    for (SparseMatrix::InnerIterator it(self.W, p); it; ++it)
      for (int c = 0; c < D * D; ++c) sum[c] += it.value() * work.strain(it.col(), c);
    for (int c = 0; c < D * D; ++c) H(p, c) = sum[c];
  }
  for (const GhostSystem& system : self.strain)
    system.set_targets(signals, H.data(), D * D, self.lattice.real);
}

template <int D>
const SparseMatrix& GhostGradient<D>::kernel_matrix() const {
  return impl_->W;
}

template <int D>
const VectorOperator<D>& GhostGradient<D>::plain_gradient() const {
  return impl_->X;
}

template <int D>
const GhostLattice<D>& GhostGradient<D>::lattice() const {
  return impl_->lattice;
}

template <int D>
std::vector<std::string> GhostGradient<D>::report() const {
  std::vector<std::string> lines;
  for (const auto* systems : {&impl_->displacement, &impl_->strain})
    for (const GhostSystem& system : *systems) lines.push_back(system.report());
  return lines;
}

template <int D>
std::string GhostGradient<D>::solver() const {
  std::set<std::string> used;
  for (const auto* systems : {&impl_->displacement, &impl_->strain})
    for (const GhostSystem& system : *systems) used.insert(system.solver());
  std::string text;
  for (const std::string& name : used) text += (text.empty() ? "" : "+") + name;
  return text;
}

template class GhostGradient<1>;
template class GhostGradient<2>;

}  // namespace tlsph
