// ToJson writes what ParseScenario reads, for any scenario.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scene/scenario.h"

namespace ccmorse::scene {
namespace {

bool Same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool Same(const Pose2& a, const Pose2& b) { return a.x == b.x && a.y == b.y && a.yaw == b.yaw; }

bool Same(const Box& a, const Box& b) {
  return a.id == b.id && a.kind == b.kind && Same(a.pose, b.pose) && a.size_x == b.size_x &&
         a.size_y == b.size_y && a.height == b.height && a.color == b.color &&
         a.dynamic == b.dynamic && a.raised == b.raised && a.solid == b.solid &&
         a.visible == b.visible;
}

bool Same(const Mesh& a, const Mesh& b) {
  return a.id == b.id && a.name == b.name &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    [](const Vec3& v, const Vec3& w) { return Same(v, w); }) &&
         a.triangles == b.triangles && Same(a.position, b.position) &&
         Same(a.rotation, b.rotation) && a.color == b.color && a.solid == b.solid &&
         a.visible == b.visible;
}

bool Same(const Light& a, const Light& b) {
  return a.kind == b.kind && Same(a.position, b.position) && a.energy == b.energy &&
         a.shadows == b.shadows;
}

bool Same(const LaserDef& a, const LaserDef& b) {
  return Same(a.position, b.position) && a.roll == b.roll && a.pitch == b.pitch &&
         a.layers == b.layers && a.layer_separation == b.layer_separation && a.yaw == b.yaw &&
         a.frequency == b.frequency && a.scan_window_deg == b.scan_window_deg &&
         a.resolution_deg == b.resolution_deg && a.range == b.range && a.range_std == b.range_std &&
         a.layer_offset == b.layer_offset && a.visible_arc == b.visible_arc &&
         a.samples == b.samples;
}

bool Same(const std::optional<LaserDef>& a, const std::optional<LaserDef>& b) {
  return a.has_value() == b.has_value() && (!a || Same(*a, *b));
}

bool Same(const RingMount& a, const RingMount& b) {
  return Same(a.position, b.position) && a.yaw == b.yaw;
}

bool Same(const std::vector<RingMount>& a, const std::vector<RingMount>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const RingMount& m, const RingMount& n) { return Same(m, n); });
}

bool Same(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](Vec2 m, Vec2 n) { return m.x == n.x && m.y == n.y; });
}

bool Same(const HullPart& a, const HullPart& b) {
  return Same(a.outline, b.outline) && a.bottom == b.bottom && a.top == b.top;
}

bool Same(const std::optional<BodyDef>& a, const std::optional<BodyDef>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (std::equal(a->hull.begin(), a->hull.end(), b->hull.begin(), b->hull.end(),
                            [](const HullPart& m, const HullPart& n) { return Same(m, n); }) &&
                 Same(a->footprint, b->footprint) && a->mass == b->mass && a->drive == b->drive &&
                 a->wheelbase == b->wheelbase && a->max_speed == b->max_speed &&
                 a->max_side_speed == b->max_side_speed && a->max_turn_rate == b->max_turn_rate));
}

bool Same(const PlayerDevice& a, const PlayerDevice& b) {
  return a.port == b.port && a.interface == b.interface && a.index == b.index &&
         a.robot == b.robot && a.device == b.device;
}

bool Same(const PlayerDriver& a, const PlayerDriver& b) {
  return a.name == b.name && a.provided == b.provided && a.needed == b.needed &&
         a.always_on == b.always_on && a.length_unit == b.length_unit &&
         a.angle_unit == b.angle_unit && a.options == b.options;
}

bool Same(const std::optional<PlayerSetup>& a, const std::optional<PlayerSetup>& b) {
  return a.has_value() == b.has_value() &&
         (!a ||
          (std::equal(a->devices.begin(), a->devices.end(), b->devices.begin(), b->devices.end(),
                      [](const auto& m, const auto& n) { return Same(m, n); }) &&
           std::equal(a->drivers.begin(), a->drivers.end(), b->drivers.begin(), b->drivers.end(),
                      [](const auto& m, const auto& n) { return Same(m, n); })));
}

