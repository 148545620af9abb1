#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace ccmorse::testing {

/// A scenario for tests of range sensors: what it is called, and its JSON.
struct RangeScene {
  const char* name;
  std::string text;
};

/// For GoogleTest.
inline void PrintTo(const RangeScene& scene, std::ostream* out) { *out << scene.name; }

/// Three S1R with sonar rings among the arena's raised pillars.
std::string SonarScene();

/// Three S1R with infra-red rings, one of them with the sensor module in front.
std::string InfraredScene();

/// A hall with boxes and meshes (a ramp, a pyramid, a table) and four robots: a level laser that
/// meets meshes, a tilted one, one of four layers, and one with both rings.
std::string MeshScene();

/// The arena with all its dynamic obstacles up and two robots.
std::string ObstaclesUpScene();

/// All of them.
std::vector<RangeScene> RangeScenesForTests();

}  // namespace ccmorse::testing
