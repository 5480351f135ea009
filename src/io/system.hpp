#pragma once
/// \file
/// What this room shares below the streams of the C library; not part of the interface.

#include <cstddef>
#include <filesystem>
#include <functional>

namespace tlsph {

/// Throws OutputError "<path>: cannot <action>: <what the system says of `error`>".
[[noreturn]] void output_failed(const std::filesystem::path& path, const char* action, int error);

/// Writes all bytes or throws OutputError naming `path`.
void write_all(int descriptor, const void* bytes, std::size_t count,
               const std::filesystem::path& path);

/// Gives the finished file `aside` the name `target`, or removes it and throws OutputError.
void replace_file(const std::filesystem::path& aside, const std::filesystem::path& target);

/// Does `read`, which reads `file` and keeps nothing, in a child process. What it throws as
/// InputError is thrown here; so is the end of the process: the HDF5 library crashes, or never
/// comes back, on some files with damaged bytes.
void try_reading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace tlsph
