// Reading at a pace (docs/protocols/ccmorse-services.md).

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

double TimeOf(const std::string& reply) {
  return Json::Parse(reply.substr(reply.find('{'))).Find("time")->AsDouble();
}

TEST(Lockstep, TimeStandsStillUntilTheClientReads) {
  ServedSimulation served("{}", Pace::kLockstep);
  LineClient client(served.port());
  EXPECT_EQ(client.Ask("1 time now"), "1 SUCCESS");  // 0.0 is falsy
  EXPECT_EQ(TimeOf(client.Ask("2 ccmorse read")), 0.0);
  EXPECT_EQ(client.Ask("3 time now"), "3 SUCCESS");
  EXPECT_NEAR(TimeOf(client.Ask("4 ccmorse read")), 0.1, 1e-12);
  EXPECT_EQ(client.Ask("5 time now"), "5 SUCCESS 0.1");
}

TEST(Lockstep, CommandsActFromTheInstantOfTheLastRead) {
  ServedSimulation served(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})", Pace::kLockstep);
  LineClient client(served.port());
  client.Ask("1 ccmorse read");
  client.Send("2 s1r.motion set_speed [0.3, 0]\n3 ccmorse read\n4 s1r.pose get_local_data\n");
  client.ReadLine();
  client.ReadLine();
  const std::string reply = client.ReadLine().value();
  EXPECT_NEAR(Json::Parse(reply.substr(reply.find('{'))).Find("x")->AsDouble(), 1.23, 1e-12);
}

TEST(Lockstep, RequestsBehindAReadWaitForIt) {
  ServedSimulation served("{}", Pace::kLockstep);
  LineClient client(served.port());
  client.Send("1 ccmorse read\n2 ccmorse read\n3 ccmorse read\n4 time now\n");
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(client.ReadLine().value().substr(0, 1), std::to_string(i));
  }
  EXPECT_EQ(client.ReadLine(), "4 SUCCESS 0.2");
}

TEST(Lockstep, TimeWaitsForTheSlowestClient) {
  ServedSimulation served("{}", Pace::kLockstep);
  LineClient one(served.port());
  LineClient two(served.port());
  one.Ask("1 ccmorse read");
  two.Ask("1 ccmorse read");
  one.Send("2 ccmorse read\n");
  EXPECT_FALSE(one.ReadLine(std::chrono::milliseconds(100)));
  EXPECT_EQ(one.Ask("p ccmorse ping"), "p SUCCESS \"pong\"");  // it is alive, it only waits
  two.Send("2 ccmorse read\n");
  EXPECT_NEAR(TimeOf(one.ReadLine().value()), 0.1, 1e-12);
  EXPECT_NEAR(TimeOf(two.ReadLine().value()), 0.1, 1e-12);
}

TEST(Lockstep, TimeStartsWhenAsManyClientsAsAskedForRead) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 2);
  LineClient one(served.port());
  EXPECT_EQ(TimeOf(one.Ask("1 ccmorse read")), 0.0);
  one.Send("2 ccmorse read\n");
  EXPECT_FALSE(one.ReadLine(std::chrono::milliseconds(100)));
  LineClient two(served.port());
  EXPECT_EQ(TimeOf(two.Ask("1 ccmorse read")), 0.0);
  two.Send("2 ccmorse read\n");
  EXPECT_NEAR(TimeOf(one.ReadLine().value()), 0.1, 1e-12);
  EXPECT_NEAR(TimeOf(two.ReadLine().value()), 0.1, 1e-12);
}

TEST(Lockstep, AClientThatDiesIsNotWaitedFor) {
  ServedSimulation served("{}", Pace::kLockstep);
  LineClient one(served.port());
  auto two = std::make_unique<LineClient>(served.port());
  one.Ask("1 ccmorse read");
  two->Ask("1 ccmorse read");
  one.Send("2 ccmorse read\n");
  two->Reset();
  EXPECT_NEAR(TimeOf(one.ReadLine().value()), 0.1, 1e-12);
}

TEST(Lockstep, AClientThatHangsIsLetGo) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 1, {}, 0.2);
  LineClient hangs(served.port());
  LineClient other(served.port());
  hangs.Ask("1 ccmorse read");
  other.Ask("1 ccmorse read");
  other.Send("2 ccmorse read\n");
  EXPECT_NEAR(TimeOf(other.ReadLine().value()), 0.1, 1e-12);
  EXPECT_TRUE(hangs.IsClosed());
}

