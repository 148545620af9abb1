#include "sim/sensors/raw_odometry.h"

#include <cmath>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

RawOdometry::RawOdometry(Robot& robot, const std::string& name)
    : Sensor(robot, name, "RawOdometry", 60.0) {
  AddData("dS", way_);
}

void RawOdometry::Sample(const Instant& now) {
  const Vec3 here = PlaceOfMount(*this).position;
  way_ = std::sqrt(Dot(here - last_, here - last_));
  last_ = here;
  DataChanged(now.time);
}

void RawOdometry::Reset() {
  Sensor::Reset();
  last_ = PlaceOfMount(*this).position;
  way_ = 0.0;
}

void RawOdometry::AddToHash(StateHash& hash) const { hash.Add(way_); }

void RawOdometry::AppendFields(std::string& out) const { AppendField(out, "dS", way_); }

}  // namespace ccmorse::sim
