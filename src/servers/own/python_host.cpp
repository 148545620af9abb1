#include "servers/own/python_host.h"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "base/error.h"
#include "servers/own/own_components.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers {
namespace {

// Python itself stops code that takes too long, and says where it was. What it cannot stop, as it
// is not Python's, is killed so much later.
constexpr std::chrono::duration<double> kGrace(1.0);

Json PoseOf(const sim::Robot& robot) {
  const Vec3 at = robot.position();
  const Vec3 velocity = robot.velocity();
  return Json(Json::Array{at.x, at.y, at.z, 0.0, 0.0, robot.pose().yaw, velocity.x, velocity.y,
                          velocity.z, 0.0, 0.0, robot.twist().w});
}

Json VectorOf(const Vec3& v) { return Json(Json::Array{v.x, v.y, v.z}); }

Json RobotFacts(const sim::Robot& robot) {
  const scene::RobotDef& def = robot.def();
  const scene::RobotModel& model = robot.model();
  return Json(
      Json::Object{{"type", def.type},
                   {"size", Json::Array{model.length, model.width, model.height}},
                   {"mass", model.mass},
                   {"wheel_radius", model.wheel_radius},
                   {"wheel_track", model.wheel_track},
                   {"max_speed", model.max_speed},
                   {"max_turn_rate", model.max_turn_rate},
                   {"color", Json::Array{int{def.color.r}, int{def.color.g}, int{def.color.b}}},
                   {"start", Json::Array{def.pose.x, def.pose.y, def.pose.yaw}},
                   {"properties", def.properties}});
}

const char* KindWord(OwnTask::Kind kind) {
  switch (kind) {
    case OwnTask::Kind::kActivate:
      return "act";
    case OwnTask::Kind::kCall:
      return "call";
    case OwnTask::Kind::kStart:
      return "start";
    case OwnTask::Kind::kEnded:
      return "ended";
    case OwnTask::Kind::kInterrupt:
      break;
  }
  return "interrupt";
}

const sim::Component& ComponentOfTask(const OwnTask& task) {
  return task.overlay != nullptr ? *task.overlay->overlaid : task.component->component();
}

Json::Array JsonOfTexts(const std::vector<std::string>& texts) {
  return Json::Array(texts.begin(), texts.end());
}

Json OffAnswer(const std::string& text) { return Json(Json::Object{{"off", text}}); }

}  // namespace

PythonHost::PythonHost(sim::Simulation& simulation, std::vector<sim::OwnComponent*> components,
                       std::vector<Overlay*> overlays, const OwnOptions& options, Asker asker,
                       const Taker& taker)
    : simulation_(simulation),
      components_(std::move(components)),
      overlays_(std::move(overlays)),
      python_(options.python),
      folder_(options.python_folder),
      limit_(options.time_limit),
      start_limit_(options.start_time_limit),
      asker_(std::move(asker)) {
  if (python_.empty()) {
    throw Error(
        "components and overlays in Python need python3, which is nowhere in PATH; install it");
  }
  Begin(taker, false);
}

Json PythonHost::Scene(bool anew) const {
  Json robots(Json::Object{});
  for (const auto& robot : simulation_.robots()) robots.Set(robot->name(), RobotFacts(*robot));
  const sim::Canvas& canvas = simulation_.canvas();
  const scene::Scenario& scenario = simulation_.scenario();
  Json::Array components;
  for (const sim::OwnComponent* component : components_)
    components.push_back(Birth(*component, anew));
  Json::Array overlays;
  for (const Overlay* overlay : overlays_) overlays.push_back(Birth(*overlay));
  return Json(Json::Object{{"robots", std::move(robots)},
                           {"canvas", Json::Array{canvas.width(), canvas.height()}},
                           {"world", Json::Array{scenario.world.size_x, scenario.world.size_y,
                                                 scenario.world.low.x, scenario.world.low.y}},
                           {"frequency", scenario.time.frequency},
                           {"seed", static_cast<std::int64_t>(scenario.seed)},
                           {"time", simulation_.time()},
                           {"limit", limit_.count()},
                           {"start_limit", start_limit_.count()},
                           {"components", std::move(components)},
                           {"overlays", std::move(overlays)},
                           {"poses", Poses({})}});
}

