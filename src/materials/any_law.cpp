#include "tlsph/materials/any_law.hpp"

#include <fmt/format.h>

namespace tlsph {

namespace {

template <template <int, Assumption> class Law, int D>
AnyLaw<D> with_assumption(Assumption assumption, const Lame& constants) {
  if (assumption == Assumption::strain) return Law<D, Assumption::strain>(constants);
  return Law<D, Assumption::stress>(constants);
}

}  // namespace

template <int D>
AnyLaw<D> make_law(LawName name, Assumption assumption, double young, double poisson) {
  const Lame constants = lame(young, poisson);
  switch (name) {
    case LawName::st_venant_kirchhoff:
      return with_assumption<StVenantKirchhoff, D>(assumption, constants);
    case LawName::neo_hookean:
      return with_assumption<NeoHookean, D>(assumption, constants);
    case LawName::linear_elastic:
      break;
  }
  return with_assumption<LinearElastic, D>(assumption, constants);
}

template <int D>
double energy(const AnyLaw<D>& law, const Tensor<D>& H) {
  return std::visit([&](const auto& held) { return held.energy(H); }, law);
}

template <int D>
Tensor<D> pk1(const AnyLaw<D>& law, const Tensor<D>& H) {
  return std::visit([&](const auto& held) { return held.pk1(H); }, law);
}

template <int D>
Tangent<D> tangent(const AnyLaw<D>& law, const Tensor<D>& H) {
  return std::visit([&](const auto& held) { return held.tangent(H); }, law);
}

template <int D>
bool small_strain(const AnyLaw<D>& law) {
  return std::visit([](const auto& held) { return held.small_strain; }, law);
}

template <int D>
double margin(const AnyLaw<D>& law, const Tensor<D>& H) {
  return std::visit([&](const auto& held) { return held.margin(H); }, law);
}

template <int D>
std::string range(const AnyLaw<D>& law) {
  return std::visit(
      []<class Law>(const Law& held) -> std::string {
        if constexpr (std::is_same_v<Law, StVenantKirchhoff<D, Assumption::stress>>) {
          const double stretch = held.largest_uniaxial_stretch();
          return fmt::format(
              "det F > 0 and 1 + 2 E_33 > 0, E_33 the strain of the directions free of "
              "stress{}; \"neo-hookean\" goes further",
              stretch > 1 ? fmt::format(" (uniaxial stretch below {:.3f})", stretch) : "");
        } else if constexpr (std::is_same_v<Law, NeoHookean<D, Assumption::stress>>) {
          return "det F > 0 and, for a negative Poisson's ratio, a transverse stretch free of "
                 "stress";
        } else {
          return "det F > 0";
        }
      },
      law);
}

template AnyLaw<1> make_law<1>(LawName, Assumption, double, double);
template AnyLaw<2> make_law<2>(LawName, Assumption, double, double);
template AnyLaw<3> make_law<3>(LawName, Assumption, double, double);
template double energy<1>(const AnyLaw<1>&, const Tensor<1>&);
template double energy<2>(const AnyLaw<2>&, const Tensor<2>&);
template double energy<3>(const AnyLaw<3>&, const Tensor<3>&);
template Tensor<1> pk1<1>(const AnyLaw<1>&, const Tensor<1>&);
template Tensor<2> pk1<2>(const AnyLaw<2>&, const Tensor<2>&);
template Tensor<3> pk1<3>(const AnyLaw<3>&, const Tensor<3>&);
template Tangent<1> tangent<1>(const AnyLaw<1>&, const Tensor<1>&);
template Tangent<2> tangent<2>(const AnyLaw<2>&, const Tensor<2>&);
template Tangent<3> tangent<3>(const AnyLaw<3>&, const Tensor<3>&);
template bool small_strain<1>(const AnyLaw<1>&);
template bool small_strain<2>(const AnyLaw<2>&);
template bool small_strain<3>(const AnyLaw<3>&);
template double margin<1>(const AnyLaw<1>&, const Tensor<1>&);
template double margin<2>(const AnyLaw<2>&, const Tensor<2>&);
template double margin<3>(const AnyLaw<3>&, const Tensor<3>&);
template std::string range<1>(const AnyLaw<1>&);
template std::string range<2>(const AnyLaw<2>&);

}  // namespace tlsph
