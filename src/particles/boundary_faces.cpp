#include "tlsph/particles/boundary_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "tlsph/geometry/region.hpp"

namespace tlsph {

template <int D>
VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces) {
  VectorField<D> B = VectorField<D>::Zero(nodes, D);
  for (const auto& face : faces)
    for (std::size_t k = 0; k < D; ++k)
      B.row(face.nodes[k]) += face.share[k] * face.area.transpose();
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

LabelledFace<2> labelled(const Face<2>& face, const std::vector<Vector<2>>& witnesses,
                         const OutlineNames& names, const std::vector<Shape<2>>& holes,
                         double tolerance) {
  LabelledFace<2> result{face};
  const auto all = [&](auto holds) {
    return std::all_of(witnesses.begin(), witnesses.end(), holds);
  };
  const NamedPiece& own = names.closest(0.5 * (witnesses[0] + witnesses[1]), face.area);
  result.edge = own.edge;
  if (own.side != no_side && all([&](const Vector<2>& x) {
        return std::abs(x(own.side / 2) - own.piece.from(own.side / 2)) <= tolerance;
      }))
    result.side = own.side;
  for (std::size_t k = holes.size(); k-- > 0;)
    if (all([&](const Vector<2>& x) { return std::abs(depth(holes[k], x)) <= tolerance; }))
      result.hole = static_cast<int>(k) + 1;
  return result;
}

template <int D>
std::vector<Patch<D>> make_patches(const std::vector<LabelledFace<D>>& faces, std::size_t holes) {
  std::vector<Patch<D>> patches;
  const auto add = [&](const std::string& name, auto belongs) {
    std::vector<Face<D>> chosen;
    for (const auto& labelled : faces)
      if (belongs(labelled)) chosen.push_back(labelled.face);
    if (!chosen.empty()) patches.push_back(make_patch<D>(name, std::move(chosen)));
  };
  for (int side = 0; side < 2 * D; ++side)
    add(side_names[static_cast<std::size_t>(side)],
        [side](const auto& face) { return face.side == side; });
  add("hole", [](const auto& face) { return face.hole > 0 && face.side == no_side; });
  for (int k = 1; k <= static_cast<int>(holes); ++k)
    add("hole" + std::to_string(k), [k](const auto& face) { return face.hole == k; });
  add("outer", [](const auto& face) { return face.hole == 0 || face.side != no_side; });
  add("boundary", [](const auto&) { return true; });
  return patches;
}

template <int D>
std::vector<Patch<D>> make_edges(const std::vector<LabelledFace<D>>& faces) {
  std::map<int, std::vector<Face<D>>> by_edge;
  for (const auto& labelled : faces)
    if (labelled.edge > 0) by_edge[labelled.edge].push_back(labelled.face);
  std::vector<Patch<D>> edges;
  for (auto& [number, members] : by_edge)
    edges.push_back(make_patch<D>("edge" + std::to_string(number), std::move(members)));
  return edges;
}

template std::vector<Patch<1>> make_edges(const std::vector<LabelledFace<1>>&);
template std::vector<Patch<2>> make_edges(const std::vector<LabelledFace<2>>&);
template std::vector<Patch<1>> make_patches(const std::vector<LabelledFace<1>>&, std::size_t);
template std::vector<Patch<2>> make_patches(const std::vector<LabelledFace<2>>&, std::size_t);
template VectorField<1> lumped_areas(Index, const std::vector<Face<1>>&);
template VectorField<2> lumped_areas(Index, const std::vector<Face<2>>&);
template Patch<1> make_patch(std::string, std::vector<Face<1>>);
template Patch<2> make_patch(std::string, std::vector<Face<2>>);

}  // namespace tlsph
