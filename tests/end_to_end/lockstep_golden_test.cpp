// The tenth golden hash (the others are in tests/sim/golden_test.cpp): a client in lock-step.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/json.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

// The course's introduction program, 10 simulated seconds, while 13 robots stand in their docks and
// scan so finely that the work is shared.
constexpr char kGolden[] = "b8d2138ff3ecb6cc";

std::string Scene() {
  std::string robots = R"({"name": "s1r"})";
  for (int i = 0; i < 13; ++i) {
    robots += fmt::format(
        R"(, {{"name": "t{:02}", "pose": {{"x": {}, "y": 3.59, "yaw_deg": -90}}, "laser": {{"samples": 2000}}}})",
        i, 0.15 + 0.26 * i);
  }
  return R"({"world": "syrotek", "robots": [)" + robots + "]}";
}

TEST(GoldenHash, OfALockstepClientHoldsForEveryNumberOfThreadsAndEitherLink) {
  const std::pair<const char*, const char*> runs[] = {
      {"fast", "1"}, {"fast", "2"}, {"fast", "3"}, {"fast", "8"}, {"json", "8"}};
  for (const auto& [link, threads] : runs) {
    const TemporaryFolder folder;
    const std::string scene = folder.path() + "/scene.json";
    std::ofstream(scene) << Scene();
    const std::string report = folder.path() + "/report.json";
    Simulator simulator(
        {scene, "--pace", "lockstep", "--for", "10", "--threads", threads, "--report", report});
    const Finished intro =
        RunToEnd({"/usr/bin/env", std::string("CCMORSE_LINK=") + link, BuiltProgram("intro"),
                  "--port", std::to_string(simulator.port())});
    EXPECT_EQ(intro.status, 0) << intro.output;
    EXPECT_EQ(simulator.process().Wait(), 0);
    EXPECT_EQ(Json::Parse(ReadFile(report)).Find("hash")->AsString(), kGolden)
        << link << ", " << threads << " threads";
  }
}

}  // namespace
}  // namespace ccmorse::testing
