/// The computed step limit is the limit: a run just below it stays bounded, one just above
/// explodes.

#include <Eigen/Eigenvalues>
#include <complex>

#include "property/bodies.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph::property {
namespace {

struct Run {
  std::string name;
  Variant variant;
  std::vector<std::string> overrides;
};

void PrintTo(const Run& run, std::ostream* out) {
  *out << run.name;
}

constexpr const char* held_bar =
    "boundary=[{where=\"left\", traction=0.0}, {where=\"right\", fixed=true}]";

std::vector<Run> runs() {
  const Variant bar{"interval", "stress-point", "", "", ""};
  const Variant cells{"box", "stress-point", "", "", ""};
  const Variant quads{"jittered", "stress-point", "", "", ""};
  const Variant wide{"hole", "stress-point", "", "wendland-c2", "2.1"};
  const Variant nodes{"jittered", "variational", "gradient", "wendland-c2", "2.5"};
  const Variant mixed{"disc", "variational", "mixed", "lucy", "2.5"};
  const Variant corrected{"jittered", "consistent", "", "wendland-c2", "3.1", "[1, 1]"};
  const Variant quadratic{"jittered", "consistent", "", "wendland-c2", "3.6", "[2, 1]"};
  const Variant nodes_bar{"interval", "variational", "gradient", "cubic-spline", "2.4"};
  const auto stabilised = [](const Variant& variant, const char* action) {
    return std::vector<std::string>{"stabiliser.kind=" + variant.stabiliser(),
                                    std::string("stabiliser.as=") + action};
  };
  std::vector<Run> list;
  for (const auto& [name, variant] :
       {std::pair{"bar", bar}, std::pair{"cells", cells}, std::pair{"quads", quads},
        std::pair{"wide", wide}, std::pair{"nodes", nodes}, std::pair{"mixed", mixed},
        std::pair{"nodes_bar", nodes_bar}, std::pair{"corrected", corrected},
        std::pair{"quadratic", quadratic}}) {
    list.push_back({name, variant, {}});
    list.push_back({std::string(name) + "_stiffened", variant, stabilised(variant, "stiffness")});
    list.push_back({std::string(name) + "_damped", variant, stabilised(variant, "viscosity")});
  }
  // Viscosity strong enough to set the step alone.
  std::vector<std::string> heavy = stabilised(nodes, "viscosity");
  heavy.emplace_back("stabiliser.coefficient=3.0");
  list.push_back({"nodes_overdamped", nodes, heavy});
  list.push_back({"cells_clamped", cells, {"boundary=[{where=\"left\", fixed=true}]"}});
  const Variant mirror{"interval", "mirror", "", "cubic-spline", "2.5"};
  list.push_back({"mirror", mirror, {held_bar}});
  const Variant wider{"interval", "mirror", "", "modified-mollifier", "5.5"};
  list.push_back({"mirror_wide", wider, {held_bar}});
  return list;
}

/// Largest |u| of 1500 steps that start from displacements of at most one micrometre.
template <int D>
double largest_displacement(const Discretisation<D>& body, double dt) {
  Random random(21);
  State<D> state = make_state<D>(body, random.field<D>(body.nodes(), 1e-6),
                                 VectorField<D>::Zero(body.nodes(), D));
  double most = 0.0;
  try {
    march<D>(body, state, dt, 1500, 1, [&](const State<D>& now, const WorkAndImpulse<D>&) {
      most = std::max(most, now.u.cwiseAbs().maxCoeff());
    });
  } catch (const NumericalError&) {
    return std::numeric_limits<double>::infinity();
  }
  return most;
}

template <int D>
double step_at_rest(const Discretisation<D>& body) {
  return critical_step<D>(body, evaluated<D>(body, VectorField<D>::Zero(body.nodes(), D))).dt;
}

class CriticalStepLaws : public testing::TestWithParam<Run> {
 protected:
  template <class Use>
  void with_disc(const Use& use) const {
    discretised(scene_of(GetParam().variant, GetParam().overrides), use);
  }
};

TEST_P(CriticalStepLaws, RunsJustBelowItAreStable) {
  with_disc([]<int D>(const Discretisation<D>& body) {
    // Near the limit a mode may swing up to 1/√(1 − 0.997²) = 13 times its start; N of them add up.
    EXPECT_LE(largest_displacement<D>(body, 0.997 * step_at_rest<D>(body)), 1e-6 * 1e3);
  });
}

TEST_P(CriticalStepLaws, RunsJustAboveItAreNot) {
  with_disc([]<int D>(const Discretisation<D>& body) {
    EXPECT_GT(largest_displacement<D>(body, 1.01 * step_at_rest<D>(body)), 1e-6 * 1e6);
  });
}

/// C of all components, dense.
template <int D>
Eigen::MatrixXd dense_viscosity(const Discretisation<D>& body) {
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(body.nodes() * D, body.nodes() * D);
  if (body.viscosity.nonZeros() == 0) return C;
  const Eigen::MatrixXd one = body.viscosity;
  for (Index p = 0; p < body.nodes(); ++p)
    for (Index q = 0; q < body.nodes(); ++q)
      for (int i = 0; i < D; ++i) C(p * D + i, q * D + i) = one(p, q);
  return C;
}

/// Δt at which the largest eigenvalue of Δt² K + 2Δt C relative to M is 4, by bisection.
template <int D>
double dense_step(const Discretisation<D>& body) {
  const Index dofs = body.nodes() * D;
  const auto root =
      Eigen::Map<const Eigen::VectorXd>(body.inverse_mass.data(), dofs).cwiseSqrt().eval();
  const Eigen::MatrixXd K = root.asDiagonal() * dense_stiffness<D>(body) * root.asDiagonal();
  if (!body.adjoint) {
    const auto values = Eigen::EigenSolver<Eigen::MatrixXd>(K, false).eigenvalues();
    return 2.0 / std::sqrt(values.cwiseAbs().maxCoeff());
  }
  const Eigen::MatrixXd C = root.asDiagonal() * dense_viscosity<D>(body) * root.asDiagonal();
  const auto excess = [&](double dt) {
    const Eigen::MatrixXd A = dt * dt * K + 2.0 * dt * C;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly)
               .eigenvalues()
               .maxCoeff() -
           4.0;
  };
  double lower = 0.0;
  double upper = 10.0 * body.spacing / body.wave_speed();
  for (int k = 0; k < 30; ++k) {
    const double middle = 0.5 * (lower + upper);
    (excess(middle) > 0.0 ? upper : lower) = middle;
  }
  return lower;
}

