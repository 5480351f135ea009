#include "tlsph/particles/boundary_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tlsph/geometry/region.hpp"

namespace tlsph {
namespace {

/// Lengths below this share of the size of the shape are rounding.
constexpr double rounding = 1e-9;

bool same(const OutlinePiece& a, const OutlinePiece& b) {
  return a.from == b.from && a.to == b.to && a.centre == b.centre && a.radius == b.radius;
}

/// A patch of those faces and their nodes.
template <int D>
Patch<D> make_patch(std::string name, std::vector<Face<D>> faces) {
  Patch<D> patch{std::move(name), {}, std::move(faces)};
  for (const auto& face : patch.faces)
    patch.nodes.insert(patch.nodes.end(), face.nodes.begin(), face.nodes.end());
  std::ranges::sort(patch.nodes);
  patch.nodes.erase(std::ranges::unique(patch.nodes).begin(), patch.nodes.end());
  return patch;
}

}  // namespace

OutlineNames::OutlineNames(const Shape<2>& shape) : holes_(holes_of(shape)) {
  const Box<2> box = bounding_box(shape);
  size_ = (box.upper - box.lower).norm();
  for (const OutlinePiece& piece : outline(shape)) pieces_.push_back({piece});
  std::vector<std::vector<std::size_t>> edges;
  std::vector<std::size_t> outer;
  for (const OutlineLoop& loop : outline_loops(shape))
    for (const OutlineLoop& section : sections(loop)) {
      auto& edge = edges.emplace_back();
      for (const OutlinePiece& piece : section) {
        const auto found = std::ranges::find_if(
            pieces_, [&](const NamedPiece& named) { return same(named.piece, piece); });
        edge.push_back(static_cast<std::size_t>(found - pieces_.begin()));
      }
      if (enclosed_area(loop) > 0.0) outer.insert(outer.end(), edge.begin(), edge.end());
    }
  std::ranges::sort(edges, {}, [](const auto& edge) { return std::ranges::min(edge); });
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (const std::size_t k : edges[e]) pieces_[k].edge = static_cast<int>(e) + 1;
  name_sides(outer);
}

void OutlineNames::name_sides(const std::vector<std::size_t>& outer_pieces) {
  for (int side = 0; side < 4; ++side) {
    const int a = side / 2;
    const double outward = side % 2 == 0 ? -1.0 : 1.0;
    double farthest = -std::numeric_limits<double>::infinity();
    const auto faces_it = [&](const OutlinePiece& piece) {
      return !piece.is_arc() && std::abs(piece.to(a) - piece.from(a)) <= rounding * size_ &&
             outward * piece.normal(0.5)(a) > 0.5;
    };
    for (const std::size_t k : outer_pieces)
      if (const OutlinePiece& piece = pieces_[k].piece; faces_it(piece))
        farthest = std::max(farthest, outward * piece.from(a));
    for (const std::size_t k : outer_pieces)
      if (const OutlinePiece& piece = pieces_[k].piece;
          faces_it(piece) && outward * piece.from(a) >= farthest - rounding * size_)
        pieces_[k].side = side;
  }
}

const NamedPiece& OutlineNames::closest(const Vector<2>& x, const Vector<2>& outward) const {
  const NamedPiece* best = &pieces_.front();
  double least = std::numeric_limits<double>::infinity();
  for (const NamedPiece& named : pieces_) {
    const Vector<2> on = named.piece.closest(x);
    const double distance =
        (on - x).norm() + (named.piece.normal_at(on).dot(outward) > 0.0 ? 0.0 : size_);
    if (distance >= least) continue;
    least = distance;
    best = &named;
  }
  return *best;
}

LabelledFace<2> OutlineNames::labelled(const VectorField<2>& X, int from, int to, double tolerance,
                                       std::vector<Vector<2>> witnesses) const {
  const Vector<2> a = X.row(from).transpose(), b = X.row(to).transpose();
  LabelledFace<2> result{{{from, to}, face_area(a, b)}};
  witnesses.insert(witnesses.end(), {a, b});
  const NamedPiece& own = closest(0.5 * (a + b), result.face.area);
  result.edge = own.edge;
  if (own.side != no_side && std::ranges::all_of(witnesses, [&](const Vector<2>& x) {
        return std::abs(x(own.side / 2) - own.piece.from(own.side / 2)) <= tolerance;
      }))
    result.side = own.side;
  for (std::size_t k = holes_.size(); k-- > 0;)
    if (std::ranges::all_of(witnesses, [&](const Vector<2>& x) {
          return std::abs(depth(holes_[k], x)) <= tolerance;
        }))
      result.hole = static_cast<int>(k) + 1;
  return result;
}

template <int D>
void set_boundary(Particles<D>& particles, const std::vector<LabelledFace<D>>& faces,
                  std::size_t holes) {
  const auto add = [&](const std::string& name, auto belongs) {
    std::vector<Face<D>> chosen;
    for (const auto& labelled : faces)
      if (belongs(labelled)) chosen.push_back(labelled.face);
    if (!chosen.empty()) particles.patches.push_back(make_patch<D>(name, std::move(chosen)));
  };
  for (int side = 0; side < 2 * D; ++side)
    add(side_names[static_cast<std::size_t>(side)],
        [side](const auto& face) { return face.side == side; });
  add("hole", [](const auto& face) { return face.hole > 0 && face.side == no_side; });
  for (int k = 1; k <= static_cast<int>(holes); ++k)
    add(fmt::format("hole{}", k), [k](const auto& face) { return face.hole == k; });
  add("outer", [](const auto& face) { return face.hole == 0 || face.side != no_side; });
  add("boundary", [](const auto&) { return true; });
  std::map<int, std::vector<Face<D>>> by_edge;
  for (const auto& labelled : faces)
    if (labelled.edge > 0) by_edge[labelled.edge].push_back(labelled.face);
  for (auto& [number, members] : by_edge)
    particles.edges.push_back(make_patch<D>(fmt::format("edge{}", number), std::move(members)));
  particles.B = lumped_areas<D>(particles.size(), particles.find("boundary")->faces);
}

template <int D>
VectorField<D> lumped_areas(Index nodes, const std::vector<Face<D>>& faces) {
  VectorField<D> B = VectorField<D>::Zero(nodes, D);
  for (const auto& face : faces)
    for (std::size_t k = 0; k < D; ++k)
      B.row(face.nodes[k]) += face.share[k] * face.area.transpose();
  return B;
}

#define TLSPH_INSTANTIATE(D)                                                                   \
  template void set_boundary(Particles<D>&, const std::vector<LabelledFace<D>>&, std::size_t); \
  template VectorField<D> lumped_areas(Index, const std::vector<Face<D>>&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
