#include <algorithm>
#include <cmath>

#include "studies.hpp"
#include "tlsph/core/dimensions.hpp"
#include "tlsph/geometry/region.hpp"
#include "tlsph/model/builder.hpp"
#include "tlsph/stability/lattice.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph {
namespace {

constexpr int radial = 32;
constexpr int angular = 12;
constexpr int long_wave = radial / 4;  ///< 8 spacings a wave
constexpr double stabiliser_reach =
    3.2;  ///< of a pair stabiliser, twice its own gradient's and pairs

/// Nodes a side of the middle such that no operator of the middle sees the boundary.
int reach_of(const Scene& scene) {
  const double operators = scene.kernel.support.value_or(1.0);
  return static_cast<int>(std::ceil(2.0 * std::max(operators, stabiliser_reach))) + 2;
}

template <int D>
Discretisation<D> large_lattice(const Subject& subject, const StateKey& key) {
  const int reach = reach_of(scene_of(subject, key, Support::free));
  const double side = 2.0 * reach * subject.spacing;
  Subject large = subject;
  large.lower.assign(D, 0.0);
  large.upper.assign(D, side);
  large.box = true;
  BodyScene& body = large.scene.body;
  body.shape = make_box<D>(Vector<D>::Zero(), Vector<D>::Constant(side));
  body.spacing = subject.spacing;
  body.tags.clear();
  return build<D>(scene_of(large, key, Support::sliding));
}

template <int D>
WaveRow waves_of(const Subject& subject, const Method& method) {
  const StateKey key{method, 0, 0.0, subject.poisson, 1.0};
  const auto body = large_lattice<D>(subject, key);
  const State<D> state = make_state<D>(body, VectorField<D>::Zero(body.nodes(), D),
                                       VectorField<D>::Zero(body.nodes(), D));
  const LatticeSymbol<D> symbol = lattice_symbol<D>(body, state);
  const Tangent<D> A = tangent<D>(body.regions.front().law, Tensor<D>::Zero());
  const double density = body.regions.front().density;
  std::array<double, D> exact;
  exact[D - 1] = std::sqrt(A(0, 0) / density);
  if constexpr (D == 2) exact[0] = std::sqrt(A(1, 1) / density);
  const auto speeds = phase_speeds<D>(symbol, body.spacing, exact, radial, angular);

  WaveRow row;
  row.method = method.name;
  row.poisson = subject.poisson;
  row.zero_energy = zero_energy_waves<D>(symbol, body.particles.spacings, exact[D - 1]);
  std::array<double, D> worst{}, least, most{};
  least.fill(std::numeric_limits<double>::infinity());
  row.slowest = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < speeds.k.size(); ++n) {
    std::vector<double> line(speeds.k[n].begin(), speeds.k[n].end());
    const bool long_one = static_cast<int>(n % radial) + 1 == long_wave;
    for (std::size_t i = 0; i < D; ++i) {
      const double relative = speeds.relative[n][i];
      line.push_back(relative);
      row.slowest = std::min(row.slowest, relative);
      if (!long_one) continue;
      worst[i] = std::max(worst[i], std::abs(relative - 1.0));
      least[i] = std::min(least[i], relative);
      most[i] = std::max(most[i], relative);
    }
    row.map.push_back(std::move(line));
  }
  row.longitudinal = worst[D - 1];
  row.transverse = D == 2 ? worst[0] : not_known;
  row.anisotropy = 0.0;
  for (std::size_t i = 0; i < D; ++i) row.anisotropy = std::max(row.anisotropy, most[i] - least[i]);
  if (D == 1) row.anisotropy = not_known;
  return row;
}

}  // namespace

template <int D>
LatticeSymbol<D> lattice_symbol(const Discretisation<D>& body, const State<D>& state) {
  const LatticeFrame<D>& frame = *body.particles.frame;
  std::array<int, D> middle;
  for (std::size_t a = 0; a < D; ++a) middle[a] = frame.counts[a] / 2;
  const int centre = frame.index(middle);
  LinearisedForces<D> forces(body, state);
  std::array<VectorField<D>, D> answers;
  for (std::size_t j = 0; j < D; ++j) {
    VectorField<D> push = VectorField<D>::Zero(body.nodes(), D);
    push(centre, static_cast<Index>(j)) = 1.0;
    answers[j] = push;
    forces.product(push, answers[j]);
  }
  LatticeSymbol<D> symbol;
  for (Index q = 0; q < body.nodes(); ++q) {
    Tensor<D> block;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        block(i, j) = -answers[static_cast<std::size_t>(j)](q, i) / body.mass[centre];
    if (block.squaredNorm() == 0.0) continue;
    symbol.offset.push_back((body.particles.X.row(q) - body.particles.X.row(centre)).transpose());
    symbol.block.push_back(block);
  }
  return symbol;
}

WaveRow wave_row(const Subject& subject, const Method& method) {
  return in_dimension(subject.dimension, [&]<int D>() { return waves_of<D>(subject, method); });
}

template LatticeSymbol<1> lattice_symbol<1>(const Discretisation<1>&, const State<1>&);
template LatticeSymbol<2> lattice_symbol<2>(const Discretisation<2>&, const State<2>&);

}  // namespace tlsph
