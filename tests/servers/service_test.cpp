// The service port as MORSE's clients know it, over real sockets (MORSE 1.4's rules and error
// texts).

#include <gtest/gtest.h>

#include <cmath>

#include "base/json.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;

class ServiceTest : public ::testing::Test {
 protected:
  std::string Ask(const std::string& line) { return client_.Ask(line); }
  Json Value(const std::string& request) {
    const std::string reply = Ask("1 " + request);
    const std::string head = "1 SUCCESS ";
    EXPECT_EQ(reply.substr(0, head.size()), head) << reply;
    return Json::Parse(reply.substr(head.size()));
  }
  ServedSimulation served_{R"({"robots": [{"name": "s1r", "pose": {"x": 1.2, "y": 2.0}},
                                         {"name": "two", "pose": {"x": 2.2, "y": 2.6}}]})"};
  LineClient client_{served_.port()};
};

struct ErrorCase {
  const char* request;
  const char* reply;
};

TEST_F(ServiceTest, EveryErrorAnswerOfTheProtocolsTable) {
  const std::string manager = "Socket service manager: ";
  const ErrorCase cases[] = {
      {"x", R"~(x FAILED "Malformed request! ")~"},
      {"", R"~( FAILED "Malformed request! ")~"},
      {"1 simulation", R"~(1 FAILED "Malformed request! ")~"},
      {"1 nobody hello",
       R"~(1 FAILED "The request hello has not been registered in Socket service manager")~"},
      {"1 s1r.motion jump [1]",
       R"~(1 FAILED "The request jump has not been registered in Socket service manager")~"},
      {"1 s1r.motion set_speed [1,",
       R"~(1 FAILED "Invalid request syntax: error while parsing the parameters: [1,. Expecting value: line 1 column 4 (char 3)")~"},
      {"1 s1r.motion set_speed 5",
       R"~(1 FAILED "Invalid request syntax: error while parsing the parameters: 5. Expecting a list, not a number")~"},
      {"1 s1r.motion set_speed",
       R"~(1 FAILED "Socket service manager: parameters expected for service set_speed! set_speed() missing 2 required positional arguments: 'v' and 'w'")~"},
      {"1 s1r.motion set_speed []",
       R"~(1 FAILED "Socket service manager: parameters expected for service set_speed! set_speed() missing 2 required positional arguments: 'v' and 'w'")~"},
      {"1 s1r.motion set_speed [1]",
       R"~(1 FAILED "Socket service manager: wrong # of parameters for service set_speed. set_speed() missing 1 required positional argument: 'w'")~"},
      {"1 s1r.motion set_speed [1, 2, 3]",
       R"~(1 FAILED "Socket service manager: wrong # of parameters for service set_speed. set_speed() takes 3 positional arguments but 4 were given")~"},
      {"1 s1r.motion stop [1]",
       R"~(1 FAILED "Socket service manager: wrong # of parameters for service stop. stop() takes 1 positional argument but 2 were given")~"},
      {"1 s1r.waypoint setdest [1, 2, 3, 4, 5, 6]",
       R"~(1 FAILED "Socket service manager: wrong # of parameters for service setdest. setdest() takes from 4 to 6 positional arguments but 7 were given")~"},
      {"1 s1r.motion set_speed [\"a\", 1]",
       R"~(1 FAILED "Socket service manager: wrong parameter type for service set_speed. v must be a number, not a string")~"},
      {"1 s1r.waypoint goto [\"a\", 1, 2]",
       R"~(1 FAILED "Socket service manager: wrong # of parameters for service goto. x must be a number, not a string")~"},
      {"1 s1r.motion set_speed [NaN, 1]",
       R"~(1 FAILED "Socket service manager: wrong parameter type for service set_speed. v must be finite, not NaN")~"},
      {"1 simulation get_stream_port [\"nobody\"]",
       R"~(1 FAILED "Stream unavailable for component nobody")~"},
      {"1 simulation activate [\"nobody\"]",
       R"~(1 FAILED "Component 'nobody' not found. Can't activate")~"},
      {"1 simulation deactivate [\"nobody\"]",
       R"~(1 FAILED "Component 'nobody' not found. Can't deactivate")~"},
      {"1 simulation set_object_position [\"nobody\", [0, 0, 0]]",
       R"~(1 FAILED "Object 'nobody' does not appear in the scene.")~"},
      {"1 s1r.hokuyo set_property [\"colour\", 1]",
       R"~(1 FAILED "Property colour does not exist for object s1r.hokuyo")~"},
      {"1 simulation set_log_level [\"s1r\", \"info\"]", R"~(1 FAILED "Unknown level: 'info'")~"},
      {"1 communication distance_and_view [\"s1r\", \"nobody\"]",
       R"~(1 FAILED "nobody does not exist in the simulation ")~"}};
  for (const ErrorCase& c : cases) EXPECT_EQ(Ask(c.request), c.reply) << c.request;
}

TEST_F(ServiceTest, ASecondSleepIsRefusedAndTheFirstGoesOn) {
  client_.Send("a time sleep [0.2]\nb time sleep [0.1]\nc time sleep [-1]\n");
  const std::string busy =
      R"(FAILED "A service (sleep) is already running. I do not know what to do.")";
  EXPECT_EQ(client_.ReadLine(), "b " + busy);
  EXPECT_EQ(client_.ReadLine(), "c " + busy);
  EXPECT_EQ(client_.ReadLine(), "a SUCCESS");
}

TEST_F(ServiceTest, FalsyResultsAreNotSent) {
  EXPECT_EQ(Ask("1 s1r.motion stop"), "1 SUCCESS");
  EXPECT_EQ(Ask("1 s1r.motion set_speed [0, 0]"), "1 SUCCESS");
}

TEST_F(ServiceTest, ManyRequestsInOnePacketAreAnsweredInOrder) {
  std::string packet;
  for (int i = 0; i < 1000; ++i) packet += std::to_string(i) + " time mode\n";
  client_.Send(packet);
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(client_.ReadLine(), std::to_string(i) + " SUCCESS \"Best Effort\"");
  }
}

TEST_F(ServiceTest, ARequestInPiecesIsWaitedFor) {
  client_.Send("1 time ");
  client_.Send("mo");
  client_.Send("de\n");
  EXPECT_EQ(client_.ReadLine(), "1 SUCCESS \"Best Effort\"");
}

TEST_F(ServiceTest, CancelPreemptsWhateverRunsUnderTheIdFromAnyClient) {
  LineClient other(served_.port());
  client_.Send("7 s1r.waypoint goto [2, 2, 0]\n8 time mode\n");
  EXPECT_EQ(client_.ReadLine(), "8 SUCCESS \"Best Effort\"");
  other.Send("7 cancel\n");
  EXPECT_EQ(client_.ReadLine(), "7 PREEMPTED");
  EXPECT_EQ(other.Ask("no-such-id cancel\n9 time mode"), "9 SUCCESS \"Best Effort\"");
}

TEST_F(ServiceTest, ANewGotoPreemptsTheOneThatRuns) {
  client_.Send("1 s1r.waypoint goto [2, 2, 0]\n2 s1r.waypoint goto [1.2, 2.0, 0]\n");
  EXPECT_EQ(client_.ReadLine(), "1 PREEMPTED");
  EXPECT_EQ(client_.ReadLine(), "2 SUCCESS \"Arrived\"");
}

TEST_F(ServiceTest, EventsOfTheArenaAreNumbered) {
  EXPECT_EQ(Ask("1 arena events"), "1 SUCCESS");
  Ask("2 arena raise [69]");
  Ask("3 arena lower [[69, 70]]");
  const Json all = Value("arena events");
  ASSERT_EQ(all.AsArray().size(), 2U);
  EXPECT_EQ(all.AsArray()[0].Find("number")->AsInt(), 1);
  EXPECT_EQ(all.AsArray()[0].Find("what")->AsString(), "up 69");
  const Json later = Value("arena events [1]");
  ASSERT_EQ(later.AsArray().size(), 1U);
  EXPECT_EQ(later.AsArray()[0], all.AsArray()[1]);
  EXPECT_EQ(later.AsArray()[0].Find("cause")->AsString(), "service");
  EXPECT_EQ(Ask("4 arena events [2]"), "4 SUCCESS");
  // Only the last 200 are kept; the numbers go on.
  for (int i = 0; i < 210; ++i) Ask("5 arena toggle [70]");
  const Json last = Value("arena events");
  ASSERT_EQ(last.AsArray().size(), 200U);
  EXPECT_EQ(last.AsArray().front().Find("number")->AsInt(), 13);
  EXPECT_EQ(last.AsArray().back().Find("number")->AsInt(), 212);
}

TEST_F(ServiceTest, SimulationListsRobotsStreamsAndPorts) {
  EXPECT_EQ(Value("simulation list_robots"), Json::Parse(R"(["s1r", "two"])"));
  const Json streams = Value("simulation list_streams");
  EXPECT_EQ(streams.AsArray().size(), 12U);
  EXPECT_EQ(streams.AsArray()[0], Json("s1r.hokuyo"));
  const Json ports = Value("simulation get_all_stream_ports");
  EXPECT_EQ(*ports.Find("two.pose"), Value("simulation get_stream_port [\"two.pose\"]"));
}

TEST_F(ServiceTest, DetailsHoldWhatPymorseNeeds) {
  const Json details = Value("simulation details");
  const Json& robot = details.Find("robots")->AsArray()[0];
  EXPECT_EQ(*robot.Find("name"), Json("s1r"));
  const Json* motion = robot.Find("components")->Find("s1r.motion");
  EXPECT_EQ(motion->Find("stream_interfaces")->AsArray()[0].AsArray()[1], Json("IN"));
  const Json* pose = robot.Find("components")->Find("s1r.pose");
  EXPECT_EQ(pose->Find("stream_interfaces")->AsArray()[0].AsArray()[1], Json("OUT"));
  EXPECT_EQ(*pose->Find("type"), Json("Pose"));
  EXPECT_NE(motion->Find("services"), nullptr);
}

TEST_F(ServiceTest, TimeGoesOn) {
  EXPECT_EQ(Ask("1 time sleep [0.1]"), "1 SUCCESS");
  const double first = Value("time now").AsDouble();
  EXPECT_EQ(Ask("1 time sleep [0.1]"), "1 SUCCESS");
  EXPECT_GE(Value("time now").AsDouble(), first + 0.09);
  EXPECT_NE(Value("time statistics").Find("mean_frame_by_sec"), nullptr);
}

TEST_F(ServiceTest, ObjectsCanBePlacedWhereTheyFit) {
  EXPECT_EQ(Ask("1 simulation set_object_position [\"s1r\", [1.6, 2.5, 0], [0, 0, 1.5]]"),
            "1 SUCCESS");
  // Data are a tick old at most, so look when a tick has gone by.
  Ask("1 time sleep [0.05]");
  EXPECT_NEAR(Value("s1r.pose get_local_data").Find("x")->AsDouble(), 1.6, 1e-12);
  EXPECT_EQ(Ask("1 simulation set_object_position [\"s1r\", [0.34, 1.44, 0]]"),
            R"(1 FAILED "Object 's1r' does not fit there: it would overlap an obstacle")");
  EXPECT_EQ(Ask("1 simulation reset_objects"),
            R"(1 SUCCESS "Objects restored to initial position")");
}

TEST_F(ServiceTest, SuspendedDynamicsKeepRobotsWhereTheyAre) {
  EXPECT_EQ(Ask("1 simulation suspend_dynamics"), "1 SUCCESS \"Physics is suspended\"");
  Ask("1 s1r.motion set_speed [0.3, 0]");
  Ask("1 time sleep [0.1]");
  EXPECT_EQ(Value("s1r.pose get_local_data").Find("x")->AsDouble(), 1.2);
  EXPECT_EQ(Ask("1 simulation restore_dynamics"), "1 SUCCESS \"Physics is resumed\"");
}

TEST_F(ServiceTest, TwoRobotsThatSeeEachOther) {
  const Json answer = Value("communication distance_and_view [\"s1r\", \"two\"]");
  EXPECT_NEAR(answer.AsArray()[0].AsDouble(), std::hypot(1.0, 0.6), 1e-9);
  EXPECT_EQ(answer.AsArray()[1], Json(true));
}

TEST_F(ServiceTest, QuitEndsTheRunAndIsAnswered) {
  EXPECT_EQ(Ask("1 simulation quit"), "1 SUCCESS");
  served_.Join();
  SUCCEED();
}

TEST_F(ServiceTest, ConfigurationsSayWhereADeviceSits) {
  const Json configurations = *Value("s1r.hokuyo get_configurations").Find("configurations");
  EXPECT_EQ(*configurations.Find("scan_window"), Json(270.0));
  EXPECT_EQ(configurations.Find("object_to_robot")->Find("translation")->AsArray()[0], Json(0.035));
  EXPECT_NE(Value("s1r.hokuyo get_properties").Find("properties"), nullptr);
}

TEST(Configurations, SayHowATiltedLaserIsMounted) {
  ServedSimulation served(R"({"robots": [{"laser": {"roll": 0.1, "pitch": 0.2, "yaw": 0.3}}]})");
  LineClient client(served.port());
  const std::string reply = client.Ask("1 s1r.hokuyo get_configurations");
  const Json answer = Json::Parse(reply.substr(reply.find('{')));
  const Json::Array& rows =
      answer.Find("configurations")->Find("object_to_robot")->Find("rotation")->AsArray();
  const auto at = [&rows](std::size_t row, std::size_t column) {
    return rows[row].AsArray()[column].AsDouble();
  };
  // As libCCMorse reads them.
  EXPECT_NEAR(std::atan2(at(2, 1), at(2, 2)), 0.1, 1e-12);
  EXPECT_NEAR(std::asin(-at(2, 0)), 0.2, 1e-12);
  EXPECT_NEAR(std::atan2(at(1, 0), at(0, 0)), 0.3, 1e-12);
}

TEST(RangeSensors, AnswerOverTheServicePort) {
  ServedSimulation served(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}, "front": "sensors",
                                          "ir": true, "sonar": true}]})");
  LineClient client(served.port());
  client.Ask("1 time sleep [0.2]");
  const auto value = [&client](const std::string& request) {
    const std::string reply = client.Ask("1 " + request);
    return Json::Parse(reply.substr(reply.find('{')));
  };
  EXPECT_EQ(value("s1r.ir get_local_data").Find("range_list")->AsArray().size(), 8U);
  const Json sonar = value("s1r.sonar get_local_data");
  ASSERT_EQ(sonar.Find("range_list")->AsArray().size(), 6U);
  for (const Json& range : sonar.Find("range_list")->AsArray()) {
    EXPECT_GT(range.AsDouble(), 0.05);
    EXPECT_LT(range.AsDouble(), 4.0);  // the arena's walls are nearer
  }
  const Json configuration = value("s1r.sonar get_configurations");
  EXPECT_NE(configuration.Dump().find("\"poses\": [["), std::string::npos) << configuration.Dump();
}

}  // namespace
}  // namespace ccmorse::servers
