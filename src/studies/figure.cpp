#include "tlsph/studies/figure.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <vector>

namespace tlsph {
namespace {

namespace fs = std::filesystem;

/// The value of an environment variable that is set and not empty.
std::optional<fs::path> chosen_by(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

/// The script, empty if there is none.
fs::path plot_script() {
  if (const auto chosen = chosen_by("TLSPH_PLOT")) return *chosen;
  const fs::path folder = validation_folder();
  return folder.empty() ? folder : folder / "plot.py";
}

/// Runs a program with nothing to read and nothing to say; true if it exits with 0.
bool runs(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return false;
  int failure = 0;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    failure |= posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  if (failure == 0)
    failure = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return false;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

fs::path validation_folder() {
  if (const auto chosen = chosen_by("TLSPH_VALIDATION")) return *chosen;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& candidate : {program.parent_path().parent_path() / "share/tlsph/validation",
                                    fs::path(TLSPH_VALIDATION_FOLDER)})
    if (fs::is_regular_file(candidate / "plot.py", ignored)) return candidate;
  return {};
}

Figure draw_figure(const std::string& kind, const fs::path& data) {
  return draw_figure(kind, data, fs::path(data).replace_extension(".png"));
}

Figure draw_figure(const std::string& kind, const fs::path& data, const fs::path& file) {
  Figure figure;
  figure.file = file;
  const fs::path script = plot_script();
  figure.command =
      fmt::format("python3 {} {} {}", script.empty() ? "validation/plot.py" : script.string(), kind,
                  data.string());
  if (file != fs::path(data).replace_extension(".png")) figure.command += " --out " + file.string();
  if (script.empty()) return figure;
  const bool system = access("/usr/bin/python3", X_OK) == 0;
  // -B: no byte code beside the scripts, which may lie where only the system writes.
  figure.drawn = runs({system ? "/usr/bin/python3" : "python3", "-B", script.string(), kind,
                       data.string(), "--out", figure.file.string()});
  return figure;
}

}  // namespace tlsph
