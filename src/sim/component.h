#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/json.h"
#include "base/pose.h"
#include "base/rotation.h"
#include "sim/service.h"
#include "sim/state_hash.h"

namespace ccmorse::sim {

class Modifier;
class Robot;

/// The instant a tick works on.
struct Instant {
  std::uint64_t tick = 0;  ///< from 0
  double time = 0.0;       ///< s, simulated: tick / frequency
  double step = 0.0;       ///< s, of one tick
};

/// Where something sits on a robot, in the robot's frame.
struct Mount {
  Vec3 position;  ///< m
  Rotation rotation;
};

/// Numbers of a component's data that a modifier may change, by the name that they have there.
struct DataField {
  std::string_view name;
  std::span<double> numbers;  ///< one, or three of a vector
};

/// A device of a robot, MORSE's sensor or actuator: a name, a rate, data to share and services
/// (thesis 2.4; specs: morse.md B). Belongs to its robot. Not thread safe.
class Component {
 public:
  /// `type` is MORSE's class name ("Pose"); `frequency` in Hz of simulated time.
  Component(Robot& robot, const std::string& name, std::string type, double frequency);
  virtual ~Component();
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  const std::string& full_name() const { return full_name_; }  ///< "s1r.pose"
  const std::string& name() const { return name_; }            ///< "pose"
  const std::string& type() const { return type_; }
  double frequency() const { return frequency_; }
  void set_frequency(double frequency) { frequency_ = frequency; }  ///< Hz, > 0; before the run
  Robot& robot() const { return robot_; }

  /// A component that is switched off neither samples nor acts (`simulation deactivate`).
  bool active() const { return active_; }
  void set_active(bool active) { active_ = active; }

  /// Is this tick one of the component's own? The k-th falls on the first tick at or after k /
  /// frequency; true at most once a tick.
  bool TakeDue(const Instant& now, double base_frequency);
  /// Will it be, when it is asked in this tick?
  bool IsDue(const Instant& now) const { return now.tick >= next_tick_; }

  const std::vector<Service>& services() const { return services_; }

  /// The data as MORSE sends them: one JSON object without line end, timestamp first.
  const std::string& LocalData();

  /// Simulated time of the data, s.
  double timestamp() const { return timestamp_; }

  /// Its settings by MORSE's names (MORSE's get_configurations): the properties, as they are now,
  /// unless it has others, which do not change during a run.
  virtual Json Configurations() const { return Properties(); }

  /// MORSE's properties of it as they are now, in the order in which they were added.
  Json Properties() const;
  bool HasProperty(std::string_view name) const { return FindProperty(name) != nullptr; }
  /// Sets a property that it has (MORSE's set_property), from its next activation on. Throws
  /// WrongArgument on a value of another type or out of range, and changes nothing then.
  void SetProperty(std::string_view name, const Json& value);

  /// Where it sits on its robot, m, in the robot's frame: now, as a component that it is mounted on
  /// may move it.
  virtual Vec3 mount() const { return is_carried() ? CarriedMount().position : mount_; }
  /// How it is turned there.
  virtual Rotation mount_rotation() const {
    return is_carried() ? CarriedMount().rotation : RestMount().rotation;
  }
  /// The same as roll, pitch, yaw, rad.
  Vec3 mount_euler() const;
  /// Where it sits while nothing of what it is mounted on has moved.
  Mount RestMount() const {
    return {mount_, FromEuler(mount_euler_.x, mount_euler_.y, mount_euler_.z)};
  }
  /// To be called before the run.
  void set_mount(const Vec3& position, const Vec3& euler) {
    mount_ = position;
    mount_euler_ = euler;
  }

  /// The component that it is mounted on; nullptr: the robot itself. To be called before the run,
  /// in the order from the robot outwards.
  void set_parent(Component* parent);
  Component* parent() const { return parent_; }
  /// Does anything that it is mounted on move it?
  bool is_carried() const { return parent_ != nullptr && parent_->moves_; }
  /// Called once it is known what it is mounted on. Throws Error where it cannot be there.
  virtual void Mounted() {}
  /// Where what is mounted on it, and would be `at_rest` if nothing had moved, is now. Components
  /// that move what they carry override it, and end with this.
  virtual Mount Carry(const Mount& at_rest) const {
    return parent_ != nullptr ? parent_->Carry(at_rest) : at_rest;
  }

  /// Has its data changed on their way (MORSE's alter()). To be called before the run.
  void AddModifier(std::unique_ptr<Modifier> modifier);

  /// Whether it has a stream, and services: MORSE's components have only the ones that a script
  /// gave them.
  bool streamed() const { return streamed_; }
  bool served() const { return served_; }
  void set_interfaces(bool streamed, bool served) {
    streamed_ = streamed;
    served_ = served;
  }

  /// Back to the state at the start of the simulation.
  virtual void Reset();

  /// Ends its running asynchronous service, if any, as PREEMPTED (`cancel`, specs: morse.md A.5).
  virtual void Interrupt() {}

  virtual void AddToHash(StateHash& hash) const = 0;

