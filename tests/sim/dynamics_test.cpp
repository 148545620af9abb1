// Dynamic robots against the formulas of mechanics, with MORSE's constants (specs: morse.md B.3,
// H.1, H.2).

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "base/error.h"
#include "base/euler.h"
#include "base/json.h"
#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

constexpr double kGravity = 9.81;  // m/s^2
constexpr double kTick = 1.0 / 60.0;

// A dynamic box "robot" of 1 m x 0.6 m.
struct Box {
  std::string dynamics;  // members of it
  std::string components;
  double height = 0.5;  // m, of its origin
  double mass = 20.0;   // kg
  std::string name = "robot";
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
};

std::string RobotText(const Box& box) {
  const auto number = [](double value) { return Json(value).Dump(); };
  return R"({"name": ")" + box.name + R"(", "pose": {"x": )" + number(box.x) + R"(, "y": )" +
         number(box.y) + R"(, "yaw": )" + number(box.yaw) + R"(}, "type": "Custom", "body": {
      "footprint": [[0.5, -0.3], [0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3]],
      "hull": [{"outline": [[0.5, -0.3], [0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3]],
                "bottom": 0, "top": 0.5}],
      "drive": "omni", "max_speed": 100, "max_side_speed": 100, "max_turn_rate": 100, "mass": )" +
         number(box.mass) + R"(, "origin_height": )" + number(box.height) + R"(, "dynamics": {)" +
         box.dynamics + R"(}}, "components": [)" + box.components + "]}";
}

std::string Scene(const std::string& robots, const std::string& world = R"("boxes": [])",
                  const std::string& scene = "") {
  return R"({"world": {"name": "w", "size": [80, 80], "low": [-40, -40], )" + world + "}," + scene +
         R"("robots": [)" + robots + "]}";
}

class Trial {
 public:
  explicit Trial(const std::string& scene)
      : simulation_(std::make_unique<Simulation>(scene::ParseScenario(scene, "test.json"))) {}

  Component& Get(const std::string& name) {
    Component* const found = simulation_->FindComponent(name);
    if (found == nullptr) throw std::runtime_error("no component " + name);
    return *found;
  }
  void Send(const std::string& name, const std::string& message) {
    dynamic_cast<Actuator&>(Get("robot." + name)).Receive(Json::Parse(message));
  }
  const Service& Find(const std::string& name, const std::string& service) {
    for (const Service& one : Get("robot." + name).services()) {
      if (one.name == service) return one;
    }
    throw std::runtime_error("no service " + service);
  }
  void Seconds(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kTick)); ++i) {
      simulation_->Sense();
      simulation_->Act();
    }
  }
  Json Data(const std::string& name) {
    simulation_->Sense();
    return Json::Parse(Get("robot." + name).LocalData());
  }
  const Robot& robot(const std::string& name = "robot") { return *simulation_->FindRobot(name); }
  Simulation& simulation() { return *simulation_; }

 private:
  std::unique_ptr<Simulation> simulation_;
};

// What remains of a speed after `seconds` without any force.
double Damped(double speed, double lost, double seconds) {
  return speed * std::pow(1.0 - lost, seconds);
}

constexpr const char* kNoDamping =
    R"("bottom": -0.5, "top": 0.5, "linear_damping": 0, "angular_damping": 0)";

TEST(DynamicsTest, FreeFallIsHalfGTSquared) {
  Trial trial(Scene(RobotText({kNoDamping, "", 100.0})));
  trial.Seconds(2.0);
  // Steps of h have moved n (n + 1) h^2 / 2 where the formula has (n h)^2 / 2.
  const double h = kTick / 2.0;
  EXPECT_NEAR(trial.robot().position().z, 100.0 - 0.5 * kGravity * 2.0 * (2.0 + h), 1e-9);
  EXPECT_NEAR(trial.robot().position().z, 100.0 - 0.5 * kGravity * 4.0, 0.1);
  EXPECT_NEAR(trial.robot().velocity().z, -2.0 * kGravity, 1e-9);
}

TEST(DynamicsTest, ItComesToRestOnTheGround) {
  Trial trial(Scene(RobotText({kNoDamping, "", 1.5})));
  trial.Seconds(3.0);
  EXPECT_NEAR(trial.robot().position().z, 0.5, 2e-3);
  EXPECT_NEAR(trial.robot().velocity().z, 0.0, 1e-3);
  EXPECT_NEAR(trial.robot().euler().x, 0.0, 1e-3);
  EXPECT_NEAR(trial.robot().euler().y, 0.0, 1e-3);
}

TEST(DynamicsTest, FallingFastItDoesNotGetThroughTheGround) {
  Trial trial(Scene(RobotText({kNoDamping, "", 900.0})));
  trial.Seconds(30.0);
  EXPECT_NEAR(trial.robot().position().z, 0.5, 5e-3);
}

TEST(DynamicsTest, TerminalVelocityWithDamping) {
  // v' = g + v ln(1 - d) has its end at g / -ln(1 - d).
  Trial trial(
      Scene(RobotText({R"("bottom": -0.5, "top": 0.5, "linear_damping": 0.9)", "", 900.0})));
  trial.Seconds(8.0);
  const double terminal = kGravity / -std::log(1.0 - 0.9);
  EXPECT_NEAR(trial.robot().velocity().z, -terminal, 0.01 * terminal);
}