TEST_P(CriticalStepLaws, ItIsThatOfTheDenseSpectrum) {
  with_disc([]<int D>(const Discretisation<D>& body) {
    const double expected = dense_step<D>(body);

    const double actual = step_at_rest<D>(body);

    EXPECT_NEAR(actual, expected, 2e-3 * expected);
    EXPECT_NEAR(
        actual * body.wave_speed() / spacing,
        critical_step<D>(body, evaluated<D>(body, VectorField<D>::Zero(body.nodes(), D))).scaled,
        1e-9);
  });
}

INSTANTIATE_TEST_SUITE_P(, CriticalStepLaws, testing::ValuesIn(runs()), ByName());

/// Away from rest the tangent counts: compression stiffens a Neo-Hookean bar, c² = dP/dF / ρ.
TEST(CriticalStepOfADeformedBar, FollowsTheTangent) {
  const Variant bar{"interval", "stress-point", "", "", ""};
  const auto body = build<1>(scene_of(bar, {"material.law=neo-hookean"}));
  Tensor<1> H;
  H << -0.4;
  const auto state = evaluated<1>(body, affine<1>(body.particles.X, H, Vector<1>::Zero()));

  const double ratio = critical_step<1>(body, state).dt / step_at_rest<1>(body);

  const AnyLaw<1>& law = body.regions.front().law;
  const double expected =
      std::sqrt(tangent<1>(law, Tensor<1>::Zero())(0, 0) / tangent<1>(law, H)(0, 0));
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(ratio, expected, 2e-3);
}

}  // namespace
}  // namespace tlsph::property
