#include "tlsph/io/record.hpp"

#include <type_traits>

#include "tlsph/io/csv.hpp"

namespace tlsph {

void Record::set(std::string_view name, double value) {
  fields_.emplace_back(name, value);
}
void Record::set(std::string_view name, std::string_view value) {
  fields_.emplace_back(name, std::string(value));
}
void Record::set_bool(std::string_view name, bool value) {
  fields_.emplace_back(name, value);
}
void Record::set_integer(std::string_view name, std::int64_t value) {
  fields_.emplace_back(name, value);
}
void Record::set_missing(std::string_view name) {
  fields_.emplace_back(name, std::monostate());
}

void Record::append(const Record& other) {
  fields_.insert(fields_.end(), other.fields_.begin(), other.fields_.end());
}

std::vector<std::string> Record::names() const {
  std::vector<std::string> names;
  for (const auto& [name, value] : fields_) names.push_back(name);
  return names;
}

std::vector<std::string> Record::cells() const {
  std::vector<std::string> cells;
  for (const auto& [name, value] : fields_)
    cells.push_back(std::visit(
        [](const auto& held) -> std::string {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<Held, std::monostate>)
            return "";
          else if constexpr (std::is_same_v<Held, double>)
            return csv_number(held);
          else if constexpr (std::is_same_v<Held, std::string>)
            return held;
          else
            return std::to_string(held);
        },
        value));
  return cells;
}

Json Record::json() const {
  Json json;
  for (const auto& [name, value] : fields_)
    std::visit(
        [&json, &name = name](const auto& held) {
          if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>)
            json.set(name, nullptr);
          else
            json.set(name, held);
        },
        value);
  return json;
}

}  // namespace tlsph
