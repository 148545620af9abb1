#include "scene/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "assets/load.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/asset_props.h"
#include "scene/asset_world.h"
#include "scene/field.h"
#include "scene/limits.h"
#include "scene/mesh.h"
#include "scene/obstacle_rules.h"
#include "scene/robots.h"
#include "scene/world_file.h"
#include "scene/world_folders.h"

namespace ccmorse::scene {
namespace {

// What an absent 'world' and 'robots' stand for; parsed, so that messages name line 1.
constexpr const char* kDefaultWorld = "\"syrotek\"";
constexpr const char* kDefaultRobots = "[{}]";
// In the open hall of SyRoTek's arena, a start that its users chose, too (specs: syrotek.md B);
// free of every box, whichever are up.
constexpr Pose2 kDefaultPose{1.20, 2.00, Radians(150.0)};
constexpr double kFastest = 100.0;  // m/s or rad/s, likewise
constexpr int kMostSamples = 10000;
constexpr int kMostLayers = 128;
constexpr int kMostBeams = 100000;  // of all layers
constexpr std::size_t kMostMounts = 1000;
constexpr std::size_t kMostHullCorners = 64;
constexpr std::size_t kMostWheels = 16;
constexpr std::int64_t kMostSeed = std::numeric_limits<std::int64_t>::max();

// Player's interfaces and what of a robot can serve them (thesis 4.1.2).
const std::map<std::string, std::vector<std::string>>& DevicesOfInterface() {
  static const std::map<std::string, std::vector<std::string>> devices = {
      {"position2d", {"pose", "odometry"}}, {"laser", {"hokuyo"}}};
  return devices;
}

const std::string kCustom = "Custom";

// `props`: those that come with a file of shapes.
World ReadWorldChoice(const Field& field, std::vector<PropDef>& props) {
  if (field.value().IsString()) {
    const std::string& name = field.Text();
    const std::vector<std::string> known = ListWorlds();
    // Only a listed name: FindWorldFile would follow "../.." out of the folder of worlds.
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      field.FailHere(fmt::format(
          "is {}, must be {}{} or {{\"file\": \"...\"}}", Quoted(name),
          known.empty() ? "an installed world (there is none)" : "one of " + Listed(known),
          DidYouMean(name, known)));
    }
    return LoadWorld(FindWorldFile(name));
  }
  if (!field.value().IsObject()) {
    field.FailHere(
        fmt::format("must be a world's name, {{\"file\": \"...\"}} or a world in full, not {}",
                    field.value().TypeName()));
  }
  if (field.value().Find("file") == nullptr) return ReadWorld(field);
  ObjectReader reader(field);
  const Field name = reader.Require("file");
  const bool terrain = reader.Bool("terrain", false);
  reader.Finish();
  if (std::any_of(name.Text().begin(), name.Text().end(),
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; })) {
    name.FailHere(fmt::format("is {}, which no file is called", Quoted(name.Text())));
  }
  const std::filesystem::path folder = std::filesystem::path(field.file()).parent_path();
  if (assets::IsAssetName(name.Text())) {
    try {
      World world = LoadAssetWorld(assets::FindAsset(name.Text(), folder.string()), &props);
      world.terrain = terrain;
      return world;
    } catch (const Error& error) {
      name.Fail(error.what());
    }
  }
  const std::filesystem::path path = folder / name.Text();
  try {
    World world = LoadWorld(path.string());
    world.terrain = world.terrain || terrain;
    return world;
  } catch (const Error& error) {
    // A message that starts with the world's own file and line says more than this line would.
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) throw;
    name.Fail(error.what());
  }
}

// The scanner of SyRoTek's robots as Hokuyo sells it (SCIP 2.0 manual: 1024 steps a turn, 682 of
// them used, 5.6 m), where the thesis gives 270 degrees and 5 m (checklist Q11).
LaserDef Urg04lx() {
  LaserDef laser;
  laser.resolution_deg = 360.0 / 1024.0;
  laser.scan_window_deg = 681.0 * laser.resolution_deg;
  laser.range = 5.6;
  return laser;
}

// MORSE's count of beams, by repeated addition as MORSE does it (specs: morse.md H.4).
int CountBeams(double window_deg, double resolution_deg) {
  int beams = 0;
  for (double angle = -window_deg / 2.0; angle <= window_deg / 2.0 && beams <= kMostSamples;
       angle += resolution_deg) {
    ++beams;
  }
  return beams;
}

// What MORSE's builder makes of its LaserScanner (specs: morse.md B.2, H.4); the count of beams
// follows from the other numbers.
LaserDef MorseLaser(double range, double window_deg, double resolution_deg) {
  LaserDef laser;
  laser.range = range;
  laser.scan_window_deg = window_deg;
  laser.resolution_deg = resolution_deg;
  laser.samples = CountBeams(window_deg, resolution_deg);
  return laser;
}

LaserDef LaserPreset(const std::string& name) {
  if (name == "urg04lx") return Urg04lx();
  if (name == "hokuyo") return MorseLaser(30.0, 270.0, 0.25);
  if (name == "sick") return MorseLaser(30.0, 180.0, 1.0);
  if (name == "infrared") {
    LaserDef laser = MorseLaser(2.0, 20.0, 1.0);
    laser.visible_arc = true;
    return laser;
  }
  if (name == "sick_ldmrs") {
    LaserDef laser = MorseLaser(30.0, 100.0, 0.25);
    laser.frequency = 4.0;
    laser.layers = 4;
    return laser;
  }
  return LaserDef{};
}

// Completes what a file says of window, resolution and number of beams.
void ReadBeams(ObjectReader& reader, LaserDef& laser) {
  const bool has_window = reader.Has("scan_window_deg");
  const bool has_resolution = reader.Has("resolution_deg");
  const bool has_samples = reader.Has("samples");
  laser.scan_window_deg =
      reader.Number("scan_window_deg", laser.scan_window_deg, {0.0, 360.0, true});
  laser.resolution_deg = reader.Number("resolution_deg", laser.resolution_deg, {0.0, 360.0, true});
  laser.samples = reader.Integer("samples", laser.samples, 2, kMostSamples);
  const Field& field = reader.field();
  if (!has_samples && (has_window || has_resolution)) {
    laser.samples = CountBeams(laser.scan_window_deg, laser.resolution_deg);
    if (laser.samples < 2 || laser.samples > kMostSamples) {
      field.FailHere(fmt::format("makes {} beams of {} degrees in steps of {}, must be 2..{}",
                                 laser.samples < 2 ? "too few" : "too many", laser.scan_window_deg,
                                 laser.resolution_deg, kMostSamples));
    }
  } else if (has_samples && !has_resolution) {
    // So many beams spread over the window, from edge to edge.
    laser.resolution_deg = laser.scan_window_deg / (laser.samples - 1);
  } else if (has_samples && !has_window) {
    laser.scan_window_deg = std::min(360.0, laser.resolution_deg * (laser.samples - 1));
  }
  const double span = laser.resolution_deg * (laser.samples - 1);
  // Repeated addition can end a rounding error beyond the window.
  if (span > laser.scan_window_deg * (1.0 + 1e-9)) {
    field.FailHere(
        fmt::format("has {} beams {} degrees apart, which is {:.3f} degrees and more "
                    "than its window of {}",
                    laser.samples, laser.resolution_deg, span, laser.scan_window_deg));
  }
}

LaserDef ReadLaser(const Field& field, const LaserDef& delivered) {
  static const std::vector<std::string> presets = {"thesis", "urg04lx",    "hokuyo",
                                                   "sick",   "sick_ldmrs", "infrared"};
  ObjectReader reader(field);
  LaserDef laser = delivered;
  if (reader.Has("preset")) laser = LaserPreset(reader.Choice("preset", "", presets));
  laser.position = reader.Vector("position", laser.position, kFarthest);
  laser.roll = reader.Angle("roll", laser.roll);
  laser.pitch = reader.Angle("pitch", laser.pitch);
  laser.yaw = reader.Angle("yaw", laser.yaw);
  laser.frequency = reader.Number("frequency", laser.frequency, {0.0, 1000.0, true});
  laser.range = reader.Number("range", laser.range, {0.0, kFarthest, true});
  laser.range_std = reader.Number("range_std", laser.range_std, {0.0, kFarthest});
  laser.layers = reader.Integer("layers", laser.layers, 1, kMostLayers);
  laser.layer_separation =
      reader.Number("layer_separation", laser.layer_separation, {-180.0, 180.0});
  laser.layer_offset = reader.Number("layer_offset", laser.layer_offset, {-360.0, 360.0});
  laser.visible_arc = reader.Bool("visible_arc", laser.visible_arc);
  ReadBeams(reader, laser);
  reader.Finish();
  if (laser.layers * laser.samples > kMostBeams) {
    field.FailHere(fmt::format("has {} layers of {} beams, {} in all, must be at most {}",
                               laser.layers, laser.samples, laser.layers * laser.samples,
                               kMostBeams));
  }
  return laser;
}

