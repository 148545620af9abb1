// Every mistake in a scenario file is one line that says where, what and what to do.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "scene/scenario.h"

namespace ccmorse::scene {
namespace {

std::string ErrorOf(const std::string& text) {
  try {
    ParseScenario(text, "scene.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// The message of a file whose second line is `line`.
std::string ErrorInLine2(const std::string& line) { return ErrorOf("{\n" + line + "\n}"); }

// The message of a file with one robot, whose settings are the second line.
std::string ErrorInRobot(const std::string& settings) {
  return ErrorOf("{\"robots\": [{\n" + settings + "\n}]}");
}

bool HasText(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

TEST(S20, TwoRobotsOfOneNameAreAnErrorThatNamesBothLines) {
  EXPECT_EQ(
      ErrorOf(R"({
    "robots": [
      {"name": "anna"},

      {"name": "anna", "pose": {"x": 2.2, "y": 2.6}}
    ]})"),
      "scene.json:5: two robots are called 'anna', the first on line 3; give this one another "
      "'name'");
  EXPECT_TRUE(HasText(ErrorOf(R"({"robots": [{"name": "s1r_2"}, {"pose": {"x": 2.2, "y": 2.6}}]})"),
                      "two robots are called 's1r_2'"));
}

TEST(ScenarioErrors, DevicesThatARobotGoesWithoutAreChecked) {
  EXPECT_TRUE(HasText(ErrorInRobot(R"("without": ["poze"])"), "did you mean 'pose'"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("without": ["motion"])"), "robots[0].without[0]"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("without": ["pen", "pen"])"), "is there twice"));
  EXPECT_EQ(ErrorInRobot(R"("without": ["pose"], "proxies": {"position2d": {"2": "pose"}})"),
            "scene.json:2: robots[0].proxies has 'pose' as position2d:2, and 'without' takes it "
            "away");
  const Scenario scenario =
      ParseScenario(R"({"robots": [{"without": ["pose"], "wear": {"turn_lag": 0.2}}]})", "s.json");
  const ProxyTable expected = {{"laser", {{0, "hokuyo"}}}, {"position2d", {{3, "odometry"}}}};
  EXPECT_EQ(scenario.robots[0].proxies, expected);
  const Scenario again = ParseScenario(ToJson(scenario).Dump(), "s.json");
  EXPECT_EQ(again.robots[0].proxies, expected);
  EXPECT_EQ(again.robots[0].without, scenario.robots[0].without);
  EXPECT_EQ(again.robots[0].wear, scenario.robots[0].wear);
  EXPECT_TRUE(HasText(ErrorInRobot(R"("wear": {"pull": 1e9})"), "robots[0].wear.pull"));
}

TEST(ScenarioErrors, UnknownKeyNamesTheNearest) {
  EXPECT_EQ(ErrorInLine2(R"("robot": [])"),
            "scene.json:2: unknown key 'robot'; did you mean 'robots'?");
  EXPECT_EQ(ErrorInRobot(R"("postion": {"x": 1, "y": 1})"),
            "scene.json:2: unknown key 'postion' in robots[0]; did you mean 'pose'?");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"zoom": 1})"),
            "scene.json:2: unknown key 'zoom' in canvas; known are alpha, height, mode, "
            "mode_switching and width");
  EXPECT_EQ(ErrorInRobot(R"("laser": {"resolution": 1})"),
            "scene.json:2: unknown key 'resolution' in robots[0].laser; did you mean "
            "'resolution_deg'?");
}

TEST(ScenarioErrors, EveryObjectIsChecked) {
  for (const char* part : {"world", "obstacles", "canvas", "camera", "time"}) {
    const std::string message =
        ErrorInLine2(fmt::format(R"("{}": {{"name": "w", "size": [1, 1], "qqq": 1}})", part));
    EXPECT_TRUE(HasText(message, "scene.json:2: unknown key ")) << message;
  }
  for (const char* part : {"pose", "proxies", "laser"}) {
    const std::string message =
        ErrorInRobot(fmt::format(R"("{}": {{"x": 1, "y": 2, "qqq": 1}})", part));
    EXPECT_TRUE(HasText(message, "scene.json:2: unknown key ")) << message;
  }
}

TEST(ScenarioErrors, WrongTypes) {
  EXPECT_EQ(ErrorInRobot(R"("pose": {"x": "1", "y": 1})"),
            "scene.json:2: robots[0].pose.x must be a number, not a string");
  EXPECT_EQ(ErrorInLine2(R"("robots": {})"), "scene.json:2: robots must be a list, not an object");
  EXPECT_EQ(ErrorInLine2(R"("robots": [3])"),
            "scene.json:2: robots[0] must be an object {...}, not a number");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"mode_switching": 1})"),
            "scene.json:2: canvas.mode_switching must be true or false, not a number");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"width": "172"})"),
            "scene.json:2: canvas.width must be a whole number, not a string");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"width": 17.5})"),
            "scene.json:2: canvas.width must be a whole number 1..4096, not 17.5");
  EXPECT_EQ(ErrorInRobot(R"("name": 7)"),
            "scene.json:2: robots[0].name must be a string, not a number");
  EXPECT_EQ(ErrorInLine2(R"("camera": {"position": [1, 2]})"),
            "scene.json:2: camera.position has 2 numbers, must be [x, y, z]");
  EXPECT_EQ(ErrorInLine2(R"("time": null)"),
            "scene.json:2: time must be an object {...}, not null");
  EXPECT_EQ(ErrorOf("[]"), "scene.json:1: the file must be an object {...}, not a list");
}

