#pragma once
/// \file
/// Every law, listed once. Visit outside the loop:
///
///     std::visit([&](const auto& law) { for (…) P = law.pk1(H); }, any_law);
///
/// A new law is one struct, its two lines here, one line in the maker and one entry in the typed
/// tests. A caller's own law needs none of them: `GivenLaw` holds it.

#include <string>
#include <string_view>
#include <variant>

#include "tlsph/materials/given_law.hpp"
#include "tlsph/materials/linear_elastic.hpp"
#include "tlsph/materials/neo_hookean.hpp"
#include "tlsph/materials/st_venant_kirchhoff.hpp"

namespace tlsph {

template <int D>
using AnyLaw =
    std::variant<LinearElastic<D, Assumption::strain>, LinearElastic<D, Assumption::stress>,
                 StVenantKirchhoff<D, Assumption::strain>, StVenantKirchhoff<D, Assumption::stress>,
                 NeoHookean<D, Assumption::strain>, NeoHookean<D, Assumption::stress>,
                 GivenLaw<D, false>, GivenLaw<D, true>>;

enum class LawName { linear_elastic, st_venant_kirchhoff, neo_hookean };

/// The law of that name with Young's modulus [Pa] and Poisson's ratio. Throws InputError unless
/// young > 0 and −1 < poisson < 1/2.
template <int D>
[[nodiscard]] AnyLaw<D> make_law(LawName name, Assumption assumption, double young, double poisson);

// The functions of a law for callers outside the loops.

/// Ψ [J/m³].
template <int D>
[[nodiscard]] double energy(const AnyLaw<D>& law, const Tensor<D>& H);
/// P [Pa].
template <int D>
[[nodiscard]] Tensor<D> pk1(const AnyLaw<D>& law, const Tensor<D>& H);
/// ∂P/∂F [Pa].
template <int D>
[[nodiscard]] Tangent<D> tangent(const AnyLaw<D>& law, const Tensor<D>& H);
/// True for laws that are linear in H, for which det F has no meaning.
template <int D>
[[nodiscard]] bool small_strain(const AnyLaw<D>& law);
/// How far H lies inside the law's range: positive inside, zero, negative or NaN outside.
template <int D>
[[nodiscard]] double margin(const AnyLaw<D>& law, const Tensor<D>& H);
/// The range in words, for messages: "det F > 0", and what else the law asks for.
template <int D>
[[nodiscard]] std::string range(const AnyLaw<D>& law);

}  // namespace tlsph
