#include "sim/component.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/euler.h"
#include "sim/modifiers/modifier.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kMostQuoted = 40;     // bytes of a wrong value in a message
constexpr std::size_t kLongestText = 1024;  // bytes of a property

template <typename T>
Json AsJson(const T& value) {
  return Json(value);
}

Json AsJson(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

}  // namespace

Component::Component(Robot& robot, const std::string& name, std::string type, double frequency)
    : robot_(robot),
      name_(name),
      full_name_(robot.name() + "." + name),
      type_(std::move(type)),
      frequency_(frequency) {}

Component::~Component() = default;

Vec3 Component::mount_euler() const {
  return is_carried() ? ToEuler(CarriedMount().rotation) : mount_euler_;
}

void Component::set_parent(Component* parent) {
  parent_ = parent;
  moves_ = moves_ || is_carried();
}

void Component::AddModifier(std::unique_ptr<Modifier> modifier) {
  for (Service& service : modifier->Services()) AddService(std::move(service));
  modifiers_.push_back(std::move(modifier));
}

void Component::Modify(std::span<const DataField> data, const Instant& now) {
  for (const auto& modifier : modifiers_) modifier->Apply(data, now);
}

void Actuator::Take(const Json& message) {
  if (!is_modified() || !message.IsObject()) return Receive(message);
  Json changed = message;
  std::vector<double> numbers;
  for (const auto& [key, value] : changed.AsObject()) {
    numbers.push_back(value.IsNumber() ? value.AsDouble() : 0.0);
  }
  std::vector<DataField> data;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& [key, value] = changed.AsObject()[i];
    if (value.IsNumber()) data.push_back({key, {&numbers[i], 1}});
  }
  Modify(data, {});
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Json& value = changed.AsObject()[i].second;
    if (value.IsNumber()) value = Json(numbers[i]);
  }
  Receive(changed);
}

bool Component::TakeDue(const Instant& now, double base_frequency) {
  if (now.tick < next_tick_) return false;
  if (frequency_ >= base_frequency) {
    next_tick_ = now.tick + 1;
    return true;
  }
  // Switched off for a while: the ones missed are not made up for.
  const double ticks = base_frequency / frequency_;
  const double next = std::floor(static_cast<double>(now.tick) / ticks + 1e-9) + 1.0;
  next_tick_ = static_cast<std::uint64_t>(std::ceil(next * ticks - 1e-9));
  return true;
}

const std::string& Component::LocalData() {
  if (!text_valid_) {
    text_ = "{\"timestamp\": ";
    AppendJson(text_, timestamp_);
    AppendFields(text_);
    text_ += '}';
    text_valid_ = true;
  }
  return text_;
}

void Component::Reset() {
  next_tick_ = 0;
  timestamp_ = 0.0;
  text_valid_ = false;
  for (const auto& modifier : modifiers_) modifier->Reset();
}

void Component::AddProperty(const char* name, double& value, double low, double high) {
  properties_.push_back({name, &value, low, high, {}});
}

void Component::AddProperty(const char* name, std::optional<double>& value, double low,
                            double high) {
  properties_.push_back({name, &value, low, high, {}});
}

void Component::AddProperty(const char* name, bool& value) {
  properties_.push_back({name, &value, 0.0, 0.0, {}});
}

void Component::AddProperty(const char* name, std::string& value,
                            std::vector<std::string> choices) {
  properties_.push_back({name, &value, 0.0, 0.0, std::move(choices)});
}

const Component::Property* Component::FindProperty(std::string_view name) const {
  const auto found = std::find_if(properties_.begin(), properties_.end(),
                                  [name](const Property& one) { return one.name == name; });
  return found != properties_.end() ? &*found : nullptr;
}

Json Component::Properties() const {
  Json properties(Json::Object{});
  for (const Property& one : properties_) {
    std::visit([&](const auto* value) { properties.Set(one.name, AsJson(*value)); }, one.value);
  }
  return properties;
}

void Component::SetProperty(std::string_view name, const Json& value) {
  const Property* const property = FindProperty(name);
  if (property == nullptr) throw WrongArgument("there is no property " + std::string(name));
  if (std::optional<double>* const* maybe = std::get_if<std::optional<double>*>(&property->value);
      maybe != nullptr && value.IsNull()) {
    (*maybe)->reset();
    return PropertyChanged();
  }
  const auto wrong = [&](const std::string& what) {
    return WrongArgument(property->name + " must be " + what + ", not " +
                         value.Dump().substr(0, kMostQuoted));
  };
  if (double* const* number = std::get_if<double*>(&property->value)) {
    double given = std::numeric_limits<double>::quiet_NaN();
    if (value.IsNumber()) given = value.AsDouble();
    // JSON has no infinity, and whoever writes it says it in Python's words.
    if (value == Json("inf")) given = std::numeric_limits<double>::infinity();
    if (!(given >= property->low && given <= property->high)) {
      throw wrong("a number from " + Json(property->low).Dump() + " to " +
                  Json(property->high).Dump());
    }
    **number = given;
  } else if (std::optional<double>* const* maybe =
                 std::get_if<std::optional<double>*>(&property->value)) {
    if (!value.IsNumber() || !(value.AsDouble() >= property->low) ||
        !(value.AsDouble() <= property->high)) {
      throw wrong("null or a number from " + Json(property->low).Dump() + " to " +
                  Json(property->high).Dump());
    }
    **maybe = value.AsDouble();
  } else if (bool* const* flag = std::get_if<bool*>(&property->value)) {
    if (!value.IsBool()) throw wrong("true or false");
    **flag = value.AsBool();
  } else {
    if (!value.IsString() || value.AsString().size() > kLongestText) throw wrong("a short text");
    const std::vector<std::string>& choices = property->choices;
    if (!choices.empty() &&
        std::find(choices.begin(), choices.end(), value.AsString()) == choices.end()) {
      std::string all;
      for (const std::string& choice : choices) all += (all.empty() ? "" : " or ") + choice;
      throw wrong(all);
    }
    *std::get<std::string*>(property->value) = value.AsString();
  }
  PropertyChanged();
}

void Component::DataChanged(double time) {
  timestamp_ = time;
  text_valid_ = false;
}

void AppendField(std::string& out, const char* key, double value) {
  out += ", \"";
  out += key;
  out += "\": ";
  AppendJson(out, value);
}

void AppendField(std::string& out, const char* key, bool value) {
  out += ", \"";
  out += key;
  out += value ? "\": true" : "\": false";
}

void AppendField(std::string& out, const char* key, const Vec3& value) {
  out += ", \"";
  out += key;
  out += "\": [";
  AppendJson(out, value.x);
  out += ", ";
  AppendJson(out, value.y);
  out += ", ";
  AppendJson(out, value.z);
  out += ']';
}

void AppendField(std::string& out, const char* key, std::string_view value) {
  out += ", \"";
  out += key;
  out += "\": ";
  AppendJson(out, value);
}

}  // namespace ccmorse::sim
