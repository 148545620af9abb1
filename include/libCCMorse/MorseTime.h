#pragma once

#include <string>

#include "libCCMorse/MorseClient.h"

namespace CCMorse {

/// How evenly simulated time passes, as the simulator measures it.
struct MorseTimeStatistics {
  double mean_time = 0.0;              ///< s of simulated time a tick
  double variance_time = 0.0;          ///< s^2; 0 where the simulator does not tell
  double mean_frame_by_sec = 0.0;      ///< ticks a second; 0 where the simulator does not tell
  double variance_frame_by_sec = 0.0;  ///< 1/s^2; 0 where the simulator does not tell
  double diff_real_time = 0.0;         ///< s ahead of the wall clock; 0 where not told
};

/// Simulation time and its statistics (thesis 3.1.2). Keeps the client object alive; any thread.
/// Each question is a request of its own: see MorseClient::Request() for what it throws.
class MorseTime {
 public:
  explicit MorseTime(MorseClient& client);

  double GetTime() const;                     ///< simulated time now, s
  double GetLastReadTime() const;             ///< of the last Read(), s; asks nobody
  std::string GetMode() const;                ///< "Best Effort" or "Fixed Simulation Step"
  MorseTimeStatistics GetStatistics() const;  ///< since the start of the simulation
  /// Simulated seconds a real one, above 0. False when the simulator cannot change it.
  bool SetTimeScale(double factor);

 private:
  std::shared_ptr<MorseClient> client_;
};

}  // namespace CCMorse
