// Each measure against a value known by hand, from records of runs that are scripted here.

#include "grade/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/trig.h"
#include "grade/map_answer.h"
#include "grade/report.h"
#include "scene/scenario.h"
#include "servers/record/recorder.h"
#include "servers/record/replay.h"
#include "tests/support/process.h"
#include "tests/support/record_file.h"

namespace ccmorse::grade {
namespace {

// A hall of 4 x 2 m with walls of 0.1 m around it: inside x 0.1..3.9, y 0.1..1.9.
std::string Hall(const std::string& robots) {
  return R"({"world": {"name": "hall", "size": [4, 2],
    "kinds": {"border": {"height": 0.16, "color": "#444444"}},
    "boxes": [{"id": 1, "kind": "border", "x": 2, "y": 0.05, "size": [4, 0.1]},
              {"id": 2, "kind": "border", "x": 2, "y": 1.95, "size": [4, 0.1]},
              {"id": 3, "kind": "border", "x": 0.05, "y": 1, "size": [0.1, 2]},
              {"id": 4, "kind": "border", "x": 3.95, "y": 1, "size": [0.1, 2]}]},
    "canvas": {"width": 200, "height": 100},
    "robots": [)" +
         robots + "]}";
}

const char* const kOne = R"({"name": "s1r", "pose": {"x": 0.5, "y": 1.0}})";

// A run whose inputs a test gives, and its record.
class Script {
 public:
  explicit Script(const std::string& scenario, bool contest = true)
      : simulation_(scene::ParseScenario(scenario, "hall.json")),
        directory_(simulation_, servers::RunControl{}) {
    directory_.set_contest(contest);
    servers::RecordOptions options;
    options.data = "none";
    options.hash_every = 60;
    options.contest = contest;
    recorder_ = std::make_unique<servers::Recorder>(simulation_, File(), options);
    directory_.set_input_tap([this](const servers::Input& input) { recorder_->Incoming(input); });
  }

  // Calls a service in the coming tick.
  void Call(const std::string& component, const std::string& service,
            const std::string& arguments) {
    calls_.push_back([=, this] {
      directory_.Call(component, service, arguments, [](const sim::ServiceResult&) {});
    });
  }
  void Speed(double v, double w, const std::string& robot = "s1r") {
    Call(robot + ".motion", "set_speed", fmt::format("[{}, {}]", v, w));
  }
  void Submit(const std::string& name, const std::string& value) {
    Call("s1r.answers", "submit", fmt::format("[\"{}\", {}]", name, value));
  }
  void Go(double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds * 60.0));
    for (int i = 0; i < ticks; ++i) {
      simulation_.Sense();
      recorder_->Sensed();
      for (const auto& call : calls_) call();
      calls_.clear();
      simulation_.Act();
      directory_.TimeAdvanced();
      recorder_->Acted();
    }
  }
  // Ends the record; its file.
  std::string End() {
    if (recorder_) {
      for (const auto& call : calls_) call();
      recorder_->Ended(false);
    }
    recorder_.reset();
    return File();
  }
  const sim::Simulation& simulation() const { return simulation_; }

 private:
  std::string File() const { return folder_.path() + "/run.mcap"; }

  testing::TemporaryFolder folder_;
  sim::Simulation simulation_;
  servers::ServiceDirectory directory_;
  std::unique_ptr<servers::Recorder> recorder_;
  std::vector<std::function<void()>> calls_;
};

Rubric Measuring(const std::string& measure, double full, double none) {
  Rubric rubric;
  rubric.task = "test";
  rubric.seconds = 100.0;
  rubric.criteria = {{"it", measure, 100.0, full, none, "a hint", {}}};
  return rubric;
}

CriterionResult Measure(Script& script, const std::string& measure,
                        const Reference& reference = {}) {
  Rubric rubric = Measuring(measure, 1.0, 0.0);
  rubric.reference = reference;
  return Judge(rubric, script.End()).criteria.at(0);
}

// A second at 0.3 m/s from (0.5, 1) on.
void DriveAMetre(Script& script) {
  script.Speed(0.25, 0.0);
  script.Go(4.0);
  script.Speed(0.0, 0.0);
}

