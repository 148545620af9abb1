#include "base/json.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace ccmorse {
namespace {

constexpr int kMaxDepth = 64;

std::string PositionText(const std::string& reason, int line, int column, std::size_t offset) {
  return reason + ": line " + std::to_string(line) + " column " + std::to_string(column) +
         " (char " + std::to_string(offset) + ")";
}

void AppendUtf8(std::string& out, std::uint32_t code) {
  const auto byte = [&out](std::uint32_t value) { out.push_back(static_cast<char>(value)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6));
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3F));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

// Decodes the UTF-8 sequence at text[i] and moves i past it; a byte that starts none is U+FFFD. Too
// long a form of a character, half a surrogate pair and what lies beyond Unicode are none.
std::uint32_t NextCodePoint(std::string_view text, std::size_t& i) {
  const auto at = [text](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char lead = at(i);
  const std::size_t length = lead < 0x80 ? 1 : (lead >> 5) == 6 ? 2 : (lead >> 4) == 14 ? 3 : 4;
  if (lead < 0x80) return at(i++);
  if (lead < 0xC2 || lead > 0xF4 || i + length > text.size()) {
    ++i;
    return 0xFFFD;
  }
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((at(i + k) >> 6) != 2) {
      ++i;
      return 0xFFFD;
    }
    code = (code << 6) | (at(i + k) & 0x3FU);
  }
  constexpr std::uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) {
    ++i;
    return 0xFFFD;
  }
  i += length;
  return code;
}

// The text with U+FFFD for what is no UTF-8, so that it is written and read back the same.
std::string Mended(std::string text) {
  if (std::none_of(text.begin(), text.end(), [](char c) { return (c & 0x80) != 0; })) return text;
  std::string out;
  for (std::size_t i = 0; i < text.size();) AppendUtf8(out, NextCodePoint(text, i));
  return out;
}

// Whether a number that no double can hold is too large, not too small: where its first digit
// other than 0 stands, together with the exponent, decides.
bool IsTooLarge(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), e));
  const auto first = static_cast<std::int64_t>(mantissa.find_first_of("123456789"));
  std::int64_t exponent = 0;
  if (e < number.size()) {
    std::string_view digits = number.substr(e + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (parsed.ec != std::errc{}) return digits.front() != '-';
  }
  return exponent > first - point;
}

void AppendEscaped(std::string& out, std::uint32_t unit) {
  static constexpr char kHex[] = "0123456789abcdef";
  out += "\\u";
  for (int shift = 12; shift >= 0; shift -= 4) out.push_back(kHex[(unit >> shift) & 0xF]);
}

}  // namespace

JsonError::JsonError(const std::string& reason, int line, int column, std::size_t offset)
    : std::runtime_error(PositionText(reason, line, column, offset)),
      reason_(reason),
      line_(line),
      column_(column) {}

// Recursive descent over the text; positions are worked out only when something is wrong, but for
// the line of each value, which is counted along the way.
class JsonParser {
 public:
  explicit JsonParser(std::string_view text) : text_(text) {}

  Json ParseDocument() {
    SkipSpace();
    Json value = ParseValue(0);
    SkipSpace();
    if (at_ != text_.size()) Fail("Extra data", at_);
    return value;
  }

