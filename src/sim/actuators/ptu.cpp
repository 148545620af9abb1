#include "sim/actuators/ptu.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/euler.h"
#include "base/trig.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

constexpr double kMostAngle = 1e3;  // rad

double AngleArgument(Arguments arguments, std::size_t index, const char* name) {
  const double angle = NumberArgument(arguments, index, name);
  if (!(std::fabs(angle) <= kMostAngle)) throw WrongArgument(std::string(name) + " is too large");
  return angle;
}

// One step of a joint; is it there?
bool TurnTowards(double& angle, double wanted, double most, double tolerance) {
  const double off = NormalizeAngle(wanted - angle);
  if (std::fabs(off) <= tolerance) return true;
  angle = NormalizeAngle(angle + std::clamp(off, -most, most));
  return std::fabs(NormalizeAngle(wanted - angle)) <= tolerance;
}

}  // namespace

Ptu::Ptu(Robot& robot, const std::string& name, const World& world)
    : Actuator(robot, name, "PTU", 60.0), world_(world) {
  set_moves(true);
  AddProperty("Speed", speed_, 0.0, 1e6);
  AddProperty("Tolerance", tolerance_, 0.0, kPi);
  AddProperty("Manual", manual_);
  AddService(
      {"set_pan_tilt", {{"pan"}, {"tilt"}}, nullptr, [this](Arguments arguments, Completion done) {
         Start(AngleArgument(arguments, 0, "pan"), AngleArgument(arguments, 1, "tilt"),
               std::move(done));
       }});
  AddService({"look_at_point",
              {{"x"}, {"y"}, {"z"}},
              nullptr,
              [this](Arguments arguments, Completion done) {
                LookAt({NumberArgument(arguments, 0, "x"), NumberArgument(arguments, 1, "y"),
                        NumberArgument(arguments, 2, "z")},
                       std::move(done));
              }});
  AddService(
      {"look_at_object", {{"obj_name"}}, nullptr, [this](Arguments arguments, Completion done) {
         const std::string& wanted = StringArgument(arguments, 0, "obj_name");
         const SceneObject* const object = world_.objects().Find(wanted);
         if (object == nullptr) {
           throw ServiceFailed("Object '" + wanted + "' does not appear in the scene.");
         }
         LookAt(object->WorldPosition(), std::move(done));
       }});
  AddQuery({"get_pan_tilt", {}, [this](Arguments) { return Json(Json::Array{pan_, tilt_}); }});
}

// Nobody is left to answer when the simulation is taken down.
Ptu::~Ptu() { pending_ = nullptr; }

Mount Ptu::Carry(const Mount& at_rest) const {
  const Mount own = RestMount();
  // In the unit's frame, turned there, and back.
  const Rotation joints = FromEuler(0.0, tilt_, pan_);
  const Rotation turn = Combined(own.rotation, joints);
  const auto turned = [&](const Vec3& v) { return Rotate(turn, RotateBack(own.rotation, v)); };
  return Actuator::Carry(
      {own.position + turned(at_rest.position - own.position),
       {turned(at_rest.rotation.x), turned(at_rest.rotation.y), turned(at_rest.rotation.z)}});
}

void Ptu::Start(double pan, double tilt, Completion done) {
  Finish(Outcome::kPreempted);
  pending_ = std::move(done);
  wanted_pan_ = NormalizeAngle(pan);
  wanted_tilt_ = NormalizeAngle(tilt);
}

void Ptu::LookAt(const Vec3& point, Completion done) {
  const MountPlace here = PlaceOfMount(*this);
  const Vec3 way = RotateBack(here.rotation, point - here.position);
  const double level = std::sqrt(way.x * way.x + way.y * way.y);
  Start(Atan2(way.y, way.x), Atan2(0.0 - way.z, level), std::move(done));
}

void Ptu::Receive(const Json& message) {
  const double pan = NumberMember(message, "pan");
  const double tilt = NumberMember(message, "tilt");
  if (!(std::fabs(pan) <= kMostAngle) || !(std::fabs(tilt) <= kMostAngle)) {
    throw WrongArgument("that is too large an angle");
  }
  wanted_pan_ = NormalizeAngle(pan);
  wanted_tilt_ = NormalizeAngle(tilt);
}

void Ptu::Act(const Instant& now) {
  DataChanged(now.time);
  if (manual_) return;
  const double most = speed_ * std::max(now.step, 1.0 / frequency());
  const bool panned = TurnTowards(pan_, wanted_pan_, most, tolerance_);
  const bool tilted = TurnTowards(tilt_, wanted_tilt_, most, tolerance_);
  if (panned && tilted) Finish(Outcome::kSuccess);
}

void Ptu::Finish(Outcome outcome) {
  if (!pending_) return;
  const Completion done = std::exchange(pending_, nullptr);
  done({outcome, Json()});
}

void Ptu::Interrupt() {
  wanted_pan_ = pan_;
  wanted_tilt_ = tilt_;
  Finish(Outcome::kPreempted);
}

void Ptu::Reset() {
  Actuator::Reset();
  pan_ = tilt_ = 0.0;
  Interrupt();
}

void Ptu::AppendFields(std::string& out) const {
  AppendField(out, "pan", wanted_pan_);
  AppendField(out, "tilt", wanted_tilt_);
}

}  // namespace ccmorse::sim
