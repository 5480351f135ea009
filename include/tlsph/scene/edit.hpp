#pragma once
/// \file
/// Scenes changed by a program: copy one, set its members, complete it.
///
///     Scene finer = scene;
///     finer.body.spacing = 0.5 * scene.body.spacing;
///     finer = completed(finer);

#include <string>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Which keys are printed: those that a scene gives, or those too that have their default.
enum class Printed { given, all };

/// The scene as TOML text that reads back to an equal one, its keys in the order of the reference.
/// The only text that is not read back to the bit are loads by a table whose components differ: to
/// rounding.
[[nodiscard]] std::string print_scene(const Scene& scene, Printed keys = Printed::given);

/// The scene as if it had been read: defaults follow the keys they depend on, `text` is the scene
/// printed. What a new value contradicts is refused as in a file, by InputError. Places are those
/// of the file the scene was read from, as far as they are kept.
[[nodiscard]] Scene completed(const Scene& edited);

}  // namespace tlsph
