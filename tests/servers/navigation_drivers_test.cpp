// The server's drivers that navigate, vfh, nd, wavefront and amcl (specs: player.md G.2 to G.5),
// and the interfaces planner and localize, as our own client's proxies see them.

#include <gtest/gtest.h>
#include <libplayerc++/playerc++.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "base/error.h"
#include "base/trig.h"
#include "scene/player/import.h"
#include "tests/servers/served_simulation.h"

namespace ccmorse::servers {
namespace {

using player::DriverDef;
using player::PortSetup;
using PlayerCc::LocalizeProxy;
using PlayerCc::PlannerProxy;
using PlayerCc::PlayerClient;
using PlayerCc::Position2dProxy;

constexpr const char* kNavigationHall = R"({"world": {"name": "hall", "size": [6, 6], "boxes": []},
    "robots": [{"name": "a", "pose": {"x": 3, "y": 3, "yaw_deg": 0}, "sonar": {}}]})";

Json Tuple(std::initializer_list<double> numbers) {
  Json::Array items;
  for (const double number : numbers) items.emplace_back(number);
  return items;
}

DriverDef Vfh(const char* eye = "laser") {
  DriverDef def{"vfh", {{"", "position2d", 1}}, {{"", "position2d", 0}, {"", eye, 0}}};
  def.options.angle_unit = Radians(1.0);
  def.options.values = {{"robot_radius", 0.098},    {"cell_size", 0.02},
                        {"window_diameter", 81.0},  {"safety_dist_0ms", 0.03},
                        {"max_speed", 0.2},         {"max_acceleration", 0.4},
                        {"max_turnrate_0ms", 80.0}, {"free_space_cutoff_0ms", 5e5},
                        {"obs_cutoff_0ms", 6e5},    {"distance_epsilon", 0.06}};
  return def;
}

DriverDef Nd(const char* eye = "laser") {
  DriverDef def{"nd",
                {{"", "position2d", 1}},
                {{"input", "position2d", 0}, {"output", "position2d", 0}, {"", eye, 0}}};
  def.options.angle_unit = Radians(1.0);
  def.options.values = {{"robot_radius", 0.098},
                        {"goal_tol", Tuple({0.06, 10.0})},
                        {"max_speed", Tuple({0.2, 80.0})},
                        {"min_speed", Tuple({0.01, 10.0})},
                        {"avoid_dist", 0.12},
                        {"safety_dist", 0.01},
                        {"rotate_stuck_time", 5.0},
                        {"translate_stuck_time", 5.0},
                        {"translate_stuck_dist", 0.05}};
  return def;
}

// A port of the scenario's first robot, which is called s1r in the arena and a in the hall: what
// it is by the pose in the world, as position2d:0, and what it can see with.
std::vector<PortSetup> PortWith(const std::string& robot, std::vector<DriverDef> drivers) {
  PortSetup setup;
  setup.port = 0;
  setup.name = robot;
  for (const char* const each : {"laser", "sonar", "simulation", "map"}) {
    setup.devices.push_back({robot, {each, 0}});
  }
  setup.devices.push_back({robot, {"ranger", 0, "sonar"}});
  setup.devices.push_back({robot, {"position2d", 0, "pose"}});
  setup.drivers = std::move(drivers);
  return {setup};
}

// A simulation in lock-step with one client of ours, which alone lets time go on.
class ServedDrivers {
 public:
  ServedDrivers(const std::string& scenario, std::vector<PortSetup> setup)
      : served_(scenario, Pace::kLockstep, 0.0, MorseServerOptions{}, 1, RecordOptions{}, 10.0,
                std::move(setup)),
        client_("player://127.0.0.1", static_cast<std::uint32_t>(served_.player_port())) {}

  PlayerClient* client() { return &client_; }
  const sim::Robot& robot() const { return *served_.simulation().robots().front(); }

  // Reads until `done()` or for `seconds` of simulated time; whether it is done.
  template <typename Done>
  bool ReadUntil(double seconds, const Done& done) {
    const double end = served_.simulation().time() + seconds;
    while (served_.simulation().time() < end) {
      client_.Read();
      if (done()) return true;
    }
    return false;
  }

 private:
  ServedSimulation served_;
  PlayerClient client_;
};

double Distance(const player_pose2d_t& a, const player_pose2d_t& b) {
  return std::hypot(a.px - b.px, a.py - b.py);
}

player_pose2d_t PoseOf(const Position2dProxy& position) {
  return {position.GetXPos(), position.GetYPos(), position.GetYaw()};
}

bool Stands(const Position2dProxy& position) {
  return position.GetXSpeed() == 0.0 && position.GetYawSpeed() == 0.0;
}

