#pragma once
/// \file
/// A value that knows whether a scene gives it.

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace tlsph {

template <class T>
concept MayBeAbsent = requires(const T& value) {
  value.has_value();
};

/// The value of a key in force, and whether the scene gives it. Construction sets a default;
/// assignment gives a value, as if it stood in the file. A default that depends on other keys is
/// filled in by the reader, so it follows them when they change.
template <class T>
class Defaulted {
 public:
  Defaulted() = default;
  Defaulted(T standard) : value_(std::move(standard)) {}
  Defaulted& operator=(T value) {
    value_ = std::move(value);
    given_ = true;
    return *this;
  }

  [[nodiscard]] bool given() const { return given_; }
  [[nodiscard]] const T& get() const { return value_; }
  operator const T&() const { return value_; }
  operator std::string_view() const requires std::same_as<T, std::string> { return value_; }
  bool operator==(const T& other) const { return value_ == other; }

  // Of a value that may be absent, as of an optional.
  [[nodiscard]] bool has_value() const requires MayBeAbsent<T> { return value_.has_value(); }
  explicit operator bool() const requires MayBeAbsent<T> { return value_.has_value(); }
  const auto& operator*() const { return *value_; }
  const auto* operator->() const { return &*value_; }
  [[nodiscard]] auto value_or(auto other) const { return value_.value_or(other); }

 private:
  T value_{};
  bool given_ = false;
};

}  // namespace tlsph
