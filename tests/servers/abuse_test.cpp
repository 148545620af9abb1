// Bad input: the simulation goes on, in time, with bounded memory, and other clients are served.

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "base/log.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

long ResidentKilobytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    if (word == "VmRSS:") {
      long kilobytes = 0;
      status >> kilobytes;
      return kilobytes;
    }
  }
  return 0;
}

class AbuseTest : public ::testing::Test {
 protected:
  AbuseTest() { SetLogLevel(LogLevel::kError); }
  ~AbuseTest() override { SetLogLevel(LogLevel::kInfo); }

  int StreamPort(const std::string& component) {
    LineClient client(served_.port());
    const std::string reply = client.Ask("1 simulation get_stream_port [\"" + component + "\"]");
    return std::stoi(reply.substr(reply.rfind(' ') + 1));
  }
  // Time advances and a well-behaved client is answered.
  void ExpectAlive() {
    LineClient good(served_.port());
    EXPECT_EQ(good.Ask("1 time sleep [0.05]"), "1 SUCCESS");
    EXPECT_EQ(good.Ask("1 time mode"), "1 SUCCESS \"Best Effort\"");
  }
  ServedSimulation served_{"{}"};
};

TEST_F(AbuseTest, RandomBytesOnEveryPort) {
  std::mt19937_64 random(1);
  std::vector<int> ports = {served_.port(), StreamPort("s1r.motion"), StreamPort("s1r.pose"),
                            StreamPort("s1r.waypoint")};
  for (int round = 0; round < 50; ++round) {
    for (const int port : ports) {
      LineClient client(port);
      std::string bytes(static_cast<std::size_t>(random() % 5000), '\0');
      for (char& byte : bytes) byte = static_cast<char>(random() % 7 == 0 ? '\n' : random() % 256);
      client.Send(bytes);
      if (round % 2 == 0) client.Reset();
    }
  }
  ExpectAlive();
}

TEST_F(AbuseTest, ALineOfTenMegabytesIsRefusedAndTheConnectionLives) {
  LineClient client(served_.port());
  client.Send(std::string(10U << 20, 'x'));
  client.Send("\n");
  EXPECT_NE(client.ReadLine().value().find("Malformed request!"), std::string::npos);
  EXPECT_EQ(client.Ask("1 time mode"), "1 SUCCESS \"Best Effort\"");
  LineClient stream(StreamPort("s1r.motion"));
  stream.Send(std::string(10U << 20, 'x') + "\n{\"v\": 0.1, \"w\": 0}\n");
  ExpectAlive();
}

TEST_F(AbuseTest, HalfLinesAndSuddenEnds) {
  for (int i = 0; i < 100; ++i) {
    LineClient client(served_.port());
    client.Send("1 simulation deta");
    if (i % 2 == 0) client.Reset();
  }
  ExpectAlive();
}

TEST_F(AbuseTest, TwoThousandConnectionsAtOnce) {
  for (const int port : {served_.port(), StreamPort("s1r.pose")}) {
    std::vector<std::unique_ptr<LineClient>> crowd;
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
      try {
        crowd.push_back(std::make_unique<LineClient>(port));
      } catch (const std::runtime_error&) {
        ++refused;  // the test's own file handles may run out first
      }
      if (crowd.size() > 300) crowd.erase(crowd.begin());
    }
    EXPECT_LT(refused, 2000);
  }
  ExpectAlive();
}

TEST_F(AbuseTest, BeyondTheLimitAConnectionIsClosedAndTheOthersStay) {
  MorseServerOptions limits;
  limits.most_clients = 3;
  ServedSimulation small("{}", Pace::kRealTime, 0.0, limits);
  std::vector<std::unique_ptr<LineClient>> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(std::make_unique<LineClient>(small.port()));
    EXPECT_EQ(clients.back()->Ask("1 time mode"), "1 SUCCESS \"Best Effort\"");
  }
  LineClient fourth(small.port());
  EXPECT_TRUE(fourth.IsClosed());
  EXPECT_EQ(clients[0]->Ask("1 time mode"), "1 SUCCESS \"Best Effort\"");
}

TEST_F(AbuseTest, AClientThatNeverReadsItsRepliesCostsBoundedMemory) {
  LineClient greedy(served_.port());
  greedy.Ask("1 s1r.pen resize_canvas [300, 300]");
  const long before = ResidentKilobytes();
  std::string requests;
  for (int i = 0; i < 2000; ++i) requests += "1 s1r.pen get_image_data\n";  // 1.4 MB each: 2.8 GB
  greedy.Send(requests);
  ExpectAlive();
  ExpectAlive();
  EXPECT_LT(ResidentKilobytes() - before, 200L * 1024);
}

TEST_F(AbuseTest, AFloodOfRequestsDoesNotStopTime) {
  LineClient flood(served_.port());
  std::string requests;
  for (int i = 0; i < 20000; ++i) requests += "1 nobody nothing\n";
  flood.Send(requests);
  ExpectAlive();
}

TEST_F(AbuseTest, PeeksAndReadsWithoutEndOnOneConnection) {
  LineClient client(served_.port());
  std::string requests;
  for (int i = 0; i < 5000; ++i) requests += "1 ccmorse peek\n2 ccmorse ping\n";
  client.Send(requests + "3 ccmorse peek [\"x\"]\n4 ccmorse peek {\n");
  for (int i = 0; i < 10000; ++i) ASSERT_TRUE(client.ReadLine());
  EXPECT_NE(client.ReadLine().value().find("FAILED"), std::string::npos);
  EXPECT_NE(client.ReadLine().value().find("FAILED"), std::string::npos);
  ExpectAlive();
}

TEST_F(AbuseTest, APortInUseIsNamed) {
  MorseServerOptions options;
  options.port = served_.port();
  options.first_stream_port = 0;
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  try {
    const Runner second(simulation, {Pace::kMax, 1.0, 1.0, 1, options});
    ADD_FAILURE() << "two simulations on one port";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(served_.port())), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("--port"), std::string::npos);
  }
}

}  // namespace
}  // namespace ccmorse::servers
