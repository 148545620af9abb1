// Player's .cfg files, and what of them a Player server is told (specs: player.md C.2).

#include "scene/player/player_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/trig.h"
#include "scene/player/import.h"

namespace ccmorse::scene {
namespace {

const std::string kWorlds = CCMORSE_SOURCE_DIR "/tests/worlds/";

PlayerConfig ParseConfig(const std::string& text) {
  return ParsePlayerConfig(text, "test.cfg", [](const std::string& path) -> std::string {
    throw Error("cannot read " + path);
  });
}

template <typename Call>
std::string ConfigError(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string DeviceText(const PlayerDevice& device) {
  return std::to_string(device.port) + ":" + device.interface + ":" + std::to_string(device.index) +
         " " + device.robot + "." + device.device;
}

std::vector<std::string> DeviceTexts(const ImportedScenario& imported) {
  std::vector<std::string> texts;
  for (const PlayerDevice& device : imported.scenario.player->devices) {
    texts.push_back(DeviceText(device));
  }
  return texts;
}

bool HasNote(const ImportedScenario& imported, const std::string& text) {
  return std::any_of(imported.notes.begin(), imported.notes.end(), [&text](const FileNote& note) {
    return (note.at.Text() + ": " + note.text).find(text) != std::string::npos;
  });
}

TEST(PlayerConfigC2, AddressesHaveFieldsThatMayMissFromTheLeft) {
  EXPECT_EQ(ParsePlayerAddress("laser:0"), (PlayerAddress{"", "", 6665, "laser", 0}));
  EXPECT_EQ(ParsePlayerAddress("6666:position2d:1"),
            (PlayerAddress{"", "", 6666, "position2d", 1}));
  EXPECT_EQ(ParsePlayerAddress("localhost:6665:laser:0"),
            (PlayerAddress{"", "localhost", 6665, "laser", 0}));
  EXPECT_EQ(ParsePlayerAddress("odometry:::position2d:1"),
            (PlayerAddress{"odometry", "", 6665, "position2d", 1}));
  for (const char* const text : {"laser:0", "6666:laser:0", "host:7000:laser:3", "host::laser:3",
                                 "input:::position2d:0", "input:h:6667:position2d:65535"}) {
    EXPECT_EQ(ParsePlayerAddress(ToText(ParsePlayerAddress(text))), ParsePlayerAddress(text));
  }
}

TEST(PlayerConfigC2, WhatIsNoAddressIsRefused) {
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("laser"); }).find("is no device"),
            std::string::npos);
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("lasr:0"); }).find("did you mean 'laser'?"),
            std::string::npos);
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("laser:-1"); }).find("index"), std::string::npos);
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("70000:laser:0"); }).find("port"),
            std::string::npos);
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("0:laser:0"); }).find("port"), std::string::npos);
  EXPECT_NE(ConfigError([] { ParsePlayerAddress("a:b:c:d:laser:0"); }).find("is no device"),
            std::string::npos);
  EXPECT_EQ(ConfigError([] {
              ParseConfig("driver ( name \"x\"\nprovides [ \"lasr:0\" ] )");
            }).substr(0, 11),
            "test.cfg:2:");
}

TEST(PlayerConfigC2, KeysThatAllDriversShareAreTakenOut) {
  const PlayerConfig config = ParseConfig(
      "driver ( name \"amcl\" plugin \"libamcl\" alwayson 1 provides [ \"localize:0\" ]\n"
      "  requires [ \"odometry:::position2d:1\" \"laser:0\" ] extra 3 )");
  ASSERT_EQ(config.drivers.size(), 1U);
  const ConfigDriver& section = config.drivers[0];
  EXPECT_EQ(section.driver.name, "amcl");
  EXPECT_EQ(section.plugin, "libamcl");
  EXPECT_TRUE(section.driver.always_on);
  ASSERT_EQ(section.driver.needed.size(), 2U);
  EXPECT_EQ(section.driver.needed[0].key, "odometry");
  ASSERT_EQ(section.driver.options.size(), 1U);
  EXPECT_EQ(section.driver.options[0].first, "extra");
  EXPECT_EQ(section.driver.places[0], "test.cfg:2");
  EXPECT_EQ(ConfigError([] { ParseConfig("\ndriver ( )"); }).substr(0, 31),
            "test.cfg:2: a driver without a ");
}

