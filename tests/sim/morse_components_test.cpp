// MORSE's sensors and actuators against the physics of robots that move as they are told (specs:
// morse.md B.2, B.3).

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "base/error.h"
#include "base/json.h"
#include "base/trig.h"
#include "scene/scenario.h"
#include "sim/sensors/geodesy.h"
#include "sim/simulation.h"
#include "tests/sim/morse_trial.h"

namespace ccmorse::sim {
namespace {

const std::string kXyw = R"({"name": "motion", "type": "MotionXYW"})";

TEST(MorseVelocityTest, SpeedsOfARobotThatLooksLeftAndGoesForward) {
  Trial run(
      Scene(R"({"name": "v", "type": "Velocity"},)"
            R"({"name": "turned", "type": "Velocity", "rotation": [0, 0, 1.5707963267948966]},)"
            R"({"name": "p", "type": "Velocity", "properties": {"ComputationMode": "Position"}},)" +
                kXyw,
            R"({"x": 0, "y": 0, "yaw": 1.5707963267948966})"));
  run.Send("motion", R"({"x": 2.0, "y": 0.5, "w": 0.0})");
  run.Ticks(3);
  for (const char* name : {"v", "p"}) {
    const Json data = run.Data(name);
    ExpectVector(data, "linear_velocity", 2.0, 0.5, 0.0);
    ExpectVector(data, "angular_velocity", 0.0, 0.0, 0.0);
    ExpectVector(data, "world_linear_velocity", -0.5, 2.0, 0.0);
  }
  // A sensor that looks left has forward on its right.
  ExpectVector(run.Shown("turned"), "linear_velocity", 0.5, -2.0, 0.0);
  run.Send("motion", R"({"x": 0.0, "y": 0.0, "w": 0.7})");
  run.Ticks(2);
  for (const char* name : {"v", "p"}) {
    ExpectVector(run.Data(name), "angular_velocity", 0.0, 0.0, 0.7);
  }
}

TEST(MorseAccelerometerTest, StartingAndTheCentreOfACircle) {
  Trial run(Scene(R"({"name": "a", "type": "Accelerometer"},)"
                  R"({"name": "out", "type": "Accelerometer", "position": [0, 0.5, 0]},)" +
                  kXyw));
  run.Ticks(2);
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0})");
  run.Ticks(1);
  Json data = run.Data("a");
  // From rest to 1 m/s within a tick.
  ExpectVector(data, "acceleration", 60.0, 0.0, 0.0, 1e-9);
  ExpectVector(data, "velocity", 1.0, 0.0, 0.0);
  EXPECT_NEAR(data.Find("distance")->AsDouble(), kStep, 1e-12);
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0.5})");
  run.Ticks(3);
  // v w towards the centre, on the left; finite differences see it half a tick late.
  data = run.Data("a");
  ExpectVector(data, "acceleration", 0.0, 0.5, 0.0, 0.005);
  // The sensor 0.5 m to the left feels w^2 r less of it.
  ExpectVector(run.Shown("out"), "acceleration", 0.0, 0.5 - 0.25 * 0.5, 0.0, 0.005);
}

TEST(MorseGyroscopeTest, AnglesOfTheSensorInTheWorld) {
  Trial run(Scene(R"({"name": "g", "type": "Gyroscope", "rotation": [0.1, -0.2, 3.0]})",
                  R"({"x": 0, "y": 0, "yaw": 1.0})"));
  run.Data("g");
  EXPECT_NEAR(run.Number("g", "yaw"), 4.0 - 2.0 * kPi, 1e-12);
  EXPECT_NEAR(run.Number("g", "pitch"), -0.2, 1e-12);
  EXPECT_NEAR(run.Number("g", "roll"), 0.1, 1e-12);
}

