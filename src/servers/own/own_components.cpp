#include "servers/own/own_components.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "servers/own/plugin_host.h"
#include "servers/own/python_host.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers {
namespace {

using sim::Outcome;

const std::string* TextOf(const Json& answer, const char* key) {
  const Json* const text = answer.Find(key);
  return text != nullptr && text->IsString() ? &text->AsString() : nullptr;
}

const char* WordOfOutcome(Outcome outcome) {
  if (outcome == Outcome::kSuccess) return "SUCCESS";
  return outcome == Outcome::kPreempted ? "PREEMPTED" : "FAILED";
}

Json ValueOfResult(const sim::ServiceResult& result) {
  return result.text.empty() ? result.value : Json::Parse(result.text);
}

OwnTask TaskOf(Overlay& overlay, OwnTask::Kind kind) {
  OwnTask task{overlay.own, kind};
  task.overlay = &overlay;
  return task;
}

const std::string& NameOfTask(const OwnTask& task) {
  return task.overlay != nullptr ? task.overlay->key : task.component->component().full_name();
}

Outcome OutcomeOf(const Json& word) {
  if (word == Json("SUCCESS")) return Outcome::kSuccess;
  return word == Json("PREEMPTED") ? Outcome::kPreempted : Outcome::kFailed;
}

bool Uses(const scene::Scenario& scenario, std::string_view language) {
  for (const scene::RobotDef& robot : scenario.robots) {
    if (!robot.components) continue;
    for (const scene::ComponentDef& component : *robot.components) {
      if (component.own && component.own->language == language) return true;
      if (!component.overlays.empty() && language == "python") return true;
    }
  }
  return false;
}

}  // namespace

bool OwnComponents::AreThere(const scene::Scenario& scenario) {
  return Uses(scenario, "python") || Uses(scenario, "c++");
}

OwnComponents::OwnComponents(sim::Simulation& simulation, ServiceDirectory& directory,
                             const OwnOptions& options)
    : simulation_(simulation), directory_(directory) {
  for (const auto& robot : simulation.robots()) {
    for (const auto& component : robot->components()) {
      auto* const own = dynamic_cast<sim::OwnComponent*>(component.get());
      if (own != nullptr) components_.push_back(own);
    }
  }
  const auto of = [this](std::string_view language) {
    std::vector<sim::OwnComponent*> found;
    std::copy_if(components_.begin(), components_.end(), std::back_inserter(found),
                 [&](const auto* each) { return each->def().language == language; });
    return found;
  };
  AddOverlays();
  // They are inputs of the run, which has not begun.
  const CodeHost::Taker taker = [this](const OwnTask& task, const OwnAnswer& answer) {
    first_answers_.emplace_back(task, answer);
  };
  if (Uses(simulation.scenario(), "python")) {
    std::vector<Overlay*> overlays;
    for (const auto& overlay : overlays_) overlays.push_back(overlay.get());
    python_ = std::make_unique<PythonHost>(
        simulation, of("python"), std::move(overlays), options,
        [this](const Json& question) { return Ask(question); }, taker);
  }
  if (Uses(simulation.scenario(), "c++")) {
    plugins_ = std::make_unique<PluginHost>(simulation, of("c++"), taker);
  }
  for (sim::OwnComponent* component : components_) component->set_code(this);
  for (const auto& [task, answer] : first_answers_) {
    const std::string* const name = TextOf(answer, "name");
    if (task.overlay != nullptr && name != nullptr) Register(*task.overlay, *name);
  }
}

OwnComponents::~OwnComponents() {
  *self_ = nullptr;
  for (sim::OwnComponent* component : components_) component->set_code(nullptr);
}

CodeHost& OwnComponents::HostOf(const OwnTask& task) {
  return task.overlay != nullptr || task.component->def().language == "python" ? *python_
                                                                               : *plugins_;
}

bool OwnComponents::IsOff(const OwnTask& task) {
  return (task.overlay != nullptr && task.overlay->off) ||
         (task.component != nullptr && off_[task.component]);
}

void OwnComponents::AddOverlays() {
  for (const auto& robot : simulation_.robots()) {
    if (!robot->def().components) continue;
    for (const scene::ComponentDef& component : *robot->def().components) {
      for (const scene::OverlayDef& def : component.overlays) {
        const std::string full_name = robot->name() + "." + component.name;
        auto overlay = std::make_unique<Overlay>();
        overlay->def = &def;
        overlay->overlaid = simulation_.FindComponent(full_name);
        if (overlay->overlaid == nullptr) continue;  // another simulator's
        auto* const own = dynamic_cast<sim::OwnComponent*>(overlay->overlaid);
        if (own != nullptr && own->def().language == "python") overlay->own = own;
        // A component may have more than one, of the same class, too.
        overlay->key = fmt::format("overlay {} of {} ({})", def.code, full_name, overlays_.size());
        overlays_.push_back(std::move(overlay));
      }
    }
  }
}

