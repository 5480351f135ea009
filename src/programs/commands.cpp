#include "commands.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "progress.hpp"
#include "report.hpp"
#include "tlsph/cases/cases.hpp"
#include "tlsph/core/error.hpp"
#include "tlsph/core/stop.hpp"
#include "tlsph/io/checkpoint.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"
#include "tlsph/stability/atlas.hpp"
#include "tlsph/studies/benchmark.hpp"
#include "tlsph/studies/chart.hpp"
#include "tlsph/studies/converge.hpp"
#include "tlsph/studies/figure.hpp"
#include "tlsph/studies/fit.hpp"
#include "tlsph/studies/validation.hpp"

namespace tlsph {
namespace {

/// To the standard output, unless the user wants it quiet; OutputError if it takes nothing (a full
/// disk, a closed pipe).
void print(const CommandLine& line, const std::string& text) {
  if (line.quiet) return;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    throw OutputError("the standard output could not be written");
}

std::filesystem::path output_of(const CommandLine& line, const char* study) {
  return line.out.empty() ? "out" / line.scene.stem().concat(study) : line.out;
}

/// From now on the first signal is a request, which sets the flag this returns.
const std::atomic<bool>* catch_interrupts() {
  may_end_at_once() = false;
  return &stop_flag();
}

void set_study(StudyOptions& options, const std::filesystem::path& out, ProgressDisplay& display) {
  options.out = out;
  options.stop_requested = catch_interrupts();
  options.progress = [&](const std::string& what, double share) { display.show(share, what); };
}

ExitCode ended(bool interrupted, bool holds = true) {
  if (interrupted) return interruption();
  return holds ? ExitCode::done : ExitCode::verdict_failed;
}

/// What to say of a run that goes on with other threads than it was begun with.
std::string threads_note(const CommandLine& line, const std::filesystem::path& out) {
  const auto before = read_checkpoint(out / "checkpoint.h5").integer("threads");
  const int now = line.threads > 0 ? line.threads : omp_get_max_threads();
  if (before == now) return "";
  return fmt::format(
      "begun on {} thread{}, resumed on {}: the same up to rounding, not bit for bit; "
      "--threads {} keeps the bits\n",
      before, before == 1 ? "" : "s", now, before);
}

}  // namespace

ExitCode run_scene(const CommandLine& line) {
  const Scene scene = read_scene(line.scene, line.overrides);
  ProgressDisplay display(line.quiet);
  RunOptions options;
  options.out = line.out.empty() ? default_output(scene) : line.out;
  options.threads = line.threads;
  options.resume = line.resume;
  options.progress = [&](const Progress& progress) { display.show(progress); };
  options.stop_requested = &stop_flag();
  const std::string note = line.resume ? threads_note(line, options.out) : "";

  const Summary summary = run(scene, options);

  display.clear();
  print(line, run_report(summary, options.out) + note);
  return ended(summary.interrupted);
}

ExitCode plan_scene(const CommandLine& line) {
  print(line, plan(read_scene(line.scene, line.overrides)).text);
  return ExitCode::done;
}

ExitCode export_scene(const CommandLine& line) {
  export_operators(read_scene(line.scene, line.overrides), line.out);
  print(line, fmt::format("operators in {0}/*.mtx and {0}/operators.h5, their properties in "
                          "{0}/report.json\n",
                          line.out.string()));
  return ExitCode::done;
}

ExitCode converge_scene(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "-converge");
  std::optional<ProgressDisplay> display;  // one a run; elsewhere than on a terminal a line a run
  ConvergenceOptions options;
  options.out = out;
  options.threads = line.threads;
  options.stop_requested = catch_interrupts();
  if (ProgressDisplay::style_for(line.quiet) == ProgressDisplay::Style::bar) {
    options.before_run = [&](const ConvergenceRow&) { display.emplace(line.quiet); };
    options.run_progress = [&](const Progress& progress) { display->show(progress); };
  }
  options.after_run = [&](const ConvergenceRow& row) {
    display.reset();
    print(line, run_line(row));
  };

