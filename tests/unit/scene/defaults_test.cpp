// What a scene says when it says as little as it may.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Defaults, OfASheet) {
  const Scene scene = sheet_with({});

  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.formulation, Formulation::stress_point);
  EXPECT_EQ(scene.body.placement, NodePlacement::on_boundary);
  EXPECT_EQ(scene.body.jitter, 0.0);
  EXPECT_EQ(scene.materials.front().law, LawName::neo_hookean);
  EXPECT_EQ(scene.materials.front().assumption, Assumption::strain);
  EXPECT_EQ(scene.time.safety, 0.9);
  EXPECT_FALSE(scene.time.step);
  EXPECT_THAT(scene.boundaries, IsEmpty());
  EXPECT_THAT(scene.probes, IsEmpty());
  EXPECT_THAT(scene.body_force, IsEmpty());
  EXPECT_EQ(scene.exact, ExactKind::none);
  EXPECT_EQ(scene.displacement.kind, InitialField::Kind::zero);
  EXPECT_EQ(scene.text, smallest_sheet);
  EXPECT_EQ(scene.file, "sheet.toml");
}

TEST(Defaults, OfThePlainStructAreThoseOfTheKeyTable) {
  const OutputScene output;
  const Scene scene = sheet_with({});

  EXPECT_EQ(scene.output.frames, output.frames);
  EXPECT_EQ(scene.output.probe_every, output.probe_every);
  EXPECT_EQ(scene.output.energy_every, output.energy_every);
  EXPECT_EQ(scene.output.checkpoint, output.checkpoint);
  EXPECT_EQ(scene.output.checkpoint_steps, output.checkpoint_steps);
  EXPECT_EQ(scene.output.fields, output.fields);
  EXPECT_EQ(scene.body.seed, BodyScene{}.seed);
  EXPECT_EQ(scene.materials.front().law, MaterialScene{}.law);
  EXPECT_EQ(scene.time.safety, TimeScene{}.safety);
  EXPECT_EQ(scene.formulation, Scene{}.formulation);
  EXPECT_EQ(scene.dimension, Scene{}.dimension);
}

struct FormulationDefaults {
  std::string formulation;
  int dimension;
  std::string family;
  std::optional<double> support;
  Correction correction;
  StabiliserKind stabiliser;
};

void PrintTo(const FormulationDefaults& expected, std::ostream* stream) {
  *stream << expected.formulation << ' ' << expected.dimension << "D";
}

class DefaultsByFormulation : public testing::TestWithParam<FormulationDefaults> {};

TEST_P(DefaultsByFormulation, KernelAndStabiliser) {
  const auto& expected = GetParam();
  const auto change = "formulation=" + expected.formulation;

  const Scene scene = expected.dimension == 1 ? bar_with({change}) : sheet_with({change});

  EXPECT_EQ(name_of(scene.formulation), expected.formulation);
  EXPECT_EQ(scene.kernel.family, expected.family);
  EXPECT_EQ(scene.kernel.support, expected.support);
  EXPECT_EQ(scene.kernel.correction, expected.correction);
  EXPECT_EQ(scene.stabiliser.kind, expected.stabiliser);
  EXPECT_EQ(scene.stabiliser.action, StabiliserAction::stiffness);
  EXPECT_FALSE(scene.stabiliser.coefficient);
}

constexpr auto plain = Correction::none;
constexpr auto corrected = Correction::least_squares;
INSTANTIATE_TEST_SUITE_P(
    All, DefaultsByFormulation,
    testing::Values(
        FormulationDefaults{"thesis", 1, "modified-mollifier", 2.5, plain, StabiliserKind::none},
        FormulationDefaults{"thesis", 2, "modified-mollifier", 2.5, plain, StabiliserKind::none},
        FormulationDefaults{"mirror", 1, "modified-mollifier", 2.5, plain, StabiliserKind::none},
        FormulationDefaults{"mirror", 2, "modified-mollifier", 2.5, plain, StabiliserKind::none},
        FormulationDefaults{"variational", 1, "wendland-c2", 2.5, corrected, StabiliserKind::none},
        FormulationDefaults{"variational", 2, "wendland-c2", 2.5, corrected, StabiliserKind::pair},
        FormulationDefaults{"consistent", 1, "wendland-c2", 3.1, corrected, StabiliserKind::pair},
        FormulationDefaults{"consistent", 2, "wendland-c2", 3.6, corrected, StabiliserKind::pair},
        FormulationDefaults{"stress-point", 1, "wendland-c2", {}, corrected, StabiliserKind::none},
        FormulationDefaults{
            "stress-point", 2, "wendland-c2", {}, corrected, StabiliserKind::cell}));

TEST(Defaults, StressPointsWithASupportHaveNoCellStabiliser) {
  const Scene scene = sheet_with({"kernel.support=1.8"});

  EXPECT_EQ(scene.kernel.support, 1.8);
  EXPECT_EQ(scene.stabiliser.kind, StabiliserKind::none);
}

