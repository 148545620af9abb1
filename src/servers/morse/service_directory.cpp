#include "servers/morse/service_directory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/base64.h"
#include "base/error.h"
#include "base/log.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/limits.h"
#include "servers/morse/arena_services.h"
#include "servers/own/own_change.h"
#include "sim/robots/robot_skills.h"

namespace ccmorse::servers {
namespace {

using sim::Arguments;
using sim::Outcome;
using sim::Service;
using sim::ServiceFailed;
using sim::WrongArgument;

// Python's list of names in its TypeError texts: 'a' / 'a' and 'b' / 'a', 'b', and 'c'.
std::string QuotedNames(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += names.size() == 2 ? " and " : i + 1 == names.size() ? ", and " : ", ";
    text += "'" + names[i] + "'";
  }
  return text;
}

// What Python says of a call with the wrong number of arguments; "" when the number is right.
// Methods count `self`, as Python does.
std::string ArityComplaint(const Service& service, std::size_t given) {
  std::vector<std::string> missing;
  std::size_t required = 0;
  for (const sim::ServiceParameter& parameter : service.parameters) {
    if (parameter.optional) continue;
    ++required;
    if (required > given) missing.push_back(parameter.name);
  }
  if (!missing.empty()) {
    return service.name + "() missing " + std::to_string(missing.size()) +
           " required positional argument" + (missing.size() == 1 ? "" : "s") + ": " +
           QuotedNames(missing);
  }
  const std::size_t most = service.parameters.size();
  if (given <= most) return "";
  const std::string takes =
      required == most ? std::to_string(most + 1)
                       : "from " + std::to_string(required + 1) + " to " + std::to_string(most + 1);
  return service.name + "() takes " + takes + " positional argument" +
         (required == most && most == 0 ? "" : "s") + " but " + std::to_string(given + 1) +
         (given == 0 ? " was" : " were") + " given";
}

// Where text is no UTF-8; its length where it is.
std::size_t EndOfUtf8(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    if (first >= 0x80 && (first < 0xC2 || first > 0xF4)) return i;
    // The second byte's limits keep out what could be written shorter, halves of pairs, and more
    // than there is.
    const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    for (std::size_t k = 1; k < length; ++k) {
      if (byte(i + k) < (k == 1 ? low : 0x80) || byte(i + k) > (k == 1 ? high : 0xBF)) return i;
    }
    i += length;
  }
  return text.size();
}

void Fail(const sim::Completion& done, std::string text) {
  done({Outcome::kFailed, Json(std::move(text))});
}

std::string ListText(Arguments arguments) {
  std::string text = "[";
  for (const Json& argument : arguments) {
    if (text.size() > 1) text += ", ";
    text += argument.Dump();
  }
  return text + ']';
}

Vec3 PointArgument(Arguments arguments, std::size_t index, const char* name) {
  const Json& value = arguments[index];
  if (!value.IsArray() || value.AsArray().size() != 3) {
    throw WrongArgument(std::string(name) + " must be [x, y, z]");
  }
  const Json::Array& parts = value.AsArray();
  return {sim::NumberArgument(parts, 0, "x"), sim::NumberArgument(parts, 1, "y"),
          sim::NumberArgument(parts, 2, "z")};
}

Json ToJson(Vec3 v) { return Json(Json::Array{v.x, v.y, v.z}); }

bool BoolArgument(Arguments arguments, std::size_t index, const char* name) {
  const Json& value = arguments[index];
  if (!value.IsBool()) {
    throw WrongArgument(std::string(name) + " must be true or false, not " + value.TypeName());
  }
  return value.AsBool();
}

using Matrix4 = std::array<double, 16>;

Matrix4 MatrixArgument(Arguments arguments, std::size_t index, const char* name) {
  const auto wrong = [name] {
    return WrongArgument(std::string(name) + " must be 4 rows of 4 numbers");
  };
  const Json& rows = arguments[index];
  if (!rows.IsArray() || rows.AsArray().size() != 4) throw wrong();
  Matrix4 matrix{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Json& row = rows.AsArray()[i];
    if (!row.IsArray() || row.AsArray().size() != 4) throw wrong();
    for (std::size_t k = 0; k < 4; ++k)
      matrix[4 * i + k] = sim::NumberArgument(row.AsArray(), k, name);
  }
  return matrix;
}

Json MatrixJson(const Matrix4& matrix) {
  Json::Array rows;
  for (std::size_t i = 0; i < 4; ++i) {
    rows.push_back(Json::Array(matrix.begin() + static_cast<std::ptrdiff_t>(4 * i),
                               matrix.begin() + static_cast<std::ptrdiff_t>(4 * i + 4)));
  }
  return Json(std::move(rows));
}

Matrix4 CameraTransform(Vec3 position, Vec3 euler) {
  const auto [x, y, z] = FromEuler(euler.x, euler.y, euler.z);
  return {x.x, y.x, z.x, position.x, x.y, y.y, z.y, position.y,
          x.z, y.z, z.z, position.z, 0.0, 0.0, 0.0, 1.0};
}

