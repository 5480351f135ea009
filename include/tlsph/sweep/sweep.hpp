#pragma once
/// \file
/// A whole step of the central difference in one pass over the body.
///
/// `evaluate` and `advance` (dynamics/state.hpp) say what a step is, operator by operator; every
/// one of their products writes a field that the next one reads, and that traffic is most of their
/// time. A sweep does the same sums block by block: the gradient of a few hundred material points,
/// their stress at once in its place, and the nodes behind them once every
/// point that reads or feeds them has been computed. H, P and the forces never leave the
/// cache; a step reads and writes u and v, once.
///
///     points  H = G u, P = ∂Ψ/∂F            in a window that moves along the body
///     rows    r = M⁻¹ (S u + C v)           the same
///     nodes   a = M⁻¹ D P − r + loads, v += Δt a, u += Δt v
///
/// A body whose laws are linear needs no stress to move: where that is less work – on lattices of
/// stress points, by a third and more –, a step is one product
///
///     rows    a = Σ B (u_r − u_q) + g       of blocks B of −M⁻¹K, into a window
///     nodes   a + loads, v += Δt a, u += Δt v
///
/// whose block rows are put together from the shared rows of G, D and S, a handful on a lattice;
/// `evaluate` goes by the points all the same.
///
/// Rows of G, M⁻¹D and M⁻¹S that are equal up to a shift are stored once
/// (operators/row_storage.hpp) and run vectorised across particles. The rows of a cell stabiliser
/// are a direction more of G and D. Workers own ranges of nodes; what they read of each other is
/// computed before the first of them writes. Results do not depend on which steps are observed, and
/// are the same in every run of as many threads, also while one of them makes the parts of all
/// because that is faster (core/team_choice.hpp); they differ from `evaluate` and `advance` by
/// rounding.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tlsph/dynamics/balance.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph {

namespace sweep {
template <int D>
class Storage;
}  // namespace sweep

/// Which of the compiled inner loops run; `widest` that this processor has.
enum class Instructions { widest, baseline, avx2, avx512 };
/// True where the program has them and the processor too.
[[nodiscard]] bool available(Instructions instructions);
/// "avx512", "avx2" or "baseline": what `widest` means here.
[[nodiscard]] std::string widest_instructions();

/// Multiply-adds per second of one core in that many rounds on registers, the widest instructions:
/// what bounds arithmetic here.
[[nodiscard]] double peak_multiply_adds(Index rounds);

/// How a step finds accelerations.
enum class StepForm {
  cheapest,   ///< whatever is least work
  points,     ///< by strain and stress of the material points
  stiffness,  ///< as one product with the stiffness, where there is one to be had
};

struct SweepOptions {
  int threads = 1;
  /// Weights of rows without a stencil in single precision, sums in double: half the traffic on
  /// irregular particles. G and D are then adjoint to 1e-7 only, and momenta kept as well as that.
  bool single_weights = false;
  Instructions instructions = Instructions::widest;
  /// The laws at small strain and no loads, so that `evaluate` gives f = −K u of the undeformed
  /// body.
  bool linearised = false;
  StepForm form = StepForm::cheapest;
};

template <int D>
class Sweep {
 public:
  /// True where a sweep can do what the discretisation asks for: gradients that are one matrix a
  /// direction, for all components. Laws with a memory, the solves of `thesis`, mirrored edges
  /// and a stiffness matrix beside a viscous one are left to `evaluate` and `advance`.
  [[nodiscard]] static bool possible(const Discretisation<D>& discretisation);

  /// Plans the passes; `discretisation` must outlive the sweep.
  explicit Sweep(const Discretisation<D>& discretisation, const SweepOptions& options = {});
  Sweep(Sweep&&) noexcept;
  Sweep(const Sweep&) = delete;
  Sweep& operator=(const Sweep&) = delete;
  Sweep& operator=(Sweep&&) = delete;
  ~Sweep();

  /// One step to `next_time` = t_n + dt; u and v of the state change, H, P and f are left as they
  /// are. Gathers the boundary forces on the way. Takes nothing from the heap. NumericalError as
  /// `evaluate`, with u and v of t_n restored to rounding.
  void step(State<D>& state, double dt, double next_time, BoundaryForces<D>& forces);

  /// H, P (where the state has them) and f of the state (and its viscous forces), as `evaluate`
  /// leaves them to rounding, at a fraction of its cost. NumericalError as there. Takes nothing
  /// from the heap.
  void evaluate(State<D>& state);

  /// The operators as it reads them; for this room.
  [[nodiscard]] const sweep::Storage<D>& operators() const;

  /// How rows are stored, of all operators together; bytes of what a step reads beside u and v.
  [[nodiscard]] StorageReport storage() const;

  /// Multiply-adds of a node and step where steps are one product with the stiffness; nothing where
  /// they go by the points.
  [[nodiscard]] std::optional<double> stiffness_multiply_adds() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace tlsph
