#include "render/simulation_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/euler.h"
#include "base/nearest_name.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "render/vector_math.h"
#include "scene/mesh.h"
#include "scene/robots.h"
#include "sim/sensors/laser_scanner.h"

namespace ccmorse::render {
namespace {

constexpr double kBevel = 0.004;       // m
constexpr double kGroundBelow = 0.02;  // m under the floor
constexpr Color kLaserColor{30, 139, 255};
constexpr double kLaserOpacity = 0.22;  // seen on a white floor, and several leave it visible
// What lamps of energy 1 do: a white floor under the sun, the sky and four spots of SyRoTek's is
// nearly white, and the sun's shadows are seen beside what the others light.
constexpr double kSunIrradiance = 1.0;
constexpr double kSpotIntensity = 0.4;
constexpr double kSky = 0.2;

// The materials that robots share.
struct Parts {
  int chassis, rubber, rim, scanner;
};

Vec3 OnRobot(const Pose2& pose, const Vec3& at) {
  const Vec2 placed = Transform(pose, {at.x, at.y});
  return {placed.x, placed.y, at.z};
}

void AddWheels(const sim::Robot& robot, const Parts& parts, PictureScene& scene) {
  const scene::RobotModel& model = robot.model();
  for (const double side : {1.0, -1.0}) {
    const double y = side * model.wheel_track / 2.0;
    const double half = model.wheel_width / 2.0;
    const double r = model.wheel_radius;
    const auto at = [&](double along) { return OnRobot(robot.pose(), {0.0, y + along, r}); };
    scene.AddCylinder(at(-half), at(half), r, parts.rubber);
    scene.AddCylinder(at(side * half), at(side * (half + 0.001)), 0.6 * r, parts.rim);
  }
}

// `place` is where a point of the mesh's frame lies in the world.
template <typename Place>
void AddTriangles(const scene::Mesh& mesh, const Place& place, PictureScene& scene) {
  const int material = scene.AddMaterial({Linear(mesh.color), 0.04, 0.6, false});
  std::vector<int> of_palette;
  for (const Color& color : mesh.palette) {
    of_palette.push_back(scene.AddMaterial({Linear(color), 0.04, 0.6, false}));
  }
  const std::vector<Vec3> vertices = scene::PlacedVertices(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = place(vertices[static_cast<std::size_t>(mesh.triangles[i][k])]);
    }
    const int own =
        mesh.color_of.empty() ? material : of_palette[static_cast<std::size_t>(mesh.color_of[i])];
    scene.AddTriangle(corners, own);
  }
}

// The robot's own shape; false where it has none.
bool AddShape(const sim::Robot& robot, PictureScene& scene) {
  if (!robot.def().body || robot.def().body->shape.empty()) return false;
  const Rotation rotation = robot.rotation();
  const auto place = [&](const Vec3& v) { return robot.position() + Rotate(rotation, v); };
  for (const scene::Mesh& mesh : robot.def().body->shape) AddTriangles(mesh, place, scene);
  return true;
}

void AddRobot(const sim::Robot& robot, const Parts& parts, const PictureOptions& options,
              PictureScene& scene) {
  const scene::RobotModel& model = robot.model();
  const int body = scene.AddMaterial({Linear(robot.def().color), 0.05, 0.28, false});
  const double ground = robot.lift();
  const bool shown = AddShape(robot, scene);
  for (std::size_t i = 0; i < model.hull.size() && !shown; ++i) {
    const scene::HullPart& part = model.hull[i];
    // Where there are several the lowest is the chassis, dark; the upper ones wear the colour.
    const bool chassis = model.hull.size() > 1 && i == 0;
    scene.AddPrism(robot.pose(), part.outline,
                   ground + std::max(part.bottom, model.ground_clearance), ground + part.top,
                   kBevel, chassis ? parts.chassis : body);
  }
  if (model.wheel_radius > 0.0) AddWheels(robot, parts, scene);
  for (const auto& component : robot.components()) {
    const auto* const laser = dynamic_cast<const sim::LaserScanner*>(component.get());
    if (laser == nullptr) continue;
    const auto at = [&](double up) {
      const Vec3 mount = laser->mount() + Vec3{0, 0, up};
      if (robot.tilted()) return robot.position() + Rotate(robot.rotation(), mount);
      return OnRobot(robot.pose(), mount + Vec3{0, 0, ground + model.origin_height});
    };
    scene.AddCylinder(at(-0.022), at(0.004), 0.026, parts.scanner);
    scene.AddCylinder(at(0.004), at(0.022), 0.023, parts.scanner);
    const sim::BeamFan& fan = laser->fan();
    if (!options.lasers || !fan.upright() || robot.tilted() || fan.count() < 2 ||
        laser->ranges().empty())
      continue;
    const Vec3 first = fan.Direction(0);
    const Vec3 second = fan.Direction(1);
    Fan film;
    film.origin = at(0.0);
    film.yaw = robot.pose().yaw + ToEuler(laser->mount_rotation()).z;
    film.first = std::atan2(first.y, first.x);
    film.step = std::remainder(std::atan2(second.y, second.x) - film.first, 2.0 * kPi);
    film.ranges = laser->ranges();
    film.color = Linear(kLaserColor);
    film.opacity = kLaserOpacity;
    if (film.step > 0.0) scene.fans.push_back(std::move(film));
  }
}

// `thing`: the passive object that it is a part of, nullptr where it is none.
void AddMesh(const scene::Mesh& mesh, const sim::SceneObject* thing, PictureScene& scene) {
  if (!mesh.drawn) return;
  if (thing == nullptr || !thing->HasMoved()) {
    AddTriangles(
        mesh, [](const Vec3& v) { return v; }, scene);
    return;
  }
  const Vec3 from = thing->start.position;
  const Vec3& euler = thing->start.rotation;
  const Rotation before = FromEuler(euler.x, euler.y, euler.z);
  const Vec3 to = thing->WorldPosition();
  const Rotation now = thing->WorldRotation();
  AddTriangles(
      mesh, [&](const Vec3& v) { return to + Rotate(now, RotateBack(before, v - from)); }, scene);
}

const sim::SceneObject* ThingOf(const scene::Mesh& mesh, const sim::World& world) {
  for (const sim::SceneObject& object : world.objects().all()) {
    const std::vector<int>& parts = object.start.meshes;
    if (std::find(parts.begin(), parts.end(), mesh.id) != parts.end()) return &object;
  }
  return nullptr;
}

void AddLamps(const scene::World& world, PictureScene& scene) {
  scene.sky = kSky;
  for (const scene::Light& light : world.lights) {
    if (light.kind == "sun") {
      scene.suns.push_back({Unit(light.position), kSunIrradiance * light.energy, 0.03});
    } else {
      scene.spots.push_back({light.position, kSpotIntensity * light.energy, 0.1});
    }
  }
  // A world that says nothing is lit from behind the left shoulder.
  if (world.lights.empty()) scene.suns.push_back({Unit({-1.0, -1.5, 3.0}), kSunIrradiance, 0.03});
}

void AddRectangle(Vec2 low, Vec2 high, double z, int material, PictureScene& scene) {
  const Vec3 a{low.x, low.y, z};
  const Vec3 b{high.x, low.y, z};
  const Vec3 c{high.x, high.y, z};
  const Vec3 d{low.x, high.y, z};
  scene.AddTriangle({a, b, c}, material);
  scene.AddTriangle({a, c, d}, material);
}

void AddFloor(const sim::Simulation& simulation, bool canvas_shown, PictureScene& scene) {
  const scene::World& world = simulation.world().scene();
  const Vec3 floor = Linear(world.floor);
  // Nothing is whiter than paper.
  const auto paper = [](const Vec3& color) { return 0.82 * color; };
  scene.floor_material = scene.AddMaterial({paper(floor), 0.03, 0.5, false});
  // A table that is darker than the floor, so that the arena stands out.
  scene.ground_material = scene.AddMaterial({{0.20, 0.22, 0.25}, 0.0, 0.9, false});
  const Vec2 low = world.low;
  const Vec2 high = world.high();
  double table = -kGroundBelow;
  if (world.has_floor) {
    // A slab, so that the floor has an edge.
    const std::vector<Vec2> outline = {low, {high.x, low.y}, high, {low.x, high.y}};
    scene.AddPrism({}, outline, -kGroundBelow, 0.0, 0.0, scene.floor_material);
  } else {
    for (const scene::Mesh& mesh : world.meshes) {
      for (const Vec3& vertex : scene::PlacedVertices(mesh)) {
        table = std::min(table, vertex.z - kGroundBelow);
      }
    }
  }
  const double size = std::max(world.size_x, world.size_y);
  scene.middle = world.middle();
  scene.fade_from = 1.0 * size;
  const Vec2 half{2.1 * size, 2.1 * size};
  AddRectangle(scene.middle - half, scene.middle + half, table, scene.ground_material, scene);
  if (!canvas_shown) return;
  const sim::Canvas& canvas = simulation.canvas();
  const double alpha = simulation.scenario().canvas.alpha;
  scene.floor_color = [&canvas, alpha, floor, low, paper](double x, double y) {
    const auto column = static_cast<int>(std::floor((x - low.x) / canvas.cell_size()));
    const auto row = static_cast<int>(std::floor((y - low.y) / canvas.cell_size()));
    if (!canvas.Contains(column, row) || !canvas.IsDrawn(column, row)) return paper(floor);
    return paper(alpha * Linear(canvas.GetPixel(column, row)) + (1.0 - alpha) * floor);
  };
}

// m above the floor, of a robot's body, as it began: 0 unless it is in the air.
double FootOf(const scene::RobotModel& model) {
  constexpr double kInTheAir = 0.3;  // m
  double foot = model.hull.empty() ? 0.0 : model.hull[0].bottom;
  for (const scene::HullPart& part : model.hull) foot = std::min(foot, part.bottom);
  return foot > kInTheAir ? foot : 0.0;
}

const sim::Robot& RobotOf(const sim::Simulation& simulation, const std::string& name) {
  if (simulation.robots().empty()) throw Error("there is no robot for a camera to go with");
  if (name.empty()) return *simulation.robots().front();
  const sim::Robot* const robot = simulation.FindRobot(name);
  if (robot != nullptr) return *robot;
  std::vector<std::string> names;
  for (const auto& one : simulation.robots()) names.push_back(one->name());
  throw Error("there is no robot '" + name + "' for the camera" + DidYouMean(name, names));
}

}  // namespace

