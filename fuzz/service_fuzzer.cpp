// ServiceDirectory on a small simulation with two robots. Each line of the input does one thing:
// - "component service parameters" calls a service;
// - "cancel" ends whatever runs;
// - "> component message" sends an actuator a message of its stream;
// - an empty line is a tick.
// What must hold: no call throws; each is answered at most once, in a form that makes one line of
// JSON without NaN; a stream's message is taken or turned down by the errors that the server
// expects; robots' poses stay finite, and within a kilometre no robot drives into anything.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "base/polygon.h"
#include "fuzz/check.h"
#include "scene/scenario.h"
#include "servers/morse/service_directory.h"
#include "sim/simulation.h"
#include "wire/morse_line.h"

namespace {

using ccmorse::Json;
using ccmorse::fuzz::Require;
using ccmorse::servers::RunControl;
using ccmorse::servers::ServiceDirectory;
using ccmorse::sim::Simulation;

// Limits on what one input may cost; they keep the fuzzer quick and hide no branch.
constexpr int kMostLines = 100;
constexpr int kMostListedCells = 1000;

// Few beams and cells, so that a simulation is made and ticked thousands of times a second.
const ccmorse::scene::Scenario& SmallScenario() {
  static const ccmorse::scene::Scenario scenario = ccmorse::scene::ParseScenario(
      R"({"world": {"name": "hall", "size": [4, 3], "boxes": [
           {"id": 1, "kind": "wall", "x": 2, "y": 0.05, "size": [4, 0.1], "height": 0.3,
            "color": "red"},
           {"id": 2, "kind": "gate", "x": 3, "y": 2, "yaw_deg": 30, "size": [0.5, 0.1],
            "height": 0.3, "color": "blue", "dynamic": true}]},
          "obstacles": {"up": [2]},
          "robots": [{"name": "a", "pose": {"x": 1, "y": 1}, "laser": {"samples": 9}},
                     {"name": "b", "pose": {"x": 1.4, "y": 1, "yaw_deg": 180},
                      "laser": {"samples": 9}}],
          "canvas": {"width": 8, "height": 6}, "time": {"frequency": 20}})",
      "small.json");
  return scenario;
}

RunControl Control() {
  RunControl control;
  control.stream_port = [](const ccmorse::sim::Component& component) {
    return ServiceDirectory::HasStream(component) ? 60000 : 0;
  };
  control.quit = [] {};
  control.time_mode = [] { return std::string("Best Effort"); };
  control.time_statistics = [] { return Json(Json::Object{{"mean_time", 0.05}}); };
  control.set_time_scale = [](double factor) { return factor < 10.0; };
  return control;
}

void CheckResult(const ccmorse::sim::ServiceResult& result) {
  const std::string json = result.text.empty() ? result.value.Dump() : std::string(result.text);
  Require(json.find('\n') == std::string::npos, "an answer is one line", json);
  const Json value = Json::Parse(json);
  Require(json.find("NaN") == std::string::npos || value.IsString(), "no answer is NaN", json);
  if (result.outcome == ccmorse::sim::Outcome::kFailed) {
    Require(value.IsString() && !value.IsFalsy(), "a failure says why", json);
  }
}

void CheckBodies(const Simulation& simulation) {
  constexpr double kFar = 1000.0;  // m; beyond, coordinates are too coarse to tell contact
  constexpr double kRounding = 1e-9;
  const auto& robots = simulation.robots();
  const auto near = [](const ccmorse::Pose2& pose) {
    return std::fabs(pose.x) < kFar && std::fabs(pose.y) < kFar;
  };
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const ccmorse::Pose2& pose = robots[i]->pose();
    Require(std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw),
            "a pose is finite");
    if (!near(pose)) continue;
    const auto& outline = robots[i]->outline().outline;
    for (const auto& box : simulation.world().obstacles()) {
      Require(ccmorse::ConvexGap(outline, box.outline) > -kRounding, "no robot is in a box");
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (!near(robots[k]->pose())) continue;
      Require(ccmorse::ConvexGap(outline, robots[k]->outline().outline) > -kRounding,
              "no robot is in another one");
    }
  }
}

// A simulation, its services and the count of answers to each call.
class Session {
 public:
  Session() : simulation_(SmallScenario()), directory_(simulation_, Control()) {
    // A folder that is not there: save_image_copy runs, but leaves no files behind.
    simulation_.canvas().set_picture_folder("/nonexistent");
  }

  void Do(std::string_view line) {
    if (line.empty()) return Tick();
    std::string text = "0 ";  // an id, as the parser wants one
    text += line;
    const ccmorse::wire::MorseRequest parsed = ccmorse::wire::ParseMorseRequest(text);
    if (parsed.kind == ccmorse::wire::MorseRequest::Kind::kCancel) {
      for (ccmorse::sim::Component* component : simulation_.components()) component->Interrupt();
    } else if (parsed.kind == ccmorse::wire::MorseRequest::Kind::kCall) {
      if (parsed.component == ">") {
        Send(parsed.service, parsed.parameters);
      } else {
        Call(parsed);
      }
    }
    CheckBodies(simulation_);
  }

  void Tick() {
    simulation_.Sense();
    simulation_.Act();
    directory_.TimeAdvanced();
    CheckBodies(simulation_);
  }

 private:
  void Call(const ccmorse::wire::MorseRequest& request) {
    const auto& canvas = simulation_.canvas();
    if (request.service == "get_image_data" &&
        canvas.width() * canvas.height() > kMostListedCells) {
      return;
    }
    const auto answers = std::make_shared<int>(0);
    directory_.Call(request.component, request.service, request.parameters,
                    [answers](const ccmorse::sim::ServiceResult& result) {
                      Require(++*answers == 1, "a call is answered once");
                      CheckResult(result);
                    });
  }

  void Send(std::string_view name, std::string_view message) {
    auto* actuator = dynamic_cast<ccmorse::sim::Actuator*>(simulation_.FindComponent(name));
    if (actuator == nullptr) return;
    try {
      actuator->Receive(Json::Parse(message));
    } catch (const ccmorse::JsonError&) {
      // Turned down: no JSON.
    } catch (const ccmorse::sim::WrongArgument&) {
      // Turned down: not what the actuator needs.
    }
  }

  Simulation simulation_;
  ServiceDirectory directory_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(data, data + size);
  Session session;
  std::string_view rest = input;
  for (int line = 0; line < kMostLines && !rest.empty(); ++line) {
    const std::size_t end = rest.find('\n');
    session.Do(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  session.Tick();
  return 0;
}
