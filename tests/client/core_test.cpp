// The core layer: connection, client, robots, devices (thesis 3.1.1, 3.3).

#include <sstream>
#include <type_traits>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

TEST(K01, RequestsAndAnswersAreMatchedByNumber) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_EQ(client->Request("s1r.pen", "get_pixel", MorseArgs(3, 4)).ToString(), "[1, 2, 3]");
  EXPECT_EQ(client->Request("time", "mode").GetString(""), "Fixed Simulation Step");
  EXPECT_EQ(server.Count("s1r.pen get_pixel [3, 4]"), 1U);
}

TEST(K01, NumbersOfRequestsGrow) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  client->Read();
  client->Command("s1r.motion", "set_speed", MorseArgs(0.1, 0.0));
  client->Read();
  unsigned long last = 0;
  for (const std::string& id : server.Ids()) {
    EXPECT_GT(std::stoul(id), last);
    last = std::stoul(id);
  }
}

TEST(K01, AnswersWithoutValueAreNull) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  const MorseValue value = client->Request("s1r.waypoint", "stop");
  EXPECT_TRUE(value.IsNull());
  EXPECT_FALSE(value.IsTrue());
}

TEST(K01, NanAndInfinityAreNumbers) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("time now", "SUCCESS [NaN, Infinity, -Infinity]");
  const auto values = client->Request("time", "now").GetDoubles("");
  ASSERT_EQ(values.size(), 3U);
  EXPECT_TRUE(std::isnan(values[0]));
  EXPECT_TRUE(std::isinf(values[1]) && values[1] > 0);
  EXPECT_TRUE(std::isinf(values[2]) && values[2] < 0);
}

TEST(K01, RefusedAndLateRequestsAreErrors) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  const MorseError refused = ErrorOf([&] { client->Request("s1r.pose", "fly"); });
  EXPECT_TRUE(Has(refused.GetErrorStr(), "s1r.pose fly"));
  EXPECT_TRUE(Has(refused.GetErrorStr(), "The request fly has not been registered"));
  EXPECT_EQ(refused.GetErrorCode(), MorseError::kRefused);
  server.Answer("s1r.waypoint get_status", std::nullopt);
  const MorseError late =
      ErrorOf([&] { client->Request("s1r.waypoint", "get_status", MorseArgs(), 0.05); });
  EXPECT_TRUE(Has(late.GetErrorStr(), "no answer to s1r.waypoint get_status in time"));
  client->Read();  // the connection still works
}

TEST(K03, RefusedConnectionNamesHostPortAndFunction) {
  int port = 0;
  {
    FakeServer server;
    port = server.port();
  }
  const auto start = std::chrono::steady_clock::now();
  const MorseError error = ErrorOf([&] { MorseClient::Share("localhost", port); });
  EXPECT_LT(SecondsOf(start), 2.0);
  EXPECT_EQ(error.GetErrorStr(), "cannot connect to localhost:" + std::to_string(port) +
                                     ": Connection refused; is the simulator running? (ccmorse "
                                     "listens on port 4000 by default)");
  EXPECT_EQ(error.GetErrorFun(), "MorseClient::MorseClient()");
  EXPECT_EQ(error.GetErrorCode(), -1);
  EXPECT_FALSE(error.SimulationEnded());
}

TEST(K03, PortsOutOfRangeAreErrors) {
  for (const int port : {0, -1, 65536}) {
    EXPECT_TRUE(
        Has(ErrorOf([&] { MorseClient::Share(kHost, port); }).GetErrorStr(), std::to_string(port)));
  }
}

TEST(K03, ListenerThatNeverAnswersIsAnErrorWithinTwoSeconds) {
  FakeServer server;
  server.FallSilent();
  const auto start = std::chrono::steady_clock::now();
  const MorseError error = ErrorOf([&] { MorseClient::Share(kHost, server.port()); });
  EXPECT_LT(SecondsOf(start), 2.5);
  EXPECT_TRUE(Has(error.GetErrorStr(), std::to_string(server.port())));
}

TEST(K03, ErrorsPrintAndArriveAsStandardExceptions) {
  const MorseError error("it broke", "Class::Method()", 7);
  std::ostringstream out;
  out << error;
  EXPECT_EQ(out.str(), "Class::Method()(7) : it broke");
  EXPECT_STREQ(error.what(), "Class::Method(): it broke");
}

TEST(K04, ValuesOfTheCanvasAndOfPlayer) {
  ImagePoint_t point;
  EXPECT_EQ(point, ImagePoint_t(0, 0));
  point = ImagePoint_t(3, 4);
  EXPECT_EQ(point.x, 3);
  EXPECT_EQ(point.y, 4);
  const player_pose2d_t pose = {1.0, 2.0, 3.0};
  EXPECT_EQ(pose.pa, 3.0);
}

