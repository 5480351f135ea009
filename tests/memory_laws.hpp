#pragma once
/// \file
/// Laws with a memory, small enough to be solved by hand.

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "tlsph/materials/any_law.hpp"
#include "tlsph/materials/kinematics.hpp"

namespace tlsph {

/// Small-strain plasticity of von Mises with linear isotropic hardening, in 1D and plane strain, by
/// radial return (Simo and Hughes, Computational Inelasticity, 1998, box 3.1):
///
///     s = 2μ (dev ε − εᵖ),  q = √(3/2) |s| ≤ σ_y + K α,  dεᵖ = 3/2 s/q dα
///
/// A point remembers εᵖ (xx, yy, zz, xy) and α. The energy Ψ = κ/2 (tr ε)² + μ |dev ε − εᵖ|² + K/2
/// α² is stored, σ_y α is lost.
template <int D>
class VonMises {
 public:
  static constexpr int dimension = D;
  static constexpr std::string_view name = "von-mises";
  static constexpr std::array<LawConstant, 4> keys = {
      {{"bulk", "Pa", above(0.0), "bulk modulus"},
       {"shear", "Pa", above(0.0), "shear modulus"},
       {"yield", "Pa", above(0.0), "yield stress"},
       {"hardening", "Pa", above(0.0), "change of the yield stress with the plastic strain"}}};
  static constexpr bool small_strain = true;
  static constexpr int memory = 5;

  explicit VonMises(std::span<const double> values)
      : bulk_(values[0]), shear_(values[1]), yield_(values[2]), hardening_(values[3]) {}

  [[nodiscard]] double energy(const TensorOf<D, double>& H, const double* now) const {
    const double volume = trace<D>(H);
    double strain[4], square = 0.0;
    elastic_deviator(H, now, strain);
    for (int k = 0; k < 4; ++k) square += (k < 3 ? 1 : 2) * strain[k] * strain[k];
    return 0.5 * bulk_ * volume * volume + shear_ * square + 0.5 * hardening_ * now[4] * now[4];
  }
  [[nodiscard]] double dissipated(const double* now) const { return yield_ * now[4]; }

  template <class R>
  [[nodiscard]] TensorOf<D, R> stress(const TensorOf<D, R>& H, const Past& past, R* now,
                                      Mask<R>& good) const {
    R strain[4];
    elastic_deviator(H, past.memory, strain);
    R square = strain[0] * strain[0] + strain[1] * strain[1] + strain[2] * strain[2] +
               2.0 * strain[3] * strain[3];
    const double strength = yield_ + hardening_ * past.memory[4];
    R flow = Numbers<R>::all(0.0), ratio = flow;  // change of α, 3/2 of that over |s|/(2μ) √(3/2)
    if (6.0 * shear_ * shear_ * square > strength * strength) {
      const R norm = Numbers<R>::root(1.5 * square);  // q/(2μ)
      flow = (2.0 * shear_ * norm - strength) / (3.0 * shear_ + hardening_);
      ratio = 1.5 * flow / norm;
    }
    for (int k = 0; k < 4; ++k) {
      now[k] = past.memory[k] + ratio * strain[k];
      strain[k] = strain[k] - ratio * strain[k];
    }
    now[4] = past.memory[4] + flow;
    good &= flow < huge;
    const R pressure = bulk_ * trace<D>(H);
    TensorOf<D, R> P;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a)
        P(i, a) = i == a ? pressure + 2.0 * shear_ * strain[i] : 2.0 * shear_ * strain[3];
    return P;
  }

  [[nodiscard]] double transverse_stretch(const TensorOf<D, double>&) const { return 1.0; }
  [[nodiscard]] double transverse_stress(const TensorOf<D, double>& H) const {
    return bulk_ * trace<D>(H);  // of an elastic state without deviator; nobody asks here
  }
  [[nodiscard]] double margin(const TensorOf<D, double>&) const { return 1.0; }

 private:
  /// dev ε − εᵖ: xx, yy, zz, xy.
  template <class R>
  static void elastic_deviator(const TensorOf<D, R>& H, const double* plastic, R* result) {
    const R third = trace<D>(H) / 3.0;
    for (int k = 0; k < 3; ++k) result[k] = (k < D ? H(k, k) - third : -third) - plastic[k];
    if constexpr (D == 2)
      result[3] = 0.5 * (H(0, 1) + H(1, 0)) - plastic[3];
    else
      result[3] = Numbers<R>::all(-plastic[3]);
  }

  double bulk_, shear_, yield_, hardening_;
};

inline constexpr std::array<double, 4> soft_metal = {2e6, 1e6, 2e3, 1e5};

/// A bar that breaks: P = (1 − d) E H, and the damage d follows the largest strain so far,
///
///     d = (1 − ε₀/|H|) b  for |H| > ε₀
///
/// A point remembers the largest |H| and the energy ∫ ½ E H² dd that damage took.
class DamagedBar {
 public:
  static constexpr int dimension = 1;
  static constexpr std::string_view name = "damaged";
  static constexpr std::array<LawConstant, 3> keys = {
      {{"young", "Pa", above(0.0), "E"},
       {"onset", "", above(0.0), "ε₀"},
       {"brittleness", "", between(0.0, 1.1), "b"}}};
  static constexpr bool small_strain = true;
  static constexpr int memory = 2;