TEST(DynamicsTest, TerminalVelocityWithDrag) {
  // c v^2 = m g.
  Trial trial(Scene(
      RobotText({kNoDamping, R"({"name": "drag", "type": "Drag", "properties": {"DragCoeffZ": 2}})",
                 900.0})));
  trial.Seconds(15.0);
  const double terminal = std::sqrt(20.0 * kGravity / 2.0);
  EXPECT_NEAR(trial.robot().velocity().z, -terminal, 0.01 * terminal);
}

TEST(DynamicsTest, FrictionStopsItWithinVSquaredOverTwoMuG) {
  // Friction is the product of both: 0.5 * 0.5.
  const std::string motion = R"({"name": "motion", "type": "MotionVW"})";
  Trial trial(Scene(RobotText({std::string(kNoDamping) + R"(, "ground": true)", motion})));
  trial.Seconds(0.5);
  trial.Send("motion", R"({"v": 3, "w": 0})");
  trial.Seconds(kTick);
  trial.simulation().FindRobot("robot")->Command({}, nullptr);  // nobody drives any more
  const double from = trial.robot().position().x;
  const double speed = trial.robot().velocity().x;
  trial.Seconds(3.0);
  EXPECT_NEAR(trial.robot().velocity().x, 0.0, 1e-3);
  const double expected = speed * speed / (2.0 * 0.25 * kGravity);
  EXPECT_NEAR(trial.robot().position().x - from, expected, 0.03 * expected);
}

TEST(DynamicsTest, H2_SpeedsOfMorsyAreThoseThatMorsesTestsExpect) {
  // Within a tick two steps of v = v (1 - d)^(1/120) - mu g / 120; d = 0.493: 0.948 and 1.937 m/s.
  const std::string components =
      R"({"name": "motion", "type": "MotionVW"}, {"name": "air", "type": "Airspeed"})";
  Trial trial(Scene(RobotText({R"("bottom": 0, "top": 1.68, "ground": true, "linear_damping": 0.493,
                              "angular_damping": 0.658)",
                               components, 0.0, 15.0})));
  for (const double v : {1.0, 2.0}) {
    trial.Send("motion", R"({"v": )" + std::to_string(v) + R"(, "w": 0})");
    trial.Seconds(1.0);
    double speed = v;
    for (int i = 0; i < 2; ++i) speed = Damped(speed, 0.493, 1.0 / 120.0) - 0.25 * kGravity / 120.0;
    EXPECT_NEAR(trial.robot().velocity().x, speed, 0.004) << v;
    EXPECT_NEAR(trial.Data("air").Find("diff_pressure")->AsDouble(), v == 1.0 ? 0.55 : 2.30, 0.01);
  }
}

TEST(DynamicsTest, H2_WithAFrictionOfFiveAnAtrvGetsOnly1_4m) {
  const std::string motion = R"({"name": "motion", "type": "MotionVW"})";
  Trial trial(Scene(RobotText({R"("bottom": -0.1, "top": 0.737, "ground": true, "friction": 5,
                              "linear_damping": 0.0254, "angular_damping": 0.18)",
                               motion, 0.1})));
  trial.Seconds(0.5);
  const double from = trial.robot().position().x;
  trial.Send("motion", R"({"v": 1, "w": 0})");
  trial.Seconds(2.0);
  EXPECT_NEAR(trial.robot().position().x - from, 1.4, 0.1);
}

TEST(ForceTorqueTest, AForceAcceleratesAndItsLeverTurns) {
  // 1 m to the left of the origin, on a robot without weight: 10 N forwards.
  const std::string components =
      R"({"name": "push", "type": "ForceTorque", "position": [0, 1, 0]})";
  Trial trial(
      Scene(RobotText({std::string(kNoDamping) + R"(, "gravity": false)", components, 5.0, 1.0}),
            R"("boxes": [])"));
  trial.Send("push", R"({"force": [0.1, 0, 0], "torque": [0, 0, 0]})");
  trial.Seconds(1.0);
  // Iz = m (a^2 + b^2) / 12 of the box of 1 m x 0.6 m.
  const double inertia = 1.0 * (1.0 + 0.36) / 12.0;
  EXPECT_NEAR(trial.robot().spin().z, -0.1 / inertia, 1e-6);
  EXPECT_NEAR(trial.robot().position().z, 5.0, 1e-9);
}

TEST(ForceTorqueTest, InTheRobotsFrameThereIsNoLever) {
  const std::string components =
      R"({"name": "push", "type": "ForceTorque", "position": [0, 1, 0], "rotation": [0, 0, 1],
          "properties": {"RobotFrame": true}})";
  Box box{std::string(kNoDamping) + R"(, "gravity": false)", components, 5.0, 1.0};
  box.yaw = kPi / 2.0;
  Trial trial(Scene(RobotText(box)));
  trial.Send("push", R"({"force": [2, 0, 0], "torque": [0, 0, 0]})");
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().velocity().x, 0.0, 1e-9);
  EXPECT_NEAR(trial.robot().velocity().y, 2.0, 1e-9);
  EXPECT_NEAR(trial.robot().spin().z, 0.0, 1e-12);
}

