/// The machinery of validation: verdicts, cases in processes of their own, the table they end in.

#include "tlsph/studies/validation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <limits>
#include <thread>

#include "study_folder.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/json.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Check, HoldsWithinItsTolerance) {
  EXPECT_TRUE((Check{"", "", Criterion::relative, -2.0, -2.02, 0.011}).holds());
  EXPECT_FALSE((Check{"", "", Criterion::relative, -2.0, -2.03, 0.011}).holds());
  EXPECT_TRUE((Check{"", "", Criterion::absolute, 1.0, 1.09, 0.1}).holds());
  EXPECT_FALSE((Check{"", "", Criterion::absolute, 1.0, 1.11, 0.1}).holds());
  EXPECT_TRUE((Check{"", "", Criterion::at_most, 1.0, 1.0, 0.0}).holds());
  EXPECT_FALSE((Check{"", "", Criterion::at_most, 1.0, 1.1, 0.0}).holds());
  EXPECT_TRUE((Check{"", "", Criterion::at_least, 1.0, 1.1, 0.0}).holds());
  EXPECT_FALSE((Check{"", "", Criterion::at_least, 1.0, 0.9, 0.0}).holds());
  EXPECT_TRUE((Check{"", "", Criterion::reported, nan, 3.0, 0.0}).holds());
}

TEST(Check, NeverHoldsForWhatIsNotANumber) {
  for (const Criterion criterion : {Criterion::relative, Criterion::absolute, Criterion::at_most,
                                    Criterion::at_least, Criterion::reported})
    EXPECT_FALSE((Check{"", "", criterion, 1.0, nan, 1.0}).holds());
}

void two_hold(CaseRun& run) {
  run.check("a source, Fig. 1", "speed [m/s]", 5800.0, relative(5801.0, 1e-3));
  run.check("a source, Fig. 2", "growth | rate", 0.5, reported(0.6));
  run.table("numbers", {{"time", std::vector{0.0, 1.0}}, {"value", std::vector{2.0, 3.0}}});
}
void one_fails(CaseRun& run) {
  run.check("a source", "error", 2e-3, at_most(1e-3));
  run.check("a source", "order", 2.0, at_least(1.9));
}
void throws(CaseRun& run) {
  run.check("a source", "seen before", 0.0, at_most(1.0));
  throw InputError("no such scene");
}
void crashes(CaseRun&) {
  std::signal(SIGSEGV, SIG_DFL);
  std::raise(SIGSEGV);
}
void says_nothing(CaseRun&) {}
void runs_a_scene(CaseRun& run) {
  const CaseScene scene = run.scene("run", "bar.toml", {"body.spacing=0.05"});
  run.check("", "particles", static_cast<double>(scene.summary.particles), absolute(21.0, 0.0));
  run.check("", "rows", static_cast<double>(scene.probe("tip.displacement_x").size()),
            absolute(static_cast<double>(scene.summary.steps + 1), 0.0));
  const CaseScene lost =
      run.scene("lost", "bar.toml",
                {"time.step=5e-3", "time.allow_unstable=true", "time.end=1e4", "output.frames=0"});
  run.check("", "time of the failure", lost.failed_at.value_or(nan), at_least(0.0));
}
void sleeps(CaseRun& run) {
  std::this_thread::sleep_for(std::chrono::seconds(20));
  run.check("", "awake", 1.0, reported());
}

class Validating : public StudyFolder {
 protected:
  void SetUp() override {
    StudyFolder::SetUp();
    std::filesystem::create_directories(folder / "cases/scene");
    write("cases/plot.py", "");
    write("cases/scene/bar.toml", pushed_bar + with_probes);
    setenv("TLSPH_VALIDATION", (folder / "cases").c_str(), 1);
  }
  void TearDown() override {
    unsetenv("TLSPH_VALIDATION");
    StudyFolder::TearDown();
  }
  [[nodiscard]] ValidationOptions options() const {
    ValidationOptions chosen;
    chosen.out = folder / "out";
    chosen.at_once = 2;
    chosen.figures = false;
    return chosen;
  }
};

TEST_F(Validating, ListsEveryCaseInItsOrderWhateverEndsFirst) {
  constexpr std::array cases = {Case{"good", "a good one", 1.0, true, two_hold},
                                Case{"bad", "a bad one", 5.0, true, one_fails},
                                Case{"broken", "a broken one", 3.0, true, throws}};
  std::vector<std::string> ended;
  ValidationOptions chosen = options();
  chosen.after_case = [&](const CaseResult& result, double) { ended.push_back(result.name); };

  const ValidationTable table = validate(cases, chosen);

  ASSERT_EQ(table.cases.size(), 3U);
  EXPECT_THAT(ended, testing::UnorderedElementsAre("good", "bad", "broken"));
  EXPECT_EQ(table.cases[0].name, "good");
  EXPECT_TRUE(table.cases[0].holds());
  EXPECT_EQ(table.cases[1].name, "bad");
  EXPECT_FALSE(table.cases[1].holds());
  EXPECT_FALSE(table.cases[2].holds());
  EXPECT_EQ(table.cases[2].failure, "no such scene");
  EXPECT_EQ(table.cases[2].checks.size(), 1U) << "what was seen before counts";
  EXPECT_FALSE(table.holds());
  EXPECT_EQ(read(folder / "out/good/numbers.csv"), "time,value\n0,2\n1,3\n");
}