TEST(K05, OneClientForAnAddress) {
  FakeServer server;
  const auto a = MorseClient::Share(kHost, server.port());
  const auto b = MorseClient::Share(kHost, server.port());
  EXPECT_EQ(a.get(), b.get());
  EXPECT_EQ(&MorseClient::GetInstance(), a.get());
  EXPECT_EQ(&MorseClient::GetInstance(kHost, server.port()), a.get());
  EXPECT_EQ(server.Count("simulation list_robots"), 1U);
  a->Close();
}

TEST(K05, TheLastUserClosesTheConnection) {
  FakeServer server;
  auto a = std::make_unique<PlayerClient>(kHost, server.port());
  auto b = std::make_unique<PlayerClient>(kHost, server.port());
  a.reset();
  EXPECT_TRUE(b->Connected());
  b->Read();
  b.reset();
  EXPECT_TRUE(server.WaitForConnections(0));
  PlayerClient again(kHost, server.port());
  again.Read();
  EXPECT_TRUE(server.WaitForConnections(1));
}

TEST(K05, AClosedInstanceIsReplaced) {
  FakeServer server;
  MorseClient& first = MorseClient::GetInstance(kHost, server.port());
  first.Close();
  EXPECT_FALSE(first.Connected());
  MorseClient& second = MorseClient::GetInstance(kHost, server.port());
  EXPECT_NE(&first, &second);
  second.Read();
  EXPECT_EQ(first.GetRobots().size(), 1U);  // the old one stays readable
  second.Close();
}

TEST(K05, TwoServersAtOnce) {
  FakeServer one;
  FakeServer two;
  const auto a = MorseClient::Share(kHost, one.port());
  const auto b = MorseClient::Share(kHost, two.port());
  EXPECT_NE(a.get(), b.get());
  a->Read();
  EXPECT_EQ(two.Count("ccmorse read"), 0U);
}

TEST(K06, ConnectingAsksForRobotsDevicesAndSettingsOnce) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  client->Read();
  EXPECT_EQ(server.Count("simulation list_robots"), 1U);
  EXPECT_EQ(server.Count("simulation details"), 1U);
  EXPECT_EQ(server.Count("ccmorse hello [{\"client\""), 1U);
  EXPECT_EQ(server.Count("s1r.hokuyo get_configurations"), 1U);
  EXPECT_EQ(server.Count("s1r.properties get_local_data"), 1U);
  EXPECT_TRUE(client->IsCCMorse());
  EXPECT_EQ(client->GetServerName(), "ccmorse 0.1.0");
  EXPECT_EQ(client->GetPace(), "lockstep");
  EXPECT_DOUBLE_EQ(client->GetReadPeriod(), 0.1);
}

TEST(K06, PlainMorseIsRecognised) {
  FakeServer server(Plain());
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_FALSE(client->IsCCMorse());
  EXPECT_EQ(client->GetServerName(), "MORSE");
  client->Read();
  EXPECT_EQ(server.Count("ccmorse read"), 0U);
  EXPECT_EQ(server.Count("s1r.pose get_local_data"), 1U);
}

TEST(K06, StrangeDetailsAreNoCrash) {
  for (const char* details :
       {"SUCCESS", "SUCCESS []", "SUCCESS {\"robots\": 5}",
        "SUCCESS {\"robots\": [1, {\"name\": 2}]}",
        "SUCCESS {\"robots\": [{\"name\": \"s1r\", \"components\": [1]}]}",
        "SUCCESS {\"robots\": [{\"name\": \"s1r\", \"components\": {\"s1r.pose\": 3}}]}"}) {
    FakeServer server;
    server.Answer("simulation details", details);
    const auto client = MorseClient::Share(kHost, server.port());
    client->Read();
    EXPECT_EQ(client->GetRobots().size(), 1U) << details;
  }
  FakeServer server;
  server.Answer("simulation details", "SUCCESS {broken");
  EXPECT_TRUE(
      Has(ErrorOf([&] { MorseClient::Share(kHost, server.port()); }).GetErrorStr(), "JSON"));
}

