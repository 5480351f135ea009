#pragma once
/// \file
/// What every study is given beside its request.

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace tlsph {

struct StudyOptions {
  std::filesystem::path out;  ///< directory of the results
  const std::atomic<bool>* stop_requested = nullptr;
  /// Called several times a second with the current work and the share of the study that is done.
  std::function<void(const std::string& what, double share)> progress = {};

  [[nodiscard]] bool stopped() const { return stop_requested != nullptr && *stop_requested; }
};

}  // namespace tlsph
