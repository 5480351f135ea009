#pragma once
/// \file
/// How the values of keys stand in a scene: for each type the forms and words it takes, and the
/// pair of reading and printing. Values of one table only have their pair beside the keys of that
/// table.

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "schema.hpp"
#include "tlsph/scene/names.hpp"
#include "tlsph/scene/scene.hpp"

namespace tlsph {

/// A node that is not placed yet.
template <class Value>
[[nodiscard]] Node node_of(Value value) {
  return {std::move(value), {}, ""};
}
[[nodiscard]] inline Entry entry_of(std::string_view name, Node value) {
  return {std::string(name), {}, std::move(value)};
}

/// `forms`, perhaps `words()` and the group `below`; `read(node, scene)` of a node whose form and
/// words have been checked, into the scene being read, and `print(value)`.
template <class V>
struct Codec;

/// A value that stands as it is: `V` in the program, `Leaf` in the tree.
template <class V, class Leaf, unsigned Forms>
struct PlainCodec {
  static constexpr unsigned forms = Forms;
  static V read(const Node& node, const Scene&) {
    return static_cast<V>(std::get<Leaf>(node.value));
  }
  static Node print(const V& value) { return node_of(static_cast<Leaf>(value)); }
};
template <>
struct Codec<bool> : PlainCodec<bool, bool, flag> {};
template <>
struct Codec<std::uint64_t> : PlainCodec<std::uint64_t, std::int64_t, integer> {};
template <>
struct Codec<std::string> : PlainCodec<std::string, std::string, text> {};

template <>
struct Codec<double> {
  static constexpr unsigned forms = number;
  static double read(const Node& node, const Scene&) { return node.number(); }
  static Node print(double value) { return node_of(value); }
};

template <>
struct Codec<int> {
  static constexpr unsigned forms = integer;
  static int read(const Node& node, const Scene&) {
    constexpr auto most = std::numeric_limits<int>::max();
    const std::int64_t value = *node.integer();
    if (value > most || value < std::numeric_limits<int>::min())
      fail_at(node.place, "must be at most {}, not {}", most, value);
    return static_cast<int>(value);
  }
  static Node print(int value) { return node_of(std::int64_t{value}); }
};

template <class E>
requires(!word_list<E>.empty()) struct Codec<E> {
  static constexpr unsigned forms = text;
  static std::vector<std::string> words() {
    std::vector<std::string> all;
    for (const auto& [name, entry] : word_list<E>) all.emplace_back(name);
    return all;
  }
  static E read(const Node& node, const Scene&) { return *from_name<E>(*node.text()); }
  static Node print(E value) { return node_of(std::string(name_of(value))); }
};

template <class V>
[[nodiscard]] Node print_list(const std::vector<V>& values) {
  std::vector<Node> items;
  for (const V& value : values) items.push_back(Codec<V>::print(value));
  return node_of(std::move(items));
}

/// A vector: one number per dimension.
template <>
struct Codec<std::vector<double>> {
  static constexpr unsigned forms = numbers;
  static std::vector<double> read(const Node& node, const Scene& scene) {
    return read_vector(node, scene.dimension, "one per dimension");
  }
  static Node print(const std::vector<double>& value) { return print_list(value); }
};

template <>
struct Codec<std::vector<std::string>> {
  static constexpr unsigned forms = texts;
  static std::vector<std::string> read(const Node& node, const Scene&) {
    std::vector<std::string> value;
    for (const Node& item : *node.list()) value.push_back(*item.text());
    return value;
  }
  static Node print(const std::vector<std::string>& value) { return print_list(value); }
};

template <class V>
struct Codec<Defaulted<V>> : Codec<V> {};

/// A word in place of a number means none.
template <class V>
struct Codec<std::optional<V>> : Codec<V> {
  static std::optional<V> read(const Node& node, const Scene& scene) {
    if (node.text() && (Codec<V>::forms & text) == 0) return std::nullopt;
    return Codec<V>::read(node, scene);
  }
  static Node print(const std::optional<V>& value) { return Codec<V>::print(*value); }
};

}  // namespace tlsph
