// The third layer: Player's proxies (thesis 3.1.3), with the calls of the thesis's listing C.2.

#include <sstream>
#include <thread>
#include <type_traits>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

constexpr double kPi = 3.14159265358979323846;

class Program : public ::testing::Test {
 protected:
  FakeServer server;
  PlayerClient client{kHost, server.port()};
};
using L302 = Program;
using L303 = Program;
using L304 = Program;
using L305 = Program;
using L306 = Program;
using L308 = Program;
using L309 = Program;
using L310 = Program;
using L311 = Program;
using L312 = Program;
using X11 = Program;
using X12 = Program;
using X13 = Program;
using X14 = Program;
using X15 = Program;
using X17 = Program;
using X19 = Program;
using X24 = Program;
using X25 = Program;
using X26 = Program;
using X27 = Program;
using X28 = Program;
using X29 = Program;
using X31 = Program;
using X32 = Program;
using X33 = Program;
using X34 = Program;
using X35 = Program;
using X36 = Program;
using X37 = Program;

TEST(L301, ProxiesInheritTheAbstractBase) {
  EXPECT_TRUE(std::is_abstract_v<MorseProxy>);
  EXPECT_TRUE((std::is_base_of_v<MorseProxy, Position2dProxy>));
  EXPECT_TRUE((std::is_base_of_v<MorseProxy, LaserProxy>));
  EXPECT_TRUE((std::is_base_of_v<MorseProxy, WindowProxy>));
}

TEST_F(L302, TheIndexDecidesBetweenPoseAndOdometry) {
  Position2dProxy truth(&client, 0);
  Position2dProxy also(&client, 2);
  Position2dProxy odometry(&client, 3);
  client.Read();
  EXPECT_DOUBLE_EQ(truth.GetXPos(), 1.0);
  EXPECT_DOUBLE_EQ(also.GetYPos(), 2.0);
  EXPECT_DOUBLE_EQ(odometry.GetXPos(), 0.25);
  EXPECT_DOUBLE_EQ(odometry.GetYaw(), 0.125);
  EXPECT_EQ(truth.GetDriverName(), "s1r.pose");
  EXPECT_EQ(odometry.GetDriverName(), "s1r.odometry");
}

TEST_F(L302, WithoutATableTheIndexCountsRobots) {
  FakeServer::Options options = Plain();
  options.robots = {"s1r", "other"};
  FakeServer simulator(options);
  PlayerClient program(kHost, simulator.port());
  EXPECT_EQ(Position2dProxy(&program, 0).GetDriverName(), "s1r.pose");
  EXPECT_EQ(Position2dProxy(&program, 1).GetDriverName(), "other.pose");
  EXPECT_EQ(LaserProxy(&program, 1).GetDriverName(), "other.hokuyo");
  EXPECT_TRUE(Has(ErrorOf([&] { LaserProxy(&program, 2); }).GetErrorStr(), "laser:1 of other"));
}

TEST_F(L303, LaserHasAllOfPlayersMethods) {
  LaserProxy laser(&client);
  EXPECT_EQ(laser.GetCount(), 0U);
  client.Read();
  EXPECT_EQ(laser.GetCount(), 682U);
  EXPECT_DOUBLE_EQ(laser.GetRange(100), 0.5);
  EXPECT_DOUBLE_EQ(laser.GetMinRight(), 0.5);
  EXPECT_DOUBLE_EQ(laser.MinRight(), 0.5);
  EXPECT_DOUBLE_EQ(laser.GetMinLeft(), 5.0);
  EXPECT_DOUBLE_EQ(laser.MinLeft(), 5.0);
  EXPECT_NEAR(laser.GetPoint(100).px, 0.5 * std::cos(laser.GetBearing(100)), 1e-12);
  EXPECT_NEAR(laser.GetPoint(100).py, 0.5 * std::sin(laser.GetBearing(100)), 1e-12);
  EXPECT_DOUBLE_EQ(laser.GetConfMinAngle(), laser.GetMinAngle());
  EXPECT_DOUBLE_EQ(laser.GetConfMaxAngle(), laser.GetMaxAngle());
  EXPECT_DOUBLE_EQ(laser.GetScanningFrequency(), 10.0);
  EXPECT_DOUBLE_EQ(laser.GetRangeRes(), 0.0);
  EXPECT_FALSE(laser.IntensityOn());
  EXPECT_EQ(laser.GetIntensity(3), 0);
  laser.RequestConfigure();
  laser.RequestGeom();
  EXPECT_DOUBLE_EQ(laser.GetPose().px, 0.035);
  EXPECT_DOUBLE_EQ(laser.GetRobotPose().px, 1.0);
  EXPECT_DOUBLE_EQ(laser.GetSize().sl, 0.15);
  EXPECT_EQ(laser.GetID(), -1);
  EXPECT_THROW(laser.RequestID(), MorseError);
  const MorseError error = ErrorOf([&] { laser.Configure(-1, 1, 1, 1, false, 10); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "not supported by this device"));
  std::ostringstream out;
  out << laser;
  EXPECT_TRUE(Has(out.str(), "#Laser (6:0)"));
}

