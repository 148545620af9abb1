#include "servers/own/own_components.h"

#include <algorithm>
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

Outcome OutcomeOf(const Json& word) {
  if (word == Json("SUCCESS")) return Outcome::kSuccess;
  return word == Json("PREEMPTED") ? Outcome::kPreempted : Outcome::kFailed;
}

bool Uses(const scene::Scenario& scenario, std::string_view language) {
  for (const scene::RobotDef& robot : scenario.robots) {
    if (!robot.components) continue;
    for (const scene::ComponentDef& component : *robot.components) {
      if (component.own && component.own->language == language) return true;
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
  // They are inputs of the run, which has not begun.
  const CodeHost::Taker taker = [this](const OwnTask& task, const OwnAnswer& answer) {
    first_answers_.emplace_back(task, answer);
  };
  if (Uses(simulation.scenario(), "python")) {
    python_ = std::make_unique<PythonHost>(
        simulation, of("python"), options, [this](const Json& question) { return Ask(question); },
        taker);
  }
  if (Uses(simulation.scenario(), "c++")) {
    plugins_ = std::make_unique<PluginHost>(simulation, of("c++"), taker);
  }
  for (sim::OwnComponent* component : components_) component->set_code(this);
}

OwnComponents::~OwnComponents() {
  for (sim::OwnComponent* component : components_) component->set_code(nullptr);
}

CodeHost& OwnComponents::HostOf(const sim::OwnComponent& component) {
  return component.def().language == "python" ? *python_ : *plugins_;
}

void OwnComponents::Sensed() {
  for (const auto& [task, answer] : std::exchange(first_answers_, {})) Take(task, answer);
  tasks_.clear();
  for (sim::Sensor* sensor : simulation_.sampled()) {
    auto* const own = dynamic_cast<sim::OwnComponent*>(sensor);
    if (own != nullptr && !off_[own]) tasks_.push_back({own});
  }
  Perform(tasks_);
}

void OwnComponents::BeforeAct() {
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
      if (&HostOf(*task.component) == host) own.push_back(task);
    }
    if (own.empty()) continue;
    host->Perform(own,
                  [this](const OwnTask& task, const OwnAnswer& answer) { Take(task, answer); });
  }
  busy_ = false;
}

OwnAnswer OwnComponents::PerformOne(OwnTask task) {
  if (off_[task.component]) {
    throw sim::ServiceFailed(task.component->component().full_name() +
                             " was switched off: its code has failed");
  }
  if (busy_) throw sim::ServiceFailed("Components of one's own do not call each other");
  OwnAnswer kept;
  busy_ = true;
  const std::vector<OwnTask> tasks = {std::move(task)};
  HostOf(*tasks.front().component)
      .Perform(tasks, [&](const OwnTask& done, const OwnAnswer& answer) {
        kept = answer;
        // The caller's own answer comes before those of services that it has ended.
        Take(done, answer);
      });
  busy_ = false;
  if (const std::string* const text = TextOf(kept, "failed")) throw sim::ServiceFailed(*text);
  if (const std::string* const text = TextOf(kept, "wrong")) throw sim::WrongArgument(*text);
  if (TextOf(kept, "off") != nullptr) {
    throw sim::ServiceFailed(tasks.front().component->component().full_name() +
                             " was switched off: its code has failed");
  }
  return kept;
}

Json OwnComponents::Call(sim::OwnComponent& component, const std::string& service,
                         sim::Arguments arguments) {
  const OwnAnswer answer = PerformOne({&component, OwnTask::Kind::kCall, service, arguments, 0});
  const Json* const result = answer.Find("result");
  return result != nullptr ? *result : Json();
}

void OwnComponents::Start(sim::OwnComponent& component, const std::string& service,
                          sim::Arguments arguments, sim::Completion done) {
  const std::int64_t ticket = ++last_ticket_;
  // Before the code runs: it may be done at once.
  pending_[ticket] = {&component, std::move(done)};
  try {
    PerformOne({&component, OwnTask::Kind::kStart, service, arguments, ticket});
  } catch (...) {
    // Whoever called answers it.
    pending_.erase(ticket);
    throw;
  }
}

void OwnComponents::Interrupt(sim::OwnComponent& component) {
  if (off_[&component] || busy_) return;
  const bool runs = std::any_of(pending_.begin(), pending_.end(), [&](const auto& each) {
    return each.second.component == &component;
  });
  if (!runs) return;
  try {
    PerformOne({&component, OwnTask::Kind::kInterrupt});
  } catch (const sim::ServiceFailed&) {
    // It has been said in the log.
  }
}

void OwnComponents::Take(const OwnTask& task, const OwnAnswer& answer) {
  sim::OwnComponent& component = *task.component;
  if (const Json* const change = answer.Find("change")) {
    try {
      directory_.ChangeOwn(component, *change);
    } catch (const Error& error) {
      SwitchOff(component, error.what());
    }
  }
  if (const std::string* const text = TextOf(answer, "error")) {
    LogError("{}: {}", component.component().full_name(), *text);
  }
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
    EndServices(component, "The code of " + component.component().full_name() +
                               " was started anew, as other code has crashed");
  }
  if (const std::string* const text = TextOf(answer, "off")) SwitchOff(component, *text);
}

void OwnComponents::SwitchOff(sim::OwnComponent& component, const std::string& reason) {
  if (std::exchange(off_[&component], true)) return;
  LogError("{} is switched off: {}", component.component().full_name(), reason);
  // The reason names places on this machine, which are nothing for a record.
  directory_.ChangeOwn(component, Json(Json::Object{{"off", true}}));
  EndServices(component,
              component.component().full_name() + " was switched off: its code has failed");
}

void OwnComponents::EndServices(const sim::OwnComponent& component, const std::string& reason) {
  std::vector<sim::Completion> waiting;
  for (auto it = pending_.begin(); it != pending_.end();) {
    if (it->second.component != &component) {
      ++it;
      continue;
    }
    waiting.push_back(std::move(it->second.done));
    it = pending_.erase(it);
  }
  for (const sim::Completion& done : waiting) done({Outcome::kFailed, Json(reason)});
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
  const ServiceDirectory::Target target = directory_.Find(component, service);
  if (target.service == nullptr) return failed(ServiceDirectory::NotRegistered(service));
  if (target.service->start)
    return failed(service + " answers later; only clients can wait for it");
  std::optional<Json> answer;
  directory_.Run(target, arguments, [&](const sim::ServiceResult& result) {
    const Json value = result.text.empty() ? result.value : Json::Parse(result.text);
    answer = Json(Json::Object{{result.outcome == Outcome::kSuccess ? "result" : "failed", value}});
  });
  return answer ? *answer : failed(service + " does not answer");
}

}  // namespace ccmorse::servers
