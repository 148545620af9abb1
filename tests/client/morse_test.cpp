// The second layer: devices as MORSE has them (thesis 3.1.2).

#include <functional>
#include <type_traits>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

TEST(L201, SensorsAndActuatorsAreAbstractDevices) {
  EXPECT_TRUE(std::is_abstract_v<MorseSensor> && std::is_abstract_v<MorseActuator>);
  EXPECT_TRUE((std::is_base_of_v<MorseDevice, MorseSensor>));
  EXPECT_TRUE((std::is_base_of_v<MorseDevice, MorseActuator>));
  EXPECT_TRUE((std::is_base_of_v<MorseSensor, MorsePose>));
  EXPECT_TRUE((std::is_base_of_v<MorseSensor, MorseOdometry>));
  EXPECT_TRUE((std::is_base_of_v<MorseSensor, MorseLaser>));
  EXPECT_TRUE((std::is_base_of_v<MorseSensor, MorseProperties>));
  EXPECT_TRUE((std::is_base_of_v<MorseActuator, MorseMotionVW>));
  EXPECT_TRUE((std::is_base_of_v<MorseActuator, MorseWaypoint>));
  EXPECT_TRUE((std::is_base_of_v<MorseActuator, MorsePen>));
}

class Devices : public ::testing::Test {
 protected:
  template <class T>
  T& Get() {
    return client->GetRobot("s1r").GetDevice<T>();
  }
  FakeServer server;
  std::shared_ptr<MorseClient> client = MorseClient::Share(kHost, server.port());
};
using L202 = Devices;
using L203 = Devices;
using L204 = Devices;
using L205 = Devices;
using L206 = Devices;
using L207 = Devices;
using L208 = Devices;
using L209 = Devices;
using L210 = Devices;
using L211 = Devices;
using L212 = Devices;

TEST_F(L202, PoseIsTheOneInTheWorld) {
  MorsePose& pose = Get<MorsePose>();
  EXPECT_FALSE(pose.HasPose());
  client->Read();
  EXPECT_TRUE(pose.HasPose());
  EXPECT_DOUBLE_EQ(pose.GetX(), 1.0);
  EXPECT_DOUBLE_EQ(pose.GetY(), 2.0);
  EXPECT_DOUBLE_EQ(pose.GetZ(), 0.1);
  EXPECT_DOUBLE_EQ(pose.GetYaw(), 0.5);
  EXPECT_DOUBLE_EQ(pose.GetRoll() + pose.GetPitch(), 0.0);
  EXPECT_DOUBLE_EQ(pose.GetTimestamp(), 0.1);
}

TEST_F(L203, OdometryHasPoseSpeedsAndStall) {
  MorseOdometry& odometry = Get<MorseOdometry>();
  client->Read();
  EXPECT_DOUBLE_EQ(odometry.GetX(), 0.25);
  EXPECT_DOUBLE_EQ(odometry.GetY(), 0.5);
  EXPECT_DOUBLE_EQ(odometry.GetYaw(), 0.125);
  EXPECT_DOUBLE_EQ(odometry.GetXSpeed(), 0.3);
  EXPECT_DOUBLE_EQ(odometry.GetYSpeed(), 0.0);
  EXPECT_DOUBLE_EQ(odometry.GetYawSpeed(), 0.1);
  EXPECT_FALSE(odometry.GetStall());
}

TEST_F(L204, MotionSendsSpeeds) {
  Get<MorseMotionVW>().SetSpeed(0.25, -0.5);
  server.ClearLines();
  client->Read();
  EXPECT_EQ(server.Lines().front(), "s1r.motion set_speed [0.25, -0.5]");
  EXPECT_THROW(Get<MorseMotionVW>().SetSpeed(std::nan(""), 0.0), MorseError);
}

