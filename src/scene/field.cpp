#include "scene/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/trig.h"

namespace ccmorse::scene {
namespace {

struct NamedColor {
  const char* name;
  Color color;
};

// The colours of the course's CCanvas (specs: syrotek.md C) with their X11 values, gray49 being
// what SyRoTek's world file gives its static obstacles.
constexpr std::array kColors = {
    NamedColor{"black", {0, 0, 0}},        NamedColor{"blue", {0, 0, 255}},
    NamedColor{"brown", {165, 42, 42}},    NamedColor{"cyan", {0, 255, 255}},
    NamedColor{"darkblue", {0, 0, 160}},   NamedColor{"gray", {128, 128, 128}},
    NamedColor{"gray49", {125, 125, 125}}, NamedColor{"green", {0, 128, 0}},
    NamedColor{"grey", {128, 128, 128}},   NamedColor{"lightblue", {173, 216, 230}},
    NamedColor{"lime", {0, 255, 0}},       NamedColor{"magenta", {255, 0, 255}},
    NamedColor{"maroon", {128, 0, 0}},     NamedColor{"olive", {128, 128, 0}},
    NamedColor{"orange", {255, 165, 0}},   NamedColor{"purple", {128, 0, 128}},
    NamedColor{"red", {255, 0, 0}},        NamedColor{"silver", {192, 192, 192}},
    NamedColor{"white", {255, 255, 255}},  NamedColor{"yellow", {255, 255, 0}},
};

std::vector<std::string> ColorNames() {
  std::vector<std::string> names;
  for (const NamedColor& entry : kColors) names.emplace_back(entry.name);
  return names;
}

std::string RangeText(const Range& range) {
  if (range.above_min) return fmt::format("more than {} and at most {}", range.min, range.max);
  return fmt::format("{}..{}", range.min, range.max);
}

// "#1e90ff" as a colour; false when the text is no such thing.
bool ParseHexColor(const std::string& text, Color& color) {
  if (text.size() != 7 || text[0] != '#') return false;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const first = text.data() + 1 + 2 * i;
    if (std::from_chars(first, first + 2, channels[i], 16).ptr != first + 2) return false;
  }
  color = {channels[0], channels[1], channels[2]};
  return true;
}

// What to say to somebody who wrote `key`: the nearest known key, else one that starts alike (a
// 'position' is a 'pose' here), else all of them.
std::string Hint(const std::string& key, const std::vector<std::string>& known) {
  const std::string near = DidYouMean(key, known);
  if (!near.empty()) return near;
  for (const std::string& name : known) {
    if (name.size() > 3 && key.compare(0, 3, name, 0, 3) == 0) {
      return fmt::format("; did you mean '{}'?", name);
    }
  }
  return "; known are " + Listed(known);
}

bool IsContinuationByte(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::string Printable(std::string_view text) {
  constexpr std::size_t kLongest = 64;
  std::size_t length = std::min(text.size(), kLongest);
  // Not in the middle of a UTF-8 character.
  while (length > 0 && length < text.size() && IsContinuationByte(text[length])) --length;
  std::string out;
  for (const char c : text.substr(0, length)) {
    const auto byte = static_cast<unsigned char>(c);
    out.push_back(byte < 0x20 || byte == 0x7F ? '?' : c);
  }
  if (length < text.size()) out += "...";
  return out;
}

std::string Quoted(std::string_view text) { return "'" + Printable(text) + "'"; }

std::string Listed(std::span<const std::string> names) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 == names.size() ? " and " : ", ";
    out += names[i];
  }
  return out;
}

