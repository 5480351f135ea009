#pragma once
/// \file
/// The parts of a scene that choose its operators.

#include <optional>

#include "view.hpp"

namespace tlsph {

/// The degrees a gradient is corrected to; `true` means those that suit the formulation.
[[nodiscard]] std::optional<ConsistencyScene> read_consistency(const TableView& root,
                                                               Formulation formulation,
                                                               int dimension);

[[nodiscard]] KernelScene read_kernel(const TableView& view, Formulation formulation,
                                      const std::optional<ConsistencyScene>& consistency,
                                      int dimension);

/// After dimension, formulation and kernel of the scene.
[[nodiscard]] StabiliserScene read_stabiliser(const TableView& view, const Scene& scene);

}  // namespace tlsph
