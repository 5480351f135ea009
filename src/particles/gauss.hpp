#pragma once
/// \file
/// Gauss–Legendre rules on [0, 1].

#include <array>
#include <cstddef>

namespace tlsph {

template <std::size_t N>
struct GaussRule {
  std::array<double, N> point, weight;
};

/// Exact to degree five.
inline constexpr GaussRule<3> gauss_3 = {{0.1127016653792583, 0.5, 0.8872983346207417},
                                         {5.0 / 18, 8.0 / 18, 5.0 / 18}};
/// Exact to degree seven.
inline constexpr GaussRule<4> gauss_4 = {
    {0.06943184420297371, 0.33000947820757187, 0.66999052179242813, 0.93056815579702629},
    {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693}};

}  // namespace tlsph
