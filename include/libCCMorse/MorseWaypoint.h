#pragma once

#include <string>

#include "libCCMorse/MorseActuator.h"

namespace CCMorse {

/// The actuator that drives a robot to a place, MORSE's Waypoint (thesis 4.1.2): it turns towards
/// the goal and goes there, and does not plan around obstacles. Owned by the client; any thread.
class MorseWaypoint : public MorseActuator, public MorseGoalControl {
 public:
  explicit MorseWaypoint(const MorseDeviceInfo& info);

  /// Sets the goal (x, y), m in the world, reached within `tolerance`, m; at most `speed`, m/s. It
  /// leaves with the next Read(). Throws MorseError when a number is not finite.
  void SetGoal(double x, double y, double tolerance = 0.1, double speed = 1.0) override;
  /// Drives there and waits until it is reached: true, or false when another goal took its place.
  /// `timeout`, s. In a simulation in lock-step another thread must read meanwhile. Throws
  /// MorseError when it takes longer or the simulator refuses.
  bool GoTo(double x, double y, double tolerance = 0.1, double speed = 1.0, double timeout = 60.0);
  /// Stops; Resume() goes on. With the next Read().
  void Stop() override;
  /// Goes on after Stop(). With the next Read().
  void Resume();
  /// "Transit", "Arrived" or "Stop", asked from the simulator. Throws MorseError without an answer.
  std::string GetStatus();
};

}  // namespace CCMorse
