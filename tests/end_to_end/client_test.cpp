// The client library against the real simulator.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "libCCMorse/CCMorse.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace {

using namespace CCMorse;  // NOLINT(google-build-using-namespace): as the course's programs write it
using ccmorse::testing::Simulator;
using ccmorse::testing::TemporaryFile;

double CpuSeconds() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

// A client with the S1R's two proxies, in lock-step unless told otherwise.
struct Rig {
  explicit Rig(const std::string& scenario = "course_map", const std::string& pace = "lockstep")
      : simulator({scenario, "--pace", pace}),
        client("localhost", simulator.port()),
        position(&client, 0),
        laser(&client, 0) {}
  Simulator simulator;
  PlayerClient client;
  Position2dProxy position;
  LaserProxy laser;
};

TEST(X19, TheLoopUntilTheFirstFreshScanEndsWithinASecondOfSimulation) {
  Rig rig;
  while (!rig.laser.IsFresh()) {
    rig.client.Read();
    while (rig.client.Peek(0)) rig.client.Read();
  }
  EXPECT_LE(rig.laser.GetDataTime(), 1.0);
}

TEST(X18, PeekIsFalseRightAfterAReadInLockstep) {
  Rig rig;
  for (int i = 0; i < 20; ++i) {
    rig.client.Read();
    EXPECT_FALSE(rig.client.Peek(0));
  }
}

TEST(X18, PeekIsFalseInRealTimeUntilTheNextDataAreDue) {
  // Data every two seconds: no machine is so busy that they come between Read() and Peek().
  const TemporaryFile file(".json", R"({"time": {"read_frequency": 0.5}})");
  Rig rig(file.path(), "real");
  rig.client.Read();
  EXPECT_FALSE(rig.client.Peek(0));
  EXPECT_TRUE(rig.client.Peek(30000));
  rig.client.Read();
}

TEST(X18, AProgramThatOnlyPeeksIsNotStarvedInLockstep) {
  Rig rig;
  int reads = 0;
  for (int i = 0; i < 100; ++i) {
    if (!rig.client.Peek(0)) continue;
    rig.client.Read();
    ++reads;
  }
  EXPECT_GT(reads, 20);
}

TEST(X26, PositionIsGroundTruth) {
  Rig rig;
  rig.client.Read();
  rig.position.SetMotorEnable(true);
  rig.position.SetSpeed(0.3, 0.0);
  const double yaw = 150.0 * PI / 180.0;
  for (int i = 1; i <= 5; ++i) {
    rig.client.Read();
    EXPECT_NEAR(rig.position.GetXPos(), 1.20 + 0.03 * i * std::cos(yaw), 1e-9);
    EXPECT_NEAR(rig.position.GetYPos(), 2.00 + 0.03 * i * std::sin(yaw), 1e-9);
    EXPECT_NEAR(rig.position.GetYaw(), yaw, 1e-9);
  }
  EXPECT_NEAR(rig.position.GetXSpeed(), 0.3, 1e-9);
}

TEST(X24, SwitchingTheMotorsOffStopsTheRobot) {
  Rig rig;
  rig.client.Read();
  rig.position.SetMotorEnable(true);
  rig.position.SetSpeed(0.3, 0.5);
  rig.client.Read();
  rig.client.Read();
  EXPECT_GT(rig.position.GetXSpeed(), 0.0);
  rig.position.SetMotorEnable(false);
  rig.client.Read();
  rig.client.Read();
  EXPECT_EQ(rig.position.GetXSpeed(), 0.0);
  EXPECT_EQ(rig.position.GetYawSpeed(), 0.0);
}

TEST(G06, FreshnessCountsEachScanOnce) {
  // A laser of 5 Hz read ten times a second: half of the reads bring a new scan.
  const TemporaryFile file(".json", R"({"robots": [{"laser": {"frequency": 5}}]})");
  Rig rig(file.path());
  int fresh = 0;
  for (int i = 0; i < 20; ++i) {
    rig.client.Read();
    fresh += rig.laser.IsFresh() ? 1 : 0;
    rig.laser.NotFresh();
  }
  EXPECT_EQ(fresh, 10);
}

