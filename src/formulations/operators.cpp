#include "tlsph/formulations/operators.hpp"

#include <cmath>
#include <utility>

#include "tlsph/core/stop.hpp"
#include "tlsph/formulations/extension.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/operators/row_storage.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

/// D = −GᵀV of the gradient it has, rows that are equal up to a shift stored once.
template <int D>
void close_naturally(Discretisation<D>& body) {
  body.gradient = std::move(body.gradient).with_shared_rows(rounding_of<D>(body.particles));
  body.divergence = body.gradient.negative_adjoint(body.points.V);
}

/// The smallest change of the gradient on its own pattern that makes it consistent, if asked for.
template <int D>
void correct(const OperatorChoices& choices, Discretisation<D>& body) {
  stop_point();
  if (!choices.consistency) return;
  auto corrected = consistent_gradient<D>(body.gradient, body.points, body.particles,
                                          *choices.consistency, choices.consistency_place);
  body.gradient = std::move(corrected.gradient);
  body.consistency = corrected.residuals;
}

template <int D>
double radius(const OperatorChoices& choices, const Discretisation<D>& body) {
  return choices.support.value_or(0.0) * body.particles.spacing;
}

/// Gradient by a fit over the support of each node, or by sums with one of their corrections.
template <int D>
VectorOperator<D> node_gradient(const OperatorChoices& choices, const Discretisation<D>& body) {
  const Particles<D>& particles = body.particles;
  const double h = radius(choices, body);
  if (choices.correction == Correction::least_squares)
    return point_gradient<D>(choices.kernel, h, body.points.X, particles.X, choices.order);
  return collocated_gradient<D>(choices.kernel, h, particles.X, particles.V, choices.correction);
}

/// Reactions of moved edges are m ü + Σ w P, each material point counted for the edge node across
/// from it. In `mirror` w = V ∂H/∂ū, the work of the stress in a unit motion of the edge, which
/// closes the balance of energy. In `thesis`, whose forces do no such work, w = Σ_q D_q, what of
/// a stress the forces of all nodes together have, which closes that of momentum.
template <int D>
void add_reactions_of_moved(const Edges<D>& edges, Discretisation<D>& body) {
  const LatticeFrame<D>& frame = *body.particles.frame;
  for (std::size_t b = 0; b < D; ++b)
    for (std::size_t side = 0; side < 2; ++side)
      for (int i = 0; i < D; ++i) {
        const std::size_t moving = edges[b][side].displacement[static_cast<std::size_t>(i)];
        if (moving == no_signal) continue;
        const auto across = [&](Index p) {
          auto at = frame.coordinates(static_cast<int>(p));
          at[b] = side == 0 ? 0 : frame.counts[b] - 1;
          return Index{frame.index(at)};
        };
        TensorField<D> w = TensorField<D>::Zero(body.nodes(), D * D);
        if (body.ghosts) {
          const Neighbours& rows = body.divergence.pattern();
          for (std::size_t k = 0; k < rows.column.size(); ++k) {
            const int p = rows.column[k];
            const int at = frame.coordinates(p)[b];
            if ((2 * at < frame.counts[b]) == (side == 0))
              w(p, i * D + static_cast<int>(b)) +=
                  body.divergence.weight(static_cast<Index>(k), static_cast<int>(b), i);
          }
        } else {
          VectorField<D> u = VectorField<D>::Zero(body.nodes(), D);
          for (Index p = 0; p < body.nodes(); ++p) u(across(p), i) = 1.0;
          body.gradient.gradient(u, w);
          for (const SignalTerm& term : body.gradient_terms)
            if (term.signal == moving) w.data()[term.slot] += term.weight;
          w.array().colwise() *= body.points.V.array();
        }
        const double rounding = 1e-14 * w.cwiseAbs().maxCoeff();
        for (Index p = 0; p < body.nodes(); ++p)
          for (Index slot = p * D * D; slot < (p + 1) * D * D; ++slot)
            if (std::abs(w.data()[slot]) > rounding)
              body.reactions.push_back({across(p) * D + i, slot, w.data()[slot]});
      }
}

