#pragma once
/// \file
/// The inner loops of a sweep (tlsph/sweep/sweep.hpp), compiled once an instruction set and
/// picked when the program starts. Plain arrays only: a source that is compiled for AVX-512 must
/// not instantiate anything that the rest of the program might link to.
///
/// Fields of a body are interleaved as everywhere, x_q = (x_1 … x_D). What lives at material points
/// is kept by direction, one interleaved array a derivative: H_a = ∂u/∂X_a at out[a], and P_a
/// likewise, so that every product is a sum of shifted arrays, vectorised across rows and
/// components alike.

#include <cstddef>

#include "tlsph/materials/law_list.hpp"
#include "tlsph/operators/row_run.hpp"

namespace tlsph {
enum class Instructions;  // tlsph/sweep/sweep.hpp
}

namespace tlsph::sweep {

using Index = std::ptrdiff_t;  // tlsph::Index, without its header

/// The weights of an operator's rows: of its stencils, and of the rows without one (found by row).
struct RowWeights {
  const int* stencil_start = nullptr;
  const int* offset = nullptr;
  const double* stencil_weight = nullptr;
  const int* reach = nullptr;
  const int* mixed = nullptr;  ///< of blocks: entries of a stencil, its first, that mix components
  const Index* row_start = nullptr;
  const int* column = nullptr;
  const double* weight = nullptr;        ///< of general rows, or
  const float* weight_single = nullptr;  ///< these
  const double* row_scale = nullptr;     ///< factor of a general row, where there is one
};

/// Consecutive runs, cut to the rows wanted.
struct Runs {
  const RowRun* run = nullptr;
  Index count = 0;
};

/// One row, wherever it is stored: entry k stands at column origin + index[k].
template <class Weight>
struct Row {
  const int* index;
  const Weight* weight;  ///< as many an entry as there are directions
  Index entries;
  Index origin;
  double scale;  ///< of the row's products, where they are scaled
};

template <class Weight>
[[gnu::always_inline]] inline Row<Weight> general_row(const RowWeights& table,
                                                      const Weight* weights, int directions,
                                                      Index row) {
  const Index start = table.row_start[row];
  return {table.column + start, weights + start * directions, table.row_start[row + 1] - start, 0,
          table.row_scale != nullptr ? table.row_scale[row] : 1.0};
}

[[gnu::always_inline]] inline Row<double> stencil_row(const RowWeights& table, int directions,
                                                      const RowRun& run, Index row) {
  const Index start = table.stencil_start[run.stencil];
  return {table.offset + start, table.stencil_weight + start * directions,
          table.stencil_start[run.stencil + 1] - start, run.column + (row - run.first), 1.0};
}

/// Rows `base` … stand at the start of the arrays.
struct Window {
  double* const* direction = nullptr;
  Index base = 0;
};

/// Weights of an entry of a stiffness (stiffness.hpp), a block: D of its diagonal, and in 2D what
/// each component gives to the other.
template <int D>
inline constexpr int block_weights = D* D;

/// What makes velocities and places of accelerations; arrays of the whole body.
struct Motion {
  double kick = 0.0, dt = 0.0;
  double* v = nullptr;
  double* u = nullptr;
  const double* rows = nullptr;  ///< to be taken off the acceleration from row `rows_base` on
  Index rows_base = 0;
  double body_force[2] = {0.0, 0.0};  ///< acceleration
};

/// Overruns: loops write up to `overrun` doubles beyond the last row of their output, which must
/// have room for them, and read as far beyond the inputs that are windows.
inline constexpr Index overrun = 32;

/// The inner loops of a law. Each takes the law's text (tlsph/materials/law.hpp) first.
struct LawLoops {
  /// H of `count` points becomes P, in place. False where det F ≤ 0 or a stress is not finite.
  bool (*stress)(const void* law, double* const* field, Index first, Index count);
  /// H = G u and P of rows, by `modes`; out holds P and, with modes, their rows. False as above.
  bool (*points[2])(const void* law, const RowWeights&, Runs, const double* u, Index size,
                    Window out);
  /// dP = ∂P/∂F : dH of `count` points.
  void (*tangent)(const void* law, const double* const* H, const double* const* dH,
                  double* const* dP, Index count);
  /// max λ_max(∂P/∂F at H − ∂P/∂F at `before`) of `count` points, at most that [Pa]; zero if no
  /// eigenvalue is positive.
  double (*stiffening)(const void* law, const double* const* H, const float* const* before,
                       Index count);
};

/// The inner loops of G and D.
struct Products {
  /// out_a[row] = Σ_k w^a_k u[column_k]; `size` doubles in u.
  void (*gradient)(const RowWeights&, Runs, const double* u, Index size, Window out);
  /// out[row] = Σ_a Σ_k w^a_k P_a[column_k].
  void (*divergence)(const RowWeights&, Runs, Window P, double* out, Index out_base);
  /// The same for accelerations that move their rows: v += kick a, u += dt v; the largest |v|.
  double (*move)(const RowWeights&, Runs, Window P, const Motion&);
};

template <int D>
struct Loops {
  Products products[2];  ///< by `modes`: of D directions, and of those and one more
  /// out[row] = Σ_k w_k (x[column_k] − x[row]).
  void (*differences)(const RowWeights&, Runs, const double* x, Index size, double* out,
                      Index out_base);
  LawLoops laws[laws::Listed<D>::size];  ///< in the order of the list
  /// max ‖H − H₀‖² ‖F⁻¹‖² of `count` points, H₀ = `before`.
  double (*deformation)(const double* const* H, const float* const* before, Index count);
  /// `count` rounds of independent fused multiply-adds on registers. Returns their number; `sum`
  /// keeps the compiler from removing the loop.
  Index (*multiply_adds)(Index count, double& sum);
  /// a −= r.
  void (*subtract)(Index size, const double* r, double* a);
  /// out[row] = Σ_k B_k (u[row + offset_k] − u[row]) + body force of the rows of some runs, then of
  /// patches in them; false where one is not finite.
  bool (*accelerations)(const RowWeights&, Runs, Runs patches, const double* u, Index size,
                        const double* body_force, double* out, Index out_base);
  /// As `move`, of rows whose accelerations are those of `Motion::rows`.
  double (*move_on)(Runs, const Motion&);
};

/// Those for a set of instructions that is `available`.
template <int D>
[[nodiscard]] const Loops<D>& loops(Instructions instructions);

// One source each.
template <int D>
[[nodiscard]] const Loops<D>& baseline_loops();
template <int D>
[[nodiscard]] const Loops<D>& avx2_loops();
template <int D>
[[nodiscard]] const Loops<D>& avx512_loops();

}  // namespace tlsph::sweep