// [[x, y, z, yaw], ...], as the ring's get_configurations gives them.
std::vector<RingMount> ReadMounts(const Field& field) {
  std::vector<RingMount> mounts;
  for (const Field& pose : field.Items()) {
    const std::vector<Field> numbers = pose.Items();
    if (numbers.size() != 4) {
      pose.FailHere(fmt::format("has {} numbers, must be [x, y, z, yaw]", numbers.size()));
    }
    const Range place{-kFarthest, kFarthest};
    mounts.push_back(
        {{numbers[0].Number(place), numbers[1].Number(place), numbers[2].Number(place)},
         numbers[3].Number({-20.0 * kPi, 20.0 * kPi})});
  }
  if (mounts.empty() || mounts.size() > kMostMounts) {
    field.FailHere(fmt::format("has {} poses, must have 1..{}", mounts.size(), kMostMounts));
  }
  return mounts;
}

// true for the ring as delivered, false for none, an object for one with settings of its own.
std::optional<RingDef> ReadRing(const Field& field, const RingDef& delivered) {
  if (field.value().IsBool()) {
    return field.value().AsBool() ? std::optional(delivered) : std::nullopt;
  }
  if (!field.value().IsObject()) {
    field.FailHere(
        fmt::format("must be true, false or an object {{...}}, not {}", field.value().TypeName()));
  }
  ObjectReader reader(field);
  RingDef ring = delivered;
  ring.frequency = reader.Number("frequency", ring.frequency, {0.0, 1000.0, true});
  ring.range = reader.Number("range", ring.range, {0.0, kFarthest, true});
  ring.min_range =
      reader.Number("min_range", std::min(ring.min_range, ring.range / 2.0), {0.0, kFarthest});
  ring.cone_deg = reader.Number("cone_deg", ring.cone_deg, {0.0, 170.0, true});
  if (reader.Has("poses")) ring.mounts = ReadMounts(reader.Require("poses"));
  reader.Finish();
  if (ring.min_range >= ring.range) {
    field.FailHere(fmt::format("has a min_range of {} m, must be less than its range of {} m",
                               ring.min_range, ring.range));
  }
  return ring;
}

// Nobody but the file knows where the range sensors of a Custom robot sit.
void CheckRings(ObjectReader& reader, const RobotDef& robot) {
  if (!robot.body) return;
  if (robot.ir && robot.ir->mounts.empty()) {
    reader.Require("ir").FailHere("lacks 'poses': where the sensors of a Custom robot sit");
  }
  if (robot.sonar && robot.sonar->mounts.empty()) {
    reader.Require("sonar").FailHere("lacks 'poses': where the sensors of a Custom robot sit");
  }
}

// With the sensor module in its front bay a robot has no laser to talk of.
void CheckModule(ObjectReader& reader, const RobotDef& robot) {
  if (robot.front == "laser") return;
  if (robot.front == "none") {
    const auto table = robot.proxies.find("laser");
    if (table == robot.proxies.end() || table->second.empty()) return;
    reader.Require("proxies").FailHere("name the 'hokuyo', but this robot has no 'laser'; add one");
  }
  const Field front = reader.Require("front");
  if (reader.Has("laser")) {
    reader.Require("laser").FailHere(
        "belongs to a robot with \"front\": \"laser\"; remove one of them");
  }
  const auto table = robot.proxies.find("laser");
  if (table != robot.proxies.end() && !table->second.empty()) {
    reader.Require("proxies").FailHere(
        "name the 'hokuyo', which this robot's front sensor module has taken the place of");
  }
  if (robot.front == "sensors" && !robot.ir && !robot.sonar) {
    front.FailHere("is the sensor module, so add \"ir\": true, \"sonar\": true or both");
  }
}

void ReadProxies(const Field& field, ProxyTable& proxies) {
  ObjectReader reader(field);
  for (const auto& [interface, devices] : DevicesOfInterface()) {
    if (!reader.Has(interface)) continue;
    const Field indexes = reader.Require(interface);
    ObjectReader index_reader(indexes);
    std::map<int, std::string> table;
    for (const auto& member : indexes.value().AsObject()) {
      const Field device = index_reader.Require(member.first);
      const std::string& text = member.first;
      const bool is_index = !text.empty() && text.size() <= 5 &&
                            text.find_first_not_of("0123456789") == std::string::npos &&
                            (text == "0" || text[0] != '0') && std::stoi(text) <= 65535;
      if (!is_index) {
        device.Fail(fmt::format("key {} in {} must be an index 0..65535, as \"0\"", Quoted(text),
                                indexes.path()));
      }
      table[std::stoi(text)] = device.Choice(devices);
    }
    proxies[interface] = std::move(table);
  }
  reader.Finish();
}

// A driver reads its own settings; here only what no settings may have is turned down.
void CheckSettings(const Field& field) {
  if (field.value().IsArray()) {
    for (const Field& item : field.Items()) CheckSettings(item);
  } else if (field.value().IsObject()) {
    ObjectReader reader(field);
    for (const auto& member : field.value().AsObject()) CheckSettings(reader.Require(member.first));
  } else if (field.value().IsNumber() && !std::isfinite(field.value().AsDouble())) {
    field.FailHere("must be a finite number");
  }
}

void ReadDrivers(const Field& field, std::map<std::string, Json>& drivers) {
  ObjectReader reader(field);
  for (const auto& member : field.value().AsObject()) {
    const Field settings = reader.Require(member.first);
    if (!settings.value().IsObject()) {
      settings.FailHere(fmt::format("must be an object {{...}} of settings, not {}",
                                    settings.value().TypeName()));
    }
    CheckSettings(settings);
    drivers[member.first] = settings.value();
  }
}

PoseNoiseDef ReadPoseNoise(const Field& field) {
  ObjectReader reader(field);
  PoseNoiseDef noise;
  noise.pos_std = reader.Number("pos_std", noise.pos_std, {0.0, kFarthest});
  noise.rot_std = reader.Number("rot_std", noise.rot_std, {0.0, kPi});
  reader.Finish();
  return noise;
}

// Strictly convex and counter-clockwise.
std::vector<Vec2> ReadOutline(const Field& field, std::size_t most) {
  std::vector<Vec2> outline;
  const Range place{-kFarthest, kFarthest};
  for (const Field& corner : field.Items()) {
    const std::vector<Field> numbers = corner.Items();
    if (numbers.size() != 2) {
      corner.FailHere(fmt::format("has {} numbers, must be [x, y]", numbers.size()));
    }
    outline.push_back({numbers[0].Number(place), numbers[1].Number(place)});
  }
  if (outline.size() < 3 || outline.size() > most) {
    field.FailHere(fmt::format("has {} corners, must have 3..{}", outline.size(), most));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    const Vec2 c = outline[(i + 2) % outline.size()];
    if (!(Cross(b - a, c - b) > 0.0)) {
      field.FailHere(fmt::format(
          "must turn left at each corner, convex and counter-clockwise, but not at ({}, {})", b.x,
          b.y));
    }
  }
  return outline;
}

// A factor for all axes, or one for each.
Vec3 ReadScale(ObjectReader& reader) {
  if (!reader.Has("scale")) return {1.0, 1.0, 1.0};
  const Field scale = reader.Require("scale");
  if (scale.value().IsNumber()) {
    const double all = scale.Number({0.0, kFarthest, true});
    return {all, all, all};
  }
  return scale.Vector(kFarthest);
}

std::string ReadPhysics(ObjectReader& reader) {
  static const std::vector<std::string> types = {"NO_COLLISION", "STATIC",    "DYNAMIC",
                                                 "RIGID_BODY",   "SOFT_BODY", "OCCLUDER",
                                                 "SENSOR",       "NAVMESH",   "CHARACTER"};
  return reader.Has("physics") ? reader.Choice("physics", "", types) : "";
}

// A view of a robot need not have more triangles: a fleet of them is shown, too.
constexpr std::size_t kMostShown = 20000;

// The file that a robot's shape, and where it gives none its body, comes from.
void ReadModel(const Field& field, bool has_footprint, BodyDef& body) {
  ObjectReader reader(field);
  const Field file = reader.Require("file");
  const Vec3 scale = ReadScale(reader);
  const std::string physics = ReadPhysics(reader);
  const std::optional<Color> paint =
      reader.Has("color") ? std::optional(reader.Require("color").ReadColor()) : std::nullopt;
  reader.Finish();
  try {
    const std::string folder = std::filesystem::path(field.file()).parent_path().string();
    RobotShape shape =
        RobotShapeOf(assets::LoadAsset(assets::FindAsset(file.Text(), folder)), physics, scale);
    for (Mesh& mesh : shape.shape) {
      Mesh simple = Simplified(std::move(mesh), kMostShown);
      if (paint) Paint(*paint, simple);
      body.shape.push_back(std::move(simple));
    }
    if (has_footprint) return;
    body.footprint = shape.footprint;
    body.hull = shape.hull;
    body.mass = shape.mass;
    body.origin_height = std::max(0.0, -shape.lowest);
    if (shape.collides) return;
    // Nothing touches it, as nearly as may be, and no sensor sees it.
    constexpr double kPoint = 0.01;  // m
    body.footprint = {{kPoint, -kPoint}, {kPoint, kPoint}, {-kPoint, kPoint}, {-kPoint, -kPoint}};
    body.hull.clear();
  } catch (const Error& error) {
    file.Fail(error.what());
  }
}

