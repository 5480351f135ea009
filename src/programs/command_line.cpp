#include <CLI/CLI.hpp>
#include <iostream>

#include "commands.hpp"
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

/// Values in one word, separated by commas.
template <class Values>
CLI::Option* add_list(CLI::App& command, const char* name, Values& values, const char* text,
                      const char* type) {
  return command.add_option(name, values, text)
      ->type_name(type)
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_out(CLI::App& command, CommandLine& line, const std::string& standard) {
  command.add_option("--out", line.out, "directory for the results; default: " + standard)
      ->type_name("DIR");
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

void add_run(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  add_out(command, line, "out/<name of the scene>");
  add_threads(command, line);
  add_quiet(command, line);
  command.add_flag("--resume", line.resume, "go on from the checkpoint in the directory");
}

void add_export(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  command.add_option("--out", line.out, "directory for the matrices")->type_name("DIR")->required();
  add_quiet(command, line);
}

void add_converge(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  auto* sizes = command.add_option_group("sizes");
  sizes->add_option(add_list(
      command, "--spacing", line.spacings,
      "spacings [m], at least two; three where the scene names no exact solution", "A,B,C[,...]"));
  sizes->add_option(add_list(command, "--cloud", line.clouds,
                             "clouds of particles instead (body.cloud), sized by their number",
                             "A.csv,B.csv[,...]"));
  sizes->require_option(1);
  add_list(command, "--formulation", line.formulations,
           "formulations to compare; default: the scene's", "A[,B,...]");
  command
      .add_option("--over", line.over,
                  "another key of the scene to compare, e.g. kernel.support=2.1,2.6; may be "
                  "repeated, each value with each")
      ->type_name("KEY=A,B[,...]")
      ->allow_extra_args(false);
  add_list(command, "--seed", line.seeds,
           "run every one with each body.seed: median, worst and spread of random particles",
           "A[,B,...]");
  add_list(
      command, "--value", line.values,
      "number to read off a probe and to extrapolate: <probe>.<column>.<end|max|min|peak|period>",
      "NAME[,...]");
  add_out(command, line, "out/<name of the scene>-converge");
  add_threads(command, line);
  add_quiet(command, line);
}

void add_stability(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  command
      .add_option("--only", line.only,
                  "rows whose names this regular expression finds, e.g. 'jitter 0.4.*nu 0.3'")
      ->type_name("REGEX");
  add_out(command, line, "out/<name of the scene>-stability");
  add_quiet(command, line);
}

void add_chart(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  command.add_option("--budget", line.budget, "wall time of the study, e.g. 120s or 10min")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}},
          CLI::AsNumberWithUnit::UNIT_OPTIONAL, "TIME"))
      ->capture_default_str();
  add_list(
      command, "--value", line.values,
      "number to read off a probe, <probe>.<column>.<end|max|min|peak|period>, and its answer; "
      "without one it is extrapolated",
      "NAME[=ANSWER][,...]");
  add_list(command, "--spacing", line.spacings,
           "spacings [m]; default: 4, 2, 1, 1/2 ... of the scene's", "A[,B,...]");
  add_list(command, "--formulation", line.formulations, "only these formulations", "A[,B,...]");
  add_list(command, "--peer", line.peers, "other programs beside it, scripts of validation/peers",
           "A[,B,...]");
  add_out(command, line, "out/<name of the scene>-chart");
  add_threads(command, line, "1");
  add_quiet(command, line);
}

void add_fit(CLI::App& command, CommandLine& line) {
  add_scene(command, line);
  command.add_option("--error", line.error, "wanted, relative, e.g. 0.01")->required();
  auto* quantity = command.add_option("--quantity", line.quantity,
                                      "stress, displacement or velocity, against the exact "
                                      "solution; default: the worst of the three");
  command
      .add_option("--value", line.values,
                  "instead: number to read off a probe, <probe>.<column>.<end|max|min|peak|"
                  "period>, and its answer; without one it is extrapolated")
      ->type_name("NAME[=ANSWER]")
      ->expected(1)
      ->excludes(quantity);
  add_out(command, line, "out/<name of the scene>-fit");
  add_threads(command, line, "1");
  add_quiet(command, line);
}

void add_validate(CLI::App& command, CommandLine& line) {
  command.add_option("CASE", line.cases, "names of cases, folders of validation/; default: all");
  command.add_flag("--quick", line.quick, "only what takes seconds");
  add_out(command, line, "out/validation");
  add_threads(command, line);
  add_quiet(command, line);
}

void add_benchmark(CLI::App& command, CommandLine& line) {
  command.add_option("--particles", line.particles, "of the large bodies; default: 500000")
      ->type_name("N")
      ->check(CLI::Range(1e3, 1e8));
  command.add_option("--seconds", line.seconds, "of a batch of steps, seven a case; default: 0.3")
      ->type_name("S")
      ->check(CLI::Range(1e-4, 60.0));
  add_out(command, line, "out/benchmark");
  add_quiet(command, line);
}

struct Command {
  const char *name, *description;
  void (*add_options)(CLI::App&, CommandLine&);
  ExitCode (*run)(const CommandLine&);
};
constexpr Command commands[] = {
    {"run", "run a scene", add_run, run_scene},
    {"plan", "say what would be modelled and what it costs; run nothing", add_scene, plan_scene},
    {"export", "write every operator as Matrix Market file and into operators.h5", add_export,
     export_scene},
    {"converge", "run a scene at several spacings: errors and the orders they fall with",
     add_converge, converge_scene},
    {"stability", "where methods fail on the body and material of a scene, why, and what cures it",
     add_stability, draw_stability},
    {"chart", "speed against accuracy: many ways to model a scene, and the front of the best",
     add_chart, chart_scene},
    {"fit", "the cheapest model of a scene for a wanted error, verified", add_fit, fit_scene},
    {"validate", "run problems of the literature and hold what comes out against what must",
     add_validate, validate_cases},
    {"benchmark", "time a step in every kind of storage, beside what this machine could do",
     add_benchmark, benchmark_steps},
    {"scene-reference", "every key of a scene: type, unit, default, range",
     [](CLI::App&, CommandLine&) {}, print_reference},
};

}  // namespace

std::optional<CommandLine> parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  CLI::App app{"Total-Lagrangian SPH elastodynamics as sparse matrices", "tlsph"};
  app.set_version_flag("--version", version());
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  for (const Command& each : commands) {
    CLI::App* command = app.add_subcommand(each.name, each.description);
    each.add_options(*command, line);
    command->callback([&] { line.command = each.run; });
  }
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