TEST(MorseAttitudeTest, AnglesAndRateAndTheCompass) {
  Trial run(Scene(R"({"name": "a", "type": "Attitude"}, {"name": "north", "type": "Attitude",
                    "properties": {"UseAngleAgainstNorth": true}},)" +
                      kXyw,
                  R"({"x": 0, "y": 0, "yaw": 0.5})"));
  run.Send("motion", R"({"x": 0, "y": 0, "w": 0.6})");
  run.Ticks(1);
  Json data = run.Data("a");
  EXPECT_NEAR(data.Find("rotation")->Find("yaw")->AsDouble(), 0.5 + 0.6 * kStep, 1e-12);
  EXPECT_EQ(data.Find("rotation")->Find("roll")->AsDouble(), 0.0);
  ExpectVector(data, "angular_velocity", 0.0, 0.0, 0.6);
  // x points east: the robot looks 0.51 rad to the left of it, so pi/2 - 0.51 clockwise from north.
  EXPECT_NEAR(run.Shown("north").Find("rotation")->Find("yaw")->AsDouble(), 0.51 - kPi / 2.0,
              1e-12);
}

TEST(MorseAirspeedTest, StagnationPressureOfTheSpeed) {
  Trial run(Scene(R"({"name": "a", "type": "Airspeed"},)" + kXyw));
  run.Send("motion", R"({"x": 2.0, "y": 1.0, "w": 0})");
  run.Ticks(2);
  run.Data("a");
  EXPECT_NEAR(run.Number("a", "diff_pressure"), 0.5 * 1.225 * 4.0, 1e-9);
}

TEST(MorseBarometerTest, ReferencePressureWhereItStarted) {
  Trial run(Scene(R"({"name": "b", "type": "Barometer", "position": [0, 0, 5]})"));
  run.Data("b");
  EXPECT_NEAR(run.Number("b", "pressure"), 101325.0, 1e-6);
  run.Get("b").SetProperty("ReferencePressure", 90000);
  run.Ticks(1);
  run.Data("b");
  EXPECT_NEAR(run.Number("b", "pressure"), 90000.0, 1e-6);
}

TEST(MorseClockTest, TheTimestampAlone) {
  Trial run(Scene(R"({"name": "c", "type": "Clock"})"));
  run.Ticks(6);
  run.Data("c");
  EXPECT_EQ(run.Get("c").LocalData(), R"({"timestamp": 0.1})");
}

TEST(MorseBatteryTest, DischargesByItsRateAndChargesInAZone) {
  Trial run(Scene(R"({"name": "b", "type": "Battery", "properties": {"DischargingRate": 10}},
                   {"name": "teleport", "type": "Teleport"})",
                  R"({"x": 0, "y": 0})", "",
                  R"("zones": [{"type": "Charging", "position": [10, 0, 0], "half_size": [2, 2, 2]},
                             {"type": "Other", "position": [0, 0, 0]}],)"));
  EXPECT_EQ(*run.Shown("b").Find("status"), Json("Charged"));
  run.Ticks(120);
  run.Data("b");
  EXPECT_NEAR(run.Number("b", "charge"), 80.0, 1e-9);
  EXPECT_EQ(*run.Shown("b").Find("status"), Json("Discharging"));
  run.Call("teleport", "translate", {11.9});
  run.Ticks(60);
  EXPECT_EQ(*run.Shown("b").Find("status"), Json("Charging"));
  EXPECT_NEAR(run.Number("b", "charge"), 90.0, 0.5);
  run.Ticks(120);
  EXPECT_EQ(*run.Shown("b").Find("status"), Json("Charged"));
  EXPECT_EQ(run.Number("b", "charge"), 100.0);
}

TEST(MorseProximityTest, WhoIsWithinRangeOfTheRobotsOrigin) {
  Trial run(Scene(R"({"name": "p", "type": "Proximity", "frequency": 60, "position": [5, 0, 0],
                    "properties": {"Range": 6}})",
                  R"({"x": 0, "y": 0})",
                  Other("mouse", 3, 4, R"(, "properties": {"Cheese": true})") + Other("cat", 0, 7),
                  R"("props": [{"name": "crumb", "file": "crumb", "position": [0, 1, 0.1],
                              "properties": {"Cheese": 1}}],)"));
  run.Data("p");
  EXPECT_EQ(run.Get("p").LocalData(),
            R"({"timestamp": 0.0, "near_objects": {"mouse": 5.0}, "near_robots": {"mouse": 5.0}})");
  run.Call("p", "set_range", {7});
  run.Ticks(1);
  EXPECT_EQ(run.Data("p").Find("near_objects")->AsObject().size(), 2U);
  run.Call("p", "set_tracked_tag", {"Cheese"});
  run.Ticks(1);
  const Json near = *run.Data("p").Find("near_robots");
  EXPECT_NEAR(near.Find("crumb")->AsDouble(), 1.0, 1e-12);
  EXPECT_NEAR(near.Find("mouse")->AsDouble(), 5.0, 1e-12);
  EXPECT_EQ(near.Find("cat"), nullptr);
  EXPECT_THROW(run.Call("p", "set_range", {-1}), WrongArgument);
}

