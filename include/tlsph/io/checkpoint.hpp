#pragma once
/// \file
/// The state of a run from which it goes on bit for bit: named arrays, integers and texts. Written
/// aside, put on the disk, then renamed: the checkpoint under its name is always a whole one.
///
/// File: the 8 bytes "TLSPHCKP", the version as a 64-bit integer in the machine's order, the counts
/// and entries (lengths as 64-bit integers, doubles as their bytes), a 64-bit check sum of all
/// that. It is read on the kind of machine that wrote it.

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace tlsph {

template <class Array>
struct CheckpointEntries {
  std::map<std::string, Array> arrays;
  std::map<std::string, std::int64_t> integers;
  std::map<std::string, std::string> texts;
};

/// A checkpoint to be written, on arrays that the caller keeps alive.
using CheckpointView = CheckpointEntries<std::span<const double>>;

/// A checkpoint as read.
struct Checkpoint : CheckpointEntries<std::vector<double>> {
  std::filesystem::path path;  ///< where it came from

  /// The array of that name; InputError if it is missing.
  [[nodiscard]] const std::vector<double>& array(const std::string& name) const;
  /// The same, and InputError if it has not `size` values.
  [[nodiscard]] const std::vector<double>& array(const std::string& name, std::size_t size) const;
  /// The one value of an array; InputError if it is missing.
  [[nodiscard]] double number(const std::string& name) const { return array(name, 1)[0]; }
  /// InputError if it is missing.
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] const std::string& text(const std::string& name) const;
};

/// Replaces the checkpoint at `path`; on failure (OutputError) the old one stays.
void write_checkpoint(const std::filesystem::path& path, const CheckpointView& checkpoint);

/// Throws InputError if the file is missing, no checkpoint, of another version or kind of machine,
/// torn or altered.
Checkpoint read_checkpoint(const std::filesystem::path& path);

}  // namespace tlsph