// The camera that MORSE's scenes have: focal length 20 of 32 wide, clipped at 0.1 m, and a picture
// of 4 : 3, as OpenGL writes a projection.
Matrix4 PerspectiveProjection(double far_clip = 100.0) {
  constexpr double kNear = 0.1;
  constexpr double kScale = 2.0 * 20.0 / 32.0;
  return {kScale,
          0.0,
          0.0,
          0.0,
          0.0,
          kScale * 4.0 / 3.0,
          0.0,
          0.0,
          0.0,
          0.0,
          -(far_clip + kNear) / (far_clip - kNear),
          -2.0 * far_clip * kNear / (far_clip - kNear),
          0.0,
          0.0,
          -1.0,
          0.0};
}

// [value, type, doc, python attribute] by name, as MORSE lists properties.
Json PropertyTable(const Json& properties) {
  Json table(Json::Object{});
  for (const auto& [key, value] : properties.AsObject()) {
    const char* const type = value.IsBool()     ? "bool"
                             : value.IsInt()    ? "int"
                             : value.IsNumber() ? "float"
                             : value.IsNull()   ? "NoneType"
                                                : "string";
    table.Set(key, Json::Array{value, type, "", key});
  }
  return table;
}

Json YawQuaternion(double yaw) {
  const auto [s, c] = SinCos(yaw / 2.0);
  return Json(Json::Array{0.0, 0.0, s, c});
}

}  // namespace

ServiceDirectory::ServiceDirectory(sim::Simulation& simulation, RunControl control)
    : simulation_(simulation), control_(std::move(control)) {
  for (sim::Component* component : simulation_.components()) {
    if (component->served()) AddComponentServices(*component);
  }
  for (const auto& robot : simulation_.robots()) {
    if (robot->def().services) AddRobotServices(*robot);
  }
  AddSimulationServices();
  AddStreamServices();
  AddObjectServices();
  AddCameraServices();
  AddTimeServices();
  AddCommunicationServices();
  AddRunServices();
  for (Service& service : ArenaServices(simulation_)) Add("arena", std::move(service));
}

bool ServiceDirectory::HasStream(const sim::Component& component) {
  return component.type() != "Pen" && component.type() != "Answers" && component.streamed();
}

void ServiceDirectory::Add(const std::string& component, Service service) {
  std::string name = service.name;
  services_[component].insert_or_assign(std::move(name), std::move(service));
}

void ServiceDirectory::AddQuery(const std::string& component, Service service) {
  service.changes_simulation = false;
  Add(component, std::move(service));
}

ServiceDirectory::Target ServiceDirectory::Find(std::string_view component,
                                                std::string_view service) const {
  const auto table = services_.find(component);
  if (table == services_.end()) return {};
  const auto entry = table->second.find(service);
  if (entry == table->second.end()) return {};
  return {&table->first, &entry->second};
}

std::string ServiceDirectory::NotRegistered(std::string_view service) {
  return "The request " + std::string(service) +
         " has not been registered in Socket service manager";
}

void ServiceDirectory::Call(std::string_view component, std::string_view service,
                            std::string_view parameters, const sim::Completion& done) {
  const Target target = Find(component, service);
  if (target.service == nullptr) return Fail(done, NotRegistered(service));
  Json::Array arguments;
  if (!parameters.empty()) {
    std::string reason;
    if (const std::size_t end = EndOfUtf8(parameters); end < parameters.size()) {
      reason = "No UTF-8 at byte " + std::to_string(end);
    } else {
      try {
        Json parsed = Json::Parse(parameters);
        if (parsed.IsArray()) {
          arguments = std::move(parsed.AsArray());
        } else {
          reason = std::string("Expecting a list, not ") + parsed.TypeName();
        }
      } catch (const JsonError& error) {
        reason = error.what();
      }
    }
    if (!reason.empty()) {
      constexpr std::size_t kShown = 1000;
      return Fail(done, "Invalid request syntax: error while parsing the parameters: " +
                            std::string(parameters.substr(0, kShown)) + ". " + reason);
    }
  }
  Run(target, arguments, done);
}

