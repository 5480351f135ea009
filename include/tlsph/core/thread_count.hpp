#pragma once
/// \file
/// The number of threads for a while.

#include <omp.h>

namespace tlsph {

/// Sets the number of OpenMP's threads and, when it goes, what it was before.
class ThreadCount {
 public:
  explicit ThreadCount(int count) { omp_set_num_threads(count); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;
  ~ThreadCount() { omp_set_num_threads(before_); }
  [[nodiscard]] int before() const { return before_; }

 private:
  int before_ = omp_get_max_threads();
};

}  // namespace tlsph
