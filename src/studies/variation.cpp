// Keys of a scene and the values they take in turn.
#include <fmt/format.h>

#include <algorithm>

#include "tlsph/core/error.hpp"
#include "tlsph/studies/converge.hpp"

namespace tlsph {

Variation parse_variation(const std::string& text) {
  const Place place{"--over " + text, 0, 0, ""};
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(place, "a comparison is key=a,b,…, e.g. kernel.support=2.1,2.6");
  Variation variation{text.substr(0, equals), {""}};
  int depth = 0;
  char quote = 0;
  for (std::size_t k = equals + 1; k < text.size(); ++k) {
    const char c = text[k];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      variation.values.emplace_back();
      continue;
    }
    variation.values.back() += c;
  }
  for (auto value = variation.values.begin(); value != variation.values.end(); ++value) {
    if (value->empty()) throw InputError(place, "a value is missing");
    if (std::find(variation.values.begin(), value, *value) != value)
      throw InputError(place, fmt::format("{} stands twice; each once", *value));
  }
  return variation;
}

}  // namespace tlsph