WheelDef ReadWheel(const Field& field) {
  static const std::vector<std::string> drives = {"left", "right", "free", "ball"};
  ObjectReader reader(field);
  WheelDef wheel;
  wheel.position = reader.Vector("position", wheel.position, kFarthest);
  wheel.radius = reader.Number("radius", wheel.radius, {0.0, kFarthest, true});
  wheel.width = reader.Number("width", wheel.width, {0.0, kFarthest, true});
  wheel.mass = reader.Number("mass", wheel.mass, {0.0, 1e6, true});
  wheel.friction = reader.Number("friction", wheel.friction, {0.0, 1000.0});
  wheel.linear_damping = reader.Number("linear_damping", wheel.linear_damping, {0.0, 1.0});
  wheel.angular_damping = reader.Number("angular_damping", wheel.angular_damping, {0.0, 1.0});
  wheel.drive = reader.Choice("drive", "free", drives);
  reader.Finish();
  return wheel;
}

VehicleDef ReadVehicle(const Field& field) {
  ObjectReader reader(field);
  VehicleDef vehicle;
  vehicle.front = reader.Number("front", vehicle.front, {-kFarthest, kFarthest});
  vehicle.rear = reader.Number("rear", vehicle.rear, {-kFarthest, kFarthest});
  vehicle.half_track = reader.Number("half_track", vehicle.half_track, {0.0, kFarthest, true});
  vehicle.height = reader.Number("height", vehicle.height, {-kFarthest, kFarthest});
  vehicle.wheel_radius =
      reader.Number("wheel_radius", vehicle.wheel_radius, {0.0, kFarthest, true});
  vehicle.rest_length = reader.Number("rest_length", vehicle.rest_length, {0.0, kFarthest, true});
  vehicle.stiffness = reader.Number("stiffness", vehicle.stiffness, {0.0, 1e4});
  vehicle.damping = reader.Number("damping", vehicle.damping, {0.0, 100.0});
  vehicle.compression = reader.Number("compression", vehicle.compression, {0.0, 100.0});
  vehicle.friction = reader.Number("friction", vehicle.friction, {0.0, 1e4});
  vehicle.roll_influence = reader.Number("roll_influence", vehicle.roll_influence, {0.0, 1.0});
  reader.Finish();
  return vehicle;
}

DynamicsDef ReadDynamics(const Field& field) {
  static const std::vector<std::string> kinds = {"rigid", "free"};
  ObjectReader reader(field);
  DynamicsDef def;
  def.kind = reader.Choice("kind", def.kind, kinds);
  def.bottom = reader.Number("bottom", def.bottom, {-kFarthest, kFarthest});
  def.top = reader.Number("top", std::max(def.top, def.bottom + 0.5), {-kFarthest, kFarthest});
  if (def.top <= def.bottom) reader.Require("top").FailHere("must be above 'bottom'");
  def.friction = reader.Number("friction", def.friction, {0.0, 1000.0});
  def.linear_damping = reader.Number("linear_damping", def.linear_damping, {0.0, 1.0});
  def.angular_damping = reader.Number("angular_damping", def.angular_damping, {0.0, 1.0});
  def.gravity = reader.Bool("gravity", def.gravity);
  def.ground = reader.Bool("ground", def.ground);
  def.roll = reader.Angle("roll", def.roll);
  def.pitch = reader.Angle("pitch", def.pitch);
  def.turning_track = reader.Number("turning_track", def.turning_track, {0.0, kFarthest});
  if (reader.Has("wheels")) {
    for (const Field& wheel : reader.Require("wheels").Items()) {
      def.wheels.push_back(ReadWheel(wheel));
    }
    if (def.wheels.size() > kMostWheels) {
      reader.Require("wheels").FailHere(
          fmt::format("has {} wheels, must have at most {}", def.wheels.size(), kMostWheels));
    }
  }
  if (reader.Has("vehicle")) {
    def.vehicle = ReadVehicle(reader.Require("vehicle"));
    if (!def.wheels.empty()) {
      reader.Require("vehicle").FailHere("has wheels of its own; remove it or 'wheels'");
    }
  }
  reader.Finish();
  return def;
}

BodyDef ReadBody(const Field& field) {
  static const std::vector<std::string> drives = {"diff", "omni", "car"};
  ObjectReader reader(field);
  BodyDef body;
  const bool has_footprint = reader.Has("footprint");
  if (reader.Has("model")) ReadModel(reader.Require("model"), has_footprint, body);
  if (has_footprint || body.footprint.empty()) {
    body.footprint = ReadOutline(reader.Require("footprint"), kFootprintCorners);
  }
  if (reader.Has("shape")) {
    for (Mesh& mesh : ReadShape(reader.Require("shape"))) body.shape.push_back(std::move(mesh));
  }
  body.flies = reader.Bool("flies", body.flies);
  if (reader.Has("hull")) {
    body.hull.clear();
    for (const Field& item : reader.Require("hull").Items()) {
      ObjectReader part_reader(item);
      HullPart part;
      part.outline = ReadOutline(part_reader.Require("outline"), kMostHullCorners);
      part.bottom = part_reader.Number("bottom", 0.0, {0.0, kFarthest});
      part.top = part_reader.Require("top").Number({part.bottom, kFarthest, true});
      part_reader.Finish();
      body.hull.push_back(std::move(part));
    }
  }
  body.mass = reader.Number("mass", body.mass, {0.0, 1e6, true});
  body.drive = reader.Choice("drive", body.drive, drives);
  body.wheelbase = reader.Number("wheelbase", body.wheelbase, {0.0, kFarthest, true});
  body.max_speed = reader.Number("max_speed", body.max_speed, {0.0, kFastest, true});
  const double side = body.drive == "omni" ? body.max_speed : 0.0;
  body.max_side_speed = reader.Number("max_side_speed", side, {0.0, kFastest});
  if (body.max_side_speed > 0.0 && body.drive != "omni") {
    reader.Require("max_side_speed").FailHere("is for robots whose drive is \"omni\"; remove it");
  }
  body.max_turn_rate = reader.Number("max_turn_rate", body.max_turn_rate, {0.0, kFastest, true});
  body.origin_height = reader.Number("origin_height", body.origin_height, {0.0, kFarthest});
  if (reader.Has("dynamics")) body.dynamics = ReadDynamics(reader.Require("dynamics"));
  reader.Finish();
  return body;
}

OdometryDef ReadOdometry(const Field& field) {
  ObjectReader reader(field);
  OdometryDef odometry;
  if (reader.Has("start")) odometry.start = ReadPose(reader.Require("start"));
  odometry.error = reader.Vector("error", odometry.error, 1.0);
  const Vec3& error = odometry.error;
  if (error.x < 0.0 || error.y < 0.0 || error.z < 0.0) {
    reader.Require("error").FailHere("must be 0..1, forward, sideways and in turning");
  }
  reader.Finish();
  return odometry;
}

WearDef ReadWear(const Field& field) {
  ObjectReader reader(field);
  WearDef wear;
  wear.pull = reader.Number("pull", wear.pull, {-10.0, 10.0});
  wear.turn_lag = reader.Number("turn_lag", wear.turn_lag, {0.0, 10.0});
  reader.Finish();
  return wear;
}

bool Lacks(const RobotDef& robot, const std::string& device) {
  return std::find(robot.without.begin(), robot.without.end(), device) != robot.without.end();
}

// Takes the devices that a robot goes without from those that its type has; Player's indexes that
// the file does not name go with them.
void ReadWithout(const Field& field, RobotDef& robot) {
  for (const Field& item : field.Items()) {
    const std::string device = item.Choice(RemovableDevices());
    if (Lacks(robot, device)) item.FailHere("is there twice");
    robot.without.push_back(device);
    for (auto& [interface, table] : robot.proxies) {
      std::erase_if(table, [&](const auto& entry) { return entry.second == device; });
    }
  }
}

// A proxy of what is not there would be found out when a client asks for it, and not before.
void CheckProxies(ObjectReader& reader, const RobotDef& robot) {
  for (const auto& [interface, table] : robot.proxies) {
    for (const auto& [index, device] : table) {
      if (!Lacks(robot, device)) continue;
      reader.Require("proxies").FailHere(
          fmt::format("has '{}' as {}:{}, and 'without' takes it away", device, interface, index));
    }
  }
}

std::vector<RangerDef> ReadRangers(const Field& field, const RobotModel& model) {
  static const std::vector<std::string> taken = {
      "pose", "odometry", "hokuyo", "ir", "sonar", "properties", "motion", "waypoint", "pen"};
  std::vector<RangerDef> rangers;
  for (const Field& item : field.Items()) {
    ObjectReader reader(item);
    RangerDef ranger;
    const Field name = reader.Require("name");
    ranger.name = name.Identifier();
    const bool twice =
        std::find(taken.begin(), taken.end(), ranger.name) != taken.end() ||
        std::any_of(rangers.begin(), rangers.end(),
                    [&ranger](const RangerDef& other) { return other.name == ranger.name; });
    if (twice) {
      name.FailHere(fmt::format("is {}, as is another component of the robot; choose another name",
                                Quoted(ranger.name)));
    }
    if (reader.Has("laser") == reader.Has("ring")) {
      item.FailHere("must have either a 'laser' or a 'ring'");
    }
    if (reader.Has("laser")) {
      ranger.laser = ReadLaser(reader.Require("laser"), model.laser);
    } else {
      const Field ring = reader.Require("ring");
      RingDef delivered = model.sonar;
      ranger.ring = ReadRing(ring, delivered);
      if (!ranger.ring || ranger.ring->mounts.empty()) {
        ring.FailHere("lacks 'poses': where its sensors sit");
      }
    }
    reader.Finish();
    rangers.push_back(std::move(ranger));
  }
  return rangers;
}

