#pragma once
/// \file
/// Histories at points of the body: what an instrument glued to a reference position would record.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tlsph/core/error.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/observe/quantity.hpp"
#include "tlsph/particles/interpolation.hpp"

namespace tlsph {

/// What a scene asks for: quantities by their names.
template <int D>
struct ProbeRequest {
  std::string name;
  Vector<D> at;  ///< reference position [m]
  std::vector<std::string> quantities;
  Place place = {};  ///< where its position is asked for
};

/// Evaluates probes by rows fixed at construction: the particle at the position if there is one,
/// else a first-order consistent interpolation (nodes for motion, material points for strain and
/// stress).
template <int D>
class Probes {
 public:
  /// InputError at the place of a request whose position cannot be interpolated to.
  Probes(const Discretisation<D>& discretisation, const std::vector<ProbeRequest<D>>& requests);

  /// `<probe>.<quantity>_<component>` for every value, in the order of `sample`.
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// Nodes and material points that `sample` looks at, each perhaps more than once.
  [[nodiscard]] std::vector<Index> nodes() const;
  [[nodiscard]] std::vector<Index> points() const;
  /// Values at t_n, one entry a column of `row`. Takes nothing from the heap.
  void sample(const Instant<D>& now, std::span<double> row) const;
  /// The columns of what an exact solution knows, and its values at a time [s].
  [[nodiscard]] std::vector<std::string> exact_columns() const;
  void sample_exact(const ExactSolution<D>& exact, double time, std::span<double> row) const;

 private:
  struct Probe {
    std::string name;
    Vector<D> at;
    InterpolationRow nodes, points;
    std::size_t region = 0;
    Index nearest = 0;  // material point
    std::vector<const Quantity<D>*> quantities;
  };
  std::vector<Probe> probes_;
  std::vector<std::string> columns_;
};

}  // namespace tlsph