TEST_F(L205, ScannerHasRangesAndTheAngleOfTheShortest) {
  MorseLaser& laser = Get<MorseLaser>();
  EXPECT_EQ(laser.GetCount(), 0U);
  EXPECT_DOUBLE_EQ(laser.GetMinRange(), 5.0);
  EXPECT_DOUBLE_EQ(laser.GetMinRangeAngle(), 0.0);
  client->Read();
  EXPECT_EQ(laser.GetCount(), 682U);
  EXPECT_EQ(laser.GetRanges().size(), 682U);
  EXPECT_DOUBLE_EQ(laser.GetMinRange(), 0.5);
  EXPECT_DOUBLE_EQ(laser.GetMinRangeAngle(), laser.GetBearing(100));
  EXPECT_NEAR(laser.GetScanWindow(), 4.712389, 1e-6);
  EXPECT_DOUBLE_EQ(laser.GetFrequency(), 10.0);
  EXPECT_DOUBLE_EQ(laser.GetMounting().px, 0.035);
  EXPECT_DOUBLE_EQ(laser.GetMounting().pyaw, 0.0);
  EXPECT_TRUE(Has(ErrorOf([&] { laser.GetRange(700); }).GetErrorStr(), "index 700 of 682"));
}

TEST_F(L205, RangesStayBetweenZeroAndTheHighest) {
  server.SetData("s1r.hokuyo", "\"range_list\": [Infinity, NaN, -1, 7, 1.5]");
  client->Read();
  EXPECT_EQ(Get<MorseLaser>().GetRanges(), (std::vector<double>{5.0, 5.0, 0.0, 5.0, 1.5}));
}

TEST_F(L206, WaypointGoesStopsAndTells) {
  MorseWaypoint& waypoint = Get<MorseWaypoint>();
  waypoint.SetGoal(1.0, 2.0, 0.1, 0.3);
  waypoint.Stop();
  waypoint.Resume();
  EXPECT_EQ(waypoint.GetStatus(), "Transit");
  EXPECT_EQ(server.Count("s1r.waypoint setdest [1.0, 2.0, 0.0, 0.1, 0.3]"), 1U);
  EXPECT_EQ(server.Count("s1r.waypoint stop"), 1U);
  EXPECT_EQ(server.Count("s1r.waypoint resume"), 1U);
  EXPECT_TRUE(waypoint.GoTo(1.0, 2.0));
  server.Answer("s1r.waypoint goto", "PREEMPTED");
  EXPECT_FALSE(waypoint.GoTo(1.0, 2.0));
  server.Answer("s1r.waypoint goto", std::nullopt);
  EXPECT_THROW(waypoint.GoTo(1.0, 2.0, 0.1, 1.0, 0.05), MorseError);
  EXPECT_THROW(waypoint.SetGoal(std::nan(""), 0.0), MorseError);
}

TEST_F(L207, PropertiesAreReadByPath) {
  const MorseProperties& properties = Get<MorseProperties>();
  EXPECT_EQ(properties.GetRobotName(), "s1r");
  EXPECT_DOUBLE_EQ(properties.GetDouble("mass", -1.0), 2.0);
  EXPECT_DOUBLE_EQ(properties.GetDouble("no.such.key", -1.0), -1.0);
  EXPECT_DOUBLE_EQ(properties.GetDouble("name", -1.0), -1.0);  // a text
  EXPECT_EQ(properties.GetInt("color.1"), 170);
  EXPECT_EQ(properties.GetString("canvas.mode"), "ground");
  EXPECT_EQ(properties.GetDoubles("size").size(), 3U);
  EXPECT_TRUE(properties.Has("drivers.snd"));
  EXPECT_DOUBLE_EQ(properties.GetDriver("snd").GetDouble("max_speed"), 0.2);
  EXPECT_EQ(properties.GetProxyIndexes("position2d"), (std::vector<int>{0, 2, 3}));
  EXPECT_DOUBLE_EQ(properties.GetInitialPose().pa, 0.5);
  EXPECT_DOUBLE_EQ(properties.GetLength(), 0.174);
}

