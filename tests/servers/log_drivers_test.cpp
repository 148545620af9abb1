// writelog and readlog: a log of what devices published, written and played back (specs: player.md
// B.7 log, C.2), as our own client's proxies see it.

#include <gtest/gtest.h>
#include <libplayerc++/playerc++.h>

#include <fstream>
#include <sstream>

#include "base/error.h"
#include "tests/servers/served_simulation.h"

namespace ccmorse::servers {
namespace {

using player::DriverDef;
using player::PortSetup;
using PlayerCc::LaserProxy;
using PlayerCc::LogProxy;
using PlayerCc::PlayerClient;
using PlayerCc::PlayerError;
using PlayerCc::Position2dProxy;
using PlayerCc::SonarProxy;

constexpr const char* kHall = R"({"world": {"name": "hall", "size": [6, 6], "boxes": []},
    "robots": [{"name": "a", "pose": {"x": 3, "y": 3, "yaw_deg": 0}, "sonar": {}}]})";

class PlayerLog : public ::testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.path() + "/" + name; }

  DriverDef Writer() const {
    DriverDef def{
        "writelog", {{"", "log", 0}}, {{"", "position2d", 0}, {"", "laser", 0}, {"", "sonar", 0}}};
    def.options.values = {{"filename", Path("run.log")}};
    return def;
  }
  DriverDef Reader() const {
    DriverDef def{
        "readlog", {{"", "position2d", 0}, {"", "laser", 0}, {"", "sonar", 0}, {"", "log", 0}}, {}};
    def.options.values = {{"filename", Path("run.log")}};
    return def;
  }

  static std::vector<PortSetup> Port(bool with_robot, DriverDef def) {
    PortSetup setup;
    setup.port = 0;
    setup.name = "a";
    if (with_robot) {
      for (const char* const each : {"position2d", "laser", "sonar"}) {
        setup.devices.push_back({"a", {each, 0}});
      }
    }
    setup.drivers = {std::move(def)};
    return {setup};
  }

  struct Sample {
    double time, x, yaw, range, sonar;
    bool operator==(const Sample&) const = default;
  };
  static Sample Read(PlayerClient& client, const Position2dProxy& position, const LaserProxy& laser,
                     const SonarProxy& sonar) {
    client.Read();
    return {position.GetDataTime(), position.GetXPos(), position.GetYaw(), laser.GetRange(100),
            sonar.GetCount() > 0 ? sonar.GetScan(0) : -1.0};
  }

  std::string Text(const std::string& name) const {
    std::ifstream file(Path(name));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  testing::TemporaryFolder folder_;
};

// A simulation in lock-step and its one client.
class Served {
 public:
  explicit Served(std::vector<PortSetup> setup, const char* scenario = kHall)
      : served_(scenario, Pace::kLockstep, 0.0, MorseServerOptions{}, 1, RecordOptions{}, 10.0,
                std::move(setup)),
        client_("player://127.0.0.1", static_cast<std::uint32_t>(served_.player_port())) {}
  PlayerClient& client() { return client_; }

 private:
  ServedSimulation served_;
  PlayerClient client_;
};

TEST_F(PlayerLog, WhatIsWrittenIsPlayedBackTheSameAtTheSamePace) {
  std::vector<Sample> written;
  player_pose3d_t mount{};
  {
    Served run(Port(true, Writer()));
    Position2dProxy position(&run.client(), 0);
    LaserProxy laser(&run.client(), 0);
    SonarProxy sonar(&run.client(), 0);
    LogProxy log(&run.client(), 0);
    log.QueryState();
    EXPECT_EQ(log.GetType(), 2);
    EXPECT_EQ(log.GetState(), 1);
    laser.RequestGeom();
    mount = laser.GetPose();
    position.SetSpeed(0.2, 0.3);
    for (int i = 0; i < 30; ++i) {
      written.push_back(Read(run.client(), position, laser, sonar));
    }
    log.SetWriteState(0);
    log.QueryState();
    EXPECT_EQ(log.GetState(), 0);
  }
  const std::string text = Text("run.log");
  EXPECT_NE(text.find("\n0.1 0 0 position2d 0 1 1 "), std::string::npos) << text.substr(0, 400);
  EXPECT_NE(text.find("\n0.1 0 0 laser 0 1 1 "), std::string::npos);

  Served run(Port(false, Reader()));
  Position2dProxy position(&run.client(), 0);
  LaserProxy laser(&run.client(), 0);
  SonarProxy sonar(&run.client(), 0);
  LogProxy log(&run.client(), 0);
  log.QueryState();
  EXPECT_EQ(log.GetType(), 1);
  EXPECT_EQ(log.GetState(), 1);
  laser.RequestGeom();
  EXPECT_EQ(laser.GetPose().px, mount.px);
  EXPECT_NE(mount.px, 0.0);
  EXPECT_EQ(position.HasCapability(PLAYER_MSGTYPE_REQ, PLAYER_POSITION2D_REQ_GET_GEOM), 1);
  EXPECT_EQ(position.HasCapability(PLAYER_MSGTYPE_REQ, PLAYER_POSITION2D_REQ_SET_ODOM), 0);
  EXPECT_THROW(log.SetWriteState(1), PlayerError);
  Sample first = Read(run.client(), position, laser, sonar);
  const double shift = written[0].time - first.time;
  for (std::size_t i = 0; i < 20; ++i) {
    first.time += shift;
    EXPECT_NEAR(first.time, written[i].time, 1e-5) << i;
    first.time = written[i].time;
    EXPECT_EQ(first, written[i]) << i;
    first = Read(run.client(), position, laser, sonar);
  }
  log.Rewind();
  first = Read(run.client(), position, laser, sonar);
  EXPECT_EQ(first.x, written[0].x);
  EXPECT_GT(first.time, 1.5);  // the simulation's, which does not go back
}

