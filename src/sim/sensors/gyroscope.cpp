#include "sim/sensors/gyroscope.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Gyroscope::Gyroscope(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Gyroscope", 60.0) {
  AddData("yaw", euler_.z);
  AddData("pitch", euler_.y);
  AddData("roll", euler_.x);
}

void Gyroscope::Sample(const Instant& now) {
  euler_ = PlaceOfMount(*this).euler;
  DataChanged(now.time);
}

void Gyroscope::Reset() {
  Sensor::Reset();
  euler_ = {};
}

void Gyroscope::AddToHash(StateHash& hash) const {
  hash.Add(euler_.x);
  hash.Add(euler_.y);
  hash.Add(euler_.z);
}

void Gyroscope::AppendFields(std::string& out) const {
  AppendField(out, "yaw", euler_.z);
  AppendField(out, "pitch", euler_.y);
  AppendField(out, "roll", euler_.x);
}

}  // namespace ccmorse::sim
