#include "sim/sensors/ptu_posture.h"

#include "base/error.h"
#include "sim/actuators/ptu.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

PtuPosture::PtuPosture(Robot& robot, const std::string& name)
    : Sensor(robot, name, "PTUPosture", 60.0) {}

void PtuPosture::Mounted() {
  for (const Component* on = parent(); on != nullptr && ptu_ == nullptr; on = on->parent()) {
    ptu_ = dynamic_cast<const Ptu*>(on);
  }
  if (ptu_ == nullptr) {
    throw Error("the PTUPosture " + full_name() + " is mounted on no PTU: append it to one");
  }
}

void PtuPosture::Sample(const Instant& now) {
  pan_ = ptu_->pan();
  tilt_ = ptu_->tilt();
  DataChanged(now.time);
}

void PtuPosture::Reset() {
  Sensor::Reset();
  pan_ = tilt_ = 0.0;
}

void PtuPosture::AddToHash(StateHash& hash) const {
  hash.Add(pan_);
  hash.Add(tilt_);
}

void PtuPosture::AppendFields(std::string& out) const {
  AppendField(out, "pan", pan_);
  AppendField(out, "tilt", tilt_);
}

}  // namespace ccmorse::sim
