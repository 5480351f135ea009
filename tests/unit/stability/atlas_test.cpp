/// The atlas of a small sheet and a small bar: what must fail fails, for the reason it must, and
/// nothing else.
#include "tlsph/stability/atlas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

const std::filesystem::path scenes =
    std::filesystem::path(TLSPH_SOURCE_DIR) / "validation/stability";

Atlas atlas_of(const char* scene, const std::string& only) {
  // A body of a few particles: the laws do not depend on its size.
  const std::string spacing =
      std::string(scene) == "bar.toml" ? "body.spacing=7.5e-3" : "body.spacing=0.02";
  return draw_atlas({scenes / scene, {spacing}, only}, {});
}

const AtlasRow& row_of(const Atlas& atlas, const std::string& name) {
  for (const AtlasRow& row : atlas.rows)
    if (row.name == name) return row;
  throw std::out_of_range(name);
}

const PerturbedRun& run_of(const AtlasRow& row, const std::string& label) {
  for (const PerturbedRun& run : row.runs)
    if (run.label == label) return run;
  throw std::out_of_range(label);
}

struct Expected {
  const char* scene;
  const char* name;
  Verdict verdict;
};
class Verdicts : public testing::TestWithParam<Expected> {};

TEST_P(Verdicts, AreConfirmedByRuns) {
  const auto& [scene, name, verdict] = GetParam();
  std::string only = "^";
  for (const char* c = name; *c != '\0'; ++c)
    only += std::isalnum(*c) != 0 || *c == ' ' ? std::string(1, *c) : std::string("\\") + *c;
  const Atlas atlas = atlas_of(scene, only + "$");

  ASSERT_EQ(atlas.rows.size(), 1U);
  const AtlasRow& row = atlas.rows.front();
  EXPECT_EQ(row.verdict, verdict);
  const PerturbedRun& below = run_of(row, "0.95");
  const PerturbedRun& above = run_of(row, "1.02");
  EXPECT_EQ(below.bounded(), verdict == Verdict::stable || verdict == Verdict::zero_energy);
  EXPECT_FALSE(above.bounded());
  if (!below.bounded()) {
    // Other modes grow nearly as fast, and a run starts with all of them: it is the slower for it.
    EXPECT_GT(below.seen, 0.9 * below.expected);
    EXPECT_LT(below.seen, 1.01 * below.expected);
  }
  EXPECT_EQ(row.acoustic <= 0.0, verdict == Verdict::material);
  EXPECT_EQ(row.excursion > 1.4, verdict == Verdict::zero_energy);
  EXPECT_EQ(atlas.failures.empty(), false);  // the step beyond the limit is one at least
  if (verdict == Verdict::material) return;  // nothing bounds the step but what grows
  EXPECT_GE(row.bound, 0.99 * row.limit);
  EXPECT_LE(row.bound, 1.005 * row.limit);
}
INSTANTIATE_TEST_SUITE_P(
    States, Verdicts,
    testing::Values(
        Expected{"sheet.toml", "stress-point cells + S, jitter 0.4, nu 0.4999, stretch 0.2",
                 Verdict::stable},
        Expected{"sheet.toml", "stress-point cells, lattice, nu 0.3, stretch 1",
                 Verdict::zero_energy},
        Expected{"sheet.toml", "variational 2.5 + S, lattice, nu 0.3, stretch 1", Verdict::stable},
        Expected{"sheet.toml", "variational 2.5 + S, jitter 0.4, nu 0.3, stretch 0.2",
                 Verdict::negative},
        Expected{"sheet.toml", "stress-point cells + S, lattice, nu 0.49, stretch 4",
                 Verdict::material},
        Expected{"bar.toml", "stress-point, lattice, nu 0.48, stretch 4", Verdict::stable},
        Expected{"bar.toml", "stress-point, lattice, nu 0.49, stretch 4", Verdict::material},
        Expected{"bar.toml", "variational 5.5, lattice, nu 0.3, stretch 1", Verdict::zero_energy},
        Expected{"bar.toml", "mirror 2.5, lattice, nu 0.3, stretch 2", Verdict::stable}));

TEST(Atlas, SetsBesideAFailureTheRowThatCuresIt) {
  const Atlas atlas =
      atlas_of("sheet.toml", "^stress-point cells( \\+ S)?, lattice, nu 0.3, stretch 1$");

  ASSERT_FALSE(atlas.failures.empty());
  const Failure& soft = atlas.failures.front();
  EXPECT_THAT(soft.what, HasSubstr("without energy"));
  EXPECT_THAT(soft.run, HasSubstr("3 modes"));
  EXPECT_THAT(soft.cured_run, HasSubstr("stress-point cells + S"));
  EXPECT_EQ(soft.states, 1);
}