std::string ColorText(Color color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

void Field::Fail(const std::string& text) const {
  throw Error(fmt::format("{}:{}: {}", file(), line(), text));
}

void Field::FailHere(const std::string& text) const {
  Fail((path_.empty() ? "the file" : path_) + " " + text);
}

double Field::Number(const Range& range) const {
  if (!value().IsNumber()) FailHere(fmt::format("must be a number, not {}", value().TypeName()));
  const double number = value().AsDouble();
  if (!std::isfinite(number)) FailHere("must be a finite number");
  if (number < range.min || number > range.max || (range.above_min && number <= range.min)) {
    FailHere(fmt::format("is {}, must be {}", number, RangeText(range)));
  }
  return number;
}

std::int64_t Field::Integer(std::int64_t min, std::int64_t max) const {
  if (!value().IsNumber()) {
    FailHere(fmt::format("must be a whole number, not {}", value().TypeName()));
  }
  std::int64_t number = 0;
  if (value().IsInt()) {
    number = value().AsInt();
  } else {
    const double real = value().AsDouble();
    // Beyond 2^53 a double no longer tells neighbouring whole numbers apart.
    if (!(std::abs(real) <= 9007199254740992.0) || real != std::floor(real)) {
      FailHere(fmt::format("must be a whole number {}..{}, not {}", min, max, real));
    }
    number = static_cast<std::int64_t>(real);
  }
  if (number < min || number > max) {
    FailHere(fmt::format("is {}, must be {}..{}", number, min, max));
  }
  return number;
}

bool Field::Bool() const {
  if (!value().IsBool()) FailHere(fmt::format("must be true or false, not {}", value().TypeName()));
  return value().AsBool();
}

const std::string& Field::Text() const {
  if (!value().IsString()) FailHere(fmt::format("must be a string, not {}", value().TypeName()));
  return value().AsString();
}

std::string Field::Choice(std::span<const std::string> choices) const {
  const std::string& text = Text();
  if (std::find(choices.begin(), choices.end(), text) == choices.end()) {
    std::vector<std::string> quoted;
    for (const std::string& choice : choices) quoted.push_back(Quoted(choice));
    FailHere(fmt::format("is {}, must be {}{}{}", Quoted(text), choices.size() > 1 ? "one of " : "",
                         Listed(quoted), DidYouMean(text, choices)));
  }
  return text;
}

std::string Field::Identifier() const {
  const std::string& text = Text();
  const bool good =
      !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
      });
  if (!good) {
    FailHere(fmt::format("is {}, must be 1 to 64 letters, digits or _", Quoted(text)));
  }
  return text;
}

Color Field::ReadColor() const {
  constexpr const char* kForms = "a colour: \"#rrggbb\", [r, g, b] of 0..255 or a name";
  if (value().IsArray()) {
    const std::vector<Field> items = Items();
    if (items.size() != 3) {
      FailHere(fmt::format("has {} numbers, must be {}", items.size(), kForms));
    }
    const auto channel = [&items](std::size_t i) {
      return static_cast<std::uint8_t>(items[i].Integer(0, 255));
    };
    return {channel(0), channel(1), channel(2)};
  }
  if (!value().IsString()) FailHere(fmt::format("must be {}, not {}", kForms, value().TypeName()));
  const std::string& text = value().AsString();
  Color color;
  if (ParseHexColor(text, color)) return color;
  for (const NamedColor& entry : kColors) {
    if (text == entry.name) return entry.color;
  }
  const std::vector<std::string> names = ColorNames();
  FailHere(fmt::format("is {}, must be \"#rrggbb\", [r, g, b] of 0..255, or one of {}{}",
                       Quoted(text), Listed(names), DidYouMean(text, names)));
}

Vec3 Field::Vector(double limit) const {
  const std::vector<Field> items = Items();
  if (items.size() != 3) {
    FailHere(fmt::format("has {} numbers, must be [x, y, z]", items.size()));
  }
  const Range range{-limit, limit};
  return {items[0].Number(range), items[1].Number(range), items[2].Number(range)};
}

std::vector<Field> Field::Items() const {
  if (!value().IsArray()) FailHere(fmt::format("must be a list, not {}", value().TypeName()));
  std::vector<Field> items;
  for (const Json& item : value().AsArray()) {
    items.emplace_back(item, fmt::format("{}[{}]", path_, items.size()), *file_);
  }
  return items;
}

