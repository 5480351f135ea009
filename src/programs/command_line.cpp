#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "tlsph/core/error.hpp"
#include "tlsph/simulation/version.hpp"

namespace tlsph {
namespace {

void add_scene(CLI::App& command, CommandLine& line) {
  command.add_option("SCENE", line.scene, "scene file (TOML)")->required();
  // One value each: what follows belongs to the next option, even where it looks like a list.
  command
      .add_option("--set", line.overrides,
                  "override a key of the scene, e.g. body.spacing=1e-3 or "
                  "boundary[0].traction.amplitude=-2e5; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_out(CLI::App& command, CommandLine& line, const std::string& standard) {
  command.add_option("--out", line.out, "directory for the results" + standard)->type_name("DIR");
}

void add_threads(CLI::App& command, CommandLine& line,
                 const std::string& standard = "as many as pay") {
  command.add_option("--threads", line.threads, "threads; default: " + standard)
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

void add_quiet(CLI::App& command, CommandLine& line) {
  command.add_flag("--quiet", line.quiet, "print nothing but errors");
}

void add_run(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand("run", "run a scene");
  add_scene(*command, line);
  add_out(*command, line, "; default: out/<name of the scene>");
  add_threads(*command, line);
  add_quiet(*command, line);
  command->add_flag("--resume", line.resume, "go on from the checkpoint in the directory");
  command->callback([&line] { line.command = Command::run; });
}

void add_plan(CLI::App& app, CommandLine& line) {
  auto* command =
      app.add_subcommand("plan", "say what would be modelled and what it costs; run nothing");
  add_scene(*command, line);
  command->callback([&line] { line.command = Command::plan; });
}

void add_export(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "export", "write every operator as Matrix Market file and into operators.h5");
  add_scene(*command, line);
  command->add_option("--out", line.out, "directory for the matrices")
      ->type_name("DIR")
      ->required();
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::export_operators; });
}

void add_converge(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "converge", "run a scene at several spacings: errors and the orders they fall with");
  add_scene(*command, line);
  const auto list = [&](const char* name, auto& values, const char* text, const char* type) {
    return command->add_option(name, values, text)
        ->type_name(type)
        ->delimiter(',')
        ->allow_extra_args(false);
  };
  auto* sizes = command->add_option_group("sizes");
  sizes->add_option(list(
      "--spacing", line.spacings,
      "spacings [m], at least two; three where the scene names no exact solution", "A,B,C[,...]"));
  sizes->add_option(list("--cloud", line.clouds,
                         "clouds of particles instead (body.cloud), sized by their number",
                         "A.csv,B.csv[,...]"));
  sizes->require_option(1);
  list("--formulation", line.formulations, "formulations to compare; default: the scene's",
       "A[,B,...]");
  command
      ->add_option("--over", line.over,
                   "another key of the scene to compare, e.g. kernel.support=2.1,2.6; may be "
                   "repeated, each value with each")
      ->type_name("KEY=A,B[,...]")
      ->allow_extra_args(false);
  list("--seed", line.seeds,
       "run every one with each body.seed: median, worst and spread of random particles",
       "A[,B,...]");
  list("--value", line.values,
       "number to read off a probe and to extrapolate: <probe>.<column>.<end|max|min|peak|period>",
       "NAME[,...]");
  add_out(*command, line, "; default: out/<name of the scene>-converge");
  add_threads(*command, line);
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::converge; });
}

void add_stability(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "stability",
      "where methods fail on the body and material of a scene, why, and what cures it");
  add_scene(*command, line);
  command
      ->add_option("--only", line.only,
                   "rows whose names this regular expression finds, e.g. 'jitter 0.4.*nu 0.3'")
      ->type_name("REGEX");
  add_out(*command, line, "; default: out/<name of the scene>-stability");
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::stability; });
}

