#pragma once
/// \file
/// What a step costs, beside what the machine could do: nanoseconds per particle and step of a
/// sweep and of the plain way (sparse products of Eigen, a law, an update), and the share of the
/// limit that binds, memory or arithmetic, both measured in the same run.

#include <functional>
#include <string>
#include <vector>

#include "tlsph/analysis/not_known.hpp"
#include "tlsph/core/types.hpp"
#include "tlsph/operators/row_storage.hpp"
#include "tlsph/studies/study.hpp"

namespace tlsph {

struct BenchmarkRow {
  std::string name;
  Index particles = 0;
  double neighbours = 0.0;  ///< entries of a row of G, mean
  int threads = 1;
  StorageReport storage;
  double ns = 0.0;  ///< CPU time of a thread per particle and step, the fastest of several batches
  double spread = 0.0;  ///< median over fastest, minus one
  /// Of the plain way on one thread; not a number where it was not measured.
  double plain_ns = not_known;
  double bytes = 0.0;          ///< per particle and step that must come from and go to memory
  double multiply_adds = 0.0;  ///< per particle and step
  double memory_ns = 0.0, arithmetic_ns = 0.0;  ///< what the machine would need for either

  /// The part of the time that the binding limit explains.
  [[nodiscard]] double share() const;
  [[nodiscard]] bool memory_binds() const { return memory_ns >= arithmetic_ns; }
};

struct BenchmarkTable {
  double triad_bytes_per_second = 0.0;  ///< a = b + s c, three arrays, one thread
  double multiply_adds_per_second = 0.0;
  std::string instructions;
  int cores = 1;
  std::vector<BenchmarkRow> rows;
  bool interrupted = false;

  /// What `tlsph benchmark` prints.
  [[nodiscard]] std::string text() const;
  /// benchmark.csv and benchmark.json.
  void write(const std::filesystem::path& directory) const;
};

/// Without `out` nothing is written.
struct BenchmarkOptions : StudyOptions {
  Index particles = 500'000;  ///< of the large bodies, about
  double seconds = 0.3;       ///< of a batch of steps
  std::function<void(const std::string&)> before_case;
};

[[nodiscard]] BenchmarkTable benchmark(const BenchmarkOptions& options);

}  // namespace tlsph