TEST_F(L304, WindowDrawsWithThePen) {
  WindowProxy& window = WindowProxy::GetInstance(&client, 10, 10);
  using Level = unsigned char;
  server.ClearLines();
  window.SetPixel(1, 2, 1, 2, 3);
  window.SetPixel(1, 2, 1, 2, 3, 255);
  window.SetPixel(1, 2, 1, 2, 3, 0.5);
  window.SetPixel(1, 2, Level{1}, Level{2}, Level{3});
  window.SetPixel(1, 2, Level{1}, Level{2}, Level{3}, Level{0});
  window.SetPixel(1, 2, 0.0, 0.0, 1.0);
  window.SetPixel(1, 2, 0.0, 0.0, 1.0, 0.5);
  window.SetPixel(1, 2, "#34AAFF");
  window.SetPixel(1, 2, "#34AAFF", 255);
  window.SetPixel(1, 2, "#34AAFF", 0.5);
  window.SetPixel(1, 2, 1, 0.0, 0);
  window.SetLine(0, 0, 1, 1, 0, 255, 0);
  window.SetLine(0, 0, 1, 1, 0, 255, 0, 255);
  window.SetLine(0, 0, 1, 1, 0, 255, 0, 0.5);
  window.SetLine(0, 0, 1, 1, Level{1}, Level{2}, Level{3});
  window.SetLine(0, 0, 1, 1, Level{1}, Level{2}, Level{3}, Level{0});
  window.SetLine(0, 0, 1, 1, 0.0, 0.0, 1.0);
  window.SetLine(0, 0, 1, 1, 0.0, 0.0, 1.0, 0.5);
  window.SetLine(0, 0, 1, 1, "#34AAFF");
  window.SetLine(0, 0, 1, 1, "#34AAFF", 255);
  window.SetLine(0, 0, 1, 1, "#34AAFF", 0.5);
  window.SetLine(0, 0, 1, 1, 0, 0.5, 0);
  client.Read();
  EXPECT_EQ(server.Count("s1r.pen set_pixel [1, 2, "), 11U);
  EXPECT_EQ(server.Count("s1r.pen set_line [0, 0, 1, 1, "), 11U);
  EXPECT_EQ(window.GetPixel(0, 0), (Color_t{1, 2, 3}));
  window.ResizeCanvas(1, 1);
  window.SetImageData({{1, 2, 3}});
  window.UpdateImageData({{{0, 0}, {1, 2, 3}}});
  window.SaveImageCopy("a.png");
  server.Answer("s1r.pen get_image_data", "SUCCESS [[1, 2, 3]]");
  EXPECT_EQ(window.GetImageData().size(), 1U);
  window.RefreshSize();
  delete &window;
}

TEST_F(L305, ProxiesHavePlayersCommonMethods) {
  Position2dProxy position(&client, 3);
  EXPECT_EQ(position.GetIndex(), 3U);
  EXPECT_EQ(position.GetInterface(), 4U);
  EXPECT_EQ(position.GetInterfaceStr(), "position2d");
  EXPECT_EQ(position.GetPlayerClient(), &client);
  EXPECT_EQ(position.HasCapability(1, 2), 0);
  bool flag = false;
  std::int32_t number = 0;
  double value = 0.0;
  char* text = nullptr;
  EXPECT_EQ(position.GetBoolProp("x", &flag) + position.SetBoolProp("x", flag), -2);
  EXPECT_EQ(position.GetIntProp("x", &number) + position.SetIntProp("x", number), -2);
  EXPECT_EQ(position.GetDblProp("x", &value) + position.SetDblProp("x", value), -2);
  EXPECT_EQ(position.GetStrProp("x", &text) + position.SetStrProp("x", "y"), -2);
  position.SetReplaceRule(true);
  std::ostringstream out;
  out << position << client;
  EXPECT_TRUE(Has(out.str(), "#Position2D (4:3)"));
  EXPECT_TRUE(Has(out.str(), "127.0.0.1: "));
}

