#pragma once

// Sensors and actuators of one's own for CCMorse's simulator, in C++ (docs/components.md): this
// header is all that a plug-in is compiled against, and it links with nothing of ours. Between
// simulator and plug-in there are only functions and structs of C, so that the two may be built by
// different compilers.

#include <cstddef>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Changes when a plug-in built for one number cannot be loaded by a simulator of another.
#define CCMORSE_PLUGIN_VERSION 1

extern "C" {

/// A value on its way. Whoever hands it on owns what it points to, until the next call.
struct CCMorseValue {
  enum Kind { kNone = 0, kFlag = 1, kNumber = 2, kText = 3, kNumbers = 4 };
  int kind;
  int flag;  ///< 0 or 1
  double number;
  const char* text;  ///< UTF-8, ends with a zero
  const double* numbers;
  size_t size;  ///< of numbers
};

/// What the simulator offers to one component; `self` is the pointer of the same name.
struct CCMorseHost {
  int version;
  void* self;
  // While it is made:
  void (*add_data)(void* self, const char* name, const CCMorseValue* first);
  void (*add_property)(void* self, const char* name, const CCMorseValue* first);
  /// `parameters`: names between blanks; optional ones behind a '?'.
  void (*add_service)(void* self, const char* name, const char* parameters, int asynchronous);
  // At any time:
  void (*get)(void* self, const char* name, CCMorseValue* value);
  void (*set)(void* self, const char* name, const CCMorseValue* value);
  void (*get_property)(void* self, const char* name, CCMorseValue* value);
  /// x, y, z, m; roll, pitch, yaw, rad; of the component or its robot.
  void (*get_pose)(void* self, int of_robot, double* pose);
  double (*get_time)(void* self);
  /// "speed" vx vy wz; "place" x y yaw; "pixel" x y r g b alpha; "line" x0 y0 x1 y1 r g b alpha;
  /// "clear"; "resize" width height.
  void (*act)(void* self, const char* what, const double* numbers, size_t size);
  /// `status`: 0 SUCCESS, 1 FAILED, 2 PREEMPTED.
  void (*complete)(void* self, int status, const CCMorseValue* result);
  void (*log)(void* self, const char* text);
  /// `how`: 0 its code is broken; 1 the service has failed; 2 an argument is wrong.
  void (*fail)(void* self, int how, const char* text);
  void (*answer)(void* self, const CCMorseValue* result);
};

/// What a plug-in offers; its function ccmorse_plugin() gives it to the simulator.
struct CCMorsePlugin {
  int version;  ///< CCMORSE_PLUGIN_VERSION of the header that it was built with
  int is_actuator;
  const char* type;                        ///< name of the class
  void* (*make)(const CCMorseHost* host);  ///< null: it has told `fail`
  void (*destroy)(void* component);
  void (*act)(void* component);
  void (*call)(void* component, size_t service, const CCMorseValue* arguments, size_t size);
  void (*interrupt)(void* component);
};

}  // extern "C"

namespace ccmorse {

/// A field of data, a property, an argument or a result.
class Value {
 public:
  // NOLINTBEGIN(google-explicit-constructor): a value reads as what it is.
  Value() = default;
  Value(bool flag) : value_(flag) {}
  Value(int number) : value_(double(number)) {}
  Value(double number) : value_(number) {}
  Value(const char* text) : value_(std::string(text)) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(std::vector<double> numbers) : value_(std::move(numbers)) {}
  // NOLINTEND(google-explicit-constructor)
  explicit Value(const CCMorseValue& raw) {
    if (raw.kind == CCMorseValue::kFlag) value_ = raw.flag != 0;
    if (raw.kind == CCMorseValue::kNumber) value_ = raw.number;
    if (raw.kind == CCMorseValue::kText) value_ = std::string(raw.text);
    if (raw.kind == CCMorseValue::kNumbers) {
      value_ = std::vector<double>(raw.numbers, raw.numbers + raw.size);
    }
  }

  // Each throws WrongType where it is something else.
  bool Flag() const { return As<bool>("true or false"); }
  double Number() const { return As<double>("a number"); }
  const std::string& Text() const { return As<std::string>("a text"); }
  const std::vector<double>& Numbers() const { return As<std::vector<double>>("numbers"); }

