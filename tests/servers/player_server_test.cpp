// Player's protocol on real sockets (specs: player.md B, H).

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "base/trig.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/player_wire_client.h"

namespace ccmorse::servers {
namespace {

namespace wire = ccmorse::wire::player;
using testing::PlayerWireClient;
using wire::MessageType;

constexpr const char* kWideHall = R"({"world": {"name": "hall", "size": [10, 10], "boxes": []},
    "robots": [{"name": "a", "pose": {"x": 2, "y": 5, "yaw_deg": 0}}]})";

constexpr const char* kPair = R"({"world": {"name": "hall", "size": [10, 10], "boxes": []},
    "robots": [{"name": "b", "pose": {"x": 2, "y": 5}}, {"name": "a", "pose": {"x": 5, "y": 5}}]})";

wire::Position2dCmdVel Velocity(double x, double turn) {
  wire::Position2dCmdVel command;
  command.vel = {x, 0.0, turn};
  command.state = 1;
  return command;
}

TEST(PlayerServer, GreetsWith32BytesOfBanner) {
  ServedSimulation served(kWideHall);
  const PlayerWireClient client(served.player_port());
  EXPECT_EQ(client.banner().substr(0, 15), std::string("Player v.3.1.0\0", 15));
  EXPECT_EQ(client.banner().size(), 32U);
}

TEST(PlayerServer, ListsTheDevicesOfItsPortAndTheirDrivers) {
  ServedSimulation served(kWideHall);
  PlayerWireClient client(served.player_port());
  const auto list = client.Get<wire::DeviceDevlist>(wire::kPlayer, 0, wire::kPlayerReqDevlist);
  ASSERT_GE(list.devices.size(), 4U);
  EXPECT_EQ(list.devices[0],
            (wire::Devaddr{0x0100007f, static_cast<std::uint32_t>(served.player_port()),
                           wire::kPosition2d, 0}));
  for (const wire::Devaddr& device : list.devices) {
    wire::DeviceDriverinfo asked;
    asked.addr = device;
    const auto info = client.Get<wire::DeviceDriverinfo>(
        wire::kPlayer, 0, wire::kPlayerReqDriverinfo, wire::Encode(asked));
    EXPECT_EQ(info.addr, device);
    EXPECT_FALSE(info.driver_name.empty());
  }
}

TEST(PlayerServer, EachRobotHasAPortOfItsOwnInTheScenariosOrder) {
  ServedSimulation served(kPair, Pace::kLockstep);
  PlayerWireClient first(served.player_port(0));
  first.SetPull(true);
  first.Subscribe(wire::kPosition2d, 2);
  EXPECT_EQ(first.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().pos.px, 2.0);
  PlayerWireClient second(served.player_port(1));
  second.SetPull(true);
  second.Subscribe(wire::kPosition2d, 2);
  first.Send(MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);  // lets time go on
  EXPECT_EQ(second.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().pos.px, 5.0);
}

TEST(PlayerServer, RefusesUnknownDevicesAtOnce) {
  ServedSimulation served(kWideHall);
  PlayerWireClient client(served.player_port());
  wire::DeviceReq wanted;
  wanted.addr = {0, 0, wire::kGripper, 7};
  wanted.access = 1;
  const auto refused = client.RequestWith(wire::kPlayer, 0, wire::kPlayerReqDev, wanted);
  EXPECT_EQ(refused.header.type, MessageType::kNack);
  EXPECT_EQ(refused.body.size(), 28U);  // B.5
  EXPECT_EQ(refused.body[19], 3);       // access
  EXPECT_EQ(client.Request(wire::kGripper, 7, wire::kGripperReqGetGeom).header.type,
            MessageType::kNack);  // H8
  EXPECT_EQ(client.Request(wire::kPlayer, 0, wire::kPlayerReqAuth).header.type, MessageType::kNack);
  EXPECT_EQ(client.Request(wire::kPlayer, 0, 99).header.type, MessageType::kNack);
}