// Identifiers with dots between them.
std::string ReadComponentName(const Field& field) {
  const std::string& name = field.Text();
  bool good = !name.empty() && name.size() <= 256 && name.front() != '.' && name.back() != '.' &&
              name.find("..") == std::string::npos;
  for (const char c : name) {
    good = good && (c == '.' || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                    (c >= 'A' && c <= 'Z'));
  }
  if (!good) {
    field.FailHere(fmt::format(
        "is {}, must be letters, digits, '_' and dots between them, 1 to 256", Quoted(name)));
  }
  return name;
}

// Names and values as MORSE's scripts have them; who uses one checks it.
Json ReadProperties(const Field& field) {
  if (!field.value().IsObject()) {
    field.FailHere(fmt::format("must be an object {{...}}, not {}", field.value().TypeName()));
  }
  CheckSettings(field);
  return field.value();
}

OwnServiceDef ReadOwnService(const Field& field) {
  ObjectReader reader(field);
  OwnServiceDef service;
  service.name = reader.Require("name").Identifier();
  if (reader.Has("parameters")) {
    for (const Field& item : reader.Require("parameters").Items()) {
      ObjectReader parameter(item);
      service.parameters.push_back(
          {parameter.Require("name").Identifier(), parameter.Bool("optional", false)});
      parameter.Finish();
    }
  }
  service.asynchronous = reader.Bool("asynchronous", service.asynchronous);
  reader.Finish();
  return service;
}

OwnDef ReadOwn(const Field& field) {
  ObjectReader reader(field);
  OwnDef own;
  own.language = reader.Require("language").Choice(std::vector<std::string>{"python", "c++"});
  own.kind = reader.Require("kind").Choice(std::vector<std::string>{"sensor", "actuator"});
  own.code = reader.Require("code").Text();
  if (reader.Has("path")) {
    for (const Field& item : reader.Require("path").Items()) own.path.push_back(item.Text());
  }
  if (reader.Has("level")) own.level = reader.Require("level").Text();
  if (reader.Has("data")) own.data = ReadProperties(reader.Require("data"));
  if (reader.Has("properties")) own.properties = ReadProperties(reader.Require("properties"));
  for (const auto& [name, value] : own.properties.AsObject()) {
    if (value.IsNumber() || value.IsBool() || value.IsString()) continue;
    reader.Require("properties")
        .FailHere(fmt::format("has {} as {}, must be a number, a text, true or false",
                              value.TypeName(), Quoted(name)));
  }
  if (reader.Has("services")) {
    for (const Field& item : reader.Require("services").Items()) {
      own.services.push_back(ReadOwnService(item));
    }
  }
  reader.Finish();
  return own;
}

OverlayDef ReadOverlay(const Field& field) {
  ObjectReader reader(field);
  OverlayDef overlay;
  overlay.code = reader.Require("code").Text();
  if (reader.Has("path")) {
    for (const Field& item : reader.Require("path").Items()) overlay.path.push_back(item.Text());
  }
  if (reader.Has("settings")) overlay.settings = ReadProperties(reader.Require("settings"));
  if (reader.Has("services")) {
    for (const Field& item : reader.Require("services").Items()) {
      overlay.services.push_back(ReadOwnService(item));
    }
  }
  reader.Finish();
  return overlay;
}

ModifierDef ReadModifier(const Field& field) {
  ObjectReader reader(field);
  ModifierDef modifier;
  modifier.type = reader.Require("type").Choice(ModifierTypes());
  if (reader.Has("settings")) modifier.settings = ReadProperties(reader.Require("settings"));
  reader.Finish();
  return modifier;
}

// Has the settings of a scanner.
bool HasLaser(const ComponentDef& component) {
  return component.type == "LaserScanner" || component.type == "VelodyneRayCast";
}

ComponentDef ReadComponent(const Field& field) {
  ObjectReader reader(field);
  ComponentDef component;
  component.name = ReadComponentName(reader.Require("name"));
  if (reader.Has("own")) {
    component.own = ReadOwn(reader.Require("own"));
    component.type = reader.Require("type").Identifier();
  } else {
    component.type = reader.Require("type").Choice(ComponentTypes());
  }
  component.frequency = reader.Number("frequency", component.frequency, {0.0, 1000.0, true});
  component.position = reader.Vector("position", component.position, kFarthest);
  component.rotation = reader.Vector("rotation", component.rotation, 20.0 * kPi);
  component.stream = reader.Bool("stream", component.stream);
  component.services = reader.Bool("services", component.services);
  if (reader.Has("noise")) {
    if (component.type != "Pose") reader.Require("noise").FailHere("is for a Pose; remove it");
    component.noise = ReadPoseNoise(reader.Require("noise"));
  }
  if (HasLaser(component) && !component.own) {
    LaserDef laser = MorseLaser(30.0, 180.0, 1.0);  // MORSE's own defaults (specs: morse.md B.2)
    laser.frequency = component.frequency;
    laser.position = component.position;
    laser.roll = component.rotation.x;
    laser.pitch = component.rotation.y;
    laser.yaw = component.rotation.z;
    if (reader.Has("laser")) laser = ReadLaser(reader.Require("laser"), laser);
    component.frequency = laser.frequency;
    component.position = laser.position;
    component.rotation = {laser.roll, laser.pitch, laser.yaw};
    component.laser = laser;
  } else if (reader.Has("laser")) {
    reader.Require("laser").FailHere("is for a LaserScanner; remove it");
  }
  if (reader.Has("level")) {
    const std::vector<std::string> levels = LevelsOf(component.type);
    const Field level = reader.Require("level");
    if (levels.empty()) level.FailHere("is for a GPS or an Odometry; remove it");
    component.level = level.Choice(levels);
  }
  if (reader.Has("properties")) component.properties = ReadProperties(reader.Require("properties"));
  if (reader.Has("modifiers")) {
    for (const Field& modifier : reader.Require("modifiers").Items()) {
      component.modifiers.push_back(ReadModifier(modifier));
    }
  }
  if (reader.Has("overlays")) {
    for (const Field& overlay : reader.Require("overlays").Items()) {
      component.overlays.push_back(ReadOverlay(overlay));
    }
  }
  reader.Finish();
  return component;
}

// The level of an Odometry that knows where the robot is, which Player's clients ask for.
bool IsOdometry(const ComponentDef& component) {
  return component.type == "Odometry" && !component.own &&
         (component.level.empty() || component.level == "integrated");
}

// The devices of a robot that has others than those of its type; they are found by Player's clients
// under the first indexes.
void ReadComponents(ObjectReader& reader, RobotDef& robot) {
  for (const char* key : {"front", "laser", "ir", "sonar", "rangers", "proxies"}) {
    if (reader.Has(key)) {
      reader.Require(key).FailHere("belongs to a robot without 'components'; remove one of them");
    }
  }
  std::vector<ComponentDef> components;
  for (const Field& item : reader.Require("components").Items()) {
    ComponentDef component = ReadComponent(item);
    for (const ComponentDef& other : components) {
      if (other.name != component.name) continue;
      item.FailHere(
          fmt::format("is called {}, as is another component of the robot; choose "
                      "another name",
                      Quoted(component.name)));
    }
    components.push_back(std::move(component));
  }
  robot.front = "none";
  robot.proxies.clear();
  for (const ComponentDef& component : components) {
    if (component.own) continue;
    const bool scans = component.type == "LaserScanner";
    if (!scans && component.type != "Pose" && !IsOdometry(component)) continue;
    robot.proxies[scans ? "laser" : "position2d"].emplace(0, component.name);
  }
  robot.components = std::move(components);
}

// One more than that of any box or mesh.
int NextId(const World& world) {
  int next = 1;
  for (const Box& box : world.boxes) next = std::max(next, box.id + 1);
  for (const Mesh& mesh : world.meshes) next = std::max(next, mesh.id + 1);
  return next;
}

// Its shapes come from its file, unless it names the world's meshes that are it.
PropDef ReadProp(const Field& field, World& world) {
  ObjectReader reader(field);
  PropDef prop;
  prop.name = reader.Require("name").Text();
  const Field file = reader.Require("file");
  prop.file = file.Text();
  if (reader.Has("object")) prop.object = reader.Require("object").Text();
  prop.position = reader.Vector("position", prop.position, kFarthest);
  prop.rotation = reader.Vector("rotation", prop.rotation, 20.0 * kPi);
  if (reader.Has("properties")) prop.properties = ReadProperties(reader.Require("properties"));
  PropPlace place;
  place.keep_pose = reader.Bool("keep_pose", false);
  place.scale = ReadScale(reader);
  place.physics = ReadPhysics(reader);
  std::vector<Mesh> own;
  if (reader.Has("shape")) own = ReadShape(reader.Require("shape"));
  const bool named = reader.Has("meshes");
  if (named) {
    for (const Field& item : reader.Require("meshes").Items()) {
      const auto id = static_cast<int>(item.Integer(1, 1000000));
      const bool known = std::any_of(world.meshes.begin(), world.meshes.end(),
                                     [id](const Mesh& mesh) { return mesh.id == id; });
      if (!known) item.FailHere(fmt::format("is {}, which no mesh of the world has as its id", id));
      prop.meshes.push_back(id);
    }
  }
  reader.Finish();
  if (!own.empty()) {
    int id = NextId(world);
    for (Mesh& mesh : PlacedShape(std::move(own), place, prop)) {
      mesh.id = id++;
      mesh.name = IdentifierOf(prop.name);
      prop.meshes.push_back(mesh.id);
      world.meshes.push_back(std::move(mesh));
    }
    return prop;
  }
  if (named || !assets::IsAssetName(prop.file)) return prop;
  try {
    const std::string folder = std::filesystem::path(field.file()).parent_path().string();
    const std::string path = assets::FindAsset(prop.file, folder);
    const assets::AssetScene asset = assets::LoadAsset(path);
    std::vector<Mesh> meshes;
    try {
      meshes = MeshesOfProp(asset, place, NextId(world), prop);
    } catch (const Error& error) {
      throw Error(fmt::format("{}: {}", path, error.what()));
    }
    for (Mesh& mesh : meshes) {
      mesh.name = IdentifierOf(prop.name);  // sensors tell things, not their parts
      world.meshes.push_back(std::move(mesh));
    }
  } catch (const Error& error) {
    file.Fail(error.what());
  }
  return prop;
}

