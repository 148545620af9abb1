// Json::Parse. What must hold, whatever the bytes:
// - the result is a value or a JsonError of one line that points into the text;
// - Dump() is one line of printable ASCII that parses again, to an equal value if all strings were
//   well-formed UTF-8 (others are mended), and dumps to the same text then;
// - a number alone is what the C library makes of it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/json.h"
#include "fuzz/check.h"

namespace {

using ccmorse::Json;
using ccmorse::JsonError;
using ccmorse::fuzz::Require;

// Unicode's table 3-7, written out differently from the code under test.
bool IsWellFormed(std::string_view text) {
  const auto in = [text](std::size_t i, int low, int high) {
    const int byte = i < text.size() ? static_cast<unsigned char>(text[i]) : -1;
    return byte >= low && byte <= high;
  };
  std::size_t i = 0;
  while (i < text.size()) {
    if (in(i, 0x00, 0x7F)) {
      i += 1;
    } else if (in(i, 0xC2, 0xDF) && in(i + 1, 0x80, 0xBF)) {
      i += 2;
    } else if ((in(i, 0xE0, 0xE0) && in(i + 1, 0xA0, 0xBF) && in(i + 2, 0x80, 0xBF)) ||
               (in(i, 0xE1, 0xEC) && in(i + 1, 0x80, 0xBF) && in(i + 2, 0x80, 0xBF)) ||
               (in(i, 0xED, 0xED) && in(i + 1, 0x80, 0x9F) && in(i + 2, 0x80, 0xBF)) ||
               (in(i, 0xEE, 0xEF) && in(i + 1, 0x80, 0xBF) && in(i + 2, 0x80, 0xBF))) {
      i += 3;
    } else if ((in(i, 0xF0, 0xF0) && in(i + 1, 0x90, 0xBF) && in(i + 2, 0x80, 0xBF) &&
                in(i + 3, 0x80, 0xBF)) ||
               (in(i, 0xF1, 0xF3) && in(i + 1, 0x80, 0xBF) && in(i + 2, 0x80, 0xBF) &&
                in(i + 3, 0x80, 0xBF)) ||
               (in(i, 0xF4, 0xF4) && in(i + 1, 0x80, 0x8F) && in(i + 2, 0x80, 0xBF) &&
                in(i + 3, 0x80, 0xBF))) {
      i += 4;
    } else {
      return false;
    }
  }
  return true;
}

bool SameText(const std::string& a, const std::string& b) { return a == b || !IsWellFormed(a); }

// Equality for which NaN equals NaN, -0.0 differs from 0.0 and 1 from 1.0.
bool Same(const Json& a, const Json& b) {
  if (a.IsArray()) {
    return b.IsArray() && std::equal(a.AsArray().begin(), a.AsArray().end(), b.AsArray().begin(),
                                     b.AsArray().end(), Same);
  }
  if (a.IsObject()) {
    return b.IsObject() &&
           std::equal(a.AsObject().begin(), a.AsObject().end(), b.AsObject().begin(),
                      b.AsObject().end(), [](const Json::Member& x, const Json::Member& y) {
                        return SameText(x.first, y.first) && Same(x.second, y.second);
                      });
  }
  if (a.IsString()) return b.IsString() && SameText(a.AsString(), b.AsString());
  if (a.IsNumber() && !a.IsInt()) {
    if (!b.IsNumber() || b.IsInt()) return false;
    const double x = a.AsDouble();
    const double y = b.AsDouble();
    return (std::isnan(x) && std::isnan(y)) || (x == y && std::signbit(x) == std::signbit(y));
  }
  return a == b;
}

void CheckError(const JsonError& error, std::string_view text) {
  const std::string what = error.what();
  Require(what.find('\n') == std::string::npos, "a JsonError is one line", what);
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  Require(error.line() >= 1 && error.line() <= lines, "a JsonError points into the text", what);
  Require(error.column() >= 1 && static_cast<std::size_t>(error.column()) <= text.size() + 1,
          "a JsonError points into the text", what);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  Json value;
  try {
    value = Json::Parse(text);
  } catch (const JsonError& error) {
    CheckError(error, text);
    return 0;
  }
  const std::string dump = value.Dump();
  Require(std::all_of(dump.begin(), dump.end(), [](char c) { return c >= 0x20 && c < 0x7F; }),
          "a dump is printable ASCII", dump);
  const Json again = Json::Parse(dump);
  Require(Same(value, again), "a dump parses to an equal value", dump);
  Require(again.Dump() == dump, "parsing and dumping again changes nothing", dump);
  if (value.IsNumber() && text.find_first_not_of("0123456789+-.eE") == std::string::npos) {
    const double expected = std::strtod(text.c_str(), nullptr);
    Require(value.AsDouble() == expected, "a number is read as the C library reads it", dump);
  }
  return 0;
}
