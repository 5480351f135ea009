#include "tlsph/particles/boundary_runs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "gauss.hpp"
#include "tlsph/geometry/polygon.hpp"

namespace tlsph {
namespace {

/// Faces that turn by more than this meet in a corner.
constexpr double corner_turn = std::numbers::pi / 6;
constexpr std::size_t stencil = 4;

/// What joins a face to the one that begins where it ends.
struct Joint {
  std::size_t next = 0;
  double turn = 0.0;
};

/// A face on the way with the body on the left.
struct Link {
  int begin = 0, end = 0;
  Vector<2> chord;
  std::optional<Joint> before = {}, after = {};

  Link(const VectorField<2>& X, const Face<2>& face) : begin(face.nodes[0]), end(face.nodes[1]) {
    chord = (X.row(end) - X.row(begin)).transpose();
    if (cross(face.area, chord) >= 0.0) return;
    std::swap(begin, end);
    chord = (X.row(end) - X.row(begin)).transpose();
  }

  /// The turn of a face is half of those at its ends; a corner tells nothing of it.
  [[nodiscard]] double half_turn() const {
    if (!before && !after) return 0.0;
    return 0.25 * ((before ? before : after)->turn + (after ? after : before)->turn);
  }
};

std::vector<Link> linked(const VectorField<2>& X, const std::vector<Face<2>>& faces) {
  std::vector<Link> links;
  for (const Face<2>& face : faces) links.emplace_back(X, face);
  std::multimap<int, std::size_t> begins, ends;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    begins.emplace(links[f].begin, f);
    ends.emplace(links[f].end, f);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int end = links[f].end;
    if (begins.count(end) != 1 || ends.count(end) != 1) continue;
    const std::size_t next = begins.find(end)->second;
    const Vector<2>&a = links[f].chord, &b = links[next].chord;
    const double turn = std::atan2(cross(a, b), a.dot(b));
    if (next == f || std::abs(turn) > corner_turn) continue;
    links[f].after = Joint{next, turn};
    links[next].before = Joint{f, turn};
  }
  return links;
}

/// Weight of each node of a run [m]: the cubic through four of them, integrated face by face.
std::vector<double> cubic_weights(const BoundaryRun& run) {
  const std::size_t faces = run.face.size();
  const std::size_t nodes = run.node.size();
  std::vector<double> weights(nodes, 0.0);
  for (std::size_t k = 0; k < faces; ++k) {
    // Offset of the first node of the stencil from the begin of the face: −1 but near an end.
    const std::size_t first =
        run.closed ? k + nodes - 1 : std::min(std::max<std::size_t>(k, 1) - 1, nodes - stencil);
    const std::size_t face = run.closed ? first + 1 : k;
    std::array<double, stencil> s{};
    for (std::size_t i = 1; i < stencil; ++i) s[i] = s[i - 1] + run.arc((first + i - 1) % faces);
    const double from = s[face - first];
    const double length = s[face - first + 1] - from;
    for (std::size_t g = 0; g < gauss_3.point.size(); ++g)
      for (std::size_t i = 0; i < stencil; ++i) {
        double value = gauss_3.weight[g] * length;
        for (std::size_t j = 0; j < stencil; ++j)
          if (j != i) value *= (from + gauss_3.point[g] * length - s[j]) / (s[i] - s[j]);
        weights[(first + i) % nodes] += value;
      }
  }
  return weights;
}

}  // namespace

double BoundaryRun::arc(std::size_t k) const {
  const double phi = half_turn[k];
  return chord[k] * (phi == 0.0 ? 1.0 : phi / std::sin(phi));
}

std::vector<BoundaryRun> boundary_runs(const VectorField<2>& X, const std::vector<Face<2>>& faces) {
  const std::vector<Link> links = linked(X, faces);
  std::vector<char> done(faces.size(), 0);
  std::vector<BoundaryRun> runs;
  const auto follow = [&](std::size_t first) {
    BoundaryRun run;
    for (std::size_t f = first; done[f] == 0;) {
      done[f] = 1;
      run.face.push_back(f);
      run.node.push_back(links[f].begin);
      run.chord.push_back(links[f].chord.norm());
      run.half_turn.push_back(links[f].half_turn());
      if (!links[f].after) break;
      f = links[f].after->next;
    }
    const Link& last = links[run.face.back()];
    run.closed = last.after.has_value();
    if (!run.closed) run.node.push_back(last.end);
    runs.push_back(std::move(run));
  };
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (done[f] == 0 && !links[f].before) follow(f);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (done[f] == 0) follow(f);
  return runs;
}

void make_shares_cubic(const VectorField<2>& X, std::vector<Face<2>>& faces) {
  for (const BoundaryRun& run : boundary_runs(X, faces)) {
    if (run.node.size() < stencil) continue;
    const std::vector<double> weights = cubic_weights(run);
    const std::size_t count = run.face.size();
    const auto share_of = [&](std::size_t k, std::size_t end) -> double& {
      Face<2>& face = faces[run.face[k]];
      return face.share[face.nodes[0] == run.node[run.at(k, end)] ? 0 : 1];
    };
    // w_q n_q between two faces: a part of each, such that what is across the normal cancels.
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t end = 0; end < 2; ++end) {
        const double w = weights[run.at(k, end)];
        const double cosine = std::cos(run.half_turn[k]);
        const bool at_corner = !run.closed && (end == 0 ? k == 0 : k + 1 == count);
        if (at_corner) {
          share_of(k, end) = w / (run.chord[k] * cosine);
          continue;
        }
        const std::size_t other = (k + (end == 0 ? count - 1 : 1)) % count;
        const double mean =
            run.chord[other] * cosine + run.chord[k] * std::cos(run.half_turn[other]);
        share_of(k, end) = w * run.chord[other] / (mean * run.chord[k]);
      }
  }
}

}  // namespace tlsph
