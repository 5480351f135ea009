#include "document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tlsph {
namespace {

/// Levels of tables and lists below the root, and parts of a dotted key: far more than a scene has.
constexpr std::size_t deepest = 16;

/// Where text comes from: a file, or an override at `path`, whose values all share one place that
/// already names the path.
struct Origin {
  std::string file;
  std::optional<std::string> path = {};

  [[nodiscard]] Place at(std::size_t line, std::size_t column, const std::string& key = "") const {
    if (path) return Place{file, 0, 0, key == *path ? "" : key};
    return Place{file, static_cast<int>(line), static_cast<int>(column), key};
  }
  [[nodiscard]] Place at(const toml::source_region& source, const std::string& key = "") const {
    return at(source.begin.line, source.begin.column, key);
  }
};

Node convert(const toml::node& node, const Origin& origin, const std::string& path,
             std::size_t depth);

std::vector<Entry> convert_table(const toml::table& table, const Origin& origin,
                                 const std::string& path, std::size_t depth) {
  std::vector<std::pair<toml::source_position, Entry>> entries;
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    const std::string below = join_path(path, name);
    entries.emplace_back(key.source().begin, Entry{name, origin.at(key.source(), below),
                                                   convert(value, origin, below, depth)});
  }
  // The library sorts by name; the user's order is that of the file.
  std::ranges::stable_sort(entries, {}, [](const auto& entry) {
    return std::pair(entry.first.line, entry.first.column);
  });
  std::vector<Entry> result;
  for (auto& [position, entry] : entries) result.push_back(std::move(entry));
  return result;
}

/// Of a node `depth` levels below the root.
Node convert(const toml::node& node, const Origin& origin, const std::string& path,
             std::size_t depth) {
  if (depth > deepest)
    fail_at(origin.at(node.source()),
            "more than {} levels of tables and lists; no key of a scene lies "
            "so deep",
            deepest);
  Node result{Unsupported{}, origin.at(node.source(), path), path};
  node.visit([&]<class T>(const T& value) {
    if constexpr (toml::is_table<T>) {
      result.value = convert_table(value, origin, path, depth + 1);
    } else if constexpr (toml::is_array<T>) {
      std::vector<Node> items;
      for (std::size_t i = 0; i < value.size(); ++i)
        items.push_back(convert(value[i], origin, fmt::format("{}[{}]", path, i), depth + 1));
      result.value = std::move(items);
    } else if constexpr (!toml::is_chronological<T>) {
      result.value = value.get();
    }
  });
  return result;
}

/// Length of the UTF-8 sequence at `i`, 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0U;
  };
  const auto tail = [&](std::size_t k) { return (byte(k) & 0xC0U) == 0x80U; };
  if (byte(0) < 0x80U) return 1;
  if (byte(0) >= 0xC2U && byte(0) < 0xE0U && tail(1)) return 2;
  if (byte(0) >= 0xE0U && byte(0) < 0xF0U && tail(1) && tail(2)) {
    const bool overlong = byte(0) == 0xE0U && byte(1) < 0xA0U;
    const bool surrogate = byte(0) == 0xEDU && byte(1) >= 0xA0U;
    return overlong || surrogate ? 0 : 3;
  }
  if (byte(0) >= 0xF0U && byte(0) < 0xF5U && tail(1) && tail(2) && tail(3)) {
    const bool overlong = byte(0) == 0xF0U && byte(1) < 0x90U;
    const bool beyond = byte(0) == 0xF4U && byte(1) >= 0x90U;
    return overlong || beyond ? 0 : 4;
  }
  return 0;
}

/// InputError at the first byte that is no text.
void require_text(const std::string& text, const Origin& origin) {
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\0')
      throw InputError(origin.at(line, column),
                       "a binary file, not a scene; a scene is TOML text in UTF-8");
    const std::size_t length = utf8_length(text, i);
    if (length == 0)
      fail_at(origin.at(line, column),
              "byte 0x{:02x} is not UTF-8; a scene is TOML text, save it as UTF-8",
              static_cast<unsigned char>(text[i]));
    ++column;
    if (text[i] == '\n') ++line, column = 1;
    i += length;
  }
}

bool is_bare(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  });
}

/// The character after the string that begins at `i`; `line` counts those it goes over.
std::size_t end_of_string(const std::string& text, std::size_t i, std::size_t& line) {
  const std::string mark(text.compare(i, 3, std::string(3, text[i])) == 0 ? 3 : 1, text[i]);
  for (i += mark.size(); i < text.size(); ++i) {
    if (text.compare(i, mark.size(), mark) == 0) return i + mark.size();
    if (text[i] == '\n' && mark.size() == 1) return i;  // not TOML, as the parser will say
    if (text[i] == '\n') ++line;
    if (text[i] == '\\' && mark[0] == '"' && i + 1 < text.size() && text[i + 1] != '\n') ++i;
  }
  return text.size();
}

