#pragma once
/// \file
/// A checked table of a scene, read by key: values by type, defaults from the key table, complaints
/// with their place.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"
#include "schema.hpp"
#include "tlsph/scene/names.hpp"

namespace tlsph {

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

  // Value in the file, else the default of the key table, else InputError: the key is required.
  [[nodiscard]] bool flag(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] long long integer(std::string_view name) const;
  /// An integer that must also fit an int.
  [[nodiscard]] int small_integer(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;
  template <class E>
  [[nodiscard]] E choice(std::string_view name) const {
    return *from_name<E>(text(name));
  }

  /// Value in the file, else `fallback`.
  [[nodiscard]] double number_or(std::string_view name, double fallback) const {
    return has(name) ? number(name) : fallback;
  }
  template <class E>
  [[nodiscard]] E choice_or(std::string_view name, E fallback) const {
    return has(name) ? choice<E>(name) : fallback;
  }

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
  [[nodiscard]] Node value_or_default(std::string_view name) const;

  const Node* node_ = nullptr;  // nullptr: the table is not in the file
  std::string group_, path_;
  Place place_;
};

/// A list of exactly `length` numbers; `meaning` says what of, for the message.
[[nodiscard]] std::vector<double> read_vector(const Node& node, int length,
                                              const std::string& meaning);

}  // namespace tlsph
