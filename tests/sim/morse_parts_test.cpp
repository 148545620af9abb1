// MORSE's sensors, actuators and modifiers of what is felt, carried, found and said in other
// coordinates, against calculations of their own (specs: morse.md B.2, B.3, B.5).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/euler.h"
#include "base/json.h"
#include "base/trig.h"
#include "scene/magnetic_field.h"
#include "sim/robots/robot_skills.h"
#include "sim/sensors/geodesy.h"
#include "sim/sensors/magnetic_field.h"
#include "tests/sim/morse_trial.h"

namespace ccmorse::sim {
namespace {

const std::string kXyw = R"({"name": "motion", "type": "MotionXYW"})";
const std::string kEarth =
    R"("geodesy": {"longitude": 1.5, "latitude": 43.6, "altitude": 150, "angle_against_north": 90},)";

// --- Rotations

TEST(EulerTest, AnglesOfARotationGiveItAgain) {
  for (double roll = -3.0; roll < 3.1; roll += 0.75) {
    for (double pitch = -1.5; pitch < 1.6; pitch += 0.5) {
      for (double yaw = -3.0; yaw < 3.1; yaw += 0.75) {
        const Vec3 euler = ToEuler(FromEuler(roll, pitch, yaw));
        EXPECT_NEAR(euler.x, roll, 1e-13);
        EXPECT_NEAR(euler.y, pitch, 1e-13);
        EXPECT_NEAR(euler.z, yaw, 1e-13);
      }
    }
  }
  // Looking straight down, only one of roll and yaw can be told.
  const Vec3 down = ToEuler(FromEuler(0.0, kPi / 2.0, 0.7));
  EXPECT_NEAR(down.y, kPi / 2.0, 1e-12);
  EXPECT_NEAR(down.z, 0.7, 1e-9);
}

// --- The Earth's magnetic field

// North, east and down of a point dipole at the Earth's centre: (3 (m.e) e - m) / r^3 (J. D.
// Jackson, Classical Electrodynamics, 5.56), with the moment (g11, h11, g10) a^3 of the first three
// terms.
Vec3 Dipole(double longitude, double latitude, double altitude) {
  const double a = 6371200.0;
  const Vec3 moment = a * a * a * Vec3{-1501.1, 4796.2, -29438.5};
  const Vec3 at = Geodesy::EcefFromGeodetic({longitude, latitude, altitude});
  const double r = std::sqrt(Dot(at, at));
  const Vec3 e = (1.0 / r) * at;
  const Vec3 field = (1.0 / (r * r * r)) * (3.0 * Dot(moment, e) * e - moment);
  const double lon = longitude * kPi / 180.0;
  const double lat = latitude * kPi / 180.0;
  const Vec3 east{-std::sin(lon), std::cos(lon), 0.0};
  const Vec3 up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
  const Vec3 north = Cross(up, east);
  return {Dot(field, north), Dot(field, east), -Dot(field, up)};
}

TEST(MagneticFieldTest, TheFirstDegreeIsADipole) {
  const MagneticField field{scene::MagneticFieldDef{}};
  for (double latitude = -90.0; latitude <= 90.0; latitude += 22.5) {
    for (double longitude = -180.0; longitude <= 180.0; longitude += 37.0) {
      const Vec3 got = field.NorthEastDown({longitude, latitude, 5000.0}, 2015.0);
      const Vec3 expected = Dipole(longitude, latitude, 5000.0);
      EXPECT_NEAR(got.x, expected.x, 1e-6);
      EXPECT_NEAR(got.y, expected.y, 1e-6);
      EXPECT_NEAR(got.z, expected.z, 1e-6);
    }
  }
}

TEST(MagneticFieldTest, TheFieldIsTheSlopeOfThePotential) {
  // Every term by itself: the field against differences of V = a sum (a/r)^(n+1) (g cos + h sin) P,
  // with Legendre functions of the standard library.
  for (int n = 1; n <= 12; ++n) {
    for (int m = 0; m <= n; ++m) {
      scene::MagneticFieldDef def;
      def.terms = {{n, m, 100.0, m > 0 ? -40.0 : 0.0, 0.0, 0.0}};
      const auto potential = [&](const Vec3& at) {
        const double r = std::sqrt(Dot(at, at));
        const double lon = std::atan2(at.y, at.x);
        double scale = m == 0 ? 1.0 : std::sqrt(2.0);
        for (int k = n - m + 1; k <= n + m; ++k) scale /= std::sqrt(static_cast<double>(k));
        const double p = scale * std::assoc_legendre(static_cast<unsigned>(n),
                                                     static_cast<unsigned>(m), at.z / r);
        return 6371200.0 * std::pow(6371200.0 / r, n + 1) *
               (100.0 * std::cos(m * lon) + (m > 0 ? -40.0 : 0.0) * std::sin(m * lon)) * p;
      };
      const GeodeticPlace place{33.0, 51.0, 1000.0};
      const Vec3 at = Geodesy::EcefFromGeodetic(place);
      constexpr double kH = 100.0;  // m
      const Vec3 slope{
          (potential(at + Vec3{kH, 0, 0}) - potential(at - Vec3{kH, 0, 0})) / (2 * kH),
          (potential(at + Vec3{0, kH, 0}) - potential(at - Vec3{0, kH, 0})) / (2 * kH),
          (potential(at + Vec3{0, 0, kH}) - potential(at - Vec3{0, 0, kH})) / (2 * kH)};
      const double lon = place.longitude * kPi / 180.0;
      const double lat = place.latitude * kPi / 180.0;
      const Vec3 east{-std::sin(lon), std::cos(lon), 0.0};
      const Vec3 up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
      const Vec3 north = Cross(up, east);
      const Vec3 got = MagneticField(def).NorthEastDown(place, 2015.0);
      EXPECT_NEAR(got.x, -Dot(slope, north), 1e-4) << n << " " << m;
      EXPECT_NEAR(got.y, -Dot(slope, east), 1e-4) << n << " " << m;
      EXPECT_NEAR(got.z, Dot(slope, up), 1e-4) << n << " " << m;
    }
  }
}

TEST(MagneticFieldTest, TheModelOf2015AtItsPublishedPlaces) {
  const std::string file = "/usr/share/morse/data/WMM.COF";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not installed";
  const scene::MagneticFieldDef def = scene::LoadMagneticField(file);
  EXPECT_EQ(def.epoch, 2015.0);
  EXPECT_EQ(def.terms.size(), 90U);
  const MagneticField field(def);
  // Test values published with the World Magnetic Model 2015: year, altitude in km, latitude,
  // longitude; north, east, down in nT.
  const std::vector<std::array<double, 7>> published = {
      {2015.0, 0, 80, 0, 6627.1, -445.9, 54432.3},
      {2015.0, 0, 0, 120, 39518.2, 392.9, -11252.4},
      {2015.0, 0, -80, 240, 5797.3, 15761.1, -52919.1},
      {2015.0, 100, 80, 0, 6314.3, -471.6, 52269.8},
      {2015.0, 100, 0, 120, 37535.6, 364.4, -10773.4},
      {2015.0, 100, -80, 240, 5613.1, 14791.5, -50378.6},
      {2017.5, 0, 80, 0, 6599.4, -317.1, 54459.2},
      {2017.5, 0, 0, 120, 39571.4, 222.5, -11030.1},
      {2017.5, 0, -80, 240, 5873.8, 15781.4, -52687.9},
      {2017.5, 100, 80, 0, 6290.5, -348.5, 52292.7},
      {2017.5, 100, 0, 120, 37585.5, 209.5, -10564.2},
      {2017.5, 100, -80, 240, 5683.5, 14808.8, -50163.0}};
  for (const auto& [year, altitude, latitude, longitude, x, y, z] : published) {
    const Vec3 got = field.NorthEastDown({longitude, latitude, 1000.0 * altitude}, year);
    EXPECT_NEAR(got.x, x, 0.06) << year << " " << latitude;
    EXPECT_NEAR(got.y, y, 0.06) << year << " " << latitude;
    EXPECT_NEAR(got.z, z, 0.06) << year << " " << latitude;
  }
}

TEST(MagneticFieldTest, FilesThatAreNoneAreRefusedByLine) {
  const auto complaint = [](const std::string& text) {
    try {
      scene::ParseMagneticField(text, "f.cof");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(complaint(""), "f.cof:0: ends without any term");
  EXPECT_NE(complaint("hello\n").find("f.cof:1: begins with no year"), std::string::npos);
  EXPECT_NE(complaint("2015.0 X 1\n 1 2 3 4 5 6\n").find("f.cof:2: "), std::string::npos);
  EXPECT_NE(complaint("2015.0 X 1\n 99 2 3 4 5 6\n").find("f.cof:2: "), std::string::npos);
  EXPECT_NE(complaint("2015.0 X 1\n 1 0 nan 4 5 6\n").find("f.cof:2: "), std::string::npos);
  EXPECT_EQ(complaint("2015.0 X 1\n 1 0 -3e4 0 5 0\n99999\nrubbish"), "accepted");
}

TEST(MorseMagnetometerTest, TheFieldTurnedIntoTheSensor) {
  Trial run(Scene(R"({"name": "m", "type": "Magnetometer"},
                   {"name": "turned", "type": "Magnetometer", "rotation": [0, 0, 0.5]},
                   {"name": "later", "type": "Magnetometer", "properties": {"date": 2020.0}})",
                  R"({"x": 0, "y": 0})", "", kEarth));
  run.Ticks(1);
  const Vec3 felt = Dipole(1.5, 43.6, 150.1);
  EXPECT_NEAR(run.Number("m", "x"), felt.x, 1e-6);
  EXPECT_NEAR(run.Number("m", "y"), felt.y, 1e-6);
  EXPECT_NEAR(run.Number("m", "z"), felt.z, 1e-6);
  EXPECT_NEAR(run.Number("turned", "x"), std::cos(0.5) * felt.x + std::sin(0.5) * felt.y, 1e-6);
  EXPECT_NEAR(run.Number("turned", "y"), std::cos(0.5) * felt.y - std::sin(0.5) * felt.x, 1e-6);
  // The dipole becomes weaker from year to year.
  const auto strength = [&](const std::string& name) {
    return std::hypot(run.Number(name, "x"), run.Number(name, "y"), run.Number(name, "z"));
  };
  EXPECT_LT(strength("later"), strength("m") - 20.0);
  EXPECT_EQ(*run.Get("m").Properties().Find("date"), Json());
  run.Get("m").SetProperty("date", Json(2020));
  run.Ticks(1);
  EXPECT_NEAR(strength("m"), strength("later"), 1e-9);
  run.Get("m").SetProperty("date", Json());
  EXPECT_THROW(run.Get("m").SetProperty("date", Json("now")), WrongArgument);
}

TEST(MagneticFieldTest, AScenarioKeepsItAndTheModifiers) {
  const std::string text = Scene(
      R"({"name": "p", "type": "Pose", "modifiers": [{"type": "UTM", "settings":
          {"x_offset": "5"}}, {"type": "feet"}]})",
      R"({"x": 0, "y": 0})", "",
      R"("magnetic_field": {"epoch": 2010, "date": 2012.5, "terms": [[1, 0, -3e4, 0, 10, 0],
          [2, 1, 5, 6, 7, 8]]},)");
  const scene::Scenario scenario = scene::ParseScenario(text, "a.json");
  EXPECT_EQ(scenario.magnetic_field.date, 2012.5);
  ASSERT_EQ(scenario.magnetic_field.terms.size(), 2U);
  EXPECT_EQ(scenario.magnetic_field.terms[1].h_rate, 8.0);
  const std::string written = scene::ToJson(scenario).Dump();
  const scene::Scenario again = scene::ParseScenario(written, "b.json");
  EXPECT_EQ(again.magnetic_field, scenario.magnetic_field);
  EXPECT_EQ(scene::ToJson(again).Dump(), written);
  const auto with = [](const std::string& field) {
    return Scene("", R"({"x": 0, "y": 0})", "", R"("magnetic_field": )" + field + ",");
  };
  EXPECT_THROW(scene::ParseScenario(with(R"({"epoch": 2010, "terms": [[1, 2, 0, 0, 0, 0]]})"), "c"),
               Error);
  EXPECT_THROW(scene::ParseScenario(with(R"({"file": "no_such.cof"})"), "c"), Error);
}

