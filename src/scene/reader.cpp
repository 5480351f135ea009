#include "tlsph/scene/reader.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "keys.hpp"
#include "rules.hpp"
#include "tlsph/scene/edit.hpp"

namespace tlsph {
namespace {

std::string read_file(const std::filesystem::path& file) {
  const Place place{file.string(), 0, 0, ""};
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError(place, "no such file");
  if (status.type() == std::filesystem::file_type::directory)
    throw InputError(place, "a directory, not a scene file");
  std::ifstream stream(file, std::ios::binary);
  // Far above any scene; below what a device or a data file would pour in.
  constexpr std::size_t limit = std::size_t{16} << 20U;
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16U);
  while (stream && text.size() <= limit) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad() || (!stream.eof() && text.size() <= limit))
    throw InputError(place, "cannot be read; check its permissions");
  if (text.size() > limit) throw InputError(place, "larger than 16 MiB: not a scene file");
  return text;
}

/// Where the nodes of a printed scene stand that came from no file: at their path.
void place_nodes(Node& node, const std::string& path, const std::string& file) {
  node.path = path;
  if (node.place.file.empty()) node.place = {file, 0, 0, path};
  if (auto* entries = node.table())
    for (Entry& entry : *entries) {
      const std::string below = join_path(path, entry.name);
      entry.place = {file, 0, 0, below};
      place_nodes(entry.value, below, file);
    }
  if (auto* items = node.list())
    for (std::size_t k = 0; k < items->size(); ++k)
      place_nodes((*items)[k], fmt::format("{}[{}]", path, k), file);
}

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

Node document_of(const Scene& scene, Printed printed) {
  Node document = print_table(scene, scene_keys(), scene, printed);
  place_nodes(document, "", scene.file);
  return document;
}

Scene read_document(const Node& document) {
  check_document(document);
  const TableView root(document);
  Scene scene;
  read_table(scene, root, scene_keys(), scene);
  check_formulation(scene, root);
  check_positions(scene);
  check_boundaries(scene);
  check_exact(scene);
  return scene;
}

}  // namespace

Scene read_scene_text(const std::string& text, const std::string& name,
                      const std::vector<std::string>& overrides) {
  Node document = parse_document(text, name);
  if (document.table()->empty() && overrides.empty())
    throw InputError(document.place, "empty: a scene has at least [body], [material] and [time]");
  for (const auto& change : overrides) apply_override(document, change);
  Scene scene = read_document(document);
  scene.file = name;
  scene.text = overrides.empty() ? text : print_document(document);
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_scene_text(read_file(file), file.string(), overrides);
}

std::string print_scene(const Scene& scene, Printed keys) {
  return print_document(document_of(scene, keys));
}

Scene completed(const Scene& edited) {
  const Node document = document_of(edited, Printed::given);
  Scene scene = read_document(document);
  scene.file = edited.file;
  scene.text = print_document(document);
  return scene;
}

Place place_of(const Scene& scene, const std::string& key) {
  Place place{scene.file, 1, 1, key};
  try {
    const Node document = parse_document(read_file(scene.file), scene.file);
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
