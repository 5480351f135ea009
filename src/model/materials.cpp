#include <fmt/format.h>

#include <algorithm>

#include "parts.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph::parts {
namespace {

/// Node masses where density jumps between cells: each corner takes its share of its own cells, in
/// a cloud each end of an edge half of the part that belongs to it.
template <int D>
ScalarField masses_by_cell(const Scene& scene, const Particles<D>& particles,
                           const MaterialPoints<D>& points) {
  ScalarField mass = ScalarField::Zero(particles.size());
  if constexpr (D == 2) {
    const std::vector<TriangleEdge> edges = edges_of(particles.triangles);
    for (std::size_t s = 0; s < edges.size(); ++s) {
      const auto point = static_cast<Index>(s);
      const Vector<2> at = points.X.row(point).transpose();
      const double density =
          scene.materials[material_at<2>(scene, at, 1e-9 * particles.spacing)].density;
      for (const int node : {edges[s].a, edges[s].b}) mass[node] += 0.5 * density * points.V[point];
    }
  }
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    std::vector<Cell<D>> cells;
    for (std::size_t s = 0; s < particles.cells.size(); ++s) {
      const Vector<D> at = points.X.row(static_cast<Index>(s)).transpose();
      if (material_at<D>(scene, at, 1e-9 * particles.spacing) == k)
        cells.push_back(particles.cells[s]);
    }
    mass += scene.materials[k].density * node_volumes<D>(particles.X, cells);
  }
  return mass;
}

}  // namespace

template <int D>
std::size_t material_at(const Scene& scene, const Vector<D>& X, double tolerance) {
  for (std::size_t k = scene.materials.size(); k-- > 0;) {
    const MaterialScene& material = scene.materials[k];
    bool inside = true;
    if (material.lower.empty()) return k;
    for (int a = 0; a < D; ++a) {
      const auto d = static_cast<std::size_t>(a);
      inside =
          inside && X[a] >= material.lower[d] - tolerance && X[a] <= material.upper[d] + tolerance;
    }
    if (inside) return k;
  }
  return 0;
}

template <int D>
void add_materials(const Scene& scene, Discretisation<D>& body) {
  const double tolerance = 1e-9 * body.particles.spacing;
  std::vector<std::vector<int>> members(scene.materials.size());
  for (Index s = 0; s < body.points.size(); ++s) {
    const Vector<D> at = body.points.X.row(s).transpose();
    members[material_at<D>(scene, at, tolerance)].push_back(static_cast<int>(s));
  }
  ScalarField density(body.points.size());
  for (std::size_t k = 0; k < scene.materials.size(); ++k) {
    const MaterialScene& material = scene.materials[k];
    if (members[k].empty())
      throw InputError(
          material.place,
          "the region holds no material point; move or enlarge its box, or leave it out");
    for (const int s : members[k]) density[s] = material.density;
    Region<D> region{
        make_law<D>(material.law, material.assumption, material.constants), material.density, {}};
    if (scene.materials.size() > 1) region.points = std::move(members[k]);
    body.regions.push_back(std::move(region));
  }
  if (is_collocated(scene.formulation))
    body.mass = density.cwiseProduct(body.particles.V);
  else
    body.mass = scene.materials.size() == 1
                    ? ScalarField(scene.materials[0].density * body.particles.V)
                    : masses_by_cell<D>(scene, body.particles, body.points);
}

template std::size_t material_at<1>(const Scene&, const Vector<1>&, double);
template std::size_t material_at<2>(const Scene&, const Vector<2>&, double);
template void add_materials<1>(const Scene&, Discretisation<1>&);
template void add_materials<2>(const Scene&, Discretisation<2>&);

}  // namespace tlsph::parts