ZoneDef ReadZone(const Field& field) {
  ObjectReader reader(field);
  ZoneDef zone;
  zone.type = reader.Require("type").Text();
  zone.position = reader.Vector("position", zone.position, kFarthest);
  const Vec3 half = reader.Vector("half_size", {1.0, 1.0, 1.0}, kFarthest);
  zone.half_size = {std::fabs(half.x), std::fabs(half.y), std::fabs(half.z)};
  reader.Finish();
  return zone;
}

GeodesyDef ReadGeodesy(const Field& field) {
  ObjectReader reader(field);
  GeodesyDef geodesy;
  geodesy.longitude = reader.Number("longitude", geodesy.longitude, {-180.0, 180.0});
  geodesy.latitude = reader.Number("latitude", geodesy.latitude, {-90.0, 90.0});
  geodesy.altitude = reader.Number("altitude", geodesy.altitude, {-12000.0, 1e6});
  geodesy.angle_against_north =
      reader.Number("angle_against_north", geodesy.angle_against_north, {-360.0, 360.0});
  reader.Finish();
  return geodesy;
}

PhysicsDef ReadPhysics(const Field& field) {
  ObjectReader reader(field);
  PhysicsDef physics;
  physics.gravity = reader.Number("gravity", physics.gravity, {0.0, 1000.0});
  physics.substeps = reader.Integer("substeps", physics.substeps, 1, 20);
  physics.friction = reader.Number("friction", physics.friction, {0.0, 1000.0});
  reader.Finish();
  return physics;
}

// {"file": ...} of a World Magnetic Model, or {"epoch", "terms"}; and "date".
MagneticFieldDef ReadMagneticField(const Field& field) {
  ObjectReader reader(field);
  constexpr Range kYear{1.0, 9999.0};
  constexpr Range kTeslas{-1e6, 1e6};
  MagneticFieldDef magnetic;
  if (reader.Has("file")) {
    const Field file = reader.Require("file");
    try {
      const std::filesystem::path beside = std::filesystem::path(file.file()).parent_path();
      magnetic = LoadMagneticField((beside / file.Text()).string());
    } catch (const Error& error) {
      file.Fail(error.what());
    }
  } else if (reader.Has("terms")) {
    magnetic.epoch = reader.Require("epoch").Number(kYear);
    magnetic.date = magnetic.epoch;
    magnetic.terms.clear();
    for (const Field& item : reader.Require("terms").Items()) {
      const std::vector<Field> parts = item.Items();
      if (parts.size() != 6) item.FailHere("must be [n, m, g, h, g's change, h's change]");
      MagneticTerm term;
      term.degree = static_cast<int>(parts[0].Integer(1, kMostMagneticDegree));
      term.order = static_cast<int>(parts[1].Integer(0, term.degree));
      term.g = parts[2].Number(kTeslas);
      term.h = parts[3].Number(kTeslas);
      term.g_rate = parts[4].Number(kTeslas);
      term.h_rate = parts[5].Number(kTeslas);
      magnetic.terms.push_back(term);
    }
  }
  magnetic.date = reader.Number("date", magnetic.date, kYear);
  reader.Finish();
  return magnetic;
}

// A robot of type Custom says itself what the model of another type would.
void ReadCustom(ObjectReader& reader, RobotDef& robot) {
  robot.body = ReadBody(reader.Require("body"));
  robot.front = reader.Has("laser") ? "laser" : "none";
  if (reader.Has("components")) return;
  robot.front = reader.Choice("front", robot.front, std::vector<std::string>{robot.front});
}

RobotDef ReadRobot(const Field& field, std::size_t number) {
  ObjectReader reader(field);
  RobotDef robot;
  robot.name = number == 0 ? "s1r" : fmt::format("s1r_{}", number + 1);
  if (reader.Has("name")) robot.name = reader.Require("name").Identifier();
  std::vector<std::string> types = RobotTypes();
  types.insert(std::lower_bound(types.begin(), types.end(), kCustom), kCustom);
  robot.type = reader.Choice("type", robot.type, types);
  const bool custom = robot.type == kCustom;
  if (custom) ReadCustom(reader, robot);
  const RobotModel model = ModelOf(robot);
  robot.proxies = model.proxies;
  robot.laser = model.laser;
  robot.pose = reader.Has("pose") ? ReadPose(reader.Require("pose")) : kDefaultPose;
  robot.z = reader.Number("z", robot.z, {-kFarthest, kFarthest});
  robot.color = reader.ReadColor("color", robot.color);
  static const std::vector<std::string> fronts = {"laser", "sensors"};
  const bool own = reader.Has("components");
  if (own) ReadComponents(reader, robot);
  if (!custom && !own) robot.front = reader.Choice("front", robot.front, fronts);
  if (robot.front == "laser" && custom) robot.proxies["laser"][0] = "hokuyo";
  if (robot.front == "sensors") robot.proxies.erase("laser");
  if (reader.Has("ir")) robot.ir = ReadRing(reader.Require("ir"), model.ir);
  if (reader.Has("sonar")) robot.sonar = ReadRing(reader.Require("sonar"), model.sonar);
  if (reader.Has("without")) {
    const Field without = reader.Require("without");
    if (own) without.FailHere("is of no use beside 'components', which lists all there are");
    ReadWithout(without, robot);
  }
  if (reader.Has("proxies")) ReadProxies(reader.Require("proxies"), robot.proxies);
  if (reader.Has("drivers")) ReadDrivers(reader.Require("drivers"), robot.drivers);
  if (reader.Has("laser")) robot.laser = ReadLaser(reader.Require("laser"), robot.laser);
  if (reader.Has("rangers")) robot.rangers = ReadRangers(reader.Require("rangers"), model);
  if (reader.Has("pose_noise")) robot.pose_noise = ReadPoseNoise(reader.Require("pose_noise"));
  if (reader.Has("odometry")) robot.odometry = ReadOdometry(reader.Require("odometry"));
  if (reader.Has("properties")) robot.properties = ReadProperties(reader.Require("properties"));
  CheckProxies(reader, robot);
  if (reader.Has("wear")) {
    const Field wear = reader.Require("wear");
    if (robot.body && robot.body->dynamics) wear.FailHere("is for robots that forces do not move");
    robot.wear = ReadWear(wear);
  }
  robot.services = reader.Bool("services", robot.services);
  if (reader.Has("skills")) {
    for (const Field& item : reader.Require("skills").Items()) {
      robot.skills.push_back(item.Choice(RobotSkills()));
    }
  }
  CheckRings(reader, robot);
  if (!own) CheckModule(reader, robot);
  reader.Finish();
  return robot;
}

std::vector<Vec2> Outline(const RobotDef& robot) {
  std::vector<Vec2> outline;
  const RobotModel* const model = robot.body ? nullptr : &FindRobotModel(robot.type);
  for (const Vec2 corner : model != nullptr ? model->footprint : robot.body->footprint) {
    outline.push_back(Transform(robot.pose, corner));
  }
  return outline;
}

bool IsDynamic(const RobotDef& robot) { return robot.body && robot.body->dynamics; }

// A piece of a mesh that a robot could stand in.
struct MeshPart {
  const Mesh* mesh;
  std::vector<Vec2> outline;
  Vec2 low;  // its bounding box, m
  Vec2 high;
};

// None of a terrain, where it depends on the robot what is in its way, and what overlaps it at the
// start lets it go.
std::vector<MeshPart> PartsOfMeshes(const World& world) {
  std::vector<MeshPart> parts;
  if (world.terrain) return parts;
  for (const Mesh& mesh : world.meshes) {
    for (std::vector<Vec2>& outline : MeshOutlines(mesh)) {
      Vec2 low = outline[0];
      Vec2 high = outline[0];
      for (const Vec2 corner : outline) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
      }
      parts.push_back({&mesh, std::move(outline), low, high});
    }
  }
  return parts;
}

