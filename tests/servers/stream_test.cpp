// The stream ports: sensors talk, actuators listen (MORSE 1.4's rules).

#include <gtest/gtest.h>

#include <memory>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

class StreamTest : public ::testing::Test {
 protected:
  int Port(const std::string& component) {
    const std::string reply = client_.Ask("1 simulation get_stream_port [\"" + component + "\"]");
    return std::stoi(reply.substr(reply.rfind(' ') + 1));
  }
  // The pose some ticks from now.
  Json Pose() {
    client_.Ask("1 time sleep [0.1]");
    const std::string reply = client_.Ask("1 s1r.pose get_local_data");
    return Json::Parse(reply.substr(reply.find('{')));
  }
  ServedSimulation served_{R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})"};
  LineClient client_{served_.port()};
};

TEST_F(StreamTest, ASensorSendsALineEachActivation) {
  LineClient stream(Port("s1r.hokuyo"));
  double last = -1.0;
  for (int i = 0; i < 3; ++i) {
    const Json line = Json::Parse(stream.ReadLine().value());
    EXPECT_EQ(line.AsObject()[0].first, "timestamp");
    const double time = line.Find("timestamp")->AsDouble();
    if (i > 0) {
      EXPECT_NEAR(time - last, 0.1, 1e-9);
    }
    last = time;
  }
}

TEST_F(StreamTest, AnActuatorTakesLinesAndKeepsTheCommand) {
  LineClient stream(Port("s1r.motion"));
  stream.Send("{\"v\": 0.2, \"w\": 0.0, \"extra\": 1}\n");
  EXPECT_GT(Pose().Find("x")->AsDouble(), 1.2);
}

TEST_F(StreamTest, OfSeveralLinesTheLastCounts) {
  LineClient stream(Port("s1r.motion"));
  stream.Send("{\"v\": 0.5, \"w\": 0}\n{\"v\": 0.4, \"w\": 0}\n{\"v\": 0.0, \"w\": 0.5}\n");
  const Json pose = Pose();
  EXPECT_EQ(pose.Find("x")->AsDouble(), 1.2);
  EXPECT_GT(pose.Find("yaw")->AsDouble(), 0.0);
}

TEST_F(StreamTest, WhatKillsMorseIsIgnoredHere) {
  LineClient stream(Port("s1r.motion"));
  for (const char* line : {"nonsense", "5", "[]", "{\"v\": 1}", "{\"v\": \"a\", \"w\": 0}",
                           "{\"v\": NaN, \"w\": 0}", "{\"v\":", "\xff\xfe", ""}) {
    stream.Send(std::string(line) + "\n");
    Pose();
  }
  EXPECT_EQ(Pose().Find("x")->AsDouble(), 1.2);
  stream.Send("{\"v\": 0.2, ");
  Pose();
  stream.Send("\"w\": 0}\n");  // a line in two segments is one line
  EXPECT_GT(Pose().Find("x")->AsDouble(), 1.2);
}

TEST_F(StreamTest, BytesWrittenToASensorAreIgnored) {
  LineClient stream(Port("s1r.pose"));
  stream.Send("hello?\n");
  EXPECT_TRUE(stream.ReadLine());
}

TEST_F(StreamTest, ADeactivatedSensorIsSilentAndComesBack) {
  LineClient stream(Port("s1r.pose"));
  ASSERT_TRUE(stream.ReadLine());
  client_.Ask("1 simulation deactivate [\"s1r.pose\"]");
  while (stream.ReadLine(std::chrono::milliseconds(200))) {
  }
  client_.Ask("1 simulation activate [\"s1r.pose\"]");
  EXPECT_TRUE(stream.ReadLine());
}

TEST_F(StreamTest, AReaderThatNeverReadsHoldsNobodyUp) {
  LineClient lazy(Port("s1r.hokuyo"));
  LineClient stream(Port("s1r.pose"));
  for (int i = 0; i < 120; ++i) ASSERT_TRUE(stream.ReadLine()) << i;
}

}  // namespace
}  // namespace ccmorse::servers
