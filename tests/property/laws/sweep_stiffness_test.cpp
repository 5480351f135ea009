/// Steps of linear bodies as one product with their stiffness are those of `evaluate` and
/// `advance`, and keep what those keep.

#include "property/sweeps.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph::property {
namespace {

/// Bodies of linear laws, which the stiffness may step.
class SweepOfStencils : public testing::TestWithParam<Variant> {};

TEST_P(SweepOfStencils, IsTheStepOfTheProducts) {
  for (const Material& material : materials()) {
    if (!material.linear()) continue;
    for (const std::string& stabiliser : {std::string("none"), GetParam().stabiliser()}) {
      SCOPED_TRACE(material.assumption + (", " + stabiliser));
      std::vector<std::string> overrides = as_stiffness(stabiliser);
      overrides.push_back(fine_spacing(GetParam()));
      discretised(scene_of(GetParam(), overrides), [&](auto body) {
        set_material(body, material);
        expect_the_same_step(body);
        expect_the_same_step(body, 0.1, StepForm::stiffness);
      });
    }
  }
}

/// A gradient that a solve corrected has rows that sum to its residual.
std::vector<Variant> variants_that_see_no_translation() {
  std::vector<Variant> all = variants_of_one_kernel();
  std::erase_if(all, [](const Variant& variant) { return !variant.consistency.empty(); });
  return all;
}

INSTANTIATE_TEST_SUITE_P(, SweepOfStencils, testing::ValuesIn(variants_that_see_no_translation()),
                         ByName());

TEST(SweepOfStiffness, IsTheStepOfTheProductsOfSmallBodies) {
  for (const char* size : {"0.02", "0.01", "0.005"})
    for (const char* layout : {"interval", "box"}) {
      SCOPED_TRACE(fmt::format("{} of {} m", layout, size));
      const Variant variant{layout, "stress-point", "", "", ""};
      std::vector<std::string> overrides = as_stiffness(variant.stabiliser());
      overrides.push_back(std::string("body.spacing=") + size);
      discretised(scene_of(variant, overrides),
                  [](const auto& body) { expect_the_same_step(body, 0.1, StepForm::stiffness); });
    }
}

/// Two linear materials, side by side, with all that boundaries do.
TEST(SweepOfStiffness, IsTheStepOfBoundariesAndRegions) {
  for (const char* split : {"0.1", "0.034", "0.197"}) {
    std::string text = busy_scene;
    for (const char* law : {"neo-hookean", "st-venant-kirchhoff"})
      text.replace(text.find(law), std::string_view(law).size(), "linear-elastic");
    text.replace(text.find("[0.1, 0.1]"), 10,
                 fmt::format("[{}, 0.1]]\nyoung = 5e6\npoisson = 0.2\n#", split));
    Discretisation<2> body = build<2>(read_scene_text(text, "busy"));
    ASSERT_EQ(body.regions.size(), 2);

    expect_the_same_step(body, 0.01, StepForm::stiffness);
  }
}

/// What one node gains others lose, far from where the body was.
TEST(SweepOfStiffness, KeepsMomentaOfAFreeBody) {
  const Discretisation<2> body = build<2>(
      scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3", "stabiliser.kind=cell"}));
  State<2> state = moving<2>(body);
  state.u.rowwise() += Eigen::RowVector2d(0.5, -0.25);
  const auto momenta = [&] {
    const VectorField<2> p = state.v.array().colwise() * body.mass.array();
    const auto& X = body.particles.X;
    return Eigen::Vector3d(p.col(0).sum(), p.col(1).sum(),
                           X.col(0).dot(p.col(1)) - X.col(1).dot(p.col(0)));
  };
  const Eigen::Vector3d before = momenta();
  const double size = body.mass.sum() * state.v.cwiseAbs().maxCoeff();
  Sweep<2> sweep(body, {1, false, Instructions::widest, false, StepForm::stiffness});
  BoundaryForces<2> forces(body);

  for (int n = 1; n <= 100; ++n) sweep.step(state, dt, now + n * dt, forces);

  EXPECT_LE((momenta() - before).cwiseAbs().maxCoeff(), 1e-14 * size);
}

TEST(SweepOfStiffness, MovesNothingThatIsCarried) {
  const Discretisation<2> body = build<2>(
      scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3", "stabiliser.kind=cell"}));
  State<2> state = make_state<2>(body, VectorField<2>::Constant(body.nodes(), 2, 7.1),
                                 VectorField<2>::Zero(body.nodes(), 2));
  state.last_dt = dt;
  Sweep<2> sweep(body, {1, false, Instructions::widest, false, StepForm::stiffness});
  BoundaryForces<2> forces(body);

  sweep.step(state, dt, dt, forces);

  EXPECT_EQ(state.v.cwiseAbs().maxCoeff(), 0.0);
}

TEST(SweepOfStiffness, IsTakenWhereItIsLessWork) {
  const auto takes = [](const Variant& variant, const char* override_of) {
    return Sweep<2>(build<2>(scene_of(variant, {"body.spacing=4e-3", override_of})))
        .stiffness_multiply_adds()
        .has_value();
  };
  const Variant cells{"box", "stress-point", "", "", ""};

  EXPECT_TRUE(takes(cells, "stabiliser.kind=cell"));
  EXPECT_TRUE(takes(cells, "stabiliser.kind=none"));
  EXPECT_FALSE(takes(cells, "material.law=neo-hookean"));
  EXPECT_FALSE(takes(cells, "body.jitter=0.2"));
  EXPECT_FALSE(takes({"box", "variational", "", "wendland-c2", "2.5"}, "stabiliser.kind=none"));
}

/// A linear body in which one particle is nowhere.
TEST(SweepOfStiffness, RestoresTheStateThatHasNoStress) {
  const Discretisation<2> body =
      build<2>(scene_of({"box", "stress-point", "", "", ""}, {"body.spacing=4e-3"}));
  constexpr double far = 1e303;
  const auto broken = [&] {
    State<2> state = moving<2>(body);
    state.u(body.nodes() / 2, 0) = far;
    return state;
  };
  for (const StepForm form : {StepForm::points, StepForm::stiffness})
    for (const SweepOptions& way : ways(form)) {
      State<2> state = broken();
      Sweep<2> sweep(body, way);
      BoundaryForces<2> forces(body);

      EXPECT_THROW(sweep.step(state, dt, now + dt, forces), NumericalError);

      EXPECT_EQ(state.u(body.nodes() / 2, 0), far);
      state.u(body.nodes() / 2, 0) = broken().u(body.nodes() / 2, 0);
      EXPECT_LE((state.u - broken().u).cwiseAbs().maxCoeff(), 1e-15);
      EXPECT_LE((state.v - broken().v).cwiseAbs().maxCoeff(), 1e-11);
      EXPECT_EQ(state.step, 0);
      EXPECT_EQ(state.time, now);
    }
}

}  // namespace
}  // namespace tlsph::property
