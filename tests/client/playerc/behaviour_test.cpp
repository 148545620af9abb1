// PlayerCc over Player's protocol, against a double of a server (specs: player.md A.2, A.4, B).

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "libCCMorse/MorseError.h"
#include "libplayerc++/playerc++.h"
#include "tests/support/fake_server.h"
#include "tests/support/player_double.h"
#include "wire/player/deflate.h"

namespace ccmorse::test {
namespace {

using namespace PlayerCc;
using Type = wire::player::MessageType;

std::vector<PlayerDouble::Device> Devices() {
  std::vector<PlayerDouble::Device> devices = {{PLAYER_LASER_CODE, 1, "second"}};
  for (std::uint16_t code = 2; code <= 66; ++code) {
    if (code != PLAYER_LIMB_CODE && !wire::player::InterfaceName(code).empty()) {
      devices.push_back({code, 0, "stage"});
    }
  }
  return devices;
}

class PlayerProgram : public ::testing::Test {
 protected:
  void Odometry(double time, double x = 1.5) {
    wire::player::Position2dData data;
    data.pos = {x, 2.5, 0.25};
    data.vel = {0.5, 0.0, -0.5};
    data.stall = 1;
    server.Data(PLAYER_POSITION2D_CODE, 0, PLAYER_POSITION2D_DATA_STATE, time, data);
  }

