// Each interface that is served (specs: player.md B.7), as a client sees it.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "base/trig.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/player_wire_client.h"
#include "wire/player/deflate.h"

namespace ccmorse::servers {
namespace {

namespace wire = ccmorse::wire::player;
using testing::PlayerWireClient;
using wire::MessageType;

// A robot "a" that looks along x at a red box 1 m before its origin, and a green robot "b" to its
// left.
constexpr const char* kScene = R"({"world": {"name": "hall", "size": [6, 4], "boxes": [
      {"id": 7, "kind": "block", "x": 3.1, "y": 2, "size": [0.2, 0.4], "height": 0.3,
       "color": "#ff0000"}]},
    "robots": [{"name": "a", "pose": {"x": 2, "y": 2, "yaw_deg": 0}, "front": "sensors",
                "ir": {}, "sonar": {}},
               {"name": "b", "pose": {"x": 2, "y": 3, "yaw_deg": 90}, "color": "#00ff00"}],
    "canvas": {"width": 60, "height": 40}})";

class PlayerDevices : public ::testing::Test {
 protected:
  PlayerDevices() : served_(kScene, Pace::kLockstep), client_(served_.player_port()) {
    client_.SetPull(true);
  }

  template <typename Struct>
  Struct Read(std::uint16_t interface_code, std::uint16_t index = 0) {
    return client_.ReadUntil(interface_code, index).As<Struct>();
  }
  template <typename Struct>
  MessageType Ask(std::uint16_t interface_code, std::uint8_t subtype, const Struct& body) {
    return client_.RequestWith(interface_code, 0, subtype, body).header.type;
  }
  Color Cell(int x, int y) {
    // After a reply all commands before it have been taken.
    return served_.simulation().canvas().GetPixel(x, y);
  }

  ServedSimulation served_;
  PlayerWireClient client_;
};

TEST_F(PlayerDevices, RingsAreSonarIrAndRangers) {
  client_.Subscribe(wire::kSonar, 0);
  client_.Subscribe(wire::kIr, 0);
  client_.Subscribe(wire::kRanger, 1);
  client_.Subscribe(wire::kRanger, 2);
  const auto sonar = Read<wire::SonarData>(wire::kSonar);
  ASSERT_EQ(sonar.ranges.size(), 6U);
  const auto poses = client_.Get<wire::SonarGeom>(wire::kSonar, 0, wire::kSonarReqGetGeom).poses;
  ASSERT_EQ(poses.size(), 6U);
  EXPECT_NEAR(poses[0].pyaw, kPi / 2.0, 1e-9);
  // The one that looks ahead sees the box.
  EXPECT_NEAR(poses[4].px, 0.055, 1e-9);
  EXPECT_NEAR(sonar.ranges[4], 1.0 - 0.055, 1e-3);
  const auto ranger = Read<wire::RangerDataRange>(wire::kRanger, 1);
  EXPECT_NEAR(ranger.ranges[4], sonar.ranges[4], 1e-6);
  const auto ir = Read<wire::IrData>(wire::kIr);
  EXPECT_EQ(ir.ranges.size(), 8U);
  EXPECT_EQ(ir.voltages.size(), 8U);
  EXPECT_EQ(client_.Get<wire::IrPose>(wire::kIr, 0, wire::kIrReqPose).poses.size(), 8U);
  EXPECT_EQ(Read<wire::RangerDataRange>(wire::kRanger, 2).ranges.size(), 8U);
  const auto config = client_.Get<wire::RangerConfig>(wire::kRanger, 1, wire::kRangerReqGetConfig);
  EXPECT_NEAR(config.max_range, 5.0, 1e-9);
  EXPECT_NEAR(config.min_range, 0.05, 1e-9);
  EXPECT_EQ(
      client_.Get<wire::RangerGeom>(wire::kRanger, 1, wire::kRangerReqGetGeom).element_poses.size(),
      6U);
}

