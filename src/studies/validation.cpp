#include "tlsph/studies/validation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "tlsph/core/error.hpp"
#include "tlsph/core/stopwatch.hpp"
#include "tlsph/io/files.hpp"
#include "tlsph/io/json.hpp"
#include "tlsph/linear/factorization.hpp"
#include "tlsph/simulation/version.hpp"
#include "tlsph/studies/figure.hpp"

namespace tlsph {
namespace {

namespace fs = std::filesystem;

std::vector<Case> chosen_cases(std::span<const Case> cases, const ValidationOptions& options) {
  std::vector<std::string_view> names;
  for (const Case& entry : cases) names.push_back(entry.name);
  for (const std::string& name : options.only)
    if (std::ranges::find(names, name) == names.end())
      throw InputError(
          fmt::format("there is no case \"{}\"; choose from {}", name, fmt::join(names, " | ")));
  std::vector<Case> chosen;
  for (const Case& entry : cases) {
    const bool named =
        options.only.empty() || std::ranges::find(options.only, entry.name) != options.only.end();
    if (named && (entry.quick || !options.quick)) chosen.push_back(entry);
  }
  if (chosen.empty()) throw InputError("none of these cases is quick; leave --quick out");
  return chosen;
}

/// Of a case of which nothing is known yet.
CaseResult named(const Case& entry) {
  CaseResult result;
  result.name = entry.name;
  result.title = entry.title;
  return result;
}

/// Runs a case to its end, whatever happens, and says what came of it.
CaseResult result_of(const Case& entry, const fs::path& folder, const ValidationOptions& options) {
  CaseResult result = named(entry);
  const Stopwatch watch;
  try {
    CaseRun run(folder / entry.name, options.out / entry.name);
    try {
      entry.run(run);
    } catch (const std::exception& error) {
      result.failure = error.what();
    }
    result.checks = run.checks();
    if (options.figures && fs::exists(folder / entry.name / "figure.py")) {
      const fs::path target = options.out / "figures" / fmt::format("{}.png", entry.name);
      const Figure figure = draw_figure("case", run.out(), target);
      if (figure.drawn)
        result.file = figure.file;
      else
        result.undrawn = figure.command;
    }
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  result.seconds = watch.seconds();
  return result;
}

/// A case at work in a process of its own.
struct Worker {
  std::size_t index = 0;  // among the chosen cases
  pid_t process = 0;
  Stopwatch watch;
};

fs::path handed_over(const ValidationOptions& options, const Case& entry) {
  return options.out / entry.name / "checks.json";
}

/// What the process of a case left behind.
CaseResult collect(const Case& entry, int status, double seconds,
                   const ValidationOptions& options) {
  CaseResult result = named(entry);
  result.seconds = seconds;
  try {
    if (!WIFSIGNALED(status)) return CaseResult::read(Json::read(handed_over(options, entry)));
    result.failure =
        fmt::format("ended by signal {} ({})", WTERMSIG(status), sigdescr_np(WTERMSIG(status)));
  } catch (const InputError& error) {
    result.failure = error.what();
  }
  return result;
}

class Validation {
 public:
  Validation(std::vector<Case> cases, fs::path folder, const ValidationOptions& options)
      : cases_(std::move(cases)), folder_(std::move(folder)), options_(options) {
    for (std::size_t k = 0; k < cases_.size(); ++k) {
      waiting_.push_back(k);
      total_ += cases_[k].seconds;
    }
    // The longest first, taken from the back: the last ones to end are short.
    std::ranges::stable_sort(waiting_, {}, [&](std::size_t k) { return cases_[k].seconds; });
    results_.resize(cases_.size());
  }

  ValidationTable run() {
    const std::size_t places = options_.at_once > 0
                                   ? static_cast<std::size_t>(options_.at_once)
                                   : std::max(1U, std::thread::hardware_concurrency());
    ValidationTable table;
    table.version = version();
    while (!waiting_.empty() || !workers_.empty()) {
      table.interrupted = stopped();
      if (table.interrupted) break;
      while (!waiting_.empty() && workers_.size() < places) start_next();
      if (!gather()) {
        if (options_.progress) options_.progress(running(), share());
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
    }
    for (const auto& result : results_)
      if (result) table.cases.push_back(*result);
    return table;
  }

 private:
  [[nodiscard]] bool stopped() {
    if (!options_.stopped()) return false;
    for (const Worker& worker : workers_) kill(worker.process, SIGTERM);
    for (const Worker& worker : workers_) waitpid(worker.process, nullptr, 0);
    return true;
  }

  void start_next() {
    const std::size_t index = waiting_.back();
    waiting_.pop_back();
    const Case& entry = cases_[index];
    make_output_directory(options_.out / entry.name);
    fs::remove(handed_over(options_, entry));
    const pid_t process = fork();
    if (process < 0)
      throw OutputError(fmt::format("no process for {}: {}", entry.name, std::strerror(errno)));
    if (process == 0) {
      for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
      set_blas_threads(1);
      int code = EXIT_FAILURE;
      try {
        const CaseResult result = result_of(entry, folder_, options_);
        result.json().write(handed_over(options_, entry));
        code = EXIT_SUCCESS;
      } catch (...) {  // nothing was handed over, which the parent sees
      }
      _exit(code);  // what the parent still has in its buffers is the parent's to write
    }
    workers_.push_back({index, process, {}});
  }

  /// True if a process had ended.
  bool gather() {
    for (auto worker = workers_.begin(); worker != workers_.end(); ++worker) {
      int status = 0;
      if (waitpid(worker->process, &status, WNOHANG) == 0) continue;
      const std::size_t index = worker->index;
      results_[index] = collect(cases_[index], status, worker->watch.seconds(), options_);
      workers_.erase(worker);
      done_ += cases_[index].seconds;
      if (options_.after_case) options_.after_case(*results_[index], share());
      return true;
    }
    return false;
  }

  [[nodiscard]] double share() const { return done_ / total_; }

  [[nodiscard]] std::string running() const {
    std::vector<std::string_view> names;
    for (const Worker& worker : workers_) names.push_back(cases_[worker.index].name);
    return fmt::format("running {}", fmt::join(names, ", "));
  }

  std::vector<Case> cases_;
  fs::path folder_;
  const ValidationOptions& options_;
  std::vector<std::size_t> waiting_;
  std::vector<Worker> workers_;
  std::vector<std::optional<CaseResult>> results_;
  double total_ = 0.0, done_ = 0.0;
};

}  // namespace

ValidationTable validate(std::span<const Case> cases, const ValidationOptions& options) {
  std::vector<Case> chosen = chosen_cases(cases, options);
  const fs::path folder = validation_folder();
  if (folder.empty())
    throw InputError(
        "the scenes of the cases are not found; set TLSPH_VALIDATION to the folder "
        "validation of the source tree");
  make_output_directory(options.out / "figures");
  ValidationTable table = Validation(std::move(chosen), folder, options).run();
  table.write(options.out);
  return table;
}

}  // namespace tlsph
