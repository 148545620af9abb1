#include "sim/sensors/barometer.h"

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

namespace {

// The standard atmosphere (specs: morse.md B.2).
constexpr double kLapse = 0.0065;        // K/m
constexpr double kTemperature = 288.15;  // K
constexpr double kExponent = 9.81 * 0.0289644 / (8.31447 * kLapse);

}  // namespace

Barometer::Barometer(Robot& robot, const std::string& name)
    : Sensor(robot, name, "Barometer", 60.0) {
  AddProperty("ReferencePressure", reference_, 0.0, 1e9);
}

void Barometer::Sample(const Instant& now) {
  const double climbed = PlaceOfMount(*this).position.z - start_;
  const double share = 1.0 - kLapse * climbed / kTemperature;
  pressure_ = share > 0.0 ? reference_ * Exp(kExponent * Log(share)) : 0.0;
  DataChanged(now.time);
}

void Barometer::Reset() {
  Sensor::Reset();
  start_ = PlaceOfMount(*this).position.z;
  pressure_ = 0.0;
}

void Barometer::AddToHash(StateHash& hash) const { hash.Add(pressure_); }

void Barometer::AppendFields(std::string& out) const { AppendField(out, "pressure", pressure_); }

}  // namespace ccmorse::sim