TEST_F(PlayerDevices, BumpersCloseWhereTheRobotTouches) {
  client_.Subscribe(wire::kBumper, 0);
  client_.Subscribe(wire::kPosition2d, 0);
  const auto sides =
      client_.Get<wire::BumperGeom>(wire::kBumper, 0, wire::kBumperReqGetGeom).bumper_def;
  ASSERT_EQ(sides.size(), 8U);
  EXPECT_EQ(Read<wire::BumperData>(wire::kBumper).bumpers, std::vector<std::uint8_t>(8, 0));
  wire::Position2dCmdVel ahead;
  ahead.vel = {0.5, 0.0, 0.0};
  client_.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, ahead);
  wire::BumperData data;
  for (int i = 0; i < 25; ++i) data = Read<wire::BumperData>(wire::kBumper);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(data.bumpers[i] != 0, std::fabs(sides[i].pose.pyaw) < 1e-6) << "side " << i;
  }
  const auto state = Read<wire::Position2dData>(wire::kPosition2d);
  EXPECT_EQ(state.stall, 1);
  EXPECT_NEAR(state.pos.px, 1.0 - 0.087, 1e-4);
}

TEST_F(PlayerDevices, TheBatteryIsFull) {
  client_.Subscribe(wire::kPower, 0);
  const auto data = Read<wire::PowerData>(wire::kPower);
  EXPECT_EQ(data.valid, 9U);
  EXPECT_EQ(data.percent, 100.0);
  EXPECT_EQ(data.volts, 12.0);
}

TEST_F(PlayerDevices, SimulationTellsAndSetsPosesByName) {
  client_.Subscribe(wire::kSimulation, 0);
  wire::SimulationPose2dReq asked;
  asked.name = "b";
  const auto b = client_.Get<wire::SimulationPose2dReq>(
      wire::kSimulation, 0, wire::kSimulationReqGetPose2d, wire::Encode(asked));
  EXPECT_EQ(b.name, "b");
  EXPECT_NEAR(b.pose.py, 3.0, 1e-12);
  EXPECT_NEAR(b.pose.pa, kPi / 2.0, 1e-12);
  asked.name = "box_7";
  EXPECT_NEAR(client_
                  .Get<wire::SimulationPose2dReq>(
                      wire::kSimulation, 0, wire::kSimulationReqGetPose2d, wire::Encode(asked))
                  .pose.px,
              3.1, 1e-12);
  EXPECT_EQ(Ask(wire::kSimulation, wire::kSimulationReqSetPose2d, asked), MessageType::kNack);
  asked.name = "nobody";
  EXPECT_EQ(Ask(wire::kSimulation, wire::kSimulationReqGetPose2d, asked), MessageType::kNack);
  wire::SimulationPose3dReq place;
  place.name = "b";
  place.pose = {1.0, 1.0, 9.0, 9.0, 9.0, -1.0};
  EXPECT_EQ(Ask(wire::kSimulation, wire::kSimulationReqSetPose3d, place), MessageType::kAck);
  const auto moved = client_.Get<wire::SimulationPose3dReq>(
      wire::kSimulation, 0, wire::kSimulationReqGetPose3d, wire::Encode(place));
  EXPECT_EQ(moved.pose, (wire::Pose3d{1.0, 1.0, 0.0, 0.0, 0.0, -1.0}));
  place.pose = {3.1, 2.0, 0.0, 0.0, 0.0, 0.0};  // in the box
  EXPECT_EQ(Ask(wire::kSimulation, wire::kSimulationReqSetPose3d, place), MessageType::kNack);
  client_.Send(MessageType::kCommand, wire::kSimulation, 0, wire::kSimulationCmdReset);
  asked.name = "b";
  EXPECT_NEAR(client_
                  .Get<wire::SimulationPose2dReq>(
                      wire::kSimulation, 0, wire::kSimulationReqGetPose2d, wire::Encode(asked))
                  .pose.py,
              3.0, 1e-12);
}