void ServiceDirectory::Run(const Target& target, Arguments arguments, const sim::Completion& done) {
  const Service& service = *target.service;
  const std::string complaint = ArityComplaint(service, arguments.size());
  if (!complaint.empty()) {
    return Fail(done, arguments.empty()
                          ? "Socket service manager: parameters expected for service " +
                                service.name + "! " + complaint
                          : "Socket service manager: wrong # of parameters for service " +
                                service.name + ". " + complaint);
  }
  const bool refused = IsRefused(*target.component, service.name);
  const bool told = refused ? refusals_.size() < kMostRefusals : service.changes_simulation;
  if (input_tap_ && told) {
    input_tap_({Input::Kind::kService, *target.component, service.name, ListText(arguments)});
  }
  if (refused) {
    NoteRefusal(*target.component, service.name);
    return Fail(done, "This is a contest: " + *target.component + " " + service.name +
                          " is not for robots' programs");
  }
  try {
    if (service.text) {
      done({Outcome::kSuccess, Json(), service.text()});
    } else if (service.run) {
      Json value = service.run(arguments);
      done({Outcome::kSuccess, std::move(value)});
    } else {
      Start(target, arguments, done);
    }
  } catch (const ServiceFailed& error) {
    Fail(done, error.what());
  } catch (const WrongArgument& error) {
    // MORSE cannot tell the two apart in an asynchronous service, and its clients know it so.
    Fail(done, std::string("Socket service manager: wrong ") +
                   (service.start ? "# of parameters" : "parameter type") + " for service " +
                   service.name + ". " + error.what());
  }
}

// One asynchronous service of a component at a time (specs: morse.md A.5).
void ServiceDirectory::Start(const Target& target, Arguments arguments,
                             const sim::Completion& done) {
  std::shared_ptr<Running>& slot = running_[*target.component];
  const std::shared_ptr<Running> before = slot;
  if (before != nullptr && !before->over) {
    switch (before->policy) {
      case sim::WhileRunning::kPreempts:
        break;
      case sim::WhileRunning::kRefused:
        throw ServiceFailed("A service (" + before->service +
                            ") is already running. I do not know what to do.");
      case sim::WhileRunning::kNeverPreempted:
        throw ServiceFailed("A non-interruptible service (" + before->service +
                            ") is already running");
    }
  }
  const auto now = std::make_shared<Running>();
  now->service = target.service->name;
  now->policy = target.service->while_running;
  slot = now;
  try {
    target.service->start(arguments, [now, done](const sim::ServiceResult& result) {
      now->over = true;
      done(result);
    });
  } catch (...) {
    slot = before;  // what it did not preempt goes on
    throw;
  }
}

// What a program that is judged may not do: put robots or obstacles somewhere, switch physics or
// devices, have a scanner see something else, or ask where everything is.
bool ServiceDirectory::IsRefused(std::string_view component, std::string_view service) const {
  if (!contest_) return false;
  if (component == "arena" || service == "mirror") return true;
  static constexpr std::array<std::string_view, 9> kRefused = {
      "reset_objects",    "activate",          "deactivate",
      "suspend_dynamics", "restore_dynamics",  "set_object_position",
      "mirror_pose",      "get_scene_objects", "set_object_dynamics"};
  return component == "simulation" &&
         std::find(kRefused.begin(), kRefused.end(), service) != kRefused.end();
}

void ServiceDirectory::NoteRefusal(std::string_view component, std::string_view service) {
  if (refusals_.size() >= kMostRefusals) return;
  LogWarning("contest: {} {} at {:.3f} s was refused", component, service, simulation_.time());
  refusals_.push_back({simulation_.tick(), std::string(component), std::string(service)});
}

void ServiceDirectory::RunBytes(const Target& target, std::string_view bytes,
                                const sim::Completion& done) {
  const Service& service = *target.service;
  try {
    if (!service.bytes) throw WrongArgument("it takes no bytes");
    if (input_tap_ && service.changes_simulation) {
      input_tap_({Input::Kind::kBytes, *target.component, service.name, ToBase64(bytes)});
    }
    service.bytes(bytes);
    done({Outcome::kSuccess, Json()});
  } catch (const ServiceFailed& error) {
    Fail(done, error.what());
  } catch (const WrongArgument& error) {
    Fail(done, "Socket service manager: wrong parameter type for service " + service.name + ". " +
                   error.what());
  }
}

void ServiceDirectory::Receive(sim::Actuator& actuator, const Json& message) {
  if (input_tap_) {
    input_tap_({Input::Kind::kStream, actuator.full_name(), {}, message.Dump()});
  }
  actuator.Take(message);
}

void ServiceDirectory::Interrupt(std::string_view component) {
  sim::Component* const found = simulation_.FindComponent(component);
  if (found == nullptr) {
    const auto other = interrupts_.find(component);
    if (other != interrupts_.end()) other->second();
    return;
  }
  if (input_tap_) input_tap_({Input::Kind::kInterrupt, component, {}, ""});
  found->Interrupt();
}

void ServiceDirectory::ChangeOwn(sim::OwnComponent& component, const Json& change) {
  const OwnChange parsed = OwnChange::Parse(change);
  if (input_tap_) {
    input_tap_({Input::Kind::kOwn, component.component().full_name(), {}, change.Dump()});
  }
  parsed.Apply(simulation_, component);
}

