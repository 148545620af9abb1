#include "sim/sensors/collision.h"

#include <algorithm>

#include "base/polygon.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

// m: a blocked robot stands less than 1e-5 m before what it ran against (kinematics.h).
constexpr double kTouch = 1e-4;

}  // namespace

Collision::Collision(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "Collision", 60.0), world_(world) {
  AddProperty("only_objects_with_property", only_);
}

std::string Collision::NameOf(int id) const {
  for (const scene::Mesh& mesh : world_.scene().meshes) {
    if (mesh.id == id && !mesh.name.empty()) return mesh.name;
  }
  const scene::Box* const box = world_.FindBox(id);
  return (box != nullptr ? box->kind : "mesh") + "_" + std::to_string(id);
}

void Collision::Sample(const Instant& now) {
  objects_.clear();
  const auto touches = [this](const Obstacle& other) {
    return ConvexGap(robot().outline().outline, other.outline) < kTouch;
  };
  const auto add = [this](const std::string& name) {
    // Of a mesh in several pieces the name comes once.
    if (("," + objects_ + ",").find("," + name + ",") != std::string::npos) return;
    objects_ += (objects_.empty() ? "" : ",") + name;
  };
  if (robot().dynamic()) {
    for (const Surface& touched : robot().touches()) {
      if (touched.kind != HitKind::kRobot) {
        if (only_.empty()) add(NameOf(touched.object));
        continue;
      }
      const Robot& other = *world_.robots()[static_cast<std::size_t>(touched.object)];
      if (!only_.empty() && other.def().properties.Find(only_) == nullptr) continue;
      add(other.name());
    }
    return DataChanged(now.time);
  }
  if (only_.empty()) {
    near_.clear();
    const Pose2& pose = robot().pose();
    world_.NearObstacles({pose.x, pose.y}, robot().footprint().radius + kTouch, near_);
    for (const Obstacle* obstacle : near_) {
      if (touches(*obstacle)) add(NameOf(obstacle->box_id));
    }
    // On terrain it depends on the robot what of a mesh is in its way.
    std::vector<Obstacle> meshes;
    robot().FindInTheWay(robot().footprint().radius + kTouch, meshes);
    for (const Obstacle& obstacle : meshes) {
      if (touches(obstacle)) add(NameOf(obstacle.box_id));
    }
  }
  for (const Robot* other : world_.robots()) {
    if (other == &robot()) continue;
    if (!only_.empty() && other->def().properties.Find(only_) == nullptr) continue;
    const Vec3 off = other->position() - robot().position();
    const double reach = robot().footprint().radius + other->footprint().radius + kTouch;
    if (off.x * off.x + off.y * off.y > reach * reach) continue;
    Obstacle outline;
    outline.outline.reserve(other->footprint().outline.size());
    outline.MoveTo(other->footprint(), other->pose());
    if (touches(outline)) add(other->name());
  }
  DataChanged(now.time);
}

void Collision::Reset() {
  Sensor::Reset();
  objects_.clear();
}

void Collision::AddToHash(StateHash& hash) const { hash.Add(objects_); }

void Collision::AppendFields(std::string& out) const {
  AppendField(out, "collision", !objects_.empty());
  AppendField(out, "objects", std::string_view(objects_));
}

}  // namespace ccmorse::sim
