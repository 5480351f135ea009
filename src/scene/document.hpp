#pragma once
/// \file
/// A scene file as a tree of plain values, each with its place in the file. The only code that
/// knows the TOML library is document.cpp.

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tlsph/core/error.hpp"

namespace tlsph {

/// Throws InputError, its message formatted.
template <class... Values>
[[noreturn]] void fail_at(const Place& place, fmt::format_string<Values...> message,
                          Values&&... values) {
  throw InputError(place, fmt::format(message, std::forward<Values>(values)...));
}

struct Node;
struct Entry;

/// A date or time: valid TOML, but no key of a scene takes one.
struct Unsupported {};

/// One value: a leaf, a list or a table (entries in the order of the file).
struct Node {
  std::variant<bool, std::int64_t, double, std::string, std::vector<Node>, std::vector<Entry>,
               Unsupported>
      value;
  Place place;       ///< where the value starts
  std::string path;  ///< dotted path from the root, e.g. `boundary[1].traction`

  [[nodiscard]] bool is_number() const { return value.index() == 1 || value.index() == 2; }
  [[nodiscard]] const bool* flag() const { return std::get_if<bool>(&value); }
  [[nodiscard]] const std::int64_t* integer() const { return std::get_if<std::int64_t>(&value); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&value); }
  [[nodiscard]] const std::vector<Node>* list() const {
    return std::get_if<std::vector<Node>>(&value);
  }
  [[nodiscard]] std::vector<Node>* list() { return std::get_if<std::vector<Node>>(&value); }
  [[nodiscard]] const std::vector<Entry>* table() const {
    return std::get_if<std::vector<Entry>>(&value);
  }
  [[nodiscard]] std::vector<Entry>* table() { return std::get_if<std::vector<Entry>>(&value); }
  /// The number, an integer converted. Precondition: `is_number()`.
  [[nodiscard]] double number() const;
  /// The entry of that name of a table, nullptr if there is none (or no table).
  [[nodiscard]] const Node* find(std::string_view name) const;
  [[nodiscard]] Node* find(std::string_view name);
};

struct Entry {
  std::string name;
  Place place;  ///< where the name stands
  Node value;
};

/// The tree of a TOML text; the root is a table. `name` is how messages call the text. InputError
/// with line and column if it is not UTF-8 or not TOML.
[[nodiscard]] Node parse_document(const std::string& text, const std::string& name);

/// The tree of one TOML value found at `path`, every place set to `place` (with the key added below
/// the top); empty if the text is not one TOML value, InputError if it is not UTF-8.
[[nodiscard]] std::optional<Node> parse_value(const std::string& text, const Place& place,
                                              const std::string& path);

/// The tree as TOML text that parses to the same values.
[[nodiscard]] std::string print_document(const Node& root);

/// One value as TOML text, on one line.
[[nodiscard]] std::string print_value(const Node& node);

/// `path.name`, or `name` at the root; names that are not bare words are quoted.
[[nodiscard]] std::string join_path(const std::string& path, const std::string& name);

/// Sets the value at `key` of `key=value` in the tree; tables and one more list entry are created
/// on the way as needed. InputError, naming the override, if it is malformed or the path runs
/// through something that has no keys.
void apply_override(Node& root, const std::string& override_text);

}  // namespace tlsph
