#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::sim {

inline constexpr double kStep = 1.0 / 60.0;  // s

// A robot "robot" of half a metre at `pose` on an empty floor of 40 m around the origin, that goes
// wherever it is told; `more` follows its members, `scene` those of the scenario.
inline std::string Scene(const std::string& components,
                         const std::string& pose = R"({"x": 0, "y": 0})",
                         const std::string& others = "", const std::string& scene = "") {
  const std::string body = R"("type": "Custom", "body": {"footprint":
      [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "hull": [{"outline":
      [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "bottom": 0, "top": 1}],
      "drive": "omni", "max_speed": 100, "max_side_speed": 100, "max_turn_rate": 100,
      "origin_height": 0.1})";
  return R"({"world": {"name": "empty", "size": [40, 40], "low": [-20, -20], "boxes": []},)" +
         scene + R"("robots": [{"name": "robot", "pose": )" + pose + ", " + body +
         R"(, "components": [)" + components + "]}" + others + "]}";
}

// Another robot, without components.
inline std::string Other(const std::string& name, double x, double y,
                         const std::string& more = "") {
  return R"(, {"name": ")" + name + R"(", "pose": {"x": )" + std::to_string(x) + R"(, "y": )" +
         std::to_string(y) + R"(}, "type": "Custom", "body": {"footprint":
      [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "origin_height": 0.1},
      "components": [])" +
         more + "}";
}

class Trial {
 public:
  explicit Trial(const std::string& scene)
      : simulation_(std::make_unique<Simulation>(scene::ParseScenario(scene, "test.json"))) {}

  Component& Get(const std::string& name) { return *simulation_->FindComponent("robot." + name); }
  void Send(const std::string& name, const std::string& message) {
    dynamic_cast<Actuator&>(Get(name)).Take(Json::Parse(message));
  }
  Json Call(const std::string& name, const std::string& service,
            const Json::Array& arguments = {}) {
    for (const Service& one : Get(name).services()) {
      if (one.name == service) return one.run(arguments);
    }
    throw std::runtime_error("no service " + service);
  }
  // An asynchronous one: what it ends with is in the result once it has.
  std::shared_ptr<std::vector<ServiceResult>> Start(const std::string& name,
                                                    const std::string& service,
                                                    const Json::Array& arguments = {}) {
    auto results = std::make_shared<std::vector<ServiceResult>>();
    for (const Service& one : Get(name).services()) {
      if (one.name != service) continue;
      one.start(arguments, [results](ServiceResult result) { results->push_back(result); });
      return results;
    }
    throw std::runtime_error("no service " + service);
  }
  void Ticks(int count) {
    for (int i = 0; i < count; ++i) {
      simulation_->Sense();
      simulation_->Act();
    }
  }
  // What the sensor has seen of now.
  Json Data(const std::string& name) {
    simulation_->Sense();
    return Shown(name);
  }
  Json Shown(const std::string& name) { return Json::Parse(Get(name).LocalData()); }
  double Number(const std::string& name, const std::string& field) {
    return Shown(name).Find(field)->AsDouble();
  }
  const Pose2& pose() { return simulation_->FindRobot("robot")->pose(); }
  Simulation& simulation() { return *simulation_; }

 private:
  std::unique_ptr<Simulation> simulation_;
};

inline void ExpectVector(const Json& data, const char* field, double x, double y, double z,
                         double within = 1e-9) {
  const Json::Array& v = data.Find(field)->AsArray();
  ASSERT_EQ(v.size(), 3U);
  EXPECT_NEAR(v[0].AsDouble(), x, within) << field;
  EXPECT_NEAR(v[1].AsDouble(), y, within) << field;
  EXPECT_NEAR(v[2].AsDouble(), z, within) << field;
}

}  // namespace ccmorse::sim
