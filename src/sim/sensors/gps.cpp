#include "sim/sensors/gps.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

constexpr double kStandstill = 1e-9;  // m/s

const char* TypeOf(const std::string& level) {
  if (level == "raw") return "RawGPS";
  return level == "extended" ? "ExtendedGPS" : "GPS";
}

}  // namespace

Gps::Gps(Robot& robot, const std::string& name, const std::string& level,
         const scene::Scenario& scenario)
    : Sensor(robot, name, TypeOf(level), 60.0), extended_(level == "extended") {
  if (level.empty() || level == "simple") {
    AddData("x", shown_.x);
    AddData("y", shown_.y);
    AddData("z", shown_.z);
    return;
  }
  if (!scenario.geodesy) {
    throw Error("the GPS " + full_name() + " of level " + level +
                " needs to know where on the Earth the world lies: set longitude, latitude and "
                "altitude of the environment");
  }
  geodesy_.emplace(*scenario.geodesy);
}

void Gps::Sample(const Instant& now) {
  const Vec3 here = PlaceOfMount(*this).position;
  if (geodesy_) {
    place_ = geodesy_->PlaceOf(here);
    const double step = now.time - last_time_;
    velocity_ =
        sampled_ && step > 0.0 ? geodesy_->ToEnu((1.0 / step) * (here - position_)) : Vec3{};
  }
  position_ = shown_ = here;
  last_time_ = now.time;
  sampled_ = true;
  DataChanged(now.time);
}

void Gps::Reset() {
  Sensor::Reset();
  position_ = shown_ = {};
  place_ = {};
  velocity_ = {};
  sampled_ = false;
}

void Gps::AddToHash(StateHash& hash) const {
  hash.Add(shown_.x);
  hash.Add(shown_.y);
  hash.Add(shown_.z);
}

void Gps::AppendFields(std::string& out) const {
  if (!geodesy_) {
    AppendField(out, "x", shown_.x);
    AppendField(out, "y", shown_.y);
    AppendField(out, "z", shown_.z);
    return;
  }
  AppendField(out, "longitude", place_.longitude);
  AppendField(out, "latitude", place_.latitude);
  AppendField(out, "altitude", place_.altitude);
  AppendField(out, "velocity", velocity_);
  if (!extended_) return;
  const std::chrono::sys_seconds since_1970{
      std::chrono::seconds(static_cast<std::int64_t>(std::floor(timestamp())))};
  const auto day = std::chrono::floor<std::chrono::days>(since_1970);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{since_1970 - day};
  AppendField(out, "date",
              std::string_view(fmt::format("{:02}{:02}{:02}", static_cast<unsigned>(date.day()),
                                           static_cast<unsigned>(date.month()),
                                           static_cast<int>(date.year()) % 100)));
  AppendField(out, "time",
              std::string_view(fmt::format("{:02}{:02}{:02}", clock.hours().count(),
                                           clock.minutes().count(), clock.seconds().count())));
  double heading = std::numeric_limits<double>::infinity();
  if (std::fabs(velocity_.x) > kStandstill || std::fabs(velocity_.y) > kStandstill) {
    heading = Degrees(Atan2(velocity_.x, velocity_.y));
    if (heading < 0.0) heading += 360.0;
  }
  AppendField(out, "heading", heading);
}

}  // namespace ccmorse::sim