 private:
  [[noreturn]] void Fail(const std::string& reason, std::size_t offset) const {
    int line = 1;
    // Python counts characters: of a character's bytes all but the first are 0b10xxxxxx.
    std::size_t characters = 0;
    std::size_t line_start = 0;
    for (std::size_t i = 0; i < offset && i < text_.size(); ++i) {
      if ((static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U) ++characters;
      if (text_[i] == '\n') {
        ++line;
        line_start = characters;
      }
    }
    throw JsonError(reason, line, static_cast<int>(characters - line_start) + 1, characters);
  }

  void SkipSpace() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        return;
      }
      ++at_;
    }
  }

  bool Take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool TakeWord(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  Json ParseValue(int depth) {
    if (depth > kMaxDepth) Fail("Nesting deeper than 64", at_);
    const int line = line_;
    Json value = ParseBare(depth);
    value.line_ = line;
    return value;
  }

  Json ParseBare(int depth) {
    if (at_ >= text_.size()) Fail("Expecting value", at_);
    switch (text_[at_]) {
      case '{':
        return ParseObject(depth);
      case '[':
        return ParseArray(depth);
      case '"':
        return Json(ParseString());
      case 't':
        if (TakeWord("true")) return Json(true);
        break;
      case 'f':
        if (TakeWord("false")) return Json(false);
        break;
      case 'n':
        if (TakeWord("null")) return Json(nullptr);
        break;
      case 'N':
        if (TakeWord("NaN")) return Json(std::numeric_limits<double>::quiet_NaN());
        break;
      case 'I':
        if (TakeWord("Infinity")) return Json(std::numeric_limits<double>::infinity());
        break;
      default:
        return ParseNumber();
    }
    Fail("Expecting value", at_);
  }

  Json ParseNumber() {
    const std::size_t start = at_;
    if (TakeWord("-Infinity")) return Json(-std::numeric_limits<double>::infinity());
    std::size_t i = at_;
    const auto digits = [this, &i] {
      const std::size_t first = i;
      while (i < text_.size() && text_[i] >= '0' && text_[i] <= '9') ++i;
      return i - first;
    };
    if (i < text_.size() && text_[i] == '-') ++i;
    const std::size_t integer_at = i;
    if (digits() == 0) Fail("Expecting value", start);
    if (text_[integer_at] == '0')
      i = integer_at + 1;  // JSON has no leading zeros: "01" is 0, then 1
    bool is_int = true;
    if (i + 1 < text_.size() && text_[i] == '.' && text_[i + 1] >= '0' && text_[i + 1] <= '9') {
      is_int = false;
      ++i;
      digits();
    }
    if (i < text_.size() && (text_[i] == 'e' || text_[i] == 'E')) {
      const std::size_t exponent_at = i++;
      if (i < text_.size() && (text_[i] == '+' || text_[i] == '-')) ++i;
      if (digits() > 0) {
        is_int = false;
      } else {
        i = exponent_at;
      }
    }
    at_ = i;
    const char* const first = text_.data() + start;
    const char* const last = text_.data() + i;
    if (is_int) {
      std::int64_t value = 0;
      if (std::from_chars(first, last, value).ec == std::errc{}) return Json(value);
    }
    double value = 0.0;
    if (std::from_chars(first, last, value).ec == std::errc::result_out_of_range) {
      // Too large or too small for a double: infinity or zero, as Python reads it.
      value =
          IsTooLarge(std::string_view(first, last)) ? std::numeric_limits<double>::infinity() : 0.0;
      if (*first == '-') value = -value;
    }
    return Json(value);
  }

  std::uint32_t ParseHex4() {
    std::uint32_t unit = 0;
    const char* const first = text_.data() + at_;
    if (at_ + 4 > text_.size() || std::from_chars(first, first + 4, unit, 16).ptr != first + 4) {
      Fail("Invalid \\uXXXX escape", at_ - 1);
    }
    at_ += 4;
    return unit;
  }

  std::string ParseString() {
    const std::size_t start = at_++;
    std::string out;
    for (;;) {
      const std::size_t run = at_;
      while (at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\\' &&
             static_cast<unsigned char>(text_[at_]) >= 0x20) {
        ++at_;
      }
      out.append(text_.substr(run, at_ - run));
      if (at_ >= text_.size()) Fail("Unterminated string starting at", start);
      const char c = text_[at_];
      if (c == '"') {
        ++at_;
        return Mended(std::move(out));
      }
      if (c != '\\') Fail("Invalid control character at", at_);
      ParseEscape(out, start);
    }
  }

  void ParseEscape(std::string& out, std::size_t string_start) {
    const std::size_t escape_at = at_++;
    if (at_ >= text_.size()) Fail("Unterminated string starting at", string_start);
    static constexpr std::string_view kFrom = "\"\\/bfnrt";
    static constexpr std::string_view kTo = "\"\\/\b\f\n\r\t";
    const char c = text_[at_++];
    if (c != 'u') {
      const std::size_t k = kFrom.find(c);
      if (k == std::string_view::npos) Fail("Invalid \\escape", escape_at);
      out.push_back(kTo[k]);
      return;
    }
    std::uint32_t code = ParseHex4();
    if (code >= 0xD800 && code < 0xDC00 && text_.substr(at_, 2) == "\\u") {
      const std::size_t second_at = at_;
      at_ += 2;
      const std::uint32_t low = ParseHex4();
      if (low >= 0xDC00 && low < 0xE000) {
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
      } else {
        at_ = second_at;
      }
    }
    if (code >= 0xD800 && code < 0xE000) code = 0xFFFD;  // half a pair has no UTF-8
    AppendUtf8(out, code);
  }

  Json ParseArray(int depth) {
    ++at_;
    Json::Array items;
    SkipSpace();
    if (Take(']')) return Json(std::move(items));
    for (;;) {
      SkipSpace();
      items.push_back(ParseValue(depth + 1));
      SkipSpace();
      if (Take(']')) return Json(std::move(items));
      if (!Take(',')) Fail("Expecting ',' delimiter", at_);
    }
  }

  Json ParseObject(int depth) {
    ++at_;
    Json::Object members;
    SkipSpace();
    if (Take('}')) return Json(std::move(members));
    for (;;) {
      SkipSpace();
      if (at_ >= text_.size() || text_[at_] != '"') {
        Fail("Expecting property name enclosed in double quotes", at_);
      }
      std::string key = ParseString();
      SkipSpace();
      if (!Take(':')) Fail("Expecting ':' delimiter", at_);
      SkipSpace();
      members.emplace_back(std::move(key), ParseValue(depth + 1));
      SkipSpace();
      if (Take('}')) return Json(std::move(members));
      if (!Take(',')) Fail("Expecting ',' delimiter", at_);
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
};

Json Json::Parse(std::string_view text) { return JsonParser(text).ParseDocument(); }

const char* Json::TypeName() const {
  static constexpr std::array kNames = {"null",     "true or false", "a number", "a number",
                                        "a string", "a list",        "an object"};
  return kNames[value_.index()];
}

double Json::AsDouble() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
    return static_cast<double>(*integer);
  }
  return std::get<double>(value_);
}