TEST_F(L305, ReadSignalsTellOfFreshData) {
  LaserProxy laser(&client);
  int calls = 0;
  const auto connection = laser.ConnectReadSignal([&] { ++calls; });
  client.Read();
  server.SetStep(0.0);
  client.Read();  // nothing new
  EXPECT_EQ(calls, 1);
  server.SetStep(0.1);
  laser.DisconnectReadSignal(connection);
  client.Read();
  EXPECT_EQ(calls, 1);
}

TEST_F(L305, GoToDrivesByTheWaypointActuator) {
  Position2dProxy position(&client, 0);
  client.Read();
  server.ClearLines();
  position.GoTo(1.5, 2.5, 0.0);
  position.GoTo(player_pose2d_t{1.0, 1.0, 0.0}, player_pose2d_t{0.2, 0.0, 0.0});
  position.SetSpeed(0.1, 0.0);
  client.Read();
  const Lines lines = server.Lines();
  EXPECT_EQ(lines[1], "s1r.waypoint setdest [1.5, 2.5, 0.0, 0.05, 0.35]");
  EXPECT_EQ(lines[3], "s1r.waypoint setdest [1.0, 1.0, 0.0, 0.05, 0.2]");
  EXPECT_EQ(lines[4], "s1r.waypoint stop");
  EXPECT_EQ(lines[5], "s1r.motion set_speed [0.1, 0.0]");
  EXPECT_THROW(position.GoTo(std::nan(""), 0.0, 0.0), MorseError);
}

TEST_F(L305, GoToTakesGoalsInTheFrameOfItsPositions) {
  // Odometry: the robot is at (0.25, 0.5, 0.125) there and at (1, 2, 0.5) in the world.
  Position2dProxy position(&client, 3);
  client.Read();
  server.ClearLines();
  position.GoTo(0.25, 0.5, 0.0);  // where it stands
  client.Read();
  std::istringstream in(server.Lines()[1].substr(std::string("s1r.waypoint setdest [").size()));
  double x = 0.0;
  double y = 0.0;
  char comma = 0;
  in >> x >> comma >> y;
  EXPECT_NEAR(x, 1.0, 1e-9);
  EXPECT_NEAR(y, 2.0, 1e-9);
}

TEST_F(L305, CarlikeAndHeadingBecomeSpeeds) {
  Position2dProxy position(&client, 0);
  client.Read();
  server.ClearLines();
  position.SetCarlike(0.125, kPi / 4);  // turn rate 0.125 tan(45 deg) / 0.125
  position.SetVelHead(0.1, 0.5);        // the heading it has
  position.SetVelHead(0.1, 0.0, 0.5 + 2 * kPi);
  position.SetSpeed(0.1, 9.0, 0.2);
  position.SetSpeed(player_pose2d_t{0.1, 9.0, 0.3});
  client.Read();
  const Lines lines = server.Lines();
  EXPECT_TRUE(Has(lines[0], "s1r.motion set_speed [0.125, "));
  EXPECT_NEAR(std::stod(lines[0].substr(lines[0].find(',') + 1)), 1.0, 1e-9);
  EXPECT_EQ(lines[1], "s1r.motion set_speed [0.1, 0.0]");
  EXPECT_NEAR(std::stod(lines[2].substr(lines[2].find(',') + 1)), 0.0, 1e-9);
  EXPECT_EQ(lines[3], "s1r.motion set_speed [0.1, 0.2]");
  EXPECT_EQ(lines[4], "s1r.motion set_speed [0.1, 0.3]");
}

TEST_F(L305, SetOdometryMovesTheFrame) {
  Position2dProxy position(&client, 0);
  position.SetOdometry(7.0, 8.0, 0.0);  // before the first data
  EXPECT_DOUBLE_EQ(position.GetXPos(), 7.0);
  client.Read();
  EXPECT_NEAR(position.GetXPos(), 7.0, 1e-12);
  EXPECT_NEAR(position.GetYPos(), 8.0, 1e-12);
  EXPECT_NEAR(position.GetYaw(), 0.0, 1e-12);
  // One metre ahead in the world is one metre along x in the new frame.
  std::ostringstream ahead;
  ahead.precision(17);
  ahead << "\"x\": " << 1.0 + std::cos(0.5) << ", \"y\": " << 2.0 + std::sin(0.5)
        << R"(, "z": 0, "yaw": 0.75, "pitch": 0, "roll": 0)";
  server.SetData("s1r.pose", ahead.str());
  client.Read();
  EXPECT_NEAR(position.GetXPos(), 8.0, 1e-9);
  EXPECT_NEAR(position.GetYPos(), 8.0, 1e-9);
  EXPECT_NEAR(position.GetYaw(), 0.25, 1e-9);
  position.ResetOdometry();
  EXPECT_NEAR(position.GetXPos(), 0.0, 1e-9);
  EXPECT_NEAR(position.GetYaw(), 0.0, 1e-9);
}