// What is wrong unless the robot stands on the floor, clear of boxes, meshes and of the robots
// before it.
std::string ProblemOfPlace(const Scenario& scenario, const std::vector<MeshPart>& mesh_parts,
                           std::size_t index) {
  const RobotDef& robot = scenario.robots[index];
  if (IsDynamic(robot)) return "";  // it falls to where it stands, and is pushed out of the way
  const std::string who =
      fmt::format("robot '{}' at ({}, {})", robot.name, robot.pose.x, robot.pose.y);
  const std::vector<Vec2> outline = Outline(robot);
  const World& world = scenario.world;
  for (const Vec2 corner : outline) {
    if (world.terrain) break;  // the meshes are the ground, wherever they are
    const Vec2 high = world.high();
    if (corner.x < world.low.x || corner.y < world.low.y || corner.x > high.x ||
        corner.y > high.y) {
      return fmt::format("{} does not stand on the floor of world '{}', {} x {} m; move it", who,
                         world.name, world.size_x, world.size_y);
    }
  }
  for (const Box& box : world.boxes) {
    if (box.raised && box.solid &&
        ConvexOverlap(outline, BoxCorners(box.pose, box.size_x, box.size_y))) {
      return fmt::format("{} overlaps box {} ({}) at ({}, {}); move it{}", who, box.id, box.kind,
                         box.pose.x, box.pose.y, box.dynamic ? " or lower the box" : "");
    }
  }
  double reach = 0.0;
  for (const Vec2 corner : outline) {
    reach =
        std::max({reach, std::fabs(corner.x - robot.pose.x), std::fabs(corner.y - robot.pose.y)});
  }
  for (const MeshPart& part : mesh_parts) {
    if (robot.pose.x + reach < part.low.x || robot.pose.x - reach > part.high.x ||
        robot.pose.y + reach < part.low.y || robot.pose.y - reach > part.high.y) {
      continue;
    }
    if (ConvexOverlap(outline, part.outline)) {
      const Mesh& mesh = *part.mesh;
      return fmt::format("{} overlaps mesh {}{}; move it", who, mesh.id,
                         mesh.name.empty() ? "" : " (" + mesh.name + ")");
    }
  }
  for (std::size_t i = 0; i < index; ++i) {
    const RobotDef& other = scenario.robots[i];
    if (!IsDynamic(other) && ConvexOverlap(outline, Outline(other))) {
      return fmt::format("{} overlaps robot '{}' at ({}, {}); move one of them", who, other.name,
                         other.pose.x, other.pose.y);
    }
  }
  return "";
}

void ReadRobots(const Field& field, Scenario& scenario) {
  const std::vector<Field> items = field.Items();
  const std::vector<MeshPart> mesh_parts = PartsOfMeshes(scenario.world);
  for (std::size_t i = 0; i < items.size(); ++i) {
    RobotDef robot = ReadRobot(items[i], i);
    for (std::size_t k = 0; k < i; ++k) {
      if (scenario.robots[k].name != robot.name) continue;
      items[i].Fail(
          fmt::format("two robots are called '{}', the first on line {}; give this one "
                      "another 'name'",
                      robot.name, items[k].line()));
    }
    scenario.robots.push_back(std::move(robot));
    const std::string problem = ProblemOfPlace(scenario, mesh_parts, i);
    if (!problem.empty()) items[i].Fail(problem);
  }
}

CanvasDef ReadCanvas(const Field& field) {
  static const std::vector<std::string> modes = {"ground", "minimap", "fullscreen"};
  ObjectReader reader(field);
  CanvasDef canvas;
  canvas.width = reader.Integer("width", canvas.width, 1, 4096);
  canvas.height = reader.Integer("height", canvas.height, 1, 4096);
  canvas.alpha = reader.Number("alpha", canvas.alpha, {0.0, 1.0});
  canvas.mode = reader.Choice("mode", canvas.mode, modes);
  canvas.mode_switching = reader.Bool("mode_switching", canvas.mode_switching);
  reader.Finish();
  return canvas;
}

CameraDef ReadCamera(const Field& field) {
  ObjectReader reader(field);
  CameraDef camera;
  camera.position = reader.Vector("position", camera.position, kFarthest);
  camera.rotation = reader.Vector("rotation", camera.rotation, 20.0 * kPi);
  reader.Finish();
  return camera;
}

TimeDef ReadTime(const Field& field) {
  // The last two are MORSE's names: BestEffort keeps to real time, FixedSimulationStep does not
  // wait for it (specs: morse.md E, Environment.set_time_strategy).
  static const std::vector<std::string> strategies = {"realtime", "lockstep", "max", "best_effort",
                                                      "fixed_simulation_step"};
  ObjectReader reader(field);
  TimeDef time;
  time.frequency = reader.Number("frequency", time.frequency, {1.0, 1000.0});
  time.strategy = reader.Choice("strategy", time.strategy, strategies);
  if (time.strategy == "best_effort") time.strategy = "realtime";
  if (time.strategy == "fixed_simulation_step") time.strategy = "max";
  time.factor = reader.Number("factor", time.factor, {0.001, 1000.0});
  // A read brings what a tick has sensed, so there are at most as many as ticks.
  time.read_frequency = reader.Number(
      "read_frequency", std::min(time.read_frequency, time.frequency), {0.01, time.frequency});
  time.end = reader.Number("end", time.end, {0.0, 1e9});
  time.sync_port = reader.Integer("sync_port", time.sync_port, 0, 65535);
  reader.Finish();
  return time;
}

// Every robot is simulated by one node, and by one only.
MultinodeDef ReadNodes(const Field& field, const Scenario& scenario) {
  ObjectReader reader(field);
  MultinodeDef multinode;
  if (reader.Has("server")) multinode.server = reader.Require("server").Text();
  multinode.port = reader.Integer("port", multinode.port, 1, 65535);
  const Field nodes = reader.Require("nodes");
  std::vector<std::string> missing;
  for (const RobotDef& robot : scenario.robots) missing.push_back(robot.name);
  ObjectReader names(nodes);
  for (const auto& member : nodes.value().AsObject()) {
    std::vector<std::string>& robots = multinode.nodes[member.first];
    for (const Field& item : names.Require(member.first).Items()) {
      const auto found = std::find(missing.begin(), missing.end(), item.Text());
      if (found == missing.end()) {
        item.FailHere(
            fmt::format("must be a robot that no other node has, not {}", Quoted(item.Text())));
      }
      missing.erase(found);
      robots.push_back(item.Text());
    }
  }
  if (multinode.nodes.empty()) nodes.FailHere("must name the nodes and their robots");
  if (!missing.empty()) nodes.FailHere("gives no node the robot " + Quoted(missing.front()));
  reader.Finish();
  return multinode;
}

// What the section says of robots must be true of them.
void ReadPlayer(const Field& field, Scenario& scenario) {
  PlayerSetup setup = ReadPlayerSetup(field);
  std::vector<std::string> names;
  for (const RobotDef& robot : scenario.robots) names.push_back(robot.name);
  for (const PlayerDevice& device : setup.devices) {
    if (device.robot.empty()) continue;
    const auto found = std::find(names.begin(), names.end(), device.robot);
    if (found == names.end()) {
      field.FailHere(fmt::format("serves {}:{} by robot {}, which there is none of{}",
                                 device.interface, device.index, Quoted(device.robot),
                                 DidYouMean(device.robot, names)));
    }
    if (device.interface == "graphics2d") continue;  // drawn on the floor: no component has it
    const RobotDef& robot =
        scenario.robots[static_cast<std::size_t>(std::distance(names.begin(), found))];
    const std::vector<std::string> known = DevicesFor(robot, device.interface);
    if (std::find(known.begin(), known.end(), device.device) == known.end()) {
      field.FailHere(fmt::format("serves {}:{} by {} of robot {}, must be {}", device.interface,
                                 device.index, Quoted(device.device), Quoted(device.robot),
                                 known.empty() ? "left out: it has nothing to serve it by"
                                               : "by one of " + Listed(known)));
    }
  }
  scenario.player = std::move(setup);
}

Scenario ReadScenario(const Json& json, const std::string& file) {
  Scenario scenario;
  scenario.name = std::filesystem::path(file).stem().string();
  ObjectReader reader(Field(json, "", file));
  if (reader.Has("world")) {
    scenario.world = ReadWorldChoice(reader.Require("world"), scenario.props);
  } else {
    const Json world = Json::Parse(kDefaultWorld);
    scenario.world = ReadWorldChoice(Field(world, "world", file), scenario.props);
  }
  if (reader.Has("environment")) scenario.environment = reader.Require("environment").Text();
  if (reader.Has("props")) {
    for (const Field& prop : reader.Require("props").Items()) {
      scenario.props.push_back(ReadProp(prop, scenario.world));
    }
  }
  if (reader.Has("zones")) {
    for (const Field& zone : reader.Require("zones").Items()) {
      scenario.zones.push_back(ReadZone(zone));
    }
  }
  if (reader.Has("geodesy")) scenario.geodesy = ReadGeodesy(reader.Require("geodesy"));
  if (reader.Has("physics")) scenario.physics = ReadPhysics(reader.Require("physics"));
  if (reader.Has("magnetic_field")) {
    scenario.magnetic_field = ReadMagneticField(reader.Require("magnetic_field"));
  }
  if (reader.Has("obstacles")) {
    scenario.obstacles = ReadObstacles(reader.Require("obstacles"), scenario.world);
  }
  if (reader.Has("robots")) {
    ReadRobots(reader.Require("robots"), scenario);
  } else {
    const Json robots = Json::Parse(kDefaultRobots);
    ReadRobots(Field(robots, "robots", file), scenario);
  }
  if (reader.Has("canvas")) scenario.canvas = ReadCanvas(reader.Require("canvas"));
  if (reader.Has("camera")) scenario.camera = ReadCamera(reader.Require("camera"));
  if (reader.Has("time")) scenario.time = ReadTime(reader.Require("time"));
  if (reader.Has("seed")) {
    scenario.seed = static_cast<std::uint64_t>(reader.Require("seed").Integer(0, kMostSeed));
  }
  if (reader.Has("player")) ReadPlayer(reader.Require("player"), scenario);
  if (reader.Has("multinode")) {
    scenario.multinode = ReadNodes(reader.Require("multinode"), scenario);
  }
  reader.Finish();
  return scenario;
}

