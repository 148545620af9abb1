#pragma once

#include <cstdint>
#include <string>

#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/Types.h"
#include "libplayerc++/operators.h"
#include "libplayerc++/ranging.h"

namespace CCMorse {

/// A laser scanner (thesis 3.1.3): Player's LaserProxy, whose settings and geometry are known from
/// the start. A simulated scanner gives GetMaxRange() for a beam without return, and refuses
/// Configure() and RequestID() by a MorseError. GetRobotPose() is the robot's pose in the world at
/// the last Read(), where the simulation has a pose sensor. Owned by the program. Any thread.
class LaserProxy : public PlayerCc::LaserProxy {
 public:
  /// `robot`: name of the simulated robot; empty takes the first that has this index. Throws
  /// MorseError that lists the indexes when there is none.
  explicit LaserProxy(PlayerClient* client, std::uint32_t index = 0, const std::string& robot = "");
  ~LaserProxy() override;

  /// The other edge of the scan, rad, as configured.
  double GetMaxAngle() const;
};

}  // namespace CCMorse
