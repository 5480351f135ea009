// Scenes changed by a program and printed.
#include "tlsph/scene/edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "scenes.hpp"

namespace tlsph {
namespace {

/// Every key has the same value in both, whether given or by default.
bool equal(const Scene& a, const Scene& b) {
  return print_scene(a, Printed::all) == print_scene(b, Printed::all);
}

using testing::HasSubstr;
using testing::Not;

Scene read_back(const Scene& scene) {
  return read_scene_text(print_scene(scene), scene.file);
}

std::vector<std::filesystem::path> scene_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"examples", "tests", "validation"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(TLSPH_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  return files;
}

class PrintedFile : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(PrintedFile, ReadsBackTheSame) {
  const Scene scene = read_scene(GetParam());

  const Scene again = read_back(scene);

  EXPECT_TRUE(equal(scene, again)) << print_scene(scene);
  EXPECT_EQ(print_scene(scene), print_scene(again));
}

INSTANTIATE_TEST_SUITE_P(All, PrintedFile, testing::ValuesIn(scene_files()), [](const auto& file) {
  std::string name = file.param.string().substr(std::string(TLSPH_SOURCE_DIR).size());
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

TEST(PrintedFiles, AreMany) {
  EXPECT_GE(scene_files().size(), 30U);
}

/// Settings that a sheet may have, each in some of the random scenes.
const std::vector<std::string> settings = {
    R"(title="a \"b\" \\ c")",
    "formulation=variational",
    "formulation=consistent",
    "precision=mixed",
    "consistency=true",
    "gravity=[0.1, -9.81]",
    "body.shape={disc={centre=[0.5, 1e-3], radius=0.3}}",
    "body.shape={polygon=[[0, 0], [1, 0], [0.3, 0.7]]}",
    "body.shape={difference=[{box=[[0, 0], [2, 1]]}, {disc={centre=[1, 0.5], radius=0.1}}]}",
    "body.spacing=0.012345678901234567",
    "body.layout=hexagonal",
    "body.jitter=0.3",
    "body.seed=123456789012",
    R"(body.tags=[{name="part", box=[[0, 0], [0.1, 0.2]]}])",
    "kernel.family=gaussian",
    "kernel.support=3.1",
    "kernel.correction=least-squares",
    "stabiliser.kind=pair",
    "stabiliser={kind=\"pair\", coefficient=0.123, as=\"viscosity\"}",
    "material.law=linear-elastic",
    "material.assumption=stress",
    "material.region=[{box=[[0, 0], [0.1, 0.2]], young=3}, {box=[[0, 0], [1, 1]], density=1e3, "
    "law=\"st-venant-kirchhoff\"}]",
    R"(boundary[0]={where="left", fixed="y"})",
    R"(boundary[0]={where="left", fixed=false})",
    R"(boundary[0]={where="outer", held=["x"]})",
    R"(boundary[0]={where="left", traction=[0, 0]})",
    R"(boundary[0]={where="left", traction={curve="table", time=[0, 1], value=[1, 2.1]}})",
    R"(boundary[0]={where="left", traction={curve="pulse", amplitude=[1, 3], rise=1, duration=2}})",
    R"(boundary[0]={where="left", displacement={y={curve="table", time=[0, 1, 3], value=[0, 2, 1],)"
    " amplitude=0.1}, x=1e-9}}",
    R"(boundary[0]={where="left", symmetry=true, displacement={y={curve="sine-squared", )"
    "amplitude=0.1, duration=2}}}",
    R"(boundary[0]={where="left", traction={curve="smooth-ramp", amplitude=0.3, rise=0.7}})",
    "time.safety=0.7",
    "time.step=1e-7",
    "time.energy_tolerance=0.3",
    "probe[0]={at=[0.5, 0.01]}",
    R"(probe[0]={at=[0.5, 0.01], name="p", record=["velocity", "pk1"]})",
    "initial.velocity=[0.1, 0.3]",
    "initial.displacement={gradient=[[0, 0.1], [1, 2]]}",
    "initial.region=[{box=[[0, 0], [1, 1]], velocity=[1, 2], displacement=\"zero\"}]",
    "output={frames=0, fields=[], checkpoint=1.5, probe_every=3}",
};

TEST(PrintedScene, OfRandomSettingsReadsBackTheSame) {
  std::mt19937 random(7);
  std::bernoulli_distribution chosen(0.15);
  int sound = 0;
  for (int sample = 0; sample < 2000; ++sample) {
    std::vector<std::string> overrides;
    for (const std::string& setting : settings)
      if (chosen(random)) overrides.push_back(setting);
    Scene scene;
    try {
      scene = sheet_with(overrides);
    } catch (const InputError&) {
      continue;  // settings that contradict each other
    }
    ++sound;
    ASSERT_TRUE(equal(scene, read_back(scene))) << scene.text << "\n-- printed:\n"
                                                << print_scene(scene);
  }
  EXPECT_GE(sound, 200);
}

TEST(PrintedScene, SaysWhatIsGiven) {
  const std::string printed = print_scene(sheet_with({"kernel.order=1", "output.frames=3"}));

  EXPECT_THAT(printed, HasSubstr("order = 1"));
  EXPECT_THAT(printed, HasSubstr("frames = 3"));
  EXPECT_THAT(printed, Not(HasSubstr("family")));
  EXPECT_THAT(printed, Not(HasSubstr("safety")));
}

TEST(Completed, DefaultsFollowTheKeysTheyDependOn) {
  Scene scene = sheet_with({"kernel.support=3.1"});

  scene.formulation = Formulation::thesis;
  scene = completed(scene);

  EXPECT_EQ(scene.kernel.support, 3.1);
  EXPECT_EQ(scene.kernel.family, "modified-mollifier");
  EXPECT_EQ(scene.kernel.correction, Correction::none);
  EXPECT_EQ(scene.stabiliser.kind, StabiliserKind::none);
  EXPECT_EQ(scene.text, print_scene(scene));
}

TEST(Completed, IsAsIfTheFileSaidSo) {
  Scene scene = sheet_with({"consistency=true"});

  scene.formulation = Formulation::consistent;
  scene.kernel.support = 4.0;
  scene.body.spacing = 0.05;
  BoundaryScene& left = scene.boundaries.emplace_back();
  left.where = "left";
  left.fixed = {0, 1};

  EXPECT_TRUE(equal(completed(scene), sheet_with({"consistency=true", "formulation=consistent",
                                                  "kernel.support=4", "body.spacing=0.05",
                                                  R"(boundary[0]={where="left", fixed=true})"})));
}

TEST(Completed, RefusesWhatAFileMayNotSay) {
  Scene scene = sheet_with({"boundary_treatment=consistent", "formulation=thesis"});
  scene.formulation = Formulation::mirror;
  EXPECT_THROW((void)completed(scene), InputError);

  scene = sheet_with({});
  scene.body.spacing = -1.0;
  EXPECT_THROW((void)completed(scene), InputError);
}

TEST(Completed, KeepsPlaces) {
  const Scene scene = sheet_with({});

  EXPECT_EQ(completed(scene).body.spacing_place.line, scene.body.spacing_place.line);
  EXPECT_EQ(completed(scene).body.spacing_place.key, "body.spacing");
}

TEST(EqualScenes, DifferInNoKey) {
  EXPECT_TRUE(equal(sheet_with({}), sheet_with({"time.safety=0.9"})));
  EXPECT_FALSE(equal(sheet_with({}), sheet_with({"time.safety=0.8"})));
  EXPECT_FALSE(equal(sheet_with({}), sheet_with({"formulation=variational"})));
}

}  // namespace
}  // namespace tlsph
