#include "process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "tlsph/core/stopwatch.hpp"

namespace tlsph {
namespace {

/// The process id of a child with these streams, in a group of its own, so that its children can be
/// ended with it; 0 if it did not start.
pid_t spawn(std::vector<std::string>& words, const ProcessOptions& options) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t streams{};
  posix_spawnattr_t attributes{};
  const auto redirect = [&](int stream, const std::filesystem::path& file, int flags) {
    return posix_spawn_file_actions_addopen(&streams, stream, file.c_str(), flags, 0644);
  };
  constexpr int write = O_WRONLY | O_CREAT | O_TRUNC;
  if (posix_spawn_file_actions_init(&streams) != 0) return 0;
  pid_t child = 0;
  if (posix_spawnattr_init(&attributes) == 0) {
    if (redirect(STDIN_FILENO, "/dev/null", O_RDONLY) != 0 ||
        redirect(STDOUT_FILENO, options.out, write) != 0 ||
        redirect(STDERR_FILENO, options.err, write) != 0 ||
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP) != 0 ||
        posix_spawnp(&child, argv[0], &streams, &attributes, argv.data(), environ) != 0)
      child = 0;
    posix_spawnattr_destroy(&attributes);
  }
  posix_spawn_file_actions_destroy(&streams);
  return child;
}

}  // namespace

std::optional<int> run_process(std::vector<std::string> words, const ProcessOptions& options) {
  const Stopwatch watch;
  const pid_t child = spawn(words, options);
  if (child == 0) return std::nullopt;
  const bool watched = options.seconds || options.stop_requested != nullptr;
  bool killed = false;
  int status = 0;
  while (true) {
    const pid_t ended = waitpid(child, &status, watched && !killed ? WNOHANG : 0);
    if (ended == child) break;
    if (ended < 0 && errno != EINTR) return std::nullopt;
    if (ended != 0) continue;
    if ((options.seconds && watch.seconds() > *options.seconds) ||
        (options.stop_requested != nullptr && *options.stop_requested)) {
      kill(-child, SIGKILL);
      killed = true;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  if (killed || !WIFEXITED(status)) return std::nullopt;
  return WEXITSTATUS(status);
}

std::string python() {
  return access("/usr/bin/python3", X_OK) == 0 ? "/usr/bin/python3" : "python3";
}

}  // namespace tlsph
