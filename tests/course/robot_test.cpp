// The course's robot, built for the simulator (_MORSE), over the stand-in library.
#include "courses/par/intro/solutions/thesis/robot.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <type_traits>

#include "courses/par/intro/solutions/thesis/avoidance.h"
#include "imr-h/imr_exceptions.h"
#include "tests/course/match.h"
#include "tests/course/robot_fixture.h"

namespace {

using imr::robot::CRobot;
using Strings = std::vector<std::string>;

// Names the ids in the names of the tests.
class X08 : public course::RobotTest {};
class X10 : public course::RobotTest {};
class X14 : public course::RobotTest {};
class X16 : public course::RobotTest {};
class X18 : public course::RobotTest {};
class X20 : public course::RobotTest {};
class X21 : public course::RobotTest {};
class X24 : public course::RobotTest {};
class X29 : public course::RobotTest {};
class X31 : public course::RobotTest {};
class X37 : public course::RobotTest {};
class X38 : public course::RobotTest {};
class X39 : public course::RobotTest {};
class X43 : public course::RobotTest {};
class Q08 : public course::RobotTest {};
class Q09 : public course::RobotTest {};
class IntroRobot : public course::RobotTest {};

// Opens the protected part.
class Opened : public CRobot {
 public:
  using CRobot::CRobot;
  using CRobot::navigation;
  using CRobot::threadBody;
};

}  // namespace

TEST(X01, RobotIsAThreadInNamespaceImrRobot) {
  static_assert(std::is_base_of_v<imr::concurrent::CThread, imr::robot::CRobot>);
  static_assert(std::is_convertible_v<imr::robot::CRobot*, imr::concurrent::CThread*>, "public");
}

TEST(X02, PublicMembersHaveTheListingsSignatures) {
  imr::CConfig& (*get_config)(imr::CConfig&) = &CRobot::getConfig;
  void (CRobot::*stop)() = &CRobot::stop;
  static_assert(std::is_constructible_v<CRobot, imr::CConfig&>);
  static_assert(!std::is_constructible_v<CRobot, const imr::CConfig&>);
  static_assert(std::is_destructible_v<CRobot>);
  imr::CConfig config;
  EXPECT_EQ(&get_config(config), &config);
  EXPECT_NE(stop, nullptr);
}

TEST(X03, ThreadBodyAndNavigationAreProtected) {
  void (Opened::*thread_body)() = &Opened::threadBody;
  void (Opened::*navigation)() = &Opened::navigation;
  EXPECT_NE(thread_body, nullptr);
  EXPECT_NE(navigation, nullptr);
}

TEST_F(X08, ServerDefaultsForTheSimulator) {
  EXPECT_EQ(config_.get<std::string>("host"), "localhost");
  EXPECT_EQ(config_.getDescription<std::string>("host"), "morse server hostname");
  EXPECT_EQ(config_.get<int>("port"), 4000);
  EXPECT_EQ(config_.getDescription<int>("port"), "morse server port");
}

TEST_F(X10, OptionsAndDefaultsAreTheListings) {
  EXPECT_EQ(course::Dump(config_),
            "host=localhost\nport=4000\nlaser-index=0\nposition2d-index=0\ncoords=false\n"
            "x=0\ny=0\nyaw=0\n");
  EXPECT_EQ(config_.getType("coords"), imr::CConfig::BOOL);
  for (const char* name : {"x", "y", "yaw"}) {
    EXPECT_EQ(config_.getType(name), imr::CConfig::DOUBLE);
  }
  for (const char* name : {"laser-index", "position2d-index"}) {
    EXPECT_EQ(config_.getType(name), imr::CConfig::INT);
  }
  EXPECT_THROW(CRobot::getConfig(config_), imr::bad_usage);
}

