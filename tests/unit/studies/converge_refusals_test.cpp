/// What is no convergence study is refused before anything runs.
#include <gmock/gmock.h>

#include <cmath>

#include "converge_study.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class ConvergeRefuses : public Converge {};

struct Refusal {
  std::string scene;
  std::vector<double> spacings;
  std::vector<std::string> formulations;
  std::string message;
};

TEST_F(ConvergeRefuses, WhatIsNoStudy) {
  const std::string exact = pushed_bar + with_exact;
  for (const Refusal& refusal : std::vector<Refusal>{
           {exact, {}, {}, "--spacing: 0 given; at least 2"},
           {exact, {0.1}, {}, "--spacing: 1 given; at least 2"},
           {pushed_bar + with_probes, {0.1, 0.05}, {}, "--spacing: 2 given; at least 3"},
           {pushed_bar, {0.1, 0.05, 0.025}, {}, "nothing to compare"},
           {exact, {0.1, 0.05, 0.1}, {}, "--spacing: 0.1 stands twice"},
           {exact, {0.1, 0.0}, {}, "--spacing: 0 is no spacing"},
           {exact, {0.1, -0.1}, {}, "--spacing: -0.1 is no spacing"},
           {exact, {0.1, std::nan("")}, {}, "is no spacing"},
           {exact, {0.1, 0.05, 0.0502}, {}, "divides the body like"},
           {exact, {0.1, 0.03}, {}, "spacing"},
           {exact, {0.1, 0.05}, {"mirror", "mirror"}, "--formulation: mirror stands twice"},
           {exact, {0.1, 0.05}, {"mirrors"}, "--formulation: there is no \"mirrors\""},
           {pushed_bar + "[[probe]]\nat = [2.0]\n", {0.1, 0.05, 0.025}, {}, "probe"}}) {
    EXPECT_THAT([&] { (void)study(refusal.scene, refusal.spacings, refusal.formulations); },
                ThrowsMessage<InputError>(HasSubstr(refusal.message)));
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << refusal.message;
  }
}

TEST_F(ConvergeRefuses, VariationsThatAreNone) {
  const ConvergenceRequest sound = request(pushed_bar + with_exact, {0.1, 0.05});
  const auto refuses = [&](auto change, const std::string& message) {
    ConvergenceRequest unsound = sound;
    change(unsound);
    EXPECT_THAT([&] { (void)converge(unsound, {}); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };

  refuses([](auto& r) { r.over = {{"body.spacing", {"1", "2"}}}; }, "has an option, --spacing");
  refuses([](auto& r) { r.over = {{"body.seed", {"1", "2"}}}; }, "has an option, --seed");
  refuses([](auto& r) { r.over = {{"no.such", {"1"}}}; }, "no");
  refuses([](auto& r) { r.over = {{"kernel.support", {"2", "0"}}}; }, "support");
  refuses([](auto& r) { r.over = {{"a", {"1"}}, {"a", {"1"}}}; }, "stands twice");
  refuses([](auto& r) { r.over = {{"reference.exact", {"none", "bar-wave"}}}; }, "nothing to");
  refuses([](auto& r) { r.seeds = {1, 2}; }, "--seed: the particles do not depend on it");
  refuses([](auto& r) { r.seeds = {1, 1}; }, "--seed: 1 stands twice");
  refuses([](auto& r) { r.clouds = {"a.csv", "b.csv"}; }, "--cloud: a cloud has its spacing");
  refuses([](auto& r) { r.values = {"tip.displacement_x.mean"}; }, "--value: ");
  refuses([](auto& r) { r.values = {"tip.displacement_x.end"}; }, "no probe records");
}

}  // namespace
}  // namespace tlsph