TEST_F(Validating, SurvivesACaseThatCrashes) {
  constexpr std::array cases = {Case{"crash", "", 1.0, true, crashes},
                                Case{"good", "", 1.0, true, two_hold}};

  const ValidationTable table = validate(cases, options());

  ASSERT_EQ(table.cases.size(), 2U);
  EXPECT_THAT(table.cases[0].failure, HasSubstr("signal 11"));
  EXPECT_TRUE(table.cases[1].holds());
}

TEST_F(Validating, CountsACaseWithoutChecksAsFailed) {
  constexpr std::array cases = {Case{"empty", "", 1.0, true, says_nothing}};

  EXPECT_FALSE(validate(cases, options()).holds());
}

TEST_F(Validating, RunsScenesAndKeepsTheirFailures) {
  constexpr std::array cases = {Case{"scene", "", 1.0, true, runs_a_scene}};

  const ValidationTable table = validate(cases, options());

  ASSERT_EQ(table.cases.size(), 1U);
  EXPECT_EQ(table.cases[0].failure, "");
  EXPECT_TRUE(table.holds()) << table.text();
}

TEST_F(Validating, ChoosesCasesByNameAndSpeed) {
  constexpr std::array cases = {Case{"fast", "", 1.0, true, two_hold},
                                Case{"slow", "", 9.0, false, two_hold}};
  ValidationOptions quick = options();
  quick.quick = true;
  ValidationOptions named = options();
  named.only = {"slow"};
  ValidationOptions neither = named;
  neither.quick = true;
  ValidationOptions unknown = options();
  unknown.only = {"slwo"};

  const ValidationTable fast = validate(cases, quick);
  const ValidationTable slow = validate(cases, named);

  ASSERT_EQ(fast.cases.size(), 1U);
  EXPECT_EQ(fast.cases[0].name, "fast");
  ASSERT_EQ(slow.cases.size(), 1U);
  EXPECT_EQ(slow.cases[0].name, "slow");
  EXPECT_THROW(static_cast<void>(validate(cases, neither)), InputError);
  EXPECT_THROW(static_cast<void>(validate(cases, unknown)), InputError);
}

TEST_F(Validating, StopsWhenAsked) {
  constexpr std::array cases = {Case{"sleeper", "", 1.0, true, sleeps}};
  std::atomic<bool> stop{false};
  ValidationOptions chosen = options();
  chosen.stop_requested = &stop;
  chosen.progress = [&](const std::string& what, double) {
    EXPECT_EQ(what, "running sleeper");
    stop = true;
  };

  const ValidationTable table = validate(cases, chosen);

  EXPECT_TRUE(table.interrupted);
  EXPECT_FALSE(table.holds());
  EXPECT_TRUE(table.cases.empty());
}

TEST_F(Validating, WritesTheSameVerdictsAsTextPageAndJson) {
  constexpr std::array cases = {Case{"good", "a good one", 1.0, true, two_hold},
                                Case{"bad", "a bad one", 1.0, true, one_fails}};

  const ValidationTable table = validate(cases, options());

  const std::string text = table.text();
  EXPECT_THAT(text, HasSubstr("2 cases, 3 checks, 2 hold; 1 more numbers reported"));
  const std::string page = read(folder / "out/validation.md");
  EXPECT_EQ(page, table.markdown());
  EXPECT_THAT(page, HasSubstr("| [good](good) | a source, Fig. 1 | speed [m/s] | 5801 | 5800 | "
                              "0.1 % | holds |\n"));
  EXPECT_THAT(page,
              HasSubstr("|  | a source, Fig. 2 | growth \\| rate | 0.6 | 0.5 |  | (reported) |"));
  EXPECT_THAT(page, HasSubstr("| [bad](bad) | a source | error | ≤ 0.001 | 0.002 |  | FAILS |"));
  const Json json = Json::read(folder / "out/validation.json");
  const auto rows = json.list("cases");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].text("case"), "good");
  EXPECT_EQ(rows[0].list("checks")[0].number("observed"), 5800.0);
  EXPECT_TRUE(rows[0].is_null("failure") || rows[0].text("failure").empty());
}

}  // namespace
}  // namespace tlsph
