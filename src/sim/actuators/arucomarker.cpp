#include "sim/actuators/arucomarker.h"

#include "base/euler.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

Json Listed(const Vec3& v) { return Json(Json::Array{v.x, v.y, v.z}); }

Json Rows(const Rotation& r) {
  return Json(Json::Array{Json::Array{r.x.x, r.y.x, r.z.x}, Json::Array{r.x.y, r.y.y, r.z.y},
                          Json::Array{r.x.z, r.y.z, r.z.z}});
}

}  // namespace

Arucomarker::Arucomarker(Robot& robot, const std::string& name)
    : Actuator(robot, name, "Arucomarker", 60.0) {
  constexpr double kFarthest = 1e6;
  AddProperty("xoffset", x_offset_, -kFarthest, kFarthest);
  AddProperty("yoffset", y_offset_, -kFarthest, kFarthest);
  AddProperty("zoffset", z_offset_, -kFarthest, kFarthest);
  AddQuery({"get_world_position", {}, [this](Arguments) { return Listed(WorldPosition()); }});
  AddQuery({"get_local_position", {}, [this](Arguments) {
              return Listed(
                  RotateBack(this->robot().rotation(), WorldPosition() - this->robot().position()));
            }});
  AddQuery({"get_world_orientation", {}, [this](Arguments) { return Rows(WorldRotation()); }});
  AddQuery({"get_local_orientation", {}, [this](Arguments) {
              const Rotation of_robot = this->robot().rotation();
              const Rotation world = WorldRotation();
              return Rows({RotateBack(of_robot, world.x), RotateBack(of_robot, world.y),
                           RotateBack(of_robot, world.z)});
            }});
}

Vec3 Arucomarker::WorldPosition() const {
  return robot().position() +
         Vec3{position_.z + x_offset_, position_.x + y_offset_, z_offset_ - position_.y};
}

Rotation Arucomarker::WorldRotation() const {
  // Euler angles in the order YZX: first about y, then z, then x.
  const Rotation about_y = FromEuler(0.0, euler_.y, 0.0);
  const Rotation about_z = FromEuler(0.0, 0.0, euler_.z);
  return Combined(FromEuler(euler_.x, 0.0, 0.0), Combined(about_z, about_y));
}

void Arucomarker::Receive(const Json& message) {
  const Vec3 position{NumberMember(message, "x"), NumberMember(message, "y"),
                      NumberMember(message, "z")};
  const Vec3 euler{NumberMember(message, "roll"), NumberMember(message, "pitch"),
                   NumberMember(message, "yaw")};
  position_ = position;
  euler_ = euler;
  DataChanged(timestamp());
}

void Arucomarker::Act(const Instant& now) { DataChanged(now.time); }

void Arucomarker::Reset() {
  Actuator::Reset();
  position_ = euler_ = {};
}

void Arucomarker::AppendFields(std::string& out) const {
  AppendField(out, "x", position_.x);
  AppendField(out, "y", position_.y);
  AppendField(out, "z", position_.z);
  AppendField(out, "roll", euler_.x);
  AppendField(out, "pitch", euler_.y);
  AppendField(out, "yaw", euler_.z);
}

}  // namespace ccmorse::sim