TEST_F(X14, ConstructorMakesEverythingInTheListingsOrder) {
  config_.set<std::string>("host", "robot3");
  config_.set<int>("port", 4001);
  config_.set<int>("laser-index", 1);
  config_.set<int>("position2d-index", 2);
  { CRobot robot(config_); }
  const Strings calls = world_.Calls();
  ASSERT_GE(calls.size(), 8u);
  EXPECT_EQ(Strings(calls.begin(), calls.begin() + 8),
            (Strings{"new PlayerClient", "connect robot3:4001", "new LaserProxy", "laser index 1",
                     "new Position2dProxy", "position2d index 2", "new WindowProxy",
                     "window 172 x 186"}));
  EXPECT_NE(Output().find("DEBUG: CRobot: Done.\n"), std::string::npos);
}

TEST_F(X16, NegativeIndexIsRefusedWithAnImrException) {
  config_.set<int>("laser-index", -1);
  EXPECT_THROW(CRobot{config_}, imr::argument_error);
  EXPECT_EQ(Calls("delete "), Strings{"delete PlayerClient"});
}

TEST_F(X18, ConstructorReadsUntilTheFirstFreshScan) {
  world_.on_read = [&](long read) { world_.laser_fresh = read == 4; };
  world_.peeks_true = 2;  // the first Read() finds two more waiting
  { CRobot robot(config_); }
  EXPECT_EQ(world_.reads, 4);
}

TEST_F(X18, LoopTakesAllThatIsWaitingBeforeItActs) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    if (read == 2) world_.peeks_true = 3;
    world_.time = static_cast<double>(read);
  };
  Drive(0.001);  // scans: one, then one later
  // Read 1 in the constructor; reads 2 to 5 are one cycle, read 6 the next.
  EXPECT_EQ(world_.reads, 6);
  EXPECT_EQ(Calls("speed ").size(), 2u);
}

TEST_F(X20, MorseErrorEndsTheLoopWithItsTextAndFunction) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    if (read == 3) throw CCMorse::MorseError("connection lost", "MorseClient::Read()");
  };
  Drive();
  EXPECT_NE(Output().find("ERROR: Morse error: connection lost function: MorseClient::Read()\n"),
            std::string::npos);
  EXPECT_FALSE(alive_);
}

TEST_F(X20, EndOfTheSimulationIsNoError) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    if (read == 3) {
      throw CCMorse::MorseError("over", "MorseClient::Read()",
                                CCMorse::MorseError::kSimulationEnded);
    }
  };
  Drive();
  EXPECT_NE(Output().find("INFO: The simulation has ended.\n"), std::string::npos);
  EXPECT_EQ(Output().find("ERROR"), std::string::npos);
  EXPECT_TRUE(alive_);
}

TEST_F(X21, ImrExceptionEndsTheProgramWithMinusOne) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  world_.on_read = [&](long read) {
    world_.BringAll();
    if (read == 3) throw imr::io_error("disk full");
  };
  // The collected output would be lost at exit; the message goes to standard error here.
  EXPECT_EXIT(
      {
        std::cout.rdbuf(std::cerr.rdbuf());
        Drive();
      },
      testing::ExitedWithCode(255), "ERROR: Imr error: disk full");
}

TEST_F(X24, MotorsAreOnForTheDriveOnly) {
  Drive(0.0004);  // shorter than the time between two scans: the first one ends it
  EXPECT_EQ(Calls("motors "), (Strings{"motors on", "motors off"}));
  EXPECT_EQ(Calls("speed ").size(), 1u);
  EXPECT_NE(Output().find("INFO: Main loop has been left\n"), std::string::npos);
}

TEST_F(X29, WindowShowsTheWayInGreenAndThePositionsInMagenta) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = static_cast<double>(read);
    world_.x = 0.5 * static_cast<double>(read);
    world_.y = 1.0;
  };
  Drive(1.0);  // reads 2 and 3
  EXPECT_EQ(Calls("line "),
            (Strings{"line 50,50,50,50 colour 0,255,0", "line 50,50,75,50 colour 0,255,0"}));
  EXPECT_EQ(Calls("pixel "),
            (Strings{"pixel 50,50 colour 255,0,255", "pixel 75,50 colour 255,0,255"}));
}