TEST_F(L305, GeometryAndStall) {
  Position2dProxy position(&client, 0);
  EXPECT_DOUBLE_EQ(position.GetSize().sl, 0.0);
  position.RequestGeom();
  EXPECT_DOUBLE_EQ(position.GetSize().sl, 0.174);
  EXPECT_DOUBLE_EQ(position.GetOffset().px, 0.0);
  EXPECT_FALSE(position.GetStall());
  server.SetData("s1r.odometry",
                 R"("x": 0, "y": 0, "z": 0, "yaw": 0, "pitch": 0, "roll": 0, "vx": 0, "vy": 0, )"
                 R"("vz": 0, "wz": 0, "wy": 0, "wx": 0, "stall": true)");
  client.Read();
  EXPECT_TRUE(position.GetStall());
}

class Tour : public MorseDriver {
 public:
  explicit Tour(PlayerClient* client) : MorseDriver(client, "snd") {}
  ~Tour() override {
    Stop();
    Join();
  }
  std::thread::id id;
  bool fail = false;

 protected:
  void Main() override {
    id = std::this_thread::get_id();
    if (fail) throw MorseError("no way", "Tour::Main()");
    while (!StopRequested()) GetPlayerClient()->Read();
  }
};

TEST_F(L306, ADriverRunsInAThreadOfItsOwn) {
  Tour tour(&client);
  server.ClearLines();
  tour.Start();
  EXPECT_THROW(tour.Start(), MorseError);
  EXPECT_TRUE(server.WaitForLine("ccmorse read"));
  tour.Stop();
  tour.Join();
  EXPECT_FALSE(tour.IsRunning());
  EXPECT_NE(tour.id, std::this_thread::get_id());
  tour.fail = true;
  tour.Start();  // may run again
  EXPECT_EQ(ErrorOf([&] { tour.Join(); }).GetErrorStr(), "no way");
  tour.Join();
}

TEST_F(L308, PlayerClientRedirectsToTheMorseClient) {
  EXPECT_EQ(&client.GetMorseClient(), &MorseClient::GetInstance());
  // No state of its own: it is Player's client over the MorseClient.
  EXPECT_TRUE((std::is_base_of_v<PlayerCc::PlayerClient, PlayerClient>));
  EXPECT_EQ(sizeof(PlayerClient), sizeof(PlayerCc::PlayerClient));
  server.ClearLines();
  client.Read();
  EXPECT_EQ(server.Count("ccmorse read"), 1U);
  EXPECT_TRUE(client.Connected());
  EXPECT_EQ(client.GetHostname(), kHost);
  EXPECT_EQ(client.GetPort(), static_cast<std::uint32_t>(server.port()));
  client.SetDataMode(2);
  client.SetReplaceRule(true, -1, -1, -1);
  client.SetRequestTimeout(2);
  EXPECT_DOUBLE_EQ(client.GetMorseClient().GetRequestTimeout(), 2.0);
  client.SetRetryLimit(1);
  EXPECT_EQ(client.GetRetryLimit(), 1);
  client.SetRetryTime(1.0);
  EXPECT_DOUBLE_EQ(client.GetRetryTime(), 1.0);
  client.RequestDeviceList();
  EXPECT_EQ(client.GetDeviceList().size(), 4U);
  EXPECT_EQ(client.LookupCode("laser"), 6);
  EXPECT_EQ(client.LookupName(6), "laser");
  EXPECT_EQ(client.GetOverflowCount(), 0U);
}

TEST_F(L308, RunReadsUntilStop) {
  LaserProxy laser(&client);
  int reads = 0;
  laser.ConnectReadSignal([&] {
    if (++reads == 3) client.Stop();
  });
  client.Run(0);
  EXPECT_EQ(reads, 3);
}

// Whether a class lets a program set the valid flag.
template <class Proxy, class = void>
struct SetsValid : std::false_type {};
template <class Proxy>
struct SetsValid<Proxy, std::void_t<decltype(std::declval<Proxy&>().SetValid(true))>>
    : std::true_type {};