bool Same(const std::optional<RingDef>& a, const std::optional<RingDef>& b) {
  return a.has_value() == b.has_value() &&
         (!a || (a->frequency == b->frequency && a->min_range == b->min_range &&
                 a->range == b->range && a->cone_deg == b->cone_deg && Same(a->mounts, b->mounts)));
}

bool Same(const RangerDef& a, const RangerDef& b) {
  return a.name == b.name && Same(a.laser, b.laser) && Same(a.ring, b.ring);
}

bool Same(const RobotDef& a, const RobotDef& b) {
  return a.name == b.name && a.type == b.type && Same(a.pose, b.pose) && a.color == b.color &&
         a.proxies == b.proxies && a.drivers == b.drivers && a.front == b.front &&
         Same(a.ir, b.ir) && Same(a.sonar, b.sonar) &&
         (a.front != "laser" || Same(a.laser, b.laser)) &&
         a.pose_noise.pos_std == b.pose_noise.pos_std &&
         a.pose_noise.rot_std == b.pose_noise.rot_std && Same(a.odometry.start, b.odometry.start) &&
         Same(a.odometry.error, b.odometry.error) &&
         std::equal(a.rangers.begin(), a.rangers.end(), b.rangers.begin(), b.rangers.end(),
                    [](const RangerDef& m, const RangerDef& n) { return Same(m, n); }) &&
         Same(a.body, b.body);
}

template <typename T>
bool Same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!Same(a[i], b[i])) return false;
  }
  return true;
}

bool Same(const Scenario& a, const Scenario& b) {
  return a.name == b.name && a.world.name == b.world.name && a.world.size_x == b.world.size_x &&
         a.world.size_y == b.world.size_y && a.world.floor == b.world.floor &&
         a.world.origin.x == b.world.origin.x && a.world.origin.y == b.world.origin.y &&
         Same(a.world.boxes, b.world.boxes) && Same(a.world.meshes, b.world.meshes) &&
         Same(a.world.docks, b.world.docks) && Same(a.world.lights, b.world.lights) &&
         Same(a.robots, b.robots) && a.canvas.width == b.canvas.width &&
         a.canvas.height == b.canvas.height && a.canvas.alpha == b.canvas.alpha &&
         a.canvas.mode == b.canvas.mode && a.canvas.mode_switching == b.canvas.mode_switching &&
         Same(a.camera.position, b.camera.position) && Same(a.camera.rotation, b.camera.rotation) &&
         a.time.frequency == b.time.frequency && a.time.strategy == b.time.strategy &&
         a.time.factor == b.time.factor && a.time.read_frequency == b.time.read_frequency &&
         a.time.end == b.time.end && a.seed == b.seed && Same(a.player, b.player);
}

// A real number in [min, max], of any number of digits.
double Real(double min, double max) {
  const auto part = *rc::gen::inRange<std::int64_t>(0, (std::int64_t{1} << 53) + 1);
  return min + (max - min) * (static_cast<double>(part) / 9007199254740992.0);
}

Color AnyColor() {
  const auto channel = [] { return static_cast<std::uint8_t>(*rc::gen::inRange(0, 256)); };
  return {channel(), channel(), channel()};
}

Vec3 AnyVector(double limit) {
  return {Real(-limit, limit), Real(-limit, limit), Real(-limit, limit)};
}

LaserDef AnyLaser() {
  LaserDef laser;
  laser.position = AnyVector(0.1);
  laser.roll = Real(-3.0, 3.0);
  laser.pitch = Real(-3.0, 3.0);
  laser.yaw = Real(-3.0, 3.0);
  laser.layers = *rc::gen::inRange(1, 50);
  laser.layer_separation = Real(-10.0, 10.0);
  laser.frequency = Real(0.1, 100.0);
  laser.scan_window_deg = Real(1.0, 360.0);
  laser.samples = *rc::gen::inRange(2, 2000);
  laser.resolution_deg = laser.scan_window_deg / laser.samples;
  laser.range = Real(0.1, 100.0);
  laser.range_std = Real(0.0, 1.0);
  laser.layer_offset = Real(-1.0, 1.0);
  laser.visible_arc = *rc::gen::arbitrary<bool>();
  return laser;
}

