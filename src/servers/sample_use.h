#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "sim/component.h"

namespace ccmorse::servers {

/// How many of each sensor's samples some client was given, by whatever protocol; each counts once.
/// One thread.
class SampleUse {
 public:
  /// A client is given the sensor's latest sample.
  void Count(const sim::Sensor& sensor) {
    Use& use = uses_[sensor.full_name()];
    if (sensor.samples() == use.last_sample) return;
    use.last_sample = sensor.samples();
    ++use.count;
  }
  /// By the sensor's full name.
  std::uint64_t count(const std::string& full_name) const {
    const auto use = uses_.find(full_name);
    return use == uses_.end() ? 0 : use->second.count;
  }

 private:
  struct Use {
    std::uint64_t last_sample = 0;
    std::uint64_t count = 0;
  };
  std::map<std::string, Use> uses_;
};

}  // namespace ccmorse::servers
