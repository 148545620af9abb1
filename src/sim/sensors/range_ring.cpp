#include "sim/sensors/range_ring.h"

#include <algorithm>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

// Those of the robot's body, then those of the module in its front bay.
std::vector<Pose2> Mounts(const Robot& robot, std::vector<Pose2> poses) {
  const std::vector<Pose2>& module = robot.model().module_mounts;
  if (robot.def().front == "sensors") poses.insert(poses.end(), module.begin(), module.end());
  return poses;
}

}  // namespace

RangeRing::RangeRing(Robot& robot, const std::string& name, std::string type,
                     const scene::RingDef& def, std::vector<Pose2> poses, double height,
                     const World& world)
    : Sensor(robot, name, std::move(type), def.frequency),
      def_(def),
      poses_(std::move(poses)),
      height_(height),
      world_(world),
      ranges_(poses_.size(), def.range) {
  const auto [s, c] = SinCos(Radians(def.cone_deg) / 2.0);
  cone_.sine = s;
  cone_.cosine = c;
}

void RangeRing::Sample(const Instant& now) {
  const Pose2& base = robot().pose();
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Vec2 at = Transform(base, {poses_[i].x, poses_[i].y});
    const auto [s, c] = SinCos(base.yaw + poses_[i].yaw);
    Cone cone = cone_;
    cone.apex = {at.x, at.y, height_};
    cone.axis = {c, s, 0.0};
    ranges_[i] =
        std::max(def_.min_range, world_.rays().Nearest(cone, def_.range, robot().index()).distance);
  }
  DataChanged(now.time);
}

void RangeRing::Prepare() { world_.rays().Prepare(); }

void RangeRing::Reset() {
  Sensor::Reset();
  std::fill(ranges_.begin(), ranges_.end(), def_.range);
}

void RangeRing::AddToHash(StateHash& hash) const {
  for (const double range : ranges_) hash.Add(range);
}

Json RangeRing::Configurations() const {
  Json::Array poses;
  for (const Pose2& pose : poses_) {
    poses.emplace_back(
        Json::Array{pose.x, pose.y, height_ - robot().model().origin_height, pose.yaw});
  }
  return Json(Json::Object{{"min_range", def_.min_range},
                           {"range", def_.range},
                           {"cone_deg", def_.cone_deg},
                           {"frequency", def_.frequency},
                           {"poses", std::move(poses)}});
}

void RangeRing::AppendFields(std::string& out) const {
  out += ", \"range_list\": [";
  for (std::size_t i = 0; i < ranges_.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, ranges_[i]);
  }
  out += ']';
}

std::unique_ptr<RangeRing> MakeInfraredRing(Robot& robot, const World& world) {
  const scene::RobotModel& model = robot.model();
  return std::make_unique<RangeRing>(robot, "ir", "Infrared", *robot.def().ir,
                                     Mounts(robot, model.ir_mounts), model.ring_height, world);
}

std::unique_ptr<RangeRing> MakeSonarRing(Robot& robot, const World& world) {
  const scene::RobotModel& model = robot.model();
  return std::make_unique<RangeRing>(robot, "sonar", "Sonar", *robot.def().sonar,
                                     Mounts(robot, model.sonar_mounts), model.ring_height, world);
}

}  // namespace ccmorse::sim
