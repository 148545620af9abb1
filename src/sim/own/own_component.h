#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"

namespace ccmorse::sim {

class OwnComponent;

/// What runs the code of components of one's own. Where there is none, as in a replay, they keep
/// the data that they are given, and their services answer nothing.
class OwnCode {
 public:
  virtual ~OwnCode() = default;
  /// A service that answers at once. Throws ServiceFailed and WrongArgument as Service::run does.
  virtual Json Call(OwnComponent& component, const std::string& service, Arguments arguments) = 0;
  /// One that answers later, likewise.
  virtual void Start(OwnComponent& component, const std::string& service, Arguments arguments,
                     Completion done) = 0;
  /// Component::Interrupt()
  virtual void Interrupt(OwnComponent& component) = 0;
};

/// What sensors and actuators of one's own have in common (docs/components.md): the simulator has
/// their data and the list of their services, the code that fills the ones and does the others is a
/// user's, and runs elsewhere. What it changes comes as inputs of the run. Not thread safe.
class OwnComponent {
 public:
  virtual ~OwnComponent() = default;

  Component& component() const { return component_; }
  const scene::OwnDef& def() const { return def_; }

  /// Lets its services be answered. The code outlives the simulation's use of it.
  void set_code(OwnCode* code) { code_ = code; }

  /// Its data without timestamp, an object.
  const Json& data() const { return data_; }
  /// Replaces them, at simulated time `time`, s; `data` is an object.
  virtual void SetData(Json data, double time) = 0;

  /// Has anything but its own code changed data or properties since it was last asked? Asking
  /// forgets it.
  bool TakeDataChanged() { return std::exchange(data_changed_, false); }
  bool TakePropertiesChanged() { return std::exchange(properties_changed_, false); }

 protected:
  OwnComponent(Component& component, const scene::ComponentDef& def);

  // For the one class that is both this and a Component.
  using Value = std::variant<double, bool, std::string>;
  std::vector<Service> MakeServices();
  void KeepData(Json data);
  std::string_view text() const { return text_; }  ///< the data as a Component appends its fields
  /// Throws WrongArgument unless `message` has a value of the right type for each of its fields.
  void Check(const Json& message) const;
  std::deque<std::pair<std::string, Value>>& values() { return values_; }
  void InterruptCode() {
    if (code_ != nullptr) code_->Interrupt(*this);
  }
  void NoteDataChanged() { data_changed_ = true; }
  void NotePropertiesChanged() { properties_changed_ = true; }

 private:
  Component& component_;
  scene::OwnDef def_;
  OwnCode* code_ = nullptr;
  Json data_;
  std::string text_;
  std::deque<std::pair<std::string, Value>> values_;  // of properties
  bool data_changed_ = false;
  bool properties_changed_ = false;
};

/// The half of them that is alike for both: Base is Sensor or Actuator.
template <typename Base>
class OwnDevice : public Base, public OwnComponent {
 public:
  OwnDevice(Robot& robot, const scene::ComponentDef& def);

  void Interrupt() override { InterruptCode(); }
  void SetData(Json data, double time) override;
  void AddToHash(StateHash& hash) const override { hash.Add(text()); }

 private:
  void AppendFields(std::string& out) const override { out += text(); }
  void PropertyChanged() override { NotePropertiesChanged(); }
};

/// A sensor of one's own. Its sample is what its code makes of the moment, which is asked after all
/// other sensors have looked.
class OwnSensor : public OwnDevice<Sensor> {
 public:
  using OwnDevice::OwnDevice;
  void Sample(const Instant& now) override { DataChanged(now.time); }
};

/// An actuator of one's own. Its code acts just before those of the simulator do.
class OwnActuator : public OwnDevice<Actuator> {
 public:
  using OwnDevice::OwnDevice;
  void Act(const Instant& now) override { DataChanged(now.time); }
  /// Takes only what has a value of the right type for each of its fields: no client must be able
  /// to stop it by a message of which its code can make nothing.
  void Receive(const Json& message) override;
};

/// The component that a definition with `own` asks for.
Component& AddOwn(Robot& robot, const scene::ComponentDef& def);

}  // namespace ccmorse::sim
