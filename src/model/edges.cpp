#include <fmt/format.h>

#include <string>
#include <string_view>

#include "parts.hpp"
#include "tlsph/materials/uniaxial.hpp"
#include "tlsph/scene/conditions.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph::parts {
namespace {

constexpr std::array<std::array<std::string_view, 2>, 2> edge_names = {
    {{"left", "right"}, {"bottom", "top"}}};

/// The strain of the load must exist at all times; a coarse walk along the curve finds out before
/// the run does.
template <int D>
void refuse_unreachable(const Scene& scene, const Discretisation<D>& body, const Curve& load,
                        const BoundaryScene& boundary) {
  constexpr int samples = 256;
  for (int k = 0; k <= samples; ++k) {
    const double pressure = value(load, scene.time.end * k / samples);
    try {
      for (const Region<D>& region : body.regions) (void)uniaxial_gradient<D>(region.law, pressure);
    } catch (const InputError& error) {
      throw InputError(boundary.place, fmt::format("traction: {}", error.what()));
    }
  }
}

/// Reads one edge; `b` is its normal direction.
template <int D>
Edge<D> read_edge(const Scene& scene, std::string_view name, int b, Discretisation<D>& body) {
  Edge<D> edge;
  const auto signal = [&](const Curve& curve, Signal::Kind kind) {
    const Index node = body.particles.find(std::string(name))->nodes.front();
    const Vector<D> at = body.particles.X.row(node).transpose();
    body.signals.push_back({curve, kind, material_at<D>(scene, at, 1e-9 * body.particles.spacing)});
    return body.signals.size() - 1;
  };
  const double outward = name == edge_names[static_cast<std::size_t>(b)][0] ? -1.0 : 1.0;
  for (const BoundaryScene& boundary : scene.boundaries) {
    if (boundary.where != name) continue;
    for (const Condition& condition : conditions_of(boundary, b)) {
      const auto i = static_cast<std::size_t>(condition.component);
      switch (condition.kind) {
        case Condition::Kind::moved:
          edge.displacement[i] = signal(*condition.curve, Signal::Kind::value);
          [[fallthrough]];
        case Condition::Kind::fixed:
          edge.prescribed[i] = true;
          break;
        case Condition::Kind::loaded: {
          const Curve load = tension(condition, outward);
          refuse_unreachable<D>(scene, body, load, boundary);
          edge.traction = signal(load, Signal::Kind::value);
          edge.gradient = signal(load, Signal::Kind::uniaxial_gradient);
          break;
        }
        case Condition::Kind::held:  // no formulation with edges takes it
          break;
      }
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
Edges<D> build_edges(const Scene& scene, Discretisation<D>& body) {
  Edges<D> edges;
  for (int b = 0; b < D; ++b)
    for (std::size_t side = 0; side < 2; ++side)
      edges[static_cast<std::size_t>(b)][side] =
          read_edge<D>(scene, edge_names[static_cast<std::size_t>(b)][side], b, body);
  if constexpr (D == 2) refuse_tangential_strain(scene, edges);
  return edges;
}

template Edges<1> build_edges<1>(const Scene&, Discretisation<1>&);
template Edges<2> build_edges<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