void ShowSimulation(const sim::Simulation& simulation, const PictureOptions& options,
                    PictureScene& scene) {
  const scene::World& world = simulation.world().scene();
  AddFloor(simulation, options.canvas, scene);
  for (const scene::Box& box : world.boxes) {
    if (box.dynamic && !box.raised) continue;
    const double x = box.size_x / 2.0;
    const double y = box.size_y / 2.0;
    const std::vector<Vec2> outline = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    scene.AddPrism(box.pose, outline, 0.0, box.height, kBevel,
                   scene.AddMaterial({Linear(box.color), 0.04, 0.5, false}));
  }
  for (const scene::Mesh& mesh : world.meshes) {
    AddMesh(mesh, ThingOf(mesh, simulation.world()), scene);
  }
  const Parts parts = {scene.AddMaterial({{0.016, 0.019, 0.024}, 0.04, 0.45, false}),
                       scene.AddMaterial({{0.012, 0.012, 0.012}, 0.03, 0.7, false}),
                       scene.AddMaterial({{0.72, 0.74, 0.76}, 0.0, 0.3, true}),
                       scene.AddMaterial({{0.008, 0.009, 0.011}, 0.06, 0.2, false})};
  for (const auto& robot : simulation.robots()) AddRobot(*robot, parts, options, scene);
  AddLamps(world, scene);
}