TEST(MorseThermometerTest, FiresWarmByTheirDistance) {
  Trial run(Scene(R"({"name": "t", "type": "Thermometer"})", R"({"x": 0, "y": 0})",
                  Other("oven", 3, 4, R"(, "properties": {"Fire": true})"),
                  R"("props": [{"name": "fire", "file": "fire", "position": [10, 0, 0.1],
                              "properties": {"Fire": 500.0}}],)"));
  run.Data("t");
  EXPECT_NEAR(run.Number("t", "temperature"),
              15.0 + 200.0 * std::exp(-0.2 * 5.0) + 500.0 * std::exp(-0.2 * 10.0), 1e-9);
  run.Get("t").SetProperty("Range", 7.0);
  run.Ticks(1);
  run.Data("t");
  EXPECT_NEAR(run.Number("t", "temperature"), 15.0 + 200.0 * std::exp(-1.0), 1e-9);
}

TEST(MorseRadarAltimeterTest, HeightAboveTheFloorAndNothingBeyondItsRange) {
  Trial run(Scene(R"({"name": "r", "type": "RadarAltimeter", "position": [0.2, 0, 2],
                    "rotation": [0, 1, 0]})"));
  run.Data("r");
  EXPECT_NEAR(run.Number("r", "z"), 2.1, 1e-6);
  run.Get("r").SetProperty("MaxRange", 2.0);
  run.Ticks(1);
  run.Data("r");
  EXPECT_NE(run.Get("r").LocalData().find("\"z\": Infinity"), std::string::npos);
}

TEST(MorseOdometryTest, LevelsRawAndDifferentialInTheFrameOfTheStart) {
  Trial run(Scene(R"({"name": "raw", "type": "Odometry", "level": "raw"},
                   {"name": "diff", "type": "Odometry", "level": "differential"},
                   {"name": "slow", "type": "Odometry", "level": "raw", "frequency": 10},)" +
                      kXyw,
                  R"({"x": 1, "y": 2, "yaw": 1.5707963267948966})"));
  run.Send("motion", R"({"x": 3.0, "y": -4.0, "w": 0})");
  run.Ticks(12);
  const Json data = run.Data("diff");
  EXPECT_NEAR(data.Find("dx")->AsDouble(), 3.0 * kStep, 1e-12);
  EXPECT_NEAR(data.Find("dy")->AsDouble(), -4.0 * kStep, 1e-12);
  EXPECT_NEAR(data.Find("dyaw")->AsDouble(), 0.0, 1e-12);
  EXPECT_NEAR(run.Number("raw", "dS"), 5.0 * kStep, 1e-12);
  EXPECT_NEAR(run.Number("slow", "dS"), 5.0 * 0.1, 1e-12);
  run.Send("motion", R"({"x": 0, "y": 0, "w": 1.2})");
  run.Ticks(2);
  run.Data("diff");
  EXPECT_NEAR(run.Number("diff", "dyaw"), 1.2 * kStep, 1e-12);
  EXPECT_EQ(run.Get("diff").type(), "Odometry");
  EXPECT_EQ(run.Get("raw").type(), "RawOdometry");
}

