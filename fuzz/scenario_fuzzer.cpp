// ParseScenario and the simulation of what it accepts. What must hold, whatever the bytes:
// - the result is a scenario or an Error of one line that begins with the file's name;
// - an accepted scenario written by ToJson() is accepted again and written the same;
// - it can be simulated, its robots driving: none ever overlaps a box or another robot, and no pose
//   or sensor reading is NaN.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "base/json.h"
#include "base/polygon.h"
#include "fuzz/check.h"
#include "scene/scenario.h"
#include "sim/simulation.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::scene::Scenario;

// A folder that is not there, so that no {"file": ...} in an input finds anything.
constexpr const char* kFile = "/nonexistent/fuzz.json";
constexpr std::size_t kMostBytes = 64U << 10;
// How deep bodies may overlap by rounding, m; contact is found within 1e-5.
constexpr double kRounding = 1e-9;

// A device or a pipe as the world's file would hang the fuzzer, not the program.
bool ReadsAnotherFile(const std::string& text) {
  try {
    const ccmorse::Json json = ccmorse::Json::Parse(text);
    const ccmorse::Json* world = json.Find("world");
    const ccmorse::Json* file = world != nullptr ? world->Find("file") : nullptr;
    return file != nullptr && file->IsString() && file->AsString().starts_with('/');
  } catch (const ccmorse::JsonError&) {
    return false;
  }
}

void CheckMessage(const std::string& message) {
  Require(message.starts_with(std::string(kFile) + ":"), "an Error begins with the file's name",
          message);
  Require(std::none_of(message.begin(), message.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }),
          "an Error is one line of text", message);
}

void CheckBodies(const ccmorse::sim::Simulation& simulation) {
  const auto& robots = simulation.robots();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const ccmorse::Pose2& pose = robots[i]->pose();
    Require(std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw),
            "a pose is finite");
    const auto& outline = robots[i]->outline().outline;
    for (const auto& box : simulation.world().obstacles()) {
      Require(ccmorse::ConvexGap(outline, box.outline) > -kRounding, "no robot is in a box");
    }
    for (std::size_t k = 0; k < i; ++k) {
      Require(ccmorse::ConvexGap(outline, robots[k]->outline().outline) > -kRounding,
              "no robot is in another one");
    }
  }
}

void Simulate(Scenario scenario) {
  // What costs time and finds nothing: a canvas that nobody draws on.
  scenario.canvas.width = std::min(scenario.canvas.width, 64);
  scenario.canvas.height = std::min(scenario.canvas.height, 64);
  ccmorse::sim::Simulation simulation(std::move(scenario));
  CheckBodies(simulation);
  for (int tick = 0; tick < 3; ++tick) {
    simulation.Sense();
    for (ccmorse::sim::Sensor* sensor : simulation.sampled()) {
      const std::string& data = sensor->LocalData();
      Require(data.find("NaN") == std::string::npos || sensor->type() == "RobotProperties",
              "no reading is NaN", data);
    }
    // Forward and turning, backward, and on the spot: each robot begins differently.
    for (std::size_t i = 0; i < simulation.robots().size(); ++i) {
      constexpr ccmorse::sim::Twist kTwists[] = {{0.5, 2.0}, {-0.5, 0.0}, {0.0, -3.0}};
      simulation.robots()[i]->Command(kTwists[(i + static_cast<std::size_t>(tick)) % 3], nullptr);
    }
    simulation.Act();
    CheckBodies(simulation);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMostBytes) return 0;
  const std::string text(data, data + size);
  if (ReadsAnotherFile(text)) return 0;
  Scenario scenario;
  try {
    scenario = ccmorse::scene::ParseScenario(text, kFile);
  } catch (const ccmorse::Error& error) {
    CheckMessage(error.what());
    return 0;
  }
  const std::string written = ccmorse::scene::ToJson(scenario).Dump();
  try {
    const Scenario again = ccmorse::scene::ParseScenario(written, kFile);
    const std::string twice = ccmorse::scene::ToJson(again).Dump();
    Require(twice == written, "a scenario read back is written the same", written + "\n" + twice);
  } catch (const ccmorse::Error& error) {
    Require(false, "what ToJson() writes is accepted", error.what() + ("\n" + written));
  }
  Simulate(std::move(scenario));
  return 0;
}
