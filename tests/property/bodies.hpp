#pragma once
/// \file
/// Small free bodies, discretised in every way that has an adjoint force operator, built from
/// scenes as a user would write them.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "tlsph/core/dimensions.hpp"
#include "tlsph/dynamics/balance.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/kernels/families.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/stepping/critical_step.hpp"

namespace tlsph::property {

inline constexpr double spacing = 0.02;    // [m]
inline constexpr double young = 2e6;       // [Pa]
inline constexpr double density = 1000.0;  // [kg/m³]

/// A body and the operators on it. Empty words are left to the scene's defaults.
struct Variant {
  std::string layout;
  std::string formulation;
  std::string correction;
  std::string kernel;  ///< empty: the nodes of a cell
  std::string support;
  std::string consistency = {};  ///< degrees, "[1, 1]"

  [[nodiscard]] bool one_dimensional() const { return layout == "interval"; }
  [[nodiscard]] bool on_cells() const { return kernel.empty(); }
  /// G·X = I; the difference form without correction differentiates constants only.
  [[nodiscard]] bool linear_exact() const { return correction != "none"; }
  /// Scattered nodes between triangles.
  [[nodiscard]] bool on_triangles() const { return layout == "hexagonal" || layout == "cloud"; }
  /// The stabiliser that goes with these operators.
  [[nodiscard]] std::string stabiliser() const {
    return on_cells() && !one_dimensional() && !on_triangles() ? "cell" : "pair";
  }
  [[nodiscard]] std::string name() const {
    std::string text = formulation + "_" + (on_cells() ? "cell" : kernel) +
                       (correction.empty() ? "" : "_" + correction) + consistency + "_" + layout;
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return std::string_view("-[, ").find(c) != std::string_view::npos; }, '_');
    std::erase(text, ']');
    return text;
  }
};

inline void PrintTo(const Variant& variant, std::ostream* out) {
  *out << variant.name();
}

/// Names tests by their parameter: its `name()` or `name`, or the text that it is.
struct ByName {
  template <class Parameter>
  std::string operator()(const testing::TestParamInfo<Parameter>& test) const {
    if constexpr (requires { test.param.name(); })
      return test.param.name();
    else if constexpr (requires { test.param.name; })
      return test.param.name;
    else
      return test.param;
  }
};

/// A file of points in a triangle of 0.16 m, in no order: an even division of its edges and, a
/// little displaced, the nodes between.
inline std::string triangle_of_points() {
  struct PointsFile {
    PointsFile() = default;
    PointsFile(const PointsFile&) = delete;
    PointsFile& operator=(const PointsFile&) = delete;
    ~PointsFile() { std::filesystem::remove(path); }
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("tlsph_property_" + std::to_string(::getpid()) + ".csv");
  };
  static const PointsFile points;
  const auto& path = points.path;
  constexpr int n = 10;
  std::ofstream file(path);
  file << "tag,y,x\n" << std::setprecision(17);
  for (int k = 0; k < (n + 1) * (n + 1); ++k) {
    const int row = (7 * k) % ((n + 1) * (n + 1));
    const int i = row / (n + 1), j = row % (n + 1);
    if (i + j > n) continue;
    const bool inner = i > 0 && j > 0 && i + j < n;
    const double shift = inner ? 0.15 * std::sin(37.0 * row) : 0.0;
    file << (i == 0 ? "edge" : "") << ',' << 0.01 + 0.016 * (j + shift) << ','
         << -0.03 + 0.016 * (i + 0.4 * j - 0.5 * shift) << '\n';
  }
  return path.string();
}

