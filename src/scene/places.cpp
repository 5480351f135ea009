#include "tlsph/scene/places.hpp"

#include <fstream>
#include <iterator>

#include "document.hpp"

namespace tlsph {
namespace {

/// The node of that path at or below `node`, nullptr if there is none.
const Node* find_path(const Node& node, const std::string& path) {
  if (node.path == path) return &node;
  const Node* found = nullptr;
  if (const auto* entries = node.table())
    for (const Entry& entry : *entries)
      if (found == nullptr) found = find_path(entry.value, path);
  if (const auto* items = node.list())
    for (const Node& item : *items)
      if (found == nullptr) found = find_path(item, path);
  return found;
}

}  // namespace

Place place_of(const Scene& scene, const std::string& key) {
  std::ifstream file(scene.file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Place place{scene.file, 1, 1, key};
  try {
    const Node document = parse_document(text, scene.file);
    for (std::string path = key; !path.empty();) {
      if (const Node* node = find_path(document, path)) {
        place.line = node->place.line;
        place.column = node->place.column;
        break;
      }
      const std::size_t end = path.find_last_of(".[");
      path.resize(end == std::string::npos ? 0 : end);
    }
  } catch (const InputError&) {  // changed since it was read: its first line
  }
  return place;
}

}  // namespace tlsph