TEST(ForceTorqueTest, AHundredNewtonsOnAnAtrvGive4_8) {
  const std::string components = R"({"name": "push", "type": "ForceTorque"},
                                    {"name": "felt", "type": "Accelerometer"})";
  // Upwards, as friction would count otherwise.
  Trial trial(Scene(RobotText({R"("bottom": -0.5, "top": 0.5, "gravity": true,
                              "linear_damping": 0.0254)",
                               components, 50.0})));
  trial.Send("push", R"({"force": [100, 0, 196.2], "torque": [0, 0, 0]})");
  trial.Seconds(1.0);
  const Json data = trial.Data("felt");
  const Json::Array& felt = data.Find("acceleration")->AsArray();
  EXPECT_NEAR(felt[0].AsDouble(), 4.80, 0.2);
  EXPECT_NEAR(felt[2].AsDouble(), 0.0, 1e-6);
}

TEST(ForceTorqueTest, WhatIsNoForceIsRefusedAndChangesNothing) {
  Trial trial(Scene(RobotText({kNoDamping, R"({"name": "push", "type": "ForceTorque"})"})));
  for (const char* message :
       {R"({})", R"({"force": [1, 2], "torque": [0, 0, 0]})", R"({"force": 1, "torque": 2})",
        R"({"force": [1e300, 0, 0], "torque": [0, 0, 0]})",
        R"({"force": ["x", 0, 0], "torque": [0, 0, 0]})", R"({"force": [1, 0, 0]})"}) {
    EXPECT_THROW(trial.Send("push", message), WrongArgument) << message;
  }
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().position().x, 0.0, 1e-4);
}

TEST(ForceTorqueTest, TheLargestForceLeavesNumbersThatAreNumbers) {
  Trial trial(Scene(RobotText({kNoDamping, R"({"name": "push", "type": "ForceTorque"})"})));
  trial.Send("push", R"({"force": [1e9, 0, 1e9], "torque": [1e9, 1e9, 1e9]})");
  trial.Seconds(20.0);
  const Vec3 at = trial.robot().position();
  EXPECT_TRUE(std::isfinite(at.x + at.y + at.z));
  EXPECT_TRUE(std::isfinite(trial.robot().spin().x));
}

TEST(ForceTorqueTest, WhilePhysicsAreOffNothingAddsUp) {
  Trial trial(Scene(RobotText({std::string(kNoDamping) + R"(, "gravity": false)",
                               R"({"name": "push", "type": "ForceTorque"})", 5.0, 1.0})));
  trial.Send("push", R"({"force": [1, 0, 0], "torque": [0, 0, 0]})");
  trial.simulation().set_physics(false);
  trial.Seconds(10.0);
  EXPECT_EQ(trial.robot().position().x, 0.0);
  trial.simulation().set_physics(true);
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().velocity().x, 1.0, 1e-9);
}

TEST(TeleportTest, PutsADynamicRobotAnywhereSoThatItsMountIsThere) {
  Trial trial(Scene(RobotText({kNoDamping,
                               R"({"name": "there", "type": "Teleport", "position": [0, 0, 1],
                                   "rotation": [0, 0, 0.5]}, {"name": "pose", "type": "Pose",
                                   "position": [0, 0, 1], "rotation": [0, 0, 0.5]})"})));
  trial.Send("there", R"({"x": 3, "y": -2, "z": 9, "roll": 0.1, "pitch": 0.2, "yaw": 0.3})");
  trial.Seconds(kTick);
  const Json pose = trial.Data("pose");
  EXPECT_NEAR(pose.Find("x")->AsDouble(), 3.0, 1e-3);
  EXPECT_NEAR(pose.Find("y")->AsDouble(), -2.0, 1e-3);
  EXPECT_NEAR(pose.Find("z")->AsDouble(), 9.0, 5e-3);  // it has fallen for a tick
  EXPECT_NEAR(pose.Find("roll")->AsDouble(), 0.1, 1e-9);
  EXPECT_NEAR(pose.Find("pitch")->AsDouble(), 0.2, 1e-9);
  EXPECT_NEAR(pose.Find("yaw")->AsDouble(), 0.3, 1e-9);
}

TEST(OrientationTest, TurnsADynamicRobotInSpace) {
  Trial trial(Scene(RobotText({std::string(kNoDamping) + R"(, "gravity": false)",
                               R"({"name": "turn", "type": "Orientation"})", 9.0, 1.0})));
  trial.Send("turn", R"({"roll": 0.1, "pitch": -0.2, "yaw": 3})");
  trial.Seconds(0.5);
  EXPECT_NEAR(trial.robot().euler().x, 0.1, 1e-9);
  EXPECT_NEAR(trial.robot().euler().y, -0.2, 1e-9);
  EXPECT_NEAR(trial.robot().euler().z, 3.0, 1e-9);
}

TEST(ForceTorqueTest, AKinematicRobotIsRefusedWithWhatToAdd) {
  std::string scene = Scene(RobotText({"", R"({"name": "push", "type": "ForceTorque"})"}));
  const std::size_t at = scene.find(R"(, "dynamics": {})");
  ASSERT_NE(at, std::string::npos);
  scene.erase(at, std::string(R"(, "dynamics": {})").size());
  try {
    Trial trial(scene);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("add 'dynamics' to its 'body'"), std::string::npos);
  }
}

TEST(ExternalForceTest, WindBlowsInTheWorldsFrame) {
  Box box{std::string(kNoDamping) + R"(, "gravity": false)",
          R"({"name": "wind", "type": "ExternalForce"})", 5.0, 1.0};
  box.yaw = kPi / 2.0;
  Trial trial(Scene(RobotText(box)));
  trial.Send("wind", R"({"force": [3, 0, 0], "torque": [0, 0, 0]})");
  trial.Seconds(2.0);
  EXPECT_NEAR(trial.robot().velocity().x, 6.0, 1e-9);
  EXPECT_NEAR(trial.robot().velocity().y, 0.0, 1e-9);
}

TEST(SubmarineTest, OfOneKilogramItHoversAndOfTwoItSinks) {
  for (const double mass : {1.0, 2.0}) {
    // MORSE takes the bare acceleration for a force, which is the weight of 1 kg.
    Trial trial(
        Scene(RobotText({std::string(kNoDamping) + R"(, "gravity": false)", "", 50.0, mass})));
    trial.Seconds(1.0);
    EXPECT_NEAR(trial.robot().velocity().z, mass == 1.0 ? 0.0 : -kGravity / 2.0, 1e-9);
  }
}

// A slab with a slope of `angle` that rises towards +x, from its lower edge at the origin.
std::string Slope(double angle) {
  const auto number = [](double value) { return Json(value).Dump(); };
  const double run = 20.0 * std::cos(angle);
  const double rise = 20.0 * std::sin(angle);
  return R"("boxes": [], "meshes": [{"id": 1, "vertices": [[0, -20, 0], [)" + number(run) +
         ", -20, " + number(rise) + "], [" + number(run) + ", 20, " + number(rise) +
         R"(], [0, 20, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]}])";
}

// The robot 5 m up a slope, along it.
std::string OnSlope(double angle, const std::string& more) {
  const double height = 5.0 * std::sin(angle) + 0.505 * std::cos(angle);
  Box box{std::string(kNoDamping) + R"(, "pitch": )" + Json(-angle).Dump() + more, "", height};
  box.x = 5.0 * std::cos(angle) - 0.505 * std::sin(angle);
  return RobotText(box);
}

TEST(DynamicsTest, ABoxOnASlopeSlidesWhereItIsSteeperThanItsFriction) {
  const double angle = Radians(30.0);  // mu = 0.25 < tan 30 = 0.577
  Trial trial(Scene(OnSlope(angle, ""), Slope(angle)));
  trial.Seconds(0.5);
  const Vec3 before = trial.robot().velocity();
  trial.Seconds(0.5);
  const Vec3 change = (1.0 / 0.5) * (trial.robot().velocity() - before);
  const double expected = kGravity * (std::sin(angle) - 0.25 * std::cos(angle));
  EXPECT_NEAR(-(change.x * std::cos(angle) + change.z * std::sin(angle)), expected,
              0.05 * expected);
}

TEST(DynamicsTest, ABoxOnASlopeStaysWhereItIsLessSteep) {
  const double angle = Radians(10.0);  // tan 10 = 0.176 < 0.25
  Trial trial(Scene(OnSlope(angle, ""), Slope(angle)));
  trial.Seconds(0.5);
  const double from = trial.robot().position().x;
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().position().x, from, 5e-3);
}