Camera FindCamera(const sim::Simulation& simulation, const std::string& name, double aspect) {
  const scene::World& world = simulation.world().scene();
  const std::size_t colon = name.find(':');
  const std::string kind = name.substr(0, colon);
  const std::string whose = colon == std::string::npos ? "" : name.substr(colon + 1);
  if (kind == "scene") {
    const scene::CameraDef& def = simulation.scenario().camera;
    Camera camera;
    camera.position = def.position;
    camera.rotation = FromEuler(def.rotation.x, def.rotation.y, def.rotation.z);
    return camera;
  }
  if (kind == "top") {
    const auto [s, c] = SinCos(Radians(Camera{}.fov_deg / 2.0));
    const double half = std::max(world.size_y, world.size_x / aspect) / 2.0;
    const Vec3 middle{world.middle().x, world.middle().y, 0.0};
    return Camera::LookAt(middle + Vec3{0.0, 0.0, 1.06 * half * c / s}, middle);
  }
  if (kind == "follow" || kind == "robot") {
    const sim::Robot& robot = RobotOf(simulation, whose);
    const Pose2& pose = robot.pose();
    if (kind == "follow") {
      // As far behind as the robot is large: 0.9 m for one of SyRoTek's.
      const double foot = FootOf(robot.model());
      const double high = robot.model().height - foot;
      const double far = std::max(1.0, 2.8 * std::max(robot.model().length, high));
      const Vec3 up{0.0, 0.0, robot.lift() + foot};
      return Camera::LookAt(OnRobot(pose, far * Vec3{-0.9, 0.0, 0.65}) + up,
                            OnRobot(pose, far * Vec3{0.15, 0.0, 0.05}) + up);
    }
    const double eye = robot.lift() + robot.model().height + 0.03;
    const double foot = FootOf(robot.model());
    const double there = robot.lift() + foot + 0.7 * (robot.model().height - foot + 0.03);
    return Camera::LookAt(OnRobot(pose, {0.0, 0.0, eye}), OnRobot(pose, {1.0, 0.0, there}));
  }
  throw Error("there is no camera '" + name +
              "': scene, top, follow, robot, or follow:NAME and robot:NAME for a robot");
}

}  // namespace ccmorse::render