TEST(MorseMagnetometerTest, AWorldThatLiesNowhereIsAnError) {
  try {
    Trial run(Scene(R"({"name": "m", "type": "Magnetometer"})"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("robot.m needs to know where on the Earth"),
              std::string::npos);
  }
  // An IMU measures other things, too.
  Trial run(Scene(R"({"name": "m", "type": "IMU"})"));
  run.Ticks(1);
  ExpectVector(run.Shown("m"), "linear_acceleration", 0.0, 0.0, 9.81);
  ExpectVector(run.Shown("m"), "magnetic_field", 0.0, 0.0, 0.0);
}

TEST(MorseImuTest, GravityAStartACircleAndTheField) {
  Trial run(Scene(R"({"name": "imu", "type": "IMU"}, {"name": "down", "type": "IMU",
                    "rotation": [0, 1.5707963267948966, 0]},
                   {"name": "p", "type": "IMU", "properties": {"ComputationMode": "Position"}},)" +
                      kXyw,
                  R"({"x": 0, "y": 0})", "", kEarth));
  run.Ticks(2);
  ExpectVector(run.Shown("imu"), "linear_acceleration", 0.0, 0.0, 9.81);
  // One that looks down has up behind it.
  ExpectVector(run.Shown("down"), "linear_acceleration", -9.81, 0.0, 0.0);
  const Vec3 felt = Dipole(1.5, 43.6, 150.1);
  ExpectVector(run.Shown("imu"), "magnetic_field", felt.x, felt.y, felt.z, 1e-6);
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0.0})");
  run.Ticks(1);
  for (const char* name : {"imu", "p"}) {
    ExpectVector(run.Data(name), "linear_acceleration", 60.0, 0.0, 9.81, 1e-9);
  }
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0.5})");
  run.Ticks(3);
  ExpectVector(run.Data("imu"), "linear_acceleration", 0.0, 0.5, 9.81, 0.005);
  ExpectVector(run.Shown("imu"), "angular_velocity", 0.0, 0.0, 0.5);
  ExpectVector(run.Shown("down"), "angular_velocity", -0.5, 0.0, 0.0);
}