void ServiceDirectory::Apply(const Input& input) {
  switch (input.kind) {
    case Input::Kind::kService: {
      const Service* const service = Find(input.component, input.service).service;
      if (service != nullptr && IsRefused(input.component, input.service)) {
        NoteRefusal(input.component, input.service);
        return;
      }
      if (service == nullptr || !service->changes_simulation) break;
      Call(input.component, input.service, input.arguments, [](const sim::ServiceResult&) {});
      return;
    }
    case Input::Kind::kBytes: {
      const Target target = Find(input.component, input.service);
      if (target.service == nullptr || !target.service->bytes) break;
      RunBytes(target, FromBase64(input.arguments), [](const sim::ServiceResult&) {});
      return;
    }
    case Input::Kind::kStream: {
      auto* const actuator =
          dynamic_cast<sim::Actuator*>(simulation_.FindComponent(input.component));
      if (actuator == nullptr) break;
      try {
        Receive(*actuator, Json::Parse(input.arguments));
      } catch (const WrongArgument&) {
        // It was turned down when it came, too.
      }
      return;
    }
    case Input::Kind::kInterrupt:
      if (simulation_.FindComponent(input.component) == nullptr) break;
      Interrupt(input.component);
      return;
    case Input::Kind::kOwn: {
      auto* const own =
          dynamic_cast<sim::OwnComponent*>(simulation_.FindComponent(input.component));
      if (own == nullptr) break;
      ChangeOwn(*own, Json::Parse(input.arguments));
      return;
    }
  }
  throw Error("no input of a run: '" + std::string(input.component) + " " +
              std::string(input.service) + "'");
}

void ServiceDirectory::AddComponentServices(sim::Component& component) {
  const std::string& full_name = component.full_name();
  for (const Service& service : component.services()) Add(full_name, service);
  if (dynamic_cast<sim::Sensor*>(&component) != nullptr) {
    AddQuery(full_name,
             {"get_local_data", {}, nullptr, nullptr, [&component]() -> const std::string& {
                return component.LocalData();
              }});
  }
  AddQuery(full_name, {"get_configurations", {}, [&component](Arguments) {
                         Json configurations = component.Configurations();
                         const auto [x, y, z] = component.mount_rotation();
                         configurations.Set(
                             "object_to_robot",
                             Json::Object{{"rotation", Json::Array{Json::Array{x.x, y.x, z.x},
                                                                   Json::Array{x.y, y.y, z.y},
                                                                   Json::Array{x.z, y.z, z.z}}},
                                          {"translation", ToJson(component.mount())}});
                         return Json(Json::Object{{"configurations", std::move(configurations)}});
                       }});
  AddQuery(full_name,
           {"get_properties", {}, [&component](Arguments) {
              return Json(Json::Object{{"properties", PropertyTable(component.Configurations())}});
            }});
  Add(full_name,
      {"set_property", {{"name"}, {"value"}}, [&component](Arguments arguments) -> Json {
         const std::string& property = sim::StringArgument(arguments, 0, "name");
         if (component.HasProperty(property)) {
           component.SetProperty(property, arguments[1]);
           return {};
         }
         if (component.Configurations().Find(property) == nullptr) {
           throw ServiceFailed("Property " + property + " does not exist for object " +
                               component.full_name());
         }
         throw ServiceFailed("Property " + property + " of " + component.full_name() +
                             " is fixed when the simulation starts; set it in the scenario");
       }});
}

sim::Component& ServiceDirectory::ComponentArgument(Arguments arguments, const char* verb) const {
  const std::string& name = sim::StringArgument(arguments, 0, "component_name");
  sim::Component* component = simulation_.FindComponent(name);
  if (component == nullptr) {
    throw ServiceFailed("Component '" + name + "' not found. Can't " + verb);
  }
  return *component;
}

void ServiceDirectory::AddSimulationServices() {
  const auto add = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                          std::function<Json(Arguments)> run) {
    Add("simulation", {name, std::move(parameters), std::move(run)});
  };
  const auto add_query = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                                std::function<Json(Arguments)> run) {
    AddQuery("simulation", {name, std::move(parameters), std::move(run)});
  };
  add_query("list_robots", {}, [this](Arguments) {
    Json::Array names;
    for (const auto& robot : simulation_.robots()) {
      if (!IsExternal(*robot)) names.push_back(robot->name());
    }
    return Json(std::move(names));
  });
  add_query("details", {}, [this](Arguments) { return Details(); });
  add("reset_objects", {}, [this](Arguments) {
    simulation_.ResetObjects();
    return Json("Objects restored to initial position");
  });
  for (const char* name : {"quit", "terminate"}) {
    add_query(name, {}, [this](Arguments) {
      control_.quit();
      return Json();
    });
  }
  add("activate", {{"component_name"}}, [this](Arguments arguments) {
    ComponentArgument(arguments, "activate").set_active(true);
    return Json();
  });
  add("deactivate", {{"component_name"}}, [this](Arguments arguments) {
    ComponentArgument(arguments, "deactivate").set_active(false);
    return Json();
  });
  add("suspend_dynamics", {}, [this](Arguments) {
    simulation_.set_physics(false);
    return Json("Physics is suspended");
  });
  add("restore_dynamics", {}, [this](Arguments) {
    simulation_.set_physics(true);
    return Json("Physics is resumed");
  });
  add_query("set_log_level", {{"component"}, {"level"}}, [](Arguments arguments) {
    sim::StringArgument(arguments, 0, "component");
    const std::string& level = sim::StringArgument(arguments, 1, "level");
    static const std::map<std::string, LogLevel> kLevels = {{"DEBUG", LogLevel::kDebug},
                                                            {"INFO", LogLevel::kInfo},
                                                            {"WARNING", LogLevel::kWarning},
                                                            {"ERROR", LogLevel::kError},
                                                            {"CRITICAL", LogLevel::kError}};
    const auto found = kLevels.find(level);
    if (found == kLevels.end()) throw ServiceFailed("Unknown level: '" + level + "'");
    SetLogLevel(found->second);
    return Json();
  });
  add_query("get_scene_objects", {}, [this](Arguments) { return SceneObjects(); });
  add("mirror_pose", {{"robot"}, {"pose"}}, [this](Arguments arguments) {
    MirrorPose(arguments);
    return Json();
  });
}

