#include "tlsph/filling/jitter.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "tlsph/filling/cloud.hpp"
#include "tlsph/particles/delaunay.hpp"
#include "tlsph/particles/points.hpp"

namespace tlsph {
namespace {

constexpr double largest_share = 0.4;
/// A cell keeps its shape while its least corner Jacobian is above this share of the lattice's.
constexpr double least_jacobian_share = 0.1;

/// Uniform in [−1, 1). Spelled out because std::uniform_real_distribution differs between
/// libraries.
double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0;
}

/// Halves the moves of the corners of every misshapen cell until there is none. Ends, because the
/// cells of the lattice itself are right. `least(k)` is what `size(X, cell k)` must exceed.
template <int D, class Cells, class Size, class Least>
VectorField<D> with_sound_cells(const VectorField<D>& lattice, VectorField<D> moves,
                                const Cells& cells, const Size& size, const Least& least) {
  VectorField<D> X = lattice + moves;
  for (bool misshapen = true; misshapen;) {
    misshapen = false;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (size(X, cells[k]) > least(k)) continue;
      misshapen = true;
      for (const int node : cells[k]) {
        moves.row(node) *= 0.5;
        X.row(node) = lattice.row(node) + moves.row(node);
      }
    }
  }
  return X;
}

/// Cells stay, and volumes follow them.
template <int D>
void move_cells(Particles<D>& particles, VectorField<D> moves) {
  const double least = least_jacobian_share * particles.spacings.prod();
  particles.X = with_sound_cells<D>(particles.X, std::move(moves), particles.cells,
                                    least_jacobian<D>, [=](std::size_t) { return least; });
  if (!particles.cells.empty()) particles.V = node_volumes<D>(particles.X, particles.cells);
}

/// The old triangles keep the nodes within the body; then they are drawn afresh.
void move_triangles(Particles<2>& particles, VectorField<2> moves, const Place& place) {
  std::vector<double> least;
  for (const Triangle& triangle : particles.triangles)
    least.push_back(least_jacobian_share * triangle_area(particles.X, triangle));
  particles.X = with_sound_cells<2>(particles.X, std::move(moves), particles.triangles,
                                    triangle_area, [&](std::size_t k) { return least[k]; });
  const auto& faces = particles.find("boundary")->faces;
  particles.triangles = triangulate(particles.X, faces, [&](Index) { return place; });
  particles.V = voronoi_volumes(particles.X, faces);
}

}  // namespace

template <int D>
Particles<D> jittered(Particles<D> particles, double share, std::uint64_t seed,
                      const Place& place) {
  if (!(share >= 0.0 && share <= largest_share))
    throw InputError(place, fmt::format("jitter must lie between 0 and {} of the spacing, not {}; "
                                        "beyond that cells could not stay convex",
                                        largest_share, share));
  if (share == 0.0) return particles;
  std::mt19937_64 generator(seed);
  const Patch<D>* boundary = particles.find("boundary");
  VectorField<D> moves = VectorField<D>::Zero(particles.size(), D);
  std::vector<int> order = by_place<D>(particles.X);
  if (!particles.triangles.empty()) std::iota(order.begin(), order.end(), 0);
  for (const int q : order) {
    if (boundary && std::ranges::binary_search(boundary->nodes, q)) continue;
    for (int a = 0; a < D; ++a) moves(q, a) = share * particles.spacings(a) * uniform(generator);
  }
  if constexpr (D == 2)
    if (!particles.triangles.empty()) {
      move_triangles(particles, std::move(moves), place);
      return particles;
    }
  move_cells<D>(particles, std::move(moves));
  particles.frame.reset();
  return particles;
}

template Particles<1> jittered(Particles<1>, double, std::uint64_t, const Place&);
template Particles<2> jittered(Particles<2>, double, std::uint64_t, const Place&);

}  // namespace tlsph