Json LaserToJson(const LaserDef& laser) {
  return Json::Object{{"position", VectorToJson(laser.position)},
                      {"roll", laser.roll},
                      {"pitch", laser.pitch},
                      {"yaw", laser.yaw},
                      {"frequency", laser.frequency},
                      {"scan_window_deg", laser.scan_window_deg},
                      {"resolution_deg", laser.resolution_deg},
                      {"range", laser.range},
                      {"range_std", laser.range_std},
                      {"layers", laser.layers},
                      {"layer_separation", laser.layer_separation},
                      {"layer_offset", laser.layer_offset},
                      {"visible_arc", laser.visible_arc},
                      {"samples", laser.samples}};
}

Json RingToJson(const RingDef& ring) {
  Json::Object object = {{"frequency", ring.frequency},
                         {"min_range", ring.min_range},
                         {"range", ring.range},
                         {"cone_deg", ring.cone_deg}};
  if (!ring.mounts.empty()) {
    Json::Array poses;
    for (const RingMount& mount : ring.mounts) {
      const Vec3& at = mount.position;
      poses.emplace_back(Json::Array{at.x, at.y, at.z, mount.yaw});
    }
    object.emplace_back("poses", std::move(poses));
  }
  return object;
}

Json OutlineToJson(const std::vector<Vec2>& outline) {
  Json::Array corners;
  for (const Vec2 corner : outline) corners.emplace_back(Json::Array{corner.x, corner.y});
  return corners;
}

Json DynamicsToJson(const DynamicsDef& def) {
  Json::Object object = {{"kind", def.kind},
                         {"bottom", def.bottom},
                         {"top", def.top},
                         {"friction", def.friction},
                         {"linear_damping", def.linear_damping},
                         {"angular_damping", def.angular_damping},
                         {"gravity", def.gravity},
                         {"ground", def.ground},
                         {"roll", def.roll},
                         {"pitch", def.pitch},
                         {"turning_track", def.turning_track}};
  if (!def.wheels.empty()) {
    Json::Array wheels;
    for (const WheelDef& wheel : def.wheels) {
      wheels.emplace_back(Json::Object{{"position", VectorToJson(wheel.position)},
                                       {"radius", wheel.radius},
                                       {"width", wheel.width},
                                       {"mass", wheel.mass},
                                       {"friction", wheel.friction},
                                       {"linear_damping", wheel.linear_damping},
                                       {"angular_damping", wheel.angular_damping},
                                       {"drive", wheel.drive}});
    }
    object.emplace_back("wheels", std::move(wheels));
  }
  if (def.vehicle) {
    const VehicleDef& vehicle = *def.vehicle;
    object.emplace_back("vehicle", Json::Object{{"front", vehicle.front},
                                                {"rear", vehicle.rear},
                                                {"half_track", vehicle.half_track},
                                                {"height", vehicle.height},
                                                {"wheel_radius", vehicle.wheel_radius},
                                                {"rest_length", vehicle.rest_length},
                                                {"stiffness", vehicle.stiffness},
                                                {"damping", vehicle.damping},
                                                {"compression", vehicle.compression},
                                                {"friction", vehicle.friction},
                                                {"roll_influence", vehicle.roll_influence}});
  }
  return object;
}

Json BodyToJson(const BodyDef& body) {
  Json::Array hull;
  for (const HullPart& part : body.hull) {
    hull.emplace_back(Json::Object{
        {"outline", OutlineToJson(part.outline)}, {"bottom", part.bottom}, {"top", part.top}});
  }
  Json::Object object = {{"footprint", OutlineToJson(body.footprint)},
                         {"hull", std::move(hull)},
                         {"mass", body.mass},
                         {"drive", body.drive},
                         {"wheelbase", body.wheelbase},
                         {"max_speed", body.max_speed},
                         {"max_side_speed", body.max_side_speed},
                         {"max_turn_rate", body.max_turn_rate},
                         {"origin_height", body.origin_height}};
  if (body.dynamics) object.emplace_back("dynamics", DynamicsToJson(*body.dynamics));
  if (body.flies) object.emplace_back("flies", true);
  if (!body.shape.empty()) object.emplace_back("shape", ShapeToJson(body.shape));
  return object;
}

Json ServicesToJson(const std::vector<OwnServiceDef>& defs) {
  Json::Array services;
  for (const OwnServiceDef& service : defs) {
    Json::Array parameters;
    for (const OwnServiceDef::Parameter& parameter : service.parameters) {
      parameters.push_back(
          Json::Object{{"name", parameter.name}, {"optional", parameter.optional}});
    }
    services.push_back(Json::Object{{"name", service.name},
                                    {"parameters", std::move(parameters)},
                                    {"asynchronous", service.asynchronous}});
  }
  return Json(std::move(services));
}

void AddTexts(Json::Object& object, const char* key, const std::vector<std::string>& texts) {
  if (!texts.empty()) object.emplace_back(key, Json::Array(texts.begin(), texts.end()));
}

Json OwnToJson(const OwnDef& own) {
  Json::Object object = {{"language", own.language}, {"kind", own.kind}, {"code", own.code}};
  AddTexts(object, "path", own.path);
  if (!own.level.empty()) object.emplace_back("level", own.level);
  object.emplace_back("data", own.data);
  object.emplace_back("properties", own.properties);
  object.emplace_back("services", ServicesToJson(own.services));
  return object;
}

Json OverlayToJson(const OverlayDef& overlay) {
  Json::Object object = {{"code", overlay.code}};
  AddTexts(object, "path", overlay.path);
  if (!overlay.settings.AsObject().empty()) object.emplace_back("settings", overlay.settings);
  object.emplace_back("services", ServicesToJson(overlay.services));
  return object;
}

void AddProperties(Json::Object& object, const Json& properties) {
  if (!properties.AsObject().empty()) object.emplace_back("properties", properties);
}

Json ComponentToJson(const ComponentDef& component) {
  Json::Object object = {{"name", component.name},
                         {"type", component.type},
                         {"frequency", component.frequency},
                         {"position", VectorToJson(component.position)},
                         {"rotation", VectorToJson(component.rotation)},
                         {"stream", component.stream},
                         {"services", component.services}};
  if (component.own) object.emplace_back("own", OwnToJson(*component.own));
  if (component.type == "Pose" && !component.own) {
    object.emplace_back("noise", Json::Object{{"pos_std", component.noise.pos_std},
                                              {"rot_std", component.noise.rot_std}});
  }
  if (HasLaser(component) && !component.own) {
    object.emplace_back("laser", LaserToJson(component.laser));
  }
  if (!component.level.empty()) object.emplace_back("level", component.level);
  AddProperties(object, component.properties);
  if (!component.modifiers.empty()) {
    Json::Array modifiers;
    for (const ModifierDef& modifier : component.modifiers) {
      modifiers.emplace_back(
          Json::Object{{"type", modifier.type}, {"settings", modifier.settings}});
    }
    object.emplace_back("modifiers", std::move(modifiers));
  }
  if (!component.overlays.empty()) {
    Json::Array overlays;
    for (const OverlayDef& overlay : component.overlays) {
      overlays.push_back(OverlayToJson(overlay));
    }
    object.emplace_back("overlays", std::move(overlays));
  }
  return object;
}

Json PropToJson(const PropDef& prop) {
  Json::Object object = {{"name", prop.name},
                         {"file", prop.file},
                         {"object", prop.object},
                         {"position", VectorToJson(prop.position)},
                         {"rotation", VectorToJson(prop.rotation)}};
  if (!prop.meshes.empty()) {
    object.emplace_back("meshes", Json::Array(prop.meshes.begin(), prop.meshes.end()));
  }
  AddProperties(object, prop.properties);
  return object;
}

Json ZoneToJson(const ZoneDef& zone) {
  return Json::Object{{"type", zone.type},
                      {"position", VectorToJson(zone.position)},
                      {"half_size", VectorToJson(zone.half_size)}};
}

Json MagneticFieldToJson(const MagneticFieldDef& field) {
  Json::Array terms;
  for (const MagneticTerm& term : field.terms) {
    terms.emplace_back(
        Json::Array{term.degree, term.order, term.g, term.h, term.g_rate, term.h_rate});
  }
  return Json::Object{{"epoch", field.epoch}, {"date", field.date}, {"terms", std::move(terms)}};
}

Json GeodesyToJson(const GeodesyDef& geodesy) {
  return Json::Object{{"longitude", geodesy.longitude},
                      {"latitude", geodesy.latitude},
                      {"altitude", geodesy.altitude},
                      {"angle_against_north", geodesy.angle_against_north}};
}

Json MultinodeToJson(const MultinodeDef& multinode) {
  Json nodes(Json::Object{});
  for (const auto& [name, robots] : multinode.nodes) {
    nodes.Set(name, Json::Array(robots.begin(), robots.end()));
  }
  return Json::Object{
      {"server", multinode.server}, {"port", multinode.port}, {"nodes", std::move(nodes)}};
}

