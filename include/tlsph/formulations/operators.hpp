#pragma once
/// \file
/// The operators G and D of each formulation, on the particles of a body.

#include <optional>

#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/formulations/extension.hpp"
#include "tlsph/formulations/formulation.hpp"
#include "tlsph/kernels/families.hpp"

namespace tlsph {

/// What is left to choose of the operators once the formulation is; each takes what concerns it.
struct OperatorChoices {
  AnyKernel kernel;
  std::optional<double> support;  ///< full radius in spacings; none: the nodes of the cell
  int order = 1;                  ///< of the polynomials a least-squares gradient is exact for
  Correction correction = Correction::least_squares;
  std::optional<ConsistencyDegrees> consistency = {};  ///< none: gradients stay as they are fitted
  Place consistency_place = {};                        ///< for complaints
  GhostClosure ghosts = GhostClosure::consistent;
  SolverChoice solver = SolverChoice::automatic;  ///< of the ghosts
  Place solver_place = {};
};

/// How far weights and volumes of particles that mean the same may differ, relative.
template <int D>
[[nodiscard]] double rounding_of(const Particles<D>& particles);

/// Where the stresses of a formulation are. InputError if the particles have no cells for them.
template <int D>
[[nodiscard]] MaterialPoints<D> stress_points(Formulation formulation,
                                              const Particles<D>& particles);

/// G and D of a body that has its particles and points, with the signal terms of its edges and the
/// reactions of those that move. `edges` are the sides of a box, read where fields go on beyond
/// them. InputError where the particles do not carry the formulation.
template <int D>
void add_operators(Formulation formulation, const OperatorChoices& choices, const Edges<D>& edges,
                   Discretisation<D>& body);

}  // namespace tlsph
