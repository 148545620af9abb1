#include "sim/sensors/magnetometer.h"

#include "base/error.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

const scene::GeodesyDef& GeodesyFor(const Component& component, const scene::Scenario& scenario) {
  if (!scenario.geodesy) {
    throw Error("the " + component.type() + " " + component.full_name() +
                " needs to know where on the Earth the world lies: set longitude, latitude and "
                "altitude of the environment");
  }
  return *scenario.geodesy;
}

}  // namespace

FeltField::FeltField(const Component& component, const scene::Scenario& scenario)
    : component_(component),
      earth_(GeodesyFor(component, scenario)),
      field_(scenario.magnetic_field),
      date_(scenario.magnetic_field.date) {}

Vec3 FeltField::Now(const std::optional<double>& year) const {
  const MountPlace here = PlaceOfMount(component_);
  return RotateBack(here.rotation,
                    field_.NorthEastDown(earth_.PlaceOf(here.position), year.value_or(date_)));
}

Magnetometer::Magnetometer(Robot& robot, const std::string& name, const scene::Scenario& scenario)
    : Sensor(robot, name, "Magnetometer", 60.0), felt_(*this, scenario) {
  AddProperty("date", date_, 1.0, 9999.0);
}

void Magnetometer::Sample(const Instant& now) {
  field_ = felt_.Now(date_);
  DataChanged(now.time);
}

void Magnetometer::Reset() {
  Sensor::Reset();
  field_ = {};
}

void Magnetometer::AddToHash(StateHash& hash) const {
  hash.Add(field_.x);
  hash.Add(field_.y);
  hash.Add(field_.z);
}

void Magnetometer::AppendFields(std::string& out) const {
  AppendField(out, "x", field_.x);
  AppendField(out, "y", field_.y);
  AppendField(out, "z", field_.z);
}

}  // namespace ccmorse::sim
