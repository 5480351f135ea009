#pragma once
/// \file
/// What must hold between the keys of a scene: which formulation takes which options, which
/// conditions contradict each other, where an exact solution applies.

#include "schema.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Options that the formulation, dimension or shape does not take.
void check_formulation(const Scene& scene, const TableView& root);
/// Probes inside the body, material regions that touch it, steps within the run.
void check_positions(const Scene& scene);
/// At most one condition for each component of each patch.
void check_boundaries(const Scene& scene);
/// Named initial fields and the exact solution against shape, conditions and loads.
void check_exact(const Scene& scene);

/// The box of an interval or box body; nullptr for other shapes.
template <int D>
[[nodiscard]] inline const Box<D>* box_of(const Scene& scene) {
  const auto* shape = std::get_if<Shape<D>>(&scene.body.shape);
  return shape ? std::get_if<Box<D>>(&shape->form) : nullptr;
}

/// An interval or a box, whose patches are the axis-aligned left, right, top and bottom.
[[nodiscard]] inline bool is_box(const Scene& scene) {
  return box_of<1>(scene) || box_of<2>(scene);
}

}  // namespace tlsph
