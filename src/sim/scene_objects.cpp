#include "sim/scene_objects.h"

#include <algorithm>
#include <cmath>

#include "base/euler.h"
#include "base/trig.h"
#include "sim/component.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

// Where who has an object is; precondition: somebody has.
Mount PlaceOfHolder(const SceneObject& object) {
  if (object.bearer != nullptr) return {object.bearer->position(), object.bearer->rotation()};
  const MountPlace there = PlaceOfMount(*object.holder);
  return {there.position, there.rotation};
}

void HandOver(SceneObject& object, const Component* holder, const Robot* bearer) {
  const Vec3 position = object.WorldPosition();
  const Rotation rotation = object.WorldRotation();
  object.holder = holder;
  object.bearer = bearer;
  object.position = position;
  object.rotation = rotation;
  if (!object.held()) return;
  const Mount there = PlaceOfHolder(object);
  object.position = RotateBack(there.rotation, position - there.position);
  object.rotation = {RotateBack(there.rotation, rotation.x), RotateBack(there.rotation, rotation.y),
                     RotateBack(there.rotation, rotation.z)};
}

}  // namespace

Vec3 SceneObject::WorldPosition() const {
  if (robot != nullptr) return robot->position();
  if (!held()) return position;
  const Mount there = PlaceOfHolder(*this);
  return there.position + Rotate(there.rotation, position);
}

Rotation SceneObject::WorldRotation() const {
  if (robot != nullptr) return robot->rotation();
  return held() ? Combined(PlaceOfHolder(*this).rotation, rotation) : rotation;
}

bool SceneObject::HasMoved() const {
  if (robot != nullptr) return false;
  const auto same = [](const Vec3& a, const Vec3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  const Rotation now = WorldRotation();
  const Rotation before = FromEuler(start.rotation.x, start.rotation.y, start.rotation.z);
  return !same(WorldPosition(), start.position) || !same(now.x, before.x) ||
         !same(now.y, before.y) || !same(now.z, before.z);
}

bool SceneObject::Has(std::string_view property) const {
  return (robot != nullptr && property == "Robot_Tag") || properties.Find(property) != nullptr;
}

bool SceneObject::Is(std::string_view property) const {
  const Json* const value = properties.Find(property);
  return value != nullptr && !value->IsFalsy();
}

void SceneObjects::Set(std::span<const Robot* const> robots,
                       const std::vector<scene::PropDef>& props) {
  objects_.clear();
  for (const Robot* robot : robots) {
    SceneObject object;
    object.name = robot->name();
    object.robot = robot;
    objects_.push_back(std::move(object));
  }
  for (const scene::PropDef& prop : props) {
    SceneObject object;
    object.name = prop.name;
    object.start = prop;
    objects_.push_back(std::move(object));
  }
  Reset();
}

const SceneObject* SceneObjects::Find(std::string_view name) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [name](const SceneObject& one) { return one.name == name; });
  return found != objects_.end() ? &*found : nullptr;
}

SceneObject* SceneObjects::Find(std::string_view name) {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [name](const SceneObject& one) { return one.name == name; });
  return found != objects_.end() ? &*found : nullptr;
}

void SceneObjects::SetHolder(SceneObject& object, const Component* holder) {
  HandOver(object, holder, nullptr);
}

void SceneObjects::SetBearer(SceneObject& object, const Robot* bearer) {
  HandOver(object, nullptr, bearer);
}

void SceneObjects::Reset() {
  for (SceneObject& object : objects_) {
    object.holder = nullptr;
    object.bearer = nullptr;
    if (object.robot != nullptr) {
      object.properties = object.robot->def().properties;
      continue;
    }
    const Vec3& euler = object.start.rotation;
    object.properties = object.start.properties;
    object.position = object.start.position;
    object.rotation = FromEuler(euler.x, euler.y, euler.z);
  }
}

SightCone::SightCone(const Component& component, double angle, double distance)
    : least_cosine_(SinCos(Radians(std::min(angle, 360.0) / 2.0)).cos), distance_(distance) {
  const MountPlace here = PlaceOfMount(component);
  apex_ = here.position;
  axis_ = here.rotation.x;
}

std::optional<double> SightCone::DistanceOf(const Vec3& point) const {
  const Vec3 way = point - apex_;
  const double distance = std::sqrt(Dot(way, way));
  if (distance > distance_ || Dot(way, axis_) < least_cosine_ * distance) return std::nullopt;
  return distance;
}

}  // namespace ccmorse::sim
