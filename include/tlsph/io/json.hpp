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
#include <variant>
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
  Json(std::nullptr_t);
  Json(double value);
  Json(bool value);
  Json(std::int64_t value);
  template <std::integral T>
  Json(T value) : Json(static_cast<std::int64_t>(value)) {}
  Json(std::string_view text);
  template <std::convertible_to<std::string_view> T>
  Json(const T& text) : Json(std::string_view(text)) {}
  Json(const std::vector<double>& values);
  Json(const std::vector<std::string>& values);
  Json(const std::vector<Json>& elements);
  /// null for nothing.
  template <class T>
  Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json(nullptr)) {}
  /// null for an empty text.
  static Json text_or_null(std::string_view text) { return text.empty() ? Json(nullptr) : text; }
  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  /// Reads a document; throws InputError naming `origin`, with line and column.
  static Json parse(std::string_view text, const std::string& origin = "JSON");
  static Json read(const std::filesystem::path& path);

  void set(std::string_view path, Json value);

  [[nodiscard]] bool has(std::string_view path) const;
  [[nodiscard]] bool is_null(std::string_view path) const;
  /// The value at `path`; InputError if it is missing or of another type. Numbers may be integers.
  [[nodiscard]] double number(std::string_view path) const;
  [[nodiscard]] std::int64_t integer(std::string_view path) const;
  [[nodiscard]] std::string text(std::string_view path) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view path) const;
  /// Elements of the list at `path`, each a document of its own.
  [[nodiscard]] std::vector<Json> list(std::string_view path) const;

  using Scalar = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
  /// The value of a document that is a bool, a number or a text; nothing for lists, objects, null
  /// and doubles that are not finite.
  [[nodiscard]] Scalar scalar() const;

  /// The document as text; `indent` spaces a level, on one line if negative.
  [[nodiscard]] std::string dump(int indent = 2) const;
  /// Writes the document with a final line end, whole or not at all; OutputError on failure.
  void write(const std::filesystem::path& path) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace tlsph
