#pragma once
/// \file
/// One row of a table that is written twice, as comma-separated values for spreadsheets and as JSON
/// for programs: names and values are stated once.

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tlsph/io/json.hpp"

namespace tlsph {

/// Values under names, in the order in which they were set. A value that is missing (an empty
/// optional, a double that is no finite number) is an empty cell and a null.
class Record {
 public:
  void set(std::string_view name, double value);
  void set(std::string_view name, std::string_view value);
  void set(std::string_view name, const char* value) { set(name, std::string_view(value)); }
  void set(std::string_view name, const std::string& value) { set(name, std::string_view(value)); }
  template <std::integral T>
  void set(std::string_view name, T value) {
    if constexpr (std::same_as<T, bool>)
      set_bool(name, value);
    else
      set_integer(name, static_cast<std::int64_t>(value));
  }
  template <class T>
  void set(std::string_view name, const std::optional<T>& value) {
    if (value)
      set(name, *value);
    else
      set_missing(name);
  }
  /// The fields of another record after the own ones.
  void append(const Record& other);

  /// The header of the table.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Doubles with 17 digits; texts as they are, to be quoted by who writes them.
  [[nodiscard]] std::vector<std::string> cells() const;
  [[nodiscard]] Json json() const;

 private:
  using Value = std::variant<std::monostate, double, std::int64_t, bool, std::string>;
  void set_bool(std::string_view name, bool value);
  void set_integer(std::string_view name, std::int64_t value);
  void set_missing(std::string_view name);
  std::vector<std::pair<std::string, Value>> fields_;
};

}  // namespace tlsph
