#pragma once

#include <chrono>
#include <utility>

#include "base/log.h"

namespace ccmorse::servers {

/// Lets a few warnings a second through, so that garbage from the network cannot fill a disk. One
/// thread.
class WarningLimit {
 public:
  template <typename... Args>
  void Warn(fmt::format_string<Args...> format, Args&&... args) {
    const auto now = std::chrono::steady_clock::now();
    if (now - since_ > std::chrono::seconds(1)) {
      if (count_ > kPerSecond) LogWarning("... and {} more like these", count_ - kPerSecond);
      since_ = now;
      count_ = 0;
    }
    if (++count_ <= kPerSecond) LogWarning(format, std::forward<Args>(args)...);
  }

 private:
  static constexpr int kPerSecond = 5;
  std::chrono::steady_clock::time_point since_{};
  int count_ = 0;
};

}  // namespace ccmorse::servers
