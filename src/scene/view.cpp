#include "view.hpp"

#include <fmt/format.h>

#include <cassert>
#include <limits>

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

Node TableView::value_or_default(std::string_view name) const {
  const std::string& standard = key(name).standard;
  if (has(name) || standard.empty()) return require(name);
  const auto value = parse_value(standard, place_of(name), join_path(path_, std::string(name)));
  assert(value && "defaults that depend on other keys are not for this function");
  return *value;
}

bool TableView::flag(std::string_view name) const {
  return *value_or_default(name).flag();
}

double TableView::number(std::string_view name) const {
  return value_or_default(name).number();
}

long long TableView::integer(std::string_view name) const {
  return *value_or_default(name).integer();
}

int TableView::small_integer(std::string_view name) const {
  const long long value = integer(name);
  if (value > std::numeric_limits<int>::max() || value < std::numeric_limits<int>::min())
    throw InputError(place_of(name), fmt::format("must be at most {}, not {}",
                                                 std::numeric_limits<int>::max(), value));
  return static_cast<int>(value);
}

std::string TableView::text(std::string_view name) const {
  return *value_or_default(name).text();
}

std::vector<std::string> TableView::texts(std::string_view name) const {
  std::vector<std::string> result;
  const Node value = value_or_default(name);
  for (const Node& item : *value.list()) result.push_back(*item.text());
  return result;
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
