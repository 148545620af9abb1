// `ccmorse run` as a Player server, from the command line.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "tests/support/player_wire_client.h"
#include "tests/support/process.h"

namespace ccmorse {
namespace {

namespace wire = ccmorse::wire::player;
using testing::BuiltProgram;
using testing::PlayerWireClient;
using testing::Process;
using testing::RunToEnd;

// A port of 127.0.0.1 that somebody listens on.
class TakenPort {
 public:
  // 0: any. That one may be taken by another already, which is as good.
  explicit TakenPort(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    if (::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
      ::listen(socket_, 1);
    }
    socklen_t size = sizeof address;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~TakenPort() { ::close(socket_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  int port() const { return port_; }

 private:
  int socket_;
  int port_ = 0;
};

int PlayerPort(Process& process) {
  const std::string key = "Player on 127.0.0.1 port ";
  const auto line = process.WaitForLine(key);
  return line ? std::atoi(line->c_str() + key.size()) : 0;
}

std::string FreePort() { return std::to_string(TakenPort(0).port()); }

TEST(PlayerServerProgram, ARunWithAPlayerClientIsRecordedAndReplaysTheSame) {
  const testing::TemporaryFolder folder;
  const std::string record = folder.path() + "/run.mcap";
  Process process({BuiltProgram("ccmorse"), "run", "syrotek", "--port", "0", "--stream-port", "0",
                   "--pace", "lockstep", "--for", "3", "--record", record});
  const int port = PlayerPort(process);
  ASSERT_NE(port, 0) << process.output();
  {
    PlayerWireClient client(port);
    client.SetPull(true);
    client.Subscribe(wire::kPosition2d, 0);
    client.Subscribe(wire::kLaser, 0);
    client.Subscribe(wire::kGraphics2d, 0);
    for (int i = 0; i < 28; ++i) {
      client.Read();
      wire::Position2dCmdVel command;
      command.vel = {0.2, 0.0, i % 2 == 0 ? 0.7 : -0.3};
      client.Command(wire::kPosition2d, 0, wire::kPosition2dCmdVel, command);
      wire::Graphics2dCmdPolyline line;
      line.points = {{0.0, 0.0}, {0.3, 0.1}};
      client.Command(wire::kGraphics2d, 0, wire::kGraphics2dCmdPolyline, line);
    }
    client.Read();
    client.Send(wire::MessageType::kRequest, wire::kPlayer, 0, wire::kPlayerReqData);
    while (client.Receive()) {  // until the run ends
    }
  }
  EXPECT_EQ(process.Wait(), 0) << process.output();
  // Of the 30 scans it has fetched nearly all.
  EXPECT_NE(process.output().find(" 29/30"), std::string::npos) << process.output();
  const auto replay = RunToEnd({BuiltProgram("ccmorse"), "replay", record, "--verify"});
  EXPECT_EQ(replay.status, 0) << replay.output;
  EXPECT_NE(replay.output.find("equal"), std::string::npos) << replay.output;
}

TEST(PlayerServerProgram, APortThatIsAskedForAndTakenIsAnError) {
  const TakenPort taken(0);
  const auto finished =
      RunToEnd({BuiltProgram("ccmorse"), "run", "syrotek", "--port", "0", "--stream-port", "0",
                "--for", "0.1", "--player-port", std::to_string(taken.port())});
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.output.find(std::to_string(taken.port())), std::string::npos);
  EXPECT_NE(finished.output.find("--no-player"), std::string::npos) << finished.output;
}

TEST(PlayerServerProgram, PlayersOwnPortMayBeTakenByAnotherSimulation) {
  const TakenPort taken(6665);
  const auto finished = RunToEnd({BuiltProgram("ccmorse"), "run", "syrotek", "--port", FreePort(),
                                  "--stream-port", "0", "--for", "0.1", "--pace", "max"});
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_NE(finished.output.find("Player's protocol is not served: port 6665"), std::string::npos)
      << finished.output;
}

TEST(PlayerServerProgram, NoPlayerLeavesItOut) {
  const auto finished =
      RunToEnd({BuiltProgram("ccmorse"), "run", "syrotek", "--port", "0", "--stream-port", "0",
                "--for", "0.1", "--pace", "max", "--no-player"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.output.find("Player on"), std::string::npos) << finished.output;
}

TEST(PlayerServerProgram, EachRobotOfAFleetHasItsPort) {
  Process process({BuiltProgram("ccmorse"), "run", "docks", "--port", "0", "--stream-port", "0",
                   "--for", "0.1", "--pace", "max"});
  EXPECT_EQ(process.Wait(), 0);
  std::size_t count = 0;
  for (std::size_t at = 0; (at = process.output().find("Player on", at)) != std::string::npos;
       ++at) {
    ++count;
  }
  EXPECT_EQ(count, 13U) << process.output();
}

}  // namespace
}  // namespace ccmorse
