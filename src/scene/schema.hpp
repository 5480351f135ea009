#pragma once
/// \file
/// The keys of a scene, each once: what it may hold, unit, default, range, meaning. The same rows
/// check a file, supply its defaults and print `tlsph scene-reference`.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document.hpp"
#include "tlsph/core/range.hpp"

namespace tlsph {

/// What a key may hold, as bits: some keys take more than one form.
enum Form : unsigned {
  flag = 1U,      // true or false
  integer = 2U,   // a whole number
  number = 4U,    // a number
  text = 8U,      // a quoted text
  numbers = 16U,  // a list of numbers
  points = 32U,   // a list of lists of numbers
  texts = 64U,    // a list of texts
  table = 128U,   // a table { … } or [key]
  tables = 256U,  // a list of tables, [[key]]
};

/// The values of a key: words, numbers of a range, either of them, or whatever its form allows.
struct Allowed {
  std::vector<std::string> words;
  std::optional<Range> range;

  Allowed() = default;
  Allowed(Range numbers) : range(numbers) {}
  explicit Allowed(std::vector<std::string> names, std::optional<Range> numbers = {})
      : words(std::move(names)), range(numbers) {}
  /// `a | b | > 0`.
  [[nodiscard]] std::string text() const;
};

/// One key. `group` names the table it stands in, "" the top level; `below` the group of the keys
/// in its own table, if it holds one.
struct Key {
  std::string group;
  std::string name;
  unsigned forms;
  std::string below;
  std::string unit;
  std::string
      standard;  ///< default: TOML, or a remark in parentheses; empty if the key is required
  Allowed allowed;
  std::string doc;
};

/// Every key, in the order they are documented.
[[nodiscard]] const std::vector<Key>& schema();

/// The key of that name in a group, nullptr if there is none.
[[nodiscard]] const Key* find_key(std::string_view group, std::string_view name);

/// Refuses unknown keys, wrong types, numbers out of range and unknown words in the whole tree.
void check_document(const Node& root);

/// A number, a list of three numbers, … as messages call it.
[[nodiscard]] std::string describe(const Node& node);

/// The word of `words` that `word` most likely was meant to be, empty if none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& words);

}  // namespace tlsph