TEST_F(X31, DataAreUsedOnce) {
  // New data at every second read only.
  world_.on_read = [&](long read) {
    if (read % 2 == 1) world_.BringAll();
    world_.time = static_cast<double>(read);
  };
  Drive(6.0);
  EXPECT_FALSE(world_.laser_fresh);
  EXPECT_FALSE(world_.position_fresh);
  // The constructor leaves its scan (read 1) to the loop, which begins with read 2 and finds it
  // fresh still; then come reads 3, 5 and 7, and 9 ends it.
  EXPECT_EQ(summary_.scans, 5u);
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: POSITION "), static_cast<long>(summary_.scans));
  EXPECT_EQ(static_cast<long>(Calls("speed ").size()), world_.reads - 1);
}

TEST_F(X37, CommandsFollowTheNearestObstacle) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = static_cast<double>(read);
    world_.ranges.assign(682, 5.0);
    if (read == 3) world_.ranges[300] = 0.35;  // right of the robot: bearing -0.2833 rad
    if (read == 4) world_.ranges[400] = 0.15;  // too near
    if (read == 5) world_.ranges[341] = 0.15;  // the centre beam is never looked at
    if (read == 6) world_.ranges[239] = 0.15;  // just outside the window
    if (read == 7) world_.ranges[240] = 0.20;  // its first beam
    if (read == 8) world_.ranges[443] = 0.15;  // just outside
    if (read == 9) world_.ranges[442] = 0.10;  // its last beam
  };
  Drive(7.0);
  // Read 3 by hand: v = 0.15 / 0.3 * 0.3; w = 0.5 * 0.2 / 0.35
  //   + 0.5 * (1.3962634 + 0.28331449 / 0.6981317 * 2) = 0.2857143 + 1.1039493.
  EXPECT_EQ(Calls("speed "), (Strings{"speed 0.300000 0.000000", "speed 0.150000 1.389664",
                                      "speed 0.000000 1.000000", "speed 0.300000 0.000000",
                                      "speed 0.300000 0.000000", "speed 0.000000 1.000000",
                                      "speed 0.300000 0.000000", "speed 0.000000 1.000000"}));
  EXPECT_DOUBLE_EQ(summary_.nearest, 0.10);
  EXPECT_EQ(summary_.scans, 8u);
}

TEST_F(X38, StopEndsTheLoopWithinOneCycle) {
  std::mutex mutex;
  std::condition_variable changed;
  long allowed = 3;
  long reached = 0;
  world_.on_read = [&](long read) {
    std::unique_lock<std::mutex> lock(mutex);
    reached = read;
    changed.notify_all();
    changed.wait(lock, [&] { return read <= allowed; });
    world_.BringAll();
  };
  CRobot robot(config_);
  robot.execute();
  {
    std::unique_lock<std::mutex> lock(mutex);
    changed.wait(lock, [&] { return reached == 4; });  // the loop waits inside Read()
  }
  EXPECT_TRUE(robot.isRunning());
  robot.stop();
  {
    const std::lock_guard<std::mutex> lock(mutex);
    allowed = 100;  // a loop that does not stop would go on
    changed.notify_all();
  }
  robot.join();
  EXPECT_EQ(world_.reads, 4);
  EXPECT_TRUE(robot.isFinished());
  EXPECT_TRUE(robot.isAlive());
}

TEST_F(X38, StopBeforeTheStartLetsOneCycleRun) {
  CRobot robot(config_);
  robot.stop();
  robot.execute();
  robot.join();
  EXPECT_EQ(world_.reads, 2);
}

TEST_F(X39, DestructorStopsAndDeletesInTheListingsOrder) {
  {
    CRobot robot(config_);
    robot.execute();
    while (Calls("speed ").size() < 3) std::this_thread::yield();
  }
  const Strings calls = world_.Calls();
  ASSERT_GE(calls.size(), 5u);
  EXPECT_EQ(Strings(calls.end() - 5, calls.end()),
            (Strings{"motors off", "delete WindowProxy", "delete LaserProxy",
                     "delete Position2dProxy", "delete PlayerClient"}));
}

TEST_F(X39, WindowThatIsGoneAlreadyDoesNoHarm) {
  {
    CRobot robot(config_);
    delete &CCMorse::WindowProxy::GetInstance();
  }
  EXPECT_EQ(Calls("delete "), (Strings{"delete WindowProxy", "delete LaserProxy",
                                       "delete Position2dProxy", "delete PlayerClient"}));
}

