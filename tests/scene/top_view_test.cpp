// The picture from above shows what is there, in its colours.

#include "tools/top_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::tools {
namespace {

using scene::FindRobotModel;
using scene::FindScenario;
using scene::LoadScenario;
using scene::Scenario;

TopView ViewOf(const Scenario& scenario) {
  TopView view;
  view.world = &scenario.world;
  for (const scene::RobotDef& robot : scenario.robots) {
    view.robots.push_back({&FindRobotModel(robot.type), robot.pose, robot.color, {}, {}});
  }
  return view;
}

Color At(const TopView& view, const Image& image, Vec2 point) {
  const Pixel pixel = PixelOf(view, point);
  return image.pixels.at(static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(pixel.x));
}

bool IsNear(Color a, Color b, int tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance &&
         std::abs(a.b - b.b) <= tolerance;
}

TEST(W01, PictureHasTheArenasProportions) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  const Image image = RenderTopView(ViewOf(scenario));
  EXPECT_EQ(image.width, static_cast<int>(std::ceil((3.42 + 0.1) * 220.0)));
  EXPECT_EQ(image.height, static_cast<int>(std::ceil((3.72 + 0.1) * 220.0)));
  EXPECT_EQ(image.pixels.size(),
            static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
}

TEST(W03, FloorIsPaintedWhite) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  const TopView view = ViewOf(scenario);
  const Image image = RenderTopView(view);
  for (const Vec2 point : {Vec2{2.1, 2.8}, Vec2{0.9, 2.3}, Vec2{3.2, 1.9}, Vec2{0.2, 0.2}}) {
    EXPECT_TRUE(IsNear(At(view, image, point), {250, 250, 250}, 10)) << point.x << " " << point.y;
  }
}

TEST(W05, WallsAreGreyAndBordersBrown) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  const TopView view = ViewOf(scenario);
  const Image image = RenderTopView(view);
  EXPECT_EQ(At(view, image, {1.71, 3.18}), scenario.world.boxes[59].color);
  EXPECT_EQ(At(view, image, {0.02, 1.86}), scenario.world.boxes[2].color);
  EXPECT_EQ(At(view, image, {0.28, 3.59}), scenario.world.boxes[76].color);
}

TEST(W06, RaisedObstaclesAreRedAndRetractedOnesFaint) {
  const Scenario up = LoadScenario(FindScenario("course_map"));
  const TopView view = ViewOf(up);
  const Image image = RenderTopView(view);
  EXPECT_EQ(At(view, image, {1.78, 1.62}), up.world.boxes[18].color);  // 19, a slab
  EXPECT_EQ(At(view, image, {2.52, 2.35}), up.world.boxes[73].color);  // 74, a turned pillar
  const Scenario down = LoadScenario(FindScenario("syrotek"));
  const TopView flat = ViewOf(down);
  const Color faint = At(flat, RenderTopView(flat), {2.52, 2.35});
  EXPECT_GT(faint.r, 235);
  EXPECT_GT(faint.g, 200);
  EXPECT_LT(faint.g, faint.r);
}

TEST(W07, ShadowsFallToOneSide) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  const TopView view = ViewOf(scenario);
  const Image image = RenderTopView(view);
  // Pillar 73 at (2.40, 2.94), 0.16 m wide: the sun stands to the upper left.
  const Color right = At(view, image, {2.40 + 0.10, 2.94 - 0.04});
  const Color left = At(view, image, {2.40 - 0.10, 2.94 + 0.04});
  EXPECT_LT(right.g, 225);
  EXPECT_GT(left.g, 240);
}

TEST(C04, RobotIsPaintedInItsColor) {
  const Scenario scenario = LoadScenario(FindScenario("docks"));
  const TopView view = ViewOf(scenario);
  const Image image = RenderTopView(view);
  for (const scene::RobotDef& robot : scenario.robots) {
    const auto count = std::count(image.pixels.begin(), image.pixels.end(), robot.color);
    EXPECT_GT(count, 100) << robot.name;
  }
}