Json PythonHost::Birth(const sim::OwnComponent& own, bool anew) const {
  const sim::Component& component = own.component();
  const scene::OwnDef& def = own.def();
  return Json(Json::Object{{"name", component.full_name()},
                           {"robot", component.robot().name()},
                           {"class", def.code},
                           {"path", JsonOfTexts(def.path)},
                           {"level", def.level},
                           {"frequency", component.frequency()},
                           {"mount", VectorOf(component.mount())},
                           {"mount_euler", VectorOf(component.mount_euler())},
                           {"anew", anew},
                           {"data", own.data()},
                           {"properties", component.Properties()}});
}

Json PythonHost::Birth(const Overlay& overlay) const {
  const sim::Component& component = *overlay.overlaid;
  Json services(Json::Object{});  // name -> whether it answers later
  for (const char* name : {"get_local_data", "get_properties", "get_configurations"}) {
    services.Set(name, false);
  }
  services.Set("set_property", false);
  for (const sim::Service& service : component.services()) {
    services.Set(service.name, service.start != nullptr);
  }
  return Json(Json::Object{{"overlay", overlay.key},
                           {"name", component.full_name()},
                           {"robot", component.robot().name()},
                           {"class", overlay.def->code},
                           {"path", JsonOfTexts(overlay.def->path)},
                           {"settings", overlay.def->settings},
                           {"mount", VectorOf(component.mount())},
                           {"mount_euler", VectorOf(component.mount_euler())},
                           {"services", std::move(services)}});
}

// All robots' where there are no tasks, else those of the tasks'.
Json PythonHost::Poses(std::span<const OwnTask> tasks) const {
  Json poses(Json::Object{});
  for (const auto& robot : simulation_.robots()) {
    const bool wanted =
        tasks.empty() || std::any_of(tasks.begin(), tasks.end(), [&](const auto& t) {
          return &ComponentOfTask(t).robot() == robot.get();
        });
    if (wanted) poses.AsObject().emplace_back(robot->name(), PoseOf(*robot));
  }
  return poses;
}

Json PythonHost::TaskJson(const OwnTask& task) const {
  const std::string& name =
      task.overlay != nullptr ? task.overlay->key : ComponentOfTask(task).full_name();
  Json json(Json::Object{{"n", name}, {"k", KindWord(task.kind)}});
  if (task.kind == OwnTask::Kind::kEnded) {
    json.Set("i", task.ticket);
    json.Set("r", Json::Array(task.arguments.begin(), task.arguments.end()));
  }
  if (task.kind == OwnTask::Kind::kCall || task.kind == OwnTask::Kind::kStart) {
    json.Set("s", task.service);
    json.Set("a", Json::Array(task.arguments.begin(), task.arguments.end()));
  }
  if (task.kind == OwnTask::Kind::kStart) json.Set("t", task.ticket);
  if (task.component == nullptr) return json;
  if (task.overlay != nullptr) json.Set("o", ComponentOfTask(task).full_name());
  if (task.component->TakeDataChanged()) json.Set("d", task.component->data());
  if (task.component->TakePropertiesChanged()) {
    json.Set("p", task.component->component().Properties());
  }
  return json;
}

// Has what is not off made in a new process, until one lives that has made all that is left.
void PythonHost::Begin(const Taker& taker, bool anew) {
  for (bool whole = false; !whole;) {
    process_ = std::make_unique<PythonProcess>(python_, folder_);
    whole = true;
    const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(start_limit_);
    process_->Send(Scene(anew).Dump(), deadline);
    std::vector<OwnTask> all;
    for (sim::OwnComponent* component : components_) all.push_back({component});
    for (Overlay* overlay : overlays_) {
      OwnTask task{overlay->own};
      task.overlay = overlay;
      all.push_back(task);
    }
    for (const OwnTask& task : all) {
      if (BeginOne(task, taker, anew)) continue;
      whole = components_.empty() && overlays_.empty();  // else once more, without it
      break;
    }
  }
}

// False: the process has hung or died over it.
bool PythonHost::BeginOne(const OwnTask& task, const Taker& taker, bool anew) {
  std::string reason;
  Json answer = ReadAnswer(start_limit_, &reason);
  if (answer.IsNull()) {
    taker(task, OffAnswer(LastPlace(task) + reason));
    Drop(task);
    return false;
  }
  if (answer.Find("off") != nullptr) Drop(task);
  if (anew) answer.Set("anew", true);
  if (task.overlay == nullptr) {
    const Json* const at = answer.Find("at");
    if (at != nullptr && at->IsString()) places_[task.component] = at->AsString();
    task.component->TakeDataChanged();
    task.component->TakePropertiesChanged();
  }
  taker(task, answer);
  return true;
}

