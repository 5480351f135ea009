#pragma once
/// \file
/// Errors of rooms that know no scene, told with their place in it.

#include <algorithm>
#include <new>
#include <regex>
#include <string>

#include "tlsph/scene/reader.hpp"

namespace tlsph {

/// The error with a place: its own (`file:line:column: ` or `--set …: `), else that of the key its
/// message begins with, of the body if with none.
[[nodiscard]] inline InputError placed(const InputError& error, const Scene& scene) {
  const std::string text = error.what();
  if (text.starts_with("--set ") || std::regex_search(text, std::regex("^[^\n]*?:\\d+:\\d+: ")))
    return error;
  const std::size_t colon = std::min(text.find(": "), text.size());
  const bool named = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_.[]0123456789") == colon;
  return named ? InputError(place_of(scene, text.substr(0, colon)), text.substr(colon + 2))
               : InputError(place_of(scene, "body"), text);
}

/// What `work`, which builds something of the scene, returns; its InputErrors are placed, and a
/// lack of memory is one, at what sizes the body.
template <class Work>
auto in_scene(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw placed(error, scene);
  } catch (const std::bad_alloc&) {
    const bool lattice = scene.body.cloud.empty();
    throw InputError(
        place_of(scene, lattice ? "body.spacing" : "body.cloud"),
        lattice ? "out of memory; choose a larger spacing" : "out of memory; choose fewer points");
  }
}

}  // namespace tlsph
