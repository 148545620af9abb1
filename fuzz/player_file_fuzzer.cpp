// ParsePlayerConfig and ParseStageWorld, and the simulation of what they accept. An input whose
// first line begins with "#cfg" is a .cfg, any other a .world. What must hold, whatever the bytes:
// - the result is a scenario or an Error of one line that begins with the file's name;
// - an accepted world written by ToJson() is a scenario that ParseScenario accepts, written the
// same;
// - it can be simulated.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "base/error.h"
#include "fuzz/check.h"
#include "scene/player/import.h"
#include "sim/simulation.h"

namespace {

using ccmorse::fuzz::Require;
using ccmorse::scene::Scenario;

constexpr std::size_t kMostBytes = 16U << 10;
constexpr std::size_t kMostRobots = 20;  // that are simulated: more cost time and find nothing

// No file of the machine is read: these are all there are.
std::string Read(const std::string& path) {
  if (path == "dir/a.inc") return "define box model ( size [ 1 1 1 ] )\n";
  if (path == "dir/loop.inc") return "include \"loop.inc\"\n";
  if (path == "dir/a.world") {
    return "model ( )\n"
           "position ( name \"r0\" pose [ 2 0 0 0 ] ranger ( sensor ( samples 9 ) ) )\n";
  }
  throw ccmorse::Error("cannot read " + path);
}

ccmorse::Image Bitmap(const std::string& path) {
  if (path != "dir/a.png") throw ccmorse::Error("cannot read " + path);
  constexpr ccmorse::Color kDark{0, 0, 0};
  constexpr ccmorse::Color kLight{255, 255, 255};
  return {3, 2, {kDark, kLight, kDark, kDark, kDark, kLight}};
}

void CheckMessage(const std::string& message) {
  Require(message.starts_with("dir/"), "an Error begins with the file's name", message);
  Require(std::none_of(message.begin(), message.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }),
          "an Error is one line of text", message);
}

void CheckScenario(Scenario scenario) {
  const std::string written = ccmorse::scene::ToJson(scenario).Dump();
  try {
    const Scenario again = ccmorse::scene::ParseScenario(written, "fuzz.json");
    Require(ccmorse::scene::ToJson(again).Dump() == written, "a world read back is the same",
            written);
  } catch (const ccmorse::Error& error) {
    Require(false, "what ToJson() writes is accepted", error.what() + ("\n" + written));
  }
  if (scenario.robots.size() > kMostRobots) return;
  scenario.canvas.width = std::min(scenario.canvas.width, 64);
  scenario.canvas.height = std::min(scenario.canvas.height, 64);
  ccmorse::sim::Simulation simulation(std::move(scenario), 1);
  for (int tick = 0; tick < 2; ++tick) {
    simulation.Sense();
    for (const auto& robot : simulation.robots()) robot->Command({0.5, 1.0, 0.5}, nullptr);
    simulation.Act();
    for (const auto& robot : simulation.robots()) {
      const ccmorse::Pose2& pose = robot->pose();
      Require(std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw),
              "a pose is finite");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > kMostBytes) return 0;
  const std::string text(data, data + size);
  const ccmorse::scene::StageFiles files{Read, Bitmap};
  Scenario scenario;
  try {
    if (text.starts_with("#cfg")) {
      scenario = ccmorse::scene::ImportConfig(
                     ccmorse::scene::ParsePlayerConfig(text, "dir/fuzz.cfg", Read), files)
                     .scenario;
    } else {
      scenario = ccmorse::scene::ParseStageWorld(text, "dir/fuzz.world", files).scenario;
    }
  } catch (const ccmorse::Error& error) {
    CheckMessage(error.what());
    return 0;
  }
  CheckScenario(std::move(scenario));
  return 0;
}
