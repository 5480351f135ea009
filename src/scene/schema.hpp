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

/// How messages and the reference call a form.
struct FormWords {
  Form form;
  const char *in_messages, *in_reference;
};
inline constexpr FormWords form_words[] = {
    {flag, "true or false", "true/false"},
    {integer, "a whole number", "integer"},
    {number, "a number", "number"},
    {text, "a text in quotes", "text"},
    {numbers, "a list of numbers", "[number, …]"},
    {points, "a list of points [x, …]", "[[number, …], …]"},
    {texts, "a list of texts", "[text, …]"},
    {table, "a table", "table"},
    {tables, "a list of tables", "list of tables"},
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

/// One key.
struct Key {
  std::string group;  ///< the table it stands in, "" the top level
  std::string name;
  unsigned forms = 0;
  std::string unit;
  Allowed allowed;
  std::string doc;
  std::string below = {};  ///< the group of the keys in its own table, if it holds one
  /// Default: TOML, or a remark in parentheses; empty if the key is required.
  std::string standard = "(none)";
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

/// A checked table of a scene, looked at by key: values, and complaints with their place.
class TableView {
 public:
  /// The top level of a document that passed `check_document`.
  explicit TableView(const Node& root) : node_(&root), place_(root.place) {}
  /// The table `node`, whose keys are those of `group`.
  TableView(const Node& node, std::string group)
      : node_(&node), group_(std::move(group)), path_(node.path), place_(node.place) {}

  /// The table of that key; an empty one if it is not in the file.
  [[nodiscard]] TableView table(std::string_view name) const;
  /// Views of the tables of a list; none if the key is not in the file.
  [[nodiscard]] std::vector<TableView> tables(std::string_view name) const;

  /// The value, nullptr if it is not in the file.
  [[nodiscard]] const Node* find(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }
  /// The value; InputError that names the missing key and its meaning.
  const Node& require(std::string_view name) const;

  /// Where this table starts.
  [[nodiscard]] const Place& place() const { return place_; }
  /// Where the value of a key stands, or the start of the table if it is not in the file.
  [[nodiscard]] Place place_of(std::string_view name) const;
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const Node* node() const { return node_; }

 private:
  TableView(std::string group, std::string path, Place place)
      : group_(std::move(group)), path_(std::move(path)), place_(std::move(place)) {}
  [[nodiscard]] const Key& key(std::string_view name) const;

  const Node* node_ = nullptr;  // nullptr: the table is not in the file
  std::string group_, path_;
  Place place_;
};

/// A list of exactly `length` numbers; `meaning` says what of, for the message.
[[nodiscard]] std::vector<double> read_vector(const Node& node, int length,
                                              const std::string& meaning);

}  // namespace tlsph
