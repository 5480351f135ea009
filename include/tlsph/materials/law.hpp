#pragma once
/// \file
/// Elastic laws. A law is a small struct of constants with pure functions of the displacement
/// gradient H = ∂u/∂X (so F = I + H; passing H keeps full precision at strains of 1e-9): energy
/// density Ψ [J/m³], first Piola–Kirchhoff stress P = ∂Ψ/∂F [Pa], tangent A = ∂P/∂F [Pa] and its
/// action on a change of H. All of them see the D components in the model; what happens in the 3 −
/// D missing directions is the law's own affair and comes out as `transverse_stretch` and
/// `transverse_stress`.
///
/// The laws of this room are texts in the namespace `laws`, templates of the number type
/// (numbers.hpp): `Law<Text>` makes of one what is said above, and a sweep its inner loops.
///
/// Page of the room:
///   law.hpp                                          what a law is
///   numbers.hpp, dual.hpp, kinematics.hpp            what a text is written in
///   linear_elastic, st_venant_kirchhoff, neo_hookean the texts
///   law_constant.hpp                                 constants, which are keys of scenes
///   law_list.hpp, any_law.hpp                        the list of them, and the maker
///   given_law.hpp                                    a law of the caller's own
///   lame.hpp, waves.hpp                              elastic constants, wave speeds, hyperbolicity
///   stress.hpp                                       Cauchy stress, pressure, von Mises
///   uniaxial.hpp                                     the inverse P⁻¹(t̄)
///
/// `margin` says where a law ends: at det F ≤ 0, where Neo-Hookean functions return NaN, and for St
/// Venant–Kirchhoff free of transverse stress at 1 + 2E_33 ≤ 0, though its stress is a polynomial,
/// finite for any H. None of the functions throws or branches on it: test the state outside the
/// inner loop.

#include <concepts>
#include <string_view>
#include <type_traits>

#include "tlsph/core/types.hpp"
#include "tlsph/materials/dual.hpp"

namespace tlsph {

/// A_(ia)(jb) = ∂P_ia/∂F_jb, rows and columns numbered i*D + a.
template <int D>
using Tangent = Eigen::Matrix<double, D * D, D * D>;

template <class L, int D>
concept ElasticLaw = requires(const L& law, const Tensor<D>& H) {
  { L::name } -> std::convertible_to<std::string_view>;
  { L::small_strain } -> std::convertible_to<bool>;  // linear in H: P and Cauchy stress coincide
  { law.energy(H) } -> std::same_as<double>;
  { law.pk1(H) } -> std::same_as<Tensor<D>>;
  { law.dpk1(H, H) } -> std::same_as<Tensor<D>>;  // A : dH at H, second argument dH
  { law.tangent(H) } -> std::same_as<Tangent<D>>;
  { law.transverse_stretch(H) } -> std::same_as<double>;  // F_33, and F_22 in 1D
  { law.transverse_stress(H) } -> std::same_as<double>;   // Cauchy stress there [Pa]
  { law.margin(H) } -> std::same_as<double>;              // positive inside the law's range
};

/// What a material point of a law with a memory comes from: its numbers at the time before, none
/// where it is virgin, and the time since [s].
struct Past {
  const double* memory = nullptr;
  double dt = 0.0;
};

/// A text of a law with a memory.
template <class Text>
concept Remembers = requires {
  { Text::memory } -> std::convertible_to<int>;
};

/// Such a text at a past, as one without memory.
template <class Text>
class AtPast : public Text {
 public:
  using Text::Text;
  explicit AtPast(const Text& text) : Text(text) {}

  template <class R>
  [[nodiscard]] R energy(const TensorOf<Text::dimension, R>& H) const {
    return Text::energy(H, past_.memory);
  }
  template <class R>
  [[nodiscard]] TensorOf<Text::dimension, R> stress(const TensorOf<Text::dimension, R>& H,
                                                    Mask<R>& good) const {
    R now[Text::memory];
    return Text::stress(H, past_, now, good);
  }

