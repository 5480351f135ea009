#include "tlsph/studies/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "study_folder.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;
using testing::ThrowsMessage;

const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";

/// A plate that is pulled at both ends, a hole in its middle.
const std::string pulled_plate = R"(
[body]
shape = { difference = [{ box = [[0.0, 0.0], [2.0, 2.0]] }, { disc = { centre = [1.0, 1.0], radius = 0.4 } }] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
traction = { curve = "smooth-ramp", amplitude = 1e2, rise = 0.1 }
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = 1e2, rise = 0.1 }
[time]
end = 0.1
[[probe]]
name = "edge"
at = [2.0, 1.0]
record = ["displacement", "pk1"]
)";

class Fit : public StudyFolder {
 protected:
  FitRequest request(const std::string& scene, double error) const {
    return {write("scene.toml", scene), {}, error, "", std::nullopt};
  }
  FitTable run(const FitRequest& asked) const {
    FitOptions options;
    options.out = folder / "study";
    return fit(asked, options);
  }
};

class FitToAnError : public Fit, public testing::WithParamInterface<double> {};

TEST_P(FitToAnError, MeetsItAndIsNotMuchBetter) {
  const FitTable table = run(request(pushed_bar + with_exact, GetParam()));

  EXPECT_TRUE(table.meets());
  EXPECT_THAT(table.measured_error, AllOf(Le(GetParam()), Ge(GetParam() / 5.0)));
  EXPECT_THAT(table.predicted_error, AllOf(Le(GetParam()), Ge(GetParam() / 5.0)));
  // The file that was written is the scene that was measured.
  const Summary summary = tlsph::run(read_scene(folder / "study/scene.toml"), {});
  EXPECT_EQ(
      std::max({summary.errors->displacement, summary.errors->velocity, summary.errors->stress}),
      table.measured_error);
  EXPECT_EQ(summary.particles, table.particles);
}

INSTANTIATE_TEST_SUITE_P(Errors, FitToAnError, testing::Values(1e-1, 3e-2, 1e-2, 3e-3, 1e-3));

TEST_F(Fit, OfAFieldLooksAtThatAlone) {
  FitRequest asked = request(pushed_bar + with_exact, 1e-2);
  asked.quantity = "displacement";

  const FitTable table = run(asked);

  const Summary summary = tlsph::run(read_scene(folder / "study/scene.toml"), {});
  EXPECT_EQ(table.measured_error, summary.errors->displacement);
  EXPECT_GT(summary.errors->velocity, table.measured_error);
}

TEST_F(Fit, OfAnAnswerThatIsWrongMisses) {
  FitRequest asked = request(pushed_bar + tip, 1e-2);
  asked.value = ChartValue{"tip.displacement_x.max", 1.0};

  const FitTable table = run(asked);

  EXPECT_FALSE(table.meets());
  EXPECT_FALSE(table.reached);
  EXPECT_GT(table.measured_error, 0.5);
  EXPECT_THAT(table.choice_text(), HasSubstr("no way is known to reach it"));
  EXPECT_THAT(table.verdict_text(), HasSubstr("misses 0.01"));
}

TEST_F(Fit, ModelsAQuarterOfAPlateThatIsItsOwnImageTwice) {
  FitRequest asked = request(pulled_plate, 5e-2);
  asked.value = ChartValue{"edge.displacement_x.end", std::nullopt};

  const FitTable table = run(asked);

  EXPECT_THAT(table.reductions, ElementsAre(HasSubstr("x = 1 m"), HasSubstr("y = 1 m")));
  EXPECT_TRUE(table.meets());
  EXPECT_TRUE(table.linear);  // strains of 1e-4
  const Scene scene = read_scene(folder / "study/scene.toml");
  EXPECT_EQ(scene.materials.front().law, LawName::linear_elastic);
  EXPECT_EQ(scene.output.frames, 0);
  ASSERT_EQ(scene.probes.size(), 1U);
  EXPECT_THAT(scene.probes.front().record, ElementsAre("displacement"));
}

TEST_F(Fit, WritesItsPilots) {
  const FitTable table = run(request(pushed_bar + with_exact, 3e-2));

  const Json json = Json::read(folder / "study/fit.json");
  EXPECT_EQ(json.number("measured_error"), table.measured_error);
  EXPECT_EQ(json.text("family"), table.family);
  EXPECT_EQ(json.list("families").size(), table.families.size());
  const std::string csv = read(folder / "study/fit.csv");
  std::size_t pilots = 0;
  for (const FitFamily& family : table.families) pilots += family.pilots.size();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), pilots + 1);
}

TEST_F(Fit, RefusesWhatIsNoFitBeforeItWritesAnything) {
  const auto refused = [&](FitRequest asked, const char* words) {
    EXPECT_THAT([&] { (void)run(asked); }, ThrowsMessage<InputError>(HasSubstr(words)));
  };
  const FitRequest good = request(pushed_bar + with_exact + tip, 1e-2);
  for (const double error : {0.0, -1.0, 1.0, std::nan("")}) {
    FitRequest asked = good;
    asked.error = error;
    refused(asked, "--error");
  }
  FitRequest asked = good;
  asked.quantity = "pressure";
  refused(asked, "choose from displacement, velocity, stress");
  asked.quantity = "stress";
  asked.value = ChartValue{"tip.displacement_x.max", 1.0};
  refused(asked, "goes without --value");
  asked.quantity = "";
  asked.value = ChartValue{"toe.displacement_x.max", 1.0};
  refused(asked, "no probe records");
  asked.value = ChartValue{"tip.displacement_z.max", 1.0};
  refused(asked, "choose from tip.displacement_x");
  refused(request(pushed_bar + tip, 1e-2), "--value");
  asked = request(pushed_bar + tip, 1e-2);
  asked.quantity = "stress";
  refused(asked, "reference.exact");
  EXPECT_FALSE(std::filesystem::exists(folder / "study"));
}

}  // namespace
}  // namespace tlsph