TEST(DynamicsTest, ABoxInTheWayStopsItAndIsNamedByCollision) {
  const std::string components = R"({"name": "motion", "type": "MotionVW"},
                                    {"name": "touch", "type": "Collision"})";
  Trial trial(Scene(RobotText({std::string(kNoDamping) + R"(, "ground": true)", components}),
                    R"("boxes": [{"id": 1, "kind": "static", "x": 3, "y": 0, "size": [1, 4],
                                 "height": 2, "color": "red"}])"));
  trial.Send("motion", R"({"v": 1, "w": 0})");
  trial.Seconds(1.0);
  EXPECT_FALSE(trial.Data("touch").Find("collision")->AsBool());
  trial.Seconds(3.0);
  EXPECT_NEAR(trial.robot().position().x, 2.0, 0.05);
  EXPECT_TRUE(trial.Data("touch").Find("collision")->AsBool());
  EXPECT_EQ(trial.Data("touch").Find("objects")->AsString(), "static_1");
}

TEST(DynamicsTest, ADynamicRobotPushesAnother) {
  const std::string motion = R"({"name": "motion", "type": "MotionVW"})";
  Box other{kNoDamping, "", 0.5, 5.0, "other", 1.5};
  Trial trial(Scene(RobotText({std::string(kNoDamping) + R"(, "ground": true)", motion}) + "," +
                    RobotText(other)));
  trial.Send("motion", R"({"v": 1, "w": 0})");
  trial.Seconds(3.0);
  EXPECT_GT(trial.robot("other").position().x, 2.5);
  EXPECT_GT(trial.robot("other").position().x - trial.robot().position().x, 0.98);
}

// A robot with everything that a run's hash covers, told things on its way.
std::uint64_t HashOfARun(int threads, const std::string& robots) {
  Simulation simulation(
      scene::ParseScenario(Scene(robots, R"("boxes": [{"id": 1, "kind": "static", "x": 2.5,
                                          "y": 0.3, "yaw": 0.4, "size": [1, 1], "height": 2, "color": "red"}])"),
                           "test.json"),
      threads, true);
  for (int tick = 0; tick < 600; ++tick) {
    if (tick == 30) {
      dynamic_cast<Actuator&>(*simulation.FindComponent("robot.motion"))
          .Receive(Json::Parse(R"({"v": 2, "w": 0.1})"));
      dynamic_cast<Actuator&>(*simulation.FindComponent("other.push"))
          .Receive(Json::Parse(R"({"force": [-40, 3, 150], "torque": [0.3, 0.2, 1]})"));
    }
    simulation.Sense();
    simulation.Act();
  }
  return simulation.Hash();
}

