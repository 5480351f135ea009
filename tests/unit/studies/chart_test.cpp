#include "tlsph/studies/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "read_history.hpp"
#include "study_folder.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::Optional;
using testing::StartsWith;
using testing::ThrowsMessage;

std::string replaced(std::string text, const std::string& part, const std::string& with) {
  return text.replace(text.find(part), part.size(), with);
}

/// The same of a nonlinear law, gently.
const std::string gently_pushed_bar =
    replaced(replaced(pushed_bar, "linear-elastic", "neo-hookean"), "amplitude = 1e3",
             "amplitude = 10") +
    with_exact;

class Chart : public StudyFolder {
 protected:
  ChartRequest request(const std::string& scene) const {
    ChartRequest request;
    request.scene = write("scene.toml", scene);
    request.budget = 10.0;
    request.spacings = {0.1, 0.05, 0.025};
    return request;
  }
  ChartTable run(const ChartRequest& asked) const {
    ChartOptions options;
    options.out = folder / "out";
    return chart(asked, options);
  }
};

TEST_F(Chart, OfAnExactSolutionMeasuresWhatRunsMeasure) {
  ChartRequest asked = request(pushed_bar + with_exact);
  asked.formulations = {"stress-point", "mirror"};

  const ChartTable table = run(asked);

  EXPECT_THAT(table.quantities, ElementsAre("displacement", "velocity", "stress"));
  std::set<std::string> families;
  for (const ChartPoint& point : table.points) {
    ASSERT_EQ(point.failure, "");
    families.insert(point.family);
    EXPECT_GT(point.time(), 0.0);
    EXPECT_GE(point.seconds.size(), 1U);
  }
  EXPECT_GE(families.size(), 20U);
  EXPECT_THAT(families, Contains("stress-point"));
  EXPECT_THAT(families, Contains("mirror 1.5 lucy"));
  const ChartPoint& point = table.points.back();
  const Summary summary = tlsph::run(read_scene(asked.scene, point.overrides), {});
  EXPECT_EQ(point.particles, summary.particles);
  EXPECT_EQ(point.steps, summary.steps);
  EXPECT_EQ(point.errors[0], summary.errors->displacement);
  EXPECT_EQ(point.errors[2], summary.errors->stress);
}

TEST_F(Chart, FrontOfFieldsIsThatOfItsPoints) {
  const ChartTable table = run(request(pushed_bar + with_exact));

  for (std::size_t q = 0; q < table.quantities.size(); ++q) {
    std::vector<double> times;
    std::vector<double> errors;
    std::vector<bool> marked;
    for (const ChartPoint& point : table.points) {
      times.push_back(point.time());
      errors.push_back(point.failure.empty() ? point.errors[q] : std::nan(""));
      marked.push_back(point.front[q]);
    }
    EXPECT_EQ(marked, pareto_front(times, errors));
    EXPECT_THAT(marked, Contains(true));
  }
}

TEST_F(Chart, RefinesWhatIsOnTheFrontAndLeavesTheRestBehind) {
  const ChartTable table = run(request(pushed_bar + with_exact));

  // Which family wins on a body of eleven particles is a matter of microseconds.
  std::map<std::string, int> refined;
  for (const ChartPoint& point : table.points) ++refined[point.family];
  int most = 0;
  for (const auto& [family, times] : refined) most = std::max(most, times);
  EXPECT_EQ(most, 3);
  EXPECT_GT(table.dominated, 50);
  EXPECT_EQ(table.points.front().family, "stress-point");  // the defaults come first
}

