#include "servers/own/plugin_host.h"

#include <dlfcn.h>
#include <fmt/core.h>

#include <array>
#include <sstream>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "ccmorse/plugin.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::servers {
namespace {

constexpr std::array<const char*, 3> kStatus = {"SUCCESS", "FAILED", "PREEMPTED"};

// Stays open as long as we live: its code may be anywhere.
const CCMorsePlugin& Open(const std::string& file) {
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error(fmt::format("the plug-in cannot be loaded: {}", ::dlerror()));
  using Entry = const CCMorsePlugin* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, "ccmorse_plugin"));
  if (entry == nullptr) {
    throw Error(fmt::format("{} is no plug-in of ccmorse: it lacks CCMORSE_PLUGIN(...)", file));
  }
  const CCMorsePlugin* const plugin = entry();
  if (plugin->version != CCMORSE_PLUGIN_VERSION) {
    throw Error(fmt::format(
        "{} was built for version {} of ccmorse's interface of plug-ins, and this ccmorse has "
        "version {}: build it again with this ccmorse's ccmorse/plugin.h",
        file, plugin->version, CCMORSE_PLUGIN_VERSION));
  }
  return *plugin;
}

Json ToJson(const CCMorseValue& value) {
  switch (value.kind) {
    case CCMorseValue::kFlag:
      return Json(value.flag != 0);
    case CCMorseValue::kNumber:
      return Json(value.number);
    case CCMorseValue::kText:
      return Json(value.text);
    case CCMorseValue::kNumbers: {
      Json::Array numbers;
      for (std::size_t i = 0; i < value.size; ++i) numbers.emplace_back(value.numbers[i]);
      return Json(std::move(numbers));
    }
    default:
      return {};
  }
}

// What JSON has and a plug-in can be given; owns what the value points to.
class RawValue {
 public:
  explicit RawValue(const Json& json) {
    if (json.IsBool()) {
      raw_.kind = CCMorseValue::kFlag;
      raw_.flag = json.AsBool() ? 1 : 0;
    } else if (json.IsNumber()) {
      raw_.kind = CCMorseValue::kNumber;
      raw_.number = json.AsDouble();
    } else if (json.IsString()) {
      raw_.kind = CCMorseValue::kText;
      text_ = json.AsString();
    } else if (json.IsArray()) {
      raw_.kind = CCMorseValue::kNumbers;
      for (const Json& item : json.AsArray()) {
        if (!item.IsNumber()) throw sim::WrongArgument("a list must be of numbers");
        numbers_.push_back(item.AsDouble());
      }
    } else if (json.IsObject()) {
      throw sim::WrongArgument("it must not be an object");
    }
  }
  CCMorseValue Get() const {
    CCMorseValue raw = raw_;
    raw.text = text_.c_str();
    raw.numbers = numbers_.data();
    raw.size = numbers_.size();
    return raw;
  }

 private:
  CCMorseValue raw_{CCMorseValue::kNone, 0, 0.0, "", nullptr, 0};
  std::string text_;
  std::vector<double> numbers_;
};

}  // namespace