// MORSE has these three only where a component has a stream: its manager of streams makes them
// (specs: morse.md A.1).
void ServiceDirectory::AddStreamServices() {
  const auto& components = simulation_.components();
  if (std::none_of(components.begin(), components.end(),
                   [](const sim::Component* component) { return HasStream(*component); })) {
    return;
  }
  AddQuery("simulation", {"list_streams", {}, [this](Arguments) {
                            Json::Array names;
                            for (const sim::Component* component : simulation_.components()) {
                              if (HasStream(*component)) names.push_back(component->full_name());
                            }
                            return Json(std::move(names));
                          }});
  AddQuery("simulation", {"get_stream_port", {{"name"}}, [this](Arguments arguments) {
                            const std::string& name = sim::StringArgument(arguments, 0, "name");
                            const sim::Component* component = simulation_.FindComponent(name);
                            const int port =
                                component == nullptr ? 0 : control_.stream_port(*component);
                            if (port == 0)
                              throw ServiceFailed("Stream unavailable for component " + name);
                            return Json(port);
                          }});
  AddQuery("simulation", {"get_all_stream_ports", {}, [this](Arguments) {
                            Json ports(Json::Object{});
                            for (const sim::Component* component : simulation_.components()) {
                              const int port = control_.stream_port(*component);
                              if (port != 0) ports.Set(component->full_name(), port);
                            }
                            return ports;
                          }});
}

void ServiceDirectory::AddObjectServices() {
  const auto add = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                          std::function<Json(Arguments)> run) {
    Add("simulation", {name, std::move(parameters), std::move(run)});
  };
  add("set_object_position", {{"object_name"}, {"position"}, {"orientation", true}},
      [this](Arguments arguments) {
        PlaceObject(arguments);
        return Json();
      });
  const auto known = [this](const std::string& name) {
    if (SceneObjects().Find(name) == nullptr) {
      throw ServiceFailed("Object '" + name + "' does not appear in the scene.");
    }
  };
  // In MORSE, too, what is not seen by people is still seen by scanners.
  add("set_object_visibility", {{"object_name"}, {"visible"}, {"do_children"}},
      [known](Arguments arguments) {
        known(sim::StringArgument(arguments, 0, "object_name"));
        BoolArgument(arguments, 2, "do_children");
        return Json(BoolArgument(arguments, 1, "visible"));
      });
  add("set_object_dynamics", {{"object_name"}, {"state"}}, [this, known](Arguments arguments) {
    const std::string& name = sim::StringArgument(arguments, 0, "object_name");
    const bool state = BoolArgument(arguments, 1, "state");
    known(name);
    if (sim::Robot* const robot = simulation_.FindRobot(name)) robot->set_held(!state);
    return Json(state);
  });
}

// MORSE's spelling of the names.
void ServiceDirectory::AddCameraServices() {
  const auto add = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                          std::function<Json(Arguments)> run) {
    Add("simulation", {name, std::move(parameters), std::move(run)});
  };
  const scene::CameraDef& camera = simulation_.scenario().camera;
  camera_ = CameraTransform(camera.position, camera.rotation);
  projection_ = PerspectiveProjection();
  const auto place = [this] { return ToJson({camera_[3], camera_[7], camera_[11]}); };
  add("set_camarafp_position", {{"position"}}, [this, place](Arguments arguments) {
    const Vec3 position = PointArgument(arguments, 0, "position");
    camera_[3] = position.x;
    camera_[7] = position.y;
    camera_[11] = position.z;
    return place();
  });
  add("get_camarafp_position", {}, [place](Arguments) { return place(); });
  add("set_camarafp_transform", {{"transform"}}, [this](Arguments arguments) {
    camera_ = MatrixArgument(arguments, 0, "transform");
    return MatrixJson(camera_);
  });
  add("get_camarafp_transform", {}, [this](Arguments) { return MatrixJson(camera_); });
  add("set_camarafp_projection_matrix", {{"projection"}}, [this](Arguments arguments) {
    projection_ = MatrixArgument(arguments, 0, "projection");
    return MatrixJson(projection_);
  });
  add("get_camarafp_projection_matrix", {}, [this](Arguments) { return MatrixJson(projection_); });
  add("set_camarafp_far_clip", {{"far_clip"}}, [this](Arguments arguments) {
    const double far_clip = sim::NumberArgument(arguments, 0, "far_clip");
    if (far_clip <= 0.0) return Json(0);
    projection_ = PerspectiveProjection(std::clamp(far_clip, 1.0, 1e9));  // of finite numbers
    return arguments[0];
  });
}

