#pragma once
/// \file
/// A run described: what the user's scene file says, in SI units, defaults filled in. Plain data;
/// the reader is in scene/reader.hpp, changes by a program are in scene/edit.hpp. Every member that
/// is a key has its row in the table of keys (src/scene/keys*.cpp); its initial value is the
/// default.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/curves/curve.hpp"
#include "tlsph/formulations/formulation.hpp"
#include "tlsph/geometry/shape.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/materials/any_law.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/particles.hpp"
#include "tlsph/scene/defaulted.hpp"

namespace tlsph {

/// Of the weights of G and D where particles are irregular; sums are always in double.
enum class Precision { full, mixed };
/// Of the nodes a body is filled with: rows and columns, or rows shifted by half a spacing.
enum class Layout { square, hexagonal };
enum class StabiliserAction { stiffness, viscosity };
enum class ExactKind { none, bar_wave, swinging_plate, uniform_stretch };

struct NamedBox {  ///< [[body.tag]]: nodes inside [lower, upper] get this name
  std::string name;
  std::vector<double> lower, upper;
  Place place;
};

struct BodyScene {
  std::variant<std::monostate, Shape<1>, Shape<2>> shape;
  std::string cloud;     // file of points, relative to the scene's folder; empty: a lattice
  double spacing = 0.0;  // [m]; 0: estimated from the points of the cloud
  Defaulted<Layout> layout = Layout::square;
  NodePlacement placement = NodePlacement::on_boundary;
  // Outer nodes on curved and slanted edges instead of stairs (filling/fitted.hpp).
  Defaulted<bool> fit = true;
  double jitter = 0.0;  // share of the spacing, interior nodes only
  std::uint64_t seed = 1;
  std::vector<NamedBox> tags;
  Place place, spacing_place, cloud_place;

  /// Scattered nodes between triangles, not the corners of quadrilaterals.
  [[nodiscard]] bool is_cloud() const { return !cloud.empty() || layout == Layout::hexagonal; }
};

struct KernelScene {
  Defaulted<std::string> family;
  // Full radius in spacings; empty = nodes of the cell (stress-point).
  Defaulted<std::optional<double>> support;
  Defaulted<int> order = 1;  // of the polynomials a least-squares gradient is exact for
  Defaulted<Correction> correction = Correction::least_squares;
  Place place;
};

/// Degrees of the polynomials that the gradient and its adjoint are made exact for.
struct ConsistencyScene {
  int rows = 1, columns = 0;
  bool standard = false;  // those that suit the formulation, whichever it is
  Place place;
};

struct StabiliserScene {
  Defaulted<StabiliserKind> kind = StabiliserKind::none;
  std::optional<double> coefficient;  // empty = auto
  Defaulted<StabiliserAction> action = StabiliserAction::stiffness;
  Place place;
};

struct MaterialScene {
  LawName law = LawName::neo_hookean;
  Assumption assumption = Assumption::strain;
  std::vector<double> constants;     // of the law, in the order of constants_of
  double density = 0.0;              // [kg/m^3]
  std::vector<double> lower, upper;  // region box; empty = the rest of the body
  Place place;

  /// The value of a constant of the law, if it has one of that name.
  [[nodiscard]] std::optional<double> constant(std::string_view name) const {
    const auto keys = constants_of(law);
    const auto found = std::ranges::find(keys, name, &LawConstant::name);
    const auto k = static_cast<std::size_t>(found - keys.begin());
    return k < constants.size() ? std::optional(constants[k]) : std::nullopt;
  }
  [[nodiscard]] Moduli moduli() const { return moduli_at_rest(law, constants); }
};

/// Motion or load of one component; `amplitude` is folded into the curve.
struct ComponentCurve {
  int component = 0;
  Curve curve;
};

struct BoundaryScene {
  std::string where;
  std::vector<int> fixed;                // components held at zero
  std::vector<int> held;                 // components that stay where they are at t = 0
  bool symmetry = false;                 // the component normal to the (axis-aligned) patch is zero
  std::vector<ComponentCurve> motion;    // prescribed displacement [m]
  std::optional<Curve> normal_traction;  // tension positive [Pa], reference area
  std::vector<ComponentCurve> traction;  // vector per reference area [Pa]
  Place place;
};

struct TimeScene {
  double end = 0.0;  // [s]
  double safety = 0.9;
  std::optional<double> step;  // [s], instead of safety × critical
  bool allow_unstable = false;
  std::optional<double> energy_tolerance;  // of the largest energy
  Place place, end_place, step_place;
};

struct ProbeScene {
  std::string name;
  std::vector<double> at;
  std::vector<std::string> record = {"displacement"};  // names of quantities
  Place place;
};

/// zero, constant + gradient·X, or a named field.
struct InitialField {
  enum class Kind { zero, linear, swinging_plate, cantilever_mode } kind = Kind::zero;
  std::vector<double> constant;
  std::vector<std::vector<double>> gradient;
  double amplitude = 0.0;  // named fields: of the displacement [m] or velocity [m/s]
  Place place;
};

/// [[initial.region]]: what the nodes in a box start with instead; an empty field leaves it.
struct InitialRegion {
  std::vector<double> lower, upper;
  std::optional<InitialField> displacement, velocity;
  Place place;
};

struct OutputScene {
  int frames = 50;      // full fields, evenly in time, beside the initial one; 0 = none
  int probe_every = 1;  // steps between rows of probes.csv
  int energy_every =
      0;  // steps between rows of the energy ledger; 0 = about 200 rows a run, ≥ 50 apart
  double checkpoint = 60.0;  // wall seconds between checkpoints
  int checkpoint_steps = 0;  // steps between checkpoints, 0 = by wall clock only
  std::vector<std::string> fields = {"displacement", "velocity", "pk1"};
};

struct Scene {
  std::string file;  // path as given
  std::string text;  // the scene as run, overrides applied (TOML)
  std::string title;
  int dimension = 2;
  Formulation formulation = Formulation::stress_point;
  Defaulted<GhostClosure> ghosts = GhostClosure::consistent;
  Defaulted<SolverChoice> boundary_solver = SolverChoice::automatic;
  Precision precision = Precision::full;
  Place formulation_place, boundary_solver_place;
  BodyScene body;
  KernelScene kernel;
  // Empty: gradients stay as they are.
  Defaulted<std::optional<ConsistencyScene>> consistency;
  StabiliserScene stabiliser;
  std::vector<MaterialScene> materials;
  std::vector<BoundaryScene> boundaries;
  std::vector<double> body_force;  // acceleration [m/s²], empty = none
  TimeScene time;
  std::vector<ProbeScene> probes;
  ExactKind exact = ExactKind::none;
  Place exact_place;
  InitialField displacement, velocity;
  std::vector<InitialRegion> initial_regions;  // of overlapping ones the last counts
  OutputScene output;
};

}  // namespace tlsph