void add_chart(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "chart", "speed against accuracy: many ways to model a scene, and the front of the best");
  add_scene(*command, line);
  command->add_option("--budget", line.budget, "wall time of the study, e.g. 120s or 10min")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}},
          CLI::AsNumberWithUnit::UNIT_OPTIONAL, "TIME"))
      ->capture_default_str();
  const auto list = [&](const char* name, auto& values, const char* text, const char* type) {
    return command->add_option(name, values, text)
        ->type_name(type)
        ->delimiter(',')
        ->allow_extra_args(false);
  };
  list("--value", line.values,
       "number to read off a probe, <probe>.<column>.<end|max|min|peak|period>, and its answer; "
       "without one it is extrapolated",
       "NAME[=ANSWER][,...]");
  list("--spacing", line.spacings, "spacings [m]; default: 4, 2, 1, 1/2 ... of the scene's",
       "A[,B,...]");
  list("--formulation", line.formulations, "only these formulations", "A[,B,...]");
  list("--peer", line.peers, "other programs beside it, scripts of validation/peers", "A[,B,...]");
  add_out(*command, line, "; default: out/<name of the scene>-chart");
  add_threads(*command, line, "1");
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::chart; });
}

void add_fit(CLI::App& app, CommandLine& line) {
  auto* command =
      app.add_subcommand("fit", "the cheapest model of a scene for a wanted error, verified");
  add_scene(*command, line);
  command->add_option("--error", line.error, "wanted, relative, e.g. 0.01")->required();
  auto* quantity = command->add_option("--quantity", line.quantity,
                                       "stress, displacement or velocity, against the exact "
                                       "solution; default: the worst of the three");
  command
      ->add_option("--value", line.values,
                   "instead: number to read off a probe, <probe>.<column>.<end|max|min|peak|"
                   "period>, and its answer; without one it is extrapolated")
      ->type_name("NAME[=ANSWER]")
      ->expected(1)
      ->excludes(quantity);
  add_out(*command, line, "; default: out/<name of the scene>-fit");
  add_threads(*command, line, "1");
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::fit; });
}

void add_validate(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "validate", "run problems of the literature and hold what comes out against what must");
  command->add_option("CASE", line.cases, "names of cases, folders of validation/; default: all");
  command->add_flag("--quick", line.quick, "only what takes seconds");
  add_out(*command, line, "; default: out/validation");
  add_threads(*command, line);
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::validate; });
}

void add_benchmark(CLI::App& app, CommandLine& line) {
  auto* command = app.add_subcommand(
      "benchmark", "time a step in every kind of storage, beside what this machine could do");
  command->add_option("--particles", line.particles, "of the large bodies; default: 500000")
      ->type_name("N")
      ->check(CLI::Range(1e3, 1e8));
  command->add_option("--seconds", line.seconds, "of a batch of steps, seven a case; default: 0.3")
      ->type_name("S")
      ->check(CLI::Range(1e-4, 60.0));
  add_out(*command, line, "; default: out/benchmark");
  add_quiet(*command, line);
  command->callback([&line] { line.command = Command::benchmark; });
}

}  // namespace

std::optional<CommandLine> parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  CLI::App app{"Total-Lagrangian SPH elastodynamics as sparse matrices", "tlsph"};
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  add_run(app, line);
  add_plan(app, line);
  add_export(app, line);
  add_converge(app, line);
  add_stability(app, line);
  add_chart(app, line);
  add_fit(app, line);
  add_validate(app, line);
  add_benchmark(app, line);
  app.add_subcommand("scene-reference", "every key of a scene: type, unit, default, range")
      ->callback([&line] { line.command = Command::scene_reference; });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // help or version
      app.exit(error);
      if (!std::cout.flush()) throw OutputError("the standard output could not be written");
      return std::nullopt;
    }
    throw InputError("tlsph: " + std::string(error.what()) + "; see tlsph --help");
  }
  return line;
}

}  // namespace tlsph