// What a script exposes by the robot's own add_service: its skills, and its properties as they are
// now, of which only those of a victim are more than a matter of the start. MORSE's
// get_configurations of a robot asks for the robot that it is mounted on, and fails.
void ServiceDirectory::AddRobotServices(sim::Robot& robot) {
  const std::string& name = robot.name();
  for (Service& skill : sim::RobotSkills(robot, simulation_.world())) Add(name, std::move(skill));
  // Found anew for each call: the world's list of objects may have been made anew.
  const auto properties = [this, &name]() -> Json& {
    return simulation_.world().objects().Find(name)->properties;
  };
  AddQuery(name, {"get_properties", {}, [properties](Arguments) {
                    return Json(Json::Object{{"properties", PropertyTable(properties())}});
                  }});
  Add(name,
      {"set_property", {{"name"}, {"value"}}, [&robot, properties](Arguments arguments) -> Json {
         const std::string& property = sim::StringArgument(arguments, 0, "name");
         const Json* const now = properties().Find(property);
         if (now == nullptr) {
           throw ServiceFailed("Property " + property + " does not exist for object " +
                               robot.name());
         }
         const auto& skills = robot.def().skills;
         const bool victim = std::find(skills.begin(), skills.end(), "heal") != skills.end();
         if (!victim ||
             (property != "Requirements" && property != "Injured" && property != "Severity")) {
           throw ServiceFailed("Property " + property + " of " + robot.name() +
                               " is fixed when the simulation starts; set it in the "
                               "scenario");
         }
         if (std::string_view(now->TypeName()) != arguments[1].TypeName()) {
           throw WrongArgument(property + " must be " + now->TypeName() + ", not " +
                               arguments[1].TypeName());
         }
         properties().Set(property, arguments[1]);
         return {};
       }});
  AddQuery(name, {"get_configurations", {}, [&robot](Arguments) -> Json {
                    throw WrongArgument("'" + robot.def().type +
                                        "' object has no attribute 'robot_parent'");
                  }});
}

Json ServiceDirectory::Details() const {
  static const Json kServiceInterfaces(
      Json::Array{"morse.middleware.socket_request_manager.SocketRequestManager"});
  constexpr const char* kStreamManager =
      "morse.middleware.socket_datastream.SocketDatastreamManager";
  Json::Array robots;
  for (const auto& robot : simulation_.robots()) {
    if (IsExternal(*robot)) continue;
    Json components(Json::Object{});
    for (const auto& component : robot->components()) {
      Json::Array services;
      Json entry(Json::Object{{"type", component->type()}});
      const auto table = services_.find(component->full_name());
      if (table != services_.end()) {  // MORSE leaves both out where there are none
        for (const auto& [name, service] : table->second) services.push_back(name);
        entry.Set("services", std::move(services));
        entry.Set("service_interfaces", kServiceInterfaces);
      }
      if (HasStream(*component)) {
        const bool out = dynamic_cast<const sim::Sensor*>(component.get()) != nullptr;
        entry.Set("stream_interfaces",
                  Json::Array{Json::Array{kStreamManager, out ? "OUT" : "IN"}});
      }
      // pymorse looks for all that a nested name goes through, simulated or not.
      const std::string& name = component->full_name();
      for (std::size_t dot = name.find('.', robot->name().size() + 1); dot != std::string::npos;
           dot = name.find('.', dot + 1)) {
        const std::string above = name.substr(0, dot);
        if (components.Find(above) == nullptr) {
          components.Set(above, Json(Json::Object{{"type", "Component"}}));
        }
      }
      components.Set(name, std::move(entry));
    }
    Json entry(Json::Object{{"name", robot->name()},
                            {"type", robot->def().type},
                            {"components", std::move(components)}});
    const auto own = services_.find(robot->name());
    if (own != services_.end()) {
      Json::Array services;
      for (const auto& [name, service] : own->second) services.push_back(name);
      entry.Set("services", std::move(services));
      entry.Set("services_interfaces", kServiceInterfaces);  // MORSE's spelling, here alone
    }
    robots.push_back(std::move(entry));
  }
  return Json(Json::Object{{"robots", std::move(robots)},
                           {"environment", simulation_.world().scene().name}});
}

