#include "sim/actuators/rotorcraft_pilot.h"

#include <algorithm>

#include "base/trig.h"

namespace ccmorse::sim {

RotorcraftPilot::RotorcraftPilot(Robot& robot, const std::string& name, const std::string& type,
                                 const scene::Scenario& scenario, const Gains& gains)
    : Actuator(robot, name, type, 60.0), gains_(gains), max_bank_(Radians(30.0)) {
  NeedBody(*this);
  fall_ = FallOf(robot, scenario);
  AddProperty("HorizontalPgain", gains_.horizontal_p, 0.0, kMostGain);
  AddProperty("HorizontalDgain", gains_.horizontal_d, 0.0, kMostGain);
  AddProperty("VerticalPgain", gains_.vertical_p, 0.0, kMostGain);
  AddProperty("VerticalDgain", gains_.vertical_d, 0.0, kMostGain);
  AddProperty("YawPgain", gains_.yaw_p, 0.0, kMostGain);
  AddProperty("YawDgain", gains_.yaw_d, 0.0, kMostGain);
  AddProperty("RollPitchPgain", gains_.roll_pitch_p, 0.0, kMostGain);
  AddProperty("RollPitchDgain", gains_.roll_pitch_d, 0.0, kMostGain);
  AddProperty("MaxBankAngle", max_bank_, 0.0, Radians(80.0));
}

double RotorcraftPilot::Bank(double angle) const {
  return std::clamp(angle, -max_bank_, max_bank_);
}

void RotorcraftPilot::Fly(const Vec3& angles, double up, double step) {
  const double upright = std::max(0.1, robot().rotation().z.z);
  const double lift = robot().model().mass * std::max(0.0, up) / upright;
  robot().Push(lift * robot().rotation().z, {});
  loops_.Turn(robot(), angles,
              {gains_.roll_pitch_p, gains_.roll_pitch_d, gains_.yaw_p, gains_.yaw_d}, 1.0, step);
}

void RotorcraftPilot::Reset() {
  Actuator::Reset();
  loops_.Reset();
}

}  // namespace ccmorse::sim
