#include "commands.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include "interrupt.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "tlsph/scene/reader.hpp"
#include "tlsph/simulation/simulation.hpp"

namespace tlsph {
namespace {

/// To the standard output; OutputError if it takes nothing (a full disk, a closed pipe).
void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0)
    throw OutputError("the standard output could not be written");
}

ExitCode run_scene(const CommandLine& line) {
  const Scene scene = read_scene(line.scene, line.overrides);
  ProgressDisplay display(stdout, ProgressDisplay::style_for(stdout, line.quiet));
  RunOptions options;
  options.out = line.out.empty() ? default_output(scene) : line.out;
  options.threads = line.threads;
  options.resume = line.resume;
  options.progress = [&](const Progress& progress) { display.show(progress); };
  options.stop_requested = catch_interrupts();

  const Summary summary = run(scene, options);

  display.clear();
  if (!line.quiet) print(run_report(summary, options.out));
  if (!summary.interrupted) return ExitCode::done;
  return interrupt_received() == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
}

ExitCode plan_scene(const CommandLine& line) {
  print(plan(read_scene(line.scene, line.overrides)).text);
  return ExitCode::done;
}

ExitCode export_scene(const CommandLine& line) {
  export_operators(read_scene(line.scene, line.overrides), line.out);
  if (!line.quiet)
    print(
        fmt::format("operators in {0}/*.mtx and {0}/operators.h5, their properties in "
                    "{0}/report.json\n",
                    line.out.string()));
  return ExitCode::done;
}

ExitCode print_reference() {
  print(scene_reference());
  return ExitCode::done;
}

}  // namespace

ExitCode execute(const CommandLine& line) {
  switch (line.command) {
    case Command::run:
      return run_scene(line);
    case Command::plan:
      return plan_scene(line);
    case Command::export_operators:
      return export_scene(line);
    case Command::scene_reference:
      return print_reference();
  }
  return ExitCode::internal_error;
}

}  // namespace tlsph
