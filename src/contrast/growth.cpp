#include "tlsph/contrast/growth.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tlsph/core/error.hpp"
#include "tlsph/linear/krylov.hpp"

namespace tlsph {
namespace {

/// ∇W and ∇∇W at the offset d of one neighbour.
template <int D>
struct Neighbour {
  Vector<D> d, slope;
  Tensor<D> curvature;
};

template <int D>
std::vector<Neighbour<D>> neighbours_of(const StressedLattice<D>& lattice) {
  const int reach = static_cast<int>(std::ceil(lattice.h / lattice.spacing));
  std::vector<Neighbour<D>> list;
  const auto add = [&](const Vector<D>& d) {
    const double r = d.norm();
    if (r == 0.0 || r >= lattice.h) return;
    const auto [first, second] = std::visit(
        [&](const auto& kernel) {
          return std::pair{kernel_first<D>(kernel, r, lattice.h),
                           kernel_second<D>(kernel, r, lattice.h)};
        },
        lattice.kernel);
    const Vector<D> n = d / r;
    const Tensor<D> along = n * n.transpose();
    list.push_back({d, first * n, second * along + first / r * (Tensor<D>::Identity() - along)});
  };
  for (int i = -reach; i <= reach; ++i) {
    if constexpr (D == 1) {
      add(Vector<1>(i * lattice.spacing));
    } else {
      for (int j = -reach; j <= reach; ++j) add(Vector<2>(i, j) * lattice.spacing);
    }
  }
  return list;
}

template <int D>
Tensor<D> symbol_over(const std::vector<Neighbour<D>>& neighbours,
                      const StressedLattice<D>& lattice, const Vector<D>& k) {
  const double volume = std::pow(lattice.spacing, D);
  Tensor<D> C = Tensor<D>::Zero();
  Vector<D> g = Vector<D>::Zero();
  for (const Neighbour<D>& near : neighbours) {
    const double phase = k.dot(near.d);
    C += volume * (1.0 - std::cos(phase)) * near.curvature;
    g += volume * std::sin(phase) * near.slope;
  }
  const auto [lambda, mu] = lattice.moduli;
  const double sigma = lattice.stress;
  return (2.0 * sigma * C - (lambda + 2.0 * sigma + mu) * (g * g.transpose()) -
          mu * g.squaredNorm() * Tensor<D>::Identity()) /
         lattice.density;
}

template <int D>
double growth_of(const Tensor<D>& symbol) {
  const Eigen::SelfAdjointEigenSolver<Tensor<D>> solver(symbol, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

}  // namespace

template <int D>
Tensor<D> symbol(const StressedLattice<D>& lattice, const Vector<D>& k) {
  return symbol_over<D>(neighbours_of<D>(lattice), lattice, k);
}

template <int D>
double growth_rate(const StressedLattice<D>& lattice, const Vector<D>& k) {
  return growth_of<D>(symbol<D>(lattice, k));
}

template <int D>
GrowingWave<D> fastest_growth(const StressedLattice<D>& lattice) {
  constexpr int intervals = 64;
  const auto neighbours = neighbours_of<D>(lattice);
  GrowingWave<D> fastest;
  const int last = D == 1 ? 0 : intervals;
  for (int i = 0; i <= intervals; ++i)
    for (int j = 0; j <= last; ++j) {
      Vector<D> k;
      k[0] = i;
      k[D - 1] = D == 1 ? i : j;
      k *= std::numbers::pi / (intervals * lattice.spacing);
      const double rate = growth_of<D>(symbol_over<D>(neighbours, lattice, k));
      if (rate > fastest.rate) fastest = {k, rate};
    }
  return fastest;
}

template <int D>
CurrentRun<D> current_lattice(const StressedLattice<D>& lattice, const std::array<int, D>& counts,
                              int held) {
  Index N = 1;
  for (const int count : counts) N *= count;
  CurrentRun<D> run;
  run.body = {lattice.kernel, lattice.h, lattice.moduli,
              ScalarField::Constant(N, lattice.density * std::pow(lattice.spacing, D)),
              VectorField<D>::Ones(N, D)};
  run.state = {0.0, VectorField<D>(N, D), VectorField<D>::Zero(N, D),
               ScalarField::Constant(N, lattice.density), TensorField<D>::Zero(N, D * D)};
  for (Index q = 0; q < N; ++q) {
    std::array<int, D> at{};
    int row = static_cast<int>(q);
    for (std::size_t a = D; a-- > 0; row /= counts[a]) at[a] = row % counts[a];
    for (std::size_t a = 0; a < D; ++a) {
      run.state.x(q, static_cast<Index>(a)) = at[a] * lattice.spacing;
      if (at[a] < held || at[a] >= counts[a] - held) run.body.motion.row(q).setZero();
      run.state.stress(q, static_cast<Index>(a * (D + 1))) = lattice.stress;
    }
  }
  return run;
}

template <int D>
void displace(CurrentRun<D>& run, const VectorField<D>& displacement) {
  CurrentBody<D> still = run.body;
  still.motion.setZero();
  const double time = run.state.time;
  const VectorField<D> velocity = run.state.v;
  run.state.v = displacement;
  advance<D>(still, run.state, 1.0);
  run.state.v = velocity;
  run.state.time = time;
}

template <int D>
EnergyHistory step_until(CurrentRun<D>& run, double dt, double end,
                         const std::function<void(const CurrentState<D>&)>& observe) {
  const double first = kinetic_energy<D>(run.body, run.state);
  EnergyHistory history;
  while (run.state.time < end) {
    try {
      advance<D>(run.body, run.state, dt);
    } catch (const NumericalError&) {
      break;
    }
    history.time.push_back(run.state.time);
    history.energy.push_back(kinetic_energy<D>(run.body, run.state) / first);
    if (observe) observe(run.state);
  }
  return history;
}

template <int D>
double linear_growth_rate(const CurrentRun<D>& run) {
  const VectorField<D> at_rest = acceleration<D>(run.body, run.state);
  const Index dofs = run.state.x.size();
  const double size = 1e-7 * run.body.h;
  const auto derivative = [&](const Eigen::VectorXd& direction, Eigen::VectorXd& change) {
    CurrentRun<D> moved = run;
    const auto field = Eigen::Map<const VectorField<D>>(direction.data(), dofs / D, D);
    displace<D>(moved, size * run.body.motion.cwiseProduct(field));
    const VectorField<D> a = acceleration<D>(moved.body, moved.state);
    Eigen::Map<VectorField<D>>(change.data(), dofs / D, D) =
        run.body.motion.cwiseProduct(a - at_rest) / size;
  };
  const auto rightmost =
      largest_eigenvalue(derivative, dofs, {.max_steps = 300, .tolerance = 1e-3});
  return std::sqrt(std::max(0.0, rightmost.value));
}

#define TLSPH_INSTANTIATE(D)                                                                      \
  template Tensor<D> symbol<D>(const StressedLattice<D>&, const Vector<D>&);                      \
  template double growth_rate<D>(const StressedLattice<D>&, const Vector<D>&);                    \
  template GrowingWave<D> fastest_growth<D>(const StressedLattice<D>&);                           \
  template CurrentRun<D> current_lattice<D>(const StressedLattice<D>&, const std::array<int, D>&, \
                                            int);                                                 \
  template void displace<D>(CurrentRun<D>&, const VectorField<D>&);                               \
  template EnergyHistory step_until<D>(CurrentRun<D>&, double, double,                            \
                                       const std::function<void(const CurrentState<D>&)>&);       \
  template double linear_growth_rate<D>(const CurrentRun<D>&);
TLSPH_INSTANTIATE(1)
TLSPH_INSTANTIATE(2)
#undef TLSPH_INSTANTIATE

}  // namespace tlsph
