#pragma once

#include <string>

#include "sim/component.h"

namespace ccmorse::sim {

/// MORSE's Sound (specs: morse.md B.3): takes `mode` "play", "pause" or "stop", as data and stream,
/// and makes no sound.
class Sound : public Actuator {
 public:
  Sound(Robot& robot, const std::string& name);
  void Act(const Instant& now) override { DataChanged(now.time); }
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // nothing simulated depends on it
  void Reset() override;

 private:
  void AppendFields(std::string& out) const override;

  std::string mode_ = "stop";
};

}  // namespace ccmorse::sim