// Goals one after another, each reached within `tolerance` and with its heading, nothing touched.
void ExpectToReach(ServedDrivers& run, const std::vector<player_pose2d_t>& goals,
                   double tolerance) {
  Position2dProxy position(run.client(), 1);
  for (const player_pose2d_t& goal : goals) {
    position.GoTo(goal);
    EXPECT_TRUE(run.ReadUntil(
        90.0, [&] { return Distance(PoseOf(position), goal) < tolerance && Stands(position); }))
        << "to " << goal.px << " " << goal.py << ", is at " << position.GetXPos() << " "
        << position.GetYPos() << " " << position.GetYaw();
    EXPECT_LT(std::fabs(std::remainder(position.GetYaw() - goal.pa, 2.0 * kPi)), Radians(11.0));
  }
  EXPECT_EQ(run.robot().tally().contacts, 0U);
}

const std::vector<player_pose2d_t> kArenaGoals = {
    {0.9, 2.6, 0.0}, {2.2, 2.2, 1.5}, {1.2, 2.0, -2.0}};

std::string ArenaRobot() { return scene::ParseScenario("{}", "test.json").robots.front().name; }

TEST(PlayerVfh, G2DrivesTheArenasRobotToGoals) {
  ServedDrivers run("{}", PortWith(ArenaRobot(), {Vfh()}));
  ExpectToReach(run, kArenaGoals, 0.07);
}

TEST(PlayerVfh, G2SeesWithASonarOrARangerInstead) {
  for (const char* const eye : {"sonar", "ranger"}) {
    ServedDrivers run(kNavigationHall, PortWith("a", {Vfh(eye)}));
    ExpectToReach(run, {{3.8, 3.6, 1.0}}, 0.07);
  }
}

TEST(PlayerNd, G3DrivesTheArenasRobotToGoals) {
  ServedDrivers run("{}", PortWith(ArenaRobot(), {Nd()}));
  ExpectToReach(run, kArenaGoals, 0.07);
}

TEST(PlayerNd, G3SeesWithASonarBesideTheLaserOrInstead) {
  DriverDef both = Nd();
  both.required.push_back({"", "sonar", 0});
  both.options.values.emplace_back("sonar_bad_transducers", Tuple({0.0}));
  for (const DriverDef& def : {Nd("sonar"), both}) {
    ServedDrivers run(kNavigationHall, PortWith("a", {def}));
    ExpectToReach(run, {{3.8, 3.6, 1.0}}, 0.07);
  }
}

TEST(PlayerGoalDrivers, AGoalThatIsNoPlaceIsDroppedAndSpeedsTakeAGoalAway) {
  for (const DriverDef& def : {Vfh(), Nd()}) {
    ServedDrivers run(kNavigationHall, PortWith("a", {def}));
    Position2dProxy position(run.client(), 1);
    position.GoTo(std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0);
    EXPECT_FALSE(run.ReadUntil(1.0, [&] { return !Stands(position); }));
    position.GoTo(4.5, 3.0, 0.0);
    EXPECT_TRUE(run.ReadUntil(2.0, [&] { return position.GetXSpeed() > 0.05; }));
    position.SetSpeed(0.0, 0.0);
    run.ReadUntil(0.3, [] { return false; });
    EXPECT_FALSE(run.ReadUntil(1.0, [&] { return !Stands(position); }));
  }
}

