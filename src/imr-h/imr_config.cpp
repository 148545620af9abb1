#include "imr-h/imr_config.h"

#include <array>
#include <charconv>
#include <cmath>
#include <ostream>
#include <system_error>

#include "base/nearest_name.h"

namespace imr {
namespace {

const char* typeName(CConfig::TType type) {
  switch (type) {
    case CConfig::STRING:
      return "string";
    case CConfig::INT:
      return "int";
    case CConfig::DOUBLE:
      return "double";
    case CConfig::FLOAT:
      return "float";
    case CConfig::BOOL:
      return "bool";
    case CConfig::NUM_TYPES:
      break;
  }
  return "unknown";
}

// The shortest text that reads back as the same number; never depends on the locale.
template <typename T>
std::string numberText(T number) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return std::string(buffer.data(), result.ptr);
}

// Reads a number that fills the whole text; a leading plus sign is fine, infinity is not.
template <typename T>
std::optional<T> numberFrom(const std::string& text) {
  const char* first = text.data();
  const char* const last = first + text.size();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++first;
  T number{};
  const auto result = std::from_chars(first, last, number);
  if (result.ec != std::errc() || result.ptr != last) return std::nullopt;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(number)) return std::nullopt;
  }
  return number;
}

std::optional<bool> boolFrom(const std::string& text) {
  for (const char* yes : {"true", "yes", "on", "1"}) {
    if (text == yes) return true;
  }
  for (const char* no : {"false", "no", "off", "0"}) {
    if (text == no) return false;
  }
  return std::nullopt;
}

template <typename Value>
std::string valueText(const Value& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, std::string>) {
          return v;
        } else if constexpr (std::is_same_v<T, bool>) {
          return v ? "true" : "false";
        } else {
          return numberText(v);
        }
      },
      value);
}

}  // namespace

void CConfig::addOption(const std::string& name, const std::string& description, Value value,
                        bool hasDefault) {
  assert_usage(!name.empty(), "an option must have a name");
  assert_usage(!has(name), "option \"" + name + "\" is added twice");
  const TType type = static_cast<TType>(value.index());
  options_.push_back(
      SOption{name, description, value, hasDefault ? std::optional<Value>(value) : std::nullopt});
  items_.push_back(SItem{name, type});
}

const CConfig::SOption& CConfig::find(const std::string& name) const {
  for (const SOption& option : options_) {
    if (option.name == name) return option;
  }
  NameList known;
  std::string list;
  for (const SItem& item : items_) {
    known.push_back(item.name);
    list += (list.empty() ? "" : ", ") + item.name;
  }
  throw bad_usage("unknown option \"" + name + "\"" + ccmorse::DidYouMean(name, known) +
                  " (known: " + (list.empty() ? "none" : list) + ")");
}

const CConfig::SOption& CConfig::checked(const std::string& name, TType type) const {
  const SOption& option = find(name);
  const TType actual = static_cast<TType>(option.value.index());
  if (actual != type) {
    throw bad_usage("option \"" + name + "\" is of type " + typeName(actual) + ", not " +
                    typeName(type));
  }
  return option;
}

CConfig::Value CConfig::parse(const SOption& option, const std::string& text) const {
  const auto refuse = [&](const char* wanted) {
    return bad_usage("option \"" + option.name + "\" needs " + wanted + ", not \"" + text + "\"");
  };
  switch (static_cast<TType>(option.value.index())) {
    case INT:
      if (const auto number = numberFrom<int>(text)) return Value(*number);
      throw refuse("a whole number");
    case DOUBLE:
      if (const auto number = numberFrom<double>(text)) return Value(*number);
      throw refuse("a number");
    case FLOAT:
      if (const auto number = numberFrom<float>(text)) return Value(*number);
      throw refuse("a number");
    case BOOL:
      if (const auto flag = boolFrom(text)) return Value(*flag);
      throw refuse("true or false");
    case STRING:
    case NUM_TYPES:
      break;
  }
  return Value(text);
}

bool CConfig::has(const std::string& name) const {
  for (const SOption& option : options_) {
    if (option.name == name) return true;
  }
  return false;
}

CConfig::TType CConfig::getType(const std::string& name) const {
  return static_cast<TType>(find(name).value.index());
}

std::string CConfig::getText(const std::string& name) const { return valueText(find(name).value); }

std::string CConfig::getDefaultText(const std::string& name) const {
  const SOption& option = find(name);
  return option.defaultValue ? valueText(*option.defaultValue) : "";
}

const std::string& CConfig::getDescriptionText(const std::string& name) const {
  return find(name).description;
}

void CConfig::setText(const std::string& name, const std::string& text) {
  const SOption& option = find(name);
  const_cast<SOption&>(option).value = parse(option, text);
}

void CConfig::checkText(const std::string& name, const std::string& text) const {
  parse(find(name), text);
}

void CConfig::print(std::ostream& out) const {
  for (const SOption& option : options_) {
    out << option.name << '=' << valueText(option.value) << '\n';
  }
}

}  // namespace imr
