#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "libCCMorse/MorseDevice.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/Types.h"

namespace PlayerCc {
class ClientProxy;
}

namespace CCMorse {

namespace playerlink {
class MorseLink;
}

class MorseProperties;
struct MorseSubscription;

/// A robot of the simulation: its devices, the proxies that use them, and methods for the robot as
/// a whole (thesis 3.1.1). The client makes and owns it; pointers stay good as long as the client
/// object lives. Every method may be called from any thread.
class MorseRobot {
 public:
  MorseRobot(MorseClient& client, std::string name, std::string type);
  ~MorseRobot();
  MorseRobot(const MorseRobot&) = delete;
  MorseRobot& operator=(const MorseRobot&) = delete;

  const std::string& GetName() const { return name_; }  ///< name in the simulation, "s1r"
  const std::string& GetType() const { return type_; }  ///< class in the simulation, "Syrotek"
  MorseClient& GetClient() const { return client_; }    ///< the client that owns the robot
  /// All devices, in the order in which the simulator lists them.
  const std::vector<MorseDevice*>& GetDevices() const { return devices_; }

  /// The first device of class T; with a name ("hokuyo" or "s1r.hokuyo"), the one of that name.
  /// nullptr when there is none.
  template <class T = MorseDevice>
  T* FindDevice(const std::string& name = "") const {
    for (MorseDevice* device : devices_) {
      if (!name.empty() && device->GetName() != name && device->GetShortName() != name) continue;
      if (T* typed = dynamic_cast<T*>(device)) return typed;
    }
    return nullptr;
  }
  /// As FindDevice(), but throws MorseError that lists the robot's devices when there is none.
  template <class T = MorseDevice>
  T& GetDevice(const std::string& name = "") const {
    T* device = FindDevice<T>(name);
    if (!device) ThrowNoDevice(name);
    return *device;
  }

  /// The proxies that live on this robot, in the order in which they were made (thesis 3.1.1).
  std::vector<PlayerCc::ClientProxy*> GetProxies() const;

  /// The robot's configuration (thesis 3.2), a MorseProperties: include MorseProperties.h or
  /// CCMorse.h. Throws MorseError when the robot carries no RobotProperties sensor.
  template <class T = MorseProperties>
  T& GetProperties() const {
    return GetDevice<T>();
  }
  /// Whether the robot carries a RobotProperties sensor.
  bool HasProperties() const;

  /// Drives to (x, y), m in the world, until within `tolerance`, m. `speed`, m/s: 0 takes the
  /// robot's highest speed. A later SetSpeed() or Stop() gives the goal up. Throws MorseError when
  /// the robot has no waypoint actuator or a number is not finite.
  void SetGoal(double x, double y, double tolerance = 0.1, double speed = 0.0);
  /// Forward speed, m/s, and turn rate, rad/s counter-clockwise, held within the robot's limits.
  /// Throws MorseError when the robot has no motion actuator or a number is not finite.
  void SetSpeed(double v, double w);
  /// Speeds 0, and no goal any more. Sent at once.
  void Stop();

  /// Pose in the world by the robot's pose sensor, m and rad; zeros before the first data. Throws
  /// MorseError when the robot has no pose sensor.
  player_pose3d_t GetPose() const;
  double GetX() const { return GetPose().px; }      ///< m, see GetPose()
  double GetY() const { return GetPose().py; }      ///< m, see GetPose()
  double GetYaw() const { return GetPose().pyaw; }  ///< rad, see GetPose()

  // From the configuration; each throws MorseError when the simulator does not tell.
  double GetWeight() const;         ///< kg
  player_bbox3d_t GetSize() const;  ///< length, width, height, m
  double GetWheelRadius() const;    ///< m
  double GetWheelTrack() const;     ///< m between the wheels' middles
  double GetMaxSpeed() const;       ///< m/s
  double GetMaxTurnRate() const;    ///< rad/s
  Color_t GetColor() const;         ///< colour of the body

 private:
  friend class MorseClient;
  friend class playerlink::MorseLink;
  [[noreturn]] void ThrowNoDevice(const std::string& name) const;
  double Property(const char* key, const char* function) const;
  double PropertyOr(const char* key, double fallback) const;
  void AddSubscription(const std::shared_ptr<MorseSubscription>& subscription);
  void RemoveSubscription(const MorseSubscription* subscription);

  MorseClient& client_;
  const std::string name_;
  const std::string type_;
  std::vector<MorseDevice*> devices_;                              // fixed once connected
  std::vector<std::shared_ptr<MorseSubscription>> subscriptions_;  // under the data mutex
  std::atomic<bool> goal_set_{false};
};

}  // namespace CCMorse
