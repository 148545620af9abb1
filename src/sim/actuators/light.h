#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// A lamp that can be switched: MORSE's Light (specs: morse.md B.3). Data and stream: `emit`. The
/// service toggle(emit) sets it, or turns it over where nothing is given, and always answers true.
/// Nothing is lit: no sensor sees light.
class Light : public Actuator {
 public:
  Light(Robot& robot, const std::string& name);
  void Act(const Instant& now) override { DataChanged(now.time); }
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // nothing simulated depends on it
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;
  void Set(const Json& emit);

  bool emit_ = true;        // the property, and what it was at the start
  bool shining_ = true;     // the data
  double distance_ = 10.0;  // m
  std::string color_ = "(0,0,0)";
  double size_ = 1.5707963267948966;  // rad
  double energy_ = 1.0;
};

}  // namespace ccmorse::sim
