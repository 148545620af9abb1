#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>

#include "servers/morse/service_directory.h"
#include "sim/simulation.h"

namespace ccmorse::servers::player {

/// What devices work on. Both outlive them. Whatever changes the simulation goes through the
/// directory, so that it gets into the run's record.
struct DeviceContext {
  sim::Simulation& simulation;
  ServiceDirectory& directory;

  /// Calls a service; false when it failed or there is none of that name.
  bool Run(std::string_view component, std::string_view service,
           sim::Arguments arguments = {}) const {
    const ServiceDirectory::Target target = directory.Find(component, service);
    if (target.service == nullptr) return false;
    bool succeeded = false;
    directory.Run(target, arguments, [&succeeded](const sim::ServiceResult& result) {
      succeeded = result.outcome == sim::Outcome::kSuccess;
    });
    return succeeded;
  }
};

/// When a device publishes whose sensor samples more often than a client wants: at the first tick
/// at or after each k / frequency (Hz), as sensors sample, so that what has the same rate comes
/// together, stamped alike. Not at time 0, which Player takes for no data (H4).
class PublishRate {
 public:
  explicit PublishRate(double frequency) : frequency_(frequency) {}

  bool TakeDue(const sim::Simulation& simulation) {
    const std::uint64_t tick = simulation.tick();
    if (tick == 0 || tick < next_tick_) return false;
    const double ticks = std::fmax(simulation.scenario().time.frequency / frequency_, 1.0);
    const double k = std::floor(static_cast<double>(tick) / ticks + 1e-9);
    const bool on_time = static_cast<std::uint64_t>(std::ceil(k * ticks - 1e-9)) == tick;
    next_tick_ = static_cast<std::uint64_t>(std::ceil((k + 1.0) * ticks - 1e-9));
    // Someone who has just subscribed waits for the next time.
    return on_time;
  }

 private:
  double frequency_;
  std::uint64_t next_tick_ = 0;
};

}  // namespace ccmorse::servers::player