TEST(DynamicsTest, TheSameRunHasTheSameHashWhateverTheThreadsAndTheOrder) {
  const std::string one =
      RobotText({R"("bottom": -0.5, "top": 0.5, "ground": true)",
                 R"({"name": "motion", "type": "MotionVW"}, {"name": "pose", "type": "Pose"},
                {"name": "laser", "type": "LaserScanner"})",
                 0.7});
  Box second{R"("bottom": -0.5, "top": 0.5)",
             R"({"name": "push", "type": "ForceTorque"})",
             2.5,
             10.0,
             "other",
             1.2,
             0.2,
             0.5};
  const std::string two = RobotText(second);
  const std::uint64_t hash = HashOfARun(1, one + "," + two);
  EXPECT_EQ(HashOfARun(1, one + "," + two), hash);
  EXPECT_EQ(HashOfARun(3, two + "," + one), hash);
}

TEST(DynamicsTest, AfterAResetItRunsAsAtFirst) {
  Trial trial(Scene(RobotText({R"("bottom": -0.5, "top": 0.5, "roll": 0.3)", "", 3.0})));
  trial.Seconds(2.0);
  const RigidState first = trial.robot().body();
  trial.simulation().ResetObjects();
  EXPECT_EQ(trial.robot().position().z, 3.0);
  EXPECT_NEAR(trial.robot().euler().x, 0.3, 1e-12);
  trial.Seconds(2.0);
  EXPECT_EQ(trial.robot().body().position.x, first.position.x);
  EXPECT_EQ(trial.robot().body().position.z, first.position.z);
  EXPECT_EQ(trial.robot().body().rotation.x.y, first.rotation.x.y);
}

TEST(DynamicsTest, TheScenarioKeepsItsDynamics) {
  const std::string scene = Scene(
      RobotText(
          {R"("bottom": -0.1, "top": 0.4, "friction": 2, "gravity": false, "turning_track": 0.5,
                "wheels": [{"position": [0, 0.2, 0], "radius": 0.1, "drive": "left"},
                           {"position": [0, -0.2, 0], "radius": 0.1, "drive": "ball"}])",
           ""}),
      R"("boxes": [])", R"("physics": {"gravity": 1.62, "substeps": 4, "friction": 0.7},)");
  const Json once = scene::ToJson(scene::ParseScenario(scene, "test.json"));
  const Json twice = scene::ToJson(scene::ParseScenario(once.Dump(), "test.json"));
  EXPECT_EQ(once.Dump(), twice.Dump());
  const scene::Scenario read = scene::ParseScenario(once.Dump(), "test.json");
  EXPECT_EQ(read.physics->gravity, 1.62);
  EXPECT_EQ(read.robots[0].body->dynamics->wheels.size(), 2U);
  EXPECT_EQ(read.robots[0].body->dynamics->wheels[1].drive, "ball");
}

TEST(DynamicsTest, OnTheMoonThingsFallMoreSlowly) {
  Trial trial(Scene(RobotText({kNoDamping, "", 50.0}), R"("boxes": [])",
                    R"("physics": {"gravity": 1.62},)"));
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().velocity().z, -1.62, 1e-9);
}

// Wheels

// A Pioneer as MORSE has it.
std::string Pioneer(const std::string& components) {
  return R"({"name": "robot", "pose": {"x": 0, "y": 0, "yaw": 0}, "type": "Custom", "body": {
      "footprint": [[0.228, -0.1835], [0.228, 0.1835], [-0.228, 0.1835], [-0.228, -0.1835]],
      "mass": 9, "max_speed": 100, "max_turn_rate": 100, "origin_height": 0.1,
      "dynamics": {"bottom": -0.06, "top": 0.0905, "ground": true, "turning_track": 0.52,
        "wheels": [
        {"position": [0.045, 0.1706, 0], "radius": 0.0975, "width": 0.053, "drive": "left"},
        {"position": [0.045, -0.1706, 0], "radius": 0.0975, "width": 0.053, "drive": "right"},
        {"position": [-0.17, 0, -0.057], "radius": 0.0385, "drive": "ball"}]}},
      "components": [)" +
         components + "]}";
}

const std::string kWheels = R"({"name": "wheels", "type": "MotionVWDiff"})";

TEST(WheelsTest, APioneerDrivesStraightAsFastAsItsWheelsTurn) {
  Trial trial(Scene(Pioneer(kWheels)));
  trial.Seconds(0.5);
  trial.Send("wheels", R"({"v": 0.5, "w": 0})");
  trial.Seconds(2.0);
  const double from = trial.robot().position().x;
  trial.Seconds(2.0);
  EXPECT_NEAR(trial.robot().position().x - from, 1.0, 0.03);
  EXPECT_NEAR(trial.robot().position().y, 0.0, 0.02);
  EXPECT_NEAR(trial.robot().velocity().x, 0.5, 0.02);
  EXPECT_NEAR(trial.robot().position().z, 0.0975, 5e-3);
}

TEST(WheelsTest, APioneerTurnsByItsWheelsAndTheirTrueTrack) {
  Trial trial(Scene(Pioneer(kWheels)));
  trial.Seconds(0.5);
  trial.Send("wheels", R"({"v": 0, "w": 0.5})");
  trial.Seconds(1.0);
  // Its wheels are 0.3412 m apart, but MotionVWDiff takes 0.52 m for the track.
  const double rate = 0.5 * 0.52 / (2.0 * 0.1706);
  EXPECT_NEAR(trial.robot().spin().z, rate, 0.08 * rate);
}

