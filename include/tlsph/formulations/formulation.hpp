#pragma once
/// \file
/// What each formulation is, on one page: `formulation_table` has a row for each, and
/// src/formulations/operators.cpp a builder for each. Defaults of a scene, what it may ask for, and
/// the lists of formulations in messages are read off the table.
///
/// All of them are H = G u, P = ∂Ψ/∂F at F = I + H, f = D P:
///
///     thesis        G = W X W over ghosts solved for in each step     D = V X, stress ghosts at t̄
///     mirror        G = X, images of the nodes eliminated             D = V X, images eliminated
///     variational   G at the nodes, exact for linear fields           D = −GᵀV
///     consistent    the same, corrected so that D is exact too        D = −GᵀV
///     stress-point  G at the centres of cells                         D = −GᵀV

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tlsph/operators/consistency.hpp"
#include "tlsph/operators/gradients.hpp"

namespace tlsph {

enum class Formulation { thesis, mirror, variational, consistent, stress_point };

/// Where stresses are: at the nodes; or one a cell, of a cloud one an edge of its triangles.
enum class StressSites { nodes, cells };
/// What stands for the material beyond the boundary. Natural: nothing, D = −GᵀV makes tractions
/// boundary terms of the forces. Images of the nodes, eliminated from G and D once, and ghosts,
/// solved for in each step, go with the four sides of a box, each with one displacement and a load
/// normal to it, and with plain SPH sums.
enum class Closure { natural, images, ghosts };
/// How the formulation `thesis` closes its boundary: by the modified SPH matrix (2.46) with the
/// coupling to the inner particles that is missing in print, the same as printed, or the η
/// corrections (2.42), (2.45) in 1D.
enum class GhostClosure { consistent, as_printed, eta };
/// Which nodes it works on: a lattice with nodes on the boundary; all with nodes on the boundary;
/// those at the centres of lattice cells too.
enum class NodeSites { lattice, on_boundary, anywhere };
/// Whether gradients are made consistent (operators/consistency.hpp).
enum class Corrected { never, on_request, always };
enum class StabiliserKind { none, pair, cell };

/// What a formulation is and what a scene of it starts from. Pairs hold the values in 1D and 2D.
struct FormulationTraits {
  Formulation formulation;
  std::string_view name;
  StressSites sites = StressSites::nodes;
  Closure closure = Closure::natural;
  NodeSites nodes = NodeSites::on_boundary;
  std::string_view kernel = "wendland-c2";
  /// Full radius in spacings, where gradients are exact for quadratic fields the third; none: the
  /// nodes of the cell.
  std::array<std::optional<double>, 3> support = {2.5, 2.5, 2.5};
  Correction correction = Correction::least_squares;
  Corrected corrected = Corrected::never;
  std::array<ConsistencyDegrees, 2> degrees = {};  ///< of the correction
  ConsistencyDegrees highest = {};                 ///< that it can be corrected to
  std::array<StabiliserKind, 2> stabiliser = {};   ///< `cell` where each point has one
  /// Coefficient of the pair stabiliser beside gradients of order two.
  double pair_beside_quadratic = 0.1;

  [[nodiscard]] std::optional<double> default_support(int dimension, int order) const {
    return support[order > 1 ? 2 : static_cast<std::size_t>(dimension - 1)];
  }
};

inline constexpr std::array<FormulationTraits, 5> formulation_table = {
    {{.formulation = Formulation::thesis,
      .name = "thesis",
      .closure = Closure::ghosts,
      .nodes = NodeSites::lattice,
      .kernel = "modified-mollifier",
      .correction = Correction::none},
     {.formulation = Formulation::mirror,
      .name = "mirror",
      .closure = Closure::images,
      .nodes = NodeSites::lattice,
      .kernel = "modified-mollifier",
      .correction = Correction::none},
     {.formulation = Formulation::variational,
      .name = "variational",
      .nodes = NodeSites::anywhere,
      .stabiliser = {StabiliserKind::none, StabiliserKind::pair}},
     {.formulation = Formulation::consistent,
      .name = "consistent",
      .support = {3.1, 2.6, 3.6},
      .corrected = Corrected::always,
      .degrees = {{{1, 1}, {2, 1}}},
      .highest = {2, 1},
      .stabiliser = {StabiliserKind::pair, StabiliserKind::pair},
      // Its pair errors vanish on quadratic fields, and irregular particles need more of them.
      .pair_beside_quadratic = 0.3},
     {.formulation = Formulation::stress_point,
      .name = "stress-point",
      .sites = StressSites::cells,
      .support = {std::nullopt, std::nullopt, std::nullopt},
      .corrected = Corrected::on_request,
      .stabiliser = {StabiliserKind::none, StabiliserKind::cell}}}};

/// The row of a formulation.
[[nodiscard]] constexpr const FormulationTraits& traits_of(Formulation formulation) {
  return formulation_table[static_cast<std::size_t>(formulation)];
}
static_assert(std::ranges::all_of(formulation_table, [](const FormulationTraits& row) {
  return traits_of(row.formulation).name == row.name;
}));

/// D = −GᵀV, boundaries natural; the others extend the fields beyond them.
[[nodiscard]] constexpr bool is_adjoint(Formulation formulation) {
  return traits_of(formulation).closure == Closure::natural;
}
/// Stress at the nodes themselves.
[[nodiscard]] constexpr bool is_collocated(Formulation formulation) {
  return traits_of(formulation).sites == StressSites::nodes;
}

/// The names of the formulations whose row satisfies a condition: "a, b or c".
template <class Condition>
[[nodiscard]] std::string formulations_where(const Condition& condition) {
  std::vector<std::string_view> names;
  for (const FormulationTraits& row : formulation_table)
    if (condition(row)) names.push_back(row.name);
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text.append(k == 0 ? "" : k + 1 < names.size() ? ", " : " or ").append(names[k]);
  return text;
}
/// Those with natural boundaries.
[[nodiscard]] inline std::string adjoint_formulations() {
  return formulations_where([](const auto& row) { return row.closure == Closure::natural; });
}

}  // namespace tlsph
