#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A lopsided sheet of a linear law that needs all it has.
const std::string lean = R"([body]
shape = { box = [[0.0, 0.0], [1.0, 1.0]] }
spacing = 0.1
[material]
law = "linear-elastic"
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = [0.0, 1e-2]
[time]
end = 2e-2
[output]
frames = 0
)";

std::string spare(const std::vector<std::string>& overrides = {}) {
  const std::string text = plan(read_scene_text(lean, "scene", overrides)).text;
  const auto begin = text.find("it could do without\n");
  return begin == std::string::npos ? "" : text.substr(begin);
}

TEST(Plan, OfALeanSceneHasNothingToSpare) {
  EXPECT_EQ(spare(), "");
}

TEST(Plan, NamesADimensionNothingDependsOn) {
  EXPECT_THAT(spare({"boundary=[{where=\"left\",fixed=\"x\"},{where=\"right\",traction=1.0},"
                     "{where=\"top\",symmetry=true},{where=\"bottom\",symmetry=true}]"}),
              AllOf(HasSubstr("1D: nothing depends on y; 11 particles in place of 121"),
                    Not(HasSubstr("plane of symmetry"))));
}

TEST(Plan, NamesAPlaneOfSymmetry) {
  EXPECT_THAT(spare({"boundary[1].traction=1.0"}),
              AllOf(HasSubstr("y = 0.5 m is a plane of symmetry; 66 particles in place of 121"),
                    Not(HasSubstr("x = "))));
}

TEST(Plan, NamesALawThatIsLinearAtItsStrains) {
  const std::string strains = "neo-hookean at strains of at most about 4.0e-08";

  EXPECT_THAT(spare({"material.law=neo-hookean"}), HasSubstr(strains));  // 2·2·p/E
  EXPECT_EQ(spare({"material.law=neo-hookean", "boundary[1].traction=[0.0,1e3]"}), "");
  EXPECT_EQ(
      spare({"material.law=neo-hookean", "boundary[0]={where=\"left\",displacement={x=0.01}}"}),
      "");
  EXPECT_EQ(spare({"material.law=neo-hookean", "initial.velocity=[0.0,1.0]"}), "");
}

TEST(Plan, NamesASupportAboveWhatTheFormulationNeeds) {
  const std::vector<std::string> wide = {"formulation=variational", "kernel.support=3.6"};

  EXPECT_THAT(spare(wide), AllOf(HasSubstr("  support 3.6 with"), HasSubstr("support 2.5 would")));
  EXPECT_EQ(spare({"formulation=variational"}), "");
  EXPECT_THAT(spare({"kernel.support=2.5"}), HasSubstr("the nodes of each cell"));
}

TEST(Plan, NamesFramesThatTakeLongerThanTheSteps) {
  EXPECT_THAT(spare({"output.frames=1000", "output.fields=[\"displacement\"]"}),
              HasSubstr("1001 frames, 1.9 MB, take about 1 s beside"));
  EXPECT_EQ(spare({"output.frames=1", "output.fields=[\"displacement\"]"}), "");
}

TEST(Plan, NamesStressThatNobodyAsksFor) {
  const std::vector<std::string> frames = {"output.frames=100", "time.end=20"};
  auto read_too = frames;
  read_too.emplace_back("probe=[{name=\"a\",at=[1.0,1.0],record=[\"cauchy\"]}]");
  auto no_stress = frames;
  no_stress.emplace_back("output.fields=[\"displacement\"]");

  EXPECT_THAT(spare(frames), HasSubstr("0.32 of 0.71 MB"));  // 100 cells of 4, 121 nodes of 2 + 2
  EXPECT_EQ(spare(read_too), "");
  EXPECT_EQ(spare(no_stress), "");
}

/// A load on 0.51 … 0.71 of the top, which ends within faces.
const std::vector<std::string> part = {
    "body.tags=[{name=\"part\",box=[[0.51,0.999],[0.71,1.001]]},"
    "{name=\"tip\",box=[[0.999,0.999],[1.001,1.001]]}]",
    "boundary[1]={where=\"part\",traction=[0.0,-1e3]}"};

TEST(Plan, SaysWhatALoadActsOnAndSumsTo) {
  for (const char* formulation : {"stress-point", "variational", "consistent"}) {
    std::vector<std::string> overrides = part;
    overrides.push_back(std::string("formulation=") + formulation);
    const std::string text = plan(read_scene_text(lean, "scene", overrides)).text;
    EXPECT_THAT(text, HasSubstr("load on part: 0.2 m of the boundary, resultant (0, -200) N"))
        << formulation;
    EXPECT_THAT(text, HasSubstr("tag part: 2 particles, 0.2 m of the boundary\n")) << formulation;
    EXPECT_THAT(text, HasSubstr("tag tip: 1 particle, 0.002 m of the boundary\n")) << formulation;
  }
}

/// Stress points on the edges of triangles; not in cells, nor in plane stress.
TEST(Plan, WarnsOfLockingWhereItIs) {
  const auto warns = [](const std::vector<std::string>& overrides) {
    const std::string text = plan(read_scene_text(lean, "scene", overrides)).text;
    return text.find("warning: stress points on the edges of triangles lock") != std::string::npos;
  };
  const std::string triangles = "body.layout=hexagonal";
  EXPECT_TRUE(warns({triangles, "material.poisson=0.45"}));
  EXPECT_TRUE(warns({triangles, "material.poisson=0.499"}));
  EXPECT_FALSE(warns({triangles, "material.poisson=0.44"}));
  EXPECT_FALSE(warns({triangles, "material.poisson=0.499", "material.assumption=stress"}));
  EXPECT_FALSE(warns({triangles, "material.poisson=0.499", "formulation=variational"}));
  EXPECT_FALSE(warns({"material.poisson=0.499"}));
}

}  // namespace
}  // namespace tlsph
