#pragma once
/// \file
/// What a study leaves behind when it finds its input impossible after its first runs: nothing.

#include <filesystem>
#include <set>

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

}  // namespace tlsph