// --- Modifiers

std::string Modified(const std::string& type, const std::string& modifier,
                     const std::string& settings = "{}", const std::string& name = "s") {
  return R"({"name": ")" + name + R"(", "type": ")" + type + R"(", "modifiers": [{"type": ")" +
         modifier + R"(", "settings": )" + settings + "}]}";
}

TEST(MorseModifierTest, NedOfPlacesAndAngles) {
  Trial run(Scene(Modified("Pose", "NED") + "," + Modified("GPS", "NED", "{}", "gps") + "," +
                      Modified("Gyroscope", "NED", "{}", "gyro"),
                  R"({"x": 2, "y": 5, "yaw": 0.25})"));
  run.Ticks(1);
  for (const char* name : {"s", "gps"}) {
    EXPECT_EQ(run.Number(name, "x"), 5.0);
    EXPECT_EQ(run.Number(name, "y"), 2.0);
    EXPECT_EQ(run.Number(name, "z"), -0.1);
  }
  EXPECT_EQ(run.Number("s", "yaw"), 0.25);  // MORSE changes the place only
  EXPECT_NEAR(run.Number("gyro", "roll"), kPi / 2.0 - 0.25, 1e-15);
  EXPECT_EQ(run.Number("gyro", "yaw"), 0.0);
}

TEST(MorseModifierTest, EarthFrames) {
  Trial run(Scene(Modified("Pose", "ECEF") + "," + Modified("Pose", "geodetic", "{}", "geo") + "," +
                      Modified("Pose", "geocentric", "{}", "centric"),
                  R"({"x": 15, "y": -12})", "", kEarth));
  run.Ticks(1);
  // By the textbook: the origin on WGS84, then 15 m east, 12 m south, 0.1 m up of it.
  const double lon = 1.5 * kPi / 180.0;
  const double lat = 43.6 * kPi / 180.0;
  const double a = 6378137.0;
  const double e2 = 8.181919191e-2 * 8.181919191e-2;
  const double n = a / std::sqrt(1.0 - e2 * std::sin(lat) * std::sin(lat));
  const Vec3 east{-std::sin(lon), std::cos(lon), 0.0};
  const Vec3 up{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
  const Vec3 origin{(n + 150.0) * up.x, (n + 150.0) * up.y,
                    (n * (1.0 - e2) + 150.0) * std::sin(lat)};
  const Vec3 at = origin + 15.0 * east - 12.0 * Cross(up, east) + 0.1 * up;
  EXPECT_NEAR(run.Number("s", "x"), at.x, 1e-6);
  EXPECT_NEAR(run.Number("s", "y"), at.y, 1e-6);
  EXPECT_NEAR(run.Number("s", "z"), at.z, 1e-6);
  // From geodetic back by the definition of the ellipsoid.
  const double lon2 = run.Number("geo", "x") * kPi / 180.0;
  const double lat2 = run.Number("geo", "y") * kPi / 180.0;
  const double n2 = a / std::sqrt(1.0 - e2 * std::sin(lat2) * std::sin(lat2));
  const double h = run.Number("geo", "z");
  EXPECT_NEAR((n2 + h) * std::cos(lat2) * std::cos(lon2), at.x, 1e-6);
  EXPECT_NEAR((n2 + h) * std::cos(lat2) * std::sin(lon2), at.y, 1e-6);
  EXPECT_NEAR((n2 * (1.0 - e2) + h) * std::sin(lat2), at.z, 1e-6);
  EXPECT_NEAR(run.Number("centric", "x"), std::atan2(at.y, at.x) * 180.0 / kPi, 1e-12);
  EXPECT_NEAR(run.Number("centric", "y"), std::atan2(at.z, std::hypot(at.x, at.y)) * 180.0 / kPi,
              1e-12);
  EXPECT_NEAR(run.Number("centric", "z"), std::sqrt(Dot(at, at)), 1e-6);
}

TEST(MorseModifierTest, UtmAndFeet) {
  Trial run(Scene(Modified("Pose", "UTM", R"({"x_offset": "1000.5", "y_offset": -3})") + "," +
                      Modified("Pose", "feet", "{}", "f"),
                  R"({"x": 2, "y": 5})"));
  run.Ticks(1);
  EXPECT_EQ(run.Number("s", "x"), 1002.5);
  EXPECT_EQ(run.Number("s", "y"), 2.0);
  EXPECT_EQ(run.Number("s", "z"), 0.1);
  EXPECT_NEAR(run.Number("f", "y"), 5.0 * 3.2808399, 1e-12);
}

// What a sensor says in other coordinates takes an actuator there that hears the same ones.
TEST(MorseModifierTest, ActuatorsUndoWhatSensorsDo) {
  for (const char* type : {"NED", "ECEF", "geodetic", "geocentric", "UTM", "feet"}) {
    const std::string settings = std::string(type) == "UTM" ? R"({"x_offset": 500})" : "{}";
    Trial run(Scene(Modified("Pose", type, settings) + "," +
                        Modified("Teleport", type, settings, "teleport") +
                        R"(, {"name": "pose", "type": "Pose"})",
                    R"({"x": 3, "y": -4, "yaw": 0.5})", "", kEarth));
    run.Ticks(1);
    const Json said = run.Shown("s");
    run.Send("teleport", R"({"x": )" + said.Find("x")->Dump() + R"(, "y": )" +
                             said.Find("y")->Dump() + R"(, "z": )" + said.Find("z")->Dump() +
                             R"(, "yaw": 0.5, "pitch": 0, "roll": 0})");
    run.Ticks(2);
    EXPECT_NEAR(run.Number("pose", "x"), 3.0, 1e-6) << type;
    EXPECT_NEAR(run.Number("pose", "y"), -4.0, 1e-6) << type;
    EXPECT_NEAR(run.Number("teleport", "z"), 0.1, 1e-6) << type;
  }
  Trial run(Scene(Modified("Orientation", "NED")));
  run.Send("s", R"({"yaw": 0.0, "pitch": 0.0, "roll": 0.25})");
  run.Ticks(1);
  EXPECT_NEAR(run.pose().yaw, kPi / 2.0 - 0.25, 1e-12);
}

TEST(MorseModifierTest, GeodesyWithoutAPlaceIsAnError) {
  EXPECT_THROW(Trial(Scene(Modified("Pose", "ECEF"))), Error);
  EXPECT_NO_THROW(Trial(
      Scene(Modified("Pose", "ECEF", R"({"longitude": 1, "latitude": "2.5", "altitude": 3})"))));
  EXPECT_THROW(Trial(Scene(Modified("Pose", "UTM", R"({"x_offset": "far"})"))), Error);
  EXPECT_THROW(Trial(Scene(Modified("Pose", "PoseNoise", R"({"pos_std": -1})"))), Error);
  EXPECT_THROW(Trial(Scene(Modified("Pose", "Nonsense"))), Error);
}

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread SpreadOf(const std::vector<double>& numbers) {
  Spread spread;
  for (const double number : numbers) spread.mean += number / static_cast<double>(numbers.size());
  for (const double number : numbers) {
    spread.deviation += (number - spread.mean) * (number - spread.mean);
  }
  spread.deviation = std::sqrt(spread.deviation / static_cast<double>(numbers.size() - 1));
  return spread;
}

std::vector<double> Samples(Trial& run, const std::string& name, const std::string& field,
                            int count) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) {
    run.Ticks(1);
    numbers.push_back(run.Number(name, field));
  }
  return numbers;
}

