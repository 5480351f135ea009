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
RelativeErrors errors_against(const ExactSolution<D>& exact, const Instant<D>& now) {
  const Discretisation<D>& body = now.body;
  const double t = now.time();
  Distance displacement;
  Distance velocity;
  Distance stress;
  for (Index q = 0; q < body.nodes(); ++q) {
    const Vector<D> X = body.particles.X.row(q).transpose();
    const Vector<D> u = now.u().row(q).transpose();
    Vector<D> v;
    for (int i = 0; i < D; ++i) v[i] = now.motion(q * D + i).velocity;
    displacement.add(body.particles.V[q], u, exact.displacement(X, t));
    velocity.add(body.particles.V[q], v, exact.velocity(X, t));
  }
  for (Index s = 0; s < body.points.size(); ++s) {
    const Vector<D> X = body.points.X.row(s).transpose();
    stress.add(body.points.V[s], tensor_at<D>(now.P(), s), exact.stress(X, t));
  }
  return {displacement.relative(), velocity.relative(), stress.relative()};
}

template RelativeErrors errors_against<1>(const ExactSolution<1>&, const Instant<1>&);
template RelativeErrors errors_against<2>(const ExactSolution<2>&, const Instant<2>&);

}  // namespace tlsph