TEST_F(Chart, GivesTheBestOtherStepsAndALinearLaw) {
  const ChartRequest asked = request(gently_pushed_bar);

  const ChartTable table = run(asked);

  std::set<std::string> families;
  for (const ChartPoint& point : table.points) {
    families.insert(point.family);
    const bool linear = point.family.find(" linear") != std::string::npos;
    const auto step = point.family.find(" step ");
    const double share = step == std::string::npos ? 0.9 : std::stod(point.family.substr(step + 6));
    EXPECT_EQ(point.law, linear ? "linear-elastic" : "neo-hookean") << point.family;
    EXPECT_THAT(point.step_share, Optional(DoubleEq(share))) << point.family;
    EXPECT_EQ(std::ranges::count(point.overrides, "material.law=linear-elastic"), linear ? 1 : 0);
  }
  EXPECT_GT(table.variants, 0);
  EXPECT_LT(table.variants, table.families);  // of the best alone
  EXPECT_THAT(families, IsSupersetOf({"stress-point step 0.99", "stress-point linear",
                                      "stress-point linear step 0.99"}));
}

// Errors of time and space cancel next to the critical step: in 1D, between two nodes, nearly all.
TEST_F(Chart, FindsThatErrorsCancelNextToTheCriticalStep) {
  ChartRequest asked = request(gently_pushed_bar);
  asked.formulations = {"stress-point"};
  asked.spacings = {0.025};

  const ChartTable table = run(asked);

  std::map<double, double> velocity;  // least error by share of the step
  for (const ChartPoint& point : table.points) {
    const auto [at, fresh] = velocity.try_emplace(point.step_share.value(), point.errors[1]);
    at->second = std::min(at->second, point.errors[1]);
  }
  EXPECT_LT(velocity.at(0.99), 0.3 * velocity.at(0.9));
}

TEST_F(Chart, StepsAsTheSceneSaysWhereItDoes) {
  const ChartTable table = run(request(pushed_bar + "step = 1e-4\n" + with_exact));

  for (const ChartPoint& point : table.points) {
    EXPECT_THAT(point.family, Not(HasSubstr(" step "))) << point.family;
    EXPECT_EQ(point.step_share, std::nullopt);
  }
  EXPECT_EQ(table.variants, 0);  // the law is linear already
}

// The limit of formulations whose D is not the adjoint of G is no promise.
TEST_F(Chart, LengthensNoStepWithoutAdjoint) {
  ChartRequest asked = request(gently_pushed_bar);
  asked.formulations = {"mirror", "thesis"};

  const ChartTable table = run(asked);

  std::set<std::string> shorter;
  for (const ChartPoint& point : table.points) {
    EXPECT_LE(point.step_share, 0.9) << point.family;
    if (point.step_share < 0.9) shorter.insert(point.family);
  }
  EXPECT_GT(shorter.size(), 0U);
}

TEST_F(Chart, KeepsItsBudget) {
  ChartRequest asked = request(pushed_bar + with_exact);
  asked.spacings = {0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003125, 0.0015625};
  asked.budget = 1.0;
  const auto start = std::chrono::steady_clock::now();

  const ChartTable table = run(asked);

  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_LT(passed.count(), 3.0);  // a set-up is not interrupted
  EXPECT_GT(table.spent, 0.0);
  EXPECT_GT(table.points.size(), 10U);
}

TEST_F(Chart, HoldsAValueAgainstItsAnswer) {
  const std::string tip = "[[probe]]\nname = \"tip\"\nat = [1.0]\nrecord = [\"displacement\"]\n";
  ChartRequest asked = request(pushed_bar + tip);
  asked.formulations = {"stress-point"};
  asked.values = {{"tip.displacement_x.end", 1e-3}};

  const ChartTable table = run(asked);

  EXPECT_THAT(table.quantities, ElementsAre("tip.displacement_x.end"));
  EXPECT_THAT(table.answers, ElementsAre(1e-3));
  const ChartPoint& point = table.points.front();
  RunOptions options;
  options.out = folder / "one";
  (void)tlsph::run(read_scene(asked.scene, point.overrides), options);
  const History history = test::read_history(options.out / "probes.csv");
  EXPECT_NEAR(point.errors[0], std::abs(history.values[0].back() / 1e-3 - 1.0), 1e-12);
}