/// InputError at the first key of more dotted parts than any key of a scene has. The parser makes a
/// table of each part, one in the other, and the way down a chain of thousands ends the stack.
void require_short_keys(const std::string& text, const Origin& origin) {
  std::size_t line = 1, begin = 0, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (c == '"' || c == '\'') {
      i = end_of_string(text, i, line);
    } else {
      const bool in_key = is_bare(std::string(1, c)) || c == ' ' || c == '\t';
      if (c == '.' && ++dots > deepest)
        fail_at(origin.at(line, i - begin + 1),
                "a key of more than {} parts; no key of a scene has as many", deepest);
      if (c != '.' && !in_key) dots = 0;
      ++i;
      if (c == '\n') ++line, begin = i;
    }
  }
}

std::string quote(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string print_key(const std::string& name) {
  return is_bare(name) ? name : quote(name);
}

bool is_list_of_tables(const Node& node) {
  const auto* list = node.list();
  return list && !list->empty() &&
         std::all_of(list->begin(), list->end(), [](const Node& item) { return item.table(); });
}

/// `name = value` for each entry, separated.
std::string print_entries(const std::vector<Entry>& entries, const char* separator) {
  std::string text;
  for (const Entry& entry : entries)
    text += fmt::format("{}{} = {}", text.empty() ? "" : separator, print_key(entry.name),
                        print_value(entry.value));
  return text;
}

}  // namespace

double Node::number() const {
  if (const auto* whole = integer()) return static_cast<double>(*whole);
  return std::get<double>(value);
}

const Node* Node::find(std::string_view name) const {
  if (const auto* entries = table())
    for (const auto& entry : *entries)
      if (entry.name == name) return &entry.value;
  return nullptr;
}

Node* Node::find(std::string_view name) {
  return const_cast<Node*>(std::as_const(*this).find(name));
}

std::string join_path(const std::string& path, const std::string& name) {
  return path.empty() ? print_key(name) : path + '.' + print_key(name);
}

Node parse_document(const std::string& text, const std::string& name) {
  const Origin origin{name};
  require_text(text, origin);
  require_short_keys(text, origin);
  try {
    return Node{convert_table(toml::parse(text, name), origin, "", 1), origin.at(1, 1), ""};
  } catch (const toml::parse_error& error) {
    fail_at(origin.at(error.source()), "not TOML: {}", error.description());
  }
}

std::optional<Node> parse_value(const std::string& text, const Place& place,
                                const std::string& path) {
  const Origin origin{place.file, path};
  require_text(text, origin);
  try {
    const std::string line = "value = " + text + "\n";
    require_short_keys(line, origin);
    const toml::table table = toml::parse(line);
    // A line break in the text could smuggle in more entries: then it is no single value.
    if (table.size() != 1) return std::nullopt;
    return convert(*table.get("value"), origin, path, 1);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

std::string print_value(const Node& node) {
  if (const auto* flag = node.flag()) return *flag ? "true" : "false";
  if (const auto* integer = node.integer()) return fmt::format("{}", *integer);
  if (const auto* number = std::get_if<double>(&node.value)) {
    if (!std::isfinite(*number)) return fmt::format("{}", *number);
    std::string text = fmt::format("{}", *number);  // the shortest text that reads back the same
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
  }
  if (const auto* text = node.text()) return quote(*text);
  if (const auto* list = node.list()) {
    std::string text;
    for (const auto& item : *list) text += (text.empty() ? "" : ", ") + print_value(item);
    return '[' + text + ']';
  }
  if (const auto* entries = node.table()) return "{ " + print_entries(*entries, ", ") + " }";
  return "a date or time";
}

std::string print_document(const Node& root) {
  const auto has_header = [](const Entry& entry) {
    return entry.value.table() || is_list_of_tables(entry.value);
  };
  std::string text;
  const auto print = [&](const std::string& header, const std::vector<Entry>& entries) {
    text += header + print_entries(entries, "\n") + (entries.empty() ? "" : "\n");
  };
  std::vector<Entry> top = *root.table();
  std::erase_if(top, has_header);
  print("", top);
  for (const Entry& entry : *root.table()) {
    const std::string name = print_key(entry.name);
    if (const auto* entries = entry.value.table()) print(fmt::format("\n[{}]\n", name), *entries);
    if (is_list_of_tables(entry.value))
      for (const Node& item : *entry.value.list())
        print(fmt::format("\n[[{}]]\n", name), *item.table());
  }
  return text;
}

}  // namespace tlsph
