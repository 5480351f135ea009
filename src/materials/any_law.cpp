#include "tlsph/materials/any_law.hpp"

#include <fmt/format.h>

namespace tlsph {

namespace {

template <int D, class... Text>
AnyLaw<D> make_listed(laws::List<Text...>, std::size_t index, const Lame& constants) {
  using Make = AnyLaw<D> (*)(const Lame&);
  constexpr Make make[] = {[](const Lame& of) -> AnyLaw<D> { return Law<Text>(of); }...};
  return make[index](constants);
}

}  // namespace

template <int D>
AnyLaw<D> make_law(LawName name, Assumption assumption, double young, double poisson) {
  const auto index = 2 * static_cast<std::size_t>(name) + static_cast<std::size_t>(assumption);
  return make_listed<D>(laws::Listed<D>(), index, lame(young, poisson));
}

template <int D>
std::string range(const AnyLaw<D>& law) {
  return std::visit(
      []<class Held>(const Held& held) -> std::string {
        std::string text = "det F > 0";
        if constexpr (requires { Held::range; }) text = Held::range;
        if constexpr (requires { held.largest_uniaxial_stretch(); }) {
          const double stretch = held.largest_uniaxial_stretch();
          if (stretch > 1) text += fmt::format(" (uniaxial stretch below {:.3f})", stretch);
          text += "; \"neo-hookean\" goes further";
        }
        return text;
      },
      law);
}

template AnyLaw<1> make_law<1>(LawName, Assumption, double, double);
template AnyLaw<2> make_law<2>(LawName, Assumption, double, double);
template AnyLaw<3> make_law<3>(LawName, Assumption, double, double);
template std::string range<1>(const AnyLaw<1>&);
template std::string range<2>(const AnyLaw<2>&);

}  // namespace tlsph
