#pragma once

#include <string>
#include <vector>

#include "libCCMorse/MorseSensor.h"

namespace CCMorse {

/// A robot's configuration, from the RobotProperties sensor (thesis 3.2): what does not change
/// during a run. It is read once, when the client connects. Paths join keys and positions in lists
/// by dots: "mass", "color.0", "drivers.snd.max_speed". A property that the simulator adds is at
/// once readable by its path. Owned by the client; any thread.
class MorseProperties : public MorseSensor, public MorsePropertySource {
 public:
  explicit MorseProperties(const MorseDeviceInfo& info);

  MorseValue GetAll() const override;       ///< all entries; null when the simulator sent none
  bool Has(const std::string& path) const;  ///< whether there is such an entry
  MorseValue Get(const std::string& path) const;  ///< the entry, null when missing
  // Typed entries; the fallback where there is none or one of another type.
  double GetDouble(const std::string& path, double fallback = 0.0) const;
  int GetInt(const std::string& path, int fallback = 0) const;
  bool GetBool(const std::string& path, bool fallback = false) const;
  std::string GetString(const std::string& path, const std::string& fallback = "") const;
  std::vector<double> GetDoubles(const std::string& path) const;

  std::string GetRobotName() const { return GetString("name"); }        ///< the robot's name
  std::string GetRobotType() const { return GetString("type"); }        ///< the robot's class
  double GetMass() const { return GetDouble("mass"); }                  ///< kg
  double GetLength() const { return GetDouble("size.0"); }              ///< m
  double GetWidth() const { return GetDouble("size.1"); }               ///< m
  double GetHeight() const { return GetDouble("size.2"); }              ///< m
  double GetWheelRadius() const { return GetDouble("wheel_radius"); }   ///< m
  double GetWheelTrack() const { return GetDouble("wheel_track"); }     ///< m
  double GetMaxSpeed() const { return GetDouble("max_speed"); }         ///< m/s
  double GetMaxTurnRate() const { return GetDouble("max_turn_rate"); }  ///< rad/s
  player_pose2d_t GetInitialPose() const;  ///< where the robot started, m and rad
  /// Indexes for which there are proxies of `interface` ("laser"), ascending.
  std::vector<int> GetProxyIndexes(const std::string& interface) const;
  /// Settings of driver `name` ("snd"); null when there are none.
  MorseValue GetDriver(const std::string& name) const;

 protected:
  std::vector<std::string> SetupServices() const override;
  void OnSetup(const std::string& service, const MorseValue& answer) override;
  bool OnData(const MorseValue& data) override;

 private:
  MorseValue properties_;
};

}  // namespace CCMorse