TEST(PlayerServer, APullRoundIsAckThenDataThenSynch) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  EXPECT_EQ(client.Subscribe(wire::kPosition2d, 0), "ccmorse");
  client.Subscribe(wire::kLaser, 0);
  for (int i = 1; i <= 5; ++i) {
    const auto round = client.Read();
    // What has the same rate comes together, stamped alike, as Stage's data do.
    ASSERT_EQ(round.size(), 3U) << "round " << i;
    EXPECT_EQ(round[0].header.address.interf, wire::kPosition2d);
    EXPECT_EQ(round[1].header.address.interf, wire::kLaser);
    EXPECT_EQ(round[0].header.time, round[1].header.time);
    EXPECT_NEAR(round[0].header.time, 0.1 * i, 1e-12);  // and never 0 (H4)
    EXPECT_EQ(round[2].header.type, MessageType::kSynch);
    EXPECT_EQ(round[2].header.subtype, wire::kPlayerSynchOk);
    EXPECT_TRUE(round[2].body.empty());
  }
}

TEST(PlayerServer, NoSynchComesWithoutData) {
  ServedSimulation served(kWideHall);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Send(MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
  EXPECT_EQ(client.Receive()->header.type, MessageType::kAck);
  EXPECT_FALSE(client.Receive(std::chrono::milliseconds(300)));
}

TEST(PlayerServer, PushIsTheDefaultAndHasNoSynch) {
  ServedSimulation served(kWideHall);
  PlayerWireClient client(served.player_port());
  client.Subscribe(wire::kPosition2d, 0);
  double last = 0.0;
  for (int i = 0; i < 5; ++i) {
    const auto message = client.Receive();
    ASSERT_TRUE(message);
    EXPECT_EQ(message->header.type, MessageType::kData);
    EXPECT_GT(message->header.time, last);
    last = message->header.time;
  }
  EXPECT_EQ(client.Request(wire::kPlayer, 0, wire::kPlayerReqData).header.type, MessageType::kNack);
}

TEST(PlayerServer, VelocityCommandsDriveTheRobot) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 0);
  client.Read();
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
  const auto state = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  EXPECT_NEAR(state.pos.px, 0.03, 1e-12);
  EXPECT_NEAR(state.vel.px, 0.3, 1e-12);
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.0, 1.0));
  EXPECT_NEAR(client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>().pos.pa, 0.1, 1e-9);
  wire::Position2dCmdCar car;
  car.velocity = 0.14;
  car.angle = kPi / 2.0;
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdCar, car);
  const auto turned = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  EXPECT_NEAR(turned.vel.px, 0.0, 1e-12);
  EXPECT_NEAR(turned.vel.pa, 1.0, 1e-9);
}

TEST(PlayerServer, TheRobotStopsWhenTheLastSubscriberLeaves) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient viewer(served.player_port());
  viewer.SetPull(true);
  viewer.Subscribe(wire::kPosition2d, 2);
  viewer.Read();
  {
    PlayerWireClient client(served.player_port());
    client.Subscribe(wire::kPosition2d, 0);
    client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
    client.Request(wire::kPosition2d, 0, wire::kPosition2dReqGetGeom);  // it has been taken
    EXPECT_GT(viewer.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().vel.px, 0.2);
    client.Unsubscribe(wire::kPosition2d, 0);
    EXPECT_EQ(viewer.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().vel.px, 0.0);
    // Who has not subscribed does not drive.
    client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
    client.Request(wire::kPosition2d, 0, wire::kPosition2dReqGetGeom);
    EXPECT_EQ(viewer.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().vel.px, 0.0);
  }
}

TEST(PlayerServer, GoToDrivesToTheGoalAndTurns) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 0);
  client.Read();
  wire::Position2dCmdPos goal;
  goal.pos = {0.5, 0.8, -1.0};
  goal.state = 1;
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdPos, goal);
  wire::Position2dData state;
  for (int i = 0; i < 150; ++i) {
    state = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  }
  EXPECT_NEAR(state.pos.px, 0.5, 0.021);
  EXPECT_NEAR(state.pos.py, 0.8, 0.021);
  EXPECT_NEAR(state.pos.pa, -1.0, 0.02);
  EXPECT_EQ(state.vel, wire::Pose2d{});
  wire::Position2dCmdVelHead heading;
  heading.velocity = 0.1;
  heading.angle = 1.0;
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVelHead, heading);
  for (int i = 0; i < 60; ++i) {
    state = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  }
  EXPECT_NEAR(state.pos.pa, 1.0, 0.01);
  EXPECT_NEAR(state.vel.px, 0.1, 1e-9);
}

