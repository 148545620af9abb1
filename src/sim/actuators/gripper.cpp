#include "sim/actuators/gripper.h"

#include <limits>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Gripper::Gripper(Robot& robot, const std::string& name, World& world)
    : Actuator(robot, name, "Gripper", 60.0), world_(world) {
  AddProperty("Angle", angle_, 0.0, 360.0);
  AddProperty("Distance", distance_, 0.0, 1e6);
  AddService({"grab", {}, [this](Arguments) { return Grab(); }});
  AddService({"release", {}, [this](Arguments) { return Json(Release()); }});
}

Json Gripper::Grab() {
  grab_ = true;
  DataChanged(timestamp());
  if (held_ != nullptr) return Json(held_->name);
  const SightCone cone(*this, angle_, distance_);
  double nearest = std::numeric_limits<double>::infinity();
  for (SceneObject& object : world_.objects().all()) {
    if (object.robot != nullptr || object.held() || !object.Is("Graspable")) continue;
    const std::optional<double> distance = cone.DistanceOf(object.WorldPosition());
    if (!distance || *distance >= nearest) continue;
    nearest = *distance;
    held_ = &object;
  }
  if (held_ == nullptr) return {};
  SceneObjects::SetHolder(*held_, this);
  return Json(held_->name);
}

bool Gripper::Release() {
  grab_ = false;
  DataChanged(timestamp());
  if (held_ == nullptr) return false;
  SceneObjects::SetHolder(*held_, nullptr);
  held_ = nullptr;
  return true;
}

void Gripper::Receive(const Json& message) {
  const Json* const grab = message.Find("grab");
  if (grab == nullptr) throw WrongArgument("'grab' is missing");
  if (!grab->IsBool()) throw WrongArgument("grab must be true or false");
  if (grab->AsBool()) {
    Grab();
  } else {
    Release();
  }
}

void Gripper::Act(const Instant& now) { DataChanged(now.time); }

void Gripper::Reset() {
  Actuator::Reset();
  held_ = nullptr;  // the world has let go of all objects
  grab_ = false;
}

void Gripper::AppendFields(std::string& out) const { AppendField(out, "grab", grab_); }

}  // namespace ccmorse::sim
