// Pause, step and speed (docs/protocols/ccmorse-services.md).

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using std::chrono::milliseconds;
using testing::LineClient;

Json Ask(LineClient& client, const std::string& line) {
  const std::string reply = client.Ask("t " + line);
  EXPECT_EQ(reply.substr(0, 9), "t SUCCESS") << line << ": " << reply;
  return reply.size() > 10 ? Json::Parse(reply.substr(10)) : Json();
}

std::int64_t Tick(LineClient& client) { return Ask(client, "ccmorse time").Find("tick")->AsInt(); }

TEST(Time, APauseStopsTimeAndResumeLetsItGoOn) {
  for (const Pace pace : {Pace::kRealTime, Pace::kMax}) {
    ServedSimulation served("{}", pace);
    LineClient client(served.port());
    Ask(client, "ccmorse pause");
    Ask(client, "ccmorse pause");  // once is enough
    const std::int64_t tick = Tick(client);
    EXPECT_TRUE(Ask(client, "ccmorse time").Find("paused")->AsBool());
    for (int i = 0; i < 100; ++i) EXPECT_EQ(Tick(client), tick);
    Ask(client, "ccmorse resume");
    EXPECT_FALSE(Ask(client, "ccmorse time").Find("paused")->AsBool());
    Ask(client, "time sleep [0.1]");  // is over, so time goes on
    EXPECT_GE(Tick(client), tick + 6);
  }
}

TEST(Time, AStepIsExactlySoManyTicksAndIsAnsweredWhenTheyAreOver) {
  for (const Pace pace : {Pace::kRealTime, Pace::kMax}) {
    ServedSimulation served("{}", pace);
    LineClient client(served.port());
    Ask(client, "ccmorse pause");
    const std::int64_t tick = Tick(client);
    EXPECT_NEAR(Ask(client, "ccmorse step").AsDouble(), static_cast<double>(tick + 1) / 60.0, 1e-9);
    EXPECT_EQ(Tick(client), tick + 1);
    Ask(client, "ccmorse step [10]");
    EXPECT_EQ(Tick(client), tick + 11);
    // Steps that are asked for in one breath add up.
    client.Send("a ccmorse step [2]\nb ccmorse step [3]\n");
    EXPECT_EQ(client.ReadLine().value().substr(0, 9), "a SUCCESS");
    EXPECT_EQ(client.ReadLine().value().substr(0, 9), "b SUCCESS");
    EXPECT_EQ(Tick(client), tick + 16);
  }
}

TEST(Time, AStepStopsARunThatGoesOn) {
  ServedSimulation served("{}", Pace::kMax);
  LineClient client(served.port());
  Ask(client, "ccmorse step [3]");
  const std::int64_t tick = Tick(client);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(Tick(client), tick);
}

TEST(Time, CommandsOfAPauseActWhenItIsOver) {
  ServedSimulation served(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})", Pace::kMax);
  LineClient client(served.port());
  Ask(client, "ccmorse pause");
  Ask(client, "s1r.motion set_speed [0.3, 0]");
  Ask(client, "ccmorse step [60]");
  Ask(client, "s1r.motion set_speed [0, 0]");
  Ask(client, "ccmorse step");
  EXPECT_NEAR(Ask(client, "s1r.pose get_local_data").Find("x")->AsDouble(), 1.5, 1e-9);
}

TEST(Time, ClientsInLockstepWaitInAPauseAndNoneIsLetGoForIt) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 2, {}, 0.4);
  LineClient master(served.port());
  LineClient one(served.port());
  LineClient two(served.port());
  one.Ask("1 ccmorse read");
  two.Ask("1 ccmorse read");
  Ask(master, "ccmorse pause");
  one.Send("2 ccmorse read\n");
  // Twice as long as a client may hang.
  EXPECT_FALSE(two.IsClosed(milliseconds(800)));
  two.Send("2 ccmorse read\n");
  EXPECT_FALSE(one.ReadLine(milliseconds(100))) << "both wait, and still time stands";
  EXPECT_EQ(Tick(master), 0);
  Ask(master, "ccmorse resume");
  EXPECT_EQ(one.ReadLine().value().substr(0, 9), "2 SUCCESS");
  EXPECT_EQ(two.ReadLine().value().substr(0, 9), "2 SUCCESS");
  // One that hangs afterwards is let go as ever.
  one.Send("3 ccmorse read\n");
  EXPECT_TRUE(two.IsClosed());
}