TEST(Atlas, ALawLostAtEveryPoissonRatioIsCuredByTheNearestStretch) {
  const Atlas atlas =
      draw_atlas({scenes / "sheet.toml",
                  {"body.spacing=0.02", "material.law=st-venant-kirchhoff"},
                  "^stress-point cells \\+ S, lattice, nu 0\\.(3|49), stretch (0\\.5|1|1\\.5)$"},
                 {});

  ASSERT_FALSE(atlas.failures.empty());
  EXPECT_THAT(atlas.failures.front().why, HasSubstr("hyperbolicity"));
  EXPECT_THAT(atlas.failures.front().run, HasSubstr("stretch 0.5:"));
  EXPECT_THAT(atlas.failures.front().cured_run, HasSubstr("stretch 1:"));
}

TEST(Atlas, GrowthAtAnyStepIsThatOfPairsThatAreNoAdjoint) {
  // The ghosts of the thesis need a bar longer than twice their reach.
  const Atlas atlas = draw_atlas(
      {scenes / "bar.toml", {}, "^(thesis consistent|mirror) 5\\.5, lattice, nu 0\\.3, stretch 2$"},
      {});

  const AtlasRow& thesis = row_of(atlas, "thesis consistent 5.5, lattice, nu 0.3, stretch 2");
  EXPECT_EQ(thesis.verdict, Verdict::growing);
  EXPECT_NEAR(run_of(thesis, "0.95").seen / run_of(thesis, "0.95").expected, 1.0, 0.05);
  EXPECT_EQ(row_of(atlas, "mirror 5.5, lattice, nu 0.3, stretch 2").verdict, Verdict::stable);
}

TEST(Atlas, TheCounterExampleGrowsInTensionAtTheRateOfItsSums) {
  const Atlas atlas = atlas_of("bar.toml", "^updated Lagrangian");

  ASSERT_EQ(atlas.contrast.size(), 4U);
  for (const ContrastRow& row : atlas.contrast) {
    EXPECT_EQ(row.seen > 0.0, row.stress > 0.0) << row.stress;
    if (row.stress > 0.0) {
      EXPECT_NEAR(row.seen, row.expected, 0.03 * row.expected) << row.stress;
    }
  }
}

TEST(Atlas, WavesOfABarAreTheClosedForms) {
  const Atlas atlas = atlas_of("bar.toml", "^waves of (stress-point|variational 1.5)$");

  ASSERT_EQ(atlas.waves.size(), 2U);
  for (const WaveRow& row : atlas.waves)
    for (const std::vector<double>& line : row.map) {
      const double theta = line[0];
      const double closed = row.method == "stress-point" ? std::sin(theta / 2) / (theta / 2)
                                                         : std::abs(std::sin(theta)) / theta;
      EXPECT_NEAR(line[1], closed, 1e-7) << row.method << ' ' << theta;
    }
}

TEST(Atlas, FollowedStepsReachTheEndOfACompression) {
  const Atlas atlas = atlas_of("sheet.toml", "^crush of (stress-point cells|variational)");

  ASSERT_GT(atlas.compression.size(), 10U);
  for (const CompressionRow& row : atlas.compression)
    if (row.step == "followed") {
      EXPECT_EQ(row.failure, "") << row.method << ' ' << row.motion << ' ' << row.speed;
      EXPECT_LE(row.closest, 0.98) << row.method << ' ' << row.motion << ' ' << row.speed;
    }
}

TEST(Atlas, TellsAMethodThatIsNotForTheBodyFromOneThatFails) {
  const Atlas atlas =
      draw_atlas({scenes / "sheet.toml",
                  {"body.shape={disc={centre=[0.0, 0.0], radius=0.1}}", "body.spacing=0.02"},
                  "^mirror 2\\.5, lattice, nu 0\\.3, stretch 1$"},
                 {});

  ASSERT_EQ(atlas.rows.size(), 1U);
  EXPECT_EQ(atlas.rows.front().verdict, Verdict::refused);
  ASSERT_EQ(atlas.failures.size(), 1U);
  EXPECT_THAT(atlas.failures.front().what, HasSubstr("not made for this body"));
  EXPECT_THAT(atlas.failures.front().run, HasSubstr("must be an interval or a box"));
}

TEST(Atlas, RefusesWhatItCannotDraw) {
  EXPECT_THROW((void)atlas_of("sheet.toml", "("), InputError);
  EXPECT_THROW((void)atlas_of("sheet.toml", "^no such row$"), InputError);
  EXPECT_THROW((void)draw_atlas({scenes / "missing.toml", {}, ""}, {}), InputError);
  const auto cloud = std::filesystem::path(TLSPH_SOURCE_DIR) / "examples/pressure_ring.toml";
  EXPECT_THAT(
      [&] {
        (void)draw_atlas({cloud, {}, ""}, {});
      },
      testing::ThrowsMessage<InputError>(HasSubstr("leave the cloud out")));
}

}  // namespace
}  // namespace tlsph
