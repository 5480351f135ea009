#include "tlsph/particles/boundary_faces.hpp"

#include <algorithm>

namespace tlsph {

template <int D>
VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces) {
  VectorField<D> B = VectorField<D>::Zero(nodes, D);
  for (const auto& face : faces)
    for (const int node : face.nodes) B.row(node) += face.area.transpose() / D;
  return B;
}

template <int D>
Patch<D> make_patch(std::string name, std::vector<Face<D>> faces) {
  Patch<D> patch{std::move(name), {}, std::move(faces)};
  for (const auto& face : patch.faces)
    patch.nodes.insert(patch.nodes.end(), face.nodes.begin(), face.nodes.end());
  std::sort(patch.nodes.begin(), patch.nodes.end());
  patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
  return patch;
}

template VectorField<1> lumped_areas(Index, const std::vector<Face<1>>&);
template VectorField<2> lumped_areas(Index, const std::vector<Face<2>>&);
template Patch<1> make_patch(std::string, std::vector<Face<1>>);
template Patch<2> make_patch(std::string, std::vector<Face<2>>);

}  // namespace tlsph