TEST(MorseModifierTest, PoseNoiseHasItsMeanAndDeviationOnEveryAxis) {
  constexpr int kCount = 4000;
  const std::vector<std::pair<const char*, double>> expected = {
      {"x", 0.1}, {"y", 0.2}, {"z", 0.0}, {"yaw", 0.05}, {"pitch", 0.05}, {"roll", 0.05}};
  for (const auto& [field, deviation] : expected) {
    Trial run(Scene(
        Modified("Pose", "PoseNoise", R"({"pos_std": {"x": 0.1, "y": 0.2}, "rot_std": 0.05})"),
        R"({"x": 1, "y": 1, "yaw": 0})"));
    const Spread spread = SpreadOf(Samples(run, "s", field, kCount));
    const double truth = std::string(field).size() > 1 ? 0.0 : field[0] == 'z' ? 0.1 : 1.0;
    // Four standard errors of mean and deviation.
    EXPECT_NEAR(spread.mean, truth, 4.0 * deviation / std::sqrt(kCount) + 1e-12) << field;
    EXPECT_NEAR(spread.deviation, deviation, 4.0 * deviation / std::sqrt(2.0 * kCount) + 1e-12)
        << field;
  }
}

TEST(MorseModifierTest, NoiseOfASeedIsAlwaysTheSameAndOfTwoSensorsIsNot) {
  const std::string scene =
      Scene(Modified("Pose", "PoseNoise") + "," + Modified("Pose", "PoseNoise", "{}", "other") +
            "," + Modified("Pose", "PoseNoise", R"({"_2D": true})", "flat"));
  Trial one(scene);
  Trial two(scene);
  one.Ticks(20);
  two.Ticks(20);
  EXPECT_EQ(one.Get("s").LocalData(), two.Get("s").LocalData());
  EXPECT_EQ(one.simulation().Hash(), two.simulation().Hash());
  EXPECT_NE(one.Number("s", "x"), one.Number("other", "x"));
  EXPECT_EQ(one.Number("flat", "z"), 0.1);
  EXPECT_EQ(one.Number("flat", "roll"), 0.0);
  EXPECT_NE(one.Number("flat", "yaw"), 0.0);
}

TEST(MorseModifierTest, ImuNoise) {
  constexpr int kCount = 4000;
  Trial run(Scene(Modified("IMU", "IMUNoise", R"({"gyro_std": 0.02, "accel_std": {"z": 0.3}})"),
                  R"({"x": 0, "y": 0})", "", kEarth));
  std::vector<double> turning;
  std::vector<double> felt;
  for (int i = 0; i < kCount; ++i) {
    run.Ticks(1);
    turning.push_back(run.Shown("s").Find("angular_velocity")->AsArray()[0].AsDouble());
    const Json data = run.Shown("s");
    const Json::Array& acceleration = data.Find("linear_acceleration")->AsArray();
    felt.push_back(acceleration[2].AsDouble());
    EXPECT_EQ(acceleration[0].AsDouble(), 0.0);
  }
  EXPECT_NEAR(SpreadOf(turning).mean, 0.0, 4.0 * 0.02 / std::sqrt(kCount));
  EXPECT_NEAR(SpreadOf(turning).deviation, 0.02, 4.0 * 0.02 / std::sqrt(2.0 * kCount));
  EXPECT_NEAR(SpreadOf(felt).mean, 9.81, 4.0 * 0.3 / std::sqrt(kCount));
  EXPECT_NEAR(SpreadOf(felt).deviation, 0.3, 4.0 * 0.3 / std::sqrt(2.0 * kCount));
}

TEST(MorseModifierTest, OdometryOfWheelsOfAnotherSize) {
  Trial run(Scene(Modified("Odometry", "OdometryNoise", R"({"factor": 1.1})") + "," +
                  R"({"name": "raw", "type": "Odometry", "level": "raw", "modifiers":
                     [{"type": "OdometryNoise", "settings": {"factor": 0.5}}]},)" +
                  kXyw));
  run.Ticks(1);
  run.Send("motion", R"({"x": 1.0, "y": 0.5, "w": 0})");
  run.Ticks(60);
  run.Data("s");
  EXPECT_NEAR(run.Number("s", "x"), 1.1, 1e-9);
  EXPECT_NEAR(run.Number("s", "y"), 0.55, 1e-9);
  EXPECT_NEAR(run.Number("s", "vx"), 1.1, 1e-12);
  EXPECT_NEAR(run.Number("raw", "dS"), 0.5 * std::hypot(1.0, 0.5) * kStep, 1e-12);
  // Put right, it counts on from where it ought to be.
  run.Call("s", "reset_noise");
  run.Data("s");
  run.Ticks(1);
  run.Data("s");
  EXPECT_NEAR(run.Number("s", "x"), 1.0 + kStep, 0.1 * 2.1 * kStep);
}

TEST(MorseModifierTest, OdometryOfAGyroscopeThatDrifts) {
  constexpr double kDrift = 0.001;  // rad a sample
  Trial run(Scene(Modified("Odometry", "OdometryNoise", R"({"factor": 1, "gyro_drift": 0.001})") +
                  "," + kXyw));
  run.Ticks(1);
  run.Send("motion", R"({"x": 1.0, "y": 0, "w": 0})");
  run.Ticks(100);
  run.Data("s");
  double x = 0.0;
  double y = 0.0;
  // The first sample is where it begins, the second sees no motion yet; each but the first drifts.
  for (int i = 2; i <= 101; ++i) {
    x += kStep * std::cos(kDrift * i);
    y += kStep * std::sin(kDrift * i);
  }
  EXPECT_NEAR(run.Number("s", "yaw"), 101 * kDrift, 1e-12);
  EXPECT_NEAR(run.Number("s", "x"), x, 1e-9);
  EXPECT_NEAR(run.Number("s", "y"), y, 1e-9);
  EXPECT_NEAR(run.Number("s", "wz"), kDrift * 60.0, 1e-9);
}

// --- What moves and is carried

