// Drivers of the server and set-ups other than the default (specs: player.md C.2, G).

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/image.h"
#include "base/trig.h"
#include "scene/player/import.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/player_wire_client.h"
#include "wire/player/deflate.h"

namespace ccmorse::servers {
namespace {

namespace wire = ccmorse::wire::player;
using player::DeviceDef;
using player::DriverDef;
using player::PortSetup;
using testing::PlayerWireClient;

constexpr const char* kTwo = R"({"world": {"name": "hall", "size": [10, 10], "boxes": []},
    "robots": [{"name": "a", "pose": {"x": 2, "y": 5, "yaw_deg": 0}},
               {"name": "b", "pose": {"x": 5, "y": 5, "yaw_deg": 0}}]})";

PortSetup PortOf(std::vector<PortSetup::OfRobot> devices, std::vector<DriverDef> drivers = {}) {
  PortSetup setup;
  setup.port = 0;
  setup.name = "all";
  setup.devices = std::move(devices);
  setup.drivers = std::move(drivers);
  return setup;
}

class PlayerDrivers : public ::testing::Test {
 protected:
  PlayerWireClient& Serve(const PortSetup& setup) {
    served_.emplace(kTwo, Pace::kLockstep, 0.0, MorseServerOptions{}, 1, RecordOptions{}, 10.0,
                    std::vector<PortSetup>{setup});
    client_.emplace(served_->player_port());
    client_->SetPull(true);
    return *client_;
  }
  // The text that a set-up is refused with.
  static std::string Complaint(const PortSetup& setup) {
    sim::Simulation simulation(scene::ParseScenario(kTwo, "test.json"));
    RunOptions options;
    options.morse.port = 0;
    options.morse.first_stream_port = 0;
    options.player.emplace();
    options.player->setup = {setup};
    try {
      const Runner runner(simulation, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  std::optional<ServedSimulation> served_;
  std::optional<PlayerWireClient> client_;
};

TEST_F(PlayerDrivers, OnePortServesSeveralRobotsByIndex) {
  DeviceDef second{"position2d", 1};
  auto& client = Serve(PortOf({{"a", {"position2d", 0}}, {"b", second}}));
  client.Subscribe(wire::kPosition2d, 1);
  wire::Position2dCmdVel ahead;
  ahead.vel = {0.3, 0.0, 0.0};
  client.Command(wire::kPosition2d, 1, wire::kPosition2dCmdVel, ahead);
  EXPECT_NEAR(client.ReadUntil(wire::kPosition2d, 1).As<wire::Position2dData>().pos.px, 0.03, 1e-9);
  EXPECT_NEAR(served_->simulation().robots()[1]->pose().x, 5.03, 1e-9);
}

TEST_F(PlayerDrivers, RangertolaserGivesTheRangersScanAsALaser) {
  auto& client = Serve(
      PortOf({{"a", {"ranger", 0}}}, {{"rangertolaser", {{"", "laser", 0}}, {{"", "ranger", 0}}}}));
  EXPECT_EQ(client.Subscribe(wire::kLaser, 0), "rangertolaser");
  client.Subscribe(wire::kRanger, 0);
  const auto round = client.Read();
  ASSERT_EQ(round.size(), 3U);
  const auto ranger = round[1].header.address.interf == wire::kRanger ? round[1] : round[0];
  const auto laser = round[1].header.address.interf == wire::kRanger ? round[0] : round[1];
  const auto scan = laser.As<wire::LaserData>();
  const auto ranges = ranger.As<wire::RangerDataRange>().ranges;
  EXPECT_EQ(laser.header.time, ranger.header.time);
  ASSERT_EQ(scan.ranges.size(), ranges.size());
  EXPECT_EQ(static_cast<float>(scan.ranges[17]), static_cast<float>(ranges[17]));
  EXPECT_NEAR(scan.resolution, 0.39589 * 3.14159265 / 180.0, 1e-7);
  EXPECT_EQ(client.Get<wire::LaserGeom>(wire::kLaser, 0, wire::kLaserReqGetGeom).pose.px, 0.035);
}

TEST_F(PlayerDrivers, LasertorangerGivesTheLasersScanAsARanger) {
  auto& client = Serve(
      PortOf({{"a", {"laser", 0}}}, {{"lasertoranger", {{"", "ranger", 3}}, {{"", "laser", 0}}}}));
  client.Subscribe(wire::kRanger, 3);
  EXPECT_EQ(client.ReadUntil(wire::kRanger, 3).As<wire::RangerDataRange>().ranges.size(), 682U);
  EXPECT_NEAR(client.Get<wire::RangerConfig>(wire::kRanger, 3, wire::kRangerReqGetConfig).max_range,
              5.0, 1e-9);
}

TEST_F(PlayerDrivers, FakelocalizeKnowsTheTruePose) {
  DriverDef fake{
      "fakelocalize", {{"", "localize", 0}, {"", "position2d", 5}}, {{"", "simulation", 0}}};
  fake.options.values = {{"model", Json("b")}};
  auto& client = Serve(PortOf({{"a", {"simulation", 0}}}, {fake}));
  client.Subscribe(wire::kLocalize, 0);
  client.Subscribe(wire::kPosition2d, 5);
  const auto data = client.ReadUntil(wire::kLocalize, 0).As<wire::LocalizeData>();
  ASSERT_EQ(data.hypoths.size(), 1U);
  EXPECT_EQ(data.hypoths[0].mean, (wire::Pose2d{5.0, 5.0, 0.0}));
  EXPECT_EQ(data.hypoths[0].alpha, 1.0);
  EXPECT_EQ(client.ReadUntil(wire::kPosition2d, 5).As<wire::Position2dData>().pos.px, 5.0);
  const auto particles =
      client.Get<wire::LocalizeGetParticles>(wire::kLocalize, 0, wire::kLocalizeReqGetParticles);
  EXPECT_EQ(particles.particles.size(), 1U);
}

TEST_F(PlayerDrivers, MapfileServesAPicture) {
  const testing::TemporaryFile file(".png", "");
  Image image{3, 2, std::vector<Color>(6, Color{255, 255, 255})};
  image.pixels[0] = {0, 0, 0};        // top left
  image.pixels[4] = {128, 128, 128};  // bottom middle
  WritePng(image, file.path());
  DriverDef map{"mapfile", {{"", "map", 0}}, {}};
  map.options.values = {{"filename", Json(file.path())},
                        {"resolution", Json(50.0)},
                        {"origin", Json(Json::Array{Json(100.0), Json(-200.0)})}};
  map.options.length_unit = 0.01;
  auto& client = Serve(PortOf({}, {map}));
  const auto info = client.Get<wire::MapInfo>(wire::kMap, 0, wire::kMapReqGetInfo);
  EXPECT_EQ(info.width, 3U);
  EXPECT_EQ(info.height, 2U);
  EXPECT_NEAR(info.scale, 0.5, 1e-7);
  EXPECT_EQ(info.origin, (wire::Pose2d{1.0, -2.0, 0.0}));
  const wire::MapData tile{0, 0, 3, 2, 0, {}};
  const auto reply =
      client.Get<wire::MapData>(wire::kMap, 0, wire::kMapReqGetData, wire::Encode(tile));
  const auto cells = wire::Inflate(reply.data, 6);
  ASSERT_TRUE(cells);
  EXPECT_EQ(*cells, (wire::Bytes{255, 0, 255, 1, 255, 255}));  // lowest row first
}

// Rounds of Player's protocol until position2d:`index` is there, at most for 60 simulated seconds.
wire::Pose2d GoTo(PlayerWireClient& client, std::uint16_t index, const wire::Pose2d& goal) {
  wire::Position2dCmdPos command;
  command.pos = goal;
  command.state = 1;
  client.Command(wire::kPosition2d, index, wire::kPosition2dCmdPos, command);
  wire::Pose2d pose;
  for (int round = 0; round < 600; ++round) {
    const auto data = client.ReadUntil(wire::kPosition2d, index).As<wire::Position2dData>();
    pose = data.pos;
    EXPECT_EQ(data.stall, 0);
    const bool there = std::hypot(pose.px - goal.px, pose.py - goal.py) < 0.06;
    if (there && data.vel.px == 0.0 && data.vel.pa == 0.0) break;
  }
  return pose;
}

TEST(PlayerSnd, G1DrivesSyrotekSRobotToGoalsAsPosition2d1) {
  ServedSimulation served("{}", Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  EXPECT_EQ(client.Subscribe(wire::kPosition2d, 1), "snd");
  for (const wire::Pose2d& goal :
       {wire::Pose2d{0.9, 2.6, 0.0}, wire::Pose2d{2.2, 2.2, 1.5}, wire::Pose2d{1.2, 2.0, -2.0}}) {
    const wire::Pose2d end = GoTo(client, 1, goal);
    EXPECT_LT(std::hypot(end.px - goal.px, end.py - goal.py), 0.06);
    EXPECT_LT(std::fabs(std::remainder(end.pa - goal.pa, 2 * kPi)), Radians(31.0));
  }
}

TEST(PlayerSnd, SpeedsTakeTheGoalAway) {
  ServedSimulation served("{}", Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 1);
  wire::Position2dCmdPos goal;
  goal.pos = {2.2, 2.2, 0.0};
  client.Command(wire::kPosition2d, 1, wire::kPosition2dCmdPos, goal);
  for (int i = 0; i < 5; ++i) client.Read();
  client.Command(wire::kPosition2d, 1, wire::kPosition2dCmdVel, wire::Position2dCmdVel{});
  for (int i = 0; i < 3; ++i) client.Read();
  const auto still = client.ReadUntil(wire::kPosition2d, 1).As<wire::Position2dData>();
  const auto later = client.ReadUntil(wire::kPosition2d, 1).As<wire::Position2dData>();
  EXPECT_EQ(still.pos, later.pos);
}

TEST(PlayerSetup, ACfgServesItsDevicesAndDrivers) {
  const auto imported =
      scene::ImportScenario(std::string(CCMORSE_SOURCE_DIR) + "/tests/worlds/course.cfg");
  ServedSimulation served(scene::ToJson(imported.scenario).Dump(), Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  EXPECT_EQ(client.Subscribe(wire::kLaser, 0), "rangertolaser");
  EXPECT_EQ(client.Subscribe(wire::kPosition2d, 1), "snd");
  client.Subscribe(wire::kPosition2d, 0);
  const auto here = client.ReadUntil(wire::kPosition2d, 1).As<wire::Position2dData>().pos;
  wire::Position2dCmdPos goal;
  goal.pos = {here.px + 0.3 * std::cos(here.pa), here.py + 0.3 * std::sin(here.pa), here.pa};
  const wire::Pose2d end = GoTo(client, 1, goal.pos);
  EXPECT_LT(std::hypot(end.px - goal.pos.px, end.py - goal.pos.py), 0.1);
}

TEST_F(PlayerDrivers, SetUpsThatCannotBeAreRefusedByName) {
  EXPECT_NE(Complaint(PortOf({{"c", {"laser", 0}}})).find("no robot 'c'"), std::string::npos);
  EXPECT_NE(Complaint(PortOf({{"a", {"limb", 0}}})).find("'limb'"), std::string::npos);
  EXPECT_NE(Complaint(PortOf({{"a", {"laser", 0}}, {"b", {"laser", 0}}})).find("laser:0"),
            std::string::npos);
  EXPECT_NE(Complaint(PortOf({}, {{"rangertolazer", {}, {}}})).find("rangertolaser"),
            std::string::npos);
  EXPECT_NE(Complaint(PortOf({}, {{"rangertolaser", {{"", "laser", 0}}, {{"", "ranger", 0}}}}))
                .find("no ranger:0"),
            std::string::npos);
  EXPECT_NE(Complaint(PortOf({}, {{"rangertolaser", {{"", "laser", 0}}, {}}})).find("requires"),
            std::string::npos);
}

}  // namespace
}  // namespace ccmorse::servers
