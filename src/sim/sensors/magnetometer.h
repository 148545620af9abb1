#pragma once

#include <optional>
#include <string>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/sensors/geodesy.h"
#include "sim/sensors/magnetic_field.h"

namespace ccmorse::sim {

/// The Earth's magnetic field as a sensor on a robot feels it, once for all that do: the field's
/// north, east and down parts as x, y and z of the world, turned into the sensor's frame (specs:
/// morse.md B.2). Like MORSE it does not ask where the world's x points to.
class FeltField {
 public:
  /// Throws Error where the scenario does not say where on the Earth the world lies.
  FeltField(const Component& component, const scene::Scenario& scenario);

  /// nT, in the sensor's frame, where it is now. `year`: with its decimals; none: the scenario's.
  Vec3 Now(const std::optional<double>& year) const;

 private:
  const Component& component_;
  Geodesy earth_;
  MagneticField field_;
  double date_;
};

/// MORSE's Magnetometer (specs: morse.md B.2): `x`, `y`, `z`, nT, the field of FeltField. Property
/// `date`, a year with its decimals; null: the scenario's. 60 Hz.
class Magnetometer : public Sensor {
 public:
  Magnetometer(Robot& robot, const std::string& name, const scene::Scenario& scenario);
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  FeltField felt_;
  std::optional<double> date_;
  Vec3 field_;  // nT
};

}  // namespace ccmorse::sim