TEST_F(L207, AKeyThatTheSimulatorAddsIsReadable) {
  FakeServer other;
  other.SetData("s1r.properties", R"("properties": {"battery": {"cells": 3}, "lights": true})");
  const auto client_of_other = MorseClient::Share(kHost, other.port());
  const MorseProperties& properties = client_of_other->GetRobot("s1r").GetProperties();
  EXPECT_EQ(properties.GetInt("battery.cells"), 3);
  EXPECT_TRUE(properties.GetBool("lights"));
}

TEST_F(L208, TimeModeAndStatistics) {
  MorseTime time(*client);
  double last = time.GetTime();
  for (int i = 0; i < 5; ++i) {
    client->Read();
    EXPECT_GT(time.GetTime(), last);
    last = time.GetTime();
  }
  EXPECT_DOUBLE_EQ(time.GetLastReadTime(), last);
  EXPECT_EQ(time.GetMode(), "Fixed Simulation Step");
  EXPECT_DOUBLE_EQ(time.GetStatistics().mean_time, 0.0166);
  EXPECT_DOUBLE_EQ(time.GetStatistics().diff_real_time, 0.25);
  EXPECT_DOUBLE_EQ(time.GetStatistics().mean_frame_by_sec, 0.0);
  EXPECT_TRUE(time.SetTimeScale(2.0));
  EXPECT_THROW(time.SetTimeScale(0.0), MorseError);
}

using uchar = unsigned char;

// What the simulator hears of the pen's drawing, a service's arguments a line. The highest alpha
// covers, as no alpha does, so it is not sent.
class Pens : public Devices {
 protected:
  Lines Sent(const std::string& service, const std::function<void(MorsePen&)>& draw) {
    server.ClearLines();
    draw(Get<MorsePen>());
    client->Read();
    Lines sent;
    for (const std::string& line : server.Lines()) {
      const std::string start = "s1r.pen " + service + " ";
      if (line.rfind(start, 0) == 0) sent.push_back(line.substr(start.size()));
    }
    return sent;
  }
};
using P20 = Pens;
using P21 = Pens;
using P22 = Pens;
using P23 = Pens;
using P24 = Pens;

TEST_F(P20, APixelIn8BitColoursWithAlpha) {
  EXPECT_EQ(Sent("set_pixel",
                 [](MorsePen& pen) {
                   pen.SetPixel(1, 2, uchar{1}, uchar{2}, uchar{3}, uchar{255});
                   pen.SetPixel(1, 2, uchar{1}, uchar{2}, uchar{3}, uchar{51});
                   pen.SetPixel(1, 2, 300, -5, 7, 51);  // held within 0..255
                   pen.SetPixel(1, 2, 255, 0, 255, 0.5);
                   pen.SetPixel(1, 2, uchar{9}, 8, 7L, 255);
                 }),
            (Lines{"[1, 2, 1, 2, 3]", "[1, 2, 1, 2, 3, 0.2]", "[1, 2, 255, 0, 7, 0.2]",
                   "[1, 2, 255, 0, 255, 0.5]", "[1, 2, 9, 8, 7]"}));
}

TEST_F(P21, APixelIn8BitColours) {
  EXPECT_EQ(Sent("set_pixel",
                 [](MorsePen& pen) {
                   pen.SetPixel(1, 2, 255, 0, 255);
                   pen.SetPixel(1, 2, uchar{1}, uchar{2}, uchar{3});
                 }),
            (Lines{"[1, 2, 255, 0, 255]", "[1, 2, 1, 2, 3]"}));
}