TEST(WheelsTest, BelowAThousandthItBrakes) {
  Trial trial(Scene(Pioneer(kWheels)));
  trial.Seconds(0.5);
  trial.Send("wheels", R"({"v": 0.5, "w": 0})");
  trial.Seconds(1.0);
  trial.Send("wheels", R"({"v": 0.0005, "w": 0})");
  trial.Seconds(1.0);
  const double from = trial.robot().position().x;
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().position().x, from, 5e-3);
}

// MORSE's Hummer, as a car.
std::string Hummer() {
  return R"({"name": "robot", "pose": {"x": 0, "y": 0, "yaw": 0}, "type": "Custom", "body": {
      "footprint": [[2.75, -1.33], [2.75, 1.33], [-2.75, 1.33], [-2.75, -1.33]], "mass": 10,
      "max_speed": 100, "max_turn_rate": 100, "origin_height": 1.2,
      "dynamics": {"bottom": -0.95, "top": 0.95, "ground": true, "linear_damping": 0.4,
        "angular_damping": 0, "vehicle": {"front": 1.6, "rear": -2.3, "half_track": 1.3,
        "height": -0.5, "wheel_radius": 0.5}}},
      "components": [{"name": "car", "type": "SteerForce"}]})";
}

TEST(SteerForceTest, AHummerStandsOnItsSprings) {
  Trial trial(Scene(Hummer()));
  trial.Seconds(6.0);
  // The springs of an axle carry its share of the weight; the origin is 1.6 m behind the front one.
  const double front = kGravity * 2.3 / 3.9 / (2.0 * 15.0);  // m pressed together
  const double rear = kGravity * 1.6 / 3.9 / (2.0 * 15.0);
  const double height = 0.5 + 0.5 + 0.3 - (front * 2.3 + rear * 1.6) / 3.9;
  EXPECT_NEAR(trial.robot().position().z, height, 0.01);
  EXPECT_NEAR(trial.robot().euler().y, (front - rear) / 3.9, 0.005);
  EXPECT_NEAR(trial.robot().velocity().x, 0.0, 0.01);
}

TEST(SteerForceTest, NegativeForceDrivesItForwardsAgainstItsDamping) {
  Trial trial(Scene(Hummer()));
  trial.Seconds(3.0);
  trial.Send("car", R"({"steer": 0, "force": -10, "brake": 0})");
  trial.Seconds(10.0);
  // Four wheels with 0.4 of it on 10 kg: 1.6 m/s^2 against the damping.
  const double terminal = 1.6 / -std::log(1.0 - 0.4);
  EXPECT_NEAR(trial.robot().velocity().x, terminal, 0.05 * terminal);
  EXPECT_NEAR(trial.robot().position().y, 0.0, 0.1);
  trial.Send("car", R"({"steer": 0, "force": 0, "brake": 10})");
  trial.Seconds(3.0);
  EXPECT_NEAR(trial.robot().velocity().x, 0.0, 0.05);
}

TEST(SteerForceTest, SteeringToTheLeftGoesAroundACircle) {
  Trial trial(Scene(Hummer()));
  trial.Seconds(3.0);
  trial.Send("car", R"({"steer": 0.3, "force": -5, "brake": 0})");
  trial.Seconds(8.0);
  // Of a car without slip: the turn rate is v tan(steer) / wheelbase.
  const double v = trial.robot().twist().v;
  const double rate = v * std::tan(0.3) / 3.9;
  EXPECT_GT(v, 0.5);
  EXPECT_NEAR(trial.robot().spin().z, rate, 0.15 * rate);
}

// Rotorcraft

std::string Quadrotor(const std::string& components, const std::string& more = "",
                      double height = 5.0) {
  return R"({"name": "robot", "pose": {"x": 0, "y": 0, "yaw": 0}, "type": "Custom", "body": {
      "footprint": [[0.35, -0.35], [0.35, 0.35], [-0.35, 0.35], [-0.35, -0.35]], "mass": 2,
      "max_speed": 100, "max_turn_rate": 100, "origin_height": )" +
         Json(height).Dump() + R"(, "dynamics": {"bottom": -0.161, "top": 0.036)" + more +
         R"(}}, "components": [)" + components + "]}";
}

TEST(QuadrotorDynamicControlTest, HoversWhereFourRotorsCarryItsWeight) {
  Trial trial(Scene(Quadrotor(R"({"name": "rotors", "type": "QuadrotorDynamicControl"})")));
  const double w = std::sqrt(2.0 * kGravity / (4.0 * 9.169e-06));
  const std::string text = Json(w).Dump();
  trial.Send("rotors", R"({"engines": [)" + text + "," + text + "," + text + "," + text + "]}");
  trial.Seconds(5.0);
  EXPECT_NEAR(trial.robot().position().z, 5.0, 1e-6);
  EXPECT_NEAR(trial.robot().euler().z, 0.0, 1e-9);
}

