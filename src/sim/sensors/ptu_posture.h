#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

class Ptu;

/// MORSE's PTUPosture (specs: morse.md B.2): `pan` and `tilt`, rad, of the nearest PTU that it is
/// mounted on. 60 Hz.
class PtuPosture : public Sensor {
 public:
  PtuPosture(Robot& robot, const std::string& name);
  void Mounted() override;  ///< throws Error where there is no PTU
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  const Ptu* ptu_ = nullptr;
  double pan_ = 0.0;
  double tilt_ = 0.0;
};

}  // namespace ccmorse::sim