 protected:
  static constexpr double virgin[Text::memory] = {};
  Past past_{virgin, 0.0};
};

/// A law from its text, with tensors for components. A text has, beside its constants,
///
///     dimension, name, small_strain, keys: its constants, whose values a constructor takes
///     R energy(TensorOf<D, R> H)                       for double and its dual numbers
///     TensorOf<D, R> stress(H, Mask<R>& good)          for vectors and theirs too
///     double transverse_stretch(H), transverse_stress(H), margin(H)
///
/// where `good` is lost outside the law's range, and may have what any_law.hpp and the sweep ask
/// for: `range` in words, `at_rest()`, the linear law of small strains, and `multiply_adds`, the
/// work of `stress` in an inner loop, a division as four.
///
/// A text of a law whose stress depends on what a point has gone through has instead
///
///     static constexpr int memory: the numbers that a point remembers, zero in virgin material
///     double energy(H, const double* now)              stored, at H and the memory there
///     TensorOf<D, R> stress(H, Past, R* now, good)     and the memory at H, into `now`
///     double dissipated(const double* now)             since the start [J/m³]
///
/// A past of dt = 0 is that of a sudden change of H: rates have no time to act. The tangent is that
/// of `stress` at a given past; with the memory at H and dt = 0 it limits the step. Memories are
/// scalars or tensors of the reference configuration.
template <class Text>
class Law : public std::conditional_t<Remembers<Text>, AtPast<Text>, Text> {
 public:
  using Base = std::conditional_t<Remembers<Text>, AtPast<Text>, Text>;
  static constexpr int D = Text::dimension;
  using Base::Base;
  explicit Law(const Text& text) : Base(text) {}

  [[nodiscard]] double energy(const Tensor<D>& H) const { return Base::energy(components(H)); }
  /// Without a memory `now` is left alone.
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H, [[maybe_unused]] double* now = nullptr) const {
    bool good = true;
    if constexpr (Remembers<Text>)
      if (now != nullptr) return tensor(Text::stress(components(H), this->past_, now, good));
    return tensor(Base::stress(components(H), good));
  }
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    return tensor(action_of<D>(text(), components(H), components(dH)));
  }
  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const {
    const auto A = tangent_of<D>(text(), components(H));
    return Tangent<D>::NullaryExpr([&](Index row, Index column) {
      return A(static_cast<int>(row), static_cast<int>(column));
    });
  }
  [[nodiscard]] double transverse_stretch(const Tensor<D>& H) const {
    return Text::transverse_stretch(components(H));
  }
  [[nodiscard]] double transverse_stress(const Tensor<D>& H) const {
    return Text::transverse_stress(components(H));
  }
  [[nodiscard]] double margin(const Tensor<D>& H) const { return Text::margin(components(H)); }
  [[nodiscard]] const Base& text() const { return *this; }

  /// Numbers that a material point remembers.
  [[nodiscard]] static constexpr int memory() {
    if constexpr (Remembers<Text>)
      return Text::memory;
    else
      return 0;
  }
  /// The law at a past: this one, of virgin points and sudden changes, where it has no memory.
  [[nodiscard]] decltype(auto) at([[maybe_unused]] const Past& past) const {
    if constexpr (Remembers<Text>) {
      Law here = *this;
      here.past_ = {past.memory != nullptr ? past.memory : Base::virgin, past.dt};
      return here;
    } else {
      return (*this);
    }
  }
  /// Energy that points of that past have lost [J/m³].
  [[nodiscard]] double dissipated() const {
    if constexpr (Remembers<Text>)
      return Text::dissipated(this->past_.memory);
    else
      return 0.0;
  }

 private:
  static TensorOf<D, double> components(const Tensor<D>& H) {
    TensorOf<D, double> result;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) result(i, a) = H(i, a);
    return result;
  }
  static Tensor<D> tensor(const TensorOf<D, double>& P) {
    Tensor<D> result;
    for (int i = 0; i < D; ++i)
      for (int a = 0; a < D; ++a) result(i, a) = P(i, a);
    return result;
  }
};

}  // namespace tlsph
