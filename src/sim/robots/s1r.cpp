#include "sim/robots/s1r.h"

#include <algorithm>
#include <memory>

#include "sim/actuators/answers.h"
#include "sim/actuators/motion_vw.h"
#include "sim/actuators/pen.h"
#include "sim/actuators/waypoint.h"
#include "sim/robots/robot.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/odometry.h"
#include "sim/sensors/pose.h"
#include "sim/sensors/range_ring.h"
#include "sim/sensors/robot_properties.h"

namespace ccmorse::sim {

void EquipS1R(Robot& robot, const scene::Scenario& scenario, const World& world, Canvas& canvas) {
  const scene::RobotDef& def = robot.def();
  const auto has = [&def](const char* device) {
    return std::find(def.without.begin(), def.without.end(), device) == def.without.end();
  };
  if (has("pose")) robot.Add(std::make_unique<PoseSensor>(robot, "pose", scenario.seed));
  if (has("odometry")) {
    robot.Add(std::make_unique<OdometrySensor>(robot, "odometry", scenario.seed));
  }
  if (def.front == "laser") {
    robot.Add(std::make_unique<LaserScanner>(robot, "hokuyo", def.laser, world, scenario.seed));
  }
  if (def.ir) robot.Add(MakeInfraredRing(robot, world));
  if (def.sonar) robot.Add(MakeSonarRing(robot, world));
  for (const scene::RangerDef& ranger : def.rangers) {
    if (ranger.laser) {
      robot.Add(
          std::make_unique<LaserScanner>(robot, ranger.name, *ranger.laser, world, scenario.seed));
    } else {
      robot.Add(std::make_unique<RangeRing>(robot, ranger.name, "Sonar", *ranger.ring,
                                            ranger.ring->mounts, world));
    }
  }
  robot.Add(std::make_unique<RobotProperties>(robot, "properties", scenario));
  robot.Add(std::make_unique<MotionVW>(robot, "motion"));
  if (has("waypoint")) robot.Add(std::make_unique<Waypoint>(robot, "waypoint"));
  if (has("pen")) robot.Add(std::make_unique<Pen>(robot, "pen", canvas));
  if (has("answers")) robot.Add(std::make_unique<Answers>(robot, "answers"));
}

}  // namespace ccmorse::sim