const std::string kPtu = R"({"name": "ptu", "type": "PTU", "position": [0.2, 0, 1.0],
    "rotation": [0, 0, 1.5707963267948966], "properties": {"Speed": 0.5, "Tolerance": 0.001}},
   {"name": "ptu.pose", "type": "Pose", "position": [0.2, 0.5, 1.0],
    "rotation": [0, 0, 1.5707963267948966]},
   {"name": "ptu.posture", "type": "PTUPosture"})";

TEST(MorsePtuTest, TurnsAtItsSpeedAndTakesAlongWhatIsMountedOnIt) {
  Trial run(Scene(kPtu, R"({"x": 1, "y": 2, "yaw": 0})"));
  run.Ticks(1);
  // At rest it looks left, and the sensor 0.5 m before it is to the left of the robot.
  EXPECT_NEAR(run.Number("ptu.pose", "x"), 1.2, 1e-12);
  EXPECT_NEAR(run.Number("ptu.pose", "y"), 2.5, 1e-12);
  const auto done = run.Start("ptu", "set_pan_tilt", {kPi / 2.0, 0.3});
  run.Ticks(60);
  run.Data("ptu.posture");
  EXPECT_NEAR(run.Number("ptu.posture", "pan"), 0.5, 0.01);
  EXPECT_NEAR(run.Number("ptu.posture", "tilt"), 0.3, 0.002);
  EXPECT_TRUE(done->empty());
  run.Ticks(140);
  ASSERT_EQ(done->size(), 1U);
  EXPECT_EQ(done->front().outcome, Outcome::kSuccess);
  EXPECT_TRUE(done->front().value.IsNull());
  // Panned by another quarter it looks back, tilted down by 0.3 rad.
  run.Data("ptu.pose");
  EXPECT_NEAR(run.Number("ptu.pose", "x"), 1.2 - 0.5 * std::cos(0.3), 0.002);
  EXPECT_NEAR(run.Number("ptu.pose", "y"), 2.0, 0.002);
  EXPECT_NEAR(run.Number("ptu.pose", "z"), 1.1 - 0.5 * std::sin(0.3), 0.002);
  EXPECT_NEAR(std::fabs(run.Number("ptu.pose", "yaw")), kPi, 0.002);
  EXPECT_NEAR(run.Number("ptu.pose", "pitch"), 0.3, 0.002);
  const Json::Array pan_tilt = run.Call("ptu", "get_pan_tilt").AsArray();
  EXPECT_NEAR(pan_tilt[0].AsDouble(), kPi / 2.0, 0.001);
}

TEST(MorsePtuTest, LooksAtPointsAndObjectsAndANewOrderPreempts) {
  Trial run(Scene(kPtu + R"(,{"name": "ptu.eye", "type": "Pose", "position": [0.2, 0, 1.0],
                              "rotation": [0, 0, 1.5707963267948966]})",
                  R"({"x": 0, "y": 0, "yaw": 0.4})", Other("mouse", 3, 4)));
  const auto first = run.Start("ptu", "look_at_point", {-5.0, 1.0, 0.0});
  run.Ticks(2);
  const auto second = run.Start("ptu", "look_at_object", {"mouse"});
  ASSERT_EQ(first->size(), 1U);
  EXPECT_EQ(first->front().outcome, Outcome::kPreempted);
  run.Ticks(400);
  ASSERT_EQ(second->size(), 1U);
  EXPECT_EQ(second->front().outcome, Outcome::kSuccess);
  run.Data("ptu.eye");
  // From the eye to the mouse's origin, 0.1 m high.
  const double dx = 3.0 - run.Number("ptu.eye", "x");
  const double dy = 4.0 - run.Number("ptu.eye", "y");
  const double dz = 0.1 - run.Number("ptu.eye", "z");
  EXPECT_NEAR(run.Number("ptu.eye", "yaw"), std::atan2(dy, dx), 0.002);
  EXPECT_NEAR(run.Number("ptu.eye", "pitch"), -std::asin(dz / std::hypot(dx, dy, dz)), 0.002);
  EXPECT_THROW(run.Start("ptu", "look_at_object", {"cheese"}), ServiceFailed);
  const auto third = run.Start("ptu", "set_pan_tilt", {0.0, 0.0});
  run.Get("ptu").Interrupt();
  EXPECT_EQ(third->front().outcome, Outcome::kPreempted);
}

TEST(MorsePtuTest, WithManualNothingTurnsAndAPostureNeedsAPtu) {
  Trial run(Scene(kPtu));
  run.Get("ptu").SetProperty("Manual", Json(true));
  run.Send("ptu", R"({"pan": 1, "tilt": 0.5})");
  run.Ticks(10);
  EXPECT_EQ(run.Number("ptu.posture", "pan"), 0.0);
  EXPECT_THROW(run.Send("ptu", R"({"pan": 1})"), WrongArgument);
  EXPECT_THROW(Trial(Scene(R"({"name": "p", "type": "PTUPosture"})")), Error);
}

TEST(MorsePtuTest, AScannerOnItSeesWhereItIsTurnedTo) {
  // Four walls' worth: one robot straight ahead of the panned scanner, 3 m to the left.
  Trial run(Scene(R"({"name": "ptu", "type": "PTU", "position": [0, 0, 0.4], "properties":
                      {"Speed": 10}},
                     {"name": "ptu.scan", "type": "LaserScanner", "position": [0, 0, 0.4],
                      "frequency": 60, "laser": {"range": 10, "scan_window_deg": 2,
                      "resolution_deg": 1}})",
                  R"({"x": 0, "y": 0})",
                  R"(, {"name": "wall", "pose": {"x": 0, "y": 3}, "type": "Custom", "body":
      {"footprint": [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "hull":
       [{"outline": [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "bottom": 0,
         "top": 1}]}, "components": []})"));
  const auto middle = [&] {
    return run.Data("ptu.scan").Find("range_list")->AsArray()[1].AsDouble();
  };
  EXPECT_EQ(middle(), 10.0);
  run.Send("ptu", R"({"pan": 1.5707963267948966, "tilt": 0})");
  run.Ticks(60);
  EXPECT_NEAR(middle(), 2.75, 0.001);
  // Tilted down by 0.2 rad, 0.5 m above the floor, it meets the floor first.
  run.Send("ptu", R"({"pan": 1.5707963267948966, "tilt": 0.3})");
  run.Ticks(60);
  EXPECT_NEAR(middle(), 0.5 / std::sin(0.3), 0.08);
}

