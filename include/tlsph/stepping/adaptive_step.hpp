#pragma once
/// \file
/// The critical step of a body whose stiffness follows its deformation, kept safe at little cost.
///
/// A central difference is symplectic for equal steps only: a step that shrinks and grows with the
/// motion pumps energy into it. So the step only falls, by a notch or more at a time, and stays as
/// it is once the stiffest state has been met. It is shorter for a while only where a material
/// point deforms by a tenth in a step, as in an impact.
///
/// K depends on the state through the tangents A_s of the material points alone, so what an
/// estimate at one state says of all others follows from Weyl's inequality:
///
///     ω²_max ≤ ω²_max(estimate) + γ max_s λ_max(A_s − A_s(estimate)),    γ = λ_max(M⁻¹ Gᵀ V G)
///
/// γ is a constant of the operators. Tangents are those of the stretch U of F = R U, since those of
/// F have the same eigenvalues and a body that turns is as stiff as before (exact where the body
/// turns as one, and up to how much R changes over a support where it bends). Strains come from the
/// displacements block by block, in the inner loops of a sweep, and never leave the cache. The
/// bound costs two tangents a point, wanted only where the body has deformed by a part of a per
/// cent since it was last taken. Where it asks for a shorter step, an estimate is made first, as
/// often as a share of the steps pays for. How much a body deforms in the steps to come is read off
/// the last ones. The deformation per step is limited to 10 %, so that the tangent taken at its
/// start stays valid. (Where D is not the adjoint of G, as in `mirror` and `thesis`, K is not
/// symmetric and the same formula is an estimate.)

#include <algorithm>
#include <memory>

#include "tlsph/stepping/critical_step.hpp"
#include "tlsph/sweep/strain_monitor.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {

template <int D>
class AdaptiveStep {
 public:
  /// Estimates at `state`, evaluated. NumericalError if nothing limits the step there.
  AdaptiveStep(const Discretisation<D>& discretisation, const State<D>& state, double safety);
  AdaptiveStep(const AdaptiveStep&) = delete;
  AdaptiveStep& operator=(const AdaptiveStep&) = delete;
  ~AdaptiveStep();

  /// From now on only u of a state is read: strains are computed by the operators of a sweep of the
  /// same discretisation, which must outlive this.
  void use_operators_of(const Sweep<D>& sweep);

  /// The last estimate.
  [[nodiscard]] const CriticalStep& critical() const { return critical_; }
  /// The step that is safe now [s].
  [[nodiscard]] double step() const { return step_; }
  /// Starts with a shorter step [s].
  void shorten(double step) { step_ = steady_ = std::min(steady_, step); }
  /// Says that no particle has moved by more than this [m] in a component since the step before.
  /// Lets the check be skipped while displacements are too small to matter, and forces one when
  /// speeds jump (impact).
  void moved_by(double distance) {
    moves_known_ = true;
    moved_ += distance;
    last_move_ = distance;
  }
  /// At every step, the state evaluated unless a sweep reads its strains; most of the time nothing
  /// happens. True when `step()` has changed. Takes memory only for a new estimate, which also
  /// leaves H of the state evaluated.
  bool update(State<D>& state);

  /// 2/√(ω²_max bound) at a state, whatever was checked before [s].
  [[nodiscard]] double bound(const State<D>& state) const;

  [[nodiscard]] long checks() const { return checks_; }
  [[nodiscard]] long bounds() const { return bounds_; }
  [[nodiscard]] long estimates() const { return estimates_; }
  /// Wall time of checks, bounds and estimates after the first one [s].
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Calls `visit(name, value)` for all that a checkpoint needs to go on bit for bit; values are
  /// double, long, bool, std::optional<double>, StrainField and MemoryField.
  template <class Visit>
  void visit(const Visit& visit) {
    visit("gamma", gamma_);
    visit("initial_limit", initial_limit_);
    visit("critical_dt", critical_.dt);
    visit("critical_scaled", critical_.scaled);
    visit("critical_growth", critical_.growth);
    visit("limit", limit_);
    visit("step", step_);
    visit("steady", steady_);
    visit("change", change_);
    visit("last_check", last_check_);
    visit("next_check", next_check_);
    visit("moves_known", moves_known_);
    visit("moved", moved_);
    visit("last_move", last_move_);
    visit("move_at_check", move_at_check_);
    visit("checks", checks_);
    visit("bounds", bounds_);
    visit("estimates", estimates_);
    visit("estimated_at", H_estimate_);
    visit("bound_at", H_bound_);
    if (memory_estimate_.size() > 0) visit("estimated_memory", memory_estimate_);
  }

 private:
  [[nodiscard]] bool due(const State<D>& state) const;
  [[nodiscard]] double share_of_estimate(double added) const;
  void estimate(State<D>& state);
  void take_bound(State<D>& state);
  void limit_deformation(const State<D>& state, double rate, double most);

  const Discretisation<D>& body_;
  const Sweep<D>* sweep_ = nullptr;  ///< that strains and estimates are computed by
  double safety_;
  double kept_;         ///< share of the limit up to which a step stays
  double deformation_;  ///< relative one between two bounds that the safety allows for
  double gamma_ = 0.0;  ///< zero until it is wanted
  CriticalStep critical_;
  double initial_limit_;  ///< critical step of the first estimate [s]
  double limit_;          ///< critical step by the last bound [s]
  double step_;
  double steady_;  ///< the step while no point deforms fast; it only falls [s]
  std::unique_ptr<StrainMonitor<D>> monitor_;
  StrainField H_estimate_, H_bound_;  ///< by direction
  MemoryField memory_estimate_;
  bool moves_known_ = false;
  double moved_ = 0.0;                            ///< since the last check, at most [m]
  double last_move_ = 0.0, move_at_check_ = 0.0;  ///< of one step [m]
  double row_sum_ = 0.0;  ///< largest Σ_q |w^a_sq| of a material point [1/m]
  double change_ = 0.0;   ///< relative deformation since the last bound, at the last check
  long last_check_ = 0, next_check_ = 1;
  long checks_ = 0, bounds_ = 0, estimates_ = 0;
  double seconds_ = 0.0;
};

}  // namespace tlsph
