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

/// What a child gets: streams, and a group of its own, so that its children can be ended with it.
class SpawnSettings {
 public:
  explicit SpawnSettings(const ProcessOptions& options)
      : valid_(posix_spawn_file_actions_init(&actions_) == 0 &&
               posix_spawnattr_init(&attributes_) == 0) {
    if (!valid_) return;
    constexpr int write = O_WRONLY | O_CREAT | O_TRUNC;
    constexpr mode_t mode = 0644;
    int failure =
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    failure |= posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, options.out.c_str(),
                                                write, mode);
    failure |= posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, options.err.c_str(),
                                                write, mode);
    failure |= posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    valid_ = failure == 0;
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  /// Process id, 0 if it did not start.
  [[nodiscard]] pid_t spawn(std::vector<std::string>& words) const {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    if (!valid_ ||
        posix_spawnp(&child, argv[0], &actions_, &attributes_, argv.data(), environ) != 0)
      return 0;
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
  bool valid_;
};

}  // namespace

std::optional<int> run_process(std::vector<std::string> words, const ProcessOptions& options) {
  const Stopwatch watch;
  const pid_t child = SpawnSettings(options).spawn(words);
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