TEST_F(PlayerLog, AWriterWaitsForItsClientWhereTheFileSaysSoAndWritesWhereItMay) {
  DriverDef def = Writer();
  def.options.values.emplace_back("autorecord", 0.0);
  Served run(Port(true, def));
  Position2dProxy position(&run.client(), 0);
  LogProxy log(&run.client(), 0);
  log.QueryState();
  EXPECT_EQ(log.GetState(), 0);
  run.client().Read();
  EXPECT_EQ(Text("run.log"), "");
  EXPECT_THROW(log.SetFilename("../other.log"), PlayerError);
  EXPECT_THROW(log.SetFilename("/tmp/other.log"), PlayerError);
  EXPECT_THROW(log.SetFilename(""), PlayerError);
  std::ofstream(Path("there.log")) << "mine";
  EXPECT_THROW(log.SetFilename("there.log"), PlayerError);
  log.SetFilename("other.log");
  log.SetState(1);
  EXPECT_THROW(log.SetFilename("third.log"), PlayerError);
  run.client().Read();
  run.client().Read();
  log.SetState(0);
  EXPECT_NE(Text("other.log").find(" position2d 0 1 1 "), std::string::npos);
  EXPECT_EQ(Text("run.log"), "");
  EXPECT_EQ(Text("there.log"), "mine");
  EXPECT_THROW(log.Rewind(), PlayerError);
}

TEST_F(PlayerLog, AWriterThatIsAlwaysOnNeedsNoClientOfItsOwn) {
  {
    DriverDef def = Writer();
    def.always_on = true;
    Served run(Port(true, def));
    Position2dProxy position(&run.client(), 0);
    for (int i = 0; i < 5; ++i) run.client().Read();
  }
  EXPECT_NE(Text("run.log").find("\n0.5 0 0 sonar 0 1 1 "), std::string::npos);
}

TEST_F(PlayerLog, LinesThatAreNoneArePassedOver) {
  std::ofstream(Path("run.log")) << "## a comment\n"
                                    "rubbish\n"
                                    "5 0 0 position2d 0 1 1 1 2\n"              // too short
                                    "5 0 0 position2d 0 1 1 1 2 3 0 0 0 0 9\n"  // too long
                                    "5 0 0 sonar 0 1 1 4000000000 1\n"          // a count that lies
                                    "5 0 0 position2d 3 1 1 1 2 3 0 0 0 0\n"    // not provided
                                    "nan 0 0 position2d 0 1 1 1 2 3 0 0 0 0\n"
                                    "7 0 0 position2d 0 1 1 1 2 0.5 0 0 0 0\n"
                                    "7.5 0 0 position2d 0 1 1 2 2 0.5 0 0 0 1";
  Served run(Port(false, Reader()));
  Position2dProxy position(&run.client(), 0);
  run.client().Read();
  EXPECT_EQ(position.GetXPos(), 1.0);
  EXPECT_EQ(position.GetYaw(), 0.5);
  const double began = position.GetDataTime();
  run.client().Read();
  EXPECT_EQ(position.GetXPos(), 2.0);
  EXPECT_TRUE(position.GetStall());
  EXPECT_NEAR(position.GetDataTime() - began, 0.5, 0.021);
}

TEST_F(PlayerLog, LogsThatCannotBeAreRefusedByName) {
  const auto complaint = [&](const DriverDef& def, bool with_robot) -> std::string {
    sim::Simulation simulation(scene::ParseScenario(kHall, "test.json"));
    RunOptions options;
    options.morse.port = 0;
    options.morse.first_stream_port = 0;
    options.player.emplace();
    options.player->setup = Port(with_robot, def);
    try {
      const Runner runner(simulation, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint(Reader(), false).find("run.log"), std::string::npos);  // is not there
  DriverDef nothing = Writer();
  nothing.required.clear();
  EXPECT_NE(complaint(nothing, true).find("writelog requires"), std::string::npos);
  EXPECT_NE(complaint(Writer(), false).find("no position2d:0"), std::string::npos);
}

}  // namespace
}  // namespace ccmorse::servers
