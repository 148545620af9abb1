#pragma once

namespace ccmorse::scene {
struct Scenario;
}

namespace ccmorse::sim {

class Canvas;
class Robot;
class World;

/// Mounts SyRoTek's S1R: pose, odometry, hokuyo, properties; motion, waypoint, pen; and ir and
/// sonar and further rangers where the scenario says so (thesis 4.1.2, R08-R13; specs: syrotek.md
/// A). Robots of other types carry the same.
void EquipS1R(Robot& robot, const scene::Scenario& scenario, const World& world, Canvas& canvas);

}  // namespace ccmorse::sim
