#pragma once
/// \file
/// What the writers of this room share below the C library's streams; not part of the interface.

#include <cstddef>
#include <filesystem>

namespace tlsph {

/// Throws OutputError "<path>: cannot <action>: <what the system says of `error`>".
[[noreturn]] void output_failed(const std::filesystem::path& path, const char* action, int error);

/// Writes all bytes or throws OutputError naming `path`.
void write_all(int descriptor, const void* bytes, std::size_t count,
               const std::filesystem::path& path);

/// Gives the finished file `aside` the name `target`, or removes it and throws OutputError.
void replace_file(const std::filesystem::path& aside, const std::filesystem::path& target);

}  // namespace tlsph