TEST(MorseGripperTest, TakesTheNearestGraspableAheadAndLetsItGo) {
  Trial run(Scene(R"({"name": "hand", "type": "Gripper", "position": [0.3, 0, 0.4]},
                     {"name": "near", "type": "Proximity", "frequency": 60, "properties":
                      {"Track": "Graspable", "Range": 100}},)" +
                      kXyw,
                  R"({"x": 0, "y": 0})", "",
                  R"("props": [
      {"name": "cup", "file": "c", "position": [0.7, 0, 0.5], "properties": {"Graspable": true}},
      {"name": "far", "file": "c", "position": [0.75, 0, 0.5], "properties": {"Graspable": true}},
      {"name": "behind", "file": "c", "position": [0.1, 0, 0.5], "properties": {"Graspable": true}},
      {"name": "stuck", "file": "c", "position": [0.5, 0, 0.5], "properties":
       {"Graspable": false}}],)"));
  EXPECT_EQ(run.Call("hand", "release"), Json(false));
  EXPECT_EQ(run.Call("hand", "grab"), Json("cup"));
  EXPECT_EQ(run.Call("hand", "grab"), Json("cup"));
  EXPECT_EQ(*run.Shown("hand").Find("grab"), Json(true));
  run.Send("motion", R"({"x": 0, "y": 0, "w": 1.5707963267948966})");
  run.Ticks(60);
  run.Send("motion", R"({"x": 0, "y": 0, "w": 0})");
  run.Ticks(1);
  const SceneObject& cup = *run.simulation().world().objects().Find("cup");
  EXPECT_NEAR(cup.WorldPosition().x, 0.0, 1e-9);
  EXPECT_NEAR(cup.WorldPosition().y, 0.7, 1e-9);
  EXPECT_NEAR(cup.WorldPosition().z, 0.5, 1e-12);
  EXPECT_NEAR(ToEuler(cup.WorldRotation()).z, kPi / 2.0, 1e-9);
  EXPECT_EQ(run.Call("hand", "release"), Json(true));
  run.Send("motion", R"({"x": -1, "y": 0, "w": 0})");
  run.Ticks(60);
  EXPECT_NEAR(cup.WorldPosition().y, 0.7, 1e-9);  // it stayed
  EXPECT_EQ(run.Call("hand", "grab"), Json());    // nothing within reach any more
  const Json data = run.Data("near");
  const Json& near = *data.Find("near_objects");
  EXPECT_NEAR(near.Find("cup")->AsDouble(), std::hypot(1.7, 0.4), 1e-6);
  run.simulation().ResetObjects();
  EXPECT_NEAR(cup.WorldPosition().x, 0.7, 1e-12);
}

TEST(MorseGripperTest, MessagesTakeAndLetGo) {
  Trial run(Scene(R"({"name": "hand", "type": "Gripper", "position": [0.3, 0, 0.4]})",
                  R"({"x": 0, "y": 0})", "",
                  R"("props": [{"name": "cup", "file": "c", "position": [0.7, 0, 0.5],
                                "properties": {"Graspable": true}}],)"));
  run.Send("hand", R"({"grab": true})");
  const SceneObject& cup = *run.simulation().world().objects().Find("cup");
  EXPECT_NE(cup.holder, nullptr);
  run.Send("hand", R"({"grab": false})");
  EXPECT_EQ(cup.holder, nullptr);
  EXPECT_THROW(run.Send("hand", R"({"grab": 1})"), WrongArgument);
  EXPECT_THROW(run.Send("hand", R"({})"), WrongArgument);
}

// --- What robots do themselves

// A service of the robot `name`'s own.
Json Ask(Trial& run, const std::string& name, const std::string& service,
         const Json::Array& arguments = {}) {
  Simulation& simulation = run.simulation();
  for (const Service& one : RobotSkills(*simulation.FindRobot(name), simulation.world())) {
    if (one.name == service) return one.run(arguments);
  }
  throw std::runtime_error("no service " + service);
}

TEST(MorseVictimTest, HealsItself) {
  Trial run(Scene(R"({"name": "sar", "type": "SearchAndRescue", "frequency": 60, "properties":
                      {"Heal_range": 5.0, "Abilities": "1", "Freq": 60}})",
                  R"({"x": 0, "y": 0})", Other("hurt", 4, 0, R"(, "skills": ["heal"], "properties":
                      {"Injured": true, "Requirements": "1,2,3", "Severity": 10})")));
  run.Ticks(1);
  EXPECT_EQ(run.Shown("sar").Find("victim_dict")->AsObject().size(), 1U);
  EXPECT_EQ(Ask(run, "hurt", "heal"), Json());
  run.Ticks(1);
  EXPECT_EQ(run.Shown("sar").Find("victim_dict")->Dump(), "{}");
  const SceneObject& hurt = *run.simulation().world().objects().Find("hurt");
  EXPECT_EQ(hurt.properties.Dump(), R"({"Injured": false, "Requirements": "", "Severity": 0})");
  run.simulation().ResetObjects();
  EXPECT_TRUE(hurt.Is("Injured"));
  EXPECT_THROW(Ask(run, "robot", "heal"), std::runtime_error);  // who is no victim
}

TEST(MorseHumanTest, GraspsWhatIsWithinReachAndCarriesIt) {
  std::string scene = Scene(R"({"name": "hand", "type": "Gripper", "position": [0.3, 0, 0.4],
                                "properties": {"Distance": 5, "Angle": 360}},)" +
                                kXyw,
                            R"({"x": 0, "y": 0})", Other("other", -3, 0), R"("props": [
      {"name": "cup", "file": "c", "position": [0.6, 0, 0.5], "properties": {"Graspable": true}},
      {"name": "pot", "file": "c", "position": [0, 0.6, 1.5], "properties": {"Graspable": true}},
      {"name": "far", "file": "c", "position": [1.1, 0, 0.5], "properties": {"Graspable": true}},
      {"name": "rock", "file": "c", "position": [0.5, 0, 0.5]}],)");
  const std::string key = R"("name": "robot",)";
  scene.replace(scene.find(key), key.size(), key + R"( "skills": ["grasp"],)");
  Trial run(scene);
  const auto grasp = [&](const Json& grab, const char* name) {
    return Ask(run, "robot", "grasp", {grab, name});
  };
  const auto why = [&](const char* name) -> std::string {
    try {
      grasp(true, name);
    } catch (const ServiceFailed& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why("nothing"), "Object 'nothing' does not appear in the scene.");
  EXPECT_EQ(why("far"), "Object 'far' is out of reach");
  EXPECT_EQ(why("rock"), "Object 'rock' is not graspable");
  EXPECT_EQ(why("other"), "Object 'other' is not graspable");
  EXPECT_THROW(grasp(1, "cup"), WrongArgument);
  EXPECT_EQ(grasp(false, "cup"), Json(false));
  EXPECT_EQ(grasp(true, "cup"), Json(true));
  EXPECT_EQ(grasp("true", "cup"), Json(false));
  EXPECT_EQ(why("pot"), "robot holds 'cup' already");
  run.Send("motion", R"({"x": 0, "y": 0, "w": 1.5707963267948966})");
  run.Ticks(60);
  run.Send("motion", R"({"x": 1, "y": 0, "w": 0})");
  run.Ticks(60);
  const SceneObject& cup = *run.simulation().world().objects().Find("cup");
  EXPECT_NEAR(cup.WorldPosition().x, 0.0, 1e-9);
  EXPECT_NEAR(cup.WorldPosition().y, 1.6, 1e-9);
  EXPECT_NEAR(cup.WorldPosition().z, 0.5, 1e-12);
  EXPECT_NEAR(ToEuler(cup.WorldRotation()).z, kPi / 2.0, 1e-9);
  EXPECT_EQ(grasp("false", "cup"), Json(true));
  run.Ticks(60);
  EXPECT_NEAR(cup.WorldPosition().y, 1.6, 1e-9);  // it stayed
  // What one has no other takes.
  EXPECT_EQ(grasp(true, "cup"), Json(true));
  EXPECT_NE(run.Call("hand", "grab"), Json("cup"));
  run.simulation().ResetObjects();
  EXPECT_EQ(run.Call("hand", "grab"), Json("cup"));
  EXPECT_EQ(why("cup"), "Object 'cup' is held by another");
}

