#include "sim/own/own_component.h"

#include <limits>
#include <utility>

#include "base/error.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsOfType(const Json& value, const Json& wanted) {
  if (wanted.IsNull()) return true;
  if (wanted.IsNumber()) return value.IsNumber();
  if (wanted.IsBool()) return value.IsBool();
  if (wanted.IsString()) return value.IsString();
  if (wanted.IsArray()) return value.IsArray();
  return value.IsObject();
}

}  // namespace

OwnComponent::OwnComponent(Component& component, const scene::ComponentDef& def)
    : component_(component), def_(*def.own) {
  KeepData(def_.data);
  for (const auto& [name, value] : def_.properties.AsObject()) {
    if (value.IsBool()) {
      values_.emplace_back(name, value.AsBool());
    } else if (value.IsNumber()) {
      values_.emplace_back(name, value.AsDouble());
    } else {
      values_.emplace_back(name, value.AsString());
    }
  }
}

std::vector<Service> OwnComponent::MakeServices() {
  std::vector<Service> services;
  for (const scene::OwnServiceDef& def : def_.services) {
    Service service;
    service.name = def.name;
    for (const auto& parameter : def.parameters) {
      service.parameters.push_back({parameter.name, parameter.optional});
    }
    // What it changes is an input by itself.
    service.changes_simulation = false;
    if (def.asynchronous) {
      service.start = [this, name = def.name](Arguments arguments, Completion done) {
        if (code_ == nullptr) throw ServiceFailed("Its code does not run here");
        code_->Start(*this, name, arguments, std::move(done));
      };
    } else {
      service.run = [this, name = def.name](Arguments arguments) {
        if (code_ == nullptr) throw ServiceFailed("Its code does not run here");
        return code_->Call(*this, name, arguments);
      };
    }
    services.push_back(std::move(service));
  }
  return services;
}

void OwnComponent::KeepData(Json data) {
  data_ = std::move(data);
  text_.clear();
  for (const auto& [name, value] : data_.AsObject()) {
    text_ += ", ";
    AppendJson(text_, std::string_view(name));
    text_ += ": ";
    text_ += value.Dump();
  }
}

void OwnComponent::Check(const Json& message) const {
  if (!message.IsObject()) {
    throw WrongArgument(std::string("it must be an object, not ") + message.TypeName());
  }
  for (const auto& [name, value] : def_.data.AsObject()) {
    const Json* const given = message.Find(name);
    if (given == nullptr) throw WrongArgument("'" + name + "' is missing");
    if (!IsOfType(*given, value)) {
      throw WrongArgument("'" + name + "' must be " + value.TypeName() + ", not " +
                          given->TypeName());
    }
  }
}

template <typename Base>
OwnDevice<Base>::OwnDevice(Robot& robot, const scene::ComponentDef& def)
    : Base(robot, def.name, def.type, def.frequency), OwnComponent(static_cast<Base&>(*this), def) {
  for (Service& service : MakeServices()) this->AddService(std::move(service));
  for (auto& [name, value] : values()) {
    if (auto* const number = std::get_if<double>(&value)) {
      this->AddProperty(name.c_str(), *number, -kInfinity, kInfinity);
    } else if (auto* const flag = std::get_if<bool>(&value)) {
      this->AddProperty(name.c_str(), *flag);
    } else {
      this->AddProperty(name.c_str(), std::get<std::string>(value));
    }
  }
}

template <typename Base>
void OwnDevice<Base>::SetData(Json data, double time) {
  KeepData(std::move(data));
  this->DataChanged(time);
  AddToHash(this->robot().hash());
}

template class OwnDevice<Sensor>;
template class OwnDevice<Actuator>;

void OwnActuator::Receive(const Json& message) {
  Check(message);
  SetData(message, timestamp());
  NoteDataChanged();
}

Component& AddOwn(Robot& robot, const scene::ComponentDef& def) {
  if (def.own->kind == "sensor") return robot.Add(std::make_unique<OwnSensor>(robot, def));
  return robot.Add(std::make_unique<OwnActuator>(robot, def));
}

}  // namespace ccmorse::sim
