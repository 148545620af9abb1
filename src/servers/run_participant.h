#pragma once

namespace ccmorse::servers {

/// Takes part in a run from within, on its thread. Whatever it changes goes through the run's
/// ServiceDirectory, so that a replay, which has no participants, comes to the same.
class RunParticipant {
 public:
  virtual ~RunParticipant() = default;
  /// After each Simulation::Sense(), before anybody is told of what was sensed.
  virtual void Sensed() = 0;
  /// Before each Simulation::Act(), after the inputs of clients.
  virtual void BeforeAct() = 0;
};

}  // namespace ccmorse::servers