TEST(QuadrotorDynamicControlTest, EachRotorTurnsItItsOwnWay) {
  const double w = std::sqrt(2.0 * kGravity / (4.0 * 9.169e-06));
  // Which rotor is faster, by a thousandth, and the signs of roll, pitch and yaw rate.
  const struct {
    int rotor;
    const char* configuration;
    int roll, pitch, yaw;
  } cases[] = {{0, "+", 0, -1, 1}, {1, "+", -1, 0, -1},  {2, "+", 0, 1, 1},  {3, "+", 1, 0, -1},
               {0, "x", 1, -1, 1}, {1, "x", -1, -1, -1}, {2, "x", -1, 1, 1}, {3, "x", 1, 1, -1}};
  for (const auto& one : cases) {
    Trial trial(Scene(Quadrotor(std::string(R"({"name": "rotors", "type":
        "QuadrotorDynamicControl", "properties": {"Configuration": ")") +
                                one.configuration + R"("}})")));
    std::string engines;
    for (int i = 0; i < 4; ++i) {
      engines += (i > 0 ? "," : "") + Json(i == one.rotor ? 1.001 * w : w).Dump();
    }
    trial.Send("rotors", R"({"engines": [)" + engines + "]}");
    trial.Seconds(0.2);
    const Vec3 spin = RotateBack(trial.robot().rotation(), trial.robot().spin());
    const auto sign = [](double value) { return value > 1e-4 ? 1 : value < -1e-4 ? -1 : 0; };
    EXPECT_EQ(sign(spin.x), one.roll) << one.configuration << one.rotor;
    EXPECT_EQ(sign(spin.y), one.pitch) << one.configuration << one.rotor;
    EXPECT_GT(spin.z * one.yaw, 0.0) << one.configuration << one.rotor;
  }
}

TEST(RotorcraftAttitudeTest, HoversAtTheThrustOfItsWeightAndTiltsAsTold) {
  Trial trial(Scene(Quadrotor(R"({"name": "attitude", "type": "RotorcraftAttitude"})")));
  const std::string hover = Json(2.0 * kGravity / 40.0).Dump();
  trial.Send("attitude", R"({"roll": 0, "pitch": 0, "yaw": 0, "thrust": )" + hover + "}");
  trial.Seconds(2.0);
  EXPECT_NEAR(trial.robot().position().z, 5.0, 1e-3);
  // Nose up: it goes backwards; right side down: to the right.
  trial.Send("attitude", R"({"roll": 0.1, "pitch": 0.2, "yaw": 0, "thrust": )" + hover + "}");
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().euler().x, 0.1, 0.005);
  EXPECT_NEAR(trial.robot().euler().y, -0.2, 0.005);
  EXPECT_LT(trial.robot().velocity().x, -0.5);
  EXPECT_LT(trial.robot().velocity().y, -0.3);
}

