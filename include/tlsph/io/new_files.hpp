#pragma once
/// \file
/// What a study leaves behind when it finds its input impossible after its first runs: nothing.

#include <filesystem>
#include <set>

#include "tlsph/core/error.hpp"

namespace tlsph {

/// What comes into a directory, made with its parents if need be, from here on.
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
