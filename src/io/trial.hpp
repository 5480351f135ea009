#pragma once
/// \file
/// Files that a library may not survive, tried in a process of its own. Not part of the interface.

#include <filesystem>
#include <functional>

namespace tlsph {

/// Does `read`, which reads `file` and keeps nothing, in a child process. What it throws as
/// InputError is thrown here; so is the end of the process: the HDF5 library crashes, or never
/// comes back, on some files with damaged bytes.
void try_reading(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace tlsph