// Has clients find an overlay's services.
void OwnComponents::Register(Overlay& overlay, const std::string& name) {
  const bool word = !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
  });
  if (!word) return SwitchOff(overlay, fmt::format("its name '{}' is no word", name));
  if (directory_.HasServices(name) || simulation_.FindComponent(name) != nullptr) {
    return SwitchOff(overlay, fmt::format("its name {} is taken", name));
  }
  overlay.name = name;
  for (const scene::OwnServiceDef& def : overlay.def->services) {
    sim::Service service;
    service.name = def.name;
    for (const auto& parameter : def.parameters) {
      service.parameters.push_back({parameter.name, parameter.optional});
    }
    service.changes_simulation = false;  // what it calls does
    const auto task = [&overlay, name = def.name](OwnTask::Kind kind, sim::Arguments arguments) {
      OwnTask made = TaskOf(overlay, kind);
      made.service = name;
      made.arguments = arguments;
      return made;
    };
    const auto self = [alive = self_] {
      if (*alive == nullptr) throw sim::ServiceFailed("Its code does not run any more");
      return *alive;
    };
    if (def.asynchronous) {
      service.start = [task, self](sim::Arguments arguments, sim::Completion done) {
        self()->StartOne(task(OwnTask::Kind::kStart, arguments), std::move(done));
      };
    } else {
      service.run = [task, self](sim::Arguments arguments) {
        return self()->CallOne(task(OwnTask::Kind::kCall, arguments));
      };
    }
    directory_.Add(name, std::move(service));
  }
  directory_.AddInterrupt(name, [alive = self_, &overlay] {
    if (*alive != nullptr) (*alive)->InterruptOne(TaskOf(overlay, OwnTask::Kind::kInterrupt));
  });
}

void OwnComponents::Sensed() {
  for (const auto& [task, answer] : std::exchange(first_answers_, {})) Take(task, answer);
  tasks_.clear();
  for (sim::Sensor* sensor : simulation_.sampled()) {
    auto* const own = dynamic_cast<sim::OwnComponent*>(sensor);
    if (own != nullptr && !off_[own]) tasks_.push_back({own});
  }
  TellEnds();
  Perform(tasks_);
  TellEnds();
}

void OwnComponents::BeforeAct() {
  TellEnds();
  const sim::Instant now{simulation_.tick(), simulation_.time(), 0.0};
  tasks_.clear();
  for (sim::OwnComponent* component : components_) {
    const auto* const actuator = dynamic_cast<sim::OwnActuator*>(component);
    if (actuator != nullptr && !off_[component] && actuator->active() && actuator->IsDue(now)) {
      tasks_.push_back({component});
    }
  }
  Perform(tasks_);
}

void OwnComponents::Perform(std::vector<OwnTask>& tasks) {
  if (tasks.empty()) return;
  busy_ = true;
  for (const auto& host : {python_.get(), plugins_.get()}) {
    if (host == nullptr) continue;
    std::vector<OwnTask> own;
    for (const OwnTask& task : tasks) {
      if (&HostOf(task) == host) own.push_back(task);
    }
    if (own.empty()) continue;
    host->Perform(own,
                  [this](const OwnTask& task, const OwnAnswer& answer) { Take(task, answer); });
  }
  busy_ = false;
}

OwnAnswer OwnComponents::PerformOne(OwnTask task) {
  const std::string off = NameOfTask(task) + " was switched off: its code has failed";
  if (IsOff(task)) throw sim::ServiceFailed(off);
  if (busy_) throw sim::ServiceFailed("Components of one's own do not call each other");
  OwnAnswer kept;
  busy_ = true;
  const std::vector<OwnTask> tasks = {std::move(task)};
  HostOf(tasks.front()).Perform(tasks, [&](const OwnTask& done, const OwnAnswer& answer) {
    // What was made anew, as the code has crashed, answers as if it were due.
    if (done.kind != OwnTask::Kind::kActivate) kept = answer;
    // The caller's own answer comes before those of services that it has ended.
    Take(done, answer);
  });
  busy_ = false;
  if (const std::string* const text = TextOf(kept, "failed")) throw sim::ServiceFailed(*text);
  if (const std::string* const text = TextOf(kept, "wrong")) throw sim::WrongArgument(*text);
  if (TextOf(kept, "off") != nullptr) throw sim::ServiceFailed(off);
  return kept;
}

