#include "tlsph/contrast/updated_lagrangian.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tlsph/core/error.hpp"
#include "tlsph/core/parallel.hpp"
#include "tlsph/operators/neighbours.hpp"

namespace tlsph {
namespace {

/// body(j, ∇_i W_ij) for every neighbour j ≠ i.
template <int D, class Body>
void for_neighbours(const CurrentBody<D>& body, const VectorField<D>& x, const Neighbours& near,
                    Index i, const Body& act) {
  std::visit(
      [&](const auto& kernel) {
        const auto row = static_cast<std::size_t>(i);
        for (Index k = near.start[row]; k < near.start[row + 1]; ++k) {
          const Index j = near.column[static_cast<std::size_t>(k)];
          if (j == i) continue;
          const Vector<D> apart = (x.row(i) - x.row(j)).transpose();
          const double r = apart.norm();
          // Coinciding particles have no direction to push each other in.
          if (r > 0.0) act(j, Vector<D>(apart * (kernel_first<D>(kernel, r, body.h) / r)));
        }
      },
      body.kernel);
}

template <int D>
VectorField<D> acceleration_among(const CurrentBody<D>& body, const CurrentState<D>& state,
                                  const Neighbours& near) {
  VectorField<D> a = VectorField<D>::Zero(state.x.rows(), D);
  const auto scaled = [&](Index i) {
    return Tensor<D>(tensor_at<D>(state.stress, i) / (state.density[i] * state.density[i]));
  };
  for_rows(state.x.rows(), [&](Index i) {
    const Tensor<D> own = scaled(i);
    Vector<D> sum = Vector<D>::Zero();
    for_neighbours<D>(body, state.x, near, i, [&](Index j, const Vector<D>& slope) {
      sum += body.mass[j] * ((own + scaled(j)) * slope);
    });
    a.row(i) = sum.transpose();
  });
  return a;
}

/// L_i, component (a, b) = ∂v_a/∂x_b.
template <int D>
Tensor<D> velocity_gradient(const CurrentBody<D>& body, const CurrentState<D>& state,
                            const Neighbours& near, Index i) {
  Tensor<D> L = Tensor<D>::Zero();
  for_neighbours<D>(body, state.x, near, i, [&](Index j, const Vector<D>& slope) {
    L += (body.mass[j] / state.density[j]) * (state.v.row(j) - state.v.row(i)).transpose() *
         slope.transpose();
  });
  return L;
}

template <int D>
Tensor<D> stress_rate(const Lame& moduli, const Tensor<D>& L, const Tensor<D>& stress) {
  const Tensor<D> d = 0.5 * (L + L.transpose());
  const Tensor<D> w = 0.5 * (L - L.transpose());
  Tensor<D> rate = 2.0 * moduli.mu * d + w * stress - stress * w;
  rate.diagonal().array() += moduli.lambda * d.trace();
  return rate;
}

}  // namespace

template <int D>
VectorField<D> acceleration(const CurrentBody<D>& body, const CurrentState<D>& state) {
  return acceleration_among<D>(body, state, find_neighbours<D>(state.x, state.x, body.h));
}

template <int D>
void advance(const CurrentBody<D>& body, CurrentState<D>& state, double dt) {
  const Neighbours near = find_neighbours<D>(state.x, state.x, body.h);
  state.v += dt * body.motion.cwiseProduct(acceleration_among<D>(body, state, near));
  ScalarField density = state.density;
  for_rows(state.x.rows(), [&](Index i) {
    const Tensor<D> L = velocity_gradient<D>(body, state, near, i);
    density[i] *= 1.0 - dt * L.trace();
    Eigen::Map<Tensor<D>> stress(state.stress.row(i).data());
    stress += dt * stress_rate<D>(body.moduli, L, stress);
  });
  state.density = std::move(density);
  state.x += dt * state.v;
  state.time += dt;
  for (Index i = 0; i < state.x.rows(); ++i)
    if (!(state.density[i] > 0.0) || !state.v.row(i).allFinite())
      throw NumericalError(
          fmt::format("updated-Lagrangian run lost at t = {:.6e} s: particle {} has density {:.3g} "
                      "kg/m^3",
                      state.time, i, state.density[i]),
          state.time, static_cast<long>(i));
}

template <int D>
double kinetic_energy(const CurrentBody<D>& body, const CurrentState<D>& state) {
  return 0.5 * body.mass.dot(state.v.rowwise().squaredNorm());
}

#define TLSPH_INSTANTIATE(D)                                                              \
  template VectorField<D> acceleration<D>(const CurrentBody<D>&, const CurrentState<D>&); \
  template void advance<D>(const CurrentBody<D>&, CurrentState<D>&, double);              \
  template double kinetic_energy<D>(const CurrentBody<D>&, const CurrentState<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