ObjectReader::ObjectReader(Field object) : object_(std::move(object)) {
  if (!object_.value().IsObject()) {
    object_.FailHere(fmt::format("must be an object {{...}}, not {}", object_.value().TypeName()));
  }
  std::set<std::string> seen;
  for (const auto& [key, value] : object_.value().AsObject()) {
    if (seen.insert(key).second) continue;
    const int first =
        std::find_if(object_.value().AsObject().begin(), object_.value().AsObject().end(),
                     [&key = key](const Json::Member& m) { return m.first == key; })
            ->second.line();
    Field(value, "", object_.file())
        .Fail(fmt::format("key {} is given twice{}, first on line {}; remove one", Quoted(key),
                          object_.path().empty() ? "" : " in " + object_.path(), first));
  }
}

const Json* ObjectReader::Find(const std::string& key) {
  asked_.insert(key);
  return object_.value().Find(key);
}

bool ObjectReader::Has(const std::string& key) { return Find(key) != nullptr; }

Field ObjectReader::Require(const std::string& key) {
  const Json* const value = Find(key);
  if (value == nullptr) {
    std::vector<std::string> unused;
    for (const auto& member : object_.value().AsObject()) {
      if (!asked_.contains(member.first)) unused.push_back(member.first);
    }
    const std::string meant = NearestName(key, unused);
    object_.FailHere(fmt::format(
        "lacks '{}'{}", key, meant.empty() ? "" : fmt::format("; is {} meant?", Quoted(meant))));
  }
  const std::string name = Printable(key);
  const std::string path = object_.path().empty() ? name : object_.path() + "." + name;
  return {*value, path, object_.file()};
}

double ObjectReader::Number(const std::string& key, double fallback, const Range& range) {
  return Has(key) ? Require(key).Number(range) : fallback;
}

int ObjectReader::Integer(const std::string& key, int fallback, int min, int max) {
  return Has(key) ? static_cast<int>(Require(key).Integer(min, max)) : fallback;
}

bool ObjectReader::Bool(const std::string& key, bool fallback) {
  return Has(key) ? Require(key).Bool() : fallback;
}

std::string ObjectReader::Choice(const std::string& key, const std::string& fallback,
                                 std::span<const std::string> choices) {
  return Has(key) ? Require(key).Choice(choices) : fallback;
}

Color ObjectReader::ReadColor(const std::string& key, Color fallback) {
  return Has(key) ? Require(key).ReadColor() : fallback;
}

Vec3 ObjectReader::Vector(const std::string& key, Vec3 fallback, double limit) {
  return Has(key) ? Require(key).Vector(limit) : fallback;
}

double ObjectReader::Angle(const std::string& key, double fallback) {
  // A few turns are harmless; a number in the thousands is a mistake in the unit.
  constexpr double kTurns = 10.0;
  const std::string key_deg = key + "_deg";
  const bool in_degrees = Has(key_deg);
  if (!Has(key)) {
    return in_degrees ? Radians(Require(key_deg).Number({-360.0 * kTurns, 360.0 * kTurns}))
                      : fallback;
  }
  if (in_degrees) {
    Require(key_deg).Fail(
        fmt::format("{} has both '{}' and '{}'; keep one", object_.path(), key, key_deg));
  }
  return Require(key).Number({-2.0 * kPi * kTurns, 2.0 * kPi * kTurns});
}

void ObjectReader::Finish() const {
  for (const auto& [key, value] : object_.value().AsObject()) {
    if (asked_.contains(key)) continue;
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    const std::string hint = Hint(key, known);
    Field(value, "", object_.file())
        .Fail(fmt::format("unknown key {}{}{}", Quoted(key),
                          object_.path().empty() ? "" : " in " + object_.path(), hint));
  }
}

}  // namespace ccmorse::scene