TEST(Judge, DistanceTimeAndEnd) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(2.0);
  EXPECT_NEAR(*Measure(script, "distance_m").value, 1.0, 1e-9);
  EXPECT_DOUBLE_EQ(*Measure(script, "time_s").value, 6.0);
  EXPECT_EQ(*Measure(script, "finished").value, 1.0);
  Rubric short_one = Measuring("finished", 1.0, 0.0);
  short_one.seconds = 6.0;  // it was not the program that ended it
  EXPECT_EQ(*Judge(short_one, script.End()).criteria[0].value, 0.0);
}

TEST(Judge, ContactsAndHowLongTheyLast) {
  Script script(Hall(kOne));
  script.Speed(0.5, 0.0);
  script.Go(7.0);  // the wall comes after (3.9 - 0.5 - front) / 0.5 < 6.8 s
  const double blocked_for = script.simulation().robots()[0]->tally().stalled;
  ASSERT_GT(blocked_for, 0.05);
  script.Speed(-0.5, 0.0);
  script.Go(1.0);
  script.Speed(0.5, 0.0);
  script.Go(2.0);
  EXPECT_EQ(*Measure(script, "contacts").value, 2.0);
  const double way_back = *Measure(script, "contact_s").value - blocked_for;
  EXPECT_NEAR(way_back, 1.0, 0.05);  // back after 1 s, then 1 s against the wall
}

TEST(Judge, WhoDoesNotDriveIsNotPraisedForTouchingNothing) {
  Script script(Hall(kOne));
  script.Go(3.0);
  for (const char* measure : {"contacts", "contact_s", "stuck_s"}) {
    const CriterionResult result = Measure(script, measure);
    EXPECT_FALSE(result.value) << measure;
    EXPECT_EQ(result.points, 0.0);
    EXPECT_NE(result.reason.find("drove 0.00 m"), std::string::npos) << result.reason;
  }
}

TEST(Judge, StuckIsWhoStaysWithinFiveCentimetresForFiveSeconds) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(4.5);  // too short
  script.Speed(0.25, 0.0);
  script.Go(4.0);
  script.Speed(0.0, 0.0);
  script.Go(8.0);
  // Of the way before the stop 0.1 s belong to a window, 2.5 cm; 0.2 s would be 5 cm. The first
  // stop would need 0.5 s of way around it.
  EXPECT_NEAR(*Measure(script, "stuck_s").value, 8.1, 0.11);
}

TEST(Judge, CoverageIsTheVisitedShareOfWhatCanBeReached) {
  Script script(Hall(kOne));
  script.Speed(0.3, 0.0);
  script.Go(10.0);  // 3 m along the middle
  // The disc sweeps 0.2 m + a cell by 3 m and its own diameter; all is 3.8 m x 1.8 m.
  const double swept = 3.0 * 0.22 + kPi * 0.11 * 0.11;
  EXPECT_NEAR(*Measure(script, "coverage").value, swept / (3.8 * 1.8), 0.01);
}

TEST(Judge, WallErrorIsTheRmsOfTheDistanceToTheNearestWall) {
  Script script(Hall(R"({"name": "s1r", "pose": {"x": 0.7, "y": 0.4}})"));
  script.Speed(0.25, 0.0);
  script.Go(10.0);  // 0.3 m from the lower wall all the time
  Reference reference;
  reference.wall_distance_m = 0.25;
  EXPECT_NEAR(*Measure(script, "wall_error_m", reference).value, 0.05, 1e-9);
}

TEST(Judge, OvershootIsHowFarItWentBeyondAsAShareOfTheFirstError) {
  Script script(Hall(R"({"name": "s1r", "pose": {"x": 1.6, "y": 0.9, "yaw_deg": -90}})"));
  script.Speed(0.25, 0.0);
  script.Go(2.4);  // from 0.8 m to 0.2 m; wanted are 0.3 m
  Reference reference;
  reference.wall_distance_m = 0.3;
  EXPECT_NEAR(*Measure(script, "overshoot", reference).value, 0.1 / 0.5, 1e-6);
}