TEST_F(P22, APixelInDecimals) {
  EXPECT_EQ(Sent("set_pixel",
                 [](MorsePen& pen) {
                   pen.SetPixel(1, 2, 1.0, 0.5, 0.0);
                   pen.SetPixel(1, 2, 1.0, 0.5, 0.0, 0.25);
                   pen.SetPixel(1, 2, 1, 0.5, 0.0F);
                 }),
            (Lines{"[1, 2, 255, 128, 0]", "[1, 2, 255, 128, 0, 0.25]", "[1, 2, 255, 128, 0]"}));
}

TEST_F(P23, APixelInTheCodeOfAColour) {
  EXPECT_EQ(
      Sent("set_pixel",
           [](MorsePen& pen) {
             pen.SetPixel(1, 2, "#34AAFF");
             pen.SetPixel(1, 2, "#34aaff", 0);
             pen.SetPixel(1, 2, "#34AAFF", 0.5);
             for (const char* wrong : {"", "34AAFF", "#34AAF", "#34AAFG", "#34AAFF0", "blue"}) {
               EXPECT_THROW(pen.SetPixel(0, 0, wrong), MorseError) << wrong;
             }
           }),
      (Lines{"[1, 2, 52, 170, 255]", "[1, 2, 52, 170, 255, 0.0]", "[1, 2, 52, 170, 255, 0.5]"}));
}

TEST_F(P24, LinesHaveTheSameOverloads) {
  EXPECT_EQ(
      Sent("set_line",
           [](MorsePen& pen) {
             pen.SetLine(0, 1, 2, 3, 0, 255, 0);
             pen.SetLine(0, 1, 2, 3, 0, 255, 0, 51);
             pen.SetLine(0, 1, 2, 3, uchar{1}, uchar{2}, uchar{3});
             pen.SetLine(0, 1, 2, 3, uchar{1}, uchar{2}, uchar{3}, uchar{0});
             pen.SetLine(0, 1, 2, 3, 0.0, 1.0, 2.0);
             pen.SetLine(0, 1, 2, 3, 0.0, 1.0, 0.0, 0.75);
             pen.SetLine(0, 1, 2, 3, "#000102");
             pen.SetLine(0, 1, 2, 3, "#000102", 255);
             pen.SetLine(0, 1, 2, 3, "#000102", 0.5);
             pen.SetLine(0, 1, 2, 3, 0.5, 1, 0);
           }),
      (Lines{"[0, 1, 2, 3, 0, 255, 0]", "[0, 1, 2, 3, 0, 255, 0, 0.2]", "[0, 1, 2, 3, 1, 2, 3]",
             "[0, 1, 2, 3, 1, 2, 3, 0.0]", "[0, 1, 2, 3, 0, 255, 255]",
             "[0, 1, 2, 3, 0, 255, 0, 0.75]", "[0, 1, 2, 3, 0, 1, 2]", "[0, 1, 2, 3, 0, 1, 2]",
             "[0, 1, 2, 3, 0, 1, 2, 0.5]", "[0, 1, 2, 3, 128, 255, 0]"}));
}

TEST_F(L209, WholeImagesAndSizes) {
  MorsePen& pen = Get<MorsePen>();
  EXPECT_EQ(pen.GetWidth(), 100);
  EXPECT_DOUBLE_EQ(pen.GetCellSize(), 0.02);
  EXPECT_EQ(pen.GetPixel(5, 6), (Color_t{1, 2, 3}));
  pen.ResizeCanvas(2, 1);
  EXPECT_EQ(pen.GetWidth(), 2);
  EXPECT_EQ(pen.GetHeight(), 1);
  pen.SetImageData({{1, 2, 3}, {4, 5, 6}});
  pen.UpdateImageData({{{1, 0}, {7, 8, 9}}});
  server.Answer("s1r.pen get_image_data", "SUCCESS [[1, 2, 3], [7, 8, 9]]");
  EXPECT_EQ(pen.GetImageData(), (std::vector<Color_t>{{1, 2, 3}, {7, 8, 9}}));
  EXPECT_EQ(server.Count("s1r.pen set_image_data [[[1, 2, 3], [4, 5, 6]]]"), 1U);
  EXPECT_EQ(server.Count("s1r.pen update_image_data [[[1, 0, 7, 8, 9]]]"), 1U);
  pen.SaveImageCopy("map.png");
  EXPECT_EQ(server.Count("s1r.pen save_image_copy [\"map.png\"]"), 1U);
  EXPECT_THROW(pen.SetImageData({{1, 2, 3}}), MorseError);
  EXPECT_THROW(pen.ResizeCanvas(0, 5), MorseError);
  server.Answer("s1r.pen get_pixel", "FAILED \"outside\"");
  EXPECT_THROW(pen.GetPixel(-1, 0), MorseError);
}