  /// Valid as long as this value.
  CCMorseValue Raw() const {
    CCMorseValue raw{static_cast<int>(value_.index()), 0, 0.0, "", nullptr, 0};
    if (const bool* flag = std::get_if<bool>(&value_)) raw.flag = *flag ? 1 : 0;
    if (const double* number = std::get_if<double>(&value_)) raw.number = *number;
    if (const std::string* text = std::get_if<std::string>(&value_)) raw.text = text->c_str();
    if (const auto* numbers = std::get_if<std::vector<double>>(&value_)) {
      raw.numbers = numbers->data();
      raw.size = numbers->size();
    }
    return raw;
  }

 private:
  template <typename T>
  const T& As(const char* what) const;

  // In the order of CCMorseValue::Kind.
  std::variant<std::monostate, bool, double, std::string, std::vector<double>> value_;
};

/// An argument of the wrong type: a client is told FAILED "... wrong parameter type ...".
class WrongType : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A service cannot be done: a client is told FAILED and this text.
class ServiceFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <typename T>
const T& Value::As(const char* what) const {
  const T* const found = std::get_if<T>(&value_);
  if (found == nullptr) throw WrongType(std::string("it must be ") + what);
  return *found;
}

using Values = std::vector<Value>;

/// x, y, z in m; roll, pitch, yaw in rad.
struct Pose {
  double x, y, z, roll, pitch, yaw;
};

enum class Status { kSuccess = 0, kFailed = 1, kPreempted = 2 };

/// What Sensor and Actuator have in common. The constructor says what data, properties and services
/// there are; it is called when the scene is read and again when the simulation begins. All
/// functions are called on one thread. An exception switches the component off, with a line in the
/// simulator's log; a crash is the simulator's as well.
class Component {
 public:
  virtual ~Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;

  /// What happens each time that it is due.
  virtual void DefaultAction() = 0;
  /// The running asynchronous service is to end. Whoever overrides it calls it at the end.
  virtual void Interrupt() { Complete(Status::kPreempted); }

 protected:
  Component() : host_(Making()) {}

  // In the constructor.
  /// A field of the data, with its first value.
  void AddData(const char* name, const Value& first) {
    const CCMorseValue raw = first.Raw();
    host_->add_data(host_->self, name, &raw);
  }
  /// What scripts set by properties(NAME=...), clients by set_property: kept in `value`, a double,
  /// a bool or a std::string that lives as long as the component.
  template <typename T>
  void AddProperty(const char* name, T* value) {
    const Value first(*value);
    const CCMorseValue raw = first.Raw();
    host_->add_property(host_->self, name, &raw);
    refresh_.push_back([this, name, value] {
      CCMorseValue now{};
      host_->get_property(host_->self, name, &now);
      Assign(Value(now), value);
    });
  }
  using Service = std::function<Value(const Values&)>;
  /// `parameters`: names between blanks, optional ones behind a '?': "x y ?speed".
  void AddService(const char* name, const char* parameters, Service service) {
    host_->add_service(host_->self, name, parameters, 0);
    services_.push_back(std::move(service));
  }
  /// One that answers later, by Complete(). Called while one runs, it ends that as PREEMPTED.
  void AddAsyncService(const char* name, const char* parameters,
                       std::function<void(const Values&)> start) {
    host_->add_service(host_->self, name, parameters, 1);
    services_.push_back([start = std::move(start)](const Values& arguments) {
      start(arguments);
      return Value();
    });
  }

  /// The data: what a sensor sends, or what an actuator was sent.
  Value Get(const char* name) const {
    CCMorseValue raw{};
    host_->get(host_->self, name, &raw);
    return Value(raw);
  }
  void Set(const char* name, const Value& value) {
    const CCMorseValue raw = value.Raw();
    host_->set(host_->self, name, &raw);
  }
  /// Where it is in the world, and where its robot is.
  Pose GetPose() const { return PoseOf(0); }
  Pose GetRobotPose() const { return PoseOf(1); }
  /// Simulated time, s.
  double GetTime() const { return host_->get_time(host_->self); }