TEST(ScenarioErrors, NumbersOutOfRange) {
  EXPECT_EQ(ErrorInLine2(R"("time": {"frequency": 0})"),
            "scene.json:2: time.frequency is 0, must be 1..1000");
  EXPECT_EQ(ErrorInLine2(R"("time": {"factor": 0})"),
            "scene.json:2: time.factor is 0, must be 0.001..1000");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"alpha": 1.01})"),
            "scene.json:2: canvas.alpha is 1.01, must be 0..1");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"alpha": -0.5})"),
            "scene.json:2: canvas.alpha is -0.5, must be 0..1");
  EXPECT_EQ(ErrorInLine2(R"("canvas": {"height": 0})"),
            "scene.json:2: canvas.height is 0, must be 1..4096");
  EXPECT_EQ(ErrorInLine2(R"("seed": -1)"),
            "scene.json:2: seed is -1, must be 0..9223372036854775807");
  EXPECT_EQ(ErrorInRobot(R"("laser": {"range": -5})"),
            "scene.json:2: robots[0].laser.range is -5, must be more than 0 and at most 1000");
}

TEST(ScenarioErrors, NumbersThatAreNone) {
  for (const char* number : {"NaN", "Infinity", "-Infinity", "1e999"}) {
    EXPECT_EQ(ErrorInRobot(fmt::format(R"("pose": {{"x": 1, "y": {}}})", number)),
              "scene.json:2: robots[0].pose.y must be a finite number");
    EXPECT_EQ(ErrorInRobot(fmt::format(R"("drivers": {{"snd": {{"a": [1, {}]}}}})", number)),
              "scene.json:2: robots[0].drivers.snd.a[1] must be a finite number");
    EXPECT_TRUE(HasText(ErrorInLine2(fmt::format(R"("seed": {})", number)),
                        "scene.json:2: seed must be a whole number"));
  }
}

TEST(ScenarioErrors, NegativeSizesOfABox) {
  EXPECT_EQ(ErrorOf(R"({"world": {"name": "w", "size": [4, 4], "boxes": [
      {"id": 1, "kind": "wall", "x": 1, "y": 1, "size": [0.1, -1],
       "height": 1, "color": "red"}]}})"),
            "scene.json:2: world.boxes[0].size[1] is -1, must be more than 0 and at most 1000");
  EXPECT_EQ(ErrorOf(R"({"world": {"name": "w", "size": [4, 4], "boxes": [
      {"id": 1, "kind": "wall", "x": 1, "y": 1, "size": [0.1, 1],
       "height": 0, "color": "red"}]}})"),
            "scene.json:3: world.boxes[0].height is 0, must be more than 0 and at most 1000");
}

TEST(ScenarioErrors, KeyGivenTwice) {
  EXPECT_EQ(ErrorOf("{\"seed\": 1,\n\n\"seed\": 2}"),
            "scene.json:3: key 'seed' is given twice, first on line 1; remove one");
  EXPECT_EQ(ErrorInRobot("\"name\": \"a\",\n\"name\": \"b\""),
            "scene.json:3: key 'name' is given twice in robots[0], first on line 2; remove one");
  EXPECT_TRUE(HasText(ErrorInRobot(R"("drivers": {"snd": {"a": 1, "a": 2}})"), "is given twice"));
}

