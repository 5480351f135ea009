#pragma once
/// \file
/// Keys bound to the members of a scene that hold them. One row says name, unit, range, meaning and
/// default of a key; reading, printing, checks and the reference follow from it. A new key is a
/// member of scene.hpp and one row in keys*.cpp.

#include <fmt/format.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "codec.hpp"
#include "tlsph/scene/edit.hpp"

namespace tlsph {

/// A key of a table kept in a T.
template <class T>
struct Row {
  Key key;
  /// From the view of the table into `table`, a part of the scene being read. Rows are read in
  /// their order: what `scene` says of keys before this one is known.
  std::function<void(T& table, const TableView&, const Scene& scene)> read;
  /// The value, none where there is nothing to print.
  std::function<std::optional<Node>(const T& table, const Scene&, Printed)> print;
  std::string unsaid = {};    ///< the value, printed, that goes without saying
  Place T::*place = nullptr;  ///< where the key stands, or would

  [[nodiscard]] bool is_required() const { return key.standard.empty(); }

  // Changes to a row as `key` makes it.
  Row required() && {
    key.standard.clear();
    return std::move(*this);
  }
  /// The reference says `remark` of the default, in parentheses.
  Row otherwise(std::string remark) && {
    key.standard = std::move(remark);
    return std::move(*this);
  }
  /// An optional number may be given as `word` too, its default.
  Row or_word(const std::string& word) && {
    key.forms |= text;
    key.allowed.words = {word};
    key.standard = fmt::format("\"{}\"", word);
    return std::move(*this);
  }
  Row at(Place T::*member) && {
    place = member;
    return std::move(*this);
  }
};

/// The keys of a table, in the order they are documented, and what remains to do and to check once
/// they are read.
template <class T>
struct Table {
  std::string group;
  std::vector<Row<T>> rows;
  std::function<void(T&, const TableView&, const Scene&)> finish;

