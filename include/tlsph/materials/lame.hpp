#pragma once
/// \file
/// Elastic constants of an isotropic body.

namespace tlsph {

/// The kinematic assumption behind the missing dimensions: no strain there (1D strain, plane
/// strain) or no stress there (1D stress, plane stress).
enum class Assumption { strain, stress };

/// Lamé parameters [Pa].
struct Lame {
  double lambda = 0.0;
  double mu = 0.0;
};

/// λ = Eν/((1+ν)(1−2ν)), μ = E/(2(1+ν)), for Young's modulus E [Pa] and Poisson's ratio ν. Throws
/// InputError unless E > 0 and −1 < ν < 1/2.
[[nodiscard]] Lame lame(double young, double poisson);

/// λ as the D directions in the model see it: λ itself when the 3 − D missing ones are held, and
/// 2μλ/(2μ + (3−D)λ) when they are free of stress (Hooke's law solved for their strain). It makes
/// λ + 2μ Young's modulus in 1D stress and E/(1−ν²) in plane stress.
[[nodiscard]] constexpr double reduced_lambda(const Lame& constants, int dimension,
                                              Assumption assumption) {
  const auto [lambda, mu] = constants;
  if (assumption == Assumption::strain) return lambda;
  return 2 * mu * lambda / (2 * mu + (3 - dimension) * lambda);
}

}  // namespace tlsph