TEST(MorseCollisionTest, NamesWhatItTouchesAndIsSilentOtherwise) {
  Trial run(Scene(R"({"name": "c", "type": "Collision"}, {"name": "only", "type": "Collision",
                    "properties": {"only_objects_with_property": "Soft"}},)" +
                      kXyw,
                  R"({"x": 0, "y": 0})", Other("wall", 1, 0)));
  run.Data("c");
  const auto& sensor = dynamic_cast<const Sensor&>(run.Get("c"));
  EXPECT_FALSE(sensor.HasNews());
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0})");
  run.Ticks(60);
  run.Data("c");
  EXPECT_TRUE(sensor.HasNews());
  EXPECT_NE(run.Get("c").LocalData().find(R"("collision": true, "objects": "wall")"),
            std::string::npos);
  EXPECT_FALSE(dynamic_cast<const Sensor&>(run.Get("only")).HasNews());
  run.Send("motion", R"({"x": -1.0, "y": 0, "w": 0})");
  run.Ticks(2);
  run.Data("c");
  EXPECT_FALSE(sensor.HasNews());
}

TEST(MorseGpsTest, SimpleIsTheSensorsPlace) {
  Trial run(Scene(R"({"name": "gps", "type": "GPS", "position": [1, 0, 0.4]})",
                  R"({"x": 2, "y": 3, "yaw": 1.5707963267948966})"));
  run.Data("gps");
  EXPECT_NEAR(run.Number("gps", "x"), 2.0, 1e-12);
  EXPECT_NEAR(run.Number("gps", "y"), 4.0, 1e-12);
  EXPECT_NEAR(run.Number("gps", "z"), 0.5, 1e-12);
}

TEST(MorseGpsTest, RawAndExtendedAreOnTheEarth) {
  const std::string geodesy = R"("geodesy": {"longitude": 1.5, "latitude": 43.6,
                                             "altitude": 150.0},)";
  Trial run(Scene(R"({"name": "raw", "type": "GPS", "level": "raw"},
                   {"name": "ext", "type": "GPS", "level": "extended"},)" +
                      kXyw,
                  R"({"x": 0, "y": 0})", "", geodesy));
  Json data = run.Data("ext");
  EXPECT_NEAR(data.Find("longitude")->AsDouble(), 1.5, 1e-12);
  EXPECT_NEAR(data.Find("latitude")->AsDouble(), 43.6, 1e-12);
  EXPECT_NEAR(data.Find("altitude")->AsDouble(), 150.1, 1e-6);
  EXPECT_EQ(*data.Find("date"), Json("010170"));
  EXPECT_EQ(*data.Find("time"), Json("000000"));
  EXPECT_NE(run.Get("ext").LocalData().find("\"heading\": Infinity"), std::string::npos);
  EXPECT_EQ(run.Shown("raw").Find("date"), nullptr);
  // South-east at 1 m/s each: heading 135 degrees.
  run.Send("motion", R"({"x": 1.0, "y": -1.0, "w": 0})");
  run.Ticks(120);
  data = run.Data("ext");
  ExpectVector(data, "velocity", 1.0, -1.0, 0.0);
  EXPECT_NEAR(data.Find("heading")->AsDouble(), 135.0, 1e-9);
  EXPECT_EQ(*data.Find("time"), Json("000002"));
  // 2 m east and south by the radii of curvature of WGS84 at 43.6 degrees and 150 m up.
  const double e2 = 0.00669437999014;
  const double s = std::sin(Radians(43.6));
  const double n = 6378137.0 / std::sqrt(1.0 - e2 * s * s);
  const double m = 6378137.0 * (1.0 - e2) / std::pow(1.0 - e2 * s * s, 1.5);
  EXPECT_NEAR(data.Find("longitude")->AsDouble() - 1.5,
              Degrees(2.0 / ((n + 150.0) * std::cos(Radians(43.6)))), 1e-10);
  EXPECT_NEAR(data.Find("latitude")->AsDouble() - 43.6, -Degrees(2.0 / (m + 150.0)), 1e-10);
}

TEST(MorseGpsTest, RawNeedsToKnowWhereTheWorldLies) {
  EXPECT_THROW(Trial(Scene(R"({"name": "raw", "type": "GPS", "level": "raw"})")), Error);
}

TEST(MorseGpsTest, TheXAxisMayPointAnywhere) {
  scene::GeodesyDef def;
  def.angle_against_north = 0.0;  // x points north
  const Vec3 enu = Geodesy(def).ToEnu({1.0, 2.0, 3.0});
  EXPECT_NEAR(enu.x, -2.0, 1e-12);
  EXPECT_NEAR(enu.y, 1.0, 1e-12);
  EXPECT_NEAR(enu.z, 3.0, 1e-12);
}