// --- What is found

TEST(MorseSearchAndRescueTest, SeesHealsAndTellsWhatItCannot) {
  const std::string victim =
      R"(, "properties": {"Injured": true, "Requirements": "1,2,3", "Severity": 10})";
  Trial run(Scene(R"({"name": "sar", "type": "SearchAndRescue", "frequency": 6, "properties":
                      {"Heal_range": 2.0, "Abilities": "1,2"}},
                     {"name": "doctor", "type": "SearchAndRescue", "frequency": 60, "properties":
                      {"Heal_range": 5.0, "Abilities": "3"}},
                     {"name": "teleport", "type": "Teleport"})",
                  R"({"x": 0, "y": 0})",
                  Other("hurt", 4, 0, victim) + Other("well", 3, 0) + Other("aside", 4, 4, victim) +
                      Other("beyond", 14, 0, victim)));
  run.Ticks(1);
  Json data = run.Shown("sar");
  ASSERT_EQ(data.Find("victim_dict")->AsObject().size(), 1U);
  EXPECT_EQ(data.Find("victim_dict")->Find("hurt")->Dump(),
            R"({"coordinate": {"x": 4.0, "y": 0.0, "z": 0.1}, "requirements": [1, 2, 3], )"
            R"("severity": 10})");
  EXPECT_EQ(run.Call("sar", "get_robot_abilities").Dump(), "[1, 2]");
  EXPECT_EQ(run.Call("sar", "get_victim_requirements").Dump(), "[1, 2, 3]");
  EXPECT_EQ(run.Call("sar", "get_victim_severity"), Json(10));
  EXPECT_THROW(run.Start("sar", "heal"), ServiceFailed);  // 4 m away
  run.Call("teleport", "translate", {2.5});
  run.Ticks(1);
  const auto healed = run.Start("sar", "heal");
  EXPECT_THROW(run.Start("sar", "heal"), ServiceFailed);  // one at a time
  run.Ticks(85);
  EXPECT_TRUE(healed->empty());
  run.Ticks(20);  // ten activations of 6 Hz are 100 ticks
  ASSERT_EQ(healed->size(), 1U);
  EXPECT_EQ(healed->front().value, Json("Victim 'hurt' partially healed"));
  EXPECT_EQ(run.Call("sar", "get_victim_requirements").Dump(), "[3]");
  EXPECT_THROW(run.Start("sar", "heal"), ServiceFailed);  // that is for the doctor
  const auto cured = run.Start("doctor", "heal");
  run.Ticks(11);
  ASSERT_EQ(cured->size(), 1U);
  EXPECT_EQ(cured->front().value, Json("Victim 'hurt' healed"));
  EXPECT_THROW(run.Call("sar", "get_victim_severity"), ServiceFailed);  // nobody is injured there
  run.Ticks(30);
  EXPECT_EQ(run.Data("sar").Find("victim_dict")->Dump(), "{}");
}

TEST(MorseCompoundSensorTest, TheDataOfOthersUnderTheirNames) {
  Trial run(Scene(R"({"name": "all", "type": "CompoundSensor", "properties":
                      {"sensors": "robot.pose, robot.clock,robot.nobody,robot.all"}},
                     {"name": "pose", "type": "Pose"}, {"name": "clock", "type": "Clock"})",
                  R"({"x": 1, "y": 2})"));
  run.Ticks(2);
  const Json data = run.Shown("all");
  EXPECT_EQ(data.AsObject().size(), 3U);
  EXPECT_EQ(data.Find("robot.pose")->Find("x")->AsDouble(), 1.0);
  EXPECT_EQ(data.Find("robot.clock")->Dump(), run.Get("clock").LocalData());
  run.Get("all").SetProperty("sensors", Json("robot.clock"));
  run.Ticks(1);
  EXPECT_EQ(run.Shown("all").AsObject().size(), 2U);
}

std::vector<std::string> NamesSeen(Trial& run, const std::string& camera) {
  std::vector<std::string> names;
  const Json data = run.Data(camera);
  for (const Json& object : data.Find("visible_objects")->AsArray()) {
    names.push_back(object.Find("name")->AsString());
  }
  return names;
}

TEST(MorseSemanticCameraTest, WhatIsInItsViewAndNotHidden) {
  const std::string hull = R"("hull": [{"outline": [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25],
      [-0.25, -0.25]], "bottom": 0, "top": 1}])";
  const auto standing = [&](const std::string& name, double x, double y, const std::string& more) {
    return R"(, {"name": ")" + name + R"(", "pose": {"x": )" + std::to_string(x) + R"(, "y": )" +
           std::to_string(y) + R"(}, "type": "Custom", "body": {"footprint": [[0.25, -0.25],
      [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], )" +
           hull + R"(}, "components": [])" + more + "}";
  };
  const std::string thing = R"(, "properties": {"Object": true, "Type": "Cat"})";
  Trial run(Scene(R"({"name": "eye", "type": "SemanticCamera", "frequency": 60, "position":
                      [0.3, 0, 0.4], "properties": {"cam_focal": 25}},
                     {"name": "all", "type": "SemanticCamera", "frequency": 60, "position":
                      [0.3, 0, 0.4], "properties": {"noocclusion": true, "relative": true}},
                     {"name": "cats", "type": "SemanticCamera", "frequency": 60, "position":
                      [0.3, 0, 0.4], "properties": {"tag": "Cat"}})",
                  R"({"x": 1, "y": 0, "yaw": 0.1})",
                  standing("ahead", 4, 0.3, R"(, "properties": {"Object": true, "Label": "CAT"})") +
                      standing("hidden", 8, 0.7, thing) + standing("aside", 1, 5, thing) +
                      standing("plain", 4, 1.5, "") +
                      standing("false", 4, -1.5, R"(, "properties": {"Object": false})"),
                  R"("props": [{"name": "mug", "file": "m", "position": [3, -0.6, 0.5],
                      "properties": {"Object": true, "Description": "blue"}}],)"));
  EXPECT_EQ(NamesSeen(run, "eye"), (std::vector<std::string>{"CAT", "mug"}));
  EXPECT_EQ(NamesSeen(run, "all"), (std::vector<std::string>{"CAT", "hidden", "mug"}));
  EXPECT_EQ(NamesSeen(run, "cats"), (std::vector<std::string>{}));
  run.Get("cats").SetProperty("noocclusion", Json(true));
  EXPECT_EQ(NamesSeen(run, "cats"), (std::vector<std::string>{}));  // not due yet
  run.Ticks(1);
  EXPECT_EQ(NamesSeen(run, "cats"), (std::vector<std::string>{"hidden"}));
  const Json data = run.Shown("all");
  const Json& mug = data.Find("visible_objects")->AsArray()[2];
  EXPECT_EQ(mug.Find("description")->AsString(), "blue");
  // In the frame of a camera at (1, 0) turned by 0.1 rad, 0.3 m ahead of the robot's origin.
  const double dx = 3.0 - (1.0 + 0.3 * std::cos(0.1));
  const double dy = -0.6 - 0.3 * std::sin(0.1);
  const Json::Array& at = mug.Find("position")->AsArray();
  EXPECT_NEAR(at[0].AsDouble(), std::cos(0.1) * dx + std::sin(0.1) * dy, 1e-12);
  EXPECT_NEAR(at[1].AsDouble(), std::cos(0.1) * dy - std::sin(0.1) * dx, 1e-12);
  EXPECT_NEAR(at[2].AsDouble(), 0.0, 1e-12);
  EXPECT_NEAR(mug.Find("orientation")->Find("z")->AsDouble(), -std::sin(0.05), 1e-12);
  EXPECT_NEAR(mug.Find("orientation")->Find("w")->AsDouble(), std::cos(0.05), 1e-12);
}

