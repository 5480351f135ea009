#include "tlsph/observe/errors.hpp"

#include <cmath>

namespace tlsph {
namespace {

/// Σ V|a − b|² and Σ V|b|².
struct Distance {
  double difference = 0.0;
  double reference = 0.0;

  template <class A, class B>
  void add(double volume, const A& value, const B& exact) {
    difference += volume * (value - exact).squaredNorm();
    reference += volume * exact.squaredNorm();
  }
  [[nodiscard]] double relative() const {
    return reference > 0.0 ? std::sqrt(difference / reference) : std::sqrt(difference);
  }
};

}  // namespace

template <int D>
RelativeErrors errors_against(const ExactSolution<D>& exact, const Discretisation<D>& disc,
                              const State<D>& state, double dt) {
  Distance displacement;
  Distance velocity;
  Distance stress;
  for (Index q = 0; q < disc.nodes(); ++q) {
    const Vector<D> X = disc.particles.X.row(q).transpose();
    const Vector<D> u = state.u.row(q).transpose();
    Vector<D> v;
    for (int i = 0; i < D; ++i) v[i] = motion_of<D>(disc, state, dt, q * D + i).velocity;
    displacement.add(disc.particles.V[q], u, exact.displacement(X, state.time));
    velocity.add(disc.particles.V[q], v, exact.velocity(X, state.time));
  }
  for (Index s = 0; s < disc.points.size(); ++s) {
    const Vector<D> X = disc.points.X.row(s).transpose();
    stress.add(disc.points.V[s], tensor_at<D>(state.P, s), exact.stress(X, state.time));
  }
  return {displacement.relative(), velocity.relative(), stress.relative()};
}

template RelativeErrors errors_against<1>(const ExactSolution<1>&, const Discretisation<1>&,
                                          const State<1>&, double);
template RelativeErrors errors_against<2>(const ExactSolution<2>&, const Discretisation<2>&,
                                          const State<2>&, double);

}  // namespace tlsph