Json ServiceDirectory::SceneObjects() const {
  Json objects(Json::Object{});
  for (const auto& robot : simulation_.robots()) {
    objects.Set(robot->name(), Json::Array{Json::Object{}, ToJson(robot->position()),
                                           YawQuaternion(robot->pose().yaw)});
  }
  for (const scene::Box& box : simulation_.world().scene().boxes) {
    const double z = box.raised ? box.height / 2.0 : -box.height / 2.0;
    objects.Set("box_" + std::to_string(box.id),
                Json::Array{Json::Object{}, ToJson({box.pose.x, box.pose.y, z}),
                            YawQuaternion(box.pose.yaw)});
  }
  return objects;
}

void ServiceDirectory::PlaceObject(Arguments arguments) {
  const std::string& name = sim::StringArgument(arguments, 0, "object_name");
  const Vec3 position = PointArgument(arguments, 1, "position");
  if (std::fabs(position.x) > scene::kFarthest || std::fabs(position.y) > scene::kFarthest) {
    throw WrongArgument("position must lie within 1000 m of the origin");
  }
  sim::Robot* robot = simulation_.FindRobot(name);
  if (robot == nullptr) {
    if (SceneObjects().Find(name) != nullptr) {
      throw ServiceFailed("Object '" + name + "' is part of the world and cannot be moved");
    }
    throw ServiceFailed("Object '" + name + "' does not appear in the scene.");
  }
  if (robot->dynamic()) {
    // Anywhere in space: what it overlaps there pushes it out.
    const Vec3 euler =
        arguments.size() > 2 ? PointArgument(arguments, 2, "orientation") : robot->euler();
    if (std::fabs(position.z) > scene::kFarthest) {
      throw WrongArgument("position must lie within 1000 m of the origin");
    }
    robot->PlaceInSpace({position, FromEuler(euler.x, euler.y, euler.z), {}, {}});
    simulation_.world().RobotsMoved();
    return;
  }
  const double yaw =
      arguments.size() > 2 ? PointArgument(arguments, 2, "orientation").z : robot->pose().yaw;
  const Pose2 pose{position.x, position.y, NormalizeAngle(yaw)};
  std::vector<const sim::Obstacle*> others;
  for (const sim::Obstacle& box : simulation_.world().obstacles()) others.push_back(&box);
  for (const auto& other : simulation_.robots()) {
    if (other.get() != robot) others.push_back(&other->outline());
  }
  if (sim::Collides(robot->footprint(), pose, others)) {
    throw ServiceFailed("Object '" + name + "' does not fit there: it would overlap an obstacle");
  }
  robot->Place(pose);
  simulation_.world().RobotsMoved();
}

// Where the real robot is, ours is, too: it may touch what in the model of the world stands a
// little farther out, so nothing is refused for that.
void ServiceDirectory::MirrorPose(Arguments arguments) {
  const std::string& name = sim::StringArgument(arguments, 0, "robot");
  const Vec3 pose = PointArgument(arguments, 1, "pose");
  if (std::fabs(pose.x) > scene::kFarthest || std::fabs(pose.y) > scene::kFarthest) {
    throw WrongArgument("pose must lie within 1000 m of the origin");
  }
  sim::Robot* robot = simulation_.FindRobot(name);
  if (robot == nullptr) throw ServiceFailed("There is no robot '" + name + "'.");
  robot->Place({pose.x, pose.y, NormalizeAngle(pose.z)});
  simulation_.world().RobotsMoved();
}

void ServiceDirectory::AddTimeServices() {
  const auto add = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                          std::function<Json(Arguments)> run) {
    AddQuery("time", {name, std::move(parameters), std::move(run)});
  };
  add("mode", {}, [this](Arguments) { return Json(control_.time_mode()); });
  add("now", {}, [this](Arguments) { return Json(simulation_.time()); });
  add("statistics", {}, [this](Arguments) { return control_.time_statistics(); });
  add("set_time_scale", {{"factor"}}, [this](Arguments arguments) {
    const double factor = sim::NumberArgument(arguments, 0, "factor");
    if (factor <= 0.0 || factor > 1000.0) {
      throw WrongArgument("factor must be greater than 0 and at most 1000");
    }
    return Json(control_.set_time_scale(factor));
  });
  Service sleep{"sleep", {{"delay"}}, nullptr, [this](Arguments arguments, sim::Completion done) {
                  const double delay = sim::NumberArgument(arguments, 0, "delay");
                  alarm_ = simulation_.time() + delay;
                  sleeper_ = std::move(done);
                }};
  sleep.while_running = sim::WhileRunning::kRefused;
  AddQuery("time", std::move(sleep));
}

TimeState ServiceDirectory::time_state() const {
  return control_.time_state ? control_.time_state() : TimeState{};
}