 protected:
  void AddService(Service service) { services_.push_back(std::move(service)); }
  /// A service that changes nothing simulated.
  void AddQuery(Service service) {
    service.changes_simulation = false;
    services_.push_back(std::move(service));
  }
  // A property of MORSE's that lives in a member of the component: get_properties shows it,
  // set_property changes it. Numbers stay within low..high; an infinite `high` takes infinity, too.
  void AddProperty(const char* name, double& value, double low, double high);
  void AddProperty(const char* name, bool& value);
  /// Python's None: no value.
  void AddProperty(const char* name, std::optional<double>& value, double low, double high);
  /// `choices`: what it may be; none: any text.
  void AddProperty(const char* name, std::string& value, std::vector<std::string> choices = {});
  /// Has modifiers know of numbers of the data, which live in a member of the component.
  void AddData(std::string_view name, double& number) { data_.push_back({name, {&number, 1}}); }
  void AddData(std::string_view name, std::span<double> numbers) {
    data_.push_back({name, numbers});
  }
  /// Applies the modifiers to `data`.
  void Modify(std::span<const DataField> data, const Instant& now);
  std::span<const DataField> data() const { return data_; }
  bool is_modified() const { return !modifiers_.empty(); }
  /// It moves what is mounted on it.
  void set_moves(bool moves) { moves_ = moves; }
  /// To be called when the data have changed at simulated time `time`, s.
  void DataChanged(double time);
  /// Called when set_property has changed one of them.
  virtual void PropertyChanged() {}

 private:
  struct Property {
    std::string name;
    std::variant<double*, bool*, std::string*, std::optional<double>*> value;
    double low = 0.0;
    double high = 0.0;
    std::vector<std::string> choices;
  };

  const Property* FindProperty(std::string_view name) const;
  Mount CarriedMount() const { return parent_->Carry(RestMount()); }

  /// Appends `"key": value` pairs, each preceded by ", ".
  virtual void AppendFields(std::string& out) const = 0;

  Robot& robot_;
  std::string name_;
  std::string full_name_;
  std::string type_;
  double frequency_;
  bool active_ = true;
  bool streamed_ = true;
  bool served_ = true;
  Vec3 mount_;
  Vec3 mount_euler_;
  Component* parent_ = nullptr;
  bool moves_ = false;           // it, or what it is mounted on
  std::uint64_t next_tick_ = 0;  // of its next activation
  double timestamp_ = 0.0;
  bool text_valid_ = false;
  std::string text_;
  std::vector<Service> services_;
  std::vector<Property> properties_;
  std::vector<DataField> data_;
  std::vector<std::unique_ptr<Modifier>> modifiers_;
};

/// What the numbers of a sensor are, in their order.
enum class NumberForm {
  kNone,      ///< the data are more than numbers: only LocalData() has them
  kPose,      ///< x, y, z, m; roll, pitch, yaw, rad
  kOdometry,  ///< as kPose; vx, vy, vz, m/s; wx, wy, wz, rad/s; stall, 0 or 1
  kScan,      ///< ranges, m
};

/// Reads the world (thesis 2.4). Sensors of different robots sample at the same time, in threads:
/// Sample() changes nothing but the sensor.
class Sensor : public Component {
 public:
  using Component::Component;
  virtual void Sample(const Instant& now) = 0;

  /// An activation: a sample, then what the modifiers make of it.
  void Activate(const Instant& now) {
    Sample(now);
    if (is_modified()) Modify(data(), now);
  }

  /// Called on one thread after all sensors that were due have sampled: whatever a sample changes
  /// beside the sensor is changed here.
  virtual void Conclude(const Instant& /*now*/) {}

  /// Called on one thread before sensors that are due sample at the same time: whatever is made
  /// when first needed may be made here. May throw, as Sample() must not.
  virtual void Prepare() {}

  /// Is there something to be sent of the last sample? MORSE's Collision is silent without contact.
  virtual bool HasNews() const { return true; }

  /// About how much a sample costs, in beams of a scanner: work is split over threads by it.
  virtual int Work() const { return 1; }
  /// The data as bare numbers, the same as in LocalData(), for those who have no need of text.
  virtual NumberForm number_form() const { return NumberForm::kNone; }
  /// Appends them.
  virtual void AppendNumbers(std::vector<double>& /*out*/) const {}

  std::uint64_t samples() const { return samples_; }  ///< taken since the start
  void CountSample() { ++samples_; }

 private:
  std::uint64_t samples_ = 0;
};

/// Changes its robot's state or the world (thesis 2.4).
class Actuator : public Component {
 public:
  using Component::Component;
  virtual void Act(const Instant& now) = 0;
  /// Takes a message of the actuator's stream (specs: morse.md A.4). Throws WrongArgument and
  /// changes nothing when it is not what the actuator needs.
  virtual void Receive(const Json& message) = 0;
  /// The same after what its modifiers make of the message's numbers.
  void Take(const Json& message);
};

// Helpers for AppendFields.
void AppendField(std::string& out, const char* key, double value);
void AppendField(std::string& out, const char* key, bool value);
void AppendField(std::string& out, const char* key, const Vec3& value);  ///< as a list of three
void AppendField(std::string& out, const char* key, std::string_view value);

}  // namespace ccmorse::sim