TEST_F(L309, ValidIsUpToTheLibrary) {
  LaserProxy laser(&client);
  EXPECT_FALSE(laser.IsValid());
  laser.NotFresh();
  EXPECT_FALSE(laser.IsValid());
  client.Read();
  EXPECT_TRUE(laser.IsValid());
  laser.NotFresh();
  EXPECT_TRUE(laser.IsValid());
  EXPECT_FALSE(SetsValid<LaserProxy>::value);
}

TEST_F(L310, FreshComesWithNewerDataOnly) {
  LaserProxy laser(&client);
  EXPECT_FALSE(laser.IsFresh());
  client.Read();
  EXPECT_TRUE(laser.IsFresh());
  EXPECT_DOUBLE_EQ(laser.GetDataTime(), 0.1);
  EXPECT_DOUBLE_EQ(laser.GetElapsedTime(), 0.1);
  laser.NotFresh();
  EXPECT_FALSE(laser.IsFresh());
  server.SetStep(0.0);
  client.Read();  // the same timestamp
  EXPECT_FALSE(laser.IsFresh());
  server.SetStep(0.2);
  client.Read();
  EXPECT_TRUE(laser.IsFresh());
  EXPECT_NEAR(laser.GetElapsedTime(), 0.2, 1e-9);
  server.SetStep(-0.2);
  laser.NotFresh();
  client.Read();  // older
  EXPECT_FALSE(laser.IsFresh());
}

TEST_F(L311, AMissingIndexListsTheOnesThereAre) {
  const MorseError laser = ErrorOf([&] { LaserProxy(&client, 5); });
  EXPECT_TRUE(Has(laser.GetErrorStr(), "laser:5"));
  EXPECT_TRUE(Has(laser.GetErrorStr(), "laser:0 of s1r"));
  EXPECT_EQ(laser.GetErrorFun(), "LaserProxy::LaserProxy()");
  const MorseError position = ErrorOf([&] { Position2dProxy(&client, 1); });
  EXPECT_TRUE(Has(position.GetErrorStr(), "position2d:0 of s1r, position2d:2 of s1r"));
  EXPECT_THROW(LaserProxy(nullptr, 0), MorseError);
  EXPECT_THROW(LaserProxy(&client, 0, "nobody"), MorseError);
  EXPECT_TRUE(client.GetMorseClient().GetRobot("s1r").GetProxies().empty());
}

TEST_F(L311, AnIndexWithoutItsDeviceIsAnError) {
  FakeServer simulator;
  simulator.SetData("s1r.properties",
                    R"("properties": {"proxies": {"laser": {"0": "sonar", "1": "pose", "2": 7}}})");
  PlayerClient program(kHost, simulator.port());
  for (const unsigned index : {0U, 1U, 2U}) EXPECT_THROW(LaserProxy(&program, index), MorseError);
}

TEST_F(L311, TheFirstRobotThatHasTheIndexIsTaken) {
  FakeServer::Options options;
  options.robots = {"s1r", "other"};
  FakeServer simulator(options);
  PlayerClient program(kHost, simulator.port());
  EXPECT_EQ(LaserProxy(&program, 0).GetDriverName(), "s1r.hokuyo");
  EXPECT_EQ(LaserProxy(&program, 11).GetDriverName(), "other.hokuyo");
  EXPECT_EQ(Position2dProxy(&program, 11, "other").GetRobot().GetName(), "other");
  EXPECT_THROW(LaserProxy(&program, 0, "other"), MorseError);
}

TEST_F(L312, DriversAreConfiguredByRobot) {
  Tour tour(&client);
  EXPECT_EQ(tour.GetName(), "snd");
  EXPECT_DOUBLE_EQ(tour.GetConfiguration().GetDouble("max_speed"), 0.2);
}

TEST_F(X11, PlayerClientTakesAStringAndAnInt) {
  const std::string host = kHost;
  const int port = server.port();
  PlayerClient* other = new CCMorse::PlayerClient(host, port);
  EXPECT_TRUE(other->Connected());
  delete other;
  EXPECT_TRUE(client.Connected());
}

TEST_F(X12, LaserProxyTakesAClientAndAnInt) {
  const int index = 0;
  LaserProxy laser(&client, static_cast<unsigned>(index));
  EXPECT_EQ(laser.GetIndex(), 0U);
}

TEST_F(X13, Position2dProxyTakesAClientAndAnInt) {
  Position2dProxy position(&client, 0);
  EXPECT_EQ(position.GetIndex(), 0U);
}