// Matters of the run, none of the simulation: they are no inputs, so a run that was stopped a while
// is the same run.
void ServiceDirectory::AddRunServices() {
  const auto add = [this](const char* name, std::vector<sim::ServiceParameter> parameters,
                          std::function<Json(Arguments)> run) {
    AddQuery("ccmorse", {name, std::move(parameters), std::move(run)});
  };
  const auto require = [](bool there) {
    if (!there) throw ServiceFailed("Time cannot be controlled here");
  };
  for (const bool pause : {true, false}) {
    add(pause ? "pause" : "resume", {}, [this, require, pause](Arguments) {
      require(control_.set_paused != nullptr);
      control_.set_paused(pause);
      return Json();
    });
  }
  AddQuery("ccmorse",
           {"step",
            {{"ticks", true}},
            nullptr,
            [this, require](Arguments arguments, sim::Completion done) {
              constexpr int kMost = 1'000'000;
              const int ticks =
                  arguments.empty() ? 1 : sim::IntegerArgument(arguments, 0, "ticks", 1, kMost);
              require(control_.step != nullptr);
              const std::uint64_t until = control_.step(ticks);
              if (until <= simulation_.tick()) {  // a record's end
                return done({Outcome::kSuccess, simulation_.time()});
              }
              steppers_.push_back({until, std::move(done)});
            }});
  add("set_speed", {{"factor"}}, [this, require](Arguments arguments) {
    double factor = std::numeric_limits<double>::infinity();
    if (!arguments[0].IsString() || arguments[0].AsString() != "max") {
      factor = sim::NumberArgument(arguments, 0, "factor");
      if (factor < 0.001 || factor > 1000.0) {
        throw WrongArgument("factor must be 0.001 to 1000, or \"max\"");
      }
    }
    require(control_.set_speed != nullptr);
    control_.set_speed(factor);
    return Json();
  });
  add("seek", {{"seconds"}}, [this](Arguments arguments) {
    const double seconds = sim::NumberArgument(arguments, 0, "seconds");
    if (control_.seek == nullptr) throw ServiceFailed("Only a record can be sought in");
    control_.seek(seconds);
    return Json();
  });
  add("time", {}, [this](Arguments) {
    const TimeState state = time_state();
    return Json(
        Json::Object{{"time", simulation_.time()},
                     {"tick", static_cast<std::int64_t>(simulation_.tick())},
                     {"paused", state.paused},
                     {"speed", std::isfinite(state.speed) ? Json(state.speed) : Json("max")}});
  });
  add("log", {{"after", true}}, [](Arguments arguments) {
    const double after = sim::NumberArgument(arguments, 0, "after", 0.0);
    Json::Array lines;
    for (const LogEntry& entry : RecentLog(static_cast<std::uint64_t>(std::fmax(after, 0.0)))) {
      static constexpr const char* kLevels[] = {"debug", "info", "warning", "error"};
      lines.push_back(Json::Object{{"number", static_cast<std::int64_t>(entry.number)},
                                   {"level", kLevels[static_cast<std::size_t>(entry.level)]},
                                   {"text", entry.text}});
    }
    return Json(std::move(lines));
  });
}

void ServiceDirectory::TimeAdvanced() {
  const auto over = std::stable_partition(
      steppers_.begin(), steppers_.end(),
      [this](const Stepper& stepper) { return stepper.until > simulation_.tick(); });
  std::vector<Stepper> finished(std::make_move_iterator(over),
                                std::make_move_iterator(steppers_.end()));
  steppers_.erase(over, steppers_.end());
  for (const Stepper& stepper : finished) stepper.done({Outcome::kSuccess, simulation_.time()});
  const double half_tick = 0.5 / simulation_.scenario().time.frequency;
  if (!sleeper_ || simulation_.time() <= alarm_ - half_tick) return;
  const sim::Completion done = std::exchange(sleeper_, nullptr);
  done({Outcome::kSuccess, Json()});
}

void ServiceDirectory::AddCommunicationServices() {
  AddQuery("communication",
           {"distance_and_view", {{"robot1"}, {"robot2"}}, [this](Arguments arguments) {
              const auto find = [this](const std::string& name) -> const sim::Robot& {
                const sim::Robot* robot = simulation_.FindRobot(name);
                if (robot == nullptr) {
                  throw ServiceFailed(name + " does not exist in the simulation ");
                }
                return *robot;
              };
              const sim::Robot& one = find(sim::StringArgument(arguments, 0, "robot1"));
              const sim::Robot& other = find(sim::StringArgument(arguments, 1, "robot2"));
              const Vec2 from{one.pose().x, one.pose().y};
              const Vec2 way = Vec2{other.pose().x, other.pose().y} - from;
              const double distance = std::sqrt(Dot(way, way));
              int hit = one.index();
              if (distance > 0.0) {
                simulation_.world().CastRay(from, (1.0 / distance) * way, one.position().z,
                                            distance, one.index(), &hit);
              }
              return Json(Json::Array{distance, hit == other.index()});
            }});
}

}  // namespace ccmorse::servers
