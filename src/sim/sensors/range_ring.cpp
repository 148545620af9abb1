#include "sim/sensors/range_ring.h"

#include <algorithm>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

// What the scenario says; else those of the robot's body, then those of the module in its front
// bay.
std::vector<scene::RingMount> Mounts(const Robot& robot, const scene::RingDef& def,
                                     std::vector<Pose2> poses) {
  if (!def.mounts.empty()) return def.mounts;
  const scene::RobotModel& model = robot.model();
  const std::vector<Pose2>& module = model.module_mounts;
  if (robot.def().front == "sensors") poses.insert(poses.end(), module.begin(), module.end());
  std::vector<scene::RingMount> mounts;
  for (const Pose2& pose : poses) {
    mounts.push_back({{pose.x, pose.y, model.ring_height - model.origin_height}, pose.yaw});
  }
  return mounts;
}

}  // namespace

RangeRing::RangeRing(Robot& robot, const std::string& name, std::string type,
                     const scene::RingDef& def, std::vector<scene::RingMount> mounts,
                     const World& world)
    : Sensor(robot, name, std::move(type), def.frequency),
      def_(def),
      mounts_(std::move(mounts)),
      world_(world),
      ranges_(mounts_.size(), def.range) {
  const auto [s, c] = SinCos(Radians(def.cone_deg) / 2.0);
  cone_.sine = s;
  cone_.cosine = c;
}

void RangeRing::Sample(const Instant& now) {
  const Pose2& base = robot().pose();
  for (std::size_t i = 0; i < mounts_.size(); ++i) {
    const Vec3& mount = mounts_[i].position;
    const Vec2 at = Transform(base, {mount.x, mount.y});
    const auto [s, c] = SinCos(base.yaw + mounts_[i].yaw);
    Cone cone = cone_;
    cone.apex = {at.x, at.y, robot().position().z + mount.z};
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
  for (const scene::RingMount& mount : mounts_) {
    const Vec3& at = mount.position;
    poses.emplace_back(Json::Array{at.x, at.y, at.z, mount.yaw});
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
  const scene::RingDef& def = *robot.def().ir;
  return std::make_unique<RangeRing>(robot, "ir", "Infrared", def,
                                     Mounts(robot, def, model.ir_mounts), world);
}

std::unique_ptr<RangeRing> MakeSonarRing(Robot& robot, const World& world) {
  const scene::RobotModel& model = robot.model();
  const scene::RingDef& def = *robot.def().sonar;
  return std::make_unique<RangeRing>(robot, "sonar", "Sonar", def,
                                     Mounts(robot, def, model.sonar_mounts), world);
}

}  // namespace ccmorse::sim
