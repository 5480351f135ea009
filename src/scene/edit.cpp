#include "tlsph/scene/edit.hpp"

#include "document.hpp"
#include "overrides.hpp"

namespace tlsph {

std::string edit_scene_text(const std::string& text, const std::string& name,
                            const std::vector<std::string>& removed,
                            const std::vector<std::string>& overrides) {
  Node document = parse_document(text, name);
  for (const std::string& path : removed) remove_key(document, path);
  for (const std::string& change : overrides) apply_override(document, change);
  return print_document(document);
}

}  // namespace tlsph
