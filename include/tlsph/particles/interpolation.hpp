#pragma once
/// \file
/// Values between particles, exact for linear fields.

#include <vector>

#include "tlsph/core/types.hpp"

namespace tlsph {

/// f(x) ≈ Σ weight · f(node).
struct InterpolationRow {
  std::vector<Index> node;
  std::vector<double> weight;
};

/// The row for position x [m] among nodes X (N×d): the node itself if one lies within 1e-6
/// `spacing`, else a linear moving-least-squares fit over the nodes around, as few layers of them
/// as determine it (so it extrapolates linearly just outside the cloud). Where all nodes around lie
/// on one line, as the stress points of a body one cell thick, linear along it and constant across.
/// InputError if neither does.
template <int D>
[[nodiscard]] InterpolationRow linear_interpolation(const VectorField<D>& X, const Vector<D>& x,
                                                    double spacing);

}  // namespace tlsph