TEST_F(X14, WindowIsMadeInTheGivenSize) {
  WindowProxy& window = CCMorse::WindowProxy::GetInstance(&client, 172, 186);
  EXPECT_EQ(server.Count("s1r.pen resize_canvas [172, 186]"), 1U);
  EXPECT_EQ(window.GetWidth(), 172);
  EXPECT_EQ(window.GetHeight(), 186);
  EXPECT_DOUBLE_EQ(window.GetCellSize(), 0.02);
  delete &CCMorse::WindowProxy::GetInstance();
}

TEST_F(X14, WithoutAPenThereIsNoWindow) {
  FakeServer simulator(Plain());
  PlayerClient program(kHost, simulator.port());
  EXPECT_THROW(WindowProxy::GetInstance(&program, 10, 10), MorseError);
  EXPECT_THROW(WindowProxy::GetInstance(nullptr, 10, 10), MorseError);
  EXPECT_THROW(WindowProxy::GetInstance(), MorseError);
}

TEST_F(X15, WindowsComeAndGo) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_THROW(WindowProxy::GetInstance(), MorseError);
    WindowProxy& window = WindowProxy::GetInstance(&client, 10 + i, 10);
    EXPECT_EQ(&WindowProxy::GetInstance(), &window);
    EXPECT_EQ(&WindowProxy::GetInstance(&client, 20, 20), &window);
    EXPECT_EQ(window.GetWidth(), 20);
    delete &WindowProxy::GetInstance();
  }
}

TEST_F(X17, LaserTellsWhetherDataAreFresh) {
  LaserProxy laser(&client, 0);
  EXPECT_FALSE(laser.IsFresh());
  client.Read();
  EXPECT_TRUE(laser.IsFresh());
}

TEST(X18, PeekEndsTheLoopOfTheListing) {
  for (const char* pace : {"lockstep", "max"}) {
    FakeServer server(WithPace(pace));
    PlayerClient client(kHost, server.port());
    for (int i = 0; i < 3; ++i) {
      client.Read();
      int more = 0;
      while (client.Peek(0)) {
        client.Read();
        ASSERT_LT(++more, 2);
      }
      EXPECT_EQ(more, 0);
    }
    EXPECT_EQ(server.Count("ccmorse peek"), 0U);  // no round trip
  }
}

TEST(Q21, APollingProgramIsNotStarvedInLockStep) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  EXPECT_TRUE(client.Peek(0));  // before the first Read()
  client.Read();
  EXPECT_FALSE(client.Peek(0));
  EXPECT_TRUE(client.Peek(0));
  client.Read();
  EXPECT_TRUE(client.Peek(10));
  client.Read();
  EXPECT_FALSE(client.Peek());
  client.ReadIfWaiting();
  EXPECT_EQ(server.Count("ccmorse read"), 4U);
}

TEST(X18, PeekAsksCCMorseInRealTime) {
  FakeServer server(WithPace("realtime"));
  PlayerClient client(kHost, server.port());
  client.Read();
  EXPECT_FALSE(client.Peek(0));
  EXPECT_EQ(server.Count("ccmorse peek [0.0]"), 1U);
  server.Answer("ccmorse peek", "SUCCESS true");
  EXPECT_TRUE(client.Peek(250));
  EXPECT_EQ(server.Count("ccmorse peek [0.25]"), 1U);
}

TEST(X18, PeekOnPlainMorseWaitsForATick) {
  FakeServer server(Plain());
  PlayerClient client(kHost, server.port());
  EXPECT_TRUE(client.Peek(0));
  client.Read();
  EXPECT_TRUE(client.Peek(1000));
  EXPECT_EQ(server.Count("ccmorse peek"), 0U);
}

TEST_F(X19, TheStartLoopOfTheListingEnds) {
  LaserProxy laser(&client, 0);
  while (!laser.IsFresh()) {
    client.Read();
    while (client.Peek(0)) client.Read();
  }
  EXPECT_LE(client.GetMorseClient().GetTime(), 1.0);
}

TEST(X20, ErrorsHaveTextAndFunctionThatStream) {
  try {
    throw MorseError("gone", "MorseClient::Read()");
  } catch (CCMorse::MorseError& e) {
    std::ostringstream out;
    out << "Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun();
    EXPECT_EQ(out.str(), "Morse error: gone function: MorseClient::Read()");
  }
}

TEST(X23, ImagePointIsFoundByUsingNamespace) {
  ImagePoint_t last, current;
  last = ImagePoint_t(1, 2);
  current = last;
  EXPECT_EQ(current.x + current.y, 3);
}

