#pragma once
/// \file
/// A run of rows, plain enough for sources that are compiled for one instruction set alone.

namespace tlsph {

inline constexpr int no_stencil = -1;

/// Consecutive rows with one stencil, or none.
struct RowRun {
  int first = 0;
  int count = 0;
  int column = 0;  ///< of the first row's first entry; with a stencil only
  int stencil = no_stencil;
};

}  // namespace tlsph
