#pragma once
/// \file
/// Loops over rows, shared among threads where that pays. They take nothing from the heap but when
/// the first of them starts the threads; bodies must not throw.

#include <omp.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "tlsph/core/team.hpp"
#include "tlsph/core/types.hpp"

namespace tlsph {

/// Below this many rows a second thread costs more than it brings.
inline constexpr Index parallel_rows = 2000;

[[nodiscard]] inline bool worth_threads(Index rows) {
  return rows >= parallel_rows && omp_get_max_threads() > 1;
}

/// Parts of a loop for each thread: a thread that is held up leaves some of its own to others.
inline constexpr int parts_a_thread = 4;

/// range(part, first, last) for so many parts of the rows; each must write to places of its own.
template <class Range>
void for_ranges(Index rows, int parts, const Range& range) {
  static TeamChoice choice;  // one for every loop of the program
  in_parts(choice, static_cast<double>(rows), worth_threads(rows) ? omp_get_max_threads() : 1,
           parts, [&](int part) { range(part, rows * part / parts, rows * (part + 1) / parts); });
}

/// body(row) for every row; each must write to places of its own.
template <class Body>
void for_rows(Index rows, const Body& body) {
  const int parts = worth_threads(rows) ? parts_a_thread * omp_get_max_threads() : 1;
  for_ranges(rows, parts, [&](int, Index first, Index last) {
    for (Index row = first; row < last; ++row) body(row);
  });
}

/// Σ term(row); the order of summation does not depend on the number of threads.
template <class Term>
[[nodiscard]] double sum_rows(Index rows, const Term& term) {
  std::array<double, 64> sums{};
  const int parts = rows < parallel_rows ? 1 : static_cast<int>(sums.size());
  for_ranges(rows, parts, [&](int part, Index first, Index last) {
    double sum = 0.0;
    for (Index row = first; row < last; ++row) sum += term(row);
    sums[static_cast<std::size_t>(part)] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace tlsph