TEST_F(PlayerDevices, SimulationPausesAndGoesOn) {
  client_.Subscribe(wire::kSimulation, 0);
  client_.Subscribe(wire::kPosition2d, 0);
  wire::Position2dCmdVel ahead;
  ahead.vel = {0.3, 0.0, 0.0};
  client_.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, ahead);
  client_.Send(MessageType::kCommand, wire::kSimulation, 0, wire::kSimulationCmdPause);
  EXPECT_EQ(Read<wire::Position2dData>(wire::kPosition2d).pos.px, 0.0);
  client_.Send(MessageType::kCommand, wire::kSimulation, 0, wire::kSimulationCmdPause);
  EXPECT_NEAR(Read<wire::Position2dData>(wire::kPosition2d).pos.px, 0.03, 1e-9);
}

TEST_F(PlayerDevices, SimulationKnowsColoursAsStageDoes) {
  wire::SimulationPropertyReq asked;
  asked.name = "b";
  asked.prop = "color";
  const auto reply = client_.Get<wire::SimulationPropertyReq>(
      wire::kSimulation, 0, wire::kSimulationReqGetProperty, wire::Encode(asked));
  ASSERT_EQ(reply.value.size(), 16U);
  std::array<float, 4> parts{};
  std::memcpy(parts.data(), reply.value.data(), 16);
  EXPECT_EQ(parts, (std::array<float, 4>{0.0F, 1.0F, 0.0F, 1.0F}));
  asked.prop = "mass";
  EXPECT_EQ(Ask(wire::kSimulation, wire::kSimulationReqGetProperty, asked), MessageType::kNack);
}

TEST_F(PlayerDevices, Graphics2dDrawsInTheRobotsFrameAndInTheWorlds) {
  client_.Subscribe(wire::kGraphics2d, 0);
  client_.Subscribe(wire::kGraphics2d, 1);
  // Cells are 0.1 m; the robot is at (2, 2).
  wire::Graphics2dCmdPoints points;
  points.points = {{1.05, 0.05}};
  points.color = {0, 255, 0, 0};
  client_.Command(wire::kGraphics2d, 0, wire::kGraphics2dCmdPoints, points);
  points.color = {0, 0, 255, 0};
  client_.Command(wire::kGraphics2d, 1, wire::kGraphics2dCmdPoints, points);
  wire::Graphics2dCmdPolyline line;
  line.points = {{0.05, 3.05}, {0.35, 3.05}, {0.35, 3.35}};
  line.color = {255, 1, 2, 3};
  client_.Command(wire::kGraphics2d, 1, wire::kGraphics2dCmdPolyline, line);
  wire::Graphics2dCmdPolygon polygon;
  polygon.points = {{4.0, 1.0}, {5.0, 1.0}, {5.0, 2.0}, {4.0, 2.0}};
  polygon.color = {255, 9, 9, 9};
  polygon.fill_color = {255, 8, 8, 8};
  polygon.filled = 1;
  client_.Command(wire::kGraphics2d, 1, wire::kGraphics2dCmdPolygon, polygon);
  wire::Graphics2dCmdMultiline pairs;
  pairs.points = {{0.05, 0.05}, {0.05, 0.15}, {0.45, 0.05}, {0.45, 0.15}};
  pairs.color = {255, 5, 5, 5};
  client_.Command(wire::kGraphics2d, 1, wire::kGraphics2dCmdMultiline, pairs);
  // What cannot be drawn is left out.
  points.points = {{std::nan(""), 0.0}};
  client_.Command(wire::kGraphics2d, 1, wire::kGraphics2dCmdPoints, points);
  client_.Request(wire::kGraphics2d, 1, 99);
  EXPECT_EQ(Cell(30, 20), (Color{255, 0, 0}));
  EXPECT_EQ(Cell(10, 0), (Color{0, 255, 0}));
  EXPECT_EQ(Cell(2, 30), (Color{1, 2, 3}));
  EXPECT_EQ(Cell(3, 32), (Color{1, 2, 3}));
  EXPECT_EQ(Cell(45, 15), (Color{8, 8, 8}));
  EXPECT_EQ(Cell(40, 15), (Color{9, 9, 9}));
  EXPECT_EQ(Cell(0, 1), (Color{5, 5, 5}));
  EXPECT_EQ(Cell(2, 0), (Color{255, 255, 255}));  // between the pairs
  client_.Send(MessageType::kCommand, wire::kGraphics2d, 0, wire::kGraphics2dCmdClear);
  client_.Request(wire::kGraphics2d, 1, 99);
  EXPECT_FALSE(served_.simulation().canvas().IsDrawn(45, 15));
}

