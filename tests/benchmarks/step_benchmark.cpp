/// What products, laws and whole steps cost, by Google Benchmark: counters are nanoseconds per
/// particle. `tlsph benchmark` sets the same steps beside the limits of the machine.
///
///     build/release/tests/step_benchmark --benchmark_filter=Sweep

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "tlsph/model/builder.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/studies/plain_step.hpp"
#include "tlsph/sweep/sweep.hpp"

namespace tlsph {
namespace {

/// What a benchmark varies: operators, storage and law.
struct Body {
  const char* name;
  const char* formulation;
  double support;
  double jitter;
  const char* law;
  const char* assumption = "strain";
  const char* stabiliser = "";  ///< empty: the scene's own
};

constexpr std::array bodies = {
    Body{"stress-point", "stress-point", 0.0, 0.0, "neo-hookean"},
    Body{"stress-point/irregular", "stress-point", 0.0, 0.2, "neo-hookean"},
    Body{"stress-point/linear", "stress-point", 0.0, 0.0, "linear-elastic"},
    Body{"stress-point/linear-none", "stress-point", 0.0, 0.0, "linear-elastic", "strain", "none"},
    Body{"stress-point/plane-stress", "stress-point", 0.0, 0.0, "neo-hookean", "stress"},
    Body{"collocated-9", "variational", 1.5, 0.0, "neo-hookean"},
    Body{"collocated-9/linear", "variational", 1.5, 0.0, "linear-elastic"},
    Body{"collocated-21", "variational", 2.5, 0.0, "neo-hookean"},
    Body{"collocated-21/irregular", "variational", 2.5, 0.2, "neo-hookean"},
};

constexpr std::array bars = {
    Body{"bar", "stress-point", 0.0, 0.0, "neo-hookean"},
    Body{"bar/linear", "stress-point", 0.0, 0.0, "linear-elastic"},
    Body{"bar/free-sides", "stress-point", 0.0, 0.0, "neo-hookean", "stress"},
};

/// A sheet or a bar of so many cells a side.
template <int D>
Discretisation<D> sheet(const Body& body, long cells) {
  std::vector<std::string> overrides;
  if (body.support > 0.0) {
    overrides.push_back(fmt::format("kernel.support={}", body.support));
    overrides.emplace_back("stabiliser.kind=none");
  }
  if (*body.stabiliser != '\0')
    overrides.push_back(fmt::format("stabiliser.kind={}", body.stabiliser));
  const std::string text = fmt::format(
      R"(
dimension = {}
formulation = "{}"
[body]
shape = {{ {} }}
spacing = {:.17g}
jitter = {}
[material]
law = "{}"
assumption = "{}"
young = 2e6
poisson = 0.3
density = 1000
[time]
end = 1.0
)",
      D, body.formulation, D == 1 ? "interval = [0.0, 1.0]" : "box = [[0.0, 0.0], [1.0, 1.0]]",
      1.0 / static_cast<double>(cells), body.jitter, body.law, body.assumption);
  return build<D>(read_scene_text(text, "sheet", overrides));
}

constexpr double dt = 1e-9;  // nothing moves far in as many steps as a benchmark likes

void count(benchmark::State& run, Index particles) {
  run.counters["ns"] = benchmark::Counter(
      static_cast<double>(particles) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int D>
State<D> at_rest(const Discretisation<D>& discretisation) {
  State<D> state = make_state<D>(discretisation, 1e-6 * discretisation.particles.X,
                                 0.0 * discretisation.particles.X);
  evaluate<D>(discretisation, state);
  start<D>(discretisation, state, dt);
  return state;
}

template <int D>
void sweep(benchmark::State& run, const Body& body, const SweepOptions& options) {
  const Discretisation<D> discretisation = sheet<D>(body, run.range(0));
  State<D> state = at_rest<D>(discretisation);
  Sweep<D> sweep(discretisation, options);
  BoundaryForces<D> forces(discretisation);
  for (auto _ : run) sweep.step(state, dt, state.time + dt, forces);
  count(run, discretisation.nodes());
}

/// The same step operator by operator.
template <int D>
void operators(benchmark::State& run, const Body& body) {
  const Discretisation<D> discretisation = sheet<D>(body, run.range(0));
  State<D> state = at_rest<D>(discretisation);
  for (auto _ : run) {
    evaluate<D>(discretisation, state);
    advance<D>(discretisation, state, dt, state.time + dt);
  }
  count(run, discretisation.nodes());
}

template <int D>
void plain(benchmark::State& run, const Body& body) {
  const Discretisation<D> discretisation = sheet<D>(body, run.range(0));
  PlainStep<D> step(discretisation, at_rest<D>(discretisation).u);
  for (auto _ : run) step.step(dt);
  count(run, discretisation.nodes());
}

template <int D>
void gradient_product(benchmark::State& run, const Body& body) {
  const Discretisation<D> discretisation = sheet<D>(body, run.range(0));
  State<D> state = at_rest<D>(discretisation);
  for (auto _ : run) discretisation.gradient.gradient(state.u, state.H);
  count(run, discretisation.nodes());
}

template <int D>
void divergence_product(benchmark::State& run, const Body& body) {
  const Discretisation<D> discretisation = sheet<D>(body, run.range(0));
  State<D> state = at_rest<D>(discretisation);
  for (auto _ : run) discretisation.divergence.divergence(state.P, state.f);
  count(run, discretisation.nodes());
}

void law(benchmark::State& run, LawName name, Assumption assumption) {
  const AnyLaw<2> any = make_law<2>(name, assumption, 2e6, 0.3);
  TensorField<2> H = TensorField<2>::Constant(run.range(0), 4, 1e-3);
  TensorField<2> P(run.range(0), 4);
  for (auto _ : run)
    std::visit(
        [&](const auto& of) {
          for (Index s = 0; s < H.rows(); ++s)
            Eigen::Map<Tensor<2>>(P.data() + 4 * s) = of.pk1(tensor_at<2>(H, s));
        },
        any);
  benchmark::DoNotOptimize(P.data());
  count(run, H.rows());
}

using Function = std::function<void(benchmark::State&)>;

void add(const std::string& name, const Function& function, std::initializer_list<long> cells) {
  auto* added = benchmark::RegisterBenchmark(name.c_str(), function);
  for (const long n : cells) added->Arg(n);
}

const char* name_of(Instructions set) {
  return set == Instructions::widest ? "widest" : set == Instructions::avx2 ? "avx2" : "baseline";
}

/// Both ways of a step of linear laws.
constexpr std::array<std::pair<Instructions, StepForm>, 6> forms = {{
    {Instructions::widest, StepForm::points},
    {Instructions::widest, StepForm::stiffness},
    {Instructions::avx2, StepForm::points},
    {Instructions::avx2, StepForm::stiffness},
    {Instructions::baseline, StepForm::points},
    {Instructions::baseline, StepForm::stiffness},
}};

template <int D>
void add_body(const Body& body, std::initializer_list<long> cells) {
  using State = benchmark::State;
  const std::string name = body.name;
  add(
      "Sweep/" + name, [&body](State& run) { sweep<D>(run, body, {1}); }, cells);
  add(
      "Sweep/" + name + "/threads:2", [&body](State& run) { sweep<D>(run, body, {2}); }, cells);
  if (std::string_view(body.law) == "linear-elastic")
    for (const auto& [set, form] : forms)
      if (available(set)) {
        const SweepOptions options{1, false, set, false, form};
        add(
            fmt::format("Sweep/{}/{}/{}", name, form == StepForm::points ? "points" : "stiffness",
                        name_of(set)),
            [&body, options](State& run) { sweep<D>(run, body, options); }, cells);
      }
  add(
      "Operators/" + name, [&body](State& run) { operators<D>(run, body); }, cells);
  add(
      "Eigen/" + name, [&body](State& run) { plain<D>(run, body); }, cells);
  add(
      "Gradient/" + name, [&body](State& run) { gradient_product<D>(run, body); }, cells);
  add(
      "Divergence/" + name, [&body](State& run) { divergence_product<D>(run, body); }, cells);
}

void register_all() {
  for (const Body& body : bodies) add_body<2>(body, {14, 30, 54, 300, 706});
  for (const Body& body : bars) add_body<1>(body, {30, 1000, 100'000, 499'999});
  const auto add_law = [](const char* name, LawName law_name, Assumption assumption) {
    benchmark::RegisterBenchmark(name, [=](benchmark::State& run) {
      law(run, law_name, assumption);
    })->Arg(1000);
  };
  add_law("Law/linear-elastic", LawName::linear_elastic, Assumption::strain);
  add_law("Law/st-venant-kirchhoff", LawName::st_venant_kirchhoff, Assumption::strain);
  add_law("Law/neo-hookean", LawName::neo_hookean, Assumption::strain);
  add_law("Law/neo-hookean, plane stress", LawName::neo_hookean, Assumption::stress);
}

}  // namespace
}  // namespace tlsph

int main(int argc, char** argv) {
  tlsph::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