TEST(K07, RobotsGetTheirDevices) {
  FakeServer::Options options;
  options.robots = {"s1r", "other"};
  FakeServer server(options);
  const auto client = MorseClient::Share(kHost, server.port());
  ASSERT_EQ(client->GetRobots().size(), 2U);
  for (const MorseRobot* robot : client->GetRobots()) {
    EXPECT_EQ(robot->GetType(), "Syrotek");
    EXPECT_EQ(robot->GetDevice<MorsePose>().GetName(), robot->GetName() + ".pose");
    EXPECT_EQ(robot->GetDevice<MorseOdometry>().GetShortName(), "odometry");
    EXPECT_NE(robot->FindDevice<MorseLaser>(), nullptr);
    EXPECT_NE(robot->FindDevice<MorseMotionVW>(), nullptr);
    EXPECT_NE(robot->FindDevice<MorseWaypoint>(), nullptr);
    EXPECT_NE(robot->FindDevice<MorseProperties>(), nullptr);
  }
  EXPECT_EQ(client->GetDevices().size(), 13U);
}

TEST(K08, IdentifiersAreFoundInNames) {
  FakeServer::Options options;
  options.extra = {{"hokuyo", "Custom"},           {"hokuyo_1", "Custom"},
                   {"frontLaser", "Custom"},       {"pose_2", ""},
                   {"scan", "LaserScanner"},       {"gripper_open", "Gripper"},
                   {"pose", "IntegratedOdometry"}, {"PEN", ""}};
  FakeServer server(options);
  const auto client = MorseClient::Share(kHost, server.port());
  const MorseRobot& robot = client->GetRobot("s1r");
  EXPECT_NE(robot.FindDevice<MorseHokuyo>("hokuyo"), nullptr);
  EXPECT_NE(robot.FindDevice<MorseHokuyo>("s1r.hokuyo_1"), nullptr);
  EXPECT_NE(robot.FindDevice<MorseHokuyo>("frontLaser"), nullptr);
  EXPECT_NE(robot.FindDevice<MorsePose>("pose_2"), nullptr);
  EXPECT_NE(robot.FindDevice<MorseHokuyo>("scan"), nullptr);    // by its type
  EXPECT_NE(robot.FindDevice<MorseOdometry>("pose"), nullptr);  // the type is certain
  EXPECT_NE(robot.FindDevice<MorsePen>("PEN"), nullptr);
  EXPECT_NE(robot.FindDevice<MorseDevice>("gripper_open"), nullptr);
  EXPECT_EQ(robot.FindDevice<MorsePen>("gripper_open"), nullptr);
}

TEST(K09, RobotsAreFoundByName) {
  FakeServer::Options options;
  options.robots = {"s1r", "other"};
  FakeServer server(options);
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_EQ(client->GetRobot("other").GetName(), "other");
  const MorseError error = ErrorOf([&] { client->GetRobot("third"); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "s1r, other"));
}

TEST(K10, RobotsListDevicesAndProxies) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  MorseRobot& robot = *client.GetMorseClient().GetRobots().front();
  EXPECT_EQ(robot.GetDevices().size(), 7U);
  EXPECT_TRUE(robot.GetProxies().empty());
  LaserProxy laser(&client, 0);
  {
    Position2dProxy position(&client, 0);
    EXPECT_EQ(robot.GetProxies(), (std::vector<MorseProxy*>{&laser, &position}));
  }
  EXPECT_EQ(robot.GetProxies(), std::vector<MorseProxy*>{&laser});
  EXPECT_TRUE(Has(ErrorOf([&] { robot.GetDevice<>("camera"); }).GetErrorStr(), "hokuyo"));
}

TEST(K11, RobotMethodsFromGoalToWeight) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  MorseRobot& robot = client->GetRobot("s1r");
  EXPECT_DOUBLE_EQ(robot.GetWeight(), 2.0);
  EXPECT_DOUBLE_EQ(robot.GetSize().sl, 0.174);
  EXPECT_DOUBLE_EQ(robot.GetSize().sw, 0.163);
  EXPECT_DOUBLE_EQ(robot.GetSize().sh, 0.18);
  EXPECT_DOUBLE_EQ(robot.GetWheelRadius(), 0.032);
  EXPECT_DOUBLE_EQ(robot.GetWheelTrack(), 0.125);
  EXPECT_DOUBLE_EQ(robot.GetMaxSpeed(), 0.35);
  EXPECT_DOUBLE_EQ(robot.GetMaxTurnRate(), 2.5);
  EXPECT_EQ(robot.GetColor(), (Color_t{52, 170, 255}));
  server.ClearLines();
  robot.SetGoal(1.5, 2.5, 0.1, 0.2);
  robot.SetSpeed(9.0, -9.0);  // gives the goal up, and is held within the limits
  client->Read();
  const Lines lines = server.Lines();
  ASSERT_GE(lines.size(), 4U);
  EXPECT_EQ(lines[0], "s1r.motion set_speed [0.0, 0.0]");
  EXPECT_EQ(lines[1], "s1r.waypoint setdest [1.5, 2.5, 0.0, 0.1, 0.2]");
  EXPECT_EQ(lines[2], "s1r.waypoint stop");
  EXPECT_EQ(lines[3], "s1r.motion set_speed [0.35, -2.5]");
  EXPECT_DOUBLE_EQ(robot.GetX(), 1.0);
  EXPECT_DOUBLE_EQ(robot.GetY(), 2.0);
  EXPECT_DOUBLE_EQ(robot.GetYaw(), 0.5);
  server.ClearLines();
  robot.Stop();
  EXPECT_TRUE(server.WaitForLine("s1r.motion set_speed [0.0, 0.0]"));
  EXPECT_THROW(robot.SetSpeed(std::nan(""), 0.0), MorseError);
  EXPECT_THROW(robot.SetGoal(INFINITY, 0.0), MorseError);
}

