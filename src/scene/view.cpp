#include "view.hpp"

#include <fmt/format.h>

#include <cassert>

namespace tlsph {

const Key& TableView::key(std::string_view name) const {
  const Key* found = find_key(group_, name);
  assert(found && "the reader asks only for keys of the key table");
  return *found;
}

const Node* TableView::find(std::string_view name) const {
  static_cast<void>(key(name));
  return node_ ? node_->find(name) : nullptr;
}

Place TableView::place_of(std::string_view name) const {
  if (const Node* value = find(name)) return value->place;
  Place place = place_;
  place.key = join_path(path_, std::string(name));
  return place;
}

TableView TableView::table(std::string_view name) const {
  if (const Node* value = find(name)) return {*value, key(name).below};
  return {key(name).below, join_path(path_, std::string(name)), place_of(name)};
}

std::vector<TableView> TableView::tables(std::string_view name) const {
  std::vector<TableView> views;
  if (const Node* value = find(name))
    for (const Node& item : *value->list()) views.emplace_back(item, key(name).below);
  return views;
}

const Node& TableView::require(std::string_view name) const {
  if (const Node* value = find(name)) return *value;
  const Key& missing = key(name);
  std::string what = missing.doc;
  if (!missing.unit.empty()) what += (what.empty() ? "in " : ", in ") + missing.unit;
  throw InputError(place_of(name), fmt::format("missing{}{}", what.empty() ? "" : ": ", what));
}

std::vector<double> read_vector(const Node& node, int length, const std::string& meaning) {
  const auto& list = *node.list();
  if (static_cast<int>(list.size()) != length)
    throw InputError(node.place, fmt::format("must have {} number{}, {}, not {}", length,
                                             length == 1 ? "" : "s", meaning, list.size()));
  std::vector<double> result;
  for (const Node& item : list) result.push_back(item.number());
  return result;
}

}  // namespace tlsph
