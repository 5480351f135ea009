#pragma once
/// \file
/// A body at small strains, solved instead of stepped: displacements at rest, and the lowest
/// natural frequency, of the operators that a run of the scene would use.

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/linear/factorization.hpp"

namespace tlsph {

/// The rows and columns of a square matrix that are chosen.
[[nodiscard]] SparseMatrix among(const SparseMatrix& matrix, const std::vector<Index>& chosen);

class LinearBody {
 public:
  /// Factorises the stiffness at H = 0 among the free degrees of freedom. NumericalError if some
  /// motion costs no energy.
  explicit LinearBody(const Discretisation<2>& body);

  /// The displacements (N×2) at which the body rests under forces (N×2) [N per thickness].
  [[nodiscard]] VectorField<2> at_rest(const VectorField<2>& forces) const;
  /// The lowest ω [rad/s], to 1e-12 of it, by inverse iteration.
  [[nodiscard]] double lowest_frequency() const;

 private:
  const Discretisation<2>& body_;
  std::vector<Index> free_;
  Cholesky factor_;
};

}  // namespace tlsph
