#pragma once
/// \file
/// A variant of all laws. Visit outside the loop:
///
///     std::visit([&](const auto& law) { for (…) P = law.pk1(H); }, any_law);
///
/// The laws are listed in law_list.hpp. A caller's own law is not: `GivenLaw` holds it.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tlsph/materials/given_law.hpp"
#include "tlsph/materials/law_list.hpp"

namespace tlsph {

template <int D, Assumption A = Assumption::strain>
using LinearElastic = Law<laws::LinearElastic<D, A>>;
template <int D, Assumption A = Assumption::strain>
using StVenantKirchhoff = Law<laws::StVenantKirchhoff<D, A>>;
template <int D, Assumption A = Assumption::strain>
using NeoHookean = Law<laws::NeoHookean<D, A>>;

static_assert(ElasticLaw<LinearElastic<2>, 2>);
static_assert(ElasticLaw<StVenantKirchhoff<2>, 2>);
static_assert(ElasticLaw<NeoHookean<2>, 2>);

namespace laws {

template <int D, class... Text>
std::variant<Law<Text>..., GivenLaw<D, false>, GivenLaw<D, true>> any_of(List<Text...>);

}  // namespace laws

/// The listed laws in their order, then those of a caller.
template <int D>
using AnyLaw = decltype(laws::any_of<D>(laws::Listed<D>()));

/// The law of that name with the values of its constants, in the order of `constants_of`. Throws
/// InputError unless there are as many, each in its range.
template <int D>
[[nodiscard]] AnyLaw<D> make_law(LawName name, Assumption assumption,
                                 std::span<const double> constants);
/// The same for Young's modulus [Pa] and Poisson's ratio.
template <int D>
[[nodiscard]] AnyLaw<D> make_law(LawName name, Assumption assumption, double young,
                                 double poisson) {
  return make_law<D>(name, assumption, std::array{young, poisson});
}

/// The constants of all listed laws, each name once.
[[nodiscard]] std::vector<LawConstant> all_law_constants();

/// Elastic moduli of small strains.
struct Moduli {
  double young = 0.0, poisson = 0.0, shear = 0.0;  ///< [Pa], –, [Pa]
};

/// Of an isotropic body whose tangent at rest has the same A_1111, A_1122 and A_1212.
template <ElasticLaw<3> SolidLaw>
[[nodiscard]] Moduli moduli_at_rest(const SolidLaw& law) {
  const Tangent<3> A = law.tangent(Tensor<3>::Zero());
  const double lambda = A(0, 4), mu = A(1, 1);
  return {mu * (3 * lambda + 2 * mu) / (lambda + mu), 0.5 * lambda / (lambda + mu), mu};
}
[[nodiscard]] Moduli moduli_at_rest(LawName name, std::span<const double> constants);

// The functions of a law for callers outside the loops.

/// Numbers that a material point remembers.
template <int D>
[[nodiscard]] int memory(const AnyLaw<D>& any) {
  return std::visit([](const auto& law) { return law.memory(); }, any);
}
/// Ψ [J/m³].
template <int D>
[[nodiscard]] double energy(const AnyLaw<D>& any, const Tensor<D>& H) {
  return std::visit([&](const auto& law) { return law.energy(H); }, any);
}
/// P [Pa].
template <int D>
[[nodiscard]] Tensor<D> pk1(const AnyLaw<D>& any, const Tensor<D>& H) {
  return std::visit([&](const auto& law) { return law.pk1(H); }, any);
}
/// ∂P/∂F [Pa].
template <int D>
[[nodiscard]] Tangent<D> tangent(const AnyLaw<D>& any, const Tensor<D>& H, const Past& past = {}) {
  return std::visit([&](const auto& law) { return law.at(past).tangent(H); }, any);
}
/// True for laws that are linear in H, for which det F has no meaning.
template <int D>
[[nodiscard]] bool small_strain(const AnyLaw<D>& any) {
  return std::visit([](const auto& law) { return law.small_strain; }, any);
}
/// How far H lies inside the law's range: positive inside, zero, negative or NaN outside.
template <int D>
[[nodiscard]] double margin(const AnyLaw<D>& any, const Tensor<D>& H) {
  return std::visit([&](const auto& law) { return law.margin(H); }, any);
}
/// The range in words, for messages: "det F > 0", and what else the law asks for.
template <int D>
[[nodiscard]] std::string range(const AnyLaw<D>& any);
/// The law of small strains, where it is a listed one.
template <int D>
[[nodiscard]] std::optional<AnyLaw<D>> at_rest(const AnyLaw<D>& any) {
  return std::visit(
      [](const auto& law) -> std::optional<AnyLaw<D>> {
        if constexpr (requires { law.at_rest(); })
          return AnyLaw<D>(Law(law.at_rest()));
        else
          return std::nullopt;
      },
      any);
}

}  // namespace tlsph
