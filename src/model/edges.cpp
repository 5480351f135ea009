#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "parts.hpp"
#include "tlsph/materials/uniaxial.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph::parts {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 2> edge_names = {
    {{"left", "right"}, {"bottom", "top"}}};

Curve negated(const Curve& curve) {
  return GivenCurve{[curve](double t) { return -value(curve, t); }};
}

/// The strain of the load must exist at all times; a coarse walk along the curve finds out before
/// the run does.
template <int D>
void refuse_unreachable(const Scene& scene, const Discretisation<D>& disc, const Curve& load,
                        const BoundaryScene& boundary) {
  constexpr int samples = 256;
  for (int k = 0; k <= samples; ++k) {
    const double pressure = value(load, scene.time.end * k / samples);
    try {
      for (const Region<D>& region : disc.regions) (void)uniaxial_gradient<D>(region.law, pressure);
    } catch (const InputError& error) {
      throw InputError(boundary.place, fmt::format("traction: {}", error.what()));
    }
  }
}

/// Reads one edge; `b` is its normal direction.
template <int D>
Edge<D> read_edge(const Scene& scene, std::string_view name, int b, Discretisation<D>& disc) {
  Edge<D> edge;
  const auto signal = [&](const Curve& curve, Signal::Kind kind) {
    const Index node = disc.particles.find(std::string(name))->nodes.front();
    const Vector<D> at = disc.particles.X.row(node).transpose();
    disc.signals.push_back({curve, kind, material_at<D>(scene, at, 1e-9 * disc.particles.spacing)});
    return disc.signals.size() - 1;
  };
  const auto prescribe = [&](int component) {
    edge.prescribed[static_cast<std::size_t>(component)] = true;
  };
  for (const BoundaryScene& boundary : scene.boundaries) {
    if (boundary.where != name) continue;
    for (const int component : boundary.fixed) prescribe(component);
    if (boundary.symmetry) prescribe(b);
    for (const ComponentCurve& motion : boundary.motion) {
      prescribe(motion.component);
      edge.displacement[static_cast<std::size_t>(motion.component)] =
          signal(motion.curve, Signal::Kind::value);
    }
    std::optional<Curve> load = boundary.normal_traction;
    for (const ComponentCurve& traction : boundary.traction) {
      if (traction.component != b)
        throw InputError(boundary.place,
                         fmt::format("formulation \"{}\" takes loads normal to an edge only; use "
                                     "{} for tangential ones",
                                     name_of(scene.formulation), adjoint_formulations()));
      // A vector along the axis pulls at the upper edge and pushes at the lower one.
      const bool lower = name == edge_names[static_cast<std::size_t>(b)][0];
      load = lower ? negated(traction.curve) : traction.curve;
    }
    if (load) {
      refuse_unreachable<D>(scene, disc, *load, boundary);
      edge.traction = signal(*load, Signal::Kind::value);
      edge.gradient = signal(*load, Signal::Kind::uniaxial_gradient);
    }
  }
  int free = 0;
  for (const bool prescribed : edge.prescribed) free += prescribed ? 0 : 1;
  const bool normal = edge.prescribed[static_cast<std::size_t>(b)];
  edge.symmetry = D > 1 && normal && free > 0;
  edge.antisymmetry = D > 1 && !normal && free < D;
  return edge;
}

/// ε̄ = P⁻¹(t̄) knows no strain along the edge: the sides beside a loaded or free edge must forbid
/// it.
void refuse_tangential_strain(const Scene& scene, const Edges<2>& edges) {
  for (std::size_t b = 0; b < 2; ++b)
    for (std::size_t side = 0; side < 2; ++side) {
      const Edge<2>& edge = edges[b][side];
      const std::size_t along = 1 - b;
      if (edge.prescribed[b] || edge.prescribed[along]) continue;
      if (edges[along][0].prescribed[along] && edges[along][1].prescribed[along]) continue;
      throw InputError(
          scene.formulation_place,
          fmt::format(
              "\"{}\" cannot extend the displacement beyond the free edge \"{}\", which strains "
              "along itself; give the neighbouring edges symmetry = true, or use {}",
              name_of(scene.formulation), edge_names[b][side], adjoint_formulations()));
    }
}

}  // namespace

template <int D>
Edges<D> build_edges(const Scene& scene, Discretisation<D>& disc) {
  if (!disc.particles.frame)
    throw InputError(scene.formulation_place,
                     fmt::format("\"{}\" needs an undisturbed interval or box of particles on the "
                                 "boundary; for other bodies use {}",
                                 name_of(scene.formulation), adjoint_formulations()));
  for (const BoundaryScene& boundary : scene.boundaries) {
    bool known = false;
    for (std::size_t b = 0; b < D; ++b)
      for (const std::string_view name : edge_names[b]) known = known || boundary.where == name;
    if (!known)
      throw InputError(
          boundary.place,
          fmt::format("formulation \"{}\" knows whole edges only ({}); \"{}\" is none of "
                      "them",
                      name_of(scene.formulation),
                      D == 1 ? "left, right" : "left, right, bottom, top", boundary.where));
  }
  Edges<D> edges;
  for (int b = 0; b < D; ++b)
    for (std::size_t side = 0; side < 2; ++side)
      edges[static_cast<std::size_t>(b)][side] =
          read_edge<D>(scene, edge_names[static_cast<std::size_t>(b)][side], b, disc);
  if constexpr (D == 2) refuse_tangential_strain(scene, edges);
  return edges;
}

template Edges<1> build_edges<1>(const Scene&, Discretisation<1>&);
template Edges<2> build_edges<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