TEST_F(X24, MotorsOffStopAtOnceAndIgnoreCommands) {
  Position2dProxy position(&client, 0);
  position.SetMotorEnable(true);
  position.SetSpeed(0.3, 0.0);
  client.Read();
  server.ClearLines();
  position.SetMotorEnable(false);
  EXPECT_TRUE(server.WaitForLine("s1r.motion set_speed [0.0, 0.0]"));  // without a Read()
  server.ClearLines();
  position.SetSpeed(0.3, 0.0);
  position.GoTo(1.0, 1.0, 0.0);
  client.Read();
  EXPECT_EQ(server.Count("s1r.motion"), 0U);
  EXPECT_EQ(server.Count("s1r.waypoint"), 0U);
  position.SetMotorEnable(true);
  position.SetSpeed(0.2, 0.0);
  client.Read();
  EXPECT_EQ(server.Count("s1r.motion set_speed [0.2, 0.0]"), 1U);
}

TEST_F(X25, PositionTellsFreshAndValid) {
  Position2dProxy position(&client, 0);
  EXPECT_FALSE(position.IsFresh() || position.IsValid());
  client.Read();
  EXPECT_TRUE(position.IsFresh() && position.IsValid());
}

TEST_F(X26, PositionsAreTheSensorsToTheBit) {
  server.SetData("s1r.pose",
                 R"("x": 0.1234567890123, "y": -2.5, "z": 0, "yaw": -3.1, "pitch": 0, "roll": 0)");
  Position2dProxy position(&client, 0);
  client.Read();
  EXPECT_EQ(position.GetXPos(), 0.1234567890123);
  EXPECT_EQ(position.GetYPos(), -2.5);
  EXPECT_EQ(position.GetYaw(), -3.1);
}

TEST_F(X27, SpeedsComeFromTheOdometry) {
  Position2dProxy position(&client, 0);
  client.Read();
  EXPECT_DOUBLE_EQ(position.GetXSpeed(), 0.3);
  EXPECT_DOUBLE_EQ(position.GetYSpeed(), 0.0);
  EXPECT_DOUBLE_EQ(position.GetYawSpeed(), 0.1);
}

TEST_F(X28, CornersOfTheArenaAreCornersOfTheCanvas) {
  WindowProxy& window = WindowProxy::GetInstance(&client, 171, 186);
  EXPECT_EQ(window.GetX(0.0), 0);
  EXPECT_EQ(window.GetY(0.0), 0);
  EXPECT_EQ(window.GetX(3.42), 170);
  EXPECT_EQ(window.GetY(3.72), 185);
  EXPECT_EQ(window.GetX(3.419), 170);
  EXPECT_EQ(window.GetX(0.0399), 1);
  EXPECT_EQ(window.GetX(-0.01), 0);
  EXPECT_EQ(window.GetX(1e300), 170);
  EXPECT_EQ(window.GetX(std::nan("")), 0);
  EXPECT_EQ(window.GetY(-INFINITY), 0);
  EXPECT_EQ(window.GetY(INFINITY), 185);
  delete &window;
}

TEST_F(X29, SetLineTakesIntLiterals) {
  WindowProxy& window = WindowProxy::GetInstance(&client, 10, 10);
  const ImagePoint_t last(1, 2), current(3, 4);
  window.SetLine(last.x, last.y, current.x, current.y, 0, 255, 0);
  window.SetPixel(current.x, current.y, 255, 0, 255);  // X30
  client.Read();
  EXPECT_EQ(server.Count("s1r.pen set_line [1, 2, 3, 4, 0, 255, 0]"), 1U);
  EXPECT_EQ(server.Count("s1r.pen set_pixel [3, 4, 255, 0, 255]"), 1U);
  delete &window;
}

TEST(X30, SetPixelTakesIntLiterals) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  WindowProxy& window = WindowProxy::GetInstance(&client, 10, 10);
  window.SetPixel(3, 4, 255, 0, 255);
  client.Read();
  EXPECT_EQ(server.Count("s1r.pen set_pixel [3, 4, 255, 0, 255]"), 1U);
  delete &window;
}

TEST(Q19, IntLiteralsAreNotAmbiguous) {
  // Holds when this compiles: int, decimal and mixed channels choose one overload each.
  using Pixel = void (WindowProxy::*)(int, int, int, int, int);
  using Decimal = void (WindowProxy::*)(int, int, double, double, double);
  EXPECT_NE(static_cast<Pixel>(&WindowProxy::SetPixel), nullptr);
  EXPECT_NE(static_cast<Decimal>(&WindowProxy::SetPixel), nullptr);
}