  ConvergenceRequest request{line.scene, line.overrides, line.spacings, line.formulations,
                             {},         line.seeds,     line.clouds,   line.values};
  for (const std::string& text : line.over) request.over.push_back(parse_variation(text));

  const ConvergenceTable table = converge(request, options);

  display.reset();
  const Figure figure = draw_figure("convergence", out / "convergence.csv");
  print(line, fmt::format("\n{}\n{}", table.text(), results_report(out, figure)));
  if (table.interrupted) return interruption();
  const auto failed = std::ranges::count_if(
      table.rows, [](const ConvergenceRow& row) { return !row.failure.empty(); });
  if (failed > 0)
    throw NumericalError(fmt::format("{} of {} runs failed, see {}", failed, table.rows.size(),
                                     (out / "convergence.csv").string()),
                         0.0, -1);
  return ExitCode::done;
}

ExitCode draw_stability(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "-stability");
  ProgressDisplay display(line.quiet);
  AtlasOptions options;
  options.out = out;
  options.stop_requested = catch_interrupts();
  options.progress = [&](double share, const std::string& what) { display.show(share, what); };

  const Atlas atlas = draw_atlas({line.scene, line.overrides, line.only}, options);

  display.clear();
  atlas.write(out);
  const Figure figure = draw_figure("stability", out / "stability.json");
  print(line, atlas.text() + results_report(out, figure));
  return ended(atlas.interrupted);
}

ExitCode chart_scene(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "-chart");
  ChartRequest request{line.scene, line.overrides, line.budget, line.spacings, line.formulations,
                       {},         line.peers};
  for (const std::string& text : line.values) request.values.push_back(parse_chart_value(text));
  ProgressDisplay display(line.quiet);
  ChartOptions options;
  set_study(options, out, display);
  options.threads = std::max(1, line.threads);

  const ChartTable table = chart(request, options);

  display.clear();
  const Figure figure = draw_figure("chart", out / "chart.json");
  print(line, fmt::format("{}\n{}", table.text(), results_report(out, figure)));
  return ended(table.interrupted);
}

ExitCode fit_scene(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "-fit");
  FitRequest request{line.scene, line.overrides, line.error, line.quantity, std::nullopt};
  if (!line.values.empty()) request.value = parse_chart_value(line.values.front());
  ProgressDisplay display(line.quiet);
  FitOptions options;
  set_study(options, out, display);
  options.threads = std::max(1, line.threads);
  options.after_choice = [&](const FitTable& table) {
    display.clear();
    print(line, table.choice_text());
  };

  const FitTable table = fit(request, options);

  display.clear();
  print(line, fmt::format("{0}scene in {1}/scene.toml, pilots in {1}/fit.csv\n",
                          table.verdict_text(), out.string()));
  return ended(table.interrupted, table.meets());
}

ExitCode validate_cases(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "validation");
  ProgressDisplay display(line.quiet);
  ValidationOptions options;
  set_study(options, out, display);
  options.only = line.cases;
  options.quick = line.quick;
  options.at_once = line.threads;
  options.after_case = [&](const CaseResult& result, double) {
    display.clear();
    print(line, case_line(result));
  };

  const ValidationTable table = validate(all_cases(), options);

  display.clear();
  print(line, fmt::format("\n{}results in {}\n", table.text(), out.string()));
  return ended(table.interrupted, table.holds());
}

ExitCode benchmark_steps(const CommandLine& line) {
  const std::filesystem::path out = output_of(line, "benchmark");
  BenchmarkOptions options;
  options.out = out;
  if (line.particles > 0.0) options.particles = static_cast<Index>(line.particles);
  if (line.seconds > 0.0) options.seconds = line.seconds;
  options.stop_requested = catch_interrupts();
  options.before_case = [&](const std::string& name) { print(line, name + "\n"); };

  const BenchmarkTable table = benchmark(options);

  print(line, fmt::format("\n{}\nresults in {}/benchmark.csv and benchmark.json\n", table.text(),
                          out.string()));
  return ended(table.interrupted);
}

ExitCode print_reference(const CommandLine& line) {
  print(line, scene_reference());
  return ExitCode::done;
}

}  // namespace tlsph