TEST(PlayerServer, OdometryCanBeSetAndTheGlobalPoseIsAtIndex2) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 0);
  client.Subscribe(wire::kPosition2d, 2);
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
  client.Read();
  wire::Position2dSetOdomReq wanted;
  wanted.pose = {7.0, -3.0, kPi / 2.0};
  EXPECT_EQ(
      client.RequestWith(wire::kPosition2d, 0, wire::kPosition2dReqSetOdom, wanted).header.type,
      MessageType::kAck);
  const auto state = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  EXPECT_NEAR(state.pos.px, 7.0, 1e-9);
  EXPECT_NEAR(state.pos.py, -2.97, 1e-9);
  EXPECT_NEAR(state.pos.pa, kPi / 2.0, 1e-9);
  EXPECT_NEAR(client.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().pos.px, 2.09, 1e-9);
  client.Request(wire::kPosition2d, 0, wire::kPosition2dReqResetOdom);
  const auto reset = client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>();
  EXPECT_NEAR(reset.pos.px, 0.03, 1e-9);
  EXPECT_NEAR(reset.pos.py, 0.0, 1e-9);
}

TEST(PlayerServer, TheBaseHasASizeAndAMotorSwitch) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 0);
  const auto geometry =
      client.Get<wire::Position2dGeom>(wire::kPosition2d, 0, wire::kPosition2dReqGetGeom);
  EXPECT_EQ(geometry.pose, wire::Pose3d{});  // H5
  EXPECT_EQ(geometry.size, (wire::Bbox3d{0.162, 0.174, 0.18}));
  client.RequestWith(wire::kPosition2d, 0, wire::kPosition2dReqMotorPower,
                     wire::Position2dPowerConfig{0});
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
  EXPECT_EQ(client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>().vel.px, 0.0);
  client.RequestWith(wire::kPosition2d, 0, wire::kPosition2dReqMotorPower,
                     wire::Position2dPowerConfig{1});
  client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
  EXPECT_EQ(client.ReadUntil(wire::kPosition2d, 0).As<wire::Position2dData>().vel.px, 0.3);
}

TEST(PlayerServer, OneScannerIsALaserAndARanger) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kLaser, 0);
  client.Subscribe(wire::kRanger, 0);
  const auto round = client.Read();
  ASSERT_EQ(round.size(), 3U);
  const auto laser = round[0].As<wire::LaserData>();
  const auto ranger = round[1].As<wire::RangerDataRange>();
  ASSERT_EQ(laser.ranges.size(), 682U);
  EXPECT_EQ(laser.intensity.size(), 682U);
  ASSERT_EQ(ranger.ranges.size(), 682U);
  for (std::size_t i = 0; i < 682; ++i) {
    EXPECT_GE(laser.ranges[i], 0.0);  // H7
    EXPECT_EQ(static_cast<float>(ranger.ranges[i]), static_cast<float>(laser.ranges[i]));
  }
  EXPECT_NEAR(laser.min_angle, Radians(-135.0), 1e-6);
  EXPECT_NEAR(laser.max_angle, laser.min_angle + 681 * laser.resolution, 1e-5);
  const auto config = client.Get<wire::LaserConfig>(wire::kLaser, 0, wire::kLaserReqGetConfig);
  EXPECT_NEAR(config.scanning_frequency, 10.0, 1e-6);
  EXPECT_NEAR(config.max_range, 5.0, 1e-6);
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kLaserReqSetConfig, config).header.type,
            MessageType::kAck);
  wire::LaserConfig other = config;
  other.max_range = 9.0;
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kLaserReqSetConfig, other).header.type,
            MessageType::kNack);
  const auto geometry = client.Get<wire::RangerGeom>(wire::kRanger, 0, wire::kRangerReqGetGeom);
  EXPECT_NEAR(geometry.pose.px, 0.035, 1e-12);
  EXPECT_EQ(geometry.element_poses.size(), 1U);
  client.RequestWith(wire::kRanger, 0, wire::kRangerReqIntns, wire::RangerIntnsConfig{1});
  const auto with_intensities = client.Read();
  ASSERT_EQ(with_intensities.size(), 4U);
  EXPECT_EQ(with_intensities[2].header.subtype, wire::kRangerDataIntns);
}