TEST(PlayerConfigC2, OptionsAreReadByTypeInMetresAndRadians) {
  const PlayerConfig config = ParseConfig(
      "unit_length \"cm\"\ndriver ( name \"snd\" provides [ \"position2d:1\" ] robot_radius 4\n"
      "max_turn_rate 90 goal_tol [ 50 10 ] n 7 wait yes file \"map.png\" wait no )");
  const PlayerDriver& driver = config.drivers[0].driver;
  EXPECT_DOUBLE_EQ(driver.Length("robot_radius", 0.0), 0.04);
  EXPECT_DOUBLE_EQ(driver.Angle("max_turn_rate", 0.0), kPi / 2.0);
  EXPECT_DOUBLE_EQ(driver.Angle("none", 0.25), 0.25);
  EXPECT_EQ(driver.Integer("n", 0), 7);
  EXPECT_FALSE(driver.Bool("wait", true));  // the later one counts
  EXPECT_EQ(driver.Text("file", ""), "map.png");
  const auto tolerance = driver.Tuple("goal_tol", "la");
  ASSERT_TRUE(tolerance.has_value());
  EXPECT_DOUBLE_EQ((*tolerance)[0], 0.5);
  EXPECT_DOUBLE_EQ((*tolerance)[1], Radians(10.0));
  EXPECT_FALSE(driver.Tuple("none", "la").has_value());
  EXPECT_EQ(ConfigError([&] { static_cast<void>(driver.Number("file", 0.0)); }),
            "test.cfg:3: 'file' of driver 'snd' must be a number");
  EXPECT_THROW(static_cast<void>(driver.Tuple("goal_tol", "l")), Error);
}

TEST(PlayerConfigC2, OnlyDriverSectionsMatter) {
  const PlayerConfig config = ParseConfig("speed 3\nwindow ( )\ndriver ( name \"x\" )");
  EXPECT_EQ(config.drivers.size(), 1U);
  ASSERT_EQ(config.notes.size(), 2U);
  EXPECT_EQ(config.notes[0].at.Text(), "test.cfg:2");
  EXPECT_EQ(config.notes[1].at.Text(), "test.cfg:1");
}

TEST(PlayerConfigC2, ADeviceIsProvidedOnce) {
  EXPECT_EQ(ConfigError([] {
              ParseConfig(
                  "driver ( name \"a\" provides [ \"laser:0\" ] )\n"
                  "driver ( name \"b\" provides [ \"6665:laser:0\" ] )");
            }),
            "test.cfg:2: 6665:laser:0 is provided on line 1 already; remove one");
}

TEST(PlayerConfigC2, EachInterfaceGetsTheFirstModelThatIsLeft) {
  const ImportedScenario hall = ImportScenario(kWorlds + "hall.cfg");
  EXPECT_EQ(DeviceTexts(hall),
            (std::vector<std::string>{"6665:simulation:0 .", "6665:position2d:0 r0.pose",
                                      "6665:ranger:0 r0.sonar", "6665:ranger:1 r0.hokuyo",
                                      "6665:graphics2d:0 r0."}));
  ASSERT_EQ(hall.scenario.player->drivers.size(), 2U);
  EXPECT_EQ(hall.scenario.player->drivers[0].name, "rangertolaser");
  EXPECT_EQ(hall.scenario.player->drivers[1].name, "vfh");
}

TEST(PlayerConfigC2, LaserAndSonarOfOlderFilesFindTheirModels) {
  const ImportedScenario imported = ImportScenario(kWorlds + "stage2.cfg");
  EXPECT_EQ(
      DeviceTexts(imported),
      (std::vector<std::string>{"6665:simulation:0 .", "6665:position2d:0 robot1.pose",
                                "6665:sonar:0 robot1.sonar", "6665:laser:0 robot1.hokuyo",
                                "6666:position2d:0 robot2.pose", "6666:laser:0 robot2.hokuyo"}));
  EXPECT_EQ(imported.scenario.player->Ports(), (std::vector<int>{6665, 6666}));
}

TEST(PlayerConfigC2, AServerListensOnEveryPortThatOccurs) {
  const ImportedScenario fleet = ImportScenario(kWorlds + "fleet.cfg");
  EXPECT_EQ(fleet.scenario.player->Ports(), (std::vector<int>{6665, 6666, 6667}));
}

