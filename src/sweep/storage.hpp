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

/// The operators as the loops read them.
struct Operators {
  RowWeights gradient, divergence;
  RowWeights rows;     ///< of S or C; with `blocks`, of all that accelerations are made of
  bool modes = false;  ///< A u is a direction of G, −Aᵀκ one of D
  bool has_rows = false;
  bool viscous = false;  ///< the rows are those of C and act on velocities
  bool blocks = false;   ///< no point is needed
};

template <int D>
class Storage {
 public:
  /// `single`: weights of rows without a stencil in single precision. The discretisation must
  /// outlive the storage.
  Storage(const Discretisation<D>& discretisation, bool single);
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;
  ~Storage() = default;

  Operators tables;
  RowStorage gradient, divergence, rows;
  ScalarField inverse_mass;
  StorageReport report;

  /// The streams of a plan.
  [[nodiscard]] PlanInput plan_input() const;

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
  void add_report(const RowStorage& rows, const Neighbours& pattern);

  const Discretisation<D>& body_;
  General general_gradient_, general_divergence_;
  Neighbours rows_pattern_;
};

void set_stencils(RowWeights& table, const RowStorage& rows);

}  // namespace tlsph::sweep