TEST(RotorcraftAttitudeTest, TurnsClockwiseAtARateOrToAnAngle) {
  const std::string hover = Json(2.0 * kGravity / 40.0).Dump();
  Trial rate(Scene(Quadrotor(R"({"name": "attitude", "type": "RotorcraftAttitude"})")));
  rate.Send("attitude", R"({"roll": 0, "pitch": 0, "yaw": 0.5, "thrust": )" + hover + "}");
  rate.Seconds(4.0);
  EXPECT_NEAR(rate.robot().spin().z, -0.5, 0.02);
  Trial angle(Scene(Quadrotor(R"({"name": "attitude", "type": "RotorcraftAttitude",
      "properties": {"YawRateControl": false, "UseAngleAgainstNorth": true}})")));
  // x points east: north-east is an eighth of a turn to the left of it.
  angle.Send("attitude",
             R"({"roll": 0, "pitch": 0, "yaw": 0.7853981633974483, "thrust": )" + hover + "}");
  angle.Seconds(6.0);
  EXPECT_NEAR(angle.robot().euler().z, kPi / 4.0, 0.02);
}

TEST(RotorcraftAttitudeTest, WithoutThrustItFalls) {
  Trial trial(Scene(Quadrotor(R"({"name": "attitude", "type": "RotorcraftAttitude"})")));
  trial.Seconds(0.5);
  EXPECT_LT(trial.robot().velocity().z, -4.5);
}

TEST(RotorcraftVelocityTest, HoversAndFliesAtItsVelocity) {
  Trial trial(Scene(Quadrotor(R"({"name": "velocity", "type": "RotorcraftVelocity"})")));
  trial.Seconds(3.0);
  EXPECT_NEAR(trial.robot().position().z, 5.0, 0.01);
  trial.Send("velocity", R"({"vx": 1, "vy": 0.5, "vz": 0.3, "vyaw": 0})");
  trial.Seconds(20.0);
  EXPECT_NEAR(trial.robot().velocity().x, 1.0, 0.1);
  EXPECT_NEAR(trial.robot().velocity().y, 0.5, 0.1);
  EXPECT_NEAR(trial.robot().velocity().z, 0.3, 0.05);
}

TEST(RotorcraftVelocityTest, TurnsAndIsNoFasterThanMaxVelocity) {
  Trial trial(Scene(Quadrotor(R"({"name": "velocity", "type": "RotorcraftVelocity"})")));
  const Json::Array arguments{5.0, 0.0, 0.0, 0.0};
  trial.Find("velocity", "setvel").run(arguments);
  trial.Seconds(25.0);
  EXPECT_NEAR(trial.robot().velocity().x, 2.0, 0.2);
  trial.Send("velocity", R"({"vx": 0, "vy": 0, "vz": 0, "vyaw": 0.4, "tolerance": 0.1})");
  trial.Seconds(5.0);
  EXPECT_NEAR(trial.robot().spin().z, 0.4, 0.03);
}

TEST(RotorcraftWaypointTest, GoesToItsWaypointAndSaysSo) {
  Trial trial(Scene(Quadrotor(R"({"name": "way", "type": "RotorcraftWaypoint"})")));
  trial.Seconds(2.0);
  EXPECT_NEAR(trial.robot().position().z, 5.0, 0.01);  // where it was is where it stays
  std::string answer;
  const Json::Array arguments{4.0, -3.0, 8.0, 1.0, 0.2};
  trial.Find("way", "goto").start(arguments, [&](ServiceResult result) {
    if (result.outcome == Outcome::kSuccess) answer = result.value.AsString();
  });
  EXPECT_EQ(trial.Find("way", "get_status").run({}).AsString(), "Transit");
  double arrived = -1.0;
  for (int i = 0; i < 40 * 60 && arrived < 0.0; ++i) {
    trial.Seconds(kTick);
    if (!answer.empty()) arrived = trial.simulation().time();
  }
  EXPECT_EQ(answer, "Arrived");
  EXPECT_EQ(trial.Find("way", "get_status").run({}).AsString(), "Arrived");
  trial.Seconds(10.0);
  EXPECT_NEAR(trial.robot().position().x, 4.0, 0.1);
  EXPECT_NEAR(trial.robot().position().y, -3.0, 0.1);
  EXPECT_NEAR(trial.robot().position().z, 8.0, 0.1);
  EXPECT_NEAR(trial.robot().euler().z, 1.0, 0.02);
}

TEST(RotorcraftWaypointTest, ANewGotoPreemptsAndACancelStays) {
  Trial trial(Scene(Quadrotor(R"({"name": "way", "type": "RotorcraftWaypoint"})")));
  int preempted = 0;
  const auto count = [&](ServiceResult result) {
    preempted += result.outcome == Outcome::kPreempted ? 1 : 0;
  };
  const Json::Array arguments{40.0, 0.0, 5.0, 0.0};
  trial.Find("way", "goto").start(arguments, count);
  trial.Seconds(1.0);
  trial.Find("way", "goto").start(arguments, count);
  EXPECT_EQ(preempted, 1);
  trial.Seconds(1.0);
  const double x = trial.robot().position().x;
  trial.Get("robot.way").Interrupt();
  EXPECT_EQ(preempted, 2);
  trial.Seconds(15.0);
  EXPECT_NEAR(trial.robot().position().x, x, 0.1);
}

TEST(StabilizedQuadrotorTest, RisesToItsHeightAndTiltedGoesAlong) {
  Trial trial(Scene(
      Quadrotor(R"({"name": "quad", "type": "StabilizedQuadrotor"})", R"(, "kind": "free")", 1.0)));
  trial.Send("quad", R"({"theta_c": 0, "phi_c": 0, "psi_c": 0, "h_c": 10})");
  trial.Seconds(5.0);
  EXPECT_NEAR(trial.robot().position().z, 10.0, 0.01);
  EXPECT_NEAR(trial.robot().position().x, 0.0, 1e-9);
  trial.Send("quad", R"({"theta_c": 0.1, "phi_c": 0, "psi_c": 0.5, "h_c": 10})");
  trial.Seconds(1.0);
  EXPECT_NEAR(trial.robot().euler().y, 0.1, 0.005);
  // psi lags by the filter's 2 * 0.7 / 10 s.
  EXPECT_NEAR(trial.robot().euler().z, -0.5 * (1.0 - 0.14), 0.01);
  const Vec3 v = trial.robot().velocity();
  EXPECT_NEAR(std::sqrt(v.x * v.x + v.y * v.y), 10.0 * std::tan(0.1) * (1.0 - 0.14), 0.1);
  trial.Find("quad", "stop").run({});
  trial.Seconds(5.0);
  EXPECT_NEAR(trial.robot().position().z, 0.0, 0.01);
}

TEST(StabilizedQuadrotorTest, ARobotWithPhysicsIsRefused) {
  EXPECT_THROW(Trial(Scene(Quadrotor(R"({"name": "quad", "type": "StabilizedQuadrotor"})"))),
               Error);
}

TEST(DynamicsTest, SensorsOfATiltedRobotLookWhereItDoes) {
  const std::string components = R"({"name": "pose", "type": "Pose", "position": [0, 0, 1]},
      {"name": "attitude", "type": "Attitude"}, {"name": "radar", "type": "RadarAltimeter"},
      {"name": "laser", "type": "LaserScanner", "laser": {"range": 30, "scan_window_deg": 2,
                                                         "resolution_deg": 1}})";
  Trial trial(Scene(Quadrotor(components, R"(, "kind": "free", "pitch": 0.3)")));
  trial.Seconds(0.1);
  EXPECT_NEAR(trial.Data("pose").Find("x")->AsDouble(), std::sin(0.3), 1e-9);
  EXPECT_NEAR(trial.Data("pose").Find("z")->AsDouble(), 5.0 + std::cos(0.3), 1e-9);
  EXPECT_NEAR(trial.Data("pose").Find("pitch")->AsDouble(), 0.3, 1e-9);
  EXPECT_NEAR(trial.Data("attitude").Find("rotation")->Find("pitch")->AsDouble(), 0.3, 1e-9);
  EXPECT_NEAR(trial.Data("radar").Find("z")->AsDouble(), 5.0, 1e-6);
  // Nose down by 0.3 rad from 5 m.
  EXPECT_NEAR(trial.Data("laser").Find("range_list")->AsArray()[1].AsDouble(), 5.0 / std::sin(0.3),
              1e-6);
}

}  // namespace
}  // namespace ccmorse::sim
