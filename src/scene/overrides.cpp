#include "overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "schema.hpp"

namespace tlsph {
namespace {

/// Steps to any key of a scene are fewer.
constexpr std::size_t most_steps = 16;

/// One step of a path: a name in a table, or an index in a list.
struct Step {
  std::string name;
  std::optional<std::size_t> index;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// `boundary[0].traction` → boundary, 0, traction.
std::vector<Step> split_path(const std::string& path, const Place& place) {
  const InputError malformed(place,
                             "the path is names joined by dots, lists by index: a.b[0].c=value");
  std::vector<Step> steps;
  std::size_t i = 0;
  while (i < path.size()) {
    if (path[i] == '[') {
      const auto close = path.find(']', i);
      if (close == std::string::npos || close == i + 1 || close - i > 9 || steps.empty())
        throw malformed;
      const std::string digits = path.substr(i + 1, close - i - 1);
      if (!std::all_of(digits.begin(), digits.end(),
                       [](unsigned char c) { return std::isdigit(c); }))
        throw malformed;
      steps.push_back({"", static_cast<std::size_t>(std::stoul(digits))});
      i = close + 1;
      if (i < path.size() && path[i] == '.') {
        if (++i == path.size()) throw malformed;
      } else if (i < path.size() && path[i] != '[') {
        throw malformed;
      }
      continue;
    }
    const auto end = std::min(path.find_first_of(".[", i), path.size());
    if (end == i) throw malformed;
    steps.push_back({path.substr(i, end - i), std::nullopt});
    i = end;
    if (i < path.size() && path[i] == '.') {
      ++i;
      if (i == path.size() || path[i] == '.' || path[i] == '[') throw malformed;
    }
  }
  if (steps.empty() || steps.size() > most_steps) throw malformed;
  return steps;
}

/// The child a step names, created empty if it is not there yet.
Node& descend(Node& node, const Step& step, const Place& place) {
  const std::string path =
      step.index ? fmt::format("{}[{}]", node.path, *step.index) : join_path(node.path, step.name);
  // A node without value yet becomes what the path asks for.
  if (std::holds_alternative<Unsupported>(node.value)) {
    if (step.index)
      node.value = std::vector<Node>{};
    else
      node.value = std::vector<Entry>{};
  }
  const Place created{place.file, 0, 0, path};
  if (step.index) {
    auto* list = node.list();
    if (!list)
      throw InputError(place, fmt::format("{} is {}, not a list", node.path, describe(node)));
    if (*step.index > list->size())
      throw InputError(place, fmt::format("{} has {} entries; the next index is {}", node.path,
                                          list->size(), list->size()));
    if (*step.index == list->size()) list->push_back(Node{Unsupported{}, created, path});
    return (*list)[*step.index];
  }
  auto* entries = node.table();
  if (!entries && node.list())
    throw InputError(place, fmt::format("{} is a list: say which entry, {}[0].{}", node.path,
                                        node.path, step.name));
  if (!entries)
    throw InputError(place, fmt::format("{} is {}, not a table: set it as a whole, "
                                        "{}={{ … }}",
                                        node.path, describe(node), node.path));
  if (Node* child = node.find(step.name)) return *child;
  entries->push_back(Entry{step.name, created, Node{Unsupported{}, created, path}});
  return entries->back().value;
}

}  // namespace

void apply_override(Node& root, const std::string& override_text) {
  const Place place{"--set " + override_text, 0, 0, ""};
  const auto equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError(place, "an override is key=value, e.g. body.spacing=1e-3");
  const auto steps = split_path(trimmed(override_text.substr(0, equals)), place);
  const std::string text = trimmed(override_text.substr(equals + 1));

  Node* node = &root;
  for (const Step& step : steps) {
    Node* parent = node;
    node = &descend(*parent, step, place);
    // An unknown name is reported where it stands: in the override.
    if (!step.index)
      for (Entry& entry : *parent->table())
        if (&entry.value == node && entry.place.file == place.file && &step == &steps.back())
          entry.place.key.clear();
  }
  const std::string path = node->path;
  *node = parse_value(text, place, path).value_or(Node{text, place, path});
}

}  // namespace tlsph