RingDef AnyRing() {
  const double range = Real(0.1, 100.0);
  RingDef ring{Real(0.1, 100.0), Real(0.0, range / 2), range, Real(1.0, 170.0), {}};
  for (int i = *rc::gen::inRange(0, 4); i > 0; --i)
    ring.mounts.push_back({AnyVector(1.0), Real(-3, 3)});
  return ring;
}

// As small as the S1R, so that it fits its dock.
BodyDef AnyBody() {
  BodyDef body;
  const double half = Real(0.01, 0.08);
  body.footprint = {{half, -half}, {half, half}, {-half, half}, {-half, -half}};
  body.hull = {{body.footprint, Real(0.0, 0.1), Real(0.2, 1.0)}};
  body.mass = Real(0.1, 10.0);
  body.drive = *rc::gen::element<std::string>("diff", "omni", "car");
  body.wheelbase = Real(0.1, 2.0);
  body.max_speed = Real(0.1, 2.0);
  body.max_side_speed = body.drive == "omni" ? Real(0.0, 1.0) : 0.0;
  body.max_turn_rate = Real(0.1, 4.0);
  return body;
}

// A mesh above all robots.
Mesh AnyMesh(int id) {
  Mesh mesh;
  mesh.id = id;
  if (*rc::gen::arbitrary<bool>()) mesh.name = "mesh_" + std::to_string(id);
  mesh.position = {Real(-3.0, 3.0), Real(-3.0, 3.0), 50.0};
  mesh.rotation = AnyVector(6.0);
  mesh.color = AnyColor();
  for (int i = 0; i < 5; ++i) mesh.vertices.push_back(AnyVector(1.0));
  mesh.triangles = {{0, 1, 2}, {2, 3, 4}, {4, 0, 1}};
  return mesh;
}

