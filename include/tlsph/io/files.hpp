#pragma once
/// \file
/// Directories and files as a whole: made, locked, written aside and renamed. A reader never sees
/// half of a file written here, and a full disk is told, never lost. Every failure is an
/// OutputError that names the file and what the system said.

#include <cstddef>
#include <filesystem>
#include <set>
#include <string_view>

#include "tlsph/core/error.hpp"

namespace tlsph {

/// Makes `directory` with its parents and proves, by writing one, that files can be written in it.
void make_output_directory(const std::filesystem::path& directory);

/// Whether a finished file must survive the machine's power or only the program's end.
enum class Durability { program, machine };

/// A file that appears under its name only when it is complete: written beside it as `<name>.tmp`,
/// renamed by `commit`. What stood there before stays until then; without `commit` it stays for
/// good.
class AsideFile {
 public:
  explicit AsideFile(std::filesystem::path target);
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;
  ~AsideFile();

  void write(const void* bytes, std::size_t count);
  void write(std::string_view text) { write(text.data(), text.size()); }
  /// Closes and renames; with Durability::machine file and directory are on the disk on return.
  void commit(Durability durability = Durability::program);

 private:
  std::filesystem::path target_, aside_;
  int descriptor_ = -1;
};

/// Replaces the file `path` by `text`, whole or not at all.
void write_text_file(const std::filesystem::path& path, std::string_view text,
                     Durability durability = Durability::program);

/// Keeps a second run out of an output directory while this object lives. The lock dies with the
/// process, however that ends, and leaves no file behind. Throws OutputError if another holds it.
class DirectoryLock {
 public:
  explicit DirectoryLock(const std::filesystem::path& directory);
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;
  ~DirectoryLock();

 private:
  int descriptor_ = -1;
};

/// What comes into a directory, made with its parents if need be, from here on: a study that finds
/// its input impossible after its first runs leaves nothing behind.
class NewFiles {
 public:
  explicit NewFiles(std::filesystem::path directory);
  /// Removes all that was not there at first.
  void remove() const;

 private:
  std::filesystem::path directory_, made_;  // made: the uppermost folder that was not there
  std::set<std::filesystem::path> before_;
};

/// What `work` returns; an InputError of its removes what came into the directory.
template <class Work>
auto removed_if_refused(const std::filesystem::path& directory, const Work& work) {
  const NewFiles made(directory);
  try {
    return work();
  } catch (const InputError&) {
    made.remove();
    throw;
  }
}

}  // namespace tlsph
