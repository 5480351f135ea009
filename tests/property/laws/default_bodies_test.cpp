/// Bodies that turn and strain, and bodies at rest, with what a formulation does by default.

#include <Eigen/Cholesky>
#include <cmath>

#include "property/bodies.hpp"
#include "tlsph/dynamics/stabiliser_forces.hpp"

namespace tlsph::property {
namespace {

struct DefaultBody {
  std::string layout, formulation;
  /// Largest errors at rest under its weight, relative to the largest value.
  double stress = 0.0, displacement = 0.0;
  [[nodiscard]] std::string name() const {
    std::string text = formulation + "_" + layout;
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
  }
};

void PrintTo(const DefaultBody& body, std::ostream* out) {
  *out << body.name();
}

Scene scene_with(const DefaultBody& body, const std::string& law) {
  return read_scene_text("dimension = 2\nformulation = \"" + body.formulation + "\"\n[body]\n" +
                             body_of(body.layout) + "spacing = 0.02\n[material]\nlaw = \"" + law +
                             "\"\nyoung = 2e6\npoisson = 0.3\ndensity = 1000\n[time]\nend = 1.0\n",
                         body.name());
}

class Defaults : public testing::TestWithParam<DefaultBody> {};

/// Free flight with a spin, a stretch and a shear at once: strains to five hundredths, half a turn.
TEST_P(Defaults, KeepEnergyAndMomentaOfABodyThatTurnsAndStrains) {
  const Discretisation<2> body = build<2>(scene_with(GetParam(), "neo-hookean"));
  const double c = body.wave_speed(), size = 0.14;
  Tensor<2> A;
  A << 0.08, -0.15, 0.12, -0.05;
  State<2> state =
      make_state<2>(body, VectorField<2>::Zero(body.nodes(), 2),
                    affine<2>(body.particles.X, A * (0.5 * c / size), Vector<2>(0.3, -0.1)));
  evaluate<2>(body, state);
  const double dt = 0.15 * critical_step<2>(body, state).dt;
  std::vector<Balance<2>> books;
  double strain = 0.0;
  march<2>(body, state, dt, 6600, 30, [&](const State<2>& now, const WorkAndImpulse<2>&) {
    books.push_back(balance<2>({body, now, dt}));
    for (Index s = 0; s < now.H.rows(); ++s)
      strain = std::max(strain, green_lagrange<2>(tensor_at<2>(now.H, s)).cwiseAbs().maxCoeff());
  });

  EXPECT_GE(strain, 0.02);
  const double energy = books.front().kinetic + books.front().elastic;
  double largest = 0.0, momentum = 0.0, spin = 0.0, scale = 0.0, spin_scale = 0.0;
  for (const Balance<2>& now : books) {
    largest = std::max(largest, std::abs(now.kinetic + now.elastic - energy));
    scale = std::max(scale, now.momentum_scale);
    spin_scale = std::max(spin_scale, now.angular_scale);
    momentum = std::max(momentum, (now.linear_momentum - books.front().linear_momentum).norm());
    spin = std::max(spin, std::abs(now.angular_momentum - books.front().angular_momentum));
  }
  EXPECT_LE(largest, 1e-4 * energy);
  EXPECT_LE(momentum, 1e-12 * scale);
  EXPECT_LE(spin, 1e-12 * spin_scale);
}

INSTANTIATE_TEST_SUITE_P(
    , Defaults,
    testing::Values(DefaultBody{"box", "stress-point"}, DefaultBody{"jittered", "stress-point"},
                    DefaultBody{"cloud", "stress-point"}, DefaultBody{"box", "variational"},
                    DefaultBody{"jittered", "variational"}, DefaultBody{"cloud", "variational"},
                    DefaultBody{"box", "consistent"}, DefaultBody{"jittered", "consistent"},
                    DefaultBody{"cloud", "consistent"}),
    ByName());

class DefaultsAtRest : public testing::TestWithParam<DefaultBody> {};

/// (On nodes whose adjoint is not exact, `variational`, the weight makes false forces at edges.)
/// A box between smooth walls bears its weight: u_y = ρg/(λ + 2μ) (y²/2 − H y) over its foot and
/// P_yy = −ρg (H − y), which a mode that changes sign from node to node would alternate about.
TEST_P(DefaultsAtRest, StandAsTheyShouldUnderTheirWeight) {
  const Discretisation<2> body = build<2>(scene_with(GetParam(), "linear-elastic"));
  ASSERT_EQ(body.viscosity.nonZeros(), 0);
  const VectorField<2>& X = body.particles.X;
  const Vector<2> low = X.colwise().minCoeff().transpose();
  const Vector<2> size = X.colwise().maxCoeff().transpose() - low;
  std::vector<Index> free;
  for (Index q = 0; q < body.nodes(); ++q) {
    const Vector<2> x = X.row(q).transpose() - low;
    if (x.x() > 1e-9 && x.x() < size.x() - 1e-9) free.push_back(2 * q);
    if (x.y() > 1e-9) free.push_back(2 * q + 1);
  }
  constexpr double g = 10.0;
  const Eigen::MatrixXd K = dense_stiffness<2>(body);
  Eigen::VectorXd f(static_cast<Index>(free.size()));
  for (Index k = 0; k < f.size(); ++k) {
    const Index dof = free[static_cast<std::size_t>(k)];
    f[k] = dof % 2 == 1 ? -g * body.mass[dof / 2] : 0.0;
  }
  const Eigen::LDLT<Eigen::MatrixXd> factor(K(free, free));
  ASSERT_GT(factor.vectorD().minCoeff(), 1e-3 * 2e6);
  const Eigen::VectorXd x = factor.solve(f);
  VectorField<2> u = VectorField<2>::Zero(body.nodes(), 2);
  for (Index k = 0; k < x.size(); ++k) u.data()[free[static_cast<std::size_t>(k)]] = x[k];

  const State<2> rest = evaluated<2>(body, u);

  const double modulus = 2e6 * (1 - 0.3) / ((1 + 0.3) * (1 - 2 * 0.3));
  double displacement = 0.0, stress = 0.0;
  for (Index q = 0; q < body.nodes(); ++q) {
    const double y = X(q, 1) - low.y();
    const double exact = density * g / modulus * (0.5 * y * y - size.y() * y);
    displacement = std::max(displacement, std::abs(u(q, 1) - exact));
  }
  for (Index s = 0; s < body.points.size(); ++s) {
    const double exact = -density * g * (size.y() - (body.points.X(s, 1) - low.y()));
    stress = std::max(stress, std::abs(tensor_at<2>(rest.P, s)(1, 1) - exact));
  }
  EXPECT_LE(stress, GetParam().stress * density * g * size.y());
  EXPECT_LE(displacement,
            GetParam().displacement * 0.5 * density * g * size.y() * size.y() / modulus);
}

INSTANTIATE_TEST_SUITE_P(, DefaultsAtRest,
                         testing::Values(DefaultBody{"box", "stress-point", 1e-9, 1e-9},
                                         DefaultBody{"jittered", "stress-point", 0.01, 0.01},
                                         DefaultBody{"box", "variational", 0.04, 0.08},
                                         DefaultBody{"jittered", "variational", 0.15, 0.2},
                                         DefaultBody{"box", "consistent", 1e-9, 1e-9},
                                         DefaultBody{"jittered", "consistent", 1e-9, 1e-9}),
                         ByName());

}  // namespace
}  // namespace tlsph::property
