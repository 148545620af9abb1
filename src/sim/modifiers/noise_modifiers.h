#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sim/modifiers/modifier.h"
#include "sim/modifiers/settings.h"
#include "sim/noise.h"

namespace ccmorse::sim {

/// MORSE's PoseNoise (specs: morse.md B.5): adds normally distributed numbers to x, y, z, by
/// pos_std, m (0.05), and to roll, pitch, yaw, by rot_std, rad (5 degrees), as far as the data have
/// them; to x, y and yaw only with _2D. Each deviation is one number, or an object of them by axis.
class PoseNoise : public Modifier {
 public:
  PoseNoise(const Noise& noise, const ModifierSettings& settings);
  void Apply(std::span<const DataField> data, const Instant& now) override;

 private:
  Noise noise_;
  std::array<double, 3> position_;  // of x, y, z, m
  std::array<double, 3> angle_;     // of roll, pitch, yaw, rad
};

/// MORSE's IMUNoise (specs: morse.md B.5): adds normally distributed numbers to angular_velocity,
/// by gyro_std, rad/s (0.5), and to linear_acceleration, by accel_std, m/s^2 (0.5). Each deviation
/// is one number, or an object of them by axis.
class ImuNoise : public Modifier {
 public:
  ImuNoise(const Noise& noise, const ModifierSettings& settings);
  void Apply(std::span<const DataField> data, const Instant& now) override;

 private:
  Noise noise_;
  std::array<double, 3> gyro_;   // rad/s
  std::array<double, 3> accel_;  // m/s^2
};

/// MORSE's OdometryNoise (specs: morse.md B.5): wheels of another size than believed, and a
/// gyroscope that drifts. In each sample a factor is drawn about `factor` (1.05), with the
/// deviation factor_sigma (0), and a drift about gyro_drift (0), rad, with gyro_drift_sigma (0).
/// The way since the last sample counts times the factor, in the direction that the sum of drifts
/// turns it to; yaw has the sum of drifts more than it had. So do dS, dx, dy, dyaw, x, y, yaw, vx,
/// vy and wz, whichever the data have; the speeds are m/s and rad/s, where MORSE 1.4 had its units
/// wrong. Service reset_noise: the odometry is where it ought to be again, and errs anew from
/// there.
class OdometryNoise : public Modifier {
 public:
  OdometryNoise(const Noise& noise, const ModifierSettings& settings);
  void Apply(std::span<const DataField> data, const Instant& now) override;
  void Reset() override;
  std::vector<Service> Services() override;

 private:
  void Turn(double* x, double* y, double factor) const;

  Noise noise_;
  double factor_;
  double factor_sigma_;
  double drift_;            // rad a sample
  double drift_sigma_;      // rad
  double turned_ = 0.0;     // rad, sum of drifts
  bool begun_ = false;      // there is a sample to count from
  double last_time_ = 0.0;  // s, of it
  Vec2 last_;               // m, x and y before
  Vec2 shown_;              // m, what was made of them
};

}  // namespace ccmorse::sim