TEST_F(X31, NotFreshHoldsUntilTheNextData) {
  Position2dProxy position(&client, 0);
  LaserProxy laser(&client, 0);
  client.Read();
  position.NotFresh();
  laser.NotFresh();
  EXPECT_FALSE(position.IsFresh() || laser.IsFresh());
  client.Read();
  EXPECT_TRUE(position.IsFresh() && laser.IsFresh());
}

TEST_F(X32, AnglesAndCountOfTheScanner) {
  LaserProxy laser(&client, 0);
  client.Read();
  EXPECT_NEAR(laser.GetMinAngle(), -2.356, 0.0005);
  EXPECT_NEAR(laser.GetMaxAngle(), 2.356, 0.0005);
  EXPECT_EQ(laser.GetCount(), 682U);
}

TEST_F(X33, HighestRange) { EXPECT_DOUBLE_EQ(LaserProxy(&client, 0).GetMaxRange(), 5.0); }

TEST_F(X34, ResolutionInRadians) {
  LaserProxy laser(&client, 0);
  EXPECT_NEAR(laser.GetScanRes(), 0.0069096, 5e-8);
  EXPECT_EQ(static_cast<unsigned>(40 * (PI / 180) / laser.GetScanRes()), 101U);
}

TEST_F(X35, RangesByIndex) {
  LaserProxy* laser = new LaserProxy(&client, 0);
  client.Read();
  EXPECT_DOUBLE_EQ((*laser)[100], 0.5);
  EXPECT_DOUBLE_EQ((*laser)[0], 5.0);
  EXPECT_DOUBLE_EQ((*laser)[681], laser->GetMaxRange());
  const MorseError error = ErrorOf([&] { (*laser)[700]; });
  EXPECT_EQ(error.GetErrorStr(), "index 700 of 682");
  EXPECT_EQ(error.GetErrorFun(), "LaserProxy::GetRange()");
  delete laser;
}

TEST_F(X36, BearingsByIndex) {
  LaserProxy laser(&client, 0);
  EXPECT_DOUBLE_EQ(laser.GetBearing(0), laser.GetMinAngle());
  EXPECT_DOUBLE_EQ(laser.GetBearing(340), laser.GetMinAngle() + 340 * laser.GetScanRes());
}

TEST_F(X37, SetSpeedLeavesWithTheNextRead) {
  Position2dProxy position(&client, 0);
  server.ClearLines();
  position.SetSpeed(0.3, -1.0);
  client.Read();
  EXPECT_EQ(server.Lines().front(), "s1r.motion set_speed [0.3, -1.0]");
  EXPECT_THROW(position.SetSpeed(std::nan(""), 0.0), MorseError);
  EXPECT_THROW(position.SetSpeed(0.0, INFINITY), MorseError);
}

TEST(X39, BothOrdersOfDeletionAreSafe) {
  FakeServer server;
  for (const bool client_first : {false, true}) {
    auto client = std::make_unique<PlayerClient>(kHost, server.port());
    auto laser = std::make_unique<LaserProxy>(client.get(), 0);
    auto position = std::make_unique<Position2dProxy>(client.get(), 0);
    WindowProxy::GetInstance(client.get(), 10, 10);
    client->Read();
    if (!client_first) {
      delete &WindowProxy::GetInstance();
      laser.reset();
      position.reset();
      client.reset();
      continue;
    }
    client.reset();
    EXPECT_TRUE(server.WaitForConnections(0));
    EXPECT_DOUBLE_EQ(position->GetXPos(), 1.0);  // the last values
    EXPECT_DOUBLE_EQ((*laser)[100], 0.5);
    EXPECT_TRUE(laser->IsFresh());
    server.ClearLines();
    position->SetSpeed(0.1, 0.0);
    position->SetMotorEnable(false);
    WindowProxy::GetInstance().SetPixel(1, 1, 1, 1, 1);
    EXPECT_TRUE(server.Lines().empty());
    delete &WindowProxy::GetInstance();
    laser.reset();
    position.reset();
  }
}

TEST(B08, CCMorseGivesPi) {
  EXPECT_EQ(PI, 3.14159265359);
  EXPECT_EQ(::PI, CCMorse::PI);
  static_assert(std::is_same_v<decltype(CCMorse::PI), const double>);
}

}  // namespace
}  // namespace ccmorse::test