TEST(PlayerConfigC2, AsSyrotekDoesIt) {
  const ImportedScenario course = ImportScenario(kWorlds + "course.cfg");
  EXPECT_EQ(course.scenario.name, "course");
  const PlayerDriver& snd = course.scenario.player->drivers.at(1);
  EXPECT_EQ(snd.name, "snd");
  EXPECT_EQ(snd.provided.at(0), ParsePlayerAddress("position2d:1"));
  EXPECT_EQ(snd.needed.at(1).key, "output");
  EXPECT_NEAR(snd.Angle("max_turn_rate", 0.0), 1.0, 1e-3);
  EXPECT_EQ(course.scenario.robots.at(0).laser.samples, 622);

  const ImportedScenario real = ImportScenario(kWorlds + "real.cfg");
  EXPECT_EQ(DeviceTexts(real),
            (std::vector<std::string>{"6665:position2d:0 s1r.odometry",
                                      "6665:position2d:2 s1r.pose", "6665:ranger:0 s1r.hokuyo"}));
}

TEST(PlayerConfigC2, ADeviceThatNothingServesIsNamedWithItsLine) {
  const ImportedScenario imported = ImportScenario(kWorlds + "devices.cfg");
  for (const char* const name : {"fiducial:0", "blobfinder:0", "bumper:0", "gripper:0"}) {
    EXPECT_TRUE(HasNote(imported, std::string("devices.cfg:6: ") + name + " is not provided"))
        << name;
  }
  EXPECT_EQ(DeviceTexts(imported).back(), "6665:ranger:1 carrier.rear");
}

TEST(PlayerConfigC2, WhatTheConfigNamesMustBeThere) {
  const auto import = [](const std::string& text) {
    return ConfigError([&text] { ImportConfig(ParsePlayerConfig(text, kWorlds + "test.cfg")); });
  };
  EXPECT_NE(import("driver ( name \"snd\" )").find("test.cfg:1: no driver names a world"),
            std::string::npos);
  EXPECT_NE(
      import("driver ( name \"stage\" provides [ \"simulation:0\" ]\nworldfile \"no.world\" )")
          .find("test.cfg:2: "),
      std::string::npos);
  const std::string world =
      "driver ( name \"stage\" provides [ \"simulation:0\" ] worldfile \"hall.world\" )\n";
  EXPECT_NE(import(world + "driver ( name \"stage\" provides [ \"position2d:0\" ]\nmodel \"r1\" )")
                .find("test.cfg:3: 'r1' is no position model of the world; did you mean 'r0'?"),
            std::string::npos);
  EXPECT_NE(import(world + "driver ( name \"stage\"\nprovides [ \"position2d:0\" ] )")
                .find("test.cfg:3: position2d:0 is provided by no model"),
            std::string::npos);
}

TEST(PlayerSetup, AScenarioMaySayTheSameAsJson) {
  const std::string text = R"({"robots": [{"name": "r"}], "player": {
    "devices": [{"address": "position2d:0", "robot": "r", "device": "pose"},
                {"address": "6666:simulation:0"},{"address": "graphics2d:0", "robot": "r"},
                {"address": "laser:0", "robot": "r", "device": "hokuyo"}],
    "drivers": [{"name": "snd", "provides": ["position2d:1"], "requires": ["input:::position2d:0"],
                 "angle_unit": 0.5, "options": {"max_turn_rate": 2, "tol": [1, "x"], "on": true}}]}})";
  const Scenario scenario = ParseScenario(text, "test.json");
  ASSERT_TRUE(scenario.player.has_value());
  EXPECT_EQ(scenario.player->Ports(), (std::vector<int>{6665, 6666}));
  EXPECT_DOUBLE_EQ(scenario.player->drivers[0].Angle("max_turn_rate", 0.0), 1.0);
  EXPECT_TRUE(scenario.player->drivers[0].Bool("on", false));
  const std::string written = ToJson(scenario).Dump();
  EXPECT_EQ(ToJson(ParseScenario(written, "test.json")).Dump(), written);
}

TEST(PlayerSetup, WhatItSaysOfRobotsMustBeTrue) {
  const auto error = [](const std::string& devices) {
    return ConfigError([&devices] {
      ParseScenario(R"({"robots": [{"name": "r"}], "player": {"devices": [)" + devices + "]}}",
                    "test.json");
    });
  };
  EXPECT_NE(error(R"({"address": "position2d:0", "robot": "q", "device": "pose"})")
                .find("by robot 'q', which there is none of"),
            std::string::npos);
  EXPECT_NE(error(R"({"address": "sonar:0", "robot": "r", "device": "sonar"})")
                .find("it has nothing to serve it by"),
            std::string::npos);
  EXPECT_NE(error(R"({"address": "gripper:0", "robot": "r", "device": "x"})").find("'gripper'"),
            std::string::npos);
  EXPECT_NE(error(R"({"address": "simulation:0"}, {"address": "6665:simulation:0"})")
                .find("a second time"),
            std::string::npos);
}

}  // namespace
}  // namespace ccmorse::scene