TEST_F(PlayerDevices, TheMapIsTheWorldInDeflatedTiles) {
  const auto info = client_.Get<wire::MapInfo>(wire::kMap, 0, wire::kMapReqGetInfo);
  EXPECT_NEAR(info.scale, 0.02, 1e-7);
  EXPECT_EQ(info.width, 300U);
  EXPECT_EQ(info.height, 200U);
  EXPECT_EQ(info.origin, wire::Pose2d{});
  wire::MapData tile;
  tile.col = 100;
  tile.row = 50;
  tile.width = 100;
  tile.height = 100;
  const auto reply =
      client_.Get<wire::MapData>(wire::kMap, 0, wire::kMapReqGetData, wire::Encode(tile));
  EXPECT_EQ(reply.data_range, 1);
  const auto cells = wire::Inflate(reply.data, 100 * 100);
  ASSERT_TRUE(cells);
  ASSERT_EQ(cells->size(), 100U * 100U);
  // The box lies from x 3.0 to 3.2 and y 1.8 to 2.2.
  const auto cell = [&](int x, int y) {
    return static_cast<std::int8_t>(
        cells->at(static_cast<std::size_t>(y - 50) * 100 + static_cast<std::size_t>(x - 100)));
  };
  EXPECT_EQ(cell(149, 100), -1);
  EXPECT_EQ(cell(150, 100), 1);
  EXPECT_EQ(cell(159, 90), 1);
  EXPECT_EQ(cell(159, 89), -1);
  tile.col = 290;
  EXPECT_EQ(Ask(wire::kMap, wire::kMapReqGetData, tile), MessageType::kNack);
  tile = {0, 0, 641, 1, 0, {}};
  EXPECT_EQ(Ask(wire::kMap, wire::kMapReqGetData, tile), MessageType::kNack);
  EXPECT_EQ(client_.Get<wire::MapDataVector>(wire::kMap, 0, wire::kMapReqGetVector).segments.size(),
            4U);
}

TEST_F(PlayerDevices, BlobsHaveTheScenesColours) {
  client_.Subscribe(wire::kBlobfinder, 0);
  const auto data = Read<wire::BlobfinderData>(wire::kBlobfinder);
  EXPECT_EQ(data.width, 80U);
  ASSERT_EQ(data.blobs.size(), 1U);
  const wire::BlobfinderBlob& blob = data.blobs[0];
  EXPECT_EQ(blob.color, 0xff0000U);
  EXPECT_NEAR(blob.range, 1.0, 1e-3);
  // 0.4 m wide, 1 m away: 22.6 of the 60 degrees.
  EXPECT_NEAR(blob.right - blob.left + 1.0, 22.6 / 60.0 * 80.0, 1.5);
  EXPECT_NEAR(blob.x, 40.0, 1.0);
  EXPECT_LT(blob.top, 30U);  // higher than the eye
  EXPECT_GT(blob.bottom, 30U);
}

