#include "sim/modifiers/noise_modifiers.h"

#include <cmath>

#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
constexpr std::array<const char*, 3> kAngles = {"roll", "pitch", "yaw"};
constexpr double kRotation = 5.0 * kPi / 180.0;  // rad, rot_std as delivered

// Three normally distributed numbers of the tick, from its sample `first` on.
std::array<double, 3> Draw(const Noise& noise, std::uint64_t tick,
                           const std::array<double, 3>& deviations, std::uint32_t first) {
  std::array<double, 4> off{};
  noise.AddGaussian(tick, 1.0, off.data(), off.size(), first);
  return {deviations[0] * off[0], deviations[1] * off[1], deviations[2] * off[2]};
}

void AddTo(std::span<const DataField> data, std::string_view name,
           const std::array<double, 3>& off) {
  for (const DataField& field : data) {
    if (field.name != name || field.numbers.size() != off.size()) continue;
    for (std::size_t i = 0; i < off.size(); ++i) field.numbers[i] += off[i];
  }
}

}  // namespace

PoseNoise::PoseNoise(const Noise& noise, const ModifierSettings& settings)
    : noise_(noise),
      position_(settings.Deviations("pos_std", 0.05, kAxes)),
      angle_(settings.Deviations("rot_std", kRotation, kAngles)) {
  if (settings.Flag("_2D", false)) position_[2] = angle_[0] = angle_[1] = 0.0;
}

void PoseNoise::Apply(std::span<const DataField> data, const Instant& now) {
  const std::array<double, 3> moved = Draw(noise_, now.tick, position_, 0);
  const std::array<double, 3> turned = Draw(noise_, now.tick, angle_, 4);
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    if (double* const number = FindNumber(data, kAxes[i])) *number += moved[i];
    if (double* const angle = FindNumber(data, kAngles[i])) {
      *angle = NormalizeAngle(*angle + turned[i]);
    }
  }
}

ImuNoise::ImuNoise(const Noise& noise, const ModifierSettings& settings)
    : noise_(noise),
      gyro_(settings.Deviations("gyro_std", 0.5, kAxes)),
      accel_(settings.Deviations("accel_std", 0.5, kAxes)) {}

void ImuNoise::Apply(std::span<const DataField> data, const Instant& now) {
  AddTo(data, "angular_velocity", Draw(noise_, now.tick, gyro_, 0));
  AddTo(data, "linear_acceleration", Draw(noise_, now.tick, accel_, 4));
}

OdometryNoise::OdometryNoise(const Noise& noise, const ModifierSettings& settings)
    : noise_(noise),
      factor_(settings.Number("factor", 1.05, -1e3, 1e3)),
      factor_sigma_(settings.Number("factor_sigma", 0.0, 0.0, 1e3)),
      drift_(settings.Number("gyro_drift", 0.0, -kPi, kPi)),
      drift_sigma_(settings.Number("gyro_drift_sigma", 0.0, 0.0, kPi)) {}

// A way, m, or a speed, m/s, as the odometry believes it to be.
void OdometryNoise::Turn(double* x, double* y, double factor) const {
  if (x == nullptr || y == nullptr) return;
  const auto [s, c] = SinCos(turned_);
  const Vec2 way{factor * (c * *x - s * *y), factor * (s * *x + c * *y)};
  *x = way.x;
  *y = way.y;
}

void OdometryNoise::Apply(std::span<const DataField> data, const Instant& now) {
  std::array<double, 2> off{};
  noise_.AddGaussian(now.tick, 1.0, off.data(), off.size());
  const double factor = factor_ + factor_sigma_ * off[0];
  const double drift = drift_ + drift_sigma_ * off[1];
  double* const x = FindNumber(data, "x");
  double* const y = FindNumber(data, "y");
  // What it has at the first sample is where it begins.
  if (begun_ || x == nullptr) turned_ = NormalizeAngle(turned_ + drift);
  if (double* const way = FindNumber(data, "dS")) *way *= factor;
  Turn(FindNumber(data, "dx"), FindNumber(data, "dy"), factor);
  if (double* const turn = FindNumber(data, "dyaw")) *turn += drift;
  if (x == nullptr || y == nullptr) return;
  const Vec2 here{*x, *y};
  if (!begun_) shown_ = here;
  double dx = begun_ ? here.x - last_.x : 0.0;
  double dy = begun_ ? here.y - last_.y : 0.0;
  Turn(&dx, &dy, factor);
  shown_ = shown_ + Vec2{dx, dy};
  last_ = here;
  *x = shown_.x;
  *y = shown_.y;
  if (double* const yaw = FindNumber(data, "yaw")) *yaw = NormalizeAngle(*yaw + turned_);
  // Speeds are in the robot's own frame, which the drift does not turn.
  for (const char* name : {"vx", "vy"}) {
    if (double* const speed = FindNumber(data, name)) *speed *= factor;
  }
  const double step = now.time - last_time_;
  if (double* const rate = FindNumber(data, "wz"); rate != nullptr && begun_ && step > 0.0) {
    *rate += drift / step;
  }
  last_time_ = now.time;
  begun_ = true;
}

void OdometryNoise::Reset() {
  turned_ = 0.0;
  begun_ = false;
  last_ = shown_ = {};
}

std::vector<Service> OdometryNoise::Services() {
  return {{"reset_noise", {}, [this](Arguments) {
             Reset();
             return Json();
           }}};
}

}  // namespace ccmorse::sim