TEST(Judge, TrackingErrorIsTheRmsDistanceToTheTrajectory) {
  Script script(Hall(kOne));
  script.Speed(0.25, 0.0);
  script.Go(8.0);
  Reference reference;
  reference.trajectory = {{0.2, 1.04}, {3.5, 1.04}};
  EXPECT_NEAR(*Measure(script, "tracking_error_m", reference).value, 0.04, 1e-9);
}

TEST(Judge, GoalsAreVisitedInTheirOrder) {
  Script script(Hall(kOne));
  script.Speed(0.25, 0.0);
  script.Go(8.0);  // from x 0.5 to 2.5
  Reference reference;
  reference.goals[""] = {{1.0, 1.1}, {2.0, 1.2}};
  EXPECT_NEAR(*Measure(script, "goal_error_m", reference).value, 0.15, 1e-3);
  // The other way round the best is one moment between them.
  reference.goals[""] = {{2.0, 1.0}, {1.0, 1.0}};
  EXPECT_NEAR(*Measure(script, "goal_error_m", reference).value, 0.5, 1e-3);
}

TEST(Judge, OfSeveralRobotsGoalsTheWorseCounts) {
  Script script(Hall(R"({"name": "s1r", "pose": {"x": 0.5, "y": 1.0}},
                        {"name": "two", "pose": {"x": 0.5, "y": 1.5}})"));
  script.Speed(0.25, 0.0);
  script.Speed(0.25, 0.0, "two");
  script.Go(4.0);
  Reference reference;
  reference.goals["s1r"] = {{1.5, 1.0}};
  reference.goals["two"] = {{1.5, 1.7}};
  EXPECT_NEAR(*Measure(script, "goal_error_m", reference).value, 0.2, 1e-3);
  reference.goals["three"] = {{1.5, 1.7}};
  EXPECT_NE(Measure(script, "goal_error_m", reference).reason.find("no robot three"),
            std::string::npos);
}

TEST(Judge, FinalErrorIsOfWhereTheRobotIsInTheEnd) {
  for (const bool early : {false, true}) {
    Script script(Hall(kOne));
    // Where it starts it knows its pose: an answer then is worth what it is in the end.
    if (early) script.Submit("pose", "[0.5, 1.0, 0.0]");
    DriveAMetre(script);
    script.Go(0.5);
    if (!early) script.Submit("pose", "[1.53, 1.04, 0.0]");  // it is at (1.5, 1.0)
    script.Go(0.1);
    EXPECT_NEAR(*Measure(script, "final_error_m").value, early ? 1.0 : 0.05, 1e-9);
  }
}

TEST(Judge, RobotsGapIsTheSmallestDistanceOfTheirFootprints) {
  Script script(Hall(R"({"name": "s1r", "pose": {"x": 0.5, "y": 1.0}},
                        {"name": "two", "pose": {"x": 2.5, "y": 1.0, "yaw_deg": 180}})"));
  script.Speed(0.25, 0.0);
  script.Speed(0.25, 0.0, "two");
  script.Go(3.0);  // 0.75 m each: the middles are 0.5 m apart
  script.Speed(-0.25, 0.0);
  script.Speed(-0.25, 0.0, "two");
  script.Go(1.0);
  double front = 0.0;
  for (const Vec2& corner : script.simulation().robots()[0]->model().footprint) {
    front = std::max(front, corner.x);
  }
  EXPECT_NEAR(*Measure(script, "robots_gap_m").value, 0.5 - 2.0 * front, 1e-6);
}

// --- Paths

// The robot's cell is (25, 50); the goal is drawn by the seed.
Route RouteOf(const Script& script) { return *DrawRoute(script.simulation().scenario()); }

std::string PathText(const std::vector<Vec2>& points) {
  std::string text;
  for (const Vec2& point : points) {
    text += fmt::format("{}[{}, {}]", text.empty() ? "[" : ", ", point.x, point.y);
  }
  return text + "]";
}

// In an empty hall the oracle's way, m, has as many diagonal steps as the shorter side.
double BestLength(const Route& route) {
  const double dx = std::abs(route.goal.x - route.start.x);
  const double dy = std::abs(route.goal.y - route.start.y);
  return (std::max(dx, dy) + (std::sqrt(2.0) - 1.0) * std::min(dx, dy)) * 0.02;
}

TEST(Judge, AStraightPathIsValidAndTurnsNowhere) {
  Script script(Hall(kOne));
  const Route route = RouteOf(script);
  const Vec2 from = MiddleOf(route.start);
  const Vec2 to = MiddleOf(route.goal);
  script.Submit("path", PathText({from, to}));
  script.Go(0.1);
  EXPECT_EQ(*Measure(script, "path_valid").value, 1.0);
  EXPECT_EQ(*Measure(script, "turning_rad").value, 0.0);
  EXPECT_NEAR(*Measure(script, "length_ratio").value,
              std::hypot(to.x - from.x, to.y - from.y) / BestLength(route), 1e-9);
}

// A path as long as wanted, or of as many points, does not make up for what lies in walls.
TEST(Judge, AWallIsNotThinnedOutByDetoursOrPointsOnTheSpot) {
  for (const bool points : {false, true}) {
    Script script(Hall(kOne));
    const Route route = RouteOf(script);
    const Vec2 from = MiddleOf(route.start);
    std::vector<Vec2> path = {from};
    for (int i = 0; i < 300; ++i) {
      if (!points) path.push_back({from.x + 2.0, from.y});
      path.push_back(from);
    }
    path.insert(path.end(), {{from.x, 0.02}, from, MiddleOf(route.goal)});
    script.Submit("path", PathText(path));
    script.Go(0.1);
    EXPECT_NEAR(*Measure(script, "path_valid").value, 1.0 - 2.0 * (0.22 - 0.02) / BestLength(route),
                0.01);
    EXPECT_FALSE(Measure(script, "turning_rad").value);
  }
}

TEST(Judge, ADetourIsLongerAndTurns) {
  Script script(Hall(kOne));
  const Route route = RouteOf(script);
  const Vec2 from = MiddleOf(route.start);
  const Vec2 to = MiddleOf(route.goal);
  // Out and back along x first: two turns by 180 degrees less what the way on turns.
  const Vec2 away{from.x - 0.1, from.y};
  script.Submit("path", PathText({from, away, from, to}));
  script.Go(0.1);
  const double length = 0.2 + std::hypot(to.x - from.x, to.y - from.y);
  const double turned = kPi + std::fabs(std::atan2(to.y - from.y, to.x - from.x));
  EXPECT_NEAR(*Measure(script, "turning_rad").value, turned / length, 1e-9);
}

TEST(Judge, APathThroughAWallOrElsewhereIsNotValid) {
  Script script(Hall(kOne));
  const Route route = RouteOf(script);
  const Vec2 from = MiddleOf(route.start);
  const Vec2 to = MiddleOf(route.goal);
  // Out into the wall, where the middle may not be below 0.1 + 0.1 m and a cell, and back.
  script.Submit("path", PathText({from, {from.x, 0.02}, from, to}));
  script.Go(0.1);
  const CriterionResult valid = Measure(script, "path_valid");
  EXPECT_NEAR(*valid.value, 1.0 - 2.0 * (0.22 - 0.02) / BestLength(route), 0.01);
  EXPECT_FALSE(Measure(script, "length_ratio").value);

  Script other(Hall(kOne));
  other.Submit("path", PathText({from, {to.x, to.y > 1.0 ? to.y - 0.1 : to.y + 0.1}}));
  other.Go(0.1);
  const CriterionResult elsewhere = Measure(other, "path_valid");
  EXPECT_FALSE(elsewhere.value);
  EXPECT_NE(elsewhere.reason.find("ends 0.10 m from the goal"), std::string::npos);
}

TEST(Judge, AnswersThatMakeNoSenseGiveNoPoints) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"path", "[]"},
                                                                  {"path", "[[1, 2, 3]]"},
                                                                  {"path", "\"text\""},
                                                                  {"path", "[[1, NaN], [1, 2]]"},
                                                                  {"path", "[[1e300, 0], [1, 2]]"}};
  for (const auto& [name, value] : cases) {
    Script script(Hall(kOne));
    script.Submit(name, value);
    script.Go(0.1);
    const CriterionResult result = Measure(script, "path_valid");
    EXPECT_FALSE(result.value) << value;
    EXPECT_NE(result.reason.find("path"), std::string::npos) << result.reason;
  }
}

