#pragma once
/// \file
/// The body of one state: operators on the layout, uniformly stretched in the first direction.

#include <filesystem>
#include <string>
#include <vector>

#include "method.hpp"
#include "tlsph/dynamics/state.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// The scene of an atlas, read once: its file may change while hundreds of states are drawn.
struct Subject {
  Scene scene;  ///< small and bare
  int dimension = 2;
  bool box = true;                   ///< a full interval or box, whose edges can slide
  double spacing = 0.0;              ///< [m]
  std::vector<double> lower, upper;  ///< of the body [m]
  double poisson = 0.3, young = 1.0, density = 1.0;
};

/// Reads the scene, checks that an atlas can be drawn of it, and coarsens it to a few hundred
/// particles at the most.
[[nodiscard]] Subject read_subject(const std::filesystem::path& file,
                                   const std::vector<std::string>& overrides);

/// `sliding`: the normal displacement of each edge of a box is held at that of the stretch, so that
/// the uniform state of a material that carries waves is stable (van Hove; other shapes are held
/// all around). `free`: nothing is held.
enum class Support { sliding, free };

/// The edges of a box slide along themselves; the right one moves along x.
[[nodiscard]] std::vector<BoundaryScene> sliding_edges(int dimension, const Curve& right);

/// The scene of a state.
[[nodiscard]] Scene scene_of(const Subject& subject, const StateKey& key, Support support);

template <int D>
struct Specimen {
  Discretisation<D> disc;
  Tensor<D> H0 = Tensor<D>::Zero();  ///< the uniform displacement gradient
  State<D> state;                    ///< at rest at H0, evaluated
};
/// InputError where the operators cannot be built, NumericalError where the uniform state is none.
template <int D>
[[nodiscard]] Specimen<D> build_specimen(const Subject& subject, const StateKey& key,
                                         Support support);

}  // namespace tlsph