// Three spacings of the scene tell what the value tends to; the exact solution knows it.
TEST_F(Chart, ExtrapolatesAnAnswerNobodyGave) {
  const std::string middle =
      "[[probe]]\nname = \"middle\"\nat = [0.5]\nrecord = [\"displacement\"]\n";
  RunOptions options;
  options.out = folder / "exact";
  (void)tlsph::run(
      read_scene(write("exact.toml", pushed_bar + middle + with_exact), {"body.spacing=0.0125"}),
      options);
  const double truth = test::read_history(options.out / "probes_exact.csv").values[0].back();
  const double finest = test::read_history(options.out / "probes.csv").values[0].back();
  ChartRequest asked = request(pushed_bar + middle);
  asked.overrides = {"body.spacing=0.025"};
  asked.formulations = {"stress-point"};
  asked.values = {{"middle.displacement_x.end", std::nullopt}};

  const ChartTable table = run(asked);

  EXPECT_LT(std::abs(table.answers[0] / truth - 1.0), 0.2 * std::abs(finest / truth - 1.0));
}

TEST_F(Chart, WritesWhatItReturns) {
  ChartRequest asked = request(pushed_bar + with_exact);
  asked.formulations = {"stress-point"};

  const ChartTable table = run(asked);

  EXPECT_THAT(read(folder / "out/chart.csv"),
              StartsWith("peer,family,formulation,kernel,support,order,stabiliser,law,step_share,"
                         "spacing,"));
  const Json json = Json::read(folder / "out/chart.json");
  const auto points = json.list("points");
  ASSERT_EQ(points.size(), table.points.size());
  EXPECT_EQ(points[3].numbers("errors"), table.points[3].errors);
  EXPECT_EQ(points[3].numbers("stepping_seconds"), table.points[3].seconds);
  EXPECT_EQ(points[3].text("law"), "linear-elastic");
  EXPECT_EQ(points[3].number("step_share"), table.points[3].step_share);
  EXPECT_EQ(json.integer("variants"), table.variants);
  EXPECT_THAT(table.text(), HasSubstr("configuration"));
  EXPECT_THAT(table.text(), HasSubstr("\nstress\n"));
}

TEST_F(Chart, RefusesWhatIsNone) {
  const auto refuses = [&](const std::string& scene, auto change, const std::string& message) {
    ChartRequest unsound = request(scene);
    change(unsound);
    EXPECT_THAT([&] { (void)run(unsound); }, ThrowsMessage<InputError>(HasSubstr(message)));
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << message;
  };
  const std::string exact = pushed_bar + with_exact;
  const std::string probes = pushed_bar + with_probes;

  refuses(
      pushed_bar, [](auto&) {}, "nothing to be near to");
  refuses(
      probes, [](auto&) {}, "--value NAME=ANSWER");
  refuses(
      probes,
      [](auto& r) {
        r.values = {{"top.pk1_xx.end", 1.0}};
      },
      "no probe records");
  refuses(
      probes,
      [](auto& r) {
        r.values = {{"tip.displacement.end", 1.0}};
      },
      "no probe records");
  refuses(
      exact, [](auto& r) { r.budget = 0.0; }, "--budget: 0 s is no time");
  refuses(
      exact, [](auto& r) { r.formulations = {"fem"}; }, "--formulation: there is no");
  refuses(
      exact,
      [](auto& r) {
        r.spacings = {0.1, 0.1};
      },
      "--spacing: 0.1 stands twice");
  refuses(
      exact,
      [](auto& r) {
        r.spacings = {0.1, 0.07};
      },
      "spacing");
  refuses(
      exact, [](auto& r) { r.peers = {"nastran"}; }, "--peer: there is no \"nastran\"");
  refuses(
      exact, [](auto& r) { r.overrides = {"kernel.suport=2"}; }, "kernel.suport");
}

}  // namespace
}  // namespace tlsph