// --- Maps

std::string MapJson(const std::string& cells, double origin_x = 0.0) {
  return fmt::format(
      R"({{"width": 200, "height": 100, "cell_size": 0.02, "origin": [{}, 0], "cells": "{}"}})",
      origin_x, cells);
}

// The truth, as a map would show it; `seen` says how far to the right it goes.
std::string TrueCells(const scene::World& world, int seen) {
  const Grid walls = Walls(world, 0.0);
  std::string cells;
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 200; ++x) cells += x >= seen ? '?' : walls.Has({x, y}) ? '1' : '0';
  }
  return cells;
}

// Has seen all of the hall when it has driven through it and turned.
void LookAround(Script& script) {
  script.Speed(0.5, 0.0);
  script.Go(5.0);
  script.Speed(0.0, 1.0);
  script.Go(7.0);
  script.Speed(0.0, 0.0);
}

TEST(Judge, ATrueMapIsRightEverywhere) {
  Script script(Hall(kOne));
  LookAround(script);
  script.Submit("map", MapJson(TrueCells(script.simulation().scenario().world, 200)));
  script.Go(0.1);
  EXPECT_EQ(*Measure(script, "cell_accuracy").value, 1.0);
  EXPECT_EQ(*Measure(script, "explored").value, 1.0);
  EXPECT_EQ(*Measure(script, "map_iou").value, 1.0);
}