  explicit DamagedBar(std::span<const double> values)
      : young_(values[0]), onset_(values[1]), brittleness_(values[2]) {}

  template <class R>
  [[nodiscard]] R damage(const R& largest) const {
    if (largest > onset_) return brittleness_ * (1.0 - onset_ / largest);
    return Numbers<R>::all(0.0);
  }
  [[nodiscard]] double energy(const TensorOf<1, double>& H, const double* now) const {
    return 0.5 * (1.0 - damage(now[0])) * young_ * H(0, 0) * H(0, 0);
  }
  [[nodiscard]] double dissipated(const double* now) const { return now[1]; }

  template <class R>
  [[nodiscard]] TensorOf<1, R> stress(const TensorOf<1, R>& H, const Past& past, R* now,
                                      Mask<R>& good) const {
    const R strain = H(0, 0);
    const R size = strain < 0.0 ? R(-strain) : strain;
    const R before = Numbers<R>::all(past.memory[0]);
    now[0] = size > past.memory[0] ? size : before;
    // dd = b ε₀/H² dH: ∫ ½ E H² dd = ½ E b ε₀ (H − H before)
    const R from = past.memory[0] > onset_ ? before : Numbers<R>::all(onset_);
    now[1] = Numbers<R>::all(past.memory[1]);
    if (now[0] > onset_) now[1] = now[1] + 0.5 * young_ * brittleness_ * onset_ * (now[0] - from);
    good &= now[0] < huge;
    TensorOf<1, R> P;
    P(0, 0) = (1.0 - damage(now[0])) * young_ * strain;
    return P;
  }

  [[nodiscard]] double transverse_stretch(const TensorOf<1, double>&) const { return 1.0; }
  [[nodiscard]] double transverse_stress(const TensorOf<1, double>&) const { return 0.0; }
  [[nodiscard]] double margin(const TensorOf<1, double>&) const { return 1.0; }

 private:
  double young_, onset_, brittleness_;
};

/// A bar of Maxwell's model beside a spring: P = E_∞ H + E (H − ε_v), dε_v/dt = (H − ε_v)/τ,
/// exactly for strains that grow linearly within a step. A point remembers H, ε_v and the energy
/// ∫ E (H − ε_v) dε_v that was lost.
class ViscousBar {
 public:
  static constexpr int dimension = 1;
  static constexpr std::string_view name = "viscous";
  static constexpr std::array<LawConstant, 3> keys = {{{"spring", "Pa", above(0.0), "E_∞"},
                                                       {"viscous_spring", "Pa", above(0.0), "E"},
                                                       {"time", "s", above(0.0), "τ"}}};
  static constexpr bool small_strain = true;
  static constexpr int memory = 3;

  explicit ViscousBar(std::span<const double> values)
      : slow_(values[0]), fast_(values[1]), time_(values[2]) {}

  [[nodiscard]] double energy(const TensorOf<1, double>& H, const double* now) const {
    const double elastic = H(0, 0) - now[1];
    return 0.5 * slow_ * H(0, 0) * H(0, 0) + 0.5 * fast_ * elastic * elastic;
  }
  [[nodiscard]] double dissipated(const double* now) const { return now[2]; }

  /// e = H − ε_v of a strain rate r: e = e₀ exp(−t/τ) + r τ (1 − exp(−t/τ)). What is lost is the
  /// work of E e less what it stores: ∫ E e r dt − ½ E (e² − e₀²), and ∫ e dt = r τ t + τ (e₀ − e).
  template <class R>
  [[nodiscard]] TensorOf<1, R> stress(const TensorOf<1, R>& H, const Past& past, R* now,
                                      Mask<R>& good) const {
    const R strain = H(0, 0);
    const double before = past.memory[0] - past.memory[1];
    R elastic = strain - past.memory[1];
    now[2] = Numbers<R>::all(past.memory[2]);
    if (past.dt > 0.0) {
      const double share = -std::expm1(-past.dt / time_);
      const R rate = (strain - past.memory[0]) / past.dt;
      elastic = before * (1.0 - share) + time_ * share * rate;
      const R area = time_ * past.dt * rate + time_ * (before - elastic);
      now[2] = now[2] + fast_ * (area * rate - 0.5 * (elastic * elastic - before * before));
    }
    now[0] = strain;
    now[1] = strain - elastic;
    good &= elastic < huge;
    TensorOf<1, R> P;
    P(0, 0) = slow_ * strain + fast_ * elastic;
    return P;
  }

  [[nodiscard]] double transverse_stretch(const TensorOf<1, double>&) const { return 1.0; }
  [[nodiscard]] double transverse_stress(const TensorOf<1, double>&) const { return 0.0; }
  [[nodiscard]] double margin(const TensorOf<1, double>&) const { return 1.0; }

 private:
  double slow_, fast_, time_;
};

/// Any of them for a region.
template <class Text>
AnyLaw<Text::dimension> given(const std::span<const double> constants) {
  return GivenLaw<Text::dimension, Text::small_strain>(Law<Text>(constants));
}

}  // namespace tlsph