  /// Its robot drives: m/s forward, m/s to the left, rad/s counter-clockwise, until the next
  /// command. Only some robots go sideways.
  void ApplySpeed(double forward, double left, double turn) { Act("speed", {forward, left, turn}); }
  /// Its robot is put there, standing still: m, rad.
  void ForcePose(double x, double y, double yaw) { Act("place", {x, y, yaw}); }
  /// On the canvas: a cell; red, green, blue 0..255; alpha 0..1.
  void SetPixel(int x, int y, int red, int green, int blue, double alpha = 1.0) {
    Act("pixel", {double(x), double(y), double(red), double(green), double(blue), alpha});
  }
  void DrawLine(int x0, int y0, int x1, int y1, int red, int green, int blue, double alpha = 1.0) {
    Act("line", {double(x0), double(y0), double(x1), double(y1), double(red), double(green),
                 double(blue), alpha});
  }
  void ClearCanvas() { Act("clear", {}); }

  /// Ends the running asynchronous service.
  void Complete(Status status, const Value& result = {}) {
    const CCMorseValue raw = result.Raw();
    host_->complete(host_->self, static_cast<int>(status), &raw);
  }
  void Log(const std::string& text) const { host_->log(host_->self, text.c_str()); }

 private:
  template <typename>
  friend struct PluginOf;

  static const CCMorseHost*& Making() {
    static const CCMorseHost* host = nullptr;
    return host;
  }
  static void Assign(const Value& from, double* to) { *to = from.Number(); }
  static void Assign(const Value& from, bool* to) { *to = from.Flag(); }
  static void Assign(const Value& from, std::string* to) { *to = from.Text(); }
  Pose PoseOf(int of_robot) const {
    double p[6];
    host_->get_pose(host_->self, of_robot, p);
    return {p[0], p[1], p[2], p[3], p[4], p[5]};
  }
  void Act(const char* what, const std::vector<double>& numbers) {
    host_->act(host_->self, what, numbers.data(), numbers.size());
  }
  void Refresh() const {
    for (const auto& each : refresh_) each();
  }

  const CCMorseHost* host_;
  std::vector<std::function<void()>> refresh_;
  std::vector<Service> services_;
};

/// Its DefaultAction() sets the data; then they are sent.
class Sensor : public Component {
 public:
  static constexpr int kIsActuator = 0;
};

/// Its DefaultAction() does what the data, which clients send, want done.
class Actuator : public Component {
 public:
  static constexpr int kIsActuator = 1;
};

/// The functions of C around a class. No exception leaves them.
template <typename T>
struct PluginOf {
  static Component* Of(void* component) { return static_cast<Component*>(component); }

  template <typename Work>
  static void Guarded(const CCMorseHost* host, Work work) {
    try {
      work();
    } catch (const WrongType& wrong) {
      host->fail(host->self, 2, wrong.what());
    } catch (const ServiceFailed& failed) {
      host->fail(host->self, 1, failed.what());
    } catch (const std::exception& error) {
      host->fail(host->self, 0, error.what());
    } catch (...) {
      host->fail(host->self, 0, "an exception that is no std::exception");
    }
  }

  static void* Make(const CCMorseHost* host) {
    Component* made = nullptr;
    Guarded(host, [&] {
      Component::Making() = host;
      made = new T();
    });
    return made;
  }
  static void Destroy(void* component) { delete Of(component); }
  static void Act(void* component) {
    Guarded(Of(component)->host_, [&] {
      Of(component)->Refresh();
      Of(component)->DefaultAction();
    });
  }
  static void Call(void* component, size_t service, const CCMorseValue* arguments, size_t size) {
    const CCMorseHost* const host = Of(component)->host_;
    Guarded(host, [&] {
      Of(component)->Refresh();
      Values values;
      for (size_t i = 0; i < size; ++i) values.emplace_back(arguments[i]);
      const Value result = Of(component)->services_.at(service)(values);
      const CCMorseValue raw = result.Raw();
      host->answer(host->self, &raw);
    });
  }
  static void Interrupt(void* component) {
    Guarded(Of(component)->host_, [&] { Of(component)->Interrupt(); });
  }
};

}  // namespace ccmorse

/// Makes a class, which derives from ccmorse::Sensor or ccmorse::Actuator, the plug-in of its file.
#define CCMORSE_PLUGIN(Class)                                                                 \
  extern "C" __attribute__((visibility("default"))) const CCMorsePlugin* ccmorse_plugin() {   \
    using Functions = ccmorse::PluginOf<Class>;                                               \
    static const CCMorsePlugin plugin = {                                                     \
        CCMORSE_PLUGIN_VERSION, Class::kIsActuator, #Class,           &Functions::Make,       \
        &Functions::Destroy,    &Functions::Act,    &Functions::Call, &Functions::Interrupt}; \
    return &plugin;                                                                           \
  }