TEST(Lockstep, AClientThatShowsLifeIsWaitedFor) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 1, {}, 1.0);
  LineClient busy(served.port());
  LineClient other(served.port());
  busy.Ask("1 ccmorse read");
  other.Ask("1 ccmorse read");
  other.Send("2 ccmorse read\n");
  for (int i = 0; i < 15; ++i) {
    EXPECT_FALSE(other.ReadLine(std::chrono::milliseconds(100)));
    EXPECT_EQ(busy.Ask("2 ccmorse ping"), "2 SUCCESS \"pong\"");
  }
}

TEST(Lockstep, AClientThatIsAloneMayTakeItsTime) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 1, {}, 0.05);
  LineClient client(served.port());
  client.Ask("1 ccmorse read");
  EXPECT_FALSE(client.IsClosed(std::chrono::milliseconds(300)));
  EXPECT_NEAR(TimeOf(client.Ask("2 ccmorse read")), 0.1, 1e-12);
}

TEST(Lockstep, WithoutATimeLimitAClientIsWaitedForWithoutEnd) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 1, {}, 0.0);
  LineClient slow(served.port());
  LineClient other(served.port());
  slow.Ask("1 ccmorse read");
  other.Ask("1 ccmorse read");
  other.Send("2 ccmorse read\n");
  EXPECT_FALSE(other.ReadLine(std::chrono::milliseconds(300)));
  slow.Send("2 ccmorse read\n");
  EXPECT_TRUE(other.ReadLine());
}

TEST(Lockstep, TheSameCommandsGiveTheSameRun) {
  const auto run = [](int packets) {
    ServedSimulation served("{}", Pace::kLockstep, 5.0);
    {
      LineClient client(served.port());
      for (int i = 0; i <= 50; ++i) {  // the last one reads the end
        const std::string w = std::to_string(i % 3 - 1);
        client.Send("1 s1r.motion set_speed [0.2, " + w + "]\n");
        if (packets > 1) client.Ask("2 time now");
        client.Send("3 ccmorse read\n");
        client.ReadLine();
        client.ReadLine();
      }
    }
    served.Join();
    return served.simulation().Hash();
  };
  EXPECT_EQ(run(1), run(2));
}

TEST(Lockstep, TheEndIsAnnouncedToReaders) {
  ServedSimulation served("{}", Pace::kLockstep, 1.0);
  LineClient client(served.port());
  std::string reply;
  int reads = 0;
  for (; (reply = client.Ask("1 ccmorse read")).find("SUCCESS") != std::string::npos; ++reads) {
  }
  EXPECT_EQ(reads, 10);
  EXPECT_EQ(reply, R"(1 FAILED "The simulation has ended at 1.000 s")");
}

TEST(RealTime, AReadWaitsForTheNextDataAndASlowReaderGetsTheNewest) {
  ServedSimulation served("{}");
  LineClient client(served.port());
  const double first = TimeOf(client.Ask("1 ccmorse read"));
  const double second = TimeOf(client.Ask("2 ccmorse read"));
  EXPECT_GT(second, first);
  client.Ask("3 time sleep [0.5]");
  const double late = TimeOf(client.Ask("4 ccmorse read"));
  EXPECT_GE(late, second + 0.4);
  EXPECT_EQ(client.Ask("5 ccmorse peek [2]"), "5 SUCCESS true");
}

TEST(RealTime, TheClockTellsWhenDataAreDue) {
  ServedSimulation served(R"({"time": {"read_frequency": 60}})");
  LineClient client(served.port());
  client.Ask("1 ccmorse read");
  const auto seconds = [](const std::string& reply, const char* key) {
    return Json::Parse(reply.substr(reply.find('{'))).Find(key)->AsDouble();
  };
  const std::string clock = client.Ask("2 ccmorse clock");
  const double zero = seconds(clock, "due") - seconds(clock, "time");
  for (int i = 0; i < 30; ++i) {
    const double time = TimeOf(client.Ask("3 ccmorse read"));
    const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
    EXPECT_GE(now.count(), zero + time);  // never early, however late a busy machine makes it
    const double sent = seconds(client.Ask("4 ccmorse clock"), "sent");
    EXPECT_GE(sent, zero + time);
    EXPECT_LE(sent, now.count());
  }
  ServedSimulation lockstep("{}", Pace::kLockstep);
  EXPECT_EQ(LineClient(lockstep.port()).Ask("1 ccmorse clock"),
            "1 FAILED \"Only real time goes by a clock\"");
}

TEST(RealTime, HelloSaysWhatRuns) {
  ServedSimulation served("{}");
  LineClient client(served.port());
  const std::string reply = client.Ask("1 ccmorse hello [{\"client\": \"test\"}]");
  EXPECT_NE(reply.find("\"pace\": \"realtime\""), std::string::npos) << reply;
  EXPECT_NE(reply.find("\"read_period\": 0.1"), std::string::npos) << reply;
}

}  // namespace
}  // namespace ccmorse::servers
