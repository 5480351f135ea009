// Library use: the swinging plate of swinging_plate.toml, built by hand, without a scene.
//
//     H = G u,   P = law(H),   a = M^-1 D P      G: points x nodes,  D = -G^T V: nodes x points
//
//     u_x=0 o-----o   32 x 32 cells, a stress point in each; u_x = 0 on left and top,
//           |     |   u_y = 0 on bottom and right
//           o-----o   u(X, 0) = exact solution at t = 0
//
// Expected: G 1 = 0 to round-off and, at t = 2 ms, a relative error of the displacement of 4.4e-5
// (the same as `tlsph run examples/swinging_plate.toml`). Returns 0 if both hold.

#include <fmt/format.h>

#include <set>

#include "tlsph/exact/solutions.hpp"
#include "tlsph/filling/lattice.hpp"
#include "tlsph/materials/lame.hpp"
#include "tlsph/observe/errors.hpp"
#include "tlsph/operators/gradients.hpp"
#include "tlsph/particles/points.hpp"
#include "tlsph/stepping/stepper.hpp"

using namespace tlsph;

int main() {
  // 1. The reference configuration: nodes on a lattice, a stress point at the centre of each cell.
  Discretisation<2> plate;
  plate.particles = make_lattice<2>({Box<2>{{0, 0}, {1, 1}}}, 1.0 / 32);
  plate.points = cell_points(plate.particles);
  plate.spacing = plate.particles.spacing;

  // 2. The operators, built once: the gradient and its adjoint, the force operator.
  plate.gradient = cell_gradient(plate.particles, plate.points);
  plate.divergence = plate.gradient.negative_adjoint(plate.points.V);

  // 3. An operator is a sparse matrix: Eigen's, with all that Eigen can do with it.
  const SparseMatrix G_x = plate.gradient.matrix(0);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(G_x.cols());
  const double constants = (G_x * ones).cwiseAbs().maxCoeff();
  fmt::print("G_x: {} x {}, {} non-zeros, max |G_x 1| = {:.1e}\n", G_x.rows(), G_x.cols(),
             G_x.nonZeros(), constants);

  // 4. Material and mass.
  const double young = 17e6, poisson = 0.3, density = 1100;
  plate.regions = {
      {make_law<2>(LawName::linear_elastic, Assumption::strain, young, poisson), density, {}}};
  plate.mass = density * plate.particles.V;

  // 5. Rollers: degree of freedom node*2 + component is held, its inverse mass zero.
  plate.inverse_mass = plate.mass.cwiseInverse().replicate<1, 2>();
  std::set<Index> held;
  for (const auto& [edge, component] :
       {std::pair{"left", 0}, {"top", 0}, {"bottom", 1}, {"right", 1}})
    for (const int node : plate.particles.find(edge)->nodes) held.insert(2 * node + component);
  for (const Index dof : held) plate.inverse_mass.data()[dof] = 0.0;
  plate.constraints.fixed.assign(held.begin(), held.end());

  // 6. The exact motion; its state at t = 0 is where the plate starts.
  const auto exact = swinging_plate(
      {.shear_modulus = lame(young, poisson).mu, .density = density, .amplitude = 5e-4});
  VectorField<2> u(plate.nodes(), 2);
  for (Index q = 0; q < plate.nodes(); ++q)
    u.row(q) = exact.displacement(plate.particles.X.row(q).transpose(), 0.0).transpose();

  // 7. Steps: nine tenths of the critical one, shortened so that the last ends at t = 2 ms. Every
  // fiftieth state is printed as far as it is from the exact motion, and the last one.
  Stepper<2> stepper(plate, u, VectorField<2>::Zero(plate.nodes(), 2), {.end = 2e-3});
  RelativeErrors errors;
  const auto observe = [&](const Instant<2>& now) {
    errors = errors_against(exact, now);
    fmt::print("step {:3}, relative errors: u {:.2e}, v {:.2e}, P {:.2e}\n", now.step(),
               errors.displacement, errors.velocity, errors.stress);
  };
  stepper.run(observe, 50);

  // 8. What an integrator must keep: the energy.
  fmt::print("drift of the energy {:.1e}\n", stepper.balance().energy_drift());
  return constants < 1e-12 && errors.displacement < 6e-5 && errors.stress < 4e-4 ? 0 : 1;
}