// One component: the functions that its plug-in calls, and what they were called with. Without a
// component of the simulation it only listens to what it says of itself.
class PluginHost::Part {
 public:
  Part(const std::string& file, sim::Simulation* simulation, sim::OwnComponent* own)
      : plugin_(Open(file)), simulation_(simulation), own_(own) {
    host_ = {CCMORSE_PLUGIN_VERSION,
             this,
             &AddData,
             &AddProperty,
             &AddService,
             &GetData,
             &SetData,
             &GetProperty,
             &GetPose,
             &GetTime,
             &DoAct,
             &DoComplete,
             &DoLog,
             &DoFail,
             &DoAnswer};
    if (own_ != nullptr) data_ = own_->data();
    instance_ = plugin_.make(&host_);
  }
  ~Part() {
    if (instance_ != nullptr) plugin_.destroy(instance_);
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  const CCMorsePlugin& plugin() const { return plugin_; }
  const std::string& failure() const { return failure_; }
  const scene::OwnDef& described() const { return described_; }
  bool works() const { return instance_ != nullptr; }

  OwnAnswer Perform(const OwnTask& task) {
    failure_.clear();
    failed_how_ = -1;
    result_ = Json();
    deeds_.clear();
    data_changed_ = false;
    if (own_->TakeDataChanged()) data_ = own_->data();
    switch (task.kind) {
      case OwnTask::Kind::kActivate:
        plugin_.act(instance_);
        break;
      case OwnTask::Kind::kEnded:  // of overlays, which are none of these
        break;
      case OwnTask::Kind::kInterrupt:
        plugin_.interrupt(instance_);
        End(2, Json());  // where it has not
        break;
      case OwnTask::Kind::kStart:
        if (ticket_ != 0) {
          plugin_.interrupt(instance_);
          End(2, Json());
        }
        ticket_ = task.ticket;
        Call(task);
        if (failed_how_ >= 0) ticket_ = 0;
        break;
      case OwnTask::Kind::kCall:
        Call(task);
        break;
    }
    return Answer(task);
  }

 private:
  static Part& Of(void* self) { return *static_cast<Part*>(self); }

  static void AddData(void* self, const char* name, const CCMorseValue* first) {
    Of(self).described_.data.Set(name, ToJson(*first));
  }
  static void AddProperty(void* self, const char* name, const CCMorseValue* first) {
    Of(self).described_.properties.Set(name, ToJson(*first));
  }
  static void AddService(void* self, const char* name, const char* parameters, int asynchronous) {
    scene::OwnServiceDef service;
    service.name = name;
    service.asynchronous = asynchronous != 0;
    std::istringstream words(parameters);
    for (std::string word; words >> word;) {
      const bool optional = word.front() == '?';
      service.parameters.push_back({word.substr(optional ? 1 : 0), optional});
    }
    Of(self).described_.services.push_back(std::move(service));
  }
  void Show(const Json* value, CCMorseValue* out) {
    shown_ = std::make_unique<RawValue>(value != nullptr ? *value : Json());
    *out = shown_->Get();
  }
  // What cannot be shown is shown as nothing: a plug-in has data of its own types only.
  template <typename Find>
  void ShowSafely(CCMorseValue* out, Find find) {
    try {
      find();
    } catch (const sim::WrongArgument&) {
      Show(nullptr, out);
    }
  }
  static void GetData(void* self, const char* name, CCMorseValue* value) {
    Part& part = Of(self);
    const Json& data = part.own_ != nullptr ? part.data_ : part.described_.data;
    part.ShowSafely(value, [&] { part.Show(data.Find(name), value); });
  }
  static void SetData(void* self, const char* name, const CCMorseValue* value) {
    Part& part = Of(self);
    (part.own_ != nullptr ? part.data_ : part.described_.data).Set(name, ToJson(*value));
    part.data_changed_ = true;
  }
  static void GetProperty(void* self, const char* name, CCMorseValue* value) {
    Part& part = Of(self);
    const Json properties =
        part.own_ != nullptr ? part.own_->component().Properties() : part.described_.properties;
    part.ShowSafely(value, [&] { part.Show(properties.Find(name), value); });
  }
  static void GetPose(void* self, int of_robot, double* pose) {
    const Part& part = Of(self);
    std::fill(pose, pose + 6, 0.0);
    if (part.own_ == nullptr) return;
    const sim::Component& component = part.own_->component();
    const sim::Robot& robot = component.robot();
    Vec3 at = robot.position();
    Vec3 euler{0.0, 0.0, robot.pose().yaw};
    if (of_robot == 0) {
      const sim::MountPlace place = sim::PlaceOfMount(component);
      at = place.position;
      euler = place.euler;
    }
    const std::array<double, 6> six = {at.x, at.y, at.z, euler.x, euler.y, euler.z};
    std::copy(six.begin(), six.end(), pose);
  }
  static double GetTime(void* self) {
    const Part& part = Of(self);
    return part.simulation_ != nullptr ? part.simulation_->time() : 0.0;
  }
  static void DoAct(void* self, const char* what, const double* numbers, std::size_t size) {
    Json::Array deed = {Json(what)};
    for (std::size_t i = 0; i < size; ++i) deed.emplace_back(numbers[i]);
    Of(self).deeds_.emplace_back(std::move(deed));
  }
  static void DoComplete(void* self, int status, const CCMorseValue* result) {
    Of(self).End(status, ToJson(*result));
  }
  static void DoLog(void* self, const char* text) {
    const Part& part = Of(self);
    if (part.own_ != nullptr) LogInfo("{}: {}", part.own_->component().full_name(), text);
  }
  static void DoFail(void* self, int how, const char* text) {
    Of(self).failed_how_ = how;
    Of(self).failure_ = text;
  }
  static void DoAnswer(void* self, const CCMorseValue* result) {
    Of(self).result_ = ToJson(*result);
  }

  void End(int status, Json result) {
    if (ticket_ == 0 || status < 0 || status > 2) return;
    ended_.emplace_back(
        Json::Array{ticket_, kStatus[static_cast<std::size_t>(status)], std::move(result)});
    ticket_ = 0;
  }

  void Call(const OwnTask& task) {
    const auto& services = own_->def().services;
    std::size_t index = 0;
    while (index < services.size() && services[index].name != task.service) ++index;
    try {
      std::vector<RawValue> kept;
      for (const Json& argument : task.arguments) kept.emplace_back(argument);
      std::vector<CCMorseValue> raw;
      for (const RawValue& value : kept) raw.push_back(value.Get());
      plugin_.call(instance_, index, raw.data(), raw.size());
    } catch (const sim::WrongArgument& wrong) {
      failed_how_ = 2;
      failure_ = wrong.what();
    }
  }

  OwnAnswer Answer(const OwnTask& task) {
    Json answer(Json::Object{});
    const bool service = task.kind == OwnTask::Kind::kCall || task.kind == OwnTask::Kind::kStart;
    if (failed_how_ == 0 || (failed_how_ > 0 && !service)) {
      answer.Set("off", fmt::format("{}: in {}: {}", own_->def().code,
                                    service ? task.service : "DefaultAction()", failure_));
      return answer;
    }
    if (failed_how_ > 0) answer.Set(failed_how_ == 1 ? "failed" : "wrong", failure_);
    Json change(Json::Object{});
    if (!deeds_.empty()) change.Set("do", std::move(deeds_));
    if (data_changed_) change.Set("data", data_);
    if (!change.IsFalsy()) answer.Set("change", std::move(change));
    if (!ended_.empty()) answer.Set("ended", std::exchange(ended_, {}));
    if (task.kind == OwnTask::Kind::kCall) answer.Set("result", std::move(result_));
    return answer;
  }

  const CCMorsePlugin& plugin_;
  sim::Simulation* simulation_;
  sim::OwnComponent* own_;
  CCMorseHost host_{};
  void* instance_ = nullptr;
  scene::OwnDef described_;
  Json data_;
  bool data_changed_ = false;
  Json::Array deeds_;
  Json::Array ended_;
  Json result_;
  std::int64_t ticket_ = 0;  // of the running service; 0: none runs
  int failed_how_ = -1;      // as in CCMorseHost::fail; -1: not at all
  std::string failure_;
  std::unique_ptr<RawValue> shown_;
};

PluginHost::PluginHost(sim::Simulation& simulation,
                       const std::vector<sim::OwnComponent*>& components, const Taker& taker) {
  for (sim::OwnComponent* component : components) {
    auto part = std::make_unique<Part>(component->def().code, &simulation, component);
    if (!part->works()) {
      taker({component},
            Json(Json::Object{{"off", fmt::format("{}: in its constructor: {}",
                                                  component->def().code, part->failure())}}));
      continue;
    }
    parts_.emplace(component, std::move(part));
  }
}

PluginHost::~PluginHost() = default;

void PluginHost::Perform(std::span<const OwnTask> tasks, const Taker& taker) {
  for (const OwnTask& task : tasks) {
    const auto found = parts_.find(task.component);
    taker(task, found != parts_.end() ? found->second->Perform(task) : Json(Json::Object{}));
  }
}

void PluginHost::Describe(const std::string& file, scene::ComponentDef& component) {
  const Part part(file, nullptr, nullptr);
  if (!part.works()) {
    throw Error(fmt::format("{}: in its constructor: {}", file, part.failure()));
  }
  scene::OwnDef& own = *component.own;
  own.kind = part.plugin().is_actuator != 0 ? "actuator" : "sensor";
  component.type = part.plugin().type;
  own.data = part.described().data;
  own.properties = part.described().properties;
  own.services = part.described().services;
}

void DescribePlugins(scene::Scenario& scenario) {
  for (scene::RobotDef& robot : scenario.robots) {
    if (!robot.components) continue;
    for (scene::ComponentDef& component : *robot.components) {
      if (!component.own || component.own->language != "c++") continue;
      scene::OwnDef& own = *component.own;
      const std::string full = robot.name + "." + component.name;
      try {
        PluginHost::Describe(own.code, component);
      } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", full, error.what()));
      }
    }
  }
}

}  // namespace ccmorse::servers
