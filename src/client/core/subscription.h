#pragma once

#include <functional>

namespace PlayerCc {
class ClientProxy;
}

namespace CCMorse {

class MorseDevice;

/// What Read() does for a proxy. It is apart from the proxy, so that a Read() in another thread
/// never touches a proxy that is being deleted. Nothing in it changes once it is known to a robot.
struct MorseSubscription {
  PlayerCc::ClientProxy* proxy = nullptr;  ///< for MorseRobot::GetProxies() only
  const MorseDevice* device = nullptr;  ///< after its first data it is delivered with each Read()
  /// Hands the data of the devices to the proxy, without a lock; whether signal() is to follow.
  std::function<bool()> deliver;
  std::function<void()> signal;
};

}  // namespace CCMorse
