#pragma once
/// \file
/// What every study is given beside its request.

#include <atomic>
#include <filesystem>

namespace tlsph {

struct StudyOptions {
  std::filesystem::path out;  ///< directory of what it leaves
  const std::atomic<bool>* stop_requested = nullptr;

  [[nodiscard]] bool stopped() const { return stop_requested != nullptr && *stop_requested; }
};

}  // namespace tlsph
