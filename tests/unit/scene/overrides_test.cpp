// --set key=value.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string bar = smallest_bar + R"([[boundary]]
where = "left"
traction = { curve = "ramp", amplitude = 1e5, rise = 1e-4 }
[[probe]]
at = [0.1]
[[probe]]
at = [0.2]
)";

Scene read_with(const std::vector<std::string>& overrides) {
  return read_scene_text(bar, "bar.toml", overrides);
}

std::string refusal(const std::string& change) {
  try {
    static_cast<void>(read_with({change}));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Override, ReplacesAValue) {
  EXPECT_EQ(read_with({"body.spacing=0.05"}).body.spacing, 0.05);
}

TEST(Override, ReachesIntoLists) {
  const Scene scene = read_with({"boundary[0].traction.amplitude=-2e5", "probe[1].at=[0.3]"});

  EXPECT_EQ(std::get<RampCurve>(*scene.boundaries[0].normal_traction).amplitude, -2e5);
  EXPECT_EQ(scene.probes[1].at[0], 0.3);
}

TEST(Override, ReachesIntoListsOfNumbers) {
  EXPECT_EQ(read_with({"probe[1].at[0]=0.3"}).probes[1].at[0], 0.3);
}

TEST(Override, SetsKeysTheFileDoesNotHave) {
  const Scene scene = read_with({"output.frames=3", "formulation=thesis", "kernel.support=3.5"});

  EXPECT_EQ(scene.output.frames, 3);
  EXPECT_EQ(scene.formulation, Formulation::thesis);
  EXPECT_EQ(scene.kernel.support, 3.5);
}

TEST(Override, AppendsToAList) {
  const Scene scene = read_with({"probe[2].at=[0.9]", "probe[2].name=last"});

  ASSERT_EQ(scene.probes.size(), 3U);
  EXPECT_EQ(scene.probes[2].name, "last");
}

TEST(Override, IsReadAsTomlElseAsText) {
  EXPECT_EQ(read_with({"title=\"in quotes\""}).title, "in quotes");
  EXPECT_EQ(read_with({"title=two words"}).title, "two words");
  EXPECT_EQ(read_with({"title = spaces around "}).title, "spaces around");
  EXPECT_EQ(read_with({"title=a=b"}).title, "a=b");
  EXPECT_EQ(read_with({"boundary[0]={where=\"left\", fixed=true}"}).boundaries[0].fixed.size(), 1U);
}

TEST(Override, LaterOnesWin) {
  EXPECT_EQ(read_with({"body.spacing=0.05", "body.spacing=0.2"}).body.spacing, 0.2);
}

TEST(Override, MakesATextThatReadsBackTheSame) {
  const Scene scene = read_with({"title=\"tab\\t quote \\\" end\"", "body.spacing=0.05",
                                 "time.end=1e-300", "output.fields=[]"});

  const Scene again = read_scene_text(scene.text, "again.toml");

  EXPECT_EQ(again.title, "tab\t quote \" end");
  EXPECT_EQ(again.body.spacing, 0.05);
  EXPECT_EQ(again.time.end, 1e-300);
  EXPECT_TRUE(again.output.fields.empty());
  EXPECT_EQ(again.probes.size(), 2U);
  EXPECT_EQ(std::get<RampCurve>(*again.boundaries[0].normal_traction).rise, 1e-4);
}

struct Refusal {
  std::string change, message;
};

void PrintTo(const Refusal& refused, std::ostream* stream) {
  *stream << refused.message;
}

class BadOverride : public testing::TestWithParam<Refusal> {};

TEST_P(BadOverride, IsRefusedByItsOwnName) {
  const auto& [change, message] = GetParam();

  EXPECT_THAT(refusal(change), StartsWith("--set " + change + ": " + message));
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadOverride,
    testing::Values(
        Refusal{"body.spacng=1", "unknown key, did you mean body.spacing"},
        Refusal{"probe[0].att=[0]", "unknown key, did you mean probe[0].at"},
        Refusal{"outputs.frames=1", "outputs: unknown key, did you mean output"},
        Refusal{"output.frame=1", "unknown key, did you mean output.frames"},
        Refusal{"body.spacing=-1", "must be > 0, not -1"},
        Refusal{"body.spacing=.5", "must be a number, not the text \".5\""},
        Refusal{"body.spacing=", "must be a number, not the text \"\""},
        Refusal{"boundary[0].traction={curve=\"ramp\", rise=1e-4}",
                "boundary[0].traction.amplitude: missing"},
        Refusal{"probe[5].at=[0]", "probe has 2 entries; the next index is 2"},
        Refusal{"boundary.where=left", "boundary is a list: say which entry, boundary[0].where"},
        Refusal{"body[0].spacing=1", "body is a table, not a list"},
        Refusal{"dimension.x=1", "dimension is 1, not a table: set it as a whole, dimension={ … }"},
        Refusal{"no equals", "an override is key=value"}, Refusal{"=1", "an override is key=value"},
        Refusal{"a..b=1", "the path is names joined by dots"},
        Refusal{"a.=1", "the path is names joined by dots"},
        Refusal{"probe[x].at=1", "the path is names joined by dots"},
        Refusal{"probe[.at=1", "the path is names joined by dots"},
        Refusal{"probe[0]at=1", "the path is names joined by dots"},
        Refusal{"[0]=1", "the path is names joined by dots"},
        Refusal{"title=\xff", "byte 0xff is not UTF-8"}, Refusal{"time.end=1\nstep=2", "must be"}));

TEST(BadOverride, NamesTheFileForWhatTheFileSays) {
  EXPECT_THAT(refusal("dimension=2"), StartsWith("bar.toml:3:"));
  EXPECT_THAT(refusal("dimension=2"), HasSubstr("body.shape.interval: no shape in dimension 2"));
}

}  // namespace
}  // namespace tlsph