TEST(Material, RegionsInheritWhatTheyLeaveOut) {
  const Scene scene =
      sheet_with({"material.law=st-venant-kirchhoff", "material.assumption=stress",
                  "material.region[0]={box=[[0, 0], [1, 1]], young=5e6}",
                  "material.region[1].box=[[1, 0], [2, 1]]",
                  "material.region[1].law=linear-elastic", "material.region[1].density=7"});

  ASSERT_EQ(scene.materials.size(), 3U);
  EXPECT_THAT(scene.materials[0].lower, IsEmpty());
  EXPECT_EQ(scene.materials[1].law, LawName::st_venant_kirchhoff);
  EXPECT_EQ(scene.materials[1].assumption, Assumption::stress);
  EXPECT_THAT(scene.materials[1].constants, ElementsAre(5e6, 0.3));
  EXPECT_EQ(scene.materials[1].density, 1000);
  EXPECT_THAT(scene.materials[1].upper, ElementsAre(1, 1));
  EXPECT_EQ(scene.materials[2].law, LawName::linear_elastic);
  EXPECT_EQ(scene.materials[2].constant("young"), 1e6);
  EXPECT_EQ(scene.materials[2].density, 7);
  EXPECT_THAT(scene.materials[2].lower, ElementsAre(1, 0));
}

TEST(Probes, AreNumberedWhereTheyHaveNoName) {
  const Scene scene =
      sheet_with({"probe[0].at=[0, 0]", "probe[1].at=[1, 1]", "probe[1].name=a-1",
                  "probe[2].at=[2, 0.5]", "probe[2].record=[\"pk1\", \"pressure\"]"});

  EXPECT_EQ(scene.probes[0].name, "p1");
  EXPECT_EQ(scene.probes[1].name, "a-1");
  EXPECT_EQ(scene.probes[2].name, "p3");
  EXPECT_THAT(scene.probes[0].record, ElementsAre("displacement"));
  EXPECT_THAT(scene.probes[2].record, ElementsAre("pk1", "pressure"));
}

TEST(Initial, LinearFieldsFillWhatIsLeftOut) {
  const Scene scene = sheet_with(
      {"initial.displacement={constant=[1, 2]}", "initial.velocity.gradient=[[1, 2], [3, 4]]"});

  EXPECT_EQ(scene.displacement.kind, InitialField::Kind::linear);
  EXPECT_THAT(scene.displacement.constant, ElementsAre(1, 2));
  EXPECT_THAT(scene.displacement.gradient, ElementsAre(ElementsAre(0, 0), ElementsAre(0, 0)));
  EXPECT_THAT(scene.velocity.constant, ElementsAre(0, 0));
  EXPECT_THAT(scene.velocity.gradient, ElementsAre(ElementsAre(1, 2), ElementsAre(3, 4)));
}

TEST(Initial, NamedFieldsHaveAnAmplitude) {
  const Scene scene = sheet_with(
      {"initial.velocity={field=\"cantilever-mode\", amplitude=2.5}", "initial.displacement=zero"});

  EXPECT_EQ(scene.velocity.kind, InitialField::Kind::cantilever_mode);
  EXPECT_EQ(scene.velocity.amplitude, 2.5);
  EXPECT_EQ(scene.displacement.kind, InitialField::Kind::zero);
}

TEST(Places, PointIntoTheFile) {
  const Scene scene = read_scene_text(smallest_sheet + "[reference]\nexact = \"none\"\n", "s.toml");

  EXPECT_EQ(scene.body.place.line, 1);
  EXPECT_EQ(scene.body.spacing_place.line, 3);
  EXPECT_EQ(scene.body.spacing_place.key, "body.spacing");
  EXPECT_EQ(scene.exact_place.line, 11);
  EXPECT_EQ(scene.exact_place.column, 9);
  EXPECT_EQ(scene.exact_place.file, "s.toml");
}

TEST(Reference, NamesEveryChoiceOfEveryEnumeration) {
  const std::string reference = scene_reference();

  for (const auto& list : {choices<Formulation>(), choices<GhostClosure>(), choices<SolverChoice>(),
                           choices<NodePlacement>(), choices<Correction>(),
                           choices<StabiliserKind>(), choices<LawName>(), choices<ExactKind>()})
    EXPECT_THAT(reference, testing::HasSubstr(list));
}

TEST(Reference, IsReadable) {
  const std::string reference = scene_reference();

  EXPECT_THAT(reference, testing::HasSubstr("  young               number [Pa], required"));
  EXPECT_THAT(reference, testing::HasSubstr("  layout              text, default \"square\""));
  EXPECT_THAT(reference, testing::HasSubstr("\n[[material.region]]\n"));
  EXPECT_THAT(reference, testing::HasSubstr("  safety              number, default 0.9"));
}

}  // namespace
}  // namespace tlsph