TEST(Time, ARunWithPausesAndStepsHasTheSameHash) {
  const auto run = [](bool with_pauses) {
    ServedSimulation served(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})", Pace::kLockstep,
                            3.0);
    LineClient client(served.port());
    LineClient master(served.port());
    for (int i = 0; i < 31; ++i) {
      client.Send("1 s1r.motion set_speed [0.2, " + std::to_string(i % 5 - 2) + "]\n");
      client.Send("2 ccmorse read\n");
      if (with_pauses && i % 3 == 1) {
        Ask(master, "ccmorse pause");
        if (i % 2 == 0) Ask(master, "ccmorse step [2]");
        Ask(master, "ccmorse resume");
      }
      if (with_pauses && i == 20) Ask(master, "ccmorse set_speed [20]");
      client.ReadLine();
      client.ReadLine();
    }
    served.Join();
    return served.simulation().Hash();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(Time, TheSpeedChangesWhileItIsWaitedFor) {
  ServedSimulation served("{}", Pace::kRealTime);
  LineClient client(served.port());
  Ask(client, "ccmorse set_speed [0.001]");  // a tick takes 17 s
  EXPECT_EQ(Ask(client, "ccmorse time").Find("speed")->AsDouble(), 0.001);
  const auto start = std::chrono::steady_clock::now();
  client.Send("s time sleep [5]\n");
  LineClient other(served.port());
  Ask(other, "ccmorse set_speed [\"max\"]");
  EXPECT_EQ(Ask(other, "ccmorse time").Find("speed")->AsString(), "max");
  EXPECT_EQ(client.ReadLine(), "s SUCCESS");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4));
}

TEST(Time, ASpeedIsALimitForOtherPaces) {
  for (const Pace pace : {Pace::kLockstep, Pace::kMax}) {
    ServedSimulation served("{}", pace);
    LineClient client(served.port());
    Ask(client, "ccmorse set_speed [4]");
    client.Ask("0 ccmorse read");
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t from = Tick(client);
    for (int i = 0; i < 8; ++i) client.Ask("1 ccmorse read");
    const double simulated = static_cast<double>(Tick(client) - from) / 60.0;
    const double wall =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GE(simulated, 0.7);
    EXPECT_LE(simulated, 4.0 * wall + 2.0 / 60.0);
  }
}

TEST(Time, AnEndComesInAPause) {
  ServedSimulation served("{}", Pace::kRealTime);
  LineClient client(served.port());
  Ask(client, "ccmorse pause");
  client.Ask("q simulation quit");
  served.Join();
  EXPECT_LT(served.simulation().time(), 60.0);
}

TEST(Time, WrongArgumentsAreRefused) {
  ServedSimulation served("{}", Pace::kMax);
  LineClient client(served.port());
  for (const char* wrong :
       {"set_speed [0]", "set_speed [-1]", "set_speed [1001]", "set_speed [\"fast\"]", "set_speed",
        "step [0]", "step [1.5]", "step [1000001]", "seek [1]", "pause [1]", "log [\"x\"]"}) {
    EXPECT_EQ(client.Ask(std::string("w ccmorse ") + wrong).substr(0, 8), "w FAILED") << wrong;
  }
}

TEST(Time, TheLogIsToBeHad) {
  ServedSimulation served("{}", Pace::kMax);
  LineClient client(served.port());
  const Json before = Ask(client, "ccmorse log");  // no value stands for an empty list
  const std::int64_t last = before.IsArray() ? before.AsArray().back().Find("number")->AsInt() : 0;
  client.Send(std::string(2'000'000, 'x') + "\n");  // too long a line is worth a warning
  client.ReadLine();
  const Json after = Ask(client, "ccmorse log [" + std::to_string(last) + "]");
  ASSERT_FALSE(after.AsArray().empty());
  EXPECT_EQ(after.AsArray()[0].Find("number")->AsInt(), last + 1);
  EXPECT_EQ(after.AsArray()[0].Find("level")->AsString(), "warning");
  EXPECT_NE(after.AsArray()[0].Find("text")->AsString().find("longer than"), std::string::npos);
  EXPECT_LE(Ask(client, "ccmorse log").AsArray().size(), 200U);
}

}  // namespace
}  // namespace ccmorse::servers