/// Bodies of 21 to 80 particles, none of them at the origin.
inline std::string body_of(const std::string& layout) {
  if (layout == "interval") return "shape = { interval = [0.1, 0.5] }\n";
  if (layout == "disc") return "shape = { disc = { centre = [0.03, -0.02], radius = 0.08 } }\n";
  if (layout == "hole")
    return "shape = { difference = [ { box = [[-0.05, 0.01], [0.11, 0.17]] },\n"
           "  { disc = { centre = [0.03, 0.09], radius = 0.04 } } ] }\n";
  if (layout == "hexagonal")
    return "shape = { difference = [ { disc = { centre = [0.03, 0.01], radius = 0.1 } },\n"
           "  { disc = { centre = [0.04, 0.02], radius = 0.03 } } ] }\n"
           "layout = \"hexagonal\"\njitter = 0.1\n";
  if (layout == "cloud")
    return "shape = { polygon = [[-0.03, 0.01], [0.13, 0.01], [0.034, 0.17]] }\ncloud = \"" +
           triangle_of_points() + "\"\n";
  const std::string box = "shape = { box = [[-0.03, 0.02], [0.11, 0.12]] }\n";
  return layout == "jittered" ? box + "jitter = 0.2\nseed = 7\n" : box;
}

/// The scene of a free body at rest; `end` is nothing that matters to `build`.
inline Scene scene_of(const Variant& variant, const std::vector<std::string>& overrides = {}) {
  std::string text = variant.one_dimensional() ? "dimension = 1\n" : "dimension = 2\n";
  text += "formulation = \"" + variant.formulation + "\"\n";
  if (!variant.consistency.empty()) text += "consistency = " + variant.consistency + "\n";
  text += "[body]\n" + body_of(variant.layout) + "spacing = 0.02\n";
  if (!variant.kernel.empty()) {
    text += "[kernel]\nfamily = \"" + variant.kernel + "\"\nsupport = " + variant.support + "\n";
    if (!variant.correction.empty()) text += "correction = \"" + variant.correction + "\"\n";
  }
  text += "[stabiliser]\nkind = \"none\"\n";
  text += "[material]\nlaw = \"linear-elastic\"\nyoung = 2e6\npoisson = 0.3\ndensity = 1000\n";
  text += "[time]\nend = 1.0\n[output]\nframes = 0\n";
  return read_scene_text(text, variant.name(), overrides);
}

/// Overrides for a stabiliser of that kind that acts as stiffness; "none" acts as nothing.
inline std::vector<std::string> as_stiffness(const std::string& kind) {
  std::vector<std::string> overrides = {"stabiliser.kind=" + kind};
  if (kind != "none") overrides.emplace_back("stabiliser.as=stiffness");
  return overrides;
}

/// Every kernel × layout × formulation with an adjoint force operator.
inline std::vector<Variant> adjoint_variants() {
  std::vector<Variant> variants;
  for (const char* layout : {"interval", "box", "jittered", "disc", "hole"}) {
    variants.push_back({layout, "stress-point", "", "", ""});
    for (const char* degrees : {"[1, 0]", "[1, 1]"})
      variants.push_back({layout, "consistent", "", "wendland-c2", "3.1", degrees});
    if (std::string_view(layout) != "interval")
      variants.push_back({layout, "consistent", "", "wendland-c2", "3.6", "[2, 1]"});
    variants.push_back({layout, "stress-point", "", "wendland-c2", "2.1", "true"});
    for (const std::string_view kernel : kernel_names()) {
      variants.push_back({layout, "stress-point", "", std::string(kernel), "2.1"});
      for (const char* correction : {"least-squares", "gradient", "mixed", "none"})
        variants.push_back({layout, "variational", correction, std::string(kernel), "2.5"});
    }
  }
  // The geometry differs here, not the kernels.
  for (const char* layout : {"hexagonal", "cloud"}) {
    variants.push_back({layout, "stress-point", "", "", ""});
    variants.push_back({layout, "stress-point", "", "wendland-c2", "2.1"});
    variants.push_back({layout, "stress-point", "", "wendland-c2", "2.1", "true"});
    variants.push_back({layout, "variational", "least-squares", "wendland-c2", "2.5"});
    for (const char* degrees : {"[1, 0]", "[1, 1]"})
      variants.push_back({layout, "consistent", "", "wendland-c2", "3.1", degrees});
    variants.push_back({layout, "consistent", "", "wendland-c2", "3.6", "[2, 1]"});
  }
  return variants;
}

struct Material {
  const char* law;
  const char* assumption;
  std::vector<double> constants = {young, 0.3};  ///< in the order of `constants_of`
  [[nodiscard]] bool linear() const { return std::string_view(law) == "linear-elastic"; }
};

