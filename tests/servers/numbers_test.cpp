// MORSE's protocol in figures: how fast services are answered. The limit is the one that is
// promised, far from what is measured.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using Clock = std::chrono::steady_clock;
using testing::LineClient;

double Seconds(Clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

TEST(Numbers, OfAHundredThousandServiceRequests99PercentAreAnsweredWithinOneTick) {
  ServedSimulation served("{}");
  LineClient client(served.port());
  constexpr std::size_t kRequests = 100'000;
  std::vector<double> seconds;
  seconds.reserve(kRequests);
  for (std::size_t i = 0; i < kRequests; ++i) {
    const auto start = Clock::now();
    const std::string reply = client.Ask("1 s1r.pose get_local_data");
    seconds.push_back(Seconds(Clock::now() - start));
    ASSERT_TRUE(reply.starts_with("1 SUCCESS {")) << reply;
  }
  std::sort(seconds.begin(), seconds.end());
  const double p50 = seconds[kRequests / 2];
  const double p99 = seconds[kRequests * 99 / 100];
  std::printf("100,000 requests: median %.1f us, p99 %.1f us, longest %.1f ms\n", p50 * 1e6,
              p99 * 1e6, seconds.back() * 1e3);
  EXPECT_LT(p99, 1.0 / 60.0);
}

}  // namespace
}  // namespace ccmorse::servers