  PlayerDouble server{Devices()};
  PlayerClient client{"localhost", server.port()};
};
using A02 = PlayerProgram;
using A04 = PlayerProgram;
using B05 = PlayerProgram;
using B06 = PlayerProgram;

template <typename Act>
PlayerError ErrorOf(const Act& act) {
  try {
    act();
  } catch (const PlayerError& error) {
    return error;
  }
  ADD_FAILURE() << "no PlayerError came";
  return {};
}

template <typename Value>
std::string Text(const Value& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST_F(A02, WhatTheServerLacksCannotBeSubscribed) {
  const PlayerError error = ErrorOf([&] { const LimbProxy limb(&client); });
  EXPECT_EQ(error.GetErrorFun(), "LimbProxy::LimbProxy()");
  EXPECT_EQ(error.GetErrorStr(), "could not subscribe");
  EXPECT_EQ(error.GetErrorCode(), -1);
  EXPECT_EQ(Text(error), "LimbProxy::LimbProxy()(-1) : could not subscribe");
}

TEST_F(A02, ValidFreshAndTimes) {
  Position2dProxy position(&client);
  EXPECT_EQ(position.GetDriverName(), "stage");
  EXPECT_FALSE(position.IsValid() || position.IsFresh());
  EXPECT_EQ(position.GetXPos(), 0.0);
  Odometry(2.0);
  client.Read();
  EXPECT_TRUE(position.IsValid() && position.IsFresh());
  EXPECT_EQ(position.GetElapsedTime(), 2.0);  // the first counts from 0
  position.NotFresh();
  Odometry(2.0);
  client.Read();
  EXPECT_FALSE(position.IsFresh());  // no newer
  Odometry(2.5);
  client.Read();
  EXPECT_TRUE(position.IsFresh());
  EXPECT_EQ(position.GetDataTime(), 2.5);
  EXPECT_EQ(position.GetElapsedTime(), 0.5);
  EXPECT_EQ(position.GetXPos(), 1.5);
  EXPECT_EQ(position.GetYawSpeed(), -0.5);
  EXPECT_TRUE(position.GetStall());
}

TEST_F(A02, AClientMayGoBeforeItsProxies) {
  auto own = std::make_unique<PlayerClient>("player://localhost:" + std::to_string(server.port()));
  auto position = std::make_unique<Position2dProxy>(own.get());
  Odometry(1.0);
  own->Read();
  EXPECT_EQ(server.Subscribed(), 1U);
  position->SetSpeed(0.1, 0.2);
  own.reset();
  EXPECT_EQ(server.Count(PLAYER_POSITION2D_CODE, Type::kCommand, PLAYER_POSITION2D_CMD_VEL), 1U);
  EXPECT_EQ(server.Subscribed(), 0U);
  EXPECT_EQ(position->GetXPos(), 1.5);
  position->SetSpeed(0.3, 0.0);
  EXPECT_THROW(position->RequestGeom(), PlayerError);
  position.reset();
  EXPECT_EQ(server.Count(PLAYER_POSITION2D_CODE, Type::kCommand, PLAYER_POSITION2D_CMD_VEL), 1U);
}

TEST_F(A02, TwoProxiesOfADeviceAreSubscribedOnce) {
  const LaserProxy first(&client);
  auto second = std::make_unique<LaserProxy>(&client);
  wire::player::LaserData scan;
  scan.ranges = {1.0, 2.0};
  server.Data(PLAYER_LASER_CODE, 0, PLAYER_LASER_DATA_SCAN, 1.0, scan);
  client.Read();
  EXPECT_EQ(first.GetCount(), 2U);
  EXPECT_EQ(second->GetCount(), 2U);
  second.reset();
  EXPECT_EQ(server.Subscribed(), 1U);
}

TEST_F(A02, ReadSignalsComeWithNewData) {
  Position2dProxy position(&client);
  int calls = 0;
  const ClientProxy::connection_t connection = position.ConnectReadSignal([&] { ++calls; });
  Odometry(1.0);
  client.Read();
  position.DisconnectReadSignal(connection);
  Odometry(2.0);
  client.Read();
  EXPECT_EQ(calls, 1);
}

TEST_F(A02, AThreadReadsWhileAnotherRequests) {
  Position2dProxy position(&client);
  server.Answer(PLAYER_POSITION2D_CODE, PLAYER_POSITION2D_REQ_GET_GEOM,
                wire::player::Position2dGeom{{}, {0.5, 0.75, 0.0}});
  client.StartThread();
  for (int i = 1; i <= 20; ++i) {
    Odometry(i, i);
    position.RequestGeom();
    ClientProxy::scoped_lock_t lock(client.mMutex);
    position.GetXPos();  // with the mutex held, too
  }
  while (position.GetXPos() < 20.0) std::this_thread::yield();
  client.StopThread();  // although nothing comes any more
  EXPECT_EQ(position.GetSize().sl, 0.75);
}

TEST_F(B05, DeviceListNamesTheDrivers) {
  EXPECT_TRUE(client.GetDeviceList().empty());
  client.RequestDeviceList();
  const std::list<playerc_device_info_t> list = client.GetDeviceList();
  ASSERT_EQ(list.size(), Devices().size());
  EXPECT_EQ(list.front().addr.interf, PLAYER_LASER_CODE);
  EXPECT_EQ(list.front().addr.index, 1);
  EXPECT_STREQ(list.front().drivername, "second");
  EXPECT_EQ(client.LookupCode("ranger"), PLAYER_RANGER_CODE);
  EXPECT_EQ(client.LookupName(PLAYER_RANGER_CODE), "ranger");
}

TEST_F(B05, RulesAreSentAsTheyAreGiven) {
  client.SetReplaceRule(true, PLAYER_MSGTYPE_DATA, -1, PLAYER_LASER_CODE);
  LaserProxy laser(&client, 1);
  laser.SetReplaceRule(false);
  std::vector<wire::player::AddReplaceRuleReq> rules;
  for (const PlayerDouble::Noted& each : server.Messages()) {
    wire::player::AddReplaceRuleReq rule;
    if (each.header.address.interf == PLAYER_PLAYER_CODE &&
        each.header.subtype == PLAYER_PLAYER_REQ_ADD_REPLACE_RULE &&
        wire::player::Decode(each.body, rule)) {
      rules.push_back(rule);
    }
  }
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(rules[0], (wire::player::AddReplaceRuleReq{PLAYER_LASER_CODE, -1, 1, -1, 1}));
  EXPECT_EQ(rules[1], (wire::player::AddReplaceRuleReq{PLAYER_LASER_CODE, 1, -1, -1, 0}));
}

TEST_F(B06, APullRoundTakesAllThatWaits) {
  Position2dProxy position(&client);
  Odometry(1.0, 1.0);
  Odometry(2.0, 2.0);
  client.Read();
  EXPECT_EQ(position.GetXPos(), 2.0);
  EXPECT_EQ(server.Count(PLAYER_PLAYER_CODE, Type::kRequest, PLAYER_PLAYER_REQ_DATA), 1U);
  EXPECT_FALSE(client.Peek(0));  // asks for the next round
  EXPECT_FALSE(client.Peek(1));
  Odometry(3.0, 3.0);
  EXPECT_TRUE(client.Peek(5000));
  client.ReadIfWaiting();
  EXPECT_EQ(position.GetXPos(), 3.0);
  EXPECT_EQ(server.Count(PLAYER_PLAYER_CODE, Type::kRequest, PLAYER_PLAYER_REQ_DATA), 2U);
}

TEST_F(B06, APushReadTakesOneMessage) {
  client.SetDataMode(PLAYER_DATAMODE_PUSH);
  Position2dProxy position(&client);
  Odometry(1.0, 1.0);
  Odometry(2.0, 2.0);
  client.Read();
  EXPECT_EQ(position.GetXPos(), 1.0);
  client.Read();
  EXPECT_EQ(position.GetXPos(), 2.0);
  EXPECT_EQ(server.Count(PLAYER_PLAYER_CODE, Type::kRequest, PLAYER_PLAYER_REQ_DATA), 0U);
  EXPECT_THROW(client.SetDataMode(3), PlayerError);
}

TEST_F(B06, AnOverflowIsReportedUntilItIsCounted) {
  Position2dProxy position(&client);
  server.Overflow(7);
  Odometry(1.0);
  EXPECT_EQ(ErrorOf([&] { client.Read(); }).GetErrorStr(), "Overflow on server");
  Odometry(2.0);
  EXPECT_THROW(client.Read(), PlayerError);
  EXPECT_EQ(position.GetDataTime(), 2.0);  // the data are taken all the same
  EXPECT_EQ(client.GetOverflowCount(), 7U);
  EXPECT_EQ(client.GetOverflowCount(), 0U);
  Odometry(3.0);
  client.Read();
}

TEST_F(A04, RequestsAreRefusedOrTimeOut) {
  Position2dProxy position(&client);
  EXPECT_EQ(ErrorOf([&] { position.RequestGeom(); }).GetErrorFun(),
            "Position2dProxy::RequestGeom()");
  position.SetMotorEnable(true);  // a refusal is ignored
  EXPECT_EQ(position.HasCapability(PLAYER_MSGTYPE_CMD, 1), 0);
  std::int32_t number = 3;
  EXPECT_EQ(position.GetIntProp("x", &number), -1);
  EXPECT_EQ(number, 3);
  server.Answer(PLAYER_POSITION2D_CODE, wire::player::kGetInt, wire::player::IntpropReq{"x", 42});
  EXPECT_EQ(position.GetIntProp("x", &number), 0);
  EXPECT_EQ(number, 42);
  client.SetRequestTimeout(1);
  server.FallSilent();
  EXPECT_EQ(ErrorOf([&] { position.RequestGeom(); }).GetErrorStr(), "no answer in time");
}

TEST_F(A04, AServerThatComesBackIsJoinedAgain) {
  Position2dProxy position(&client);
  client.SetRetryLimit(3);
  client.SetRetryTime(0.01);
  EXPECT_EQ(client.GetRetryLimit(), 3);
  EXPECT_EQ(client.GetRetryTime(), 0.01);
  Odometry(1.0, 1.0);
  client.Read();
  server.Disconnect();
  std::thread reader([&] { client.Read(); });
  // Subscribed anew: the second DEV request of the device.
  EXPECT_TRUE(server.WaitFor(PLAYER_PLAYER_CODE, Type::kRequest, PLAYER_PLAYER_REQ_DEV, 2));
  EXPECT_TRUE(server.WaitFor(PLAYER_PLAYER_CODE, Type::kRequest, PLAYER_PLAYER_REQ_DATA, 2));
  Odometry(2.0, 2.0);
  reader.join();
  EXPECT_EQ(position.GetXPos(), 2.0);
}

TEST_F(A04, WithoutRetriesALostConnectionIsAnError) {
  server.Disconnect();
  EXPECT_THROW(client.Read(), PlayerError);
  EXPECT_THROW(client.Peek(), PlayerError);
  EXPECT_FALSE(client.Connected());
}

TEST_F(A04, LaserDecodesItsMessages) {
  LaserProxy laser(&client);
  wire::player::LaserDataScanpose posed;
  posed.scan.min_angle = -0.5;
  posed.scan.resolution = 0.5;
  posed.scan.max_range = 8.0;
  posed.scan.ranges = {1.0, 2.0, 4.0};
  posed.scan.intensity = {9, 8, 7};
  posed.pose = {1.0, 2.0, 3.0};
  server.Data(PLAYER_LASER_CODE, 0, PLAYER_LASER_DATA_SCANPOSE, 1.0, posed);
  client.Read();
  EXPECT_EQ(laser.GetMaxAngle(), 0.5);
  EXPECT_EQ(laser[2], 4.0);
  EXPECT_EQ(laser.GetIntensity(1), 8);
  EXPECT_EQ(laser.GetMinLeft(), 4.0);
  EXPECT_EQ(laser.GetMinRight(), 1.0);
  EXPECT_EQ(laser.GetPoint(1).px, 2.0);
  EXPECT_EQ(laser.GetRobotPose().pyaw, 3.0);
  EXPECT_EQ(laser.GetSize().sl, 0.15);
  EXPECT_THROW(laser.GetRange(3), PlayerError);
  server.Answer(PLAYER_LASER_CODE, PLAYER_LASER_REQ_GET_ID, wire::player::LaserGetIdConfig{77});
  laser.RequestID();
  EXPECT_EQ(laser.GetID(), 77);
  EXPECT_NE(Text(laser).find("#Laser (6:0)\n"), std::string::npos);
  EXPECT_NE(Text(laser).find("4\t28.6479\t7\t"), std::string::npos);
  // Damaged bytes change nothing.
  server.Queue(PLAYER_LASER_CODE, 0, PLAYER_LASER_DATA_SCAN, 2.0, {1, 2, 3});
  client.Read();
  EXPECT_EQ(laser.GetCount(), 3U);
  EXPECT_EQ(laser.GetDataTime(), 1.0);
}

TEST_F(A04, RangerComputesPoints) {
  server.Answer(PLAYER_RANGER_CODE, PLAYER_RANGER_REQ_GET_CONFIG,
                wire::player::RangerConfig{0.0, 1.0, M_PI / 2, 0.1, 5.0, 0.01, 10.0});
  server.Answer(PLAYER_RANGER_CODE, PLAYER_RANGER_REQ_GET_GEOM,
                wire::player::RangerGeom{{}, {}, {{1.0, 0, 0, 0, 0, 0}}, {{}}});
  RangerProxy ranger(&client);
  server.Data(PLAYER_RANGER_CODE, 0, PLAYER_RANGER_DATA_RANGE, 1.0,
              wire::player::RangerDataRange{{2.0, 3.0}});
  server.Data(PLAYER_RANGER_CODE, 0, PLAYER_RANGER_DATA_INTNS, 1.0,
              wire::player::RangerDataIntns{{0.5}});
  client.Read();
  EXPECT_EQ(ranger.GetElementCount(), 1U);
  EXPECT_EQ(ranger.GetFrequency(), 10.0);
  EXPECT_EQ(ranger.GetPoint(0).px, 3.0);
  EXPECT_NEAR(ranger.GetPoint(1).py, 3.0, 1e-12);
  EXPECT_EQ(ranger.GetIntensity(0), 0.5);
  EXPECT_NE(Text(ranger).find("[2, 3]"), std::string::npos);
}

TEST_F(A04, SonarIrBumperPower) {
  const SonarProxy sonar(&client);
  const IrProxy ir(&client);
  BumperProxy bumper(&client);
  const PowerProxy power(&client);
  server.Data(PLAYER_SONAR_CODE, 0, 1, 1.0, wire::player::SonarData{{1.5, 2.5}});
  server.Data(PLAYER_IR_CODE, 0, 1, 1.0, wire::player::IrData{{0.25}, {0.5}});
  server.Data(PLAYER_BUMPER_CODE, 0, 1, 1.0, wire::player::BumperData{{0, 1}});
  server.Data(PLAYER_POWER_CODE, 0, 1, 1.0,
              wire::player::PowerData{PLAYER_POWER_MASK_VOLTS, 12.5, 50.0, 0.0, 0.0, 1});
  client.Read();
  EXPECT_EQ(sonar[1], 2.5);
  EXPECT_EQ(sonar.GetScan(2), -1.0);
  EXPECT_EQ(Text(sonar), "#Sonar (5:0)\n0: 1.5\n1: 2.5\n");
  EXPECT_EQ(ir[0], 0.5);
  EXPECT_EQ(ir.GetVoltage(0), 0.25);
  EXPECT_TRUE(bumper[1]);
  EXPECT_TRUE(bumper.IsAnyBumped());
  EXPECT_EQ(power.GetCharge(), 12.5);
  EXPECT_TRUE(power.IsValid());
}

TEST_F(A04, PlannerLocalizeBlobsAndMarkers) {
  const PlannerProxy planner(&client);
  LocalizeProxy localize(&client);
  const BlobfinderProxy blobs(&client);
  const FiducialProxy markers(&client);
  EXPECT_LT(planner.GetCurrentWaypointId(), 0);
  wire::player::PlannerData plan;
  plan.valid = 1;
  plan.goal = {3.0, 4.0, 0.5};
  plan.waypoint_idx = 2;
  server.Data(PLAYER_PLANNER_CODE, 0, 1, 1.0, plan);
  wire::player::LocalizeData hypoths;
  hypoths.hypoths = {{{1.0, 2.0, 0.5}, {1, 2, 3, 4, 5, 6}, 0.75}};
  server.Data(PLAYER_LOCALIZE_CODE, 0, 1, 1.0, hypoths);
  wire::player::BlobfinderData found;
  found.width = 80;
  found.blobs = {{1, 0xFF0000, 4, 5, 6, 7, 8, 9, 10, 1.5}};
  server.Data(PLAYER_BLOBFINDER_CODE, 0, 1, 1.0, found);
  wire::player::FiducialData seen;
  seen.fiducials = {{17, {1.0, 0, 0, 0, 0, 0}, {}}};
  server.Data(PLAYER_FIDUCIAL_CODE, 0, 1, 1.0, seen);
  client.Read();
  EXPECT_EQ(planner.GetGy(), 4.0);
  EXPECT_EQ(planner.GetCurrentWaypointId(), 2);
  EXPECT_EQ(localize.GetHypoth(0).cov[5], 6.0);
  EXPECT_EQ(localize.GetHypoth(0).alpha, 0.75);
  EXPECT_EQ(localize.GetParticles(), -1);
  EXPECT_EQ(blobs[0].color, 0xFF0000U);
  EXPECT_EQ(blobs[0].range, 1.5F);
  EXPECT_EQ(markers[0].id, 17);
}

TEST_F(A04, AMapIsPutTogetherOfItsTiles) {
  MapProxy map(&client);
  wire::player::MapInfo info;
  info.scale = 0.5;
  info.width = 3;
  info.height = 2;
  info.origin = {-1.0, -2.0, 0.0};
  server.Answer(PLAYER_MAP_CODE, PLAYER_MAP_REQ_GET_INFO, info);
  wire::player::MapData tile;
  tile.width = 3;
  tile.height = 2;
  tile.data_range = 1;
  const wire::player::Bytes cells = {255, 0, 1, 1, 1, 1};
  tile.data = wire::player::Deflate(cells);
  server.Answer(PLAYER_MAP_CODE, PLAYER_MAP_REQ_GET_DATA, tile);
  map.RequestMap();
  EXPECT_EQ(map.GetWidth(), 3U);
  EXPECT_EQ(map.GetCell(0, 0), -1);
  EXPECT_EQ(map.GetCell(2, 0), 1);
  EXPECT_EQ(map.GetCellIndex(1, 1), 4);
  EXPECT_EQ(map.GetOriginY(), -2.0);
  std::vector<std::int8_t> copy(6);
  map.GetMap(copy.data());
  EXPECT_EQ(copy[0], -1);
  EXPECT_THROW(map.GetCell(3, 0), PlayerError);
  tile.data = {1, 2, 3};
  server.Answer(PLAYER_MAP_CODE, PLAYER_MAP_REQ_GET_DATA, tile);
  EXPECT_THROW(map.RequestMap(), PlayerError);
}

TEST_F(A04, SimulationFillsItsReferences) {
  SimulationProxy simulation(&client);
  double x = 7.0;
  double y = 8.0;
  double a = 9.0;
  simulation.GetPose2d("r0", x, y, a);  // refused: printed only
  EXPECT_EQ(x, 7.0);
  server.Answer(PLAYER_SIMULATION_CODE, PLAYER_SIMULATION_REQ_GET_POSE2D,
                wire::player::SimulationPose2dReq{"r0", {1.0, 2.0, 3.0}});
  char name[] = "r0";
  simulation.GetPose2d(name, x, y, a);
  EXPECT_EQ(x + y + a, 6.0);
}

TEST_F(A04, DrawingSendsThePen) {
  Graphics2dProxy graphics(&client);
  graphics.Color(1, 2, 3, 4);
  player_point_2d_t points[] = {{1.0, 2.0}, {3.0, 4.0}};
  graphics.DrawPolyline(points, 2);
  ASSERT_TRUE(server.WaitFor(PLAYER_GRAPHICS2D_CODE, Type::kCommand, 3));
  wire::player::Graphics2dCmdPolyline line;
  ASSERT_TRUE(wire::player::Decode(server.Messages().back().body, line));
  EXPECT_EQ(line.points.back().py, 4.0);
  EXPECT_EQ(line.color, (wire::player::Color{4, 1, 2, 3}));
}

TEST_F(A04, ACamerasFrameIsSaved) {
  CameraProxy camera(&client);
  const std::string prefix = ::testing::TempDir() + "ccmorse_camera";
  EXPECT_NO_THROW(camera.GetWidth());
  wire::player::CameraData image;
  image.width = 2;
  image.height = 1;
  image.format = PLAYER_CAMERA_FORMAT_MONO8;
  image.image = {10, 20};
  server.Data(PLAYER_CAMERA_CODE, 0, 1, 1.0, image);
  client.Read();
  EXPECT_EQ(camera.GetImageSize(), 2U);
  camera.SaveFrame(prefix);
  std::ifstream in(prefix + "0000.ppm", std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  EXPECT_EQ(bytes.str(), std::string("P6\n2 1\n255\n\x0a\x0a\x0a\x14\x14\x14"));
}

TEST_F(A04, ValuesPrintTheirFields) {
  EXPECT_EQ(Text(player_pose2d_t{1.0, 2.0, 3.0}), "1, 2, 3");
  EXPECT_EQ(Text(client), "localhost: " + std::to_string(server.port()));
  const Position2dProxy position(&client);
  Odometry(1.0);
  client.Read();
  EXPECT_EQ(Text(position),
            "#Position2D (4:0)\n#xpos\typos\ttheta\tspeed\tsidespeed\tturn\tstall\n"
            "1.5 2.5 0.25 0.5 0 -0.5 1\n");
  EXPECT_EQ(Text(static_cast<const ClientProxy&>(position)), "stage: position2d(0)");
}

TEST_F(A04, EverythingThrownIsAPlayerError) {
  EXPECT_TRUE((std::is_base_of_v<PlayerError, CCMorse::MorseError>));
  EXPECT_FALSE((std::is_base_of_v<std::exception, PlayerError>));
  EXPECT_THROW(PlayerClient("localhost", 1), PlayerError);
  EXPECT_THROW(PlayerClient("ftp://localhost", 1), PlayerError);
  EXPECT_THROW(PlayerClient("localhost", server.port(), PLAYERC_TRANSPORT_UDP), PlayerError);
  EXPECT_THROW(Position2dProxy(nullptr), PlayerError);
}

// --- Which back end an address means

TEST(PlayerAddress, AGreetingMakesAPlayerServer) {
  PlayerDouble server(Devices());
  PlayerClient plain("127.0.0.1", server.port());
  EXPECT_THROW(plain.GetMorseClient(), PlayerError);
  PlayerClient named("player://127.0.0.1:" + std::to_string(server.port()));
  EXPECT_EQ(named.GetPort(), server.port());
  EXPECT_EQ(named.GetHostname(), "127.0.0.1");
}

TEST(PlayerAddress, SilenceMakesASimulator) {
  FakeServer simulator;
  PlayerClient plain("127.0.0.1", static_cast<std::uint32_t>(simulator.port()));
  PlayerClient named("morse://127.0.0.1:" + std::to_string(simulator.port()));
  EXPECT_EQ(&plain.GetMorseClient(), &named.GetMorseClient());
  Position2dProxy position(&named);
  LaserProxy laser(&named);
  RangerProxy ranger(&named);
  named.Read();
  EXPECT_EQ(position.GetXPos(), 1.0);
  EXPECT_EQ(laser.GetRange(100), 0.5);
  EXPECT_EQ(ranger.GetRange(100), 0.5);
  EXPECT_EQ(ranger.GetElementCount(), 1U);
  EXPECT_EQ(laser.GetRobotPose().px, 1.0);
  simulator.ClearLines();
  position.SetSpeed(0.25, 0.5);
  named.Read();
  EXPECT_EQ(simulator.Count("s1r.motion set_speed [0.25, 0.5]"), 1U);
  const PlayerError error = ErrorOf([&] { const SonarProxy sonar(&named); });
  EXPECT_TRUE(error.GetErrorStr().starts_with("could not subscribe"));
}

TEST(PlayerAddress, GraphicsDrawOnTheSimulatorsCanvas) {
  FakeServer simulator;
  PlayerClient client("morse://127.0.0.1:" + std::to_string(simulator.port()));
  Graphics2dProxy graphics(&client);
  graphics.Color(255, 0, 0, 0);
  player_point_2d_t points[] = {{0.01, 0.01}, {0.05, 0.01}};
  simulator.ClearLines();
  graphics.DrawPolyline(points, 2);
  client.Read();
  EXPECT_EQ(simulator.Count("s1r.pen set_line [0, 0, 2, 0, 255, 0, 0"), 1U);
}

}  // namespace
}  // namespace ccmorse::test
