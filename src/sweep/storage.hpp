#pragma once
/// \file
/// The operators of a discretisation as a sweep reads them: equal rows once, those of D, S and C
/// over the mass, a cell stabiliser as one direction more.

#include <memory>
#include <span>
#include <vector>

#include "loops.hpp"
#include "plan.hpp"
#include "tlsph/formulations/discretisation.hpp"
#include "tlsph/operators/row_storage.hpp"

namespace tlsph::sweep {

template <int D>
class Storage {
 public:
  /// `single`: weights of rows without a stencil in single precision. The discretisation must
  /// outlive the storage.
  Storage(const Discretisation<D>& discretisation, bool single);
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;
  ~Storage() = default;

  RowWeights gradient_table, divergence_table, rows_table;
  bool modes = false;     ///< A u is a direction of G, −Aᵀκ one of D
  bool viscous = false;   ///< the rows are those of C, else of S
  bool has_rows = false;  ///< there is one of them
  RowStorage gradient, divergence, rows;
  ScalarField inverse_mass;
  StorageReport report;

  /// Which rows read which nodes and points.
  [[nodiscard]] Dependences dependences() const;

 private:
  /// The general rows of an operator that has them, into its table.
  struct General {
    std::unique_ptr<double[]> weight;  // where modes are a direction of them
    std::unique_ptr<float[]> single;
  };
  static General general_rows(const RowStorage& rows, const VectorOperator<D>& op,
                              std::span<const double> modes, bool single, RowWeights& table);
  [[nodiscard]] std::vector<double> mode_forces() const;
  void add_rows();
  void add(const StorageReport& other);

  const Discretisation<D>& disc_;
  General general_gradient_, general_divergence_;
  Neighbours rows_pattern_;
};

}  // namespace tlsph::sweep
