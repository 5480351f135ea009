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

/// max(0, term(row) over all rows); a term that is not a number is left out.
template <class Term>
[[nodiscard]] double max_rows(Index rows, const Term& term) {
  double largest = 0.0;
  if (worth_threads(rows)) {
#pragma omp parallel for schedule(static) reduction(max : largest)
    for (Index row = 0; row < rows; ++row) {
      const double value = term(row);
      largest = value > largest ? value : largest;
    }
  } else {
    for (Index row = 0; row < rows; ++row) {
      const double value = term(row);
      largest = value > largest ? value : largest;
    }
  }
  return largest;
}

}  // namespace tlsph
