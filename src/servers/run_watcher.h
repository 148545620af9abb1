#pragma once

#include "servers/morse/service_directory.h"

namespace ccmorse::servers {

/// Follows a run from within, on its thread: a recorder, a printer. It only looks.
class RunWatcher {
 public:
  virtual ~RunWatcher() = default;
  /// After each Simulation::Sense().
  virtual void Sensed() {}
  /// Whether it wants to hear of inputs. Putting them into words takes longer than most of them, so
  /// it is done for those only that read them.
  virtual bool WantsInputs() const { return false; }
  /// Before each input, in the order in which they are applied; see WantsInputs().
  virtual void Incoming(const Input&) {}
  /// After each Simulation::Act().
  virtual void Acted() {}
  /// Once, at the end, when no more input can come. `sensed`: the last Sense() was not followed by
  /// an Act().
  virtual void Ended(bool /*sensed*/) {}
};

}  // namespace ccmorse::servers