RC_GTEST_PROP(C02, WhatToJsonWritesReadsBackTheSame, ()) {
  Scenario scenario = ParseScenario(R"({"robots": []})", "test.json");
  for (Box& box : scenario.world.boxes) {
    if (box.dynamic) box.raised = *rc::gen::arbitrary<bool>();
  }
  scenario.world.floor = AnyColor();
  scenario.world.origin = {Real(-9, 9), Real(-9, 9)};
  for (Box& box : scenario.world.boxes) {
    box.solid = *rc::gen::arbitrary<bool>();
    box.visible = *rc::gen::arbitrary<bool>();
  }
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    scenario.world.meshes.insert(scenario.world.meshes.begin(), AnyMesh(1000 + i));
  }
  const int robots = *rc::gen::inRange(0, 14);
  for (int i = 0; i < robots; ++i) {
    RobotDef robot;
    robot.name = "robot_" + std::to_string(i);
    robot.pose = scenario.world.docks[static_cast<std::size_t>(i)];
    robot.color = AnyColor();
    robot.laser = AnyLaser();
    robot.pose_noise = {Real(0.0, 1.0), Real(0.0, 1.0)};
    if (*rc::gen::arbitrary<bool>()) robot.ir = AnyRing();
    if (*rc::gen::arbitrary<bool>()) robot.sonar = AnyRing();
    if (*rc::gen::arbitrary<bool>()) {
      RangerDef ranger;
      ranger.name = "more";
      if (*rc::gen::arbitrary<bool>()) {
        ranger.laser = AnyLaser();
      } else {
        ranger.ring = AnyRing();
        ranger.ring->mounts.push_back({AnyVector(1.0), 0.5});
      }
      robot.rangers.push_back(ranger);
    }
    robot.odometry = {{Real(-1, 1), Real(-1, 1), Real(-1, 1)},
                      {Real(0, 1), Real(0, 1), Real(0, 1)}};
    if (*rc::gen::arbitrary<bool>()) {
      robot.type = "Custom";
      robot.body = AnyBody();
      for (auto* ring : {&robot.ir, &robot.sonar}) {
        if (*ring) (*ring)->mounts.push_back({AnyVector(1.0), -0.5});
      }
      robot.front = *rc::gen::element<std::string>("laser", "none");
    } else if (robot.ir || robot.sonar)
      robot.front = *rc::gen::element<std::string>("laser", "sensors");
    robot.proxies["position2d"][*rc::gen::inRange(0, 65536)] = "odometry";
    robot.proxies["laser"];
    robot.drivers["snd"] = Json::Object{{"max_speed", Real(0.0, 1.0)}, {"name", "a \"b\" \n"}};
    scenario.robots.push_back(robot);
  }
  scenario.canvas.width = *rc::gen::inRange(1, 4097);
  scenario.canvas.height = *rc::gen::inRange(1, 4097);
  scenario.canvas.alpha = Real(0.0, 1.0);
  scenario.canvas.mode = *rc::gen::element<std::string>("ground", "minimap", "fullscreen");
  scenario.canvas.mode_switching = *rc::gen::arbitrary<bool>();
  scenario.camera = {AnyVector(100.0), AnyVector(6.0)};
  scenario.time.frequency = Real(1.0, 1000.0);
  scenario.time.strategy = *rc::gen::element<std::string>("realtime", "lockstep", "max");
  scenario.time.factor = Real(0.001, 1000.0);
  scenario.time.read_frequency = Real(0.01, scenario.time.frequency);
  scenario.time.end = Real(0.0, 100.0);
  if (*rc::gen::arbitrary<bool>()) {
    scenario.player.emplace();
    scenario.player->devices.push_back({*rc::gen::inRange(1, 65536), "simulation", 0, "", ""});
    if (robots > 0) scenario.player->devices.push_back({6665, "position2d", 3, "robot_0", "pose"});
    PlayerDriver driver;
    driver.name = "snd";
    driver.provided = {{"", "", 6666, "position2d", 1}};
    driver.needed = {{"input", "", 6665, "position2d", 3}, {"", "host", 7000, "laser", 0}};
    driver.always_on = *rc::gen::arbitrary<bool>();
    driver.angle_unit = Real(0.01, 1.0);
    driver.options = {{"a", Real(-1, 1)}, {"b", "text"}, {"c", Json::Array{1, "x"}}};
    scenario.player->drivers.push_back(driver);
  }
  scenario.seed = static_cast<std::uint64_t>(*rc::gen::inRange<std::int64_t>(0, INT64_MAX));

  const std::string text = ToJson(scenario).Dump();
  const Scenario read = ParseScenario(text, "test.json");
  RC_ASSERT(Same(scenario, read));
  RC_ASSERT(ToJson(read).Dump() == text);
}

TEST(C02, DeliveredScenariosReadBackTheSame) {
  for (const std::string& name : ListScenarios()) {
    const Scenario scenario = LoadScenario(FindScenario(name));
    EXPECT_TRUE(Same(scenario, ParseScenario(ToJson(scenario).Dump(), name + ".json"))) << name;
  }
}

// Whatever a byte of a file is changed to, reading it ends in a scenario or in an Error that starts
// with the file's name.
RC_GTEST_PROP(ScenarioErrors, NoChangedByteDoesHarm, ()) {
  std::string text = R"({"world": "syrotek", "obstacles": {"up": [5, 10]},
 "robots": [{"name": "s1r", "pose": {"x": 1.2, "y": 2.0, "yaw_deg": 150}, "color": "#102030",
   "proxies": {"position2d": {"0": "pose"}}, "laser": {"scan_window_deg": 180, "samples": 91}}],
 "canvas": {"width": 172}, "time": {"frequency": 60}, "seed": 3})";
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  text[at] = *rc::gen::arbitrary<char>();
  try {
    ParseScenario(text, "test.json");
  } catch (const Error& error) {
    RC_ASSERT(std::string(error.what()).starts_with("test.json:"));
    RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace ccmorse::scene
