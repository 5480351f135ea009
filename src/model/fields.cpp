#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/exact/solutions.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

using Kind = Condition::Kind;

template <int D>
Box<D> body_box(const Scene& scene) {
  return bounding_box<D>(std::get<Shape<D>>(scene.body.shape));
}

SwingingPlate plate_of(const Scene& scene, double amplitude) {
  const Box<2> box = body_box<2>(scene);
  const MaterialScene& material = scene.materials.front();
  SwingingPlate plate;
  plate.corner = box.lower;
  plate.length = box.upper[0] - box.lower[0];
  plate.shear_modulus = material.moduli().shear;
  plate.density = material.density;
  plate.amplitude = amplitude;
  return plate;
}

/// One vector field of the initial state.
template <int D>
VectorField<D> initial_field(const Scene& scene, const InitialField& field,
                             const Particles<D>& particles) {
  VectorField<D> result = VectorField<D>::Zero(particles.size(), D);
  const auto fill = [&](const auto& value_at) {
    for (Index q = 0; q < particles.size(); ++q)
      result.row(q) = value_at(Vector<D>(particles.X.row(q).transpose())).transpose();
    return result;
  };
  if (field.kind == InitialField::Kind::zero) return result;
  if (field.kind == InitialField::Kind::linear)
    return fill([&](const Vector<D>& X) {
      Vector<D> u = Vector<D>::Zero();
      for (std::size_t i = 0; i < D; ++i) {
        double& value = u[static_cast<Index>(i)];
        if (!field.constant.empty()) value = field.constant[i];
        for (std::size_t a = 0; a < D && !field.gradient.empty(); ++a)
          value += field.gradient[i][a] * X[static_cast<Index>(a)];
      }
      return u;
    });
  if constexpr (D == 2) {
    if (field.kind == InitialField::Kind::swinging_plate)
      return fill([exact = swinging_plate(plate_of(scene, field.amplitude))](const Vector<2>& X) {
        return exact.displacement(X, 0.0);
      });
    const Box<2> box = body_box<2>(scene);
    return fill([&](const Vector<2>& X) {
      const double along = (X[0] - box.lower[0]) / (box.upper[0] - box.lower[0]);
      return Vector<2>(0.0, field.amplitude * cantilever_mode(along));
    });
  }
  const bool plate = field.kind == InitialField::Kind::swinging_plate;
  throw InputError(field.place, fmt::format("\"{}\" is a field of two dimensions",
                                            plate ? "swinging-plate" : "cantilever-mode"));
}

/// Forces below this share of |P₀| Δ^(d−1) are round-off, or what a fit to boundaries leaves.
constexpr double negligible = 1e-6;

/// Largest entry at a degree of freedom that is free to follow it, and its node.
template <int D>
std::pair<double, Index> largest_free(const Discretisation<D>& body, const VectorField<D>& force) {
  std::pair<double, Index> largest{0.0, 0};
  for (Index dof = 0; dof < force.size(); ++dof)
    if (body.inverse_mass.data()[dof] != 0.0 && std::abs(force.data()[dof]) > largest.first)
      largest = {std::abs(force.data()[dof]), dof / D};
  return largest;
}

/// What the loads leave of P₀ N at the boundary, as a force on each node.
template <int D>
VectorField<D> boundary_residual(const Discretisation<D>& body, const Tensor<D>& P0) {
  VectorField<D> residual = -body.particles.B * P0.transpose();
  for (const Load& load : body.loads) {
    const double pressure = value(load.curve, 0.0);
    for (std::size_t k = 0; k < load.dof.size(); ++k)
      residual.data()[load.dof[k]] += pressure * load.weight[k];
  }
  return residual;
}

/// InputError for a body that starts under a uniform stress which its supports and loads balance,
/// while its operators do not: near boundaries the adjoint of a corrected gradient breaks the
/// divergence theorem, and what a run would show is the energy of that. `displacement` is the
/// initial one of the whole body, before any region of it.
template <int D>
void refuse_imbalance(const Scene& scene, const Discretisation<D>& body,
                      const VectorField<D>& displacement) {
  const InitialField& field = scene.displacement;
  if (field.kind != InitialField::Kind::linear || field.gradient.empty() || !body.adjoint ||
      body.regions.size() > 1 || body.has_body_force())
    return;
  Tensor<D> H0;
  for (int i = 0; i < D; ++i)
    for (int a = 0; a < D; ++a)
      H0(i, a) = field.gradient[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)];
  const Tensor<D> P0 = pk1<D>(body.regions.front().law, H0);
  const double scale = P0.norm() * std::pow(body.spacing, D - 1);
  if (!(scale > 0.0)) return;

  State<D> state = make_state<D>(body, displacement, VectorField<D>::Zero(body.nodes(), D));
  // Supports that start elsewhere, or boundaries whose stress nothing balances, are meant to move.
  if ((state.u - displacement).cwiseAbs().maxCoeff() > 1e-9 * H0.norm() * body.spacing) return;
  if (largest_free<D>(body, boundary_residual<D>(body, P0)).first > negligible * scale) return;

  evaluate<D>(body, state);
  const auto [force, node] = largest_free<D>(body, state.f);
  if (force <= negligible * scale) return;
  std::string at;
  for (int a = 0; a < D; ++a)
    at += fmt::format("{}{:.6g}", a == 0 ? "" : ", ", body.particles.X(node, a));
  throw InputError(
      field.place,
      fmt::format("a body stretched like this and held or loaded at its boundary is in "
                  "equilibrium, but not as {} sees it: its gradients near the boundary leave a "
                  "force of {:.2g} times the stress on the particle at ({}); hold layers at least "
                  "{:.3g} spacings thick, twice the support, on a regular lattice ([[body.tags]] "
                  "and held = true), or use stress-point with the nodes of each cell",
                  name_of(scene.formulation), force / scale, at,
                  2.0 * scene.kernel.support.value_or(1.0)));
}