TEST_F(PlayerDevices, FiducialsAreWhatIsSeenById) {
  client_.Subscribe(wire::kFiducial, 0);
  auto data = Read<wire::FiducialData>(wire::kFiducial);
  ASSERT_EQ(data.fiducials.size(), 2U);  // from the right
  EXPECT_EQ(data.fiducials[0].id, 7);
  EXPECT_NEAR(data.fiducials[0].pose.px, 1.1, 1e-9);
  EXPECT_EQ(data.fiducials[1].id, 1002);
  EXPECT_NEAR(data.fiducials[1].pose.py, 1.0, 1e-9);
  EXPECT_NEAR(data.fiducials[1].pose.pyaw, kPi / 2.0, 1e-9);
  wire::FiducialFov view =
      client_.Get<wire::FiducialFov>(wire::kFiducial, 0, wire::kFiducialReqGetFov);
  view.view_angle = 1.0;
  EXPECT_EQ(Ask(wire::kFiducial, wire::kFiducialReqSetFov, view), MessageType::kAck);
  data = Read<wire::FiducialData>(wire::kFiducial);
  EXPECT_EQ(data.fiducials.size(), 1U);
  view.max_range = 1e9;
  EXPECT_EQ(Ask(wire::kFiducial, wire::kFiducialReqSetFov, view), MessageType::kNack);
  EXPECT_EQ(client_.Get<wire::FiducialId>(wire::kFiducial, 0, wire::kFiducialReqGetId).id, 1001U);
}

TEST_F(PlayerDevices, OpaqueHandsOnToAllClients) {
  client_.Subscribe(wire::kOpaque, 0);
  PlayerWireClient other(served_.player_port());
  wire::OpaqueData data;
  data.data = {1, 2, 3, 250};
  other.Subscribe(wire::kOpaque, 0);
  other.Command(wire::kOpaque, 0, wire::kOpaqueCmdData, data);
  EXPECT_EQ(Read<wire::OpaqueData>(wire::kOpaque), data);
  EXPECT_EQ(other.Receive()->As<wire::OpaqueData>(), data);
  EXPECT_EQ(other.RequestWith(wire::kOpaque, 0, wire::kOpaqueReqData, data).As<wire::OpaqueData>(),
            data);
}

TEST_F(PlayerDevices, SpeechIsTaken) {
  client_.Subscribe(wire::kSpeech, 0);
  ::testing::internal::CaptureStderr();
  client_.Command(wire::kSpeech, 0, wire::kSpeechCmdSay, wire::SpeechCmd{"hello \"world\"\n"});
  client_.Request(wire::kSpeech, 0, 99);
  const std::string log = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(log.find(R"(a says "hello \"world\"\n")"), std::string::npos) << log;
}

// A world of Stage has its (0, 0) in the middle, and programs know its coordinates.
TEST(PlayerOrigin, ClientsAreToldTheCoordinatesOfTheWorldsFile) {
  ServedSimulation served(R"({"world": {"name": "hall", "size": [6, 4], "origin": [3, 2],
      "boxes": []}, "robots": [{"name": "a", "pose": {"x": 2, "y": 2.5, "yaw": 0}}],
      "canvas": {"width": 60, "height": 40}})",
                          Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kSimulation, 0);
  client.Subscribe(wire::kPosition2d, 2);
  client.Subscribe(wire::kMap, 0);
  wire::SimulationPose2dReq asked;
  asked.name = "a";
  const auto place = [&] {
    return client
        .Get<wire::SimulationPose2dReq>(wire::kSimulation, 0, wire::kSimulationReqGetPose2d,
                                        wire::Encode(asked))
        .pose;
  };
  EXPECT_EQ(place(), (wire::Pose2d{-1.0, 0.5, 0.0}));
  const auto pose = client.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().pos;
  EXPECT_NEAR(pose.px, -1.0, 1e-9);
  EXPECT_NEAR(pose.py, 0.5, 1e-9);
  asked.pose = {1.0, -1.0, 0.0};
  EXPECT_EQ(
      client.RequestWith(wire::kSimulation, 0, wire::kSimulationReqSetPose2d, asked).header.type,
      MessageType::kAck);
  EXPECT_EQ(place(), (wire::Pose2d{1.0, -1.0, 0.0}));
  EXPECT_NEAR(served.simulation().robots()[0]->pose().x, 4.0, 1e-12);
  const auto info = client.Get<wire::MapInfo>(wire::kMap, 0, wire::kMapReqGetInfo);
  EXPECT_EQ(info.origin, (wire::Pose2d{-3.0, -2.0, 0.0}));
}

}  // namespace
}  // namespace ccmorse::servers