inline std::vector<Material> materials() {
  return {{"linear-elastic", "strain"},      {"linear-elastic", "stress"},
          {"st-venant-kirchhoff", "strain"}, {"st-venant-kirchhoff", "stress"},
          {"neo-hookean", "strain"},         {"neo-hookean", "stress"}};
}

/// Builds the scene in its dimension and hands the discretisation to `use`, a generic function.
template <class Use>
void discretised(const Scene& scene, const Use& use) {
  in_dimension(scene.dimension, [&]<int D>() { use(build<D>(scene)); });
}

template <int D>
AnyLaw<D> law_of(const Material& material) {
  return make_law<D>(
      from_name<LawName>(material.law).value(),
      std::string_view(material.assumption) == "strain" ? Assumption::strain : Assumption::stress,
      material.constants);
}

/// The same discretisation with another material: operators do not depend on it, stabilisers do.
template <int D>
void set_material(Discretisation<D>& body, const Material& material) {
  body.regions.front().law = law_of<D>(material);
}

/// Numbers in [−1, 1), the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : generator_(seed) {}
  double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-52 - 1.0; }
  template <int D>
  VectorField<D> field(Index rows, double size) {
    VectorField<D> result(rows, D);
    for (Index k = 0; k < result.size(); ++k) result.data()[k] = size * (*this)();
    return result;
  }
  template <int D>
  Tensor<D> tensor(double size) {
    Tensor<D> result;
    for (Index k = 0; k < D * D; ++k) result.data()[k] = size * (*this)();
    return result;
  }

 private:
  std::mt19937_64 generator_;
};

/// u = A X + b.
template <int D>
VectorField<D> affine(const VectorField<D>& X, const Tensor<D>& A, const Vector<D>& b) {
  return (X * A.transpose()).rowwise() + b.transpose();
}

/// Rotation of the plane; in 1D there is none.
inline Tensor<2> rotation(double angle) {
  Tensor<2> R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

/// The body at rest at displacements u, with H, P and f there.
template <int D>
State<D> evaluated(const Discretisation<D>& body, const VectorField<D>& u) {
  State<D> state = make_state<D>(body, u, VectorField<D>::Zero(body.nodes(), D));
  evaluate<D>(body, state);
  return state;
}

/// K = −∂f/∂u at rest, dense, degrees of freedom in the order of the fields; for linear elasticity.
template <int D>
Eigen::MatrixXd dense_stiffness(const Discretisation<D>& body) {
  const Index dofs = body.nodes() * D;
  State<D> state = evaluated<D>(body, VectorField<D>::Zero(body.nodes(), D));
  Eigen::MatrixXd K(dofs, dofs);
  for (Index k = 0; k < dofs; ++k) {
    state.u.setZero();
    state.u.data()[k] = 1.0;
    evaluate<D>(body, state);
    K.col(k) = -Eigen::Map<const Eigen::VectorXd>(state.f.data(), dofs);
  }
  return K;
}

/// A body strained by a tenth, and every particle moved a little on top.
template <int D>
VectorField<D> deformed(const Discretisation<D>& body, Random& random) {
  const Tensor<D> A = random.tensor<D>(0.1);
  Vector<D> b;
  for (int i = 0; i < D; ++i) b[i] = 0.3 * random();
  return affine<D>(body.particles.X, A, b) + random.field<D>(body.nodes(), 0.05 * body.spacing);
}

/// A run of `steps` equal steps as the time loop makes them, calling observe(state, done) at
/// every `every`-th instant, the first and the last included, with H, P and f there.
template <int D, class Observe>
void march(const Discretisation<D>& body, State<D>& state, double dt, long steps, long every,
           const Observe& observe) {
  WorkAndImpulse<D> done;
  BoundaryForces<D> forces(body);
  const Instant<D> now{body, state, dt};
  evaluate<D>(body, state);
  start<D>(body, state, dt);
  for (long n = 0;; ++n) {
    evaluate<D>(body, state);
    forces.gather(now);
    if (n > 0) done.add_before(forces, now);
    if (n % every == 0 || n == steps) observe(state, done);
    if (n == steps) return;
    done.add_after(forces, now);
    advance<D>(body, state, dt, static_cast<double>(n + 1) * dt);
  }
}

}  // namespace tlsph::property