// The text that a set-up is refused with.
std::string Complaint(DriverDef def, const char* option = nullptr, const Json& value = {}) {
  if (option != nullptr) def.options.values.emplace(def.options.values.begin(), option, value);
  sim::Simulation simulation(scene::ParseScenario(kNavigationHall, "test.json"));
  RunOptions options;
  options.morse.port = 0;
  options.morse.first_stream_port = 0;
  options.player.emplace();
  options.player->setup = PortWith("a", {std::move(def)});
  try {
    const Runner runner(simulation, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(PlayerGoalDrivers, OptionsThatCannotBeAreRefusedByName) {
  EXPECT_EQ(Complaint(Vfh()), "");
  EXPECT_NE(Complaint(Vfh(), "window_diameter", 81.5).find("window_diameter"), std::string::npos);
  EXPECT_NE(Complaint(Vfh(), "cell_size", "large").find("cell_size"), std::string::npos);
  EXPECT_NE(Complaint(Nd(), "goal_tol", 0.5).find("tuple of 2"), std::string::npos);
  EXPECT_NE(Complaint(Nd(), "max_speed", Tuple({0.5})).find("max_speed"), std::string::npos);
  DriverDef two = Vfh();
  two.required.push_back({"", "sonar", 0});
  EXPECT_NE(Complaint(two).find("exactly one"), std::string::npos);
  DriverDef none = Nd();
  none.required.pop_back();
  EXPECT_NE(Complaint(none).find("laser or sonar"), std::string::npos);
  DriverDef planner{"wavefront", {{"", "planner", 0}}, {{"", "position2d", 0}, {"", "map", 0}}};
  EXPECT_EQ(Complaint(planner), "");
  EXPECT_NE(Complaint(planner, "safety_dist", -1.0).find("safety_dist"), std::string::npos);
  EXPECT_NE(Complaint(planner, "update_rate", 0.0).find("update_rate"), std::string::npos);
  DriverDef amcl{
      "amcl", {{"", "localize", 0}}, {{"", "position2d", 0}, {"", "laser", 0}, {"", "map", 0}}};
  EXPECT_EQ(Complaint(amcl), "");
  EXPECT_NE(Complaint(amcl, "init_pose", Tuple({1.0, 2.0})).find("init_pose"), std::string::npos);
  EXPECT_NE(Complaint(amcl, "odom_drift[1]", 3.0).find("odom_drift[1]"), std::string::npos);
  EXPECT_NE(Complaint(amcl, "pf_min_samples", 0.0).find("pf_min_samples"), std::string::npos);
}

TEST(PlayerGoalDrivers, C2OptionsWithoutEffectAreNamedWithTheirPlace) {
  DriverDef def = Vfh();
  def.options.places.assign(def.options.values.size(), "robot.cfg:7");
  def.options.values.emplace_back("cell_sise", 0.1);
  def.options.places.emplace_back("robot.cfg:8");
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(Complaint(def), "");
  const std::string log = ::testing::internal::GetCapturedStderr();
  EXPECT_NE(log.find("robot.cfg:8: 'cell_sise' of driver vfh has no effect"), std::string::npos)
      << log;
  EXPECT_EQ(log.find("robot.cfg:7"), std::string::npos) << log;
  def.options.values.back() = {"sector_angle", "wide"};
  EXPECT_EQ(Complaint(def), "robot.cfg:8: option 'sector_angle' must be a number");
}

// planner:0 and localize:0 of a robot that nothing is said of.
TEST(PlayerPlanner, G4TakesTheArenasRobotToAGoalAsItIsServedByDefault) {
  ServedDrivers run("{}", {});
  PlannerProxy planner(run.client(), 0);
  LocalizeProxy localize(run.client(), 0);
  EXPECT_EQ(planner.GetDriverName(), "wavefront");
  EXPECT_EQ(localize.GetDriverName(), "fakelocalize");
  EXPECT_TRUE(run.ReadUntil(1.0, [&] { return planner.IsValid() && localize.IsValid(); }));
  EXPECT_EQ(planner.GetPathValid(), 0U);
  EXPECT_EQ(planner.GetCurrentWaypointId(), -1);
  EXPECT_EQ(localize.GetHypothCount(), 1U);

  const player_pose2d_t goal{0.5, 1.8, 0.5};
  planner.SetGoalPose(goal.px, goal.py, goal.pa);
  ASSERT_TRUE(run.ReadUntil(1.0, [&] { return planner.GetPathValid() == 1; }));
  EXPECT_EQ(planner.GetGx(), goal.px);
  EXPECT_EQ(planner.GetGoal().pa, goal.pa);
  EXPECT_EQ(planner.GetCurrentWaypointId(), 0);
  planner.RequestWaypoints();
  ASSERT_GE(planner.GetWaypointCount(), 1U);
  EXPECT_EQ(Distance(planner[planner.GetWaypointCount() - 1], goal), 0.0);
  const double straight = Distance(planner.GetPose(), goal);
  EXPECT_GE(planner.GetPathLength(), straight - 0.03);
  EXPECT_LT(planner.GetPathLength(), 4.0 * straight);

  // Paused it stands, and goes on when it may.
  ASSERT_TRUE(
      run.ReadUntil(3.0, [&] { return Distance(planner.GetPose(), goal) < straight - 0.05; }));
  planner.SetEnable(false);
  run.ReadUntil(0.3, [] { return false; });
  const player_pose2d_t stood = planner.GetPose();
  EXPECT_FALSE(run.ReadUntil(1.0, [&] { return Distance(planner.GetPose(), stood) > 1e-9; }));
  EXPECT_EQ(planner.GetPathValid(), 1U);
  planner.SetEnable(true);
  EXPECT_TRUE(run.ReadUntil(90.0, [&] { return planner.GetPathDone() == 1; }));
  EXPECT_LT(Distance(planner.GetPose(), goal), 0.1);
  EXPECT_LT(Distance(localize.GetHypoth(0).mean, planner.GetPose()), 1e-9);
  EXPECT_EQ(run.robot().tally().contacts, 0U);

  // Into a wall there is no way, and it does not set off.
  planner.SetGoalPose(0.0, 0.0, 0.0);
  const player_pose2d_t here = planner.GetPose();
  EXPECT_FALSE(run.ReadUntil(2.0, [&] {
    return planner.GetPathValid() == 1 && planner.GetGx() == 0.0 && planner.GetGy() == 0.0;
  }));
  EXPECT_EQ(planner.GetPathDone(), 0U);
  EXPECT_LT(Distance(planner.GetPose(), here), 0.05);
  planner.SetGoalPose(std::numeric_limits<double>::infinity(), 0.0, 0.0);
  run.ReadUntil(0.3, [] { return false; });
  EXPECT_EQ(planner.GetGx(), 0.0);
}

std::string Imported(const std::string& name) {
  return scene::ToJson(
             scene::ImportScenario(std::string(CCMORSE_SOURCE_DIR) + "/tests/worlds/" + name)
                 .scenario)
      .Dump();
}

// The robot's place in the map's frame, whose origin is the middle of the world.
player_pose2d_t TruePlace(const ServedDrivers& run) {
  const Pose2& pose = run.robot().pose();
  return {pose.x - 1.725, pose.y - 1.875, pose.yaw};
}

TEST(PlayerNavigation, G2G4G5ARobotThatHasToFindItsPlaceIsPlannedAndDrivenToGoals) {
  ServedDrivers run(Imported("localize.cfg"), {});
  PlannerProxy planner(run.client(), 0);
  LocalizeProxy localize(run.client(), 0);
  Position2dProxy odometry(run.client(), 0);
  EXPECT_EQ(localize.GetDriverName(), "amcl");
  ASSERT_TRUE(run.ReadUntil(2.0, [&] { return planner.IsValid() && localize.IsValid(); }));
  // Behind the long wall, beside the short one, and back.
  double worst = 0.0;
  for (const player_pose2d_t& goal :
       {player_pose2d_t{0.8, 0.9, 1.5}, player_pose2d_t{1.1, -1.1, -1.0},
        player_pose2d_t{-1.1, -0.6, 3.0}}) {
    planner.SetGoalPose(goal.px, goal.py, goal.pa);
    ASSERT_TRUE(run.ReadUntil(1.0, [&] { return planner.GetPathDone() == 0; }));
    EXPECT_TRUE(run.ReadUntil(120.0,
                              [&] {
                                worst = std::max(
                                    worst, Distance(localize.GetHypoth(0).mean, TruePlace(run)));
                                return planner.GetPathDone() == 1;
                              }))
        << "to " << goal.px << " " << goal.py << ", is at " << planner.GetPx() << " "
        << planner.GetPy() << " " << planner.GetPa();
    EXPECT_LT(Distance(TruePlace(run), goal), 0.2);
    EXPECT_LT(Distance(planner.GetPose(), TruePlace(run)), 0.1);
  }
  EXPECT_LT(worst, 0.25);
  EXPECT_GT(Distance(PoseOf(odometry), TruePlace(run)), 0.02);  // what it would believe without
  EXPECT_EQ(run.robot().tally().contacts, 0U);
}

TEST(PlayerLocalize, G5ParticlesGoWhereSetPosePutsThem) {
  ServedDrivers run(Imported("localize.cfg"), {});
  LocalizeProxy localize(run.client(), 0);
  ASSERT_TRUE(run.ReadUntil(2.0, [&] { return localize.IsValid(); }));
  EXPECT_EQ(localize.GetPendingCount(), 0U);
  const auto weights = [&] {
    double sum = 0.0;
    for (std::uint32_t i = 0; i < localize.GetHypothCount(); ++i)
      sum += localize.GetHypoth(i).alpha;
    return sum;
  };
  EXPECT_GT(weights(), 0.9);
  EXPECT_LT(weights(), 1.001);
  double there[3] = {1.0, 1.2, 0.5};
  double spread[6] = {0.01, 0.01, 0.01, 0.0, 0.0, 0.0};
  localize.SetPose(there, spread);
  ASSERT_EQ(localize.GetParticles(), 0);
  ASSERT_GE(localize.GetNumParticles(), 200U);
  double x = 0.0;
  double y = 0.0;
  for (std::uint32_t i = 0; i < localize.GetNumParticles(); ++i) {
    x += localize.GetParticlePose(static_cast<int>(i)).px / localize.GetNumParticles();
    y += localize.GetParticlePose(static_cast<int>(i)).py / localize.GetNumParticles();
  }
  EXPECT_NEAR(x, 1.0, 0.02);
  EXPECT_NEAR(y, 1.2, 0.02);
  run.client()->Read();
  EXPECT_LT(Distance(localize.GetHypoth(0).mean, {1.0, 1.2, 0.5}), 0.3);
  double wrong[6] = {-1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_THROW(localize.SetPose(there, wrong), PlayerCc::PlayerError);
  there[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(localize.SetPose(there, spread), PlayerCc::PlayerError);
}

}  // namespace
}  // namespace ccmorse::servers
