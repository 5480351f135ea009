#pragma once
/// \file
/// Fields of consecutive rows by direction, and passes over a body in blocks of rows whose fields
/// never leave the cache.

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "plan.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph::sweep {

/// One interleaved array a direction, with room for what loops overrun. Rows `base` … stand at the
/// start.
template <int D>
class Fields {
 public:
  Fields() = default;
  Fields(int directions, Index rows, Index first = 0)
      : base(first),
        values_(static_cast<std::size_t>(directions),
                std::vector<double>(static_cast<std::size_t>(rows * D + overrun), 0.0)) {
    for (auto& values : values_) direction_.push_back(values.data());
  }
  Fields(Fields&&) noexcept = default;
  Fields& operator=(Fields&&) noexcept = default;

  Index base = 0;
  [[nodiscard]] double* const* directions() const { return direction_.data(); }
  [[nodiscard]] Window window() const { return {directions(), base}; }
  /// The components of a row in a direction.
  [[nodiscard]] double* at(Index row, int direction = 0) const {
    return direction_[static_cast<std::size_t>(direction)] + (row - base) * D;
  }
  /// The first D directions from a row on.
  [[nodiscard]] std::array<double*, D> from(Index row) const {
    std::array<double*, D> result;
    for (int a = 0; a < D; ++a) result[static_cast<std::size_t>(a)] = at(row, a);
    return result;
  }

  /// Rows [first, last) stay, at the start from now on.
  void shift(Index first, Index last) {
    for (int a = 0; a < count(); ++a) std::memmove(at(base, a), at(first, a), bytes(last - first));
    base = first;
  }
  void copy_from(const Fields& other, Index first, Index last) {
    for (int a = 0; a < count(); ++a)
      std::memcpy(at(first, a), other.at(first, a), bytes(last - first));
  }
  /// Rows [first, last) of a tensor field, from it and into it.
  void read(const TensorField<D>& field, Index first, Index last) {
    each(first, last, [&](Index k, double& here) { here = field.data()[k]; });
  }
  void write(TensorField<D>& field, Index first, Index last) const {
    each(first, last, [&](Index k, double here) { field.data()[k] = here; });
  }

 private:
  template <class Act>
  void each(Index first, Index last, const Act& act) const {
    for (Index s = first; s < last; ++s)
      for (int i = 0; i < D; ++i)
        for (int a = 0; a < D; ++a) act((s * D + i) * D + a, at(s, a)[i]);
  }
  [[nodiscard]] int count() const { return static_cast<int>(direction_.size()); }
  [[nodiscard]] static std::size_t bytes(Index rows) {
    return static_cast<std::size_t>(rows * D) * sizeof(double);
  }

  std::vector<std::vector<double>> values_;
  std::vector<double*> direction_;
};

/// The rows of an operator in blocks.
class Blocks {
 public:
  /// `runs` of so many rows; empty where no operator is applied.
  Blocks(const std::vector<RowRun>& runs, Index rows)
      : rows_(rows), blocks_((rows + block_rows - 1) / block_rows) {
    for (Index b = 0; b < blocks_; ++b)
      start_.push_back(append_runs(runs, first(b), first(b + 1), runs_));
    start_.push_back(static_cast<Index>(runs_.size()));
  }

  /// visit(first row, last row, its runs) for the blocks of one of so many parts.
  template <class Visit>
  void for_part(int part, int parts, const Visit& visit) const {
    for (Index b = blocks_ * part / parts; b < blocks_ * (part + 1) / parts; ++b) {
      const Index* start = start_.data() + b;
      visit(first(b), first(b + 1), Runs{runs_.data() + start[0], start[1] - start[0]});
    }
  }

 private:
  [[nodiscard]] Index first(Index block) const { return std::min(block * block_rows, rows_); }

  Index rows_, blocks_;
  std::vector<RowRun> runs_;
  std::vector<Index> start_;  // in the runs, of every block, and one more
};

}  // namespace tlsph::sweep