TEST_F(L210, EveryFieldOfTheSimulatorIsReadable) {
  client->Read();
  const MorseValue data = Get<MorseOdometry>().GetData();
  EXPECT_EQ(data.GetKeys().size(), 14U);
  EXPECT_DOUBLE_EQ(data.GetDouble("vx"), Get<MorseOdometry>().GetXSpeed());
  EXPECT_EQ(Get<MorseLaser>().GetData().GetSize("range_list"), Get<MorseLaser>().GetCount());
}

TEST_F(L211, TheSecondLayerAloneDrivesTheRobot) {
  for (int i = 0; i < 3; ++i) {
    client->Read();
    const bool free = Get<MorseLaser>().GetMinRange() > 1.0;
    Get<MorseMotionVW>().SetSpeed(free ? 0.3 : 0.0, free ? 0.0 : 1.0);
  }
  client->Flush();
  EXPECT_TRUE(server.WaitForLine("s1r.motion set_speed [0.0, 1.0]"));
}

// Another API on the second layer: ten lines.
class Turtle {
 public:
  explicit Turtle(MorseRobot& robot) : robot_(robot) {}
  void Forward(double speed) { robot_.SetSpeed(speed, 0.0); }
  double Heading() const { return robot_.GetDevice<MorsePose>().GetYaw(); }

 private:
  MorseRobot& robot_;
};

TEST_F(L212, AnotherApiFitsOnTop) {
  Turtle turtle(client->GetRobot("s1r"));
  turtle.Forward(0.2);
  client->Read();
  EXPECT_DOUBLE_EQ(turtle.Heading(), 0.5);
  EXPECT_EQ(server.Count("s1r.motion set_speed [0.2, 0.0]"), 1U);
}

TEST_F(L210, ValuesGiveFallbacksForWrongPaths) {
  const MorseValue value =
      MorseValue::Parse(R"({"a": [1, {"b": "c"}], "big": 1e300, "no": -1e300})");
  EXPECT_EQ(value.GetString("a.1.b"), "c");
  EXPECT_FALSE(value.Has("a.2") || value.Has("a.x") || value.Has("a.1.b.c") || value.Has("."));
  EXPECT_EQ(value.GetInt("big"), std::numeric_limits<int>::max());
  EXPECT_EQ(value.GetInt("no"), std::numeric_limits<int>::min());
  EXPECT_TRUE(value.GetDoubles("a").empty());
  EXPECT_TRUE(value.At(0).IsNull());
  EXPECT_EQ(value.Get("a").At(0).GetInt(""), 1);
  EXPECT_TRUE(MorseValue().IsNull());
  EXPECT_EQ(MorseValue().ToString(), "null");
  EXPECT_THROW(MorseValue::Parse("{"), MorseError);
}

TEST_F(L210, ArgumentsAreWrittenAsJson) {
  EXPECT_EQ(MorseArgs().ToString(), "");
  EXPECT_EQ(MorseArgs(1, 2.5, true, "a\"b").ToString(), "[1, 2.5, true, \"a\\\"b\"]");
  EXPECT_EQ(MorseArgs().Add(MorseArgs()).ToString(), "[[]]");
}

}  // namespace
}  // namespace ccmorse::test