TEST(X32, TheScanIsTheS1Rs) {
  Rig rig;
  rig.client.Read();
  EXPECT_EQ(rig.laser.GetCount(), 682U);
  EXPECT_NEAR(rig.laser.GetMinAngle(), -2.356, 1e-3);
  EXPECT_NEAR(rig.laser.GetMaxAngle(), 2.356, 1e-3);
  EXPECT_EQ(rig.laser.GetMaxRange(), 5.0);
  EXPECT_NEAR(rig.laser.GetScanRes(), 0.0069096, 1e-7);
}

TEST(X44, ReadPacesTheLoopInRealTime) {
  Rig rig("course_map", "real");
  rig.client.Read();
  const double start = rig.laser.GetDataTime();
  const double cpu = CpuSeconds();
  const auto wall = std::chrono::steady_clock::now();
  int loops = 0;
  while (rig.laser.GetDataTime() < start + 1.95) {
    rig.client.Read();
    ++loops;
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  // One turn a scan, however busy the machine is: a turn may come late, never twice.
  EXPECT_LE(loops, 20);
  EXPECT_GE(loops, 5);
  EXPECT_LT(CpuSeconds() - cpu, 0.5 * seconds);
}

TEST(X14, TheWindowHasTheSizeAskedForAndCornersMapToItsEnds) {
  Rig rig;
  WindowProxy& window = WindowProxy::GetInstance(&rig.client, 172, 186);
  EXPECT_EQ(window.GetWidth(), 172);
  EXPECT_EQ(window.GetHeight(), 186);
  EXPECT_EQ(window.GetX(0.0), 0);
  EXPECT_EQ(window.GetY(0.0), 0);
  EXPECT_EQ(window.GetX(3.42), 171);
  EXPECT_EQ(window.GetY(3.72), 185);
  delete &WindowProxy::GetInstance();
  WindowProxy& again = WindowProxy::GetInstance(&rig.client, 171, 186);
  EXPECT_EQ(again.GetWidth(), 171);
  delete &again;
}

TEST(X29, LinesAndPixelsArriveOnTheCanvas) {
  Rig rig;
  WindowProxy& window = WindowProxy::GetInstance(&rig.client, 172, 186);
  window.SetLine(0, 0, 10, 0, 0, 255, 0);
  window.SetPixel(10, 0, 255, 0, 255);
  rig.client.Read();
  ccmorse::testing::LineClient raw(rig.simulator.port());
  EXPECT_EQ(raw.Ask("1 s1r.pen get_pixel [5, 0]"), "1 SUCCESS [0, 255, 0]");
  EXPECT_EQ(raw.Ask("1 s1r.pen get_pixel [10, 0]"), "1 SUCCESS [255, 0, 255]");
  delete &window;
}

TEST(L206, TheWaypointActuatorDrivesToItsGoal) {
  Rig rig("syrotek");
  rig.client.Read();
  rig.position.GoTo(1.654, 1.85, 0.0);
  double distance = 1e9;
  for (int i = 0; i < 300 && distance > 0.2; ++i) {
    rig.client.Read();
    distance = std::hypot(rig.position.GetXPos() - 1.654, rig.position.GetYPos() - 1.85);
  }
  EXPECT_LE(distance, 0.2);
}

TEST(L211, TheSecondLayerAloneControlsTheRobot) {
  Simulator simulator({"course_map", "--pace", "lockstep"});
  MorseClient& morse = MorseClient::GetInstance("localhost", simulator.port());
  MorseRobot& robot = morse.GetRobot("s1r");
  EXPECT_NEAR(robot.GetWeight(), 2.0, 1e-12);
  MorsePose& pose = robot.GetDevice<MorsePose>();
  morse.Read();
  robot.GetDevice<MorseMotionVW>().SetSpeed(0.2, 0.0);
  const double x = pose.GetX();
  for (int i = 0; i < 10; ++i) morse.Read();
  EXPECT_NEAR(std::abs(pose.GetX() - x), 0.2 * std::cos(PI / 6), 1e-6);
  EXPECT_EQ(robot.GetDevice<MorseLaser>().GetRanges().size(), 682U);
  morse.Close();
}

TEST(K17, ASeparateReadingThreadAndASingleLoopBothWork) {
  Rig rig("course_map", "max");
  std::atomic<bool> quit = false;
  std::thread reader([&] {
    while (!quit) rig.client.Read();
  });
  double sum = 0.0;
  for (int i = 0; i < 2000; ++i) {
    rig.position.SetSpeed(0.1, i % 2 == 0 ? 0.2 : -0.2);
    if (rig.laser.IsFresh()) rig.laser.NotFresh();
    sum += rig.position.GetXPos() + rig.laser.GetCount();
  }
  quit = true;
  reader.join();
  EXPECT_TRUE(std::isfinite(sum));
  rig.client.Read();
  EXPECT_EQ(rig.laser.GetCount(), 682U);
}

TEST(K09, TwoRobotsEachWithTheirProxies) {
  Simulator simulator({"two_robots", "--pace", "lockstep"});
  PlayerClient client("localhost", simulator.port());
  Position2dProxy one(&client, 0);
  Position2dProxy two(&client, 10);
  client.Read();
  EXPECT_NEAR(one.GetXPos(), 1.20, 1e-9);
  EXPECT_NEAR(two.GetXPos(), 2.20, 1e-9);
  EXPECT_THROW(Position2dProxy(&client, 5), MorseError);
}

TEST(Faults, NoServerIsAnErrorThatNamesHostPortAndFunction) {
  const auto start = std::chrono::steady_clock::now();
  try {
    PlayerClient client("localhost", 1);
    FAIL() << "connected to nothing";
  } catch (const MorseError& error) {
    EXPECT_NE(error.GetErrorStr().find("localhost"), std::string::npos) << error.GetErrorStr();
    EXPECT_NE(error.GetErrorStr().find("1"), std::string::npos);
    EXPECT_FALSE(error.GetErrorFun().empty());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(X20, AServerKilledInMidRunIsAnErrorOutOfRead) {
  for (const char* pace : {"real", "lockstep", "max"}) {
    Rig rig("course_map", pace);
    rig.client.Read();
    rig.simulator.process().Signal(SIGKILL);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(
        {
          for (;;) rig.client.Read();
        },
        MorseError)
        << pace;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
  }
}

TEST(Faults, AServerThatHangsIsAnErrorToo) {
  Rig rig("course_map", "real");
  rig.client.Read();
  rig.simulator.process().Signal(SIGSTOP);
  EXPECT_THROW(
      {
        for (;;) rig.client.Read();
      },
      MorseError);
  rig.simulator.process().Signal(SIGCONT);
}

TEST(Faults, TheEndOfTheSimulationIsToldApartFromALostConnection) {
  Simulator simulator({"course_map", "--pace", "lockstep", "--for", "1"});
  PlayerClient client("localhost", simulator.port());
  try {
    for (;;) client.Read();
  } catch (const MorseError& error) {
    EXPECT_TRUE(error.SimulationEnded()) << error.GetErrorStr();
  }
}

TEST(X39, ProxiesMayOutliveTheirClient) {
  Simulator simulator({"course_map", "--pace", "lockstep"});
  auto client = std::make_unique<PlayerClient>("localhost", simulator.port());
  LaserProxy laser(client.get(), 0);
  Position2dProxy position(client.get(), 0);
  client->Read();
  client.reset();
  EXPECT_EQ(laser.GetCount(), 682U);
  position.SetSpeed(0.1, 0.1);
}

// The arena controller (thesis 5.1), from a program; tests/sim/arena_test.cpp has the rest of it.
TEST(Answers, AProgramHandsInAPathAMapAndAPose) {
  Rig rig;
  auto& answers = MorseClient::GetInstance().GetRobot("s1r").GetDevice<MorseAnswers>();
  answers.SubmitPath({{0.5, 1.25}, {2.0, 3.0}});
  answers.SubmitGrid("map", 2, 3, "01?010", 0.05, 1.0, 2.0);
  answers.SubmitPose(1.0, 2.0, -0.5);
  answers.SubmitJson("other", "{\"a\": [1, null]}");
  EXPECT_EQ(answers.GetSubmitted(), (std::vector<std::string>{"map", "other", "path", "pose"}));
  EXPECT_THROW(answers.SubmitGrid("map", 2, 3, "01?01"), MorseError);
  EXPECT_THROW(answers.SubmitGrid("map", 2, 3, "01x010"), MorseError);
  EXPECT_THROW(answers.SubmitPose(1.0, std::nan(""), 0.0), MorseError);
  EXPECT_THROW(answers.SubmitJson("other", "{"), MorseError);
  EXPECT_THROW(answers.Submit("", std::vector<double>{1.0}), MorseError);
}

TEST(N01, AProgramRaisesAndLowersObstacles) {
  Rig rig("syrotek");
  MorseArena arena(MorseClient::GetInstance());
  const std::vector<MorseObstacle> obstacles = arena.GetObstacles();
  ASSERT_GE(obstacles.size(), 17U);
  const int id = obstacles.front().id;
  EXPECT_FALSE(arena.IsRaised(id));
  EXPECT_TRUE(arena.Raise({id}).empty());
  EXPECT_TRUE(arena.IsRaised(id));
  arena.Toggle({id});
  EXPECT_FALSE(arena.IsRaised(id));
  arena.Raise({id});
  arena.Lower({id});
  EXPECT_FALSE(arena.IsRaised(id));
  EXPECT_THROW(arena.Raise({1000}), MorseError);
  EXPECT_THROW(arena.IsRaised(1000), MorseError);
}

TEST(N01, AnObstacleUnderARobotWaits) {
  Rig rig("syrotek");
  rig.client.Read();
  MorseArena arena(MorseClient::GetInstance());
  const int id = arena.GetObstacles().front().id;
  player_pose2d_t here{};
  here.px = rig.position.GetXPos();
  here.py = rig.position.GetYPos();
  arena.Move(id, here);  // it is down
  EXPECT_EQ(arena.Raise({id}), std::vector<int>{id});
  EXPECT_THROW(arena.Move(1000, here), MorseError);
  EXPECT_TRUE(arena.GetObstacles().front().waiting);
}

TEST(N02, AProgramKeepsAndLoadsPresets) {
  Rig rig("syrotek");
  MorseArena arena(MorseClient::GetInstance());
  const std::vector<MorseObstacle> obstacles = arena.GetObstacles();
  const std::vector<int> some = {obstacles[0].id, obstacles[1].id};
  arena.Raise(some);
  EXPECT_EQ(arena.SavePreset("some"), some);
  arena.Lower(some);
  arena.LoadPreset("some");
  EXPECT_TRUE(arena.IsRaised(some[1]));
  EXPECT_EQ(arena.GetPresets().at("some"), some);
  EXPECT_THROW(arena.LoadPreset("none"), MorseError);
}

TEST(N03, AProgramSetsATimer) {
  Rig rig("syrotek");
  MorseArena arena(MorseClient::GetInstance());
  const int id = arena.GetObstacles().front().id;
  MorseObstacleAction action;
  action.up = {id};
  arena.AddTimer(1.0, action);
  while (rig.laser.GetDataTime() < 0.95) rig.client.Read();
  EXPECT_FALSE(arena.IsRaised(id));
  while (rig.laser.GetDataTime() < 1.15) rig.client.Read();
  EXPECT_TRUE(arena.IsRaised(id));
}

TEST(N04, AProgramSetsATrap) {
  Rig rig("syrotek");
  MorseArena arena(MorseClient::GetInstance());
  const int id = arena.GetObstacles().front().id;
  rig.client.Read();
  MorseObstacleAction action;
  action.up = {id};
  // A square 0.3 m ahead of it.
  const double x = rig.position.GetXPos() + 0.3 * std::cos(rig.position.GetYaw());
  const double y = rig.position.GetYPos() + 0.3 * std::sin(rig.position.GetYaw());
  const auto corner = [&](double dx, double dy) {
    player_point_2d_t point{};
    point.px = x + dx;
    point.py = y + dy;
    return point;
  };
  arena.AddTrap("ahead",
                {corner(-0.1, -0.1), corner(0.1, -0.1), corner(0.1, 0.1), corner(-0.1, 0.1)},
                action);
  rig.client.Read();
  EXPECT_FALSE(arena.IsRaised(id));
  rig.position.SetMotorEnable(true);
  for (int i = 0; i < 30; ++i) {
    rig.position.SetSpeed(0.2, 0.0);
    rig.client.Read();
  }
  EXPECT_TRUE(arena.IsRaised(id));
}

}  // namespace