// The laser looks 270 degrees around: of a robot that stands at (0.5, 1.0) and looks along x, what
// is behind lies between the bearings of 135 and 225 degrees from 3.5 cm before its middle. It
// reaches 4 m.
TEST(Judge, WhatTheRobotDidNotSeeItDidNotMap) {
  Script script(Hall(kOne));
  script.Submit("map", MapJson(TrueCells(script.simulation().scenario().world, 200)));
  script.Go(1.0);
  const double behind = 0.435 * 0.435;  // m^2: to the wall at x = 0.1, as wide on either side
  const double body = kPi * 0.11 * 0.11 / 2.0;
  const double seen = 1.0 - (behind - body) / (3.8 * 1.8);
  EXPECT_NEAR(*Measure(script, "explored").value, seen, 0.005);
  EXPECT_NEAR(*Measure(script, "cell_accuracy").value, seen, 0.005);
  // Of the walls behind, 0.87 m, two cells at either end are near seen ones, and as much again near
  // what the map has there.
  const double hidden = 0.87 - 4 * kTolerance * kCell;
  EXPECT_NEAR(*Measure(script, "map_iou").value, 1.0 - hidden / (2.0 * (3.8 + 1.8)), 0.005);
}

TEST(Judge, AMapOfWallsThatHideTheRestIsWorthWhatWasSeen) {
  std::string hall = Hall(kOne);
  const std::string last = R"("x": 3.95, "y": 1, "size": [0.1, 2]})";
  hall.insert(hall.find(last) + last.size(),
              R"(, {"id": 5, "kind": "border", "x": 2, "y": 0.85, "size": [0.1, 1.5]})");
  Script script(hall);  // the way to the right half leads around the wall's upper end
  script.Submit("map", MapJson(TrueCells(script.simulation().scenario().world, 200)));
  script.Go(1.0);
  const Judgement judged = Judge(Measuring("cell_accuracy", 1.0, 0.0), script.End());
  EXPECT_GT(*judged.criteria[0].value, 0.45);
  EXPECT_LT(*judged.criteria[0].value, 0.65);
  ASSERT_TRUE(judged.map);
  const auto at = [&](Vec2 point) {
    const Cell cell = CellOf(point);
    return judged.map->cells[static_cast<std::size_t>(cell.y * judged.map->width + cell.x)];
  };
  EXPECT_EQ(at({1.0, 1.0}), MapPicture::kFree);
  EXPECT_EQ(at({1.96, 0.8}), MapPicture::kWall);
  EXPECT_EQ(at({3.0, 0.5}), MapPicture::kNotSeen);
}

TEST(Judge, WhereAllIsCalledFreeThereIsNoWall) {
  Script script(Hall(kOne));
  LookAround(script);
  script.Submit("map", MapJson(std::string(20000, '0')));
  script.Go(0.1);
  EXPECT_EQ(*Measure(script, "cell_accuracy").value, 1.0);
  EXPECT_EQ(*Measure(script, "map_iou").value, 0.0);  // what the rubric makes the other depend on
}

