#include "tlsph/io/new_files.hpp"

#include <system_error>
#include <utility>

namespace tlsph {
namespace fs = std::filesystem;

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