TEST_F(X39, FailedConstructorGivesBackWhatItHasMade) {
  const std::vector<std::pair<std::string, Strings>> cases = {
      {"PlayerClient", {}},
      {"LaserProxy", {"delete PlayerClient"}},
      {"Position2dProxy", {"delete LaserProxy", "delete PlayerClient"}},
      {"WindowProxy", {"delete LaserProxy", "delete Position2dProxy", "delete PlayerClient"}},
  };
  for (const auto& [failing, deleted] : cases) {
    world_.calls.clear();
    world_.failing_class = failing;
    EXPECT_THROW(CRobot{config_}, CCMorse::MorseError) << failing;
    EXPECT_EQ(Calls("delete "), deleted) << failing;
  }
}

TEST_F(X39, FailedFirstScanGivesBackEverything) {
  world_.on_read = [](long) { throw CCMorse::MorseError("gone", "MorseClient::Read()"); };
  EXPECT_THROW(CRobot{config_}, CCMorse::MorseError);
  EXPECT_EQ(Calls("delete "), (Strings{"delete WindowProxy", "delete LaserProxy",
                                       "delete Position2dProxy", "delete PlayerClient"}));
}

TEST_F(X43, LogLinesAreTheListings) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = static_cast<double>(read);
    world_.x = 1.25;
    world_.y = -0.5;
    world_.yaw = 3.0;
    world_.x_speed = 0.3;
    world_.yaw_speed = -1.0;
  };
  Drive(1.0);
  const std::string number = "-?[0-9]+(\\.[0-9]+)?(e-?[0-9]+)?";
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: POSITION 1\\.25 -0\\.5 3\n"), 2);
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: SPEED 0\\.3 0 -1\n"), 2);
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: laser " + number + " " + number + " 682\n"), 2);
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: laser -2\\.35619 2\\.34924 682\n"), 2);
  EXPECT_EQ(course::CountMatches(Output(), "DEBUG: Navigation started\\.\n"), 1);
}

TEST_F(X43, InvalidDataAreNotUsed) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = static_cast<double>(read);
    world_.laser_valid = world_.position_valid = read >= 4;
  };
  Drive(1.0);  // reads 4 and 5 count
  EXPECT_EQ(world_.reads, 5);
  EXPECT_EQ(course::CountMatches(Output(), "POSITION"), 2);
  EXPECT_EQ(Calls("speed ")[0], "speed 0.000000 0.000000");
  EXPECT_EQ(Calls("speed ")[2], "speed 0.300000 0.000000");
}

TEST_F(Q08, AliveIsTrueFromTheStart) {
  CRobot robot(config_);
  EXPECT_TRUE(robot.isAlive());
}

TEST_F(Q09, CoordsSetTheOdometry) {
  config_.set<double>("x", 1.5);
  config_.set<double>("y", -2.0);
  config_.set<double>("yaw", 0.25);
  { CRobot robot(config_); }
  EXPECT_EQ(Calls("odometry "), Strings());
  config_.set<bool>("coords", true);
  { CRobot robot(config_); }
  EXPECT_EQ(Calls("odometry "), Strings{"odometry 1.500000 -2.000000 0.250000"});
}

TEST_F(IntroRobot, StopsAfterTheGivenTimeOfTheScans) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = 10.0 + 0.1 * static_cast<double>(read);  // the clock need not start at 0
    world_.x = 0.03 * static_cast<double>(read);
  };
  Drive(5.0);
  EXPECT_EQ(summary_.scans, 51u);
  EXPECT_NEAR(summary_.seconds, 5.0, 1e-9);
  EXPECT_NEAR(summary_.distance, 50 * 0.03, 1e-9);
  EXPECT_EQ(summary_.nearest, 5.0);
}

TEST_F(IntroRobot, SurvivesAScanWithoutBeams) {
  world_.ranges.clear();
  Drive(0.0004);
  EXPECT_EQ(summary_.scans, 1u);
  EXPECT_EQ(Calls("speed "), Strings{"speed 0.300000 0.000000"});
}
