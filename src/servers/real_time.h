#pragma once

#include <chrono>

namespace ccmorse::servers {

// How runs and replays keep up with the clock.

/// Behind the clock by more than this they go on from where they are.
inline constexpr auto kGiveUpCatchingUp = std::chrono::seconds(1);

/// Of what connections bring, in one tick: at full speed no flood of requests stops time.
inline constexpr int kHandlersPerTick = 64;

}  // namespace ccmorse::servers