TEST(Judge, HalfAMapIsHalfRight) {
  Script script(Hall(kOne));
  LookAround(script);
  script.Submit("map", MapJson(TrueCells(script.simulation().scenario().world, 100)));
  script.Go(0.1);
  EXPECT_NEAR(*Measure(script, "cell_accuracy").value, 0.5, 0.01);
  EXPECT_EQ(*Measure(script, "explored").value, 1.0);  // it saw more than it says
  // All walls said are there; of those to be seen, half.
  EXPECT_NEAR(*Measure(script, "map_iou").value, 0.5, 0.02);
}

TEST(Judge, AMapThatIsWrongOrShiftedScoresSo) {
  Script all_walls(Hall(kOne));
  LookAround(all_walls);
  all_walls.Submit("map", MapJson(std::string(20000, '1')));
  all_walls.Go(0.1);
  EXPECT_EQ(*Measure(all_walls, "cell_accuracy").value, 0.0);
  EXPECT_LT(*Measure(all_walls, "map_iou").value, 0.25);

  Script shifted(Hall(kOne));
  LookAround(shifted);
  shifted.Submit("map", MapJson(TrueCells(shifted.simulation().scenario().world, 200), 0.5));
  shifted.Go(0.1);
  EXPECT_LT(*Measure(shifted, "cell_accuracy").value, 0.9);
}

// --- Scores

TEST(Judge, PointsRiseEvenlyBetweenNoneAndFull) {
  const Criterion rising{"a", "distance_m", 40.0, 3.0, 1.0, "", {}};
  EXPECT_EQ(Points(rising, 0.0), 0.0);
  EXPECT_EQ(Points(rising, 2.0), 20.0);
  EXPECT_EQ(Points(rising, 9.0), 40.0);
  const Criterion falling{"a", "contacts", 40.0, 0.0, 4.0, "", {}};
  EXPECT_EQ(Points(falling, 0.0), 40.0);
  EXPECT_EQ(Points(falling, 1.0), 30.0);
  EXPECT_EQ(Points(falling, 5.0), 0.0);
}

TEST(Judge, AConditionThatDoesNotHoldGivesNoPoints) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(1.0);
  Rubric rubric = Measuring("contacts", 0.0, 1.0);
  rubric.criteria[0].only_if = {{"distance_m", 0.9}};
  EXPECT_EQ(Judge(rubric, script.End()).score, 100.0);
  rubric.criteria[0].only_if.push_back({"distance_m", 1.1});
  const Judgement judged = Judge(rubric, script.End());
  EXPECT_EQ(judged.score, 0.0);
  EXPECT_NE(judged.criteria[0].reason.find("distance_m of 1.1 or more"), std::string::npos);
  rubric.criteria[0].only_if[1] = {"distance_m", 0.0, 0.5};
  EXPECT_NE(Judge(rubric, script.End()).criteria[0].reason.find("distance_m of 0.5 or less"),
            std::string::npos);
  // What cannot be told holds no condition.
  rubric.criteria[0].only_if[1] = {"robots_gap_m", 0.0};
  EXPECT_NE(Judge(rubric, script.End()).criteria[0].reason.find("and it was none"),
            std::string::npos);
}

TEST(Judge, TheScoreIsAPureFunctionOfTheRecord) {
  Script script(Hall(kOne));
  script.Submit("map", MapJson(TrueCells(script.simulation().scenario().world, 120)));
  DriveAMetre(script);
  script.Go(1.0);
  Rubric rubric = Measuring("cell_accuracy", 1.0, 0.0);
  rubric.criteria[0].weight = 50.0;
  rubric.criteria.push_back({"that", "coverage", 50.0, 0.2, 0.0, "", {}});
  Grading grading;
  grading.runs.resize(1);
  grading.runs[0].judgement = Judge(rubric, script.End());
  const std::string first = GradingJson(rubric, grading).Dump();
  const std::string page = GradingPage(rubric, grading);
  EXPECT_GT(grading.score(), 10.0);
  for (int i = 1; i < 100; ++i) {
    grading.runs[0].judgement = Judge(rubric, script.End());
    ASSERT_EQ(GradingJson(rubric, grading).Dump(), first);
    ASSERT_EQ(GradingPage(rubric, grading), page);
  }
}

