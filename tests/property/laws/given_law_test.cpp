/// A law that no list knows is swept with its own stress, whatever it is: here anisotropic ones,
/// which have no λ and μ.

#include "property/sweeps.hpp"
#include "tlsph/dynamics/hyperbolicity.hpp"
#include "tlsph/materials/kinematics.hpp"
#include "tlsph/materials/stress.hpp"
#include "tlsph/stepping/adaptive_step.hpp"
#include "tlsph/stepping/linearised_forces.hpp"

namespace tlsph::property {
namespace {

/// P = F S with S = C : E, or P = C : ε. C is positive and has no symmetry of a direction: in the
/// plane it acts on (E_11, E_22, 2E_12).
template <int D, bool Small>
struct Anisotropic {
  static constexpr std::string_view name = "anisotropic";
  static constexpr bool small_strain = Small;

  [[nodiscard]] Tensor<D> stress(const Tensor<D>& E) const {
    Tensor<D> S;
    if constexpr (D == 1) {
      S(0, 0) = 3e6 * E(0, 0);
    } else {
      const double a = E(0, 0), b = E(1, 1), c = E(0, 1) + E(1, 0);
      S(0, 0) = 6e6 * a + 1e6 * b + 5e5 * c;
      S(1, 1) = 1e6 * a + 2e6 * b - 3e5 * c;
      S(0, 1) = S(1, 0) = 5e5 * a - 3e5 * b + 4e5 * c;
    }
    return S;
  }
  [[nodiscard]] static Tensor<D> strain(const Tensor<D>& H) {
    return Small ? Tensor<D>(0.5 * (H + H.transpose())) : green_lagrange<D>(H);
  }
  [[nodiscard]] double energy(const Tensor<D>& H) const {
    const Tensor<D> E = strain(H);
    return 0.5 * E.cwiseProduct(stress(E)).sum();
  }
  [[nodiscard]] Tensor<D> pk1(const Tensor<D>& H) const {
    const Tensor<D> S = stress(strain(H));
    return Small ? S : Tensor<D>(S + H * S);
  }
  [[nodiscard]] Tensor<D> dpk1(const Tensor<D>& H, const Tensor<D>& dH) const {
    if (Small) return pk1(dH);
    const Tensor<D> F = deformation_gradient<D>(H);
    const Tensor<D> change = 0.5 * (F.transpose() * dH + dH.transpose() * F);
    return dH * stress(green_lagrange<D>(H)) + F * stress(change);
  }
  [[nodiscard]] Tangent<D> tangent(const Tensor<D>& H) const {
    Tangent<D> A;
    for (int column = 0; column < D * D; ++column) {
      Tensor<D> unit = Tensor<D>::Zero();
      unit(column / D, column % D) = 1.0;
      const Tensor<D> action = dpk1(H, unit);
      for (int row = 0; row < D * D; ++row) A(row, column) = action(row / D, row % D);
    }
    return A;
  }
  [[nodiscard]] double transverse_stretch(const Tensor<D>&) const { return 1.0; }
  [[nodiscard]] double transverse_stress(const Tensor<D>&) const { return 0.0; }
  [[nodiscard]] double margin(const Tensor<D>& H) const {
    return Small ? 1.0 : 1.0 + volume_change<D>(H);
  }
};

template <int D>
AnyLaw<D> own_law(bool small) {
  if (small) return GivenLaw<D, true>(Anisotropic<D, true>{});
  return GivenLaw<D, false>(Anisotropic<D, false>{});
}

/// The body with an own law, or that beside a listed one.
template <int D>
void set_own_law(Discretisation<D>& body, bool small, bool beside_another) {
  body.regions.front().law = own_law<D>(small);
  if (!beside_another) return;
  body.regions.push_back(body.regions.front());
  body.regions.back().law = make_law<D>(small ? LawName::linear_elastic : LawName::neo_hookean,
                                        Assumption::stress, young, 0.3);
  for (auto& region : body.regions) region.points.clear();
  for (int s = 0; s < body.points.size(); ++s) body.regions[s % 3 == 0 ? 0 : 1].points.push_back(s);
}

class OwnLaw : public testing::TestWithParam<Variant> {
 protected:
  template <class Use>
  void for_bodies(const Use& use) {
    for (const bool small : {false, true})
      for (const bool beside_another : {false, true}) {
        SCOPED_TRACE(std::string(small ? "small strains" : "large strains") +
                     (beside_another ? " beside another law" : ""));
        discretised(scene_of(GetParam()), [&]<int D>(Discretisation<D> body) {
          set_own_law(body, small, beside_another);
          use(body);
        });
      }
  }
};

TEST_P(OwnLaw, IsSweptWithItsOwnStress) {
  for_bodies([](const auto& body) { expect_the_same_step(body, 0.1); });
}

/// No product with a stiffness: that is for listed laws.
TEST_P(OwnLaw, IsNotSteppedByTheStiffnessOfAnother) {
  for_bodies([]<int D>(const Discretisation<D>& body) {
    const Sweep<D> sweep(body, {1, false, Instructions::widest, false, StepForm::stiffness});
    EXPECT_FALSE(sweep.stiffness_multiply_adds());
  });
}

/// f = −K u of the undeformed body, by a linearised sweep and by small displacements of the plain
/// one; K x of a deformed body by the passes of a sweep and by plain products.
TEST_P(OwnLaw, IsLinearisedWithItsOwnTangent) {
  for_bodies([]<int D>(const Discretisation<D>& body) {
    Random random(3);
    const VectorField<D> x = random.field<D>(body.nodes(), 1e-3);
    const State<D> rest = evaluated<D>(body, VectorField<D>::Zero(body.nodes(), D));
    VectorField<D> expected = x, force = x;
    LinearisedForces<D>(body, rest).product(x, expected);
    SweepOptions options;
    options.linearised = true;
    Sweep<D> linearised(body, options);
    State<D> moved = make_state<D>(body, x, VectorField<D>::Zero(body.nodes(), D));
    linearised.evaluate(moved);
    const double size = expected.cwiseAbs().maxCoeff();
    EXPECT_LE((moved.f - expected).cwiseAbs().maxCoeff(), 1e-13 * size);

    const State<D> strained = evaluated<D>(body, deformed<D>(body, random));
    const Sweep<D> sweep(body);
    LinearisedForces<D>(body, strained).product(x, expected);
    LinearisedForces<D>(body, strained, &sweep).product(x, force);
    EXPECT_LE((force - expected).cwiseAbs().maxCoeff(), 1e-13 * size);
  });
}

INSTANTIATE_TEST_SUITE_P(, OwnLaw,
                         testing::Values(Variant{"interval", "stress-point", "", "", ""},
                                         Variant{"box", "stress-point", "", "", ""},
                                         Variant{"jittered", "variational", "", "wendland-c2",
                                                 "2.5"}),
                         ByName());

/// A listed law behind the pointer is that law, for all that asks a law.
TEST(GivenLaw, OfAListedLawIsThatLaw) {
  Discretisation<2> body = build<2>(scene_of({"box", "stress-point", "", "", ""}));
  const NeoHookean<2> listed(lame(young, 0.45));
  Random random(5);
  const VectorField<2> u = affine<2>(body.particles.X, random.tensor<2>(0.3), Vector<2>::Zero());
  body.regions.front().law = listed;
  const State<2> expected = evaluated<2>(body, u);
  const double dt = critical_step<2>(body, expected).dt;
  const double energy = elastic_energy<2>(body, expected);
  AdaptiveStep<2> follower(body, evaluated<2>(body, VectorField<2>::Zero(body.nodes(), 2)), 0.9);
  const double first = follower.step();

  body.regions.front().law = GivenLaw<2, false>(listed);
  const State<2> state = evaluated<2>(body, u);

  EXPECT_EQ(state.P, expected.P);
  EXPECT_EQ(state.f, expected.f);
  EXPECT_NEAR(critical_step<2>(body, state).dt, dt, 1e-12 * dt);
  EXPECT_EQ(elastic_energy<2>(body, state), energy);
  EXPECT_EQ(cauchy<2>(body.regions.front().law, random.tensor<2>(0.0), tensor_at<2>(state.P, 3)),
            cauchy<2>(AnyLaw<2>(listed), Tensor<2>::Zero(), tensor_at<2>(state.P, 3)));
  EXPECT_FALSE(most_unstable_point<2>(body, state));
  AdaptiveStep<2> other(body, evaluated<2>(body, VectorField<2>::Zero(body.nodes(), 2)), 0.9);
  EXPECT_NEAR(other.step(), first, 1e-12 * first);
}

}  // namespace
}  // namespace tlsph::property
