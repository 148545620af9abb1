// Stage's .world files as scenarios (specs: player.md C.3).

#include "scene/player/stage_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/player/outline.h"
#include "scene/player/x11_colors.h"

namespace ccmorse::scene {
namespace {

// A picture of rows of '#' (dark) and '.'.
Image Picture(const std::vector<std::string>& rows) {
  Image image{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows) {
    for (const char c : row)
      image.pixels.push_back(c == '#' ? Color{127, 255, 255} : Color{128, 0, 0});
  }
  return image;
}

StageWorld Import(const std::string& text, const std::vector<std::string>& picture = {"#"}) {
  StageFiles files;
  files.read = [](const std::string& path) -> std::string { throw Error("cannot read " + path); };
  files.bitmap = [picture](const std::string& path) {
    if (path != "dir/plan.png") throw Error("cannot read " + path);
    return Picture(picture);
  };
  return ParseStageWorld(text, "dir/test.world", files);
}

std::string WorldError(const std::string& text) {
  try {
    Import(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

bool HasNote(const StageWorld& world, const std::string& text, bool matters = true) {
  return std::any_of(world.notes.begin(), world.notes.end(), [&](const FileNote& note) {
    return note.matters == matters &&
           (note.at.Text() + ": " + note.text).find(text) != std::string::npos;
  });
}

// Where something of the scenario is in Stage's coordinates.
Vec2 InStage(const StageWorld& world, Vec2 at) { return at - world.scenario.world.origin; }

const Box& OnlyBox(const StageWorld& world) {
  EXPECT_EQ(world.scenario.world.boxes.size(), 1U);
  return world.scenario.world.boxes.at(0);
}

TEST(StageWorldC3, TheOriginMovesFromTheMiddleToTheCorner) {
  const StageWorld world = Import(
      "model ( size [ 8 6 1 ] noblocks 1 boundary 1 ) position ( name \"r\" pose [ 1 -2 0 90 ] )");
  EXPECT_DOUBLE_EQ(world.scenario.world.size_x, 8.0);
  EXPECT_DOUBLE_EQ(world.scenario.world.size_y, 6.0);
  EXPECT_DOUBLE_EQ(world.scenario.world.origin.x, 4.0);
  EXPECT_DOUBLE_EQ(world.scenario.world.origin.y, 3.0);
  EXPECT_DOUBLE_EQ(world.scenario.robots[0].pose.x, 5.0);
  EXPECT_DOUBLE_EQ(world.scenario.robots[0].pose.y, 1.0);
  EXPECT_DOUBLE_EQ(world.scenario.robots[0].pose.yaw, kPi / 2.0);
}

TEST(StageWorldC3, GlobalPropertiesOfTime) {
  const TimeDef time = Import("interval_sim 50 speedup 3 quit_time 12").scenario.time;
  EXPECT_DOUBLE_EQ(time.frequency, 20.0);
  EXPECT_DOUBLE_EQ(time.factor, 3.0);
  EXPECT_DOUBLE_EQ(time.end, 12.0);
  EXPECT_DOUBLE_EQ(Import("").scenario.time.frequency, 10.0);
  EXPECT_EQ(Import("speedup 0").scenario.time.strategy, "max");
  EXPECT_NE(WorldError("interval_sim 0").find("test.world:1: interval_sim"), std::string::npos);
  EXPECT_TRUE(HasNote(Import("\npaused 1"), "dir/test.world:2: 'paused'"));
  EXPECT_FALSE(HasNote(Import("\npaused 0"), "paused"));
}

TEST(StageWorldC3, WhatIsAboutTheWindowIsOfNoMatter) {
  const StageWorld world = Import("window ( size [ 1 1 ] ) gui ( ) threads 4 resolution 0.02");
  EXPECT_TRUE(HasNote(world, "'window'", false));
  EXPECT_TRUE(HasNote(world, "'gui'", false));
  EXPECT_TRUE(HasNote(world, "'threads'", false));
  EXPECT_FALSE(HasNote(world, "test.world", true));
}

TEST(StageWorldC3, UnknownPropertiesAreNamedWithTheirLine) {
  EXPECT_TRUE(HasNote(Import("model (\n sizze [ 1 1 1 ] )"),
                      "dir/test.world:2: 'sizze' of model 'model:0' is not supported"));
}

TEST(StageWorldC3, UnknownTypesOfModelsAreErrors) {
  EXPECT_NE(WorldError("\nmodle ( )")
                .find("test.world:2: 'modle' is neither a type of model nor a "
                      "macro defined before; did you mean 'model'?"),
            std::string::npos);
}

TEST(StageWorldC3, PoseSizeAndOriginPlaceTheBody) {
  const StageWorld world =
      Import("model ( pose [ 1 2 0 90 ] size [ 0.4 0.2 0.6 ] origin [ 0.5 0 0 0 ] )");
  const Box& box = OnlyBox(world);
  const Vec2 at = InStage(world, {box.pose.x, box.pose.y});
  EXPECT_NEAR(at.x, 1.0, 1e-12);
  EXPECT_NEAR(at.y, 2.5, 1e-12);
  EXPECT_NEAR(box.pose.yaw, kPi / 2.0, 1e-12);
  EXPECT_NEAR(box.size_x, 0.4, 1e-12);
  EXPECT_NEAR(box.size_y, 0.2, 1e-12);
  EXPECT_NEAR(box.height, 0.6, 1e-12);
  EXPECT_EQ(box.color, (Color{255, 0, 0}));                      // red by default
  EXPECT_NEAR(OnlyBox(Import("model ( )")).size_x, 0.1, 1e-12);  // as is this size
}

TEST(StageWorldC3, APoseOfThreeNumbersHasNoHeight) {
  const StageWorld world = Import("model ( pose [ 1 2 90 ] )");
  EXPECT_NEAR(OnlyBox(world).pose.yaw, kPi / 2.0, 1e-12);
}

TEST(StageWorldC3, ColoursAreOfX11OrRgba) {
  EXPECT_EQ(OnlyBox(Import("model ( color \"green\" )")).color, (Color{0, 255, 0}));
  EXPECT_EQ(OnlyBox(Import("model ( color \"Dark Olive Green\" )")).color, (Color{85, 107, 47}));
  EXPECT_EQ(OnlyBox(Import("model ( color \"grey30\" )")).color, (Color{77, 77, 77}));
  EXPECT_EQ(OnlyBox(Import("model ( color_rgba [ 1 0.5 0 1 ] )")).color, (Color{255, 128, 0}));
  EXPECT_TRUE(HasNote(Import("model ( color \"geen\" )"), "did you mean 'green'?"));
  EXPECT_EQ(X11Color("gray100"), (Color{255, 255, 255}));
  EXPECT_FALSE(X11Color("gray101").has_value());
  EXPECT_GT(X11ColorNames().size(), 400U);
}

TEST(StageWorldC3, DarkPixelsOfABitmapAreBoxes) {
  // The picture's edges are the model's size, row 0 is at the top.
  const StageWorld world =
      Import("model ( bitmap \"plan.png\" size [ 4 2 0.5 ] )", {"##..", "...#"});
  const std::vector<Box>& boxes = world.scenario.world.boxes;
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_DOUBLE_EQ(boxes[0].size_x, 2.0);
  EXPECT_DOUBLE_EQ(boxes[0].size_y, 1.0);
  EXPECT_DOUBLE_EQ(boxes[0].height, 0.5);
  EXPECT_DOUBLE_EQ(InStage(world, {boxes[0].pose.x, 0.0}).x, -1.0);
  EXPECT_DOUBLE_EQ(InStage(world, {0.0, boxes[0].pose.y}).y, 0.5);
  EXPECT_DOUBLE_EQ(InStage(world, {boxes[1].pose.x, 0.0}).x, 1.5);
  EXPECT_DOUBLE_EQ(InStage(world, {0.0, boxes[1].pose.y}).y, -0.5);
}

TEST(StageWorldC3, RectanglesAreAsFewAsASweepGives) {
  const auto count = [](const std::vector<std::string>& rows) {
    return DarkRectangles(Picture(rows)).size();
  };
  EXPECT_EQ(count({"...", "..."}), 0U);
  EXPECT_EQ(count({"###", "###"}), 1U);
  EXPECT_EQ(count({"###", "#.#", "###"}), 4U);
  EXPECT_EQ(count({".#.", "###", ".#."}), 2U);  // they overlap in the middle
  EXPECT_EQ(count({"#.", ".#"}), 2U);
  // Whatever the picture, exactly its dark pixels are covered.
  const Image image = Picture({"##.###", ".####.", "#..##.", "###..#"});
  std::vector<int> covered(image.pixels.size(), 0);
  for (const PixelRect& r : DarkRectangles(image)) {
    for (int y = r.y; y < r.y + r.height; ++y) {
      for (int x = r.x; x < r.x + r.width; ++x)
        covered[static_cast<std::size_t>(y) * 6U + static_cast<std::size_t>(x)] = 1;
    }
  }
  for (std::size_t i = 0; i < covered.size(); ++i) {
    EXPECT_EQ(covered[i] == 1, image.pixels[i].r <= 127) << i;
  }
}

TEST(StageWorldC3, AMissingBitmapIsAnError) {
  EXPECT_EQ(WorldError("model (\n bitmap \"no.png\" )").substr(0, 44),
            "dir/test.world:2: cannot read dir/no.png; na");
}

TEST(StageWorldC3, PicturesMayBePnm) {
  const std::string plain = "P1 # c\n3 1\n101";
  EXPECT_EQ(ParsePnm(plain, "x").pixels[0], (Color{0, 0, 0}));
  EXPECT_EQ(ParsePnm(plain, "x").pixels[1], (Color{255, 255, 255}));
  EXPECT_EQ(ParsePnm(std::string("P4\n3 1\n\xA0", 8), "x").pixels[2], (Color{0, 0, 0}));
  EXPECT_EQ(ParsePnm("P2 2 1 15 15 0", "x").pixels[0], (Color{255, 255, 255}));
  EXPECT_EQ(ParsePnm(std::string("P5 1 1 255 \x40", 12), "x").pixels[0], (Color{64, 64, 64}));
  EXPECT_EQ(ParsePnm(std::string("P5 1 1 65535 \x80\x00", 15), "x").pixels[0],
            (Color{127, 127, 127}));
  EXPECT_EQ(ParsePnm("P3 1 1 255 1 2 3", "x").pixels[0], (Color{1, 2, 3}));
  EXPECT_EQ(ParsePnm(std::string("P6 1 1 255 \x01\x02\x03", 14), "x").pixels[0], (Color{1, 2, 3}));
  for (const char* const bad :
       {"P5 2 2 255 x", "P9 1 1 1", "P2 1 1 255", "P5 99999999 99999999 255 ", "P5 0 1 255 ",
        "P5 4000 4000 255 x", "P2 1 1 70000 1"}) {
    EXPECT_THROW(ParsePnm(bad, "x"), Error) << bad;
  }
}

TEST(StageWorldC3, BlocksAreScaledToTheSizeAsOneGroup) {
  const StageWorld world = Import(
      "model ( size [ 3 1 0.5 ]\n"
      " block ( points 4 point[0] [ 0 0 ] point[1] [ 10 0 ] point[2] [ 10 10 ] point[3] [ 0 10 ] "
      ")\n"
      " block ( points 4 point[0] [ 20 0 ] point[1] [ 30 0 ] point[2] [ 30 10 ] point[3] [ 20 10 ] "
      ")"
      ")");
  const std::vector<Box>& boxes = world.scenario.world.boxes;
  ASSERT_EQ(boxes.size(), 2U);
  EXPECT_DOUBLE_EQ(boxes[0].size_x, 1.0);
  EXPECT_DOUBLE_EQ(InStage(world, {boxes[0].pose.x, 0.0}).x, -1.0);
  EXPECT_DOUBLE_EQ(InStage(world, {boxes[1].pose.x, 0.0}).x, 1.0);
  EXPECT_DOUBLE_EQ(boxes[0].height, 0.5);
}

TEST(StageWorldC3, OtherPolygonsArePrisms) {
  // An L, which is not convex: 2 walls a side, and a lid of 4 triangles.
  const StageWorld world = Import(
      "model ( name \"ell\" size [ 3 3 0.4 ] block ( points 6 point[0] [ 0 0 ] point[1] [ 3 0 ]\n"
      " point[2] [ 3 1 ] point[3] [ 1 1 ] point[4] [ 1 3 ] point[5] [ 0 3 ] z [ 0 2 ] ) )");
  ASSERT_EQ(world.scenario.world.meshes.size(), 1U);
  const Mesh& mesh = world.scenario.world.meshes[0];
  EXPECT_EQ(mesh.name, "ell");
  EXPECT_EQ(mesh.triangles.size(), 6U * 2U + 4U);
  double top = 0.0;
  for (const Vec3& vertex : mesh.vertices) top = std::max(top, vertex.z);
  EXPECT_DOUBLE_EQ(top, 0.4);
  EXPECT_EQ(WorldError("model ( block ( points 2 ) )").substr(0, 25), "dir/test.world:1: points ");
  EXPECT_NE(WorldError("model ( block ( points 3 point[0] [ 0 0 ] ) )").find("lacks point[1]"),
            std::string::npos);
}

TEST(StageWorldC3, AConcaveOutlineFallsIntoConvexPieces) {
  const std::vector<Vec2> ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const std::vector<std::vector<Vec2>> pieces = ConvexPieces(ell);
  EXPECT_EQ(pieces.size(), 2U);
  double area = 0.0;
  for (const std::vector<Vec2>& piece : pieces) {
    EXPECT_TRUE(IsStrictlyConvex(piece));
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
      area += 0.5 * Cross(piece[i] - piece[0], piece[i + 1] - piece[0]);
    }
  }
  EXPECT_NEAR(area, 5.0, 1e-12);
  std::vector<Vec2> round;
  for (int i = 0; i < 40; ++i) {
    const auto [s, c] = SinCos(2.0 * kPi * i / 40.0);
    round.push_back({c, s});
  }
  const std::vector<Vec2> around = HullOf(round, 16);
  EXPECT_LE(around.size(), 16U);
  EXPECT_TRUE(IsStrictlyConvex(around));
  for (const Vec2 point : round) EXPECT_LT(DistanceBeyondEdges(around, point), 1e-9);
}

TEST(StageWorldC3, WhatIsFlatHasAMillimetre) {
  const StageWorld world = Import("model ( size [ 1 1 0 ] )");
  EXPECT_TRUE(HasNote(world, "size has 0 m in it"));
  EXPECT_DOUBLE_EQ(OnlyBox(world).height, 0.001);
}

TEST(StageWorldC3, NoblocksLeavesNothing) {
  EXPECT_TRUE(Import("model ( noblocks 1 size [ 1 1 1 ] )").scenario.world.boxes.empty());
}

TEST(StageWorldC3, ABoundaryIsFourWalls) {
  const StageWorld world = Import("model ( noblocks 1 boundary 1 size [ 4 2 0.5 ] )");
  EXPECT_EQ(world.scenario.world.boxes.size(), 4U);
  EXPECT_DOUBLE_EQ(world.scenario.world.size_x, 4.0);
}

TEST(StageWorldC3, WhoSeesAndWhoCollides) {
  EXPECT_TRUE(OnlyBox(Import("model ( )")).solid);
  EXPECT_FALSE(OnlyBox(Import("model ( obstacle_return 0 )")).solid);
  EXPECT_TRUE(OnlyBox(Import("model ( ranger_return 0 )")).visible);
  EXPECT_FALSE(OnlyBox(Import("model ( ranger_return -1 )")).visible);
  EXPECT_FALSE(OnlyBox(Import("model ( laser_return 0 )")).visible);  // Stage 3
}

TEST(StageWorldC3, ChildrenStandOnTheirParent) {
  const StageWorld world = Import(
      "model ( pose [ 1 0 0 90 ] size [ 1 1 0.4 ]\n"
      " model ( pose [ 0.2 0 0 0 ] size [ 0.2 0.2 0.3 ] ) )");
  // What does not begin at the floor is a mesh.
  ASSERT_EQ(world.scenario.world.meshes.size(), 1U);
  const Mesh& top = world.scenario.world.meshes[0];
  double low = 10.0;
  double high = 0.0;
  Vec2 middle;
  for (const Vec3& vertex : top.vertices) {
    low = std::min(low, vertex.z);
    high = std::max(high, vertex.z);
    middle = middle + (1.0 / static_cast<double>(top.vertices.size())) * Vec2{vertex.x, vertex.y};
  }
  EXPECT_DOUBLE_EQ(low, 0.4);
  EXPECT_DOUBLE_EQ(high, 0.7);
  EXPECT_NEAR(InStage(world, middle).x, 1.0, 1e-12);
  EXPECT_NEAR(InStage(world, middle).y, 0.2, 1e-12);
  const StageWorld flat =
      Import("model ( size [ 1 1 0.4 ] stack_children 0 model ( size [ 0.2 0.2 0.3 ] ) )");
  EXPECT_EQ(flat.scenario.world.boxes.size(), 2U);
}

TEST(StageWorldC3, PositionModelsAreRobots) {
  const StageWorld world = Import(
      "position ( name \"r-0\" size [ 0.5 0.3 0.2 ] mass 4 color \"blue\"\n"
      " velocity_bounds [ -0.4 0.4 0 0 0 0 -90 90 ] )");
  const RobotDef& robot = world.scenario.robots.at(0);
  EXPECT_EQ(robot.name, "r_0");
  EXPECT_EQ(robot.type, "Custom");
  EXPECT_EQ(robot.color, (Color{0, 0, 255}));
  ASSERT_TRUE(robot.body.has_value());
  EXPECT_EQ(robot.body->footprint.size(), 4U);
  EXPECT_DOUBLE_EQ(robot.body->mass, 4.0);
  EXPECT_DOUBLE_EQ(robot.body->max_speed, 0.4);
  EXPECT_DOUBLE_EQ(robot.body->max_turn_rate, kPi / 2.0);
  EXPECT_EQ(robot.body->drive, "diff");
  ASSERT_EQ(robot.body->hull.size(), 1U);
  EXPECT_DOUBLE_EQ(robot.body->hull[0].top, 0.2);
  EXPECT_EQ(robot.proxies.at("position2d").at(0), "pose");
  EXPECT_EQ(world.robots.at(0).models.at(0).name, "r-0");
  EXPECT_DOUBLE_EQ(Import("position ( )").scenario.robots[0].body->max_speed, 1.0);
}

TEST(StageWorldC3, TwoRobotsOfOneNameAreRefused) {
  EXPECT_NE(WorldError("position ( name \"a\" )\nposition ( name \"a\" pose [ 2 0 0 0 ] )")
                .find("test.world:2: two robots are called 'a'"),
            std::string::npos);
}

TEST(StageWorldC3, ARobotThatStandsInSomethingIsRefused) {
  EXPECT_NE(WorldError("model ( size [ 1 1 1 ] )\nposition ( name \"a\" )")
                .find("test.world:2: robot 'a' at"),
            std::string::npos);
}

TEST(StageWorldC3, Drives) {
  const StageWorld omni =
      Import("position ( drive \"omni\" velocity_bounds [ -1 1 -0.4 0.4 0 0 -90 90 ] )");
  EXPECT_EQ(omni.scenario.robots[0].body->drive, "omni");
  EXPECT_DOUBLE_EQ(omni.scenario.robots[0].body->max_side_speed, 0.4);
  const StageWorld car = Import("position ( drive \"car\" wheelbase 0.3 )");
  EXPECT_DOUBLE_EQ(car.scenario.robots[0].body->wheelbase, 0.3);
  EXPECT_DOUBLE_EQ(car.scenario.robots[0].body->max_side_speed, 0.0);
  EXPECT_NE(WorldError("position ( drive \"legs\" )").find("diff, omni or car"), std::string::npos);
}

TEST(StageWorldC3, LocalizationGpsAndOdom) {
  const StageWorld odom =
      Import("position ( pose [ 1 2 0 90 ] localization \"odom\" odom_error [ 0.1 0.2 0 0.3 ] )");
  const RobotDef& robot = odom.scenario.robots[0];
  EXPECT_EQ(robot.proxies.at("position2d").at(0), "odometry");
  EXPECT_DOUBLE_EQ(robot.odometry.error.x, 0.1);
  EXPECT_DOUBLE_EQ(robot.odometry.error.z, 0.3);
  EXPECT_DOUBLE_EQ(robot.odometry.start.x, 0.0);
  const StageWorld placed = Import(
      "position ( pose [ 1 2 0 90 ] localization \"odom\" localization_origin [ 1 0 0 90 ] )");
  const OdometryDef& odometry = placed.scenario.robots[0].odometry;
  EXPECT_NEAR(odometry.start.x, 2.0, 1e-12);
  EXPECT_NEAR(odometry.start.y, 0.0, 1e-12);
  EXPECT_NEAR(odometry.start.yaw, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(odometry.error.x, 0.03);  // Stage's default
  EXPECT_DOUBLE_EQ(Import("position ( )").scenario.robots[0].odometry.error.x, 0.0);
  EXPECT_NE(WorldError("position ( localization \"x\" )").find("gps or odom"), std::string::npos);
}

TEST(StageWorldC3, WhatOfAPositionIsNotSupportedIsNamed) {
  const StageWorld world = Import(
      "position (\nvelocity [ 1 0 0 0 ]\nacceleration_bounds [ -1 1 0 0 0 0 -9 9 ]\n"
      "velocity_bounds [ -0.1 1 0 0 0 0 -90 90 ]\nobstacle_return 0\nctrl \"wander\" )");
  EXPECT_TRUE(HasNote(world, ":2: 'velocity'"));
  EXPECT_TRUE(HasNote(world, ":3: 'acceleration_bounds'"));
  EXPECT_TRUE(HasNote(world, ":4: robot 'position:0' is as fast one way as the other"));
  EXPECT_TRUE(HasNote(world, ":5: obstacle_return 0"));
  EXPECT_TRUE(HasNote(world, ":6: the controller 'wander'"));
}

TEST(StageWorldC3, OneSensorOfManySamplesIsAScanner) {
  const StageWorld world = Import(
      "position ( size [ 0.4 0.4 0.2 ] ranger ( pose [ 0.1 0 0.05 30 ] update_interval 50\n"
      " sensor ( pose [ 0.1 0 0.01 0 ] range [ 0 6 ] fov 180 samples 181 noise [ 0.02 0 0 ] ) ) )");
  const RobotDef& robot = world.scenario.robots[0];
  EXPECT_EQ(robot.front, "laser");
  EXPECT_EQ(robot.laser.samples, 181);
  EXPECT_DOUBLE_EQ(robot.laser.scan_window_deg, 180.0);
  EXPECT_DOUBLE_EQ(robot.laser.resolution_deg, 1.0);  // first and last beam on the edges
  EXPECT_DOUBLE_EQ(robot.laser.range, 6.0);
  EXPECT_DOUBLE_EQ(robot.laser.range_std, 0.02);
  EXPECT_DOUBLE_EQ(robot.laser.frequency, 20.0);
  EXPECT_NEAR(robot.laser.position.x, 0.1 + 0.1 * std::cos(Radians(30.0)), 1e-12);
  EXPECT_NEAR(robot.laser.position.z, 0.2 + 0.05 + 0.01, 1e-12);  // stacked on the body
  EXPECT_NEAR(robot.laser.yaw, Radians(30.0), 1e-12);
  EXPECT_EQ(robot.proxies.at("laser").at(0), "hokuyo");
  EXPECT_EQ(world.robots[0].models.at(1).components, std::vector<std::string>{"hokuyo"});
  EXPECT_EQ(world.robots[0].models.at(1).name, "position:0.ranger:0");
}

TEST(StageWorldC3, ManySensorsAreARing) {
  const StageWorld world = Import(
      "define s sensor ( range [ 0.1 4 ] fov 20 samples 1 )\n"
      "position ( size [ 0.4 0.4 0.2 ] ranger ( s ( pose [ 0.2 0 0 0 ] ) s ( pose [ 0 0.2 0 90 ] )"
      ") )");
  const RobotDef& robot = world.scenario.robots[0];
  ASSERT_TRUE(robot.sonar.has_value());
  EXPECT_DOUBLE_EQ(robot.sonar->min_range, 0.1);
  EXPECT_DOUBLE_EQ(robot.sonar->range, 4.0);
  EXPECT_NEAR(robot.sonar->cone_deg, 20.0, 1e-12);
  ASSERT_EQ(robot.sonar->mounts.size(), 2U);
  EXPECT_DOUBLE_EQ(robot.sonar->mounts[1].position.y, 0.2);
  EXPECT_DOUBLE_EQ(robot.sonar->mounts[1].yaw, kPi / 2.0);
  EXPECT_EQ(robot.front, "none");
}

TEST(StageWorldC3, FurtherRangersHaveNamesOfTheirOwn) {
  const StageWorld world = Import(
      "define scan ranger ( sensor ( fov 90 samples 10 ) )\n"
      "define ring ranger ( sensor ( ) sensor ( ) )\n"
      "position ( scan ( ) scan ( name \"rear\" ) ring ( ) ring ( ) )");
  const RobotDef& robot = world.scenario.robots[0];
  ASSERT_EQ(robot.rangers.size(), 2U);
  EXPECT_EQ(robot.rangers[0].name, "rear");
  EXPECT_TRUE(robot.rangers[0].laser.has_value());
  EXPECT_EQ(robot.rangers[1].name, "ranger_3");  // the fourth ranger
  EXPECT_TRUE(robot.rangers[1].ring.has_value());
}

TEST(StageWorldC3, Stage3RangersHaveScountSposeAndSview) {
  const StageWorld world = Import(
      "position ( size [ 0.4 0.4 0.2 ] ranger ( scount 2 spose[0] [ 0.2 0.1 30 ]\n"
      " spose[1] [ 0.2 -0.1 -30 ] sview [ 0.1 3 25 ] ssize [ 0.01 0.05 ] ) )");
  const RobotDef& robot = world.scenario.robots[0];
  ASSERT_TRUE(robot.sonar.has_value());
  EXPECT_EQ(robot.sonar->mounts.size(), 2U);
  EXPECT_DOUBLE_EQ(robot.sonar->mounts[0].yaw, Radians(30.0));
  EXPECT_DOUBLE_EQ(robot.sonar->range, 3.0);
  EXPECT_NEAR(robot.sonar->cone_deg, 25.0, 1e-12);
}

TEST(StageWorldC3, OldLasersHaveRangeMaxFovAndSamples) {
  const StageWorld world = Import("position ( laser ( range_max 7 fov 120 samples 61 ) )");
  EXPECT_DOUBLE_EQ(world.scenario.robots[0].laser.range, 7.0);
  EXPECT_EQ(world.scenario.robots[0].laser.samples, 61);
  EXPECT_EQ(world.robots[0].models[1].type, "laser");
}

TEST(StageWorldC3, WorldsOfStage2HaveNoHeights) {
  const StageWorld world = Import(
      "size [ 10 6 ] model ( size [ 1 1 ] pose [ 3 0 0 ] )\n"
      "position ( size [ 0.4 0.4 ] laser ( ) )");
  EXPECT_DOUBLE_EQ(world.scenario.world.size_x, 10.0);
  const RobotDef& robot = world.scenario.robots[0];
  // A scanner there sees other robots: it is at half their height.
  EXPECT_DOUBLE_EQ(robot.laser.position.z, 0.5 * robot.body->hull[0].top);
  EXPECT_DOUBLE_EQ(OnlyBox(world).height, 1.0);
}

TEST(StageWorldC3, DevicesThatRobotsDoNotHaveAreNamed) {
  const StageWorld world = Import(
      "position (\nfiducial ( )\nblobfinder ( )\nbumper ( )\ncamera ( )\ngripper ( )\nactuator ( "
      ")\n"
      "blinkenlight ( )\nlightindicator ( ) )");
  int line = 2;
  for (const char* const type : {"fiducial", "blobfinder", "bumper", "camera", "gripper",
                                 "actuator", "blinkenlight", "lightindicator"}) {
    EXPECT_TRUE(HasNote(world, "test.world:" + std::to_string(line++) + ": " + type)) << type;
  }
  EXPECT_TRUE(HasNote(Import("camera ( )"), "is on no robot"));
}

TEST(StageWorldC3, ModelsOnARobotBelongToItsBody) {
  const StageWorld world =
      Import("position ( size [ 0.4 0.4 0.2 ] model ( pose [ 0.3 0 0 0 ] size [ 0.4 0.1 0.1 ] ) )");
  const BodyDef& body = *world.scenario.robots[0].body;
  EXPECT_EQ(body.hull.size(), 2U);
  double front = 0.0;
  for (const Vec2 corner : body.footprint) front = std::max(front, corner.x);
  EXPECT_DOUBLE_EQ(front, 0.5);
}

TEST(StageWorldC3, AnInvisibleRobotHasNoHull) {
  EXPECT_TRUE(Import("position ( ranger_return -1 )").scenario.robots[0].body->hull.empty());
}

TEST(StageWorldC3, WhatMakesNoSenseIsAnError) {
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(WorldError(text).find(part), std::string::npos) << text << "\n" << WorldError(text);
  };
  expect("model ( size [ -1 1 1 ] )", "size has -1 m in it");
  expect("model ( size [ 9 9 900 ] model ( size [ 1 1 900 ] ) )", "1800 m away");
  expect("model ( pose [ 5000 0 0 0 ] )", "is the unit right?");
  expect("position ( mass 0 )", "mass is 0 kg");
  expect("position ( ranger ( sensor ( range [ 2 1 ] ) ) )", "a range from 2 to 1 m");
  expect("position ( ranger ( sensor ( samples 0 ) ) )", "samples is 0");
  expect("position ( ranger ( sensor ( fov 400 samples 9 ) ) )", "fov is 400");
  expect("position ( sensor ( ) )", "a sensor must be within a ranger");
  expect("model ( block ( points 3 point[0] [ 0 0 ] point[1] [ 1 0 ] point[2] [ 2 0 ] ) )",
         "the blocks have no area");
}

}  // namespace
}  // namespace ccmorse::scene
