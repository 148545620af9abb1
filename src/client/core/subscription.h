#pragma once

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CCMorse {

class MorseDevice;
class MorseProxy;

/// What Read() keeps up to date for a proxy. It is apart from the proxy, so that a Read() in
/// another thread never touches a proxy that is being deleted. Every field is under the client's
/// data mutex.
struct MorseSubscription {
  MorseProxy* proxy = nullptr;          ///< for MorseRobot::GetProxies() only
  const MorseDevice* device = nullptr;  ///< decides over valid and fresh
  bool valid = false;
  bool fresh = false;
  double time = -std::numeric_limits<double>::infinity();  ///< s, of the last data
  double elapsed = 0.0;                                    ///< s, between the last two data
  int next_connection = 1;
  std::vector<std::pair<int, std::function<void()>>> subscribers;
};

}  // namespace CCMorse
