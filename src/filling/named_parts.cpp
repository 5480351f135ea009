#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tlsph/filling/lattice.hpp"
#include "tlsph/geometry/outline.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/particles/boundary_faces.hpp"

namespace tlsph {
namespace {

/// Share of a face, and of the spacing, that is rounding.
constexpr double face_rounding = 1e-9, box_rounding = 1e-6;

template <int D>
struct Bounds {
  Vector<D> lower, upper;
  double tolerance;
  [[nodiscard]] bool hold(const Vector<D>& x) const {
    return ((x - lower).array() >= -tolerance).all() && ((upper - x).array() >= -tolerance).all();
  }
};

/// From t = from to t = to of a curve.
struct Span {
  double from, to;
  [[nodiscard]] bool whole() const { return from == 0.0 && to == 1.0; }
};

std::vector<OutlinePiece> arcs_of(const Shape<2>* shape) {
  std::vector<OutlinePiece> arcs;
  if (shape != nullptr) arcs = outline(*shape);
  std::erase_if(arcs, [](const OutlinePiece& piece) { return !piece.is_arc(); });
  return arcs;
}

/// What a face stands for, from its first end to its second: the chord, or the arc both lie on.
OutlinePiece curve_of(const Particles<2>& particles, const Face<2>& face,
                      const std::vector<OutlinePiece>& arcs) {
  constexpr double largest_rise = 0.3;  // of an arc over its chord; a face spans 60° at most
  OutlinePiece curve{particles.X.row(face.nodes[0]).transpose(),
                     particles.X.row(face.nodes[1]).transpose()};
  if (face.nodes[0] == face.nodes[1]) {  // the side of the cell around that node
    const Vector<2> outward = face.area.normalized();
    const Vector<2> middle = curve.from + 0.5 * particles.spacings.cwiseProduct(outward);
    const Vector<2> half = 0.5 * Vector<2>(-face.area.y(), face.area.x());
    return {middle - half, middle + half};
  }
  const double length = curve.length();
  const Vector<2> middle = curve.at(0.5);
  for (const OutlinePiece& arc : arcs) {
    const auto off = [&](const Vector<2>& x) { return (arc.closest(x) - x).norm(); };
    if (off(curve.from) > box_rounding * length || off(curve.to) > box_rounding * length ||
        off(middle) > largest_rise * length)
      continue;
    const auto angle = [&](const Vector<2>& x) {
      return std::atan2(x.y() - arc.centre.y(), x.x() - arc.centre.x());
    };
    curve.centre = arc.centre;
    curve.radius = arc.radius;
    curve.start = angle(curve.from);
    curve.sweep = std::remainder(angle(curve.to) - curve.start, 2.0 * std::numbers::pi);
    break;
  }
  return curve;
}

/// Adds the t between 0 and 1 at which the curve meets the line x_axis = c.
void add_crossings(const OutlinePiece& curve, int axis, double c, std::vector<double>& crossings) {
  const auto add = [&](double t) {
    if (t > face_rounding && t < 1.0 - face_rounding) crossings.push_back(t);
  };
  if (!curve.is_arc()) {
    const double run = curve.to(axis) - curve.from(axis);
    if (run != 0.0) add((c - curve.from(axis)) / run);
    return;
  }
  const double v = (c - curve.centre(axis)) / curve.radius;
  if (std::abs(v) > 1.0) return;
  constexpr double turn = 2.0 * std::numbers::pi;
  const double angle = axis == 0 ? std::acos(v) : std::asin(v);
  for (const double meets : {angle, axis == 0 ? -angle : std::numbers::pi - angle}) {
    const double share = (meets - curve.start) / turn;
    const double ahead = share - std::floor(share);
    add(turn * (curve.sweep > 0.0 ? ahead : ahead - 1.0) / curve.sweep);
  }
}

std::vector<Span> spans_within(const OutlinePiece& curve, const Bounds<2>& box) {
  std::vector<double> cuts = {0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis)
    for (const double c : {box.lower(axis), box.upper(axis)}) add_crossings(curve, axis, c, cuts);
  std::ranges::sort(cuts);
  std::vector<Span> spans;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    if (cuts[k] - cuts[k - 1] <= face_rounding ||
        !box.hold(curve.at(0.5 * (cuts[k - 1] + cuts[k]))))
      continue;
    if (!spans.empty() && spans.back().to == cuts[k - 1])
      spans.back().to = cuts[k];
    else
      spans.push_back({cuts[k - 1], cuts[k]});
  }
  return spans;
}

/// Appends what of that edge lies in the box. Where it is a part of the edge, each node stands for
/// ∫ N dA over that part, N its linear function on the face.
void append_within(const Particles<2>& particles, const Patch<2>& edge,
                   const std::vector<OutlinePiece>& arcs, const Bounds<2>& box, Patch<2>& patch) {
  std::vector<Face<2>> pieces;
  bool whole = true;
  for (const Face<2>& face : edge.faces) {
    const OutlinePiece curve = curve_of(particles, face, arcs);
    const std::vector<Span> spans = spans_within(curve, box);
    whole = whole && spans.size() == 1 && spans.front().whole();
    const double sense = std::copysign(1.0, face_area(curve.from, curve.to).dot(face.area));
    for (const Span& span : spans) {
      Face<2> piece = face;
      const double middle = 0.5 * (span.from + span.to);
      piece.share = {1.0 - middle, middle};
      if (!span.whole()) piece.area = sense * face_area(curve.at(span.from), curve.at(span.to));
      pieces.push_back(piece);
    }
  }
  for (Face<2>& piece : pieces) {
    piece.cut = !whole;
    patch.faces.push_back(piece);
  }
}

template <int D>
void refuse_taken(const Particles<D>& particles, const std::string& name, const Place& place) {
  if (particles.find(name))
    throw InputError(place, fmt::format("tag \"{}\" already names a part of the body; choose "
                                        "another name",
                                        name));
}

}  // namespace

