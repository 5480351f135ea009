#pragma once
/// \file
/// Loops over rows, shared among threads where that pays. A parallel region takes memory from the
/// heap even if it has one thread only, so there is none unless there are more.

#include <omp.h>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// Below this many rows a second thread costs more than it brings.
inline constexpr Index parallel_rows = 2000;

[[nodiscard]] inline bool worth_threads(Index rows) {
  return rows >= parallel_rows && omp_get_max_threads() > 1;
}

/// body(row) for every row; each must write to places of its own.
template <class Body>
void for_rows(Index rows, const Body& body) {
  if (worth_threads(rows)) {
#pragma omp parallel for schedule(static)
    for (Index row = 0; row < rows; ++row) body(row);
  } else {
    for (Index row = 0; row < rows; ++row) body(row);
  }
}

/// Σ term(row); the order of summation follows the number of threads.
template <class Term>
[[nodiscard]] double sum_rows(Index rows, const Term& term) {
  double sum = 0.0;
  if (worth_threads(rows)) {
#pragma omp parallel for schedule(static) reduction(+ : sum)
    for (Index row = 0; row < rows; ++row) sum += term(row);
  } else {
    for (Index row = 0; row < rows; ++row) sum += term(row);
  }
  return sum;
}

}  // namespace tlsph
