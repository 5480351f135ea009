// Files that a library may not survive, tried in a process of their own.
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <string_view>
#include <system_error>

#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace {

enum Verdict : int { sound = 0, refused = 1, failed = 2 };

/// What the child does: the message of an InputError goes into `pipe`.
Verdict judge(const std::function<void()>& read, int pipe) {
  try {
    read();
    return sound;
  } catch (const InputError& error) {
    const std::string_view text = error.what();
    return ::write(pipe, text.data(), text.size()) < 0 ? failed : refused;
  } catch (...) {
    return failed;
  }
}

/// Seconds in which even a slow disk hands over a file of that size.
unsigned patience(const std::filesystem::path& file) {
  std::error_code unknown;
  const auto bytes = std::filesystem::file_size(file, unknown);
  return 60 + (unknown ? 0 : static_cast<unsigned>(bytes >> 23U));
}

}  // namespace

void try_reading(const std::filesystem::path& file, const std::function<void()>& read) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) output_failed(file, "read this file aside", errno);
  const pid_t child = ::fork();
  if (child < 0) {
    const int error = errno;
    for (const int end : ends) ::close(end);
    output_failed(file, "read this file aside", error);
  }
  if (child == 0) {
    for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::alarm(patience(file));
    _exit(judge(read, ends[1]));  // what the parent still has in its buffers is its own to write
  }
  ::close(ends[1]);
  std::string text;
  std::array<char, 4096> block{};
  for (ssize_t got = 0; (got = ::read(ends[0], block.data(), block.size())) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) text.append(block.data(), static_cast<std::size_t>(got));
  }
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const int verdict = WIFEXITED(status) ? WEXITSTATUS(status) : failed;
  if (verdict == sound) return;
  if (verdict == refused) throw InputError(text);
  throw InputError(Place{file.string(), 0, 0, ""},
                   "damaged: it cannot be read to its end; start without --resume");
}

}  // namespace tlsph