const Json* Json::Find(std::string_view key) const {
  const auto* members = std::get_if<Object>(&value_);
  if (members == nullptr) return nullptr;
  for (auto member = members->rbegin(); member != members->rend(); ++member) {
    if (member->first == key) return &member->second;
  }
  return nullptr;
}

void Json::Set(std::string_view key, Json value) {
  for (Member& member : std::get<Object>(value_)) {
    if (member.first == key) {
      member.second = std::move(value);
      return;
    }
  }
  std::get<Object>(value_).emplace_back(std::string(key), std::move(value));
}

bool Json::IsFalsy() const {
  struct Visitor {
    bool operator()(std::nullptr_t) const { return true; }
    bool operator()(bool value) const { return !value; }
    bool operator()(std::int64_t value) const { return value == 0; }
    bool operator()(double value) const { return value == 0.0; }
    bool operator()(const std::string& value) const { return value.empty(); }
    bool operator()(const Array& value) const { return value.empty(); }
    bool operator()(const Object& value) const { return value.empty(); }
  };
  return std::visit(Visitor{}, value_);
}

void AppendJson(std::string& out, std::int64_t value) {
  std::array<char, 24> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end);
}

void AppendJson(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "NaN";
    return;
  }
  if (std::isinf(value)) {
    out += value < 0 ? "-Infinity" : "Infinity";
    return;
  }
  // Python's repr: the shortest digits that read back the same, with an exponent only below 1e-4
  // and from 1e16 on. to_chars gives the digits; they are laid out anew.
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific)
          .ptr;
  std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  if (number.front() == '-') {
    out.push_back('-');
    number.remove_prefix(1);
  }
  const std::size_t e = number.find('e');
  int exponent = 0;
  const char* exponent_first = number.data() + e + 1;
  if (*exponent_first == '+') ++exponent_first;
  std::from_chars(exponent_first, number.data() + number.size(), exponent);
  std::array<char, 24> digits{};
  int count = 0;
  for (const char c : number.substr(0, e)) {
    if (c != '.') digits[static_cast<std::size_t>(count++)] = c;
  }
  const auto append = [&](int from, int to) {
    if (to > from) out.append(digits.data() + from, static_cast<std::size_t>(to - from));
  };
  if (exponent < -4 || exponent >= 16) {
    append(0, 1);
    if (count > 1) out.push_back('.');
    append(1, count);
    out += exponent < 0 ? "e-" : "e+";
    const int magnitude = exponent < 0 ? -exponent : exponent;
    if (magnitude < 10) out.push_back('0');
    AppendJson(out, std::int64_t{magnitude});
  } else if (exponent < 0) {
    out += "0.";
    out.append(static_cast<std::size_t>(-exponent - 1), '0');
    append(0, count);
  } else if (count <= exponent + 1) {
    append(0, count);
    out.append(static_cast<std::size_t>(exponent + 1 - count), '0');
    out += ".0";
  } else {
    append(0, exponent + 1);
    out.push_back('.');
    append(exponent + 1, count);
  }
}

void AppendJson(std::string& out, std::string_view value) {
  out.push_back('"');
  for (std::size_t i = 0; i < value.size();) {
    const std::uint32_t code = NextCodePoint(value, i);
    switch (code) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\r':
        out += "\\r";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\b':
        out += "\\b";
        break;
      case '\f':
        out += "\\f";
        break;
      default:
        if (code >= 0x20 && code < 0x7F) {
          out.push_back(static_cast<char>(code));
        } else if (code < 0x10000) {
          AppendEscaped(out, code);
        } else {
          AppendEscaped(out, 0xD800 + ((code - 0x10000) >> 10));
          AppendEscaped(out, 0xDC00 + ((code - 0x10000) & 0x3FF));
        }
    }
  }
  out.push_back('"');
}

namespace {

void AppendValue(std::string& out, const Json& value) {
  if (value.IsNull()) {
    out += "null";
  } else if (value.IsBool()) {
    out += value.AsBool() ? "true" : "false";
  } else if (value.IsInt()) {
    AppendJson(out, value.AsInt());
  } else if (value.IsNumber()) {
    AppendJson(out, value.AsDouble());
  } else if (value.IsString()) {
    AppendJson(out, std::string_view(value.AsString()));
  } else if (value.IsArray()) {
    out.push_back('[');
    const char* separator = "";
    for (const Json& item : value.AsArray()) {
      out += separator;
      AppendValue(out, item);
      separator = ", ";
    }
    out.push_back(']');
  } else {
    out.push_back('{');
    const char* separator = "";
    for (const auto& [key, member] : value.AsObject()) {
      out += separator;
      AppendJson(out, std::string_view(key));
      out += ": ";
      AppendValue(out, member);
      separator = ", ";
    }
    out.push_back('}');
  }
}

}  // namespace

std::string Json::Dump() const {
  std::string out;
  AppendValue(out, *this);
  return out;
}

}  // namespace ccmorse