/// The fields of the regions in place of those of the whole body.
template <int D>
void start_regions(const Scene& scene, const Particles<D>& particles, InitialState<D>& initial) {
  const double tolerance = 1e-6 * particles.spacing;
  for (const InitialRegion& region : scene.initial_regions) {
    const Vector<D> lower = Eigen::Map<const Vector<D>>(region.lower.data());
    const Vector<D> upper = Eigen::Map<const Vector<D>>(region.upper.data());
    std::vector<Index> members;
    for (Index q = 0; q < particles.size(); ++q) {
      const Vector<D> X = particles.X.row(q).transpose();
      if (((X - lower).array() >= -tolerance).all() && ((upper - X).array() >= -tolerance).all())
        members.push_back(q);
    }
    if (members.empty())
      throw InputError(region.place,
                       "the region holds no particle; move or enlarge its box, or leave it out");
    const auto replace = [&](const std::optional<InitialField>& field, VectorField<D>& target) {
      if (!field) return;
      const VectorField<D> source = initial_field<D>(scene, *field, particles);
      for (const Index q : members) target.row(q) = source.row(q);
    };
    replace(region.displacement, initial.displacement);
    replace(region.velocity, initial.velocity);
  }
}

template <int D>
ExactSolution<D> bar_wave_of(const Scene& scene, const Discretisation<D>& body) {
  const Box<D> box = body_box<D>(scene);
  const Tangent<D> A = tangent<D>(body.regions.front().law, Tensor<D>::Zero());
  BarWave bar;
  bar.lower = box.lower[0];
  bar.length = box.upper[0] - box.lower[0];
  bar.modulus = A(0, 0);
  if constexpr (D == 2) bar.lateral_modulus = A(3, 0);
  bar.density = body.regions.front().density;
  const PatchConditions left(scene, "left"), right(scene, "right");
  const Condition* pull = left.find(Kind::loaded, 0);  // the rules of a scene leave one of the two
  const bool lower = pull != nullptr;
  if (!lower) pull = right.find(Kind::loaded, 0);
  bar.traction = tension(*pull, lower ? -1.0 : 1.0);
  bar.loaded = lower ? BarWave::Side::lower : BarWave::Side::upper;
  const bool fixed = (lower ? right : left).has(Kind::fixed, 0);
  bar.far_end = fixed ? BarWave::Support::fixed : BarWave::Support::free;
  return bar_wave<D>(bar);
}

template <int D>
ExactSolution<D> uniform_stretch_of(const Scene& scene, const Discretisation<D>& body) {
  const Box<D> box = body_box<D>(scene);
  const double length = box.upper[0] - box.lower[0];
  const PatchConditions left(scene, "left"), right(scene, "right");
  const Condition* moved = right.find(Kind::moved, 0);  // the rules leave one of the two at least
  const bool upper = moved != nullptr;
  if (!upper) moved = left.find(Kind::moved, 0);
  return uniform_stretch<D>(
      {upper ? box.lower[0] : box.upper[0], upper ? length : -length, *moved->curve},
      body.regions.front().law);
}

}  // namespace

template <int D>
InitialState<D> build_initial(const Scene& scene, const Discretisation<D>& body) {
  InitialState<D> initial{initial_field<D>(scene, scene.displacement, body.particles),
                          initial_field<D>(scene, scene.velocity, body.particles)};
  refuse_imbalance<D>(scene, body, initial.displacement);
  start_regions<D>(scene, body.particles, initial);
  return initial;
}

template <int D>
ExactSolution<D> build_exact(const Scene& scene, const Discretisation<D>& body) {
  switch (scene.exact) {
    case ExactKind::none:
      break;
    case ExactKind::bar_wave:
      return bar_wave_of<D>(scene, body);
    case ExactKind::swinging_plate:
      if constexpr (D == 2) {
        if (scene.displacement.kind != InitialField::Kind::swinging_plate)
          throw InputError(scene.exact_place,
                           "\"swinging-plate\" needs initial.displacement = { field = "
                           "\"swinging-plate\", amplitude = … }");
        return swinging_plate(plate_of(scene, scene.displacement.amplitude));
      }
      break;
    case ExactKind::uniform_stretch:
      return uniform_stretch_of<D>(scene, body);
  }
  return {};
}

template InitialState<1> build_initial<1>(const Scene&, const Discretisation<1>&);
template InitialState<2> build_initial<2>(const Scene&, const Discretisation<2>&);
template ExactSolution<1> build_exact<1>(const Scene&, const Discretisation<1>&);
template ExactSolution<2> build_exact<2>(const Scene&, const Discretisation<2>&);

}  // namespace tlsph
