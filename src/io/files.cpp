#include "tlsph/io/files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "system.hpp"
#include "tlsph/core/error.hpp"

namespace tlsph {
namespace fs = std::filesystem;

void output_failed(const fs::path& path, const char* action, int error) {
  throw OutputError(path.string() + ": cannot " + action + ": " + std::strerror(error));
}

void write_all(int descriptor, const void* bytes, std::size_t count, const fs::path& path) {
  const char* next = static_cast<const char*>(bytes);
  while (count > 0) {
    const ssize_t written = ::write(descriptor, next, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) output_failed(path, "write", errno);
    next += written;
    count -= static_cast<std::size_t>(written);
  }
}

void replace_file(const fs::path& aside, const fs::path& target) {
  if (std::rename(aside.c_str(), target.c_str()) == 0) return;
  const int error = errno;
  ::unlink(aside.c_str());
  output_failed(target, "replace", error);
}

void make_output_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) output_failed(directory, "make this output directory", error.value());
  if (!fs::is_directory(directory, error))
    output_failed(directory, "use this as output directory", ENOTDIR);
  // Permissions, quotas and read-only mounts have many causes; writing a file asks for all at once.
  std::string trial = (directory / ".tlsph-XXXXXX").string();
  const int descriptor = ::mkstemp(trial.data());
  if (descriptor < 0) output_failed(directory, "write in this output directory", errno);
  ::close(descriptor);
  ::unlink(trial.c_str());
}

AsideFile::AsideFile(fs::path target)
    : target_(std::move(target)),
      aside_(target_.string() + ".tmp"),
      descriptor_(::open(aside_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) output_failed(aside_, "create", errno);
}

AsideFile::~AsideFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(aside_.c_str());
}

void AsideFile::write(const void* bytes, std::size_t count) {
  write_all(descriptor_, bytes, count, aside_);
}

void AsideFile::commit(Durability durability) {
  if (durability == Durability::machine && ::fsync(descriptor_) != 0)
    output_failed(aside_, "put on the disk", errno);
  // A network file system may report a full disk only here.
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    const int error = errno;
    ::unlink(aside_.c_str());
    output_failed(aside_, "close", error);
  }
  replace_file(aside_, target_);
  if (durability == Durability::program) return;
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  const int directory = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool synced = directory >= 0 && ::fsync(directory) == 0;
  const int error = errno;
  if (directory >= 0) ::close(directory);
  if (!synced) output_failed(parent, "put on the disk", error);
}

void write_text_file(const fs::path& path, std::string_view text, Durability durability) {
  AsideFile file(path);
  file.write(text);
  file.commit(durability);
}

DirectoryLock::DirectoryLock(const fs::path& directory)
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) output_failed(directory, "open this output directory", errno);
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  // File systems without locks are no reason to refuse a run.
  if (error != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw OutputError(directory.string() +
                    ": another run is writing here; wait for it or give another directory");
}

DirectoryLock::~DirectoryLock() {
  ::close(descriptor_);
}

NewFiles::NewFiles(fs::path directory) : directory_(std::move(directory)) {
  std::error_code error;
  for (fs::path folder = directory_; !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path())
    made_ = folder;
  for (const auto& entry : fs::directory_iterator(directory_, error)) before_.insert(entry.path());
}

void NewFiles::remove() const {
  std::error_code error;  // what cannot be removed stays
  if (!made_.empty()) fs::remove_all(made_, error);
  std::set<fs::path> now;
  for (const auto& entry : fs::directory_iterator(directory_, error)) now.insert(entry.path());
  for (const fs::path& path : now)
    if (!before_.contains(path)) fs::remove_all(path, error);
}

}  // namespace tlsph
