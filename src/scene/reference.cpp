// The key table as text.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "schema.hpp"
#include "tlsph/scene/reader.hpp"

namespace tlsph {
namespace {

std::string type_of(const Key& key) {
  std::vector<std::string> parts;
  for (const auto& [form, in_messages, word] : form_words) {
    if ((key.forms & form) == 0) continue;
    const bool of_others = form == table && key.below != key.name;
    parts.push_back(of_others ? fmt::format("table of {}", key.below) : word);
  }
  return fmt::format("{}", fmt::join(parts, " or "));
}

/// How the keys of a group are reached.
std::string heading(const std::string& group) {
  if (group.empty()) return "Top level, before the first [table]";
  for (const Key& key : schema()) {
    if (key.below != group || key.group == group) continue;
    const std::string path =
        key.group.empty() ? key.name : fmt::format("{}.{}", key.group, key.name);
    return (key.forms & tables) != 0 ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
  }
  return group;
}

/// The text in lines of at most 96 characters, broken at spaces and indented.
std::string wrapped(const std::string& text) {
  constexpr std::size_t indent = 22;
  constexpr std::size_t width = 96;
  std::string result;
  std::size_t column = width;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::size_t length = end - begin;
    if (column + 1 + length > width) {
      result.append(1, '\n').append(indent, ' ');
      column = indent;
    } else {
      result += ' ';
      ++column;
    }
    result += text.substr(begin, length);
    column += length;
    begin = end + 1;
  }
  return result;
}

std::string describe_key(const Key& key) {
  std::string line = fmt::format("  {:<19} {}", key.name, type_of(key));
  if (!key.unit.empty()) line += fmt::format(" [{}]", key.unit);
  if (key.standard.empty())
    line += ", required";
  else if (key.standard != "(none)")
    line += fmt::format(", default {}", key.standard);
  line += wrapped(key.allowed.text()) + wrapped(key.doc);
  return line + "\n";
}

}  // namespace

std::string scene_reference() {
  std::string result =
      "Keys of a scene (TOML, SI units). Any of them can be set from the command "
      "line: --set body.spacing=1e-3\n";
  std::string group = "-";
  for (const Key& key : schema()) {
    if (key.group != group) {
      group = key.group;
      result += fmt::format("\n{}\n", heading(group));
    }
    result += describe_key(key);
  }
  return result;
}

}  // namespace tlsph
