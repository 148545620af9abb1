#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace ccmorse {

/// What JsonError::what() says is worded as Python's json module words it, for MORSE's error
/// replies (specs: morse.md A.5): "Expecting value: line 1 column 5 (char 4)".
class JsonError : public std::runtime_error {
 public:
  JsonError(const std::string& reason, int line, int column, std::size_t offset);
  const std::string& reason() const { return reason_; }
  int line() const { return line_; }      ///< from 1
  int column() const { return column_; }  ///< from 1, in characters
 private:
  std::string reason_;
  int line_;
  int column_;
};

/// A JSON value as the MORSE protocol and our scenario files use it (RFC 8259 plus the bare words
/// NaN, Infinity and -Infinity, which Python's json reads and writes). Objects keep the order in
/// which their members were written. A value read from text knows the line it stood on.
/// A plain value type: copy, move, compare; not thread safe to change while another thread reads.
class Json {
 public:
  using Array = std::vector<Json>;
  using Member = std::pair<std::string, Json>;
  using Object = std::vector<Member>;

  // Implicit on purpose: a value of the wire reads as what it is.
  // NOLINTBEGIN(google-explicit-constructor)
  Json() = default;
  Json(std::nullptr_t) {}
  Json(bool value) : value_(value) {}
  Json(int value) : value_(std::int64_t{value}) {}
  Json(std::int64_t value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(Array value) : value_(std::move(value)) {}
  Json(Object value) : value_(std::move(value)) {}
  // NOLINTEND(google-explicit-constructor)

  /// Parses one value and nothing after it. Throws JsonError; also on nesting deeper than 64.
  static Json Parse(std::string_view text);

  bool IsNull() const { return std::holds_alternative<std::nullptr_t>(value_); }
  bool IsBool() const { return std::holds_alternative<bool>(value_); }
  bool IsInt() const { return std::holds_alternative<std::int64_t>(value_); }
  bool IsNumber() const { return IsInt() || std::holds_alternative<double>(value_); }
  bool IsString() const { return std::holds_alternative<std::string>(value_); }
  bool IsArray() const { return std::holds_alternative<Array>(value_); }
  bool IsObject() const { return std::holds_alternative<Object>(value_); }

  /// "null", "true or false", "a number", "a string", "a list", "an object": for messages.
  const char* TypeName() const;

  // Access; each throws std::bad_variant_access when the value is of another type.
  bool AsBool() const { return std::get<bool>(value_); }
  std::int64_t AsInt() const { return std::get<std::int64_t>(value_); }
  double AsDouble() const;  ///< an integer, too
  const std::string& AsString() const { return std::get<std::string>(value_); }
  const Array& AsArray() const { return std::get<Array>(value_); }
  Array& AsArray() { return std::get<Array>(value_); }
  const Object& AsObject() const { return std::get<Object>(value_); }
  Object& AsObject() { return std::get<Object>(value_); }

  /// The member `key` of an object (the last one, where it is written twice); nullptr when it is
  /// missing or this is no object.
  const Json* Find(std::string_view key) const;

  /// Sets or appends a member of an object.
  void Set(std::string_view key, Json value);

  /// What Python calls falsy: null, false, 0, 0.0, "", [] and {} (morse.md A.5: not sent in
  /// replies).
  bool IsFalsy() const;

  /// One line, as Python's json.dumps writes it: ", " and ": ", \uXXXX beyond ASCII, floats as
  /// repr.
  std::string Dump() const;

  /// Line on which the value stood, from 1; 0 for a value that was not read from text.
  int line() const { return line_; }

  bool operator==(const Json& other) const { return value_ == other.value_; }

 private:
  friend class JsonParser;
  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> value_ =
      nullptr;
  int line_ = 0;
};

// Writers for hot paths, in the same format as Json::Dump().
void AppendJson(std::string& out, double value);
void AppendJson(std::string& out, std::int64_t value);
void AppendJson(std::string& out, std::string_view value);

}  // namespace ccmorse