Json OwnComponents::Call(sim::OwnComponent& component, const std::string& service,
                         sim::Arguments arguments) {
  return CallOne({&component, OwnTask::Kind::kCall, service, arguments, 0});
}

void OwnComponents::Start(sim::OwnComponent& component, const std::string& service,
                          sim::Arguments arguments, sim::Completion done) {
  StartOne({&component, OwnTask::Kind::kStart, service, arguments, 0}, std::move(done));
}

void OwnComponents::Interrupt(sim::OwnComponent& component) {
  InterruptOne({&component, OwnTask::Kind::kInterrupt});
}

Json OwnComponents::CallOne(const OwnTask& task) {
  const OwnAnswer answer = PerformOne(task);
  TellEnds();
  const Json* const result = answer.Find("result");
  return result != nullptr ? *result : Json();
}

void OwnComponents::StartOne(OwnTask task, sim::Completion done) {
  const std::int64_t ticket = ++last_ticket_;
  task.ticket = ticket;
  const void* const of = task.overlay != nullptr ? static_cast<const void*>(task.overlay)
                                                 : static_cast<const void*>(task.component);
  // Before the code runs: it may be done at once.
  pending_[ticket] = {of, std::move(done)};
  try {
    PerformOne(std::move(task));
  } catch (...) {
    // Whoever called answers it.
    pending_.erase(ticket);
    throw;
  }
  TellEnds();
}

void OwnComponents::InterruptOne(const OwnTask& task) {
  if (IsOff(task) || busy_) return;
  const void* const of = task.overlay != nullptr ? static_cast<const void*>(task.overlay)
                                                 : static_cast<const void*>(task.component);
  const bool runs = std::any_of(pending_.begin(), pending_.end(),
                                [&](const auto& each) { return each.second.of == of; });
  if (!runs) return;
  try {
    PerformOne(task);
  } catch (const sim::ServiceFailed&) {
    // It has been said in the log.
  }
  TellEnds();
}

void OwnComponents::Take(const OwnTask& task, const OwnAnswer& answer) {
  const std::string& name = NameOfTask(task);
  const void* const of = task.overlay != nullptr ? static_cast<const void*>(task.overlay)
                                                 : static_cast<const void*>(task.component);
  const auto switch_off = [&](const std::string& reason) {
    if (task.overlay != nullptr) {
      SwitchOff(*task.overlay, reason);
    } else {
      SwitchOff(*task.component, reason);
    }
  };
  // An overlay of a component of one's own does to the world what that may do.
  const Json* const change = answer.Find("change");
  if (change != nullptr && task.component != nullptr) {
    try {
      directory_.ChangeOwn(*task.component, *change);
    } catch (const Error& error) {
      switch_off(error.what());
    }
  }
  if (const std::string* const text = TextOf(answer, "error")) LogError("{}: {}", name, *text);
  if (const Json* const ended = answer.Find("ended")) {
    for (const Json& each : ended->AsArray()) {
      const auto found = pending_.find(each.AsArray()[0].AsInt());
      if (found == pending_.end()) continue;
      const sim::Completion done = std::move(found->second.done);
      pending_.erase(found);
      done({OutcomeOf(each.AsArray()[1]), each.AsArray()[2]});
    }
  }
  if (const Json* const anew = answer.Find("anew"); anew != nullptr && !anew->IsFalsy()) {
    // What it waits for is nothing to the one that was made anew.
    std::erase_if(waits_, [&](const auto& wait) { return wait.second.overlay == task.overlay; });
    EndServices(of, "The code of " + name + " was started anew, as other code has crashed");
  }
  if (const std::string* const text = TextOf(answer, "off")) switch_off(*text);
}

void OwnComponents::SwitchOff(Overlay& overlay, const std::string& reason) {
  if (std::exchange(overlay.off, true)) return;
  LogError("{} is switched off: {}", overlay.key, reason);
  std::erase_if(waits_, [&](const auto& wait) { return wait.second.overlay == &overlay; });
  EndServices(&overlay, overlay.key + " was switched off: its code has failed");
}

void OwnComponents::SwitchOff(sim::OwnComponent& component, const std::string& reason) {
  if (std::exchange(off_[&component], true)) return;
  LogError("{} is switched off: {}", component.component().full_name(), reason);
  // The reason names places on this machine, which are nothing for a record.
  directory_.ChangeOwn(component, Json(Json::Object{{"off", true}}));
  EndServices(&component,
              component.component().full_name() + " was switched off: its code has failed");
}