TEST(MorseMotionTest, XywGoesInAnyDirectionAndVwDiffLeavesOutTheTiny) {
  Trial run(Scene(R"({"name": "diff", "type": "MotionVWDiff"},)" + kXyw));
  run.Send("motion", R"({"x": 1.0, "y": 2.0, "w": 0})");
  run.Ticks(60);
  EXPECT_NEAR(run.pose().x, 1.0, 1e-9);
  EXPECT_NEAR(run.pose().y, 2.0, 1e-9);
  run.Call("diff", "set_speed", {0.5, 1.0});
  run.Ticks(60);
  EXPECT_NEAR(run.pose().yaw, 1.0, 1e-9);
  // A circle of radius 0.5.
  EXPECT_NEAR(run.pose().x, 1.0 + 0.5 * std::sin(1.0), 1e-9);
  EXPECT_NEAR(run.pose().y, 2.0 + 0.5 * (1.0 - std::cos(1.0)), 1e-9);
  const Pose2 before = run.pose();
  run.Send("diff", R"({"v": 0.0009, "w": 0.0009})");
  run.Ticks(60);
  EXPECT_EQ(run.pose().yaw, before.yaw);
  EXPECT_EQ(run.pose().x, before.x);
}

TEST(MorseDestinationTest, StraightThereWithoutTurning) {
  Trial run(Scene(R"({"name": "to", "type": "Destination", "properties": {"Speed": 2}})",
                  R"({"x": 0, "y": 0, "yaw": 1.0})"));
  run.Get("to").SetProperty("Tolerance", 0.01);
  run.Send("to", R"({"x": 3.0, "y": 4.0, "z": 0.0})");
  run.Ticks(60);
  EXPECT_NEAR(std::hypot(run.pose().x, run.pose().y), 2.0, 1e-9);
  EXPECT_NEAR(run.pose().y / run.pose().x, 4.0 / 3.0, 1e-9);
  run.Ticks(120);
  EXPECT_NEAR(run.pose().x, 3.0, 0.01);
  EXPECT_NEAR(run.pose().y, 4.0, 0.01);
  EXPECT_EQ(run.pose().yaw, 1.0);
}

TEST(MorseOrientationTest, AtOnceOrWithASpeed) {
  Trial run(Scene(R"({"name": "o", "type": "Orientation"},
                   {"name": "slow", "type": "Orientation", "properties": {"speed": 0.5}})"));
  EXPECT_EQ(run.Number("o", "yaw"), 0.0);
  run.Send("o", R"({"yaw": 2.0, "pitch": 0, "roll": 0})");
  run.Ticks(1);
  EXPECT_NEAR(run.pose().yaw, 2.0, 1e-12);
  run.Get("o").set_active(false);
  run.Send("slow", R"({"yaw": 1.0, "pitch": 0, "roll": 0})");
  run.Ticks(60);
  EXPECT_NEAR(run.pose().yaw, 1.5, 1e-9);
  run.Ticks(120);
  EXPECT_NEAR(run.pose().yaw, 1.0, 0.02 + 1e-9);
}

TEST(MorseTeleportTest, PutsTheActuatorThereAndHoldsTheRobot) {
  Trial run(Scene(R"({"name": "t", "type": "Teleport", "position": [1, 0, 0]},)" + kXyw));
  EXPECT_NEAR(run.Number("t", "x"), 1.0, 1e-12);
  run.Send("t", R"({"x": 5, "y": 6, "z": 0, "yaw": 1.5707963267948966, "pitch": 0, "roll": 0})");
  run.Ticks(1);
  EXPECT_NEAR(run.pose().x, 5.0, 1e-12);
  EXPECT_NEAR(run.pose().y, 5.0, 1e-12);
  EXPECT_NEAR(run.pose().yaw, kPi / 2.0, 1e-12);
  run.Call("t", "translate", {1.0, -2.0});
  run.Call("t", "rotate", {0.0, 0.0, kPi / 2.0});
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0})");
  run.Ticks(60);
  EXPECT_NEAR(run.pose().x, 7.0, 1e-9);
  EXPECT_NEAR(run.pose().y, 4.0, 1e-9);
  EXPECT_THROW(run.Call("t", "translate", {1e9}), WrongArgument);
}