TEST(K11, WhatPlainMorseDoesNotTellIsAnError) {
  FakeServer server(Plain());
  const auto client = MorseClient::Share(kHost, server.port());
  const MorseError error = ErrorOf([&] { client->GetRobot("s1r").GetWeight(); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "mass"));
  EXPECT_EQ(error.GetErrorFun(), "MorseRobot::GetWeight()");
  EXPECT_THROW(client->GetRobot("s1r").GetProperties(), MorseError);
}

TEST(K12, DevicesShareTheirData) {
  FakeServer::Options options;
  options.extra = {{"battery", "Battery"}};
  FakeServer server(options);
  server.SetData("s1r.battery", "\"charge\": 87.5");
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_TRUE((std::is_base_of_v<MorseDevice, MorsePose>));
  MorseDevice& battery = client->GetRobot("s1r").GetDevice<>("battery");
  client->Read();
  EXPECT_FALSE(battery.HasData());  // a device of no known class is left alone
  battery.SetPolled(true);
  client->Read();
  EXPECT_DOUBLE_EQ(battery.GetData().GetDouble("charge"), 87.5);
  EXPECT_TRUE(battery.IsValid());
  EXPECT_GT(battery.GetTimestamp(), 0.0);
  EXPECT_THROW(client->GetRobot("s1r").GetDevice<MorseMotionVW>().SetPolled(true), MorseError);
}

// A class of devices in one place: what a user writes for a device of his own.
class Thermometer : public MorseSensor {
 public:
  explicit Thermometer(const MorseDeviceInfo& info) : MorseSensor(info) {}
  double GetTemperature() const {
    const std::lock_guard lock(DataMutex());
    return temperature_;
  }

 protected:
  bool OnData(const MorseValue& data) override {
    temperature_ = data.GetDouble("temperature");
    return data.Has("temperature");
  }

 private:
  double temperature_ = 0.0;
};
const bool kThermometer =
    RegisterMorseDevice({{"thermometer"}, {"Thermometer"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<Thermometer>(info);
                         }});

TEST(G08, ANewDeviceClassIsOneClassAndOneLine) {
  FakeServer::Options options;
  options.extra = {{"thermometer_2", "Thermometer"}};
  FakeServer server(options);
  server.SetData("s1r.thermometer_2", "\"temperature\": 21.5");
  const auto client = MorseClient::Share(kHost, server.port());
  client->Read();
  EXPECT_TRUE(kThermometer);
  EXPECT_DOUBLE_EQ(client->GetRobot("s1r").GetDevice<Thermometer>().GetTemperature(), 21.5);
}

TEST(K13, ConfigurationIsAtHandAtAnyTime) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  MorseRobot& robot = client->GetRobot("s1r");
  EXPECT_DOUBLE_EQ(robot.GetProperties().GetMass(), 2.0);
  client->Read();
  EXPECT_EQ(robot.GetProperties().GetRobotType(), "S1R");
  server.Disconnect();
  EXPECT_THROW(client->Read(), MorseError);
  EXPECT_DOUBLE_EQ(robot.GetProperties().GetMaxSpeed(), 0.35);
}

TEST(K14, TheServerNeverSpeaksFirst) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  client->Read();
  const std::size_t before = server.Lines().size();
  client->Read();
  // Every line of a round was asked by the client: one read and three sensors.
  EXPECT_EQ(server.Lines().size(), before + 4);
}

TEST(K15, ReadSendsOneQueryPerDevice) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.ClearLines();
  client->Read();
  EXPECT_EQ(server.Lines(), (Lines{"ccmorse read", "s1r.pose get_local_data",
                                   "s1r.odometry get_local_data", "s1r.hokuyo get_local_data"}));
}

