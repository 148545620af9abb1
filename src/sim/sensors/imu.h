#pragma once

#include <array>
#include <optional>
#include <string>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/sensors/magnetometer.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {

/// MORSE's IMU (specs: morse.md B.2), all in the sensor's frame: `angular_velocity`, rad/s;
/// `linear_acceleration`, m/s^2, with what holds it up against gravity: at rest 9.81 upwards; and
/// `magnetic_field`, nT, as the Magnetometer has it. 60 Hz.
class Imu : public Sensor {
 public:
  /// Where the scenario does not say where on the Earth the world lies there is no magnetic field.
  Imu(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "Automatic";  // ComputationMode
  SensorMotion motion_;
  std::optional<FeltField> felt_;
  std::array<double, 3> angular_velocity_{};
  std::array<double, 3> acceleration_{};
  std::array<double, 3> magnetic_field_{};
};

}  // namespace ccmorse::sim
