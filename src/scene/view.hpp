#pragma once
/// \file
/// A checked table of a scene, looked at by key: values, and complaints with their place.

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