TEST(MorseVelodyneRayCastTest, AnUprightFanThatTurns) {
  Trial run(Scene(R"({"name": "v", "type": "VelodyneRayCast", "frequency": 60, "position":
                      [0, 0, 0.9], "laser": {"range": 50, "scan_window_deg": 31.5,
                      "resolution_deg": 0.5}})"));
  Json data = run.Data("v");
  const auto range = [&](std::size_t i) {
    return data.Find("range_list")->AsArray()[i].AsDouble();
  };
  ASSERT_EQ(data.Find("range_list")->AsArray().size(), 64U);
  // 1 m above an endless floor: beam i points down by 27.75 - i / 2 degrees.
  for (std::size_t i = 0; i < 45; i += 4) {
    const double down = Radians(27.75 - 0.5 * static_cast<double>(i));
    EXPECT_NEAR(range(i), 1.0 / std::sin(down), 1e-5) << i;
  }
  EXPECT_EQ(range(63), 50.0);  // up by 3.75 degrees
  // The point is 15.75 degrees below the middle of the tilted fan.
  const Json::Array& lowest = data.Find("point_list")->AsArray()[0].AsArray();
  EXPECT_NEAR(lowest[0].AsDouble(), range(0) * std::cos(Radians(15.75)), 1e-9);
  EXPECT_NEAR(lowest[1].AsDouble(), 0.0, 1e-9);
  EXPECT_NEAR(lowest[2].AsDouble(), -range(0) * std::sin(Radians(15.75)), 1e-9);
}

TEST(MorseVelodyneRayCastTest, GoesRoundByItsStep) {
  // A robot to the left is met once the fan has come round to it: 90 of 0.01745 rad.
  Trial run(Scene(R"({"name": "v", "type": "VelodyneRayCast", "frequency": 60, "position":
                      [0, 0, 0.4], "laser": {"range": 50, "scan_window_deg": 31.5,
                      "resolution_deg": 0.5}})",
                  R"({"x": 0, "y": 0})",
                  R"(, {"name": "wall", "pose": {"x": 0, "y": 3}, "type": "Custom", "body":
      {"footprint": [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "hull":
       [{"outline": [[0.25, -0.25], [0.25, 0.25], [-0.25, 0.25], [-0.25, -0.25]], "bottom": 0,
         "top": 1}]}, "components": []})"));
  std::vector<int> met;
  for (int tick = 0; tick < 200; ++tick) {
    run.Ticks(1);
    // Of the beam 0.25 degrees above the horizon.
    if (run.Shown("v").Find("range_list")->AsArray()[56].AsDouble() < 49.0) met.push_back(tick);
  }
  ASSERT_FALSE(met.empty());
  const double half = std::atan2(0.25, 2.75);
  EXPECT_NEAR(met.front() * 0.01745, kPi / 2.0 - half, 0.02);
  EXPECT_NEAR(met.back() * 0.01745, kPi / 2.0 + half, 0.02);
}

TEST(MorseArucomarkerTest, WhereTheMarkerIs) {
  Trial run(Scene(R"({"name": "a", "type": "Arucomarker", "properties": {"xoffset": 0.1,
                      "yoffset": 0.2, "zoffset": 0.3}})",
                  R"({"x": 1, "y": 2, "yaw": 1.5707963267948966})"));
  run.Send("a", R"({"x": 1, "y": 2, "z": 3, "roll": 0, "pitch": 0, "yaw": 0.5})");
  run.Ticks(1);
  const Json::Array world = run.Call("a", "get_world_position").AsArray();
  EXPECT_NEAR(world[0].AsDouble(), 1.0 + 3.1, 1e-12);
  EXPECT_NEAR(world[1].AsDouble(), 2.0 + 1.2, 1e-12);
  EXPECT_NEAR(world[2].AsDouble(), 0.1 - 2.0 + 0.3, 1e-12);
  const Json::Array local = run.Call("a", "get_local_position").AsArray();
  EXPECT_NEAR(local[0].AsDouble(), 1.2, 1e-12);
  EXPECT_NEAR(local[1].AsDouble(), -3.1, 1e-12);
  const Json rows = run.Call("a", "get_world_orientation");
  EXPECT_NEAR(rows.AsArray()[0].AsArray()[0].AsDouble(), std::cos(0.5), 1e-12);
  EXPECT_NEAR(rows.AsArray()[1].AsArray()[0].AsDouble(), std::sin(0.5), 1e-12);
  const Json turned = run.Call("a", "get_local_orientation");
  EXPECT_NEAR(turned.AsArray()[0].AsArray()[0].AsDouble(), std::cos(0.5 - kPi / 2.0), 1e-12);
}

TEST(MorseKeyboardTest, KeysDriveUntilTheyAreLetGo) {
  Trial run(Scene(R"({"name": "keys", "type": "Keyboard", "properties": {"Speed": 3.0}},)" + kXyw));
  run.Call("keys", "drive", {1.0, 0.0});
  run.Ticks(60);
  EXPECT_NEAR(run.pose().x, 3.0, 1e-9);
  run.Call("keys", "drive", {0.0, 0.0});
  run.Ticks(10);
  EXPECT_NEAR(run.pose().x, 3.0, 1e-9);
  // Whoever comes next has the robot.
  run.Send("motion", R"({"x": -1, "y": 0, "w": 0})");
  run.Ticks(60);
  EXPECT_NEAR(run.pose().x, 2.0, 1e-9);
  EXPECT_THROW(run.Call("keys", "drive", {2.0, 0.0}), WrongArgument);
  EXPECT_THROW(run.Send("keys", R"({"forward": 1})"), WrongArgument);
}

}  // namespace
}  // namespace ccmorse::sim
