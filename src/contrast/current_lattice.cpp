#include "tlsph/contrast/current_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tlsph/linear/krylov.hpp"

namespace tlsph {

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

template CurrentRun<1> current_lattice<1>(const StressedLattice<1>&, const std::array<int, 1>&,
                                          int);
template CurrentRun<2> current_lattice<2>(const StressedLattice<2>&, const std::array<int, 2>&,
                                          int);
template double linear_growth_rate<1>(const CurrentRun<1>&);
template double linear_growth_rate<2>(const CurrentRun<2>&);
template void displace<1>(CurrentRun<1>&, const VectorField<1>&);
template void displace<2>(CurrentRun<2>&, const VectorField<2>&);

}  // namespace tlsph
