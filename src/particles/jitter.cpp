#include "tlsph/particles/jitter.hpp"

#include <fmt/core.h>

#include <random>
#include <vector>

#include "tlsph/particles/cells.hpp"

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

template <int D>
std::vector<char> on_boundary(const Particles<D>& particles) {
  std::vector<char> mark(static_cast<std::size_t>(particles.size()), 0);
  if (const Patch<D>* boundary = particles.find("boundary"))
    for (const int node : boundary->nodes) mark[static_cast<std::size_t>(node)] = 1;
  return mark;
}

/// Halves the moves of the corners of every misshapen cell until there is none. Ends, because the
/// cells of the lattice itself are right.
template <int D>
VectorField<D> with_convex_cells(const Particles<D>& lattice, VectorField<D> moves) {
  const double least = least_jacobian_share * lattice.spacings.prod();
  VectorField<D> X = lattice.X + moves;
  for (bool misshapen = true; misshapen;) {
    misshapen = false;
    for (const auto& cell : lattice.cells) {
      if (least_jacobian<D>(X, cell) > least) continue;
      misshapen = true;
      for (const int node : cell) {
        moves.row(node) *= 0.5;
        X.row(node) = lattice.X.row(node) + moves.row(node);
      }
    }
  }
  return X;
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
  const std::vector<char> fixed = on_boundary(particles);
  VectorField<D> moves = VectorField<D>::Zero(particles.size(), D);
  for (Index q = 0; q < particles.size(); ++q) {
    if (fixed[static_cast<std::size_t>(q)]) continue;
    for (int a = 0; a < D; ++a) moves(q, a) = share * particles.spacings(a) * uniform(generator);
  }
  particles.X = with_convex_cells(particles, std::move(moves));
  if (!particles.cells.empty()) particles.V = node_volumes<D>(particles.X, particles.cells);
  particles.frame.reset();
  return particles;
}

template Particles<1> jittered(Particles<1>, double, std::uint64_t, const Place&);
template Particles<2> jittered(Particles<2>, double, std::uint64_t, const Place&);

}  // namespace tlsph
