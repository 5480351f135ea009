#pragma once
/// \file
/// A JSON document as a tree that keeps the order in which it was filled: summaries, reports,
/// tables.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tlsph {

/// A JSON value with the meaning of a value: copies are deep. A path is the keys from the root,
/// joined by dots ("energy.kinetic"); objects on the way are made as needed. Doubles are written
/// with as many digits (at most 17) as bring back every bit; NaN and infinities, which JSON does
/// not know, become null.
class Json {
 public:
  /// An empty object.
  Json();
  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  /// Reads a document; throws InputError naming `origin`, with line and column.
  static Json parse(std::string_view text, const std::string& origin = "JSON");
  static Json read(const std::filesystem::path& path);

  void set(std::string_view path, double value);
  void set(std::string_view path, std::string_view value);
  void set(std::string_view path, const char* value) { set(path, std::string_view(value)); }
  void set(std::string_view path, const std::string& value) { set(path, std::string_view(value)); }
  void set(std::string_view path, std::nullptr_t);
  void set(std::string_view path, const std::vector<double>& values);
  void set(std::string_view path, const std::vector<std::string>& values);
  void set(std::string_view path, const Json& tree);
  template <std::integral T>
  void set(std::string_view path, T value) {
    if constexpr (std::same_as<T, bool>)
      set_bool(path, value);
    else
      set_integer(path, static_cast<std::int64_t>(value));
  }
  /// null for nothing: an empty optional, an empty text.
  void set(std::string_view path, const std::optional<double>& value);
  void set_or_null(std::string_view path, std::string_view text);
  /// Adds `element` to the list at `path`, which is made if it is not there.
  void append(std::string_view path, const Json& element);
  /// Makes the list at `path` if it is not there, so that an empty one is written too.
  void make_list(std::string_view path);

  [[nodiscard]] bool has(std::string_view path) const;
  [[nodiscard]] bool is_null(std::string_view path) const;
  /// The value at `path`; InputError if it is missing or of another type. Numbers may be integers.
  [[nodiscard]] double number(std::string_view path) const;
  [[nodiscard]] std::int64_t integer(std::string_view path) const;
  [[nodiscard]] std::string text(std::string_view path) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view path) const;
  /// Elements of the list at `path`, each a document of its own.
  [[nodiscard]] std::vector<Json> list(std::string_view path) const;

  /// The document as text; `indent` spaces a level, on one line if negative.
  [[nodiscard]] std::string dump(int indent = 2) const;
  /// Writes the document with a final line end, whole or not at all; OutputError on failure.
  void write(const std::filesystem::path& path) const;

 private:
  struct Tree;
  void set_bool(std::string_view path, bool value);
  void set_integer(std::string_view path, std::int64_t value);
  std::unique_ptr<Tree> tree_;
};

}  // namespace tlsph