TEST(PlayerServer, CapabilitiesAndPropertiesAreThere) {
  ServedSimulation served(kWideHall);
  PlayerWireClient client(served.player_port());
  const auto can = [&](MessageType type, std::uint8_t subtype) {
    wire::CapabilitiesReq asked;
    asked.type = static_cast<std::uint32_t>(type);
    asked.subtype = subtype;
    return client.RequestWith(wire::kPosition2d, 0, wire::kCapabilities, asked).header.type ==
           MessageType::kAck;
  };
  EXPECT_TRUE(can(MessageType::kCommand, wire::kPosition2dCmdVel));
  EXPECT_FALSE(can(MessageType::kRequest, wire::kPosition2dReqSpeedPid));
  wire::IntpropReq number;
  number.key = "gain";
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kGetInt, number).header.type,
            MessageType::kNack);
  number.value = -7;
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kSetInt, number).header.type,
            MessageType::kAck);
  number.value = 0;
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kGetInt, number).As<wire::IntpropReq>(),
            (wire::IntpropReq{"gain", -7}));
  const wire::StrpropReq text{"name", "front"};
  client.RequestWith(wire::kLaser, 0, wire::kSetString, text);
  EXPECT_EQ(client.RequestWith(wire::kLaser, 0, wire::kGetString, wire::StrpropReq{"name", ""})
                .As<wire::StrpropReq>(),
            text);
}

TEST(PlayerServer, LockstepWaitsForThePullClientsOfBothProtocols) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient player(served.player_port());
  player.SetPull(true);
  player.Subscribe(wire::kPosition2d, 0);
  player.Read();
  testing::LineClient morse(served.port());
  morse.Ask("1 ccmorse read");
  morse.Send("2 ccmorse read\n");
  EXPECT_FALSE(morse.ReadLine(std::chrono::milliseconds(100)));
  player.Send(MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
  EXPECT_TRUE(morse.ReadLine());
}

TEST(PlayerServer, CommandsSentBeforeTheSocketClosesAreCarriedOut) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  {
    PlayerWireClient client(served.player_port());
    client.Subscribe(wire::kPosition2d, 0);
    client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, Velocity(0.3, 0.0));
  }
  // H11, then H10: it went and stopped. The record, which is replayed at the end, has both calls.
  PlayerWireClient viewer(served.player_port());
  viewer.SetPull(true);
  viewer.Subscribe(wire::kPosition2d, 2);
  EXPECT_EQ(viewer.ReadUntil(wire::kPosition2d, 2).As<wire::Position2dData>().vel.px, 0.0);
}

