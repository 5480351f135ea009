#pragma once
/// \file
/// Scenes written by a program: keys taken out of a scene's text, others put in.

#include <string>
#include <vector>

namespace tlsph {

/// The text with the keys `removed` taken out, one after the other, and then the overrides applied,
/// as TOML; comments and layout are lost. Paths are those of an override; one that leads nowhere is
/// no error. Of entries of a list take the last first: those behind one move up. `name` is how
/// messages call the text. InputError for what is no TOML or no path; whether the result is a scene
/// is for the reader to say.
[[nodiscard]] std::string edit_scene_text(const std::string& text, const std::string& name,
                                          const std::vector<std::string>& removed,
                                          const std::vector<std::string>& overrides);

}  // namespace tlsph