void PythonHost::Drop(const OwnTask& task) {
  if (task.overlay != nullptr) {
    std::erase(overlays_, task.overlay);
  } else {
    std::erase(components_, task.component);
  }
}

bool PythonHost::IsThere(const OwnTask& task) const {
  return task.overlay != nullptr
             ? std::find(overlays_.begin(), overlays_.end(), task.overlay) != overlays_.end()
             : std::find(components_.begin(), components_.end(), task.component) !=
                   components_.end();
}

Json PythonHost::ReadAnswer(std::chrono::duration<double> limit, std::string* reason) {
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit + kGrace);
  std::string line;
  for (;;) {
    const PythonProcess::Result result = process_->Read(line, deadline);
    if (result != PythonProcess::Result::kDone) {
      const std::string end = process_->End();
      *reason = result == PythonProcess::Result::kTooLate
                    ? fmt::format("it has not answered for {} s of wall-clock time",
                                  (limit + kGrace).count())
                    : fmt::format("it has ended its process ({})", end);
      return {};
    }
    try {
      Json answer = Json::Parse(line);
      const Json* const question = answer.Find("ask");
      if (question == nullptr) return answer;
      Json reply;
      try {
        reply = asker_(*question);
      } catch (const std::exception& error) {
        reply = Json(Json::Object{{"failed", error.what()}});
      }
      process_->Send(reply.Dump(), deadline);
    } catch (const JsonError& error) {
      process_->End();
      *reason = fmt::format("it has spoilt the conversation with the simulator: {}", error.what());
      return {};
    }
  }
}

// "FILE:LINE: in NAME: " of the innermost call that is the user's, as Python's faulthandler has put
// it; else where its default action is.
std::string PythonHost::LastPlace(const OwnTask& task) const {
  constexpr std::string_view kFile = "  File \"";
  constexpr std::string_view kLine = "\", line ";
  const std::string& trace = process_->trace();
  const Overlay* const overlay = task.overlay;
  const auto known = overlay != nullptr ? places_.end() : places_.find(task.component);
  std::string fallback =
      known != places_.end()
          ? known->second
          : (overlay != nullptr ? overlay->def->code : task.component->def().code) + ": ";
  bool first = true;
  for (std::size_t at = 0; (at = trace.find(kFile, at)) != std::string::npos;) {
    at += kFile.size();
    const std::size_t line = trace.find(kLine, at);
    const std::size_t end = trace.find('\n', at);
    if (line == std::string::npos || line > end) continue;
    const std::string file = trace.substr(at, line - at);
    const std::size_t number = line + kLine.size();
    const std::size_t in = trace.find(" in ", number);
    if (in == std::string::npos || in > end) continue;
    const std::string place = fmt::format("{}:{}: in {}: ", file, trace.substr(number, in - number),
                                          trace.substr(in + 4, end - in - 4));
    const auto& path = overlay != nullptr ? overlay->def->path : task.component->def().path;
    const bool users = std::any_of(path.begin(), path.end(), [&](const std::string& folder) {
      return file.starts_with(folder + "/");
    });
    if (users) return place;
    if (std::exchange(first, false) && !file.starts_with(folder_ + "/")) fallback = place;
  }
  return fallback;
}

void PythonHost::Perform(std::span<const OwnTask> tasks, const Taker& taker) {
  while (!tasks.empty()) {
    if (components_.empty() && overlays_.empty()) return;
    Json::Array list;
    for (const OwnTask& task : tasks) list.push_back(TaskJson(task));
    const Json message(Json::Object{{"time", simulation_.time()},
                                    {"tick", static_cast<std::int64_t>(simulation_.tick())},
                                    {"poses", Poses(tasks)},
                                    {"tasks", std::move(list)}});
    process_->Send(message.Dump(),
                   Clock::now() + std::chrono::duration_cast<Clock::duration>(limit_ + kGrace));
    bool died = false;
    while (!tasks.empty() && !died) {
      const OwnTask& task = tasks.front();
      std::string reason;
      Json answer = ReadAnswer(limit_, &reason);
      died = answer.IsNull();
      if (died) answer = OffAnswer(LastPlace(task) + reason);
      if (answer.Find("off") != nullptr) Drop(task);
      taker(task, answer);
      tasks = tasks.subspan(1);
    }
    if (!died) return;
    if (!components_.empty() || !overlays_.empty()) Begin(taker, true);
    // One that the new process could not make is not asked.
    while (!tasks.empty() && !IsThere(tasks.front())) tasks = tasks.subspan(1);
  }
}

}  // namespace ccmorse::servers