TEST(PlayerServer, TheEndOfARunClosesTheConnection) {
  ServedSimulation served(kWideHall, Pace::kLockstep, 0.5);
  PlayerWireClient client(served.player_port());
  client.SetPull(true);
  client.Subscribe(wire::kPosition2d, 0);
  for (int i = 0; i < 4; ++i) client.Read();
  client.Send(MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
  EXPECT_EQ(client.Receive()->header.type, MessageType::kAck);
  EXPECT_TRUE(client.socket().IsClosed());
}

TEST(PlayerServer, BrokenStreamsEndOneConnectionOnly) {
  ServedSimulation served(kWideHall);
  PlayerWireClient good(served.player_port());
  good.Subscribe(wire::kPosition2d, 0);
  {
    PlayerWireClient half(served.player_port());
    half.socket().Send(std::string(4, '\0'));  // and then nothing
  }
  PlayerWireClient unknown(served.player_port());
  unknown.socket().Send(std::string(40, '\xff'));
  EXPECT_TRUE(unknown.socket().IsClosed());
  PlayerWireClient huge(served.player_port());
  std::string header;
  wire::Append({{0, 0, wire::kLaser, 0}, MessageType::kRequest, 1, 0.0, 0, 0}, {}, header);
  header.replace(36, 4, std::string("\x01\x00\x00\x00", 4));  // 16 MiB
  huge.socket().Send(header);
  EXPECT_TRUE(huge.socket().IsClosed());
  // A body that is none of the message's is refused, and the connection lives.
  EXPECT_EQ(
      good.Request(wire::kPosition2d, 0, wire::kPosition2dReqSetOdom, {1, 2, 3, 4}).header.type,
      MessageType::kNack);
  EXPECT_EQ(good.Request(wire::kPlayer, 0, wire::kPlayerReqDev, {0, 0, 0, 0}).header.type,
            MessageType::kNack);
  EXPECT_EQ(good.Request(wire::kPosition2d, 0, wire::kPosition2dReqGetGeom).header.type,
            MessageType::kAck);
}

TEST(PlayerServer, AHundredClientsGetEveryRound) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  std::vector<std::unique_ptr<PlayerWireClient>> clients;
  for (int i = 0; i < 100; ++i) {
    clients.push_back(std::make_unique<PlayerWireClient>(served.player_port()));
    clients.back()->SetPull(true);
    clients.back()->Subscribe(wire::kPosition2d, 0);
    clients.back()->Subscribe(wire::kLaser, 0);
  }
  for (int round = 1; round <= 5; ++round) {
    for (const auto& client : clients) {
      client->Send(MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
    }
    for (const auto& client : clients) {
      int data = 0;
      for (;;) {
        const auto message = client->Receive();
        ASSERT_TRUE(message);
        if (message->header.type == MessageType::kSynch) break;
        if (message->header.type == MessageType::kData) ++data;
      }
      EXPECT_EQ(data, 2) << "in round " << round;
    }
  }
}

TEST(PlayerServer, AClientThatNeverReadsCostsLittleAndIsToldWhatItLost) {
  ServedSimulation served(kWideHall, Pace::kLockstep);
  PlayerWireClient lazy(served.player_port());
  lazy.SetPull(true);
  lazy.Subscribe(wire::kPosition2d, 0);
  PlayerWireClient busy(served.player_port());
  busy.SetPull(true);
  busy.Subscribe(wire::kPosition2d, 0);
  for (int i = 0; i < 1030; ++i) busy.Read();
  const auto round = lazy.Read();
  ASSERT_EQ(round.size(), 1025U);
  EXPECT_EQ(round.back().header.subtype, wire::kPlayerSynchOverflow);
  EXPECT_EQ(round.back().As<wire::Overflow>().dropped, 6U);
}

// Lock-step is the same to the byte each time: what the document shows is what is sent.
TEST(PlayerServer, TheBytesAreThoseOfTheDocument) {
  ServedSimulation served(R"({"world": {"name": "h", "size": [4, 4], "boxes": []},
      "robots": [{"name": "s1r", "pose": {"x": 1, "y": 2, "yaw_deg": 0}}]})",
                          Pace::kLockstep);
  const auto port = static_cast<std::uint32_t>(served.player_port());
  std::ifstream document(CCMORSE_SOURCE_DIR "/docs/protocols/player.md");
  std::string line;
  while (std::getline(document, line) && line != "```bytes") {
  }
  struct Piece {
    std::string title;
    std::string bytes;
  };
  std::vector<Piece> pieces;
  while (std::getline(document, line) && line != "```") {
    if (line.rfind("    ", 0) != 0) {
      pieces.push_back({line, ""});
      continue;
    }
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      auto value = static_cast<std::uint32_t>(std::stoul(word, nullptr, 16));
      if (value == 6665) value = port;
      for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        pieces.back().bytes += static_cast<char>(value >> shift & 0xffU);
      }
    }
  }
  ASSERT_GE(pieces.size(), 20U);
  testing::LineClient first(served.player_port());
  std::optional<testing::LineClient> second;
  for (const Piece& piece : pieces) {
    const bool of_second = piece.title.rfind("second ", 0) == 0;
    if (of_second && !second) second.emplace(served.player_port());
    testing::LineClient& connection = of_second ? *second : first;
    if (piece.title.find("client: ") != std::string::npos) {
      connection.Send(piece.bytes);
    } else {
      EXPECT_EQ(connection.ReadBytes(piece.bytes.size()), piece.bytes) << piece.title;
    }
  }
}

}  // namespace
}  // namespace ccmorse::servers
