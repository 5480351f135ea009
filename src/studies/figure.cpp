#include "tlsph/studies/figure.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>

namespace tlsph {
namespace {

namespace fs = std::filesystem;

/// The script, empty if there is none.
fs::path plot_script() {
  if (const char* chosen = std::getenv("TLSPH_PLOT"); chosen != nullptr && *chosen != '\0')
    return chosen;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  for (const fs::path& candidate :
       {program.parent_path().parent_path() / "share/tlsph/plot.py", fs::path(TLSPH_PLOT_SCRIPT)})
    if (fs::is_regular_file(candidate, ignored)) return candidate;
  return {};
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

Figure draw_figure(const std::string& kind, const fs::path& data) {
  Figure figure;
  figure.file = fs::path(data).replace_extension(".png");
  const fs::path script = plot_script();
  figure.command =
      fmt::format("python3 {} {} {}", script.empty() ? "validation/plot.py" : script.string(), kind,
                  data.string());
  if (script.empty()) return figure;
  const bool system = access("/usr/bin/python3", X_OK) == 0;
  // -B: no byte code beside the scripts, which may lie where only the system writes.
  figure.drawn = runs({system ? "/usr/bin/python3" : "python3", "-B", script.string(), kind,
                       data.string(), "--out", figure.file.string()});
  return figure;
}

}  // namespace tlsph
