#pragma once
/// \file
/// Stress as an observer wants it: in the deformed configuration, and as scalars.

#include "tlsph/formulations/discretisation.hpp"

namespace tlsph {

/// Cauchy stress σ = P Fᵀ/J [Pa], pressure −tr σ/3 (compression positive) and von Mises stress of
/// the three-dimensional state.
template <int D>
struct StressMeasures {
  Tensor<D> cauchy;
  double pressure = 0.0;
  double von_mises = 0.0;
};

/// The measures of P at displacement gradient H, and the memory of the law there, in a region of
/// the body.
template <int D>
[[nodiscard]] StressMeasures<D> stress_measures(const Region<D>& region, const Tensor<D>& H,
                                                const Tensor<D>& P, const Past& past = {});

/// The region a material point belongs to.
template <int D>
[[nodiscard]] std::size_t region_of(const Discretisation<D>& discretisation, Index point);

}  // namespace tlsph
