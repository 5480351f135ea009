// Changes to a scene's tree by dotted path: `--set key=value`.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "schema.hpp"
#include "tlsph/core/text.hpp"

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
  const auto require = [&](bool well_formed) {
    if (!well_formed)
      throw InputError(place, "the path is names joined by dots, lists by index: a.b[0].c=value");
  };
  std::vector<Step> steps;
  for (std::string_view left : split(path, '.')) {
    const std::string_view name = left.substr(0, left.find('['));
    require(!name.empty());
    steps.push_back({std::string(name), std::nullopt});
    for (left.remove_prefix(name.size()); !left.empty();) {
      const std::size_t close = left.find(']');
      require(left[0] == '[' && close != std::string_view::npos && close > 1 && close < 10);
      const std::string digits(left.substr(1, close - 1));
      require(std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c); }));
      steps.push_back({"", static_cast<std::size_t>(std::stoul(digits))});
      left.remove_prefix(close + 1);
    }
  }
  require(!steps.empty() && steps.size() <= most_steps);
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
    if (!list) fail_at(place, "{} is {}, not a list", node.path, describe(node));
    if (*step.index > list->size())
      fail_at(place, "{} has {} entries; the next index is {}", node.path, list->size(),
              list->size());
    if (*step.index == list->size()) list->push_back(Node{Unsupported{}, created, path});
    return (*list)[*step.index];
  }
  auto* entries = node.table();
  if (!entries && node.list())
    fail_at(place, "{} is a list: say which entry, {}[0].{}", node.path, node.path, step.name);
  if (!entries)
    fail_at(place,
            "{} is {}, not a table: set it as a whole, "
            "{}={{ … }}",
            node.path, describe(node), node.path);
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
