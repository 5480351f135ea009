#pragma once
/// \file
/// From a scene file to a Scene: the only door to TOML. Everything that can be judged without
/// building particles is judged here, and every refusal is an InputError that says `file:line:col:
/// key: what is wrong, what is allowed`.

#include <filesystem>
#include <string>
#include <vector>

#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// Reads the file and applies the overrides, each `key=value` with a dotted path and lists by index
/// (`boundary[0].traction.amplitude=-2e5`); the value is read as TOML, else as a plain string. Keys
/// the file does not have may be set; keys no scene has are refused.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file,
                               const std::vector<std::string>& overrides = {});

/// The same from a text; `name` is how messages call it.
[[nodiscard]] Scene read_scene_text(const std::string& text, const std::string& name,
                                    const std::vector<std::string>& overrides = {});

/// For errors that only show when the body is built: where `key` stands in the scene's file; of one
/// that is not there, where the table around it does.
[[nodiscard]] Place place_of(const Scene& scene, const std::string& key);

/// Every key of a scene: type, unit, default, range and one line on what it does.
[[nodiscard]] std::string scene_reference();

}  // namespace tlsph