template <int D>
LatticeStencil<D> stencil_of(const OperatorChoices& choices, const Discretisation<D>& body) {
  return lattice_stencil<D>(choices.kernel, choices.support.value_or(2.5), *body.particles.frame);
}

/// D with its boundary terms; returns G and its own, which `mirror` takes.
template <int D>
FoldedOperators<D> add_folded_divergence(const LatticeStencil<D>& stencil, const Edges<D>& edges,
                                         TractionGhost ghost, Discretisation<D>& body) {
  auto folded = folded_operators<D>(stencil, *body.particles.frame, body.particles.V, edges, ghost);
  body.divergence = std::move(folded.divergence);
  body.force_terms = std::move(folded.force_terms);
  body.stress_values = std::move(folded.stress_values);
  return folded;
}

// The builders, one a row of the table.

template <int D>
void thesis(const OperatorChoices& choices, const Edges<D>& edges, Discretisation<D>& body) {
  const LatticeStencil<D> stencil = stencil_of(choices, body);
  const bool eta = choices.ghosts == GhostClosure::eta;
  add_folded_divergence<D>(stencil, edges, eta ? TractionGhost::mirrored : TractionGhost::target,
                           body);
  body.ghosts = std::make_shared<const GhostGradient<D>>(
      stencil, body.particles, edges, choices.ghosts, choices.solver, choices.solver_place);
  add_reactions_of_moved<D>(edges, body);
}

template <int D>
void mirror(const OperatorChoices& choices, const Edges<D>& edges, Discretisation<D>& body) {
  auto folded =
      add_folded_divergence<D>(stencil_of(choices, body), edges, TractionGhost::mirrored, body);
  body.gradient = std::move(folded.gradient);
  body.gradient_terms = std::move(folded.gradient_terms);
  add_reactions_of_moved<D>(edges, body);
}

template <int D>
void variational(const OperatorChoices& choices, const Edges<D>&, Discretisation<D>& body) {
  body.gradient = node_gradient<D>(choices, body);
  close_naturally<D>(body);
}

template <int D>
void consistent(const OperatorChoices& choices, const Edges<D>&, Discretisation<D>& body) {
  body.gradient = node_gradient<D>(choices, body);
  correct<D>(choices, body);
  close_naturally<D>(body);
}

template <int D>
void stress_point(const OperatorChoices& choices, const Edges<D>&, Discretisation<D>& body) {
  body.gradient = choices.support
                      ? point_gradient<D>(choices.kernel, radius(choices, body), body.points.X,
                                          body.particles.X, choices.order)
                      : cell_gradient<D>(body.particles, body.points);
  correct<D>(choices, body);
  close_naturally<D>(body);
}

template <int D>
using Builder = void (*)(const OperatorChoices&, const Edges<D>&, Discretisation<D>&);
template <int D>
constexpr std::array<Builder<D>, formulation_table.size()> builders = {
    thesis<D>, mirror<D>, variational<D>, consistent<D>, stress_point<D>};

}  // namespace

template <int D>
double rounding_of(const Particles<D>& particles) {
  return shared_row_tolerance(particles.X.cwiseAbs().maxCoeff(), particles.spacing);
}

template <int D>
MaterialPoints<D> stress_points(Formulation formulation, const Particles<D>& particles) {
  MaterialPoints<D> points =
      is_collocated(formulation) ? node_points<D>(particles) : cell_points<D>(particles);
  points.V = with_shared_values(std::move(points.V), rounding_of<D>(particles));
  return points;
}

template <int D>
void add_operators(Formulation formulation, const OperatorChoices& choices, const Edges<D>& edges,
                   Discretisation<D>& body) {
  builders<D>[static_cast<std::size_t>(formulation)](choices, edges, body);
  stop_point();
}

#define TLSPH_INSTANTIATE(D)                                                           \
  template double rounding_of<D>(const Particles<D>&);                                 \
  template MaterialPoints<D> stress_points<D>(Formulation, const Particles<D>&);       \
  template void add_operators<D>(Formulation, const OperatorChoices&, const Edges<D>&, \
                                 Discretisation<D>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
