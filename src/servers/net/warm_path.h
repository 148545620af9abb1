#pragma once

#include <array>
#include <cstddef>

namespace ccmorse::servers {

/// Keeps the way through the kernel's TCP code warm. The first packet after a pause of some
/// milliseconds takes two to four times as long as one that follows another, because caches and
/// address translations have been given to others meanwhile. Bytes sent to oneself shortly before
/// bytes that matter take the slow way in their stead; docs/performance.md has the figures. No
/// error is one: without it packets are only slower. One thread.
class WarmPath {
 public:
  /// Connects two sockets over loopback.
  WarmPath();
  ~WarmPath();
  WarmPath(const WarmPath&) = delete;
  WarmPath& operator=(const WarmPath&) = delete;

  /// Are they connected? Not where the system has no file handles left.
  bool Works() const { return ends_[1] >= 0; }

  /// Sends one packet and takes it: some 20 us. False: it did not go.
  bool Warm();

 private:
  std::array<int, 2> ends_{-1, -1};
  std::array<char, 4096> block_{};
};

}  // namespace ccmorse::servers
