#include "sim/actuators/external_force.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

ExternalForce::ExternalForce(Robot& robot, const std::string& name)
    : Wrench(robot, name, "ExternalForce") {}

void ExternalForce::Act(const Instant& now) {
  DataChanged(now.time);
  robot().Push(force(), torque());
}

}  // namespace ccmorse::sim