template <int D>
Particles<D> with_named_box(Particles<D> particles, const std::string& name, const Vector<D>& lower,
                            const Vector<D>& upper, const Place& place,
                            [[maybe_unused]] const Shape<D>* shape) {
  refuse_taken(particles, name, place);
  if (!(lower.array() <= upper.array()).all())
    throw InputError(place, fmt::format("the box of tag \"{}\" is upside down: every lower bound "
                                        "must be at most its upper bound",
                                        name));
  const Bounds<D> box{lower, upper, box_rounding * particles.spacing};
  Patch<D> patch{name, {}, {}};
  const auto inside = [&](int node) { return box.hold(particles.X.row(node).transpose()); };
  for (int node = 0; node < static_cast<int>(particles.size()); ++node)
    if (inside(node)) patch.nodes.push_back(node);
  if constexpr (D == 2) {
    const std::vector<OutlinePiece> arcs = arcs_of(shape);
    for (const Patch<2>& edge : particles.edges) append_within(particles, edge, arcs, box, patch);
  } else if (const Patch<D>* boundary = particles.find("boundary")) {
    std::copy_if(boundary->faces.begin(), boundary->faces.end(), std::back_inserter(patch.faces),
                 [&](const Face<D>& face) { return inside(face.nodes[0]); });
  }
  if (patch.nodes.empty() && patch.faces.empty())
    throw InputError(place, fmt::format("tag \"{}\" holds no particles and no part of the "
                                        "boundary: none lies in its box",
                                        name));
  particles.patches.push_back(std::move(patch));
  return particles;
}

template <int D>
Particles<D> with_named_nodes(Particles<D> particles, const std::string& name,
                              std::vector<int> nodes, const Place& place) {
  refuse_taken(particles, name, place);
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  Patch<D> patch{name, std::move(nodes), {}};
  const auto inside = [&](int node) { return std::ranges::binary_search(patch.nodes, node); };
  const auto append = [&](const std::vector<Face<D>>& edge) {
    const std::size_t first = patch.faces.size();
    std::ranges::copy_if(edge, std::back_inserter(patch.faces), [&](const Face<D>& face) {
      return std::ranges::all_of(face.nodes, inside);
    });
    const bool part = D == 2 && patch.faces.size() - first < edge.size();
    for (std::size_t f = first; f < patch.faces.size(); ++f) patch.faces[f].cut = part;
  };
  if (D == 1) append(particles.find("boundary")->faces);
  for (const Patch<D>& edge : particles.edges) append(edge.faces);
  particles.patches.push_back(std::move(patch));
  return particles;
}

#define TLSPH_INSTANTIATE(D)                                                                 \
  template Particles<D> with_named_box(Particles<D>, const std::string&, const Vector<D>&,   \
                                       const Vector<D>&, const Place&, const Shape<D>*);     \
  template Particles<D> with_named_nodes(Particles<D>, const std::string&, std::vector<int>, \
                                         const Place&);
TLSPH_FOR_DIMENSIONS(TLSPH_INSTANTIATE)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