void OwnComponents::EndServices(const void* of, const std::string& reason) {
  std::vector<sim::Completion> waiting;
  for (auto it = pending_.begin(); it != pending_.end();) {
    if (it->second.of != of) {
      ++it;
      continue;
    }
    waiting.push_back(std::move(it->second.done));
    it = pending_.erase(it);
  }
  for (const sim::Completion& done : waiting) done({Outcome::kFailed, Json(reason)});
}

// What an overlay starts of its component: [component, service, [arguments], overlay, callback].
// Where it does not end at once, the overlay is told when it has.
Json OwnComponents::AskToStart(const ServiceDirectory::Target& target,
                               const Json::Array& question) {
  const auto overlay = std::find_if(overlays_.begin(), overlays_.end(), [&](const auto& each) {
    return each->key == question[3].AsString();
  });
  if (overlay == overlays_.end()) throw Error("there is no such overlay");
  struct Running {
    bool asked = true;
    std::optional<sim::ServiceResult> result;
  };
  const auto running = std::make_shared<Running>();
  const std::int64_t wait = ++last_wait_;
  waits_[wait] = {overlay->get(), question[4].AsInt()};
  directory_.Run(target, question[2].AsArray(),
                 [alive = self_, running, wait](const sim::ServiceResult& result) {
                   if (running->asked) {
                     running->result = {result.outcome, ValueOfResult(result)};
                   } else if (*alive != nullptr) {
                     (*alive)->Ended(wait, Json(Json::Array{WordOfOutcome(result.outcome),
                                                            ValueOfResult(result)}));
                   }
                 });
  running->asked = false;
  if (!running->result) return Json(Json::Object{{"later", true}});
  waits_.erase(wait);
  const sim::ServiceResult& result = *running->result;
  if (result.outcome == Outcome::kFailed) return Json(Json::Object{{"failed", result.value}});
  return Json(Json::Object{{"ended", Json::Array{WordOfOutcome(result.outcome), result.value}}});
}

void OwnComponents::Ended(std::int64_t wait, Json end) {
  const auto found = waits_.find(wait);
  if (found != waits_.end()) found->second.end = std::move(end);
}

// The simulator is in the middle of something when services end, so overlays are told later.
void OwnComponents::TellEnds() {
  while (!busy_) {
    const auto found = std::find_if(waits_.begin(), waits_.end(),
                                    [](const auto& wait) { return wait.second.end.has_value(); });
    if (found == waits_.end()) return;
    const Wait wait = std::move(found->second);
    waits_.erase(found);
    OwnTask task = TaskOf(*wait.overlay, OwnTask::Kind::kEnded);
    task.arguments = wait.end->AsArray();
    task.ticket = wait.callback;
    try {
      PerformOne(task);
    } catch (const sim::ServiceFailed&) {
      // It is off, as the log has said.
    }
  }
}

// A question of own code, [component, service, [arguments]], to services that answer at once.
Json OwnComponents::Ask(const Json& question) {
  const auto failed = [](const std::string& text) { return Json(Json::Object{{"failed", text}}); };
  const Json::Array& words = question.AsArray();
  const std::string& component = words[0].AsString();
  const std::string& service = words[1].AsString();
  const Json::Array& arguments = words[2].AsArray();
  const sim::Canvas& canvas = simulation_.canvas();
  if (component == "canvas" && service == "get_pixel") {
    const int x = sim::IntegerArgument(arguments, 0, "x", -1'000'000'000, 1'000'000'000);
    const int y = sim::IntegerArgument(arguments, 1, "y", -1'000'000'000, 1'000'000'000);
    if (!canvas.Contains(x, y)) return failed("there is no such cell");
    const Color color = canvas.GetPixel(x, y);
    return Json(Json::Object{{"result", Json::Array{int{color.r}, int{color.g}, int{color.b}}}});
  }
  if (component.empty() && service == "interrupt") {
    directory_.Interrupt(arguments[0].AsString());
    return Json(Json::Object{{"result", Json()}});
  }
  const ServiceDirectory::Target target = directory_.Find(component, service);
  if (target.service == nullptr) return failed(ServiceDirectory::NotRegistered(service));
  if (target.service->start) {
    if (words.size() == 5) return AskToStart(target, words);
    return failed(service + " answers later; only clients can wait for it");
  }
  std::optional<Json> answer;
  directory_.Run(target, arguments, [&](const sim::ServiceResult& result) {
    answer = Json(Json::Object{
        {result.outcome == Outcome::kSuccess ? "result" : "failed", ValueOfResult(result)}});
  });
  return answer ? *answer : failed(service + " does not answer");
}

}  // namespace ccmorse::servers