TEST(MorseLightTest, ToggleAlwaysAnswersTrue) {
  Trial run(Scene(R"({"name": "l", "type": "Light"}, {"name": "s", "type": "Sound"})"));
  EXPECT_EQ(*run.Shown("l").Find("emit"), Json(true));
  EXPECT_EQ(run.Call("l", "toggle"), Json(true));
  EXPECT_EQ(*run.Shown("l").Find("emit"), Json(false));
  EXPECT_EQ(run.Call("l", "toggle", {false}), Json(true));
  EXPECT_EQ(*run.Shown("l").Find("emit"), Json(false));
  run.Send("s", R"({"mode": "pause"})");
  EXPECT_EQ(*run.Shown("s").Find("mode"), Json("pause"));
  EXPECT_THROW(run.Send("s", R"({"mode": "loud"})"), WrongArgument);
}

TEST(MorseWaypointTest, SetPropertyWidensTheAngleAndRemains) {
  Trial run(Scene(R"({"name": "w", "type": "Waypoint"}, {"name": "t", "type": "Teleport"})"));
  run.Get("t").set_active(false);
  run.Get("w").SetProperty("RemainAtDestination", true);
  run.Send("w", R"({"x": 2, "y": 0, "z": 0, "tolerance": 0.1})");
  run.Ticks(300);
  EXPECT_NEAR(run.pose().x, 2.0, 0.1);
  run.simulation().FindRobot("robot")->Place({0.0, 0.0, 0.0});
  run.Ticks(300);
  EXPECT_NEAR(run.pose().x, 2.0, 0.1);
}

TEST(MorsePropertiesTest, OfTheScriptAndOfSetPropertyAreChecked) {
  Trial run(Scene(R"({"name": "o", "type": "Orientation"})"));
  Component& component = run.Get("o");
  EXPECT_EQ(component.Properties().Dump(),
            R"({"speed": Infinity, "tolerance": 0.02, "ControlType": "Velocity"})");
  component.SetProperty("speed", 1);
  component.SetProperty("speed", "inf");
  EXPECT_THROW(component.SetProperty("speed", -1), WrongArgument);
  EXPECT_THROW(component.SetProperty("speed", "fast"), WrongArgument);
  EXPECT_THROW(component.SetProperty("ControlType", "Force"), WrongArgument);
  EXPECT_THROW(component.SetProperty("colour", 1), WrongArgument);
  EXPECT_EQ(component.Configurations(), component.Properties());
  // One that the simulator has not is of no effect, one with a wrong value an error.
  Trial(Scene(R"({"name": "o", "type": "Orientation", "properties": {"colour": 1}})"));
  EXPECT_THROW(Trial(Scene(R"({"name": "o", "type": "Orientation", "properties": {"speed": -1}})")),
               Error);
}

TEST(MorseComponentsTest, SayTheSameAfterTheirScenarioHasBeenWritten) {
  const scene::Scenario scenario = scene::ParseScenario(
      Scene(R"({"name": "g", "type": "GPS", "level": "raw", "properties": {"a": 1}})",
            R"({"x": 0, "y": 0})", Other("b", 3, 0, R"(, "properties": {"Fire": 5.0})"),
            R"("zones": [{"type": "Charging", "position": [1, 2, 3], "half_size": [4, 5, 6]}],
               "geodesy": {"longitude": 1, "latitude": 2, "altitude": 3},)"),
      "test.json");
  const std::string text = scene::ToJson(scenario).Dump();
  EXPECT_EQ(scene::ToJson(scene::ParseScenario(text, "test.json")).Dump(), text);
  EXPECT_NE(text.find(R"("level": "raw")"), std::string::npos);
  EXPECT_NE(text.find(R"("half_size": [4.0, 5.0, 6.0])"), std::string::npos);
}

}  // namespace
}  // namespace ccmorse::sim
