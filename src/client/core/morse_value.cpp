#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "base/json.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseValue.h"

namespace CCMorse {

using ccmorse::Json;

namespace {

const Json& NullJson() {
  static const Json null;
  return null;
}

}  // namespace

MorseValue::MorseValue() = default;

MorseValue::MorseValue(std::shared_ptr<const Json> root, const Json* node)
    : root_(std::move(root)), node_(node) {
  if (node_ && node_->IsNull()) node_ = nullptr;
}

MorseValue MorseValue::Parse(const std::string& text) {
  try {
    auto root = std::make_shared<const Json>(Json::Parse(text));
    const Json* node = root.get();
    return MorseValue(std::move(root), node);
  } catch (const ccmorse::JsonError& error) {
    throw MorseError(error.what(), "MorseValue::Parse()");
  }
}

const Json* MorseValue::Find(const std::string& path) const {
  const Json* node = node_ ? node_ : &NullJson();
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::size_t dot = rest.find('.');
    const std::string_view key = rest.substr(0, dot);
    rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
    if (node->IsArray()) {
      std::size_t index = 0;
      const auto parsed = std::from_chars(key.data(), key.data() + key.size(), index);
      if (parsed.ec != std::errc() || parsed.ptr != key.data() + key.size()) return nullptr;
      if (index >= node->AsArray().size()) return nullptr;
      node = &node->AsArray()[index];
    } else {
      node = node->Find(key);
      if (!node) return nullptr;
    }
  }
  return node;
}

bool MorseValue::IsNull() const { return node_ == nullptr; }
bool MorseValue::IsNumber() const { return node_ && node_->IsNumber(); }
bool MorseValue::IsString() const { return node_ && node_->IsString(); }
bool MorseValue::IsList() const { return node_ && node_->IsArray(); }
bool MorseValue::IsObject() const { return node_ && node_->IsObject(); }
bool MorseValue::IsTrue() const { return node_ && !node_->IsFalsy(); }
bool MorseValue::Has(const std::string& path) const { return Find(path) != nullptr; }

MorseValue MorseValue::Get(const std::string& path) const { return MorseValue(root_, Find(path)); }

double MorseValue::GetDouble(const std::string& path, double fallback) const {
  const Json* node = Find(path);
  return node && node->IsNumber() ? node->AsDouble() : fallback;
}

int MorseValue::GetInt(const std::string& path, int fallback) const {
  const double value = GetDouble(path, std::numeric_limits<double>::quiet_NaN());
  if (std::isnan(value)) return fallback;
  if (value >= std::numeric_limits<int>::max()) return std::numeric_limits<int>::max();
  if (value <= std::numeric_limits<int>::min()) return std::numeric_limits<int>::min();
  return static_cast<int>(value);
}

bool MorseValue::GetBool(const std::string& path, bool fallback) const {
  const Json* node = Find(path);
  return node && node->IsBool() ? node->AsBool() : fallback;
}

std::string MorseValue::GetString(const std::string& path, const std::string& fallback) const {
  const Json* node = Find(path);
  return node && node->IsString() ? node->AsString() : fallback;
}

std::vector<double> MorseValue::GetDoubles(const std::string& path) const {
  std::vector<double> values;
  const Json* node = Find(path);
  if (!node || !node->IsArray()) return values;
  values.reserve(node->AsArray().size());
  for (const Json& item : node->AsArray()) {
    if (!item.IsNumber()) return {};
    values.push_back(item.AsDouble());
  }
  return values;
}

std::vector<std::string> MorseValue::GetStrings(const std::string& path) const {
  std::vector<std::string> values;
  const Json* node = Find(path);
  if (!node || !node->IsArray()) return values;
  for (const Json& item : node->AsArray()) {
    if (!item.IsString()) return {};
    values.push_back(item.AsString());
  }
  return values;
}

std::vector<std::string> MorseValue::GetKeys(const std::string& path) const {
  std::vector<std::string> keys;
  const Json* node = Find(path);
  if (!node || !node->IsObject()) return keys;
  for (const auto& [key, value] : node->AsObject()) keys.push_back(key);
  return keys;
}

std::size_t MorseValue::GetSize(const std::string& path) const {
  const Json* node = Find(path);
  if (node && node->IsArray()) return node->AsArray().size();
  if (node && node->IsObject()) return node->AsObject().size();
  return 0;
}

MorseValue MorseValue::At(std::size_t index) const {
  if (!IsList() || index >= node_->AsArray().size()) return MorseValue();
  return MorseValue(root_, &node_->AsArray()[index]);
}

MorseValue MorseValue::Member(const std::string& key) const {
  return MorseValue(root_, node_ ? node_->Find(key) : nullptr);
}

std::string MorseValue::ToString() const { return node_ ? node_->Dump() : "null"; }

void MorseArgs::Separate() {
  if (!items_.empty()) items_ += ", ";
}

MorseArgs& MorseArgs::Add(bool value) {
  Separate();
  items_ += value ? "true" : "false";
  return *this;
}

MorseArgs& MorseArgs::Add(int value) {
  Separate();
  ccmorse::AppendJson(items_, std::int64_t{value});
  return *this;
}

MorseArgs& MorseArgs::Add(double value) {
  Separate();
  ccmorse::AppendJson(items_, value);
  return *this;
}

MorseArgs& MorseArgs::Add(const char* value) {
  Separate();
  ccmorse::AppendJson(items_, std::string_view(value));
  return *this;
}

MorseArgs& MorseArgs::Add(const std::string& value) {
  Separate();
  ccmorse::AppendJson(items_, std::string_view(value));
  return *this;
}

MorseArgs& MorseArgs::Add(const MorseArgs& list) {
  Separate();
  items_ += list.ToList();
  return *this;
}

MorseArgs& MorseArgs::Add(const MorseValue& value) {
  Separate();
  items_ += value.ToString();
  return *this;
}

std::string MorseArgs::ToString() const { return items_.empty() ? "" : ToList(); }

}  // namespace CCMorse