  Table(std::string name, std::vector<Row<T>> keys, decltype(finish) then = {})
      : group(std::move(name)), rows(std::move(keys)), finish(std::move(then)) {
    for (Row<T>& row : rows) row.key.group = group;
  }
};

/// What the table says of its keys.
template <class T>
[[nodiscard]] std::vector<Key> keys_of(const Table<T>& table) {
  std::vector<Key> keys;
  for (const Row<T>& row : table.rows) keys.push_back(row.key);
  return keys;
}

template <class V>
constexpr bool is_defaulted = requires(const V& value) {
  value.given();
};

/// A key with the initial value of its member as default.
template <class T, class V>
[[nodiscard]] Row<T> key(V T::*member, const std::string& name, std::string unit, Allowed allowed,
                         std::string meaning) {
  using C = Codec<V>;
  const V initial = T{}.*member;
  std::string standard = "(none)";
  std::string unsaid;
  if constexpr (!MayBeAbsent<V>) {
    standard = print_value(C::print(initial));
    if constexpr (!is_defaulted<V>) unsaid = standard;
    if (standard.ends_with(".0")) standard.resize(standard.size() - 2);
  }
  std::string below;
  if constexpr (requires { C::below; }) below = C::below;
  if constexpr (requires { C::words(); })
    if (allowed.words.empty()) allowed.words = C::words();
  return {{"", name, C::forms, std::move(unit), std::move(allowed), std::move(meaning),
           std::move(below), std::move(standard)},
          [=](T& table, const TableView& view, const Scene& scene) {
            if constexpr (requires { (table.*member).place; })
              (table.*member).place = view.place_of(name);
            if (const Node* node = view.find(name)) table.*member = C::read(*node, scene);
          },
          [=](const T& table, const Scene&, Printed printed) -> std::optional<Node> {
            const V& value = table.*member;
            if constexpr (is_defaulted<V>)
              if (printed == Printed::given && !value.given()) return std::nullopt;
            if constexpr (MayBeAbsent<V>)
              if (!value.has_value()) return std::nullopt;
            Node node = C::print(value);
            if constexpr (requires { value.place; }) node.place = value.place;
            return node;
          },
          std::move(unsaid)};
}

/// A key whose default depends on other keys: `standard(table, scene)`, in words `remark`.
template <class T, class V>
[[nodiscard]] Row<T> key(Defaulted<V> T::*member, const std::string& name, std::string unit,
                         Allowed allowed, std::string meaning, std::string remark,
                         std::type_identity_t<std::function<V(const T&, const Scene&)>> standard) {
  Row<T> row = key(member, name, std::move(unit), std::move(allowed), std::move(meaning))
                   .otherwise(std::move(remark));
  row.read = [member, standard, read = row.read](T& table, const TableView& view,
                                                 const Scene& scene) {
    read(table, view, scene);
    if (!(table.*member).given()) table.*member = Defaulted<V>(standard(table, scene));
  };
  return row;
}

/// Reads every key of the table.
template <class T>
void read_table(T& table, const TableView& view, const Table<T>& keys, const Scene& scene) {
  if constexpr (requires { table.place; }) table.place = view.place();
  for (const Row<T>& row : keys.rows) {
    if (row.is_required()) view.require(row.key.name);
    row.read(table, view, scene);
    if (row.place != nullptr) table.*row.place = view.place_of(row.key.name);
  }
  if (keys.finish) keys.finish(table, view, scene);
}

/// The table with the keys that are to be printed.
template <class T>
[[nodiscard]] Node print_table(const T& table, const Table<T>& keys, const Scene& scene,
                               Printed printed) {
  std::vector<Entry> entries;
  for (const Row<T>& row : keys.rows) {
    std::optional<Node> node = row.print(table, scene, printed);
    if (!node ||
        (printed == Printed::given && !row.is_required() && print_value(*node) == row.unsaid))
      continue;
    if (row.place != nullptr) node->place = table.*row.place;
    entries.push_back(entry_of(row.key.name, std::move(*node)));
  }
  Node node = node_of(std::move(entries));
  if constexpr (requires { table.place; }) node.place = table.place;
  return node;
}

namespace detail {

/// A table kept in `part(owner)`.
template <class T, class V, class Part>
[[nodiscard]] Row<T> nested(Part part, const Table<V>& below, const std::string& name,
                            std::string meaning) {
  return {{"", name, table, "", {}, std::move(meaning), below.group},
          [=, &below](T& owner, const TableView& view, const Scene& scene) {
            read_table(std::invoke(part, owner), view.table(name), below, scene);
          },
          [=, &below](const T& owner, const Scene& scene, Printed printed) -> std::optional<Node> {
            Node node = print_table(std::invoke(part, owner), below, scene, printed);
            return node.table()->empty() ? std::nullopt : std::optional(std::move(node));
          }};
}

}  // namespace detail

/// A table of its own, kept in the member.
template <class T, class V>
[[nodiscard]] Row<T> table_key(V T::*member, const Table<V>& below, const std::string& name,
                               std::string meaning) {
  return detail::nested<T>(member, below, name, std::move(meaning));
}

/// A table of its own whose keys are kept beside those of the table around it.
template <class T>
[[nodiscard]] Row<T> part_key(const Table<T>& below, const std::string& name, std::string meaning) {
  return detail::nested<T>(std::identity(), below, name, std::move(meaning));
}

/// A list of tables, kept in the member.
template <class T, class V>
[[nodiscard]] Row<T> list_key(std::vector<V> T::*member, const Table<V>& below,
                              const std::string& name, std::string meaning) {
  return {{"", name, tables, "", {}, std::move(meaning), below.group},
          [=, &below](T& owner, const TableView& view, const Scene& scene) {
            for (const TableView& item : view.tables(name))
              read_table((owner.*member).emplace_back(), item, below, scene);
          },
          [=, &below](const T& owner, const Scene& scene, Printed printed) -> std::optional<Node> {
            std::vector<Node> items;
            for (const V& item : owner.*member)
              items.push_back(print_table(item, below, scene, printed));
            return items.empty() ? std::nullopt : std::optional(node_of(std::move(items)));
          }};
}

}  // namespace tlsph
