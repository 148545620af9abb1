#include "sim/sensors/clock.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Clock::Clock(Robot& robot, const std::string& name) : Sensor(robot, name, "Clock", 60.0) {}

void Clock::Sample(const Instant& now) { DataChanged(now.time); }

void Clock::Reset() { Sensor::Reset(); }

void Clock::AddToHash(StateHash&) const {}  // the tick counts

void Clock::AppendFields(std::string&) const {}

}  // namespace ccmorse::sim