TEST(Judge, TeleportingCountsNothingAndIsFoundInTheRecord) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(1.0);
  script.Call("simulation", "set_object_position", R"(["s1r", [3.0, 1.0, 0.0]])");
  script.Go(1.0);
  EXPECT_NEAR(script.simulation().robots()[0]->pose().x, 1.5, 1e-9);  // it was refused
  const Judgement judged = Judge(Measuring("distance_m", 1.0, 0.0), script.End());
  EXPECT_EQ(judged.score, 0.0);
  EXPECT_NE(judged.refused.find("at 5.00 s"), std::string::npos) << judged.refused;
  EXPECT_NE(judged.refused.find("set_object_position"), std::string::npos) << judged.refused;
}

TEST(Judge, AskingForTheHiddenWorldIsRefusedToo) {
  for (const auto& [component, service] :
       {std::pair("simulation", "get_scene_objects"), {"arena", "list"}}) {
    Script script(Hall(kOne));
    DriveAMetre(script);
    script.Call(component, service, "");
    script.Go(0.5);
    EXPECT_NE(Judge(Measuring("distance_m", 1.0, 0.0), script.End()).refused.find(service),
              std::string::npos);
  }
}

TEST(Judge, ARunOfNoTicksCountsNothing) {
  Script script(Hall(kOne));
  const Judgement judged = Judge(Measuring("contacts", 0.0, 1.0), script.End());
  EXPECT_EQ(judged.score, 0.0);
  EXPECT_NE(judged.refused.find("never asked"), std::string::npos);
}

TEST(Judge, ARecordThatWasChangedIsRefused) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(1.0);
  const std::string file = script.End();
  std::string bytes = testing::ReadBytes(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  testing::WriteBytes(file, bytes);
  EXPECT_THROW(Judge(Measuring("distance_m", 1.0, 0.0), file), servers::RecordError);
}

TEST(Judge, ARecordWhoseInputsWereChangedWithRightChecksumsIsRefused) {
  Script script(Hall(kOne));
  DriveAMetre(script);
  script.Go(1.0);
  const std::string file = script.End();
  std::vector<testing::RecordedMessage> messages = testing::ReadMessages(file);
  int changed = 0;
  for (testing::RecordedMessage& message : messages) {
    const std::size_t at = message.data.find("[0.25, 0");
    if (message.topic != "/input" || at == std::string::npos) continue;
    message.data.replace(at, 5, "[0.35");
    ++changed;
  }
  ASSERT_EQ(changed, 1);
  testing::WriteMessages(file, messages);
  EXPECT_THROW(Judge(Measuring("distance_m", 1.0, 0.0), file), servers::RecordError);
}

TEST(Report, ThePageIsSafeWhateverThePathIsCalled) {
  Rubric rubric = Measuring("distance_m", 1.0, 0.0);
  rubric.title = "A <b>title</b>";
  Grading grading;
  grading.submission = "<script>alert(1)</script>";
  grading.build_failure = "\"quoted\" & <i>more</i>";
  const std::string page = GradingPage(rubric, grading);
  EXPECT_EQ(page.find("<script>"), std::string::npos);
  EXPECT_EQ(page.find("<i>more"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;"), std::string::npos);
}

TEST(Report, AClassIsSortedAndItsTableIsCsv) {
  const Rubric rubric = Measuring("distance_m", 1.0, 0.0);
  const std::vector<ClassEntry> entries = {
      {"b", 50.0, false, "a \"problem\", or two\nlines", {50.0}},
      {"=a", 90.0, true, "", {90.0}},
      {"c", 50.0, false, "", {}}};
  EXPECT_EQ(ClassCsv(rubric, entries),
            "place,submission,score,passed,\"it\",problem\n"
            "1,\"'=a\",90.00,yes,90.00,\"\"\n"
            "2,\"b\",50.00,no,50.00,\"a \"\"problem\"\", or two lines\"\n"
            "2,\"c\",50.00,no,0.00,\"\"\n");
}

}  // namespace
}  // namespace ccmorse::grade