Json RobotToJson(const RobotDef& robot) {
  Json::Object proxies;
  for (const auto& [interface, table] : robot.proxies) {
    Json::Object indexes;
    for (const auto& [index, device] : table) indexes.emplace_back(std::to_string(index), device);
    proxies.emplace_back(interface, std::move(indexes));
  }
  Json::Object drivers;
  for (const auto& [name, settings] : robot.drivers) drivers.emplace_back(name, settings);
  Json::Object object = {{"name", robot.name},
                         {"type", robot.type},
                         {"pose", PoseToJson(robot.pose)},
                         {"color", ColorText(robot.color)},
                         {"drivers", std::move(drivers)},
                         {"pose_noise", Json::Object{{"pos_std", robot.pose_noise.pos_std},
                                                     {"rot_std", robot.pose_noise.rot_std}}}};
  if (robot.components) {
    Json::Array components;
    for (const ComponentDef& component : *robot.components) {
      components.push_back(ComponentToJson(component));
    }
    object.emplace_back("components", std::move(components));
  } else {
    object.emplace_back("proxies", std::move(proxies));
    object.emplace_back("front", robot.front);
  }
  if (robot.body) object.emplace_back("body", BodyToJson(*robot.body));
  if (robot.z != 0.0) object.emplace_back("z", robot.z);
  AddProperties(object, robot.properties);
  if (robot.services) object.emplace_back("services", true);
  AddTexts(object, "skills", robot.skills);
  const OdometryDef& odometry = robot.odometry;
  object.emplace_back("odometry", Json::Object{{"start", PoseToJson(odometry.start)},
                                               {"error", VectorToJson(odometry.error)}});
  if (robot.wear != WearDef{}) {
    object.emplace_back("wear",
                        Json::Object{{"pull", robot.wear.pull}, {"turn_lag", robot.wear.turn_lag}});
  }
  AddTexts(object, "without", robot.without);
  if (robot.front == "laser") object.emplace_back("laser", LaserToJson(robot.laser));
  if (robot.ir) object.emplace_back("ir", RingToJson(*robot.ir));
  if (robot.sonar) object.emplace_back("sonar", RingToJson(*robot.sonar));
  if (!robot.rangers.empty()) {
    Json::Array rangers;
    for (const RangerDef& ranger : robot.rangers) {
      rangers.emplace_back(
          Json::Object{{"name", ranger.name},
                       {ranger.laser ? "laser" : "ring",
                        ranger.laser ? LaserToJson(*ranger.laser) : RingToJson(*ranger.ring)}});
    }
    object.emplace_back("rangers", std::move(rangers));
  }
  return object;
}

}  // namespace

Scenario ParseScenario(const std::string& text, const std::string& file) {
  try {
    return ReadScenario(Json::Parse(text), file);
  } catch (const JsonError& error) {
    throw Error(
        fmt::format("{}:{}: {} (column {})", file, error.line(), error.reason(), error.column()));
  }
}

Scenario LoadScenario(const std::string& file) { return ParseScenario(ReadFile(file), file); }

std::vector<std::string> PlaceProblems(const Scenario& scenario) {
  const std::vector<MeshPart> mesh_parts = PartsOfMeshes(scenario.world);
  std::vector<std::string> problems;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    problems.push_back(ProblemOfPlace(scenario, mesh_parts, i));
  }
  return problems;
}

const std::vector<std::string>& RemovableDevices() {
  static const std::vector<std::string> devices = {"answers", "odometry", "pen", "pose",
                                                   "waypoint"};
  return devices;
}

const std::vector<std::string>& RobotSkills() {
  static const std::vector<std::string> skills = {"grasp", "heal"};
  return skills;
}

const std::vector<std::string>& ComponentTypes() {
  static const std::vector<std::string> types = {"Accelerometer",
                                                 "Airspeed",
                                                 "Arucomarker",
                                                 "Attitude",
                                                 "Barometer",
                                                 "Battery",
                                                 "Clock",
                                                 "Collision",
                                                 "CompoundSensor",
                                                 "Destination",
                                                 "Drag",
                                                 "ExternalForce",
                                                 "ForceTorque",
                                                 "GPS",
                                                 "Gripper",
                                                 "Gyroscope",
                                                 "IMU",
                                                 "Keyboard",
                                                 "LaserScanner",
                                                 "Light",
                                                 "Magnetometer",
                                                 "MotionVW",
                                                 "MotionVWDiff",
                                                 "MotionXYW",
                                                 "Odometry",
                                                 "Orientation",
                                                 "PTU",
                                                 "PTUPosture",
                                                 "Pen",
                                                 "Pose",
                                                 "Proximity",
                                                 "QuadrotorDynamicControl",
                                                 "RadarAltimeter",
                                                 "RobotProperties",
                                                 "RotorcraftAttitude",
                                                 "RotorcraftVelocity",
                                                 "RotorcraftWaypoint",
                                                 "SearchAndRescue",
                                                 "SemanticCamera",
                                                 "Sound",
                                                 "StabilizedQuadrotor",
                                                 "SteerForce",
                                                 "Teleport",
                                                 "Thermometer",
                                                 "Velocity",
                                                 "VelodyneRayCast",
                                                 "Waypoint"};
  return types;
}

const std::vector<std::string>& ModifierTypes() {
  static const std::vector<std::string> types = {"ECEF",          "IMUNoise",   "NED",
                                                 "OdometryNoise", "PoseNoise",  "UTM",
                                                 "feet",          "geocentric", "geodetic"};
  return types;
}

std::vector<std::string> LevelsOf(const std::string& type) {
  if (type == "GPS") return {"simple", "raw", "extended"};
  if (type == "Odometry") return {"integrated", "raw", "differential"};
  return {};
}

std::vector<std::string> DevicesFor(const RobotDef& robot, const std::string& interface) {
  if (robot.components) {
    std::vector<std::string> devices;
    for (const ComponentDef& component : *robot.components) {
      if (component.own) continue;
      const bool serves =
          component.type == "LaserScanner"
              ? interface == "laser" || interface == "ranger"
              : interface == "position2d" && (component.type == "Pose" || IsOdometry(component));
      if (serves) devices.push_back(component.name);
    }
    return devices;
  }
  std::vector<std::string> devices;
  if (interface == "position2d") {
    for (const char* device : {"pose", "odometry"}) {
      if (!Lacks(robot, device)) devices.emplace_back(device);
    }
    return devices;
  }
  const bool lasers = interface == "laser" || interface == "ranger";
  const bool rings = interface == "sonar" || interface == "ir" || interface == "ranger";
  if (lasers && robot.front == "laser") devices.emplace_back("hokuyo");
  if (rings && robot.ir) devices.emplace_back("ir");
  if (rings && robot.sonar) devices.emplace_back("sonar");
  for (const RangerDef& ranger : robot.rangers) {
    if (ranger.laser ? lasers : rings) devices.push_back(ranger.name);
  }
  return devices;
}

Json ToJson(const Scenario& scenario) {
  Json::Array robots;
  for (const RobotDef& robot : scenario.robots) robots.push_back(RobotToJson(robot));
  const CanvasDef& canvas = scenario.canvas;
  const TimeDef& time = scenario.time;
  Json::Object object = {
      {"world", WorldToJson(scenario.world)},
      {"obstacles", ObstaclesToJson(scenario.obstacles, scenario.world)},
      {"robots", std::move(robots)},
      {"canvas", Json::Object{{"width", canvas.width},
                              {"height", canvas.height},
                              {"alpha", canvas.alpha},
                              {"mode", canvas.mode},
                              {"mode_switching", canvas.mode_switching}}},
      {"camera", Json::Object{{"position", VectorToJson(scenario.camera.position)},
                              {"rotation", VectorToJson(scenario.camera.rotation)}}},
      {"time", Json::Object{{"frequency", time.frequency},
                            {"strategy", time.strategy},
                            {"factor", time.factor},
                            {"read_frequency", time.read_frequency},
                            {"end", time.end}}},
      {"seed", static_cast<std::int64_t>(scenario.seed)}};
  if (time.sync_port != 0) {
    const auto at = std::find_if(object.begin(), object.end(),
                                 [](const Json::Member& member) { return member.first == "time"; });
    at->second.Set("sync_port", time.sync_port);
  }
  if (!scenario.environment.empty()) object.emplace_back("environment", scenario.environment);
  if (!scenario.props.empty()) {
    Json::Array props;
    for (const PropDef& prop : scenario.props) props.push_back(PropToJson(prop));
    object.emplace_back("props", std::move(props));
  }
  if (!scenario.zones.empty()) {
    Json::Array zones;
    for (const ZoneDef& zone : scenario.zones) zones.push_back(ZoneToJson(zone));
    object.emplace_back("zones", std::move(zones));
  }
  if (scenario.geodesy) object.emplace_back("geodesy", GeodesyToJson(*scenario.geodesy));
  if (scenario.physics) {
    object.emplace_back("physics", Json::Object{{"gravity", scenario.physics->gravity},
                                                {"substeps", scenario.physics->substeps},
                                                {"friction", scenario.physics->friction}});
  }
  if (scenario.magnetic_field != MagneticFieldDef{}) {
    object.emplace_back("magnetic_field", MagneticFieldToJson(scenario.magnetic_field));
  }
  if (scenario.player) object.emplace_back("player", PlayerSetupToJson(*scenario.player));
  if (scenario.multinode) object.emplace_back("multinode", MultinodeToJson(*scenario.multinode));
  return object;
}

}  // namespace ccmorse::scene
