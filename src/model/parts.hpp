#pragma once
/// \file
/// The parts `build` is made of.

#include "tlsph/formulations/extension.hpp"
#include "tlsph/model/builder.hpp"

namespace tlsph::parts {

/// Laws and densities with the points they hold, and the masses of the nodes.
template <int D>
void add_materials(const Scene& scene, Discretisation<D>& body);

/// Constraints and loads from the scene's boundaries, and inverse masses.
template <int D>
void add_conditions(const Scene& scene, Discretisation<D>& body);

/// The edges of a box as `mirror` and `thesis` need them; adds their signals.
template <int D>
[[nodiscard]] Edges<D> build_edges(const Scene& scene, Discretisation<D>& body);

/// S or C of the scene's stabiliser.
template <int D>
void add_stabiliser(const Scene& scene, Discretisation<D>& body);

/// The material entry that rules at X: the last one whose box holds it, else the first, which has
/// no box.
template <int D>
[[nodiscard]] std::size_t material_at(const Scene& scene, const Vector<D>& X, double tolerance);

}  // namespace tlsph::parts
