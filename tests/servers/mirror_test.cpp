#include "servers/player/mirror.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "scene/scenario.h"
#include "sim/sensors/laser_scanner.h"
#include "wire/player/frame.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
namespace player = wire::player;
using asio::ip::tcp;
using player::MessageType;

// A robot as a Player server shows it, for one connection after the other: in each round of PULL a
// pose a little farther on and a scan. It stands at the end of the last round when nobody asks.
class FakeRobot {
 public:
  explicit FakeRobot(bool localised, int connections = 1)
      : localised_(localised), acceptor_(io_, tcp::endpoint(tcp::v4(), 0)), thread_([=, this] {
          for (int i = 0; i < connections; ++i) ServeOne(i + 1 < connections);
        }) {}
  ~FakeRobot() { thread_.join(); }
  int port() const { return acceptor_.local_endpoint().port(); }

 private:
  // Ends after three rounds where `hang_up`, else when the client goes.
  void ServeOne(bool hang_up) {
    tcp::socket socket = acceptor_.accept();
    asio::write(socket, asio::buffer(player::Banner("3.1.0-test")));
    player::FrameReader frames;
    std::array<char, 1024> block{};
    boost::system::error_code gone;
    for (int rounds = 0; !(hang_up && rounds == 3);) {
      const std::size_t size = socket.read_some(asio::buffer(block), gone);
      if (gone) return;
      frames.Append(std::string_view(block.data(), size));
      while (const auto message = frames.Next()) {
        std::string out;
        rounds += Answer(*message, out) ? 1 : 0;
        asio::write(socket, asio::buffer(out), gone);
        if (gone) return;
      }
    }
  }

  bool Answer(const player::Message& message, std::string& out) {
    player::Header header = message.header;
    header.type = MessageType::kAck;
    if (header.subtype == player::kPlayerReqDev) {
      player::DeviceReq request;
      EXPECT_TRUE(player::Decode(message.body, request));
      EXPECT_EQ(message.body.size(), 28U);  // no name, as libplayerc asks
      if (request.addr.index == 2 && !localised_) header.type = MessageType::kNack;
    }
    player::Append(header, {}, out);
    if (header.subtype != player::kPlayerReqData) return false;
    player::Position2dData state;
    state.pos = {1.0, 2.0, 0.5};
    Send(player::kPosition2d, localised_ ? 2 : 0, player::kPosition2dDataState,
         player::Encode(state), out);
    player::LaserData scan;  // five beams from -1 to 1 rad; the middle one has no hit
    scan.min_angle = -1.0;
    scan.max_angle = 1.0;
    scan.resolution = 0.5;
    scan.max_range = 4.0;
    scan.ranges = {0.5, 0.01, 4.0, 1.5, 2.0};
    scan.intensity.resize(5);
    Send(player::kLaser, 0, player::kLaserDataScan, player::Encode(scan), out);
    header.type = MessageType::kSynch;
    header.subtype = player::kPlayerSynchOk;
    player::Append(header, {}, out);
    return true;
  }

  static void Send(std::uint16_t interface_code, std::uint16_t index, std::uint8_t subtype,
                   const player::Bytes& body, std::string& out) {
    player::Header header;
    header.address = {0, 0, interface_code, index};
    header.subtype = subtype;
    header.time = 1.0;
    player::Append(header, body, out);
  }

  const bool localised_;
  asio::io_context io_;
  tcp::acceptor acceptor_;
  std::thread thread_;
};

class MirrorTest : public ::testing::Test {
 protected:
  // Shows what the robot at `port` says until `done`; for 10 s at most.
  void ShowUntil(int port, const std::function<bool()>& done) {
    const Mirror mirror(io_, simulation_, directory_, {"s1r", "127.0.0.1", port});
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!done() && std::chrono::steady_clock::now() < until) {
      io_.run_one_for(std::chrono::milliseconds(100));
      simulation_.Sense();
      simulation_.Act();
    }
    EXPECT_TRUE(done());
  }
  const sim::LaserScanner& scanner() const {
    return *dynamic_cast<sim::LaserScanner*>(simulation_.FindComponent("s1r.hokuyo"));
  }
  const Pose2& pose() const { return simulation_.FindRobot("s1r")->pose(); }

  asio::io_context io_;
  sim::Simulation simulation_{scene::ParseScenario("{}", "test.json")};
  ServiceDirectory directory_{simulation_, {}};
};

TEST_F(MirrorTest, N06ShowsThePoseAndTheScanOfARealRobot) {
  const FakeRobot robot(true);
  ShowUntil(robot.port(), [this] { return pose().x == 1.0 && scanner().ranges()[681] == 5.0; });
  EXPECT_EQ(pose().y, 2.0);
  EXPECT_EQ(pose().yaw, 0.5);
  for (std::size_t i = 0; i < scanner().ranges().size(); ++i) {
    const Vec3 beam = scanner().fan().Direction(i);
    const double bearing = std::atan2(beam.y, beam.x);
    double expected = 5.0;  // beside the real scan, at a blind value and without a hit: no hit
    if (std::fabs(bearing + 1.0) < 0.249) expected = 0.5;
    if (std::fabs(bearing - 0.5) < 0.249) expected = 1.5;
    if (std::fabs(bearing - 1.0) < 0.249) expected = 2.0;
    const double to_edge = std::fabs(std::fmod(bearing + 10.25, 0.5));
    if (std::min(to_edge, 0.5 - to_edge) < 0.002) continue;  // between two real beams
    EXPECT_EQ(scanner().ranges()[i], expected) << "beam " << i << " at " << bearing;
  }
}

TEST_F(MirrorTest, N06TakesTheOdometryOfARobotThatIsNotLocalised) {
  const FakeRobot robot(false);
  ShowUntil(robot.port(), [this] { return pose().x == 1.0; });
}

TEST_F(MirrorTest, N06ConnectsAgainWhenTheRobotHangsUp) {
  const FakeRobot robot(true, 2);
  int shown = 0;
  directory_.set_input_tap([&](const Input& input) {
    if (input.service == "mirror_pose") ++shown;
  });
  ShowUntil(robot.port(), [&] { return shown >= 5; });  // three come before it hangs up
}

TEST_F(MirrorTest, N06EverythingShownIsAnInputOfTheRecord) {
  const FakeRobot robot(true);
  std::vector<Input> inputs;
  directory_.set_input_tap([&](const Input& input) { inputs.push_back(input); });
  ShowUntil(robot.port(), [&] { return inputs.size() >= 2; });
  EXPECT_EQ(inputs[0].component, "simulation");
  EXPECT_EQ(inputs[1].component, "s1r.hokuyo");
}

TEST(MirrorTarget, NamesRobotHostAndPort) {
  const MirrorTarget whole = MirrorTarget::Parse("s1r_2=player://syrotek:38000");
  EXPECT_EQ(whole.robot, "s1r_2");
  EXPECT_EQ(whole.host, "syrotek");
  EXPECT_EQ(whole.port, 38000);
  EXPECT_EQ(MirrorTarget::Parse("localhost").port, 6665);
  for (const char* wrong : {"", "=x", "player://", "host:", "host:0", "host:99999", "a/b"}) {
    EXPECT_THROW(MirrorTarget::Parse(wrong), Error) << wrong;
  }
}

}  // namespace
}  // namespace ccmorse::servers