TEST(ScenarioErrors, Obstacles) {
  EXPECT_TRUE(
      HasText(ErrorInLine2(R"("obstacles": {"up": [5, 91]})"),
              "scene.json:2: obstacles.up[1] is 91, which is no obstacle of world 'syrotek'; "
              "dynamic are 5, 6,"));
  EXPECT_TRUE(
      HasText(ErrorInLine2(R"("obstacles": {"up": [26]})"),
              "scene.json:2: obstacles.up[0] is 26, a box of kind 'static', which cannot be "
              "moved; dynamic are 5, 6,"));
  EXPECT_TRUE(HasText(ErrorInLine2(R"("obstacles": {"down": [1]})"), "cannot be moved"));
  EXPECT_EQ(ErrorInLine2(R"("obstacles": {"up": [5], "down": [5]})"),
            "scene.json:2: obstacles.down[0] is 5, which is also in 'up'; remove one");
  EXPECT_TRUE(
      HasText(ErrorOf(R"({"world": {"name": "w", "size": [4, 4]}, "obstacles": {"up": [1]}})"),
              "this world has none"));
}

TEST(ScenarioErrors, CustomRobots) {
  const std::string square = "[[0.1, -0.1], [0.1, 0.1], [-0.1, 0.1], [-0.1, -0.1]]";
  const auto error = [&](const std::string& body, const std::string& more = "") {
    return ErrorInRobot(R"("type": "Custom", "body": {)" + body + "}" + more);
  };
  EXPECT_TRUE(HasText(ErrorInRobot(R"("type": "Custom")"), "robots[0] lacks 'body'"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("body": {})"), "unknown key 'body'"));
  EXPECT_TRUE(HasText(error(""), "robots[0].body lacks 'footprint'"));
  EXPECT_TRUE(HasText(error(R"("footprint": [[0, 0], [1, 0]])"), "has 2 corners, must have 3..16"));
  EXPECT_TRUE(HasText(error(R"("footprint": [[0, 0], [0, 1], [1, 0]])"), "must turn left"));
  EXPECT_TRUE(HasText(error(R"("footprint": )" + square + R"(, "max_side_speed": 1)"),
                      "is for robots whose drive is \"omni\""));
  EXPECT_TRUE(HasText(error(R"("footprint": )" + square, R"(, "sonar": {"range": 2})"),
                      "robots[0].sonar lacks 'poses'"));
  EXPECT_TRUE(
      HasText(error(R"("footprint": )" + square, R"(, "proxies": {"laser": {"0": "hokuyo"}})"),
              "this robot has no 'laser'"));
  EXPECT_TRUE(
      HasText(error(R"("footprint": )" + square, R"(, "rangers": [{"name": "pose", "laser": {}}])"),
              "is 'pose', as is another component of the robot"));
  EXPECT_TRUE(HasText(error(R"("footprint": )" + square, R"(, "rangers": [{"name": "a"}])"),
                      "must have either a 'laser' or a 'ring'"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("odometry": {"error": [0, 0, -1]})"), "must be 0..1"));
}

TEST(ScenarioErrors, UnknownNames) {
  EXPECT_EQ(ErrorInRobot(R"("type": "S2R")"),
            "scene.json:2: robots[0].type is 'S2R', must be one of 'BoxRobot', 'Custom' and 'S1R'; "
            "did you "
            "mean 'S1R'?");
  EXPECT_EQ(ErrorInRobot(R"("proxies": {"position2d": {"0": "pos"}})"),
            "scene.json:2: robots[0].proxies.position2d.0 is 'pos', must be one of 'pose' and "
            "'odometry'; did you mean 'pose'?");
  EXPECT_EQ(ErrorInRobot(R"("proxies": {"positon2d": {"0": "pose"}})"),
            "scene.json:2: unknown key 'positon2d' in robots[0].proxies; did you mean "
            "'position2d'?");
  for (const char* index : {"-1", "65536", "a", "", "01", "1.0", "99999999999999999999"}) {
    EXPECT_EQ(
        ErrorInRobot(fmt::format(R"("proxies": {{"laser": {{"{}": "hokuyo"}}}})", index)),
        fmt::format(
            "scene.json:2: key '{}' in robots[0].proxies.laser must be an index 0..65535, as \"0\"",
            index));
  }
  EXPECT_TRUE(HasText(ErrorInLine2(R"("world": "syrotec")"),
                      "scene.json:2: world is 'syrotec', must be one of "));
  EXPECT_TRUE(HasText(ErrorInLine2(R"("world": "syrotec")"), "did you mean 'syrotek'?"));
  EXPECT_TRUE(HasText(ErrorInLine2(R"("world": "../worlds/syrotek")"), "must be one of"));
  EXPECT_EQ(ErrorInLine2(R"("world": {"file": "none.json"})"),
            "scene.json:2: cannot read none.json: No such file or directory");
  EXPECT_TRUE(
      HasText(ErrorInLine2(R"("time": {"strategy": "realtim"})"), "did you mean 'realtime'?"));
  EXPECT_TRUE(
      HasText(ErrorInLine2(R"("canvas": {"mode": "mini-map"})"), "did you mean 'minimap'?"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("laser": {"preset": "urg04"})"), "must be one of"));
}

std::string ErrorInMesh(const std::string& settings) {
  return ErrorInLine2(R"("world": {"name": "w", "size": [4, 4], "boxes": [{"id": 4, "kind": "k",
"x": 1, "y": 1, "size": [1, 1], "height": 1, "color": "red"}], "meshes": [{"id": 5, )" +
                      settings + "}]}");
}

TEST(ScenarioErrors, Meshes) {
  const std::string vertices = R"("vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0]])";
  EXPECT_EQ(ErrorInMesh(vertices), "scene.json:3: world.meshes[0] lacks 'triangles'");
  EXPECT_EQ(ErrorInMesh(vertices + R"(, "triangles": [])"),
            "scene.json:3: world.meshes[0].triangles is empty, must have a triangle or more");
  EXPECT_EQ(ErrorInMesh(vertices + R"(, "triangles": [[0, 1, 4]])"),
            "scene.json:3: world.meshes[0].triangles[0][2] is 4, must be 0..3");
  EXPECT_EQ(ErrorInMesh(vertices + R"(, "triangles": [[0, 1]])"),
            "scene.json:3: world.meshes[0].triangles[0] has 2 numbers, must be the indexes of 3 "
            "vertices");
  for (const char* line : {"[0, 1, 3]", "[0, 1, 0]"}) {
    EXPECT_TRUE(HasText(ErrorInMesh(vertices + R"(, "triangles": [)" + line + "]"),
                        "which lie on one line; remove it"));
  }
  EXPECT_EQ(ErrorInMesh(R"("vertices": [[0, 0, 0]], "triangles": [])"),
            "scene.json:3: world.meshes[0].vertices has 1 vertices, must have 3 or more");
  EXPECT_TRUE(
      HasText(ErrorInMesh(R"("vertices": [[0, 0, 1e9]], "triangles": [])"), "must be -1000"));
  EXPECT_TRUE(HasText(ErrorInMesh(vertices + R"(, "triangles": [[0, 1, 2]], "postion": [1, 2, 3])"),
                      "unknown key 'postion' in world.meshes[0]; did you mean 'position'?"));
  const std::string triangle = R"("vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
"triangles": [[0, 1, 2]])";
  EXPECT_EQ(
      ErrorInMesh(triangle + R"(}, {"id": 5, )" + triangle),
      "scene.json:4: world.meshes[1] has id 5, as has the mesh on line 3; ids must be unique");
  EXPECT_EQ(ErrorInMesh(triangle + R"(}, {"id": 4, )" + triangle),
            "scene.json:4: world.meshes[1] has id 4, as has a box; ids must be unique");
}

TEST(ScenarioErrors, Rings) {
  EXPECT_EQ(ErrorInRobot(R"("ir": 3)"),
            "scene.json:2: robots[0].ir must be true, false or an object {...}, not a number");
  EXPECT_TRUE(
      HasText(ErrorInRobot(R"("sonar": {"cone": 3})"), "unknown key 'cone' in robots[0].sonar"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("sonar": {"cone_deg": 180})"), "at most 170"));
  EXPECT_EQ(
      ErrorInRobot(R"("ir": {"range": 1, "min_range": 1})"),
      "scene.json:2: robots[0].ir has a min_range of 1 m, must be less than its range of 1 m");
  EXPECT_EQ(ErrorInRobot(R"("front": "sensors")"),
            "scene.json:2: robots[0].front is the sensor module, so add \"ir\": true, \"sonar\": "
            "true or both");
  EXPECT_EQ(ErrorInRobot(R"("front": "sensors", "ir": true, "laser": {})"),
            "scene.json:2: robots[0].laser belongs to a robot with \"front\": \"laser\"; remove "
            "one of them");
  EXPECT_TRUE(HasText(
      ErrorInRobot(R"("front": "sensors", "ir": true, "proxies": {"laser": {"0": "hokuyo"}})"),
      "has taken the place of"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("front": "laserr")"), "did you mean 'laser'?"));
}

TEST(ScenarioErrors, Layers) {
  EXPECT_TRUE(HasText(ErrorInRobot(R"("laser": {"layers": 0})"), "is 0, must be 1..128"));
  EXPECT_EQ(ErrorInRobot(R"("laser": {"layers": 128, "samples": 1000})"),
            "scene.json:2: robots[0].laser has 128 layers of 1000 beams, 128000 in all, must be at "
            "most 100000");
  EXPECT_EQ(ErrorInRobot(R"("laser": {"pitch": 1, "pitch_deg": 1})"),
            "scene.json:2: robots[0].laser has both 'pitch' and 'pitch_deg'; keep one");
}

TEST(ScenarioErrors, Colors) {
  for (const char* color : {"\"#12345\"", "\"#12345g\"", "\"#+1+2+3\"", "\"\"", "\"gren\""}) {
    const std::string message = ErrorInRobot(fmt::format(R"("color": {})", color));
    EXPECT_TRUE(HasText(message, "scene.json:2: robots[0].color is ")) << message;
  }
  EXPECT_TRUE(HasText(ErrorInRobot(R"("color": "gren")"), "did you mean 'green'?"));
  EXPECT_EQ(ErrorInRobot(R"("color": [0, 256, 0])"),
            "scene.json:2: robots[0].color[1] is 256, must be 0..255");
  EXPECT_TRUE(HasText(ErrorInRobot(R"("color": [0, 0])"), "has 2 numbers"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("color": 7)"), "must be a colour"));
}

TEST(ScenarioErrors, Names) {
  for (const char* name : {"", "a b", "a.b", "r\\u00e9my", "a\\nb"}) {
    const std::string message = ErrorInRobot(fmt::format(R"("name": "{}")", name));
    EXPECT_TRUE(HasText(message, "must be 1 to 64 letters, digits or _")) << message;
    EXPECT_FALSE(HasText(message, "\n")) << message;
  }
  EXPECT_TRUE(HasText(ErrorInRobot(fmt::format(R"("name": "{}")", std::string(65, 'a'))), "..."));
}

TEST(ScenarioErrors, MissingKeys) {
  EXPECT_EQ(ErrorInRobot(R"("pose": {"x": 1})"), "scene.json:2: robots[0].pose lacks 'y'");
  EXPECT_EQ(ErrorInRobot(R"("pose": {"y": 1, "X": 1})"),
            "scene.json:2: robots[0].pose lacks 'x'; is 'X' meant?");
  EXPECT_EQ(ErrorInLine2(R"("world": {"name": "w"})"), "scene.json:2: world lacks 'size'");
}

TEST(ScenarioErrors, BothUnitsOfAnAngle) {
  EXPECT_EQ(ErrorInRobot(R"("pose": {"x": 1, "y": 1, "yaw": 0, "yaw_deg": 0})"),
            "scene.json:2: robots[0].pose has both 'yaw' and 'yaw_deg'; keep one");
  EXPECT_TRUE(HasText(ErrorInRobot(R"("pose": {"x": 1, "y": 1, "yaw": 150})"),
                      "robots[0].pose.yaw is 150, must be "));
}

TEST(ScenarioErrors, BadJsonNamesItsLine) {
  EXPECT_EQ(ErrorOf("{\n\"seed\": 1,\n}"),
            "scene.json:3: Expecting property name enclosed in double quotes (column 1)");
  EXPECT_EQ(ErrorOf(""), "scene.json:1: Expecting value (column 1)");
  EXPECT_EQ(ErrorOf("{} {}"), "scene.json:1: Extra data (column 4)");
}

TEST(ScenarioErrors, RobotsThatStandWhereTheyCannot) {
  EXPECT_EQ(
      ErrorOf("{\"robots\": [\n{\"pose\": {\"x\": 0.05, \"y\": 2.0}}]}"),
      "scene.json:2: robot 's1r' at (0.05, 2) does not stand on the floor of world 'syrotek', "
      "3.42 x 3.72 m; move it");
  EXPECT_EQ(
      ErrorOf("{\"robots\": [\n{\"pose\": {\"x\": 0.1, \"y\": 2.0}}]}"),
      "scene.json:2: robot 's1r' at (0.1, 2) overlaps box 3 (border) at (0.02, 1.86); move it");
  const std::string on_pillar = "\"robots\": [\n{\"pose\": {\"x\": 1.72, \"y\": 2.58}}]}";
  EXPECT_EQ(ErrorOf("{\"obstacles\": {\"up\": [72]}, " + on_pillar),
            "scene.json:2: robot 's1r' at (1.72, 2.58) overlaps box 72 (dynamic_pillar) at (1.72, "
            "2.58); move it or lower the box");
  EXPECT_EQ(ErrorOf("{" + on_pillar), "no error");
  EXPECT_EQ(ErrorOf(R"({"robots": [
      {"name": "a", "pose": {"x": 2.2, "y": 2.6}},
      {"name": "b", "pose": {"x": 2.3, "y": 2.6}}]})"),
            "scene.json:3: robot 'b' at (2.3, 2.6) overlaps robot 'a' at (2.2, 2.6); move one of "
            "them");
  // 0.174 m long, so 0.18 m apart is enough.
  EXPECT_EQ(ErrorOf(R"({"robots": [{"pose": {"x": 2.2, "y": 2.6}},
                                   {"pose": {"x": 2.38, "y": 2.6}}]})"),
            "no error");
}

TEST(ScenarioErrors, DefaultRobotThatDoesNotFitStillHasALine) {
  EXPECT_EQ(
      ErrorOf(R"({"world": {"name": "tiny", "size": [1, 1]}})"),
      "scene.json:1: robot 's1r' at (1.2, 2) does not stand on the floor of world 'tiny', 1 x "
      "1 m; move it");
}

TEST(ScenarioErrors, BeamsThatDoNotFitTheWindow) {
  EXPECT_TRUE(HasText(ErrorInRobot(R"("laser": {"resolution_deg": 1e-9})"),
                      "scene.json:2: robots[0].laser makes too many beams"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("laser": {"scan_window_deg": 1, "resolution_deg": 5})"),
                      "makes too few beams"));
  EXPECT_TRUE(HasText(ErrorInRobot(R"("laser": {"samples": 5000, "resolution_deg": 1})"),
                      "more than its window of 360"));
  EXPECT_TRUE(HasText(
      ErrorInRobot(R"("laser": {"samples": 682, "resolution_deg": 1, "scan_window_deg": 90})"),
      "more than its window of 90"));
}

TEST(WorldErrors, Boxes) {
  const auto error_of_boxes = [](const std::string& boxes) {
    return ErrorOf(
        "{\"world\": {\"name\": \"w\", \"size\": [4, 4],\n"
        "\"kinds\": {\"wall\": {\"height\": 1, \"color\": \"red\"}},\n\"boxes\": [" +
        boxes + "]}}");
  };
  const std::string wall = R"({"id": 1, "kind": "wall", "x": 3, "y": 3, "size": [1, 1]})";
  EXPECT_EQ(error_of_boxes(wall), "no error");
  EXPECT_EQ(error_of_boxes(wall + ",\n" + wall),
            "scene.json:4: world.boxes[1] has id 1, as has the box on line 3; ids must be unique");
  EXPECT_EQ(
      error_of_boxes(R"({"id": 1, "kind": "wal", "x": 3, "y": 3, "size": [1, 1]})"),
      "scene.json:3: world.boxes[0].kind is 'wal', must be one of wall; did you mean 'wall'?");
  EXPECT_EQ(error_of_boxes(
                R"({"id": 1, "kind": "wall", "x": 3, "y": 3, "size": [1, 1], "raised": false})"),
            "scene.json:3: world.boxes[0].raised leaves a box down that is not dynamic; make it "
            "dynamic");
  EXPECT_EQ(error_of_boxes(R"({"id": 1, "kind": "wall", "x": 3, "y": 3, "size": [1]})"),
            "scene.json:3: world.boxes[0].size has 1 numbers, must be [x, y]");
  EXPECT_EQ(ErrorOf(R"({"world": {"name": "w", "size": [4, 4], "boxes": [
      {"id": 1, "kind": "wall", "x": 3, "y": 3, "size": [1, 1], "height": 1}]}})"),
            "scene.json:2: world.boxes[0] lacks 'color'");
}

}  // namespace
}  // namespace ccmorse::scene