TEST(C03, RobotIsPaintedWhereItStandsAndFacesForward) {
  const Scenario scenario = LoadScenario(FindScenario("syrotek"));
  TopView view = ViewOf(scenario);
  view.robots[0].pose = {2.0, 2.5, 0.0};
  const Image image = RenderTopView(view);
  const Color body = view.robots[0].color;
  EXPECT_EQ(At(view, image, {2.0, 2.54}), body);
  EXPECT_LT(At(view, image, {2.035, 2.5}).r, 110);  // the scanner, ahead of the axle
  EXPECT_EQ(At(view, image, {1.985, 2.5}), (Color{255, 255, 255}));  // the arrow
  EXPECT_LT(At(view, image, {2.0, 2.57}).r, 60);                     // a wheel
}

TEST(T06, TrackOnTheCanvasIsGreenAndLiesBeneathTheBoxes) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  TopView view = ViewOf(scenario);
  view.canvas.width = 172;
  view.canvas.height = 186;
  view.canvas.colors.assign(172 * 186, {0, 255, 0});
  view.canvas.alpha.assign(172 * 186, 0);
  for (std::size_t x = 0; x < 172; ++x) view.canvas.alpha[140 * 172 + x] = 255;  // y 2.80..2.82
  for (std::size_t x = 0; x < 172; ++x) view.canvas.alpha[110 * 172 + x] = 128;  // y 2.20..2.22
  const Image image = RenderTopView(view);
  EXPECT_EQ(At(view, image, {1.4, 2.81}), (Color{0, 255, 0}));
  EXPECT_TRUE(IsNear(At(view, image, {1.2, 2.21}), {127, 252, 127}, 6));
  EXPECT_TRUE(IsNear(At(view, image, {1.4, 2.85}), {250, 250, 250}, 10));    // one cell up: floor
  EXPECT_EQ(At(view, image, {0.34, 2.81}), scenario.world.boxes[57].color);  // wall 58 covers it
}

TEST(P29, ScanIsAGreenFan) {
  const Scenario scenario = LoadScenario(FindScenario("syrotek"));
  TopView view = ViewOf(scenario);
  view.robots[0].scan_origin = {1.2, 2.0};
  view.robots[0].scan = {{1.9, 1.8}, {2.0, 2.0}, {1.9, 2.2}};
  const Image image = RenderTopView(view);
  const Color inside = At(view, image, {1.8, 1.9});
  EXPECT_GT(inside.g, inside.r + 15);
  EXPECT_GT(inside.g, inside.b + 15);
  const Color outside = At(view, image, {1.8, 2.4});
  EXPECT_TRUE(IsNear(outside, {250, 250, 250}, 10));
}

TEST(TopViewPicture, IsTheSameEveryTime) {
  const Scenario scenario = LoadScenario(FindScenario("docks"));
  TopView view = ViewOf(scenario);
  view.pixels_per_metre = 60.0;
  EXPECT_TRUE(RenderTopView(view).pixels == RenderTopView(view).pixels);
}

TEST(TopViewPicture, ScalesWithoutMovingThings) {
  const Scenario scenario = LoadScenario(FindScenario("course_map"));
  for (const double scale : {40.0, 500.0}) {
    TopView view = ViewOf(scenario);
    view.pixels_per_metre = scale;
    view.margin = 0.0;
    EXPECT_TRUE(
        IsNear(At(view, RenderTopView(view), {2.52, 2.35}), scenario.world.boxes[73].color, 3))
        << scale;
  }
}

TEST(TopViewPicture, BadInputIsAnError) {
  const Scenario scenario = LoadScenario(FindScenario("syrotek"));
  EXPECT_THROW(RenderTopView(TopView{}), Error);
  for (const double scale : {0.0, -1.0, std::nan(""), 1e9, 9.0}) {
    TopView view = ViewOf(scenario);
    view.pixels_per_metre = scale;
    EXPECT_THROW(RenderTopView(view), Error) << scale;
  }
  TopView view = ViewOf(scenario);
  view.margin = 1e9;
  EXPECT_THROW(RenderTopView(view), Error);
  view = ViewOf(scenario);
  view.margin = -0.1;
  EXPECT_THROW(RenderTopView(view), Error);
  view = ViewOf(scenario);
  view.canvas.width = 10;
  view.canvas.height = 10;
  view.canvas.colors.resize(99);
  view.canvas.alpha.resize(100);
  EXPECT_THROW(RenderTopView(view), Error);
}

}  // namespace
}  // namespace ccmorse::tools
