// MORSE's port of time synchronisation (specs: morse.md A.6).

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using std::chrono::milliseconds;
using testing::LineClient;

constexpr const char* kScene = R"({"time": {"sync_port": 6000}})";

std::int64_t Tick(LineClient& client) {
  const std::string reply = client.Ask("t ccmorse time");
  return Json::Parse(reply.substr(10)).Find("tick")->AsInt();
}

// The tick, once time has stood still as long as several ticks would take.
std::int64_t StandingTick(LineClient& client) {
  std::int64_t tick = Tick(client);
  for (int same = 0; same < 5;) {
    EXPECT_FALSE(client.ReadLine(milliseconds(20)));
    const std::int64_t now = Tick(client);
    same = now == tick ? same + 1 : 0;
    tick = now;
  }
  return tick;
}

void ExpectTick(LineClient& client, std::int64_t tick) {
  for (int i = 0; i < 500 && Tick(client) < tick; ++i) client.ReadLine(milliseconds(5));
  EXPECT_EQ(StandingTick(client), tick);
}

class SyncPortTest : public ::testing::TestWithParam<Pace> {};

TEST_P(SyncPortTest, OneRecvIsOneTick) {
  ServedSimulation served(kScene, GetParam());
  LineClient client(served.port());
  LineClient master(served.sync_port());
  const std::int64_t start = StandingTick(client);  // while it free-wheeled nobody was connected
  for (int i = 1; i <= 20; ++i) {
    master.Send(i % 2 == 0 ? "sync" : "\n");  // whatever it is
    ExpectTick(client, start + i);
  }
}

TEST_P(SyncPortTest, WhatIsMoreThan2048BytesIsMoreTicks) {
  ServedSimulation served(kScene, GetParam());
  LineClient client(served.port());
  LineClient master(served.sync_port());
  const std::int64_t start = StandingTick(client);
  client.Ask("p ccmorse pause");  // so that all of it is there before any is taken
  master.Send(std::string(3 * 2048, 'x'));
  EXPECT_FALSE(client.ReadLine(milliseconds(50)));
  client.Ask("p ccmorse resume");
  ExpectTick(client, start + 3);
}

TEST_P(SyncPortTest, WithoutAClientTimeGoesByItself) {
  ServedSimulation served(kScene, GetParam());
  LineClient client(served.port());
  EXPECT_EQ(client.Ask("1 time sleep [0.1]"), "1 SUCCESS");
  for (const bool sudden : {false, true}) {
    auto master = std::make_unique<LineClient>(served.sync_port());
    StandingTick(client);
    if (sudden) master->Reset();
    master.reset();
    EXPECT_EQ(client.Ask("2 time sleep [0.1]"), "2 SUCCESS");
  }
}

TEST_P(SyncPortTest, ServicesAreAnsweredWhileATickIsWaitedFor) {
  ServedSimulation served(kScene, GetParam());
  LineClient client(served.port());
  const LineClient master(served.sync_port());
  const std::int64_t start = StandingTick(client);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(client.Ask("1 simulation list_robots"), "1 SUCCESS [\"s1r\"]");
  EXPECT_EQ(Tick(client), start);
  EXPECT_EQ(client.Ask("1 simulation quit"), "1 SUCCESS");
  served.Join();
}

TEST_P(SyncPortTest, ASecondClientWaitsUntilTheFirstHasLeft) {
  ServedSimulation served(kScene, GetParam());
  LineClient client(served.port());
  auto first = std::make_unique<LineClient>(served.sync_port());
  std::int64_t tick = StandingTick(client);
  LineClient second(served.sync_port());
  second.Send("sync");
  EXPECT_EQ(StandingTick(client), tick);
  first->Send("sync");
  ExpectTick(client, tick + 1);
  first.reset();
  ExpectTick(client, tick + 2);  // what the second has sent
  second.Send("sync");
  ExpectTick(client, tick + 3);
}

std::string NameOfPace(const ::testing::TestParamInfo<Pace>& info) { return PaceName(info.param); }

INSTANTIATE_TEST_SUITE_P(A6, SyncPortTest, ::testing::Values(Pace::kRealTime, Pace::kMax),
                         NameOfPace);

}  // namespace
}  // namespace ccmorse::servers