TEST(K15, CommandsGoBeforeTheReadInOrder) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.ClearLines();
  client->Command("s1r.motion", "set_speed", MorseArgs(0.1, 0.0));
  client->Command("s1r.pen", "set_pixel", MorseArgs(1, 2, 3, 4, 5));
  client->Command("s1r.motion", "set_speed", MorseArgs(0.2, 0.0));
  client->Read();
  const Lines lines = server.Lines();
  ASSERT_GE(lines.size(), 4U);
  EXPECT_EQ(lines[0], "s1r.motion set_speed [0.1, 0.0]");
  EXPECT_EQ(lines[1], "s1r.pen set_pixel [1, 2, 3, 4, 5]");
  EXPECT_EQ(lines[2], "s1r.motion set_speed [0.2, 0.0]");
  EXPECT_EQ(lines[3], "ccmorse read");
}

TEST(K15, RequestsAreSentAfterTheCommandsThatWait) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.ClearLines();
  client->Command("s1r.pen", "set_pixel", MorseArgs(1, 2, 3, 4, 5));
  client->Request("s1r.pen", "get_pixel", MorseArgs(1, 2));
  EXPECT_EQ(server.Lines(),
            (Lines{"s1r.pen set_pixel [1, 2, 3, 4, 5]", "s1r.pen get_pixel [1, 2]"}));
}

TEST(K15, MoreThanAMebibyteOfCommandsIsSentAtOnce) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  const std::string text(1000, 'x');
  for (int i = 0; i < 1200; ++i) client->Command("s1r.pen", "save_image_copy", MorseArgs(text));
  EXPECT_TRUE(server.WaitForLine("s1r.pen save_image_copy"));
  client->Read();
  EXPECT_EQ(server.Count("s1r.pen save_image_copy"), 1200U);
}

TEST(K15, ARefusedCommandIsAnErrorAfterTheDataWereTaken) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("s1r.motion set_speed", "FAILED \"no wheels\"");
  client->Command("s1r.motion", "set_speed", MorseArgs(0.1, 0.0));
  const MorseError error = ErrorOf([&] { client->Read(); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "s1r.motion set_speed"));
  EXPECT_TRUE(Has(error.GetErrorStr(), "no wheels"));
  EXPECT_EQ(error.GetErrorFun(), "MorseClient::Read()");
  EXPECT_TRUE(client->GetRobot("s1r").GetDevice<MorsePose>().IsValid());
  client->Read();  // told once
}

TEST(K16, ReadTellsTheTimeOfTheData) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_DOUBLE_EQ(client->GetTime(), 0.0);
  client->Read();
  client->Read();
  EXPECT_DOUBLE_EQ(client->GetTime(), 0.2);
}

TEST(K18, MorseClientHasAllOfPlayersConnection) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_TRUE(client->Connected());
  EXPECT_EQ(client->GetHostname(), kHost);
  EXPECT_EQ(client->GetPort(), static_cast<std::uint32_t>(server.port()));
  client->SetRequestTimeout(3.0);
  EXPECT_DOUBLE_EQ(client->GetRequestTimeout(), 3.0);
  EXPECT_THROW(client->SetRequestTimeout(0.0), MorseError);
  client->SetRetryLimit(2);
  EXPECT_EQ(client->GetRetryLimit(), 2);
  client->SetRetryTime(1.5);
  EXPECT_DOUBLE_EQ(client->GetRetryTime(), 1.5);
  client->SetDataMode(2);
  client->SetReplaceRule(true);
  client->RequestDeviceList();
  const auto devices = client->GetDeviceList();
  ASSERT_EQ(devices.size(), 4U);
  EXPECT_EQ(devices.front().addr.interf, 4U);
  EXPECT_STREQ(devices.front().drivername, "s1r.pose");
  EXPECT_EQ(client->LookupCode("laser"), 6);
  EXPECT_EQ(client->LookupName(4), "position2d");
  EXPECT_EQ(client->LookupCode("teapot"), 0xFFFF);
  EXPECT_EQ(client->GetOverflowCount(), 0U);
}

TEST(H11, TheClientSendsWhatWaitsBeforeItCloses) {
  FakeServer server;
  {
    const auto client = MorseClient::Share(kHost, server.port());
    client->Command("s1r.motion", "set_speed", MorseArgs(0.0, 0.0));
  }
  EXPECT_TRUE(server.WaitForLine("s1r.motion set_speed [0.0, 0.0]"));
}

}  // namespace
}  // namespace ccmorse::test
