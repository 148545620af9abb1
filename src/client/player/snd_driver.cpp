#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/trig.h"
#include "libCCMorse/LaserProxy.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseRobot.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/Position2dProxy.h"
#include "libCCMorse/SndDriver.h"
#include "navigation/snd.h"

namespace CCMorse {

using ccmorse::navigation::Drive;
using ccmorse::navigation::Snd;
using ccmorse::navigation::SndOptions;

namespace {

constexpr char kConstructor[] = "SndDriver::SndDriver()";

SndOptions ReadOptions(const MorseValue& settings) {
  SndOptions options = ccmorse::navigation::SndOptionsForS1r();
  const std::vector<std::string> known = {"robot_radius",  "min_gap_width", "obstacle_avoid_dist",
                                          "max_speed",     "max_turn_rate", "goal_position_tol",
                                          "goal_angle_tol"};
  for (const std::string& key : settings.GetKeys()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw MorseError(
          "drivers.snd: there is no setting \"" + key + "\"" + ccmorse::DidYouMean(key, known),
          kConstructor);
    }
    if (!settings.Member(key).IsNumber()) {
      throw MorseError("drivers.snd." + key + " must be a number", kConstructor);
    }
    const double value = settings.Member(key).GetDouble("");
    if (key == "robot_radius") options.robot_radius = value;
    if (key == "min_gap_width") options.min_gap_width = value;
    if (key == "obstacle_avoid_dist") options.obstacle_avoid_dist = value;
    if (key == "max_speed") options.max_speed = value;
    if (key == "max_turn_rate") options.max_turn_rate = ccmorse::Radians(value);
    if (key == "goal_position_tol") options.goal_position_tol = value;
    if (key == "goal_angle_tol") options.goal_angle_tol = ccmorse::Radians(value);
  }
  try {
    return Snd::Resolved(options);
  } catch (const ccmorse::Error& error) {
    throw MorseError(error.what(), kConstructor);
  }
}

}  // namespace

struct SndDriver::Parts {
  Parts(PlayerClient* client, const std::string& robot, std::uint32_t position_index,
        std::uint32_t laser_index, const SndOptions& options)
      : position(client, position_index, robot), laser(client, laser_index, robot), snd(options) {}

  Position2dProxy position;
  LaserProxy laser;
  std::vector<double> ranges;  // of the driver's thread

  std::mutex mutex;
  std::condition_variable changed;
  // Under the mutex.
  Snd snd;
  Drive last;
  bool driving = false;  // a speed was commanded that may not be 0
  bool running = false;  // Main() is under way
  double time = 0.0;     // s, of the last scan
};

SndDriver::SndDriver(PlayerClient* client, const std::string& robot, std::uint32_t position_index,
                     std::uint32_t laser_index)
    : MorseDriver(client, "snd", robot),
      parts_(std::make_unique<Parts>(client, robot, position_index, laser_index,
                                     ReadOptions(GetConfiguration()))) {}

SndDriver::~SndDriver() {
  Stop();
  try {
    Join();
  } catch (...) {  // what Main() threw is for who calls Join()
  }
}

void SndDriver::GoTo(double x, double y, double yaw) {
  const std::lock_guard lock(parts_->mutex);
  try {
    parts_->snd.SetGoal({x, y, yaw});
  } catch (const ccmorse::Error&) {
    throw MorseError("a number of the goal is not finite", "SndDriver::GoTo()");
  }
  parts_->last = {};
}

void SndDriver::GoTo(player_pose2d_t goal) { GoTo(goal.px, goal.py, goal.pa); }

void SndDriver::Cancel() {
  const std::lock_guard lock(parts_->mutex);
  parts_->snd.ClearGoal();
  parts_->last = {};
}

bool SndDriver::HasGoal() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->snd.goal().has_value();
}

bool SndDriver::IsArrived() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->last.at_goal;
}

bool SndDriver::IsStalled() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->last.stalled;
}

bool SndDriver::WaitForArrival(double timeout) {
  std::unique_lock lock(parts_->mutex);
  std::optional<double> start;
  while (IsRunning() && !parts_->last.at_goal) {
    // Between Start() and the thread's first scan there is no time to measure from.
    if (parts_->running) {
      if (!start) start = parts_->time;
      if (parts_->time - *start >= timeout) break;
    }
    // The thread tells of each scan and of its end; the limit is for one that ended in between.
    parts_->changed.wait_for(lock, std::chrono::milliseconds(100));
  }
  return parts_->last.at_goal;
}

double SndDriver::GetRobotRadius() const { return parts_->snd.options().robot_radius; }
double SndDriver::GetMinGapWidth() const { return parts_->snd.options().min_gap_width.value(); }
double SndDriver::GetObstacleAvoidDist() const {
  return parts_->snd.options().obstacle_avoid_dist.value();
}
double SndDriver::GetMaxSpeed() const { return parts_->snd.options().max_speed; }
double SndDriver::GetMaxTurnRate() const { return parts_->snd.options().max_turn_rate; }
double SndDriver::GetGoalPositionTol() const {
  return parts_->snd.options().goal_position_tol.value();
}
double SndDriver::GetGoalAngleTol() const { return parts_->snd.options().goal_angle_tol; }

void SndDriver::Main() {
  Parts& own = *parts_;
  // However Main() ends, who waits for the goal must learn of it.
  struct Ending {
    Parts& parts;
    ~Ending() {
      const std::lock_guard lock(parts.mutex);
      parts.running = false;
      parts.changed.notify_all();
    }
  } const ending{own};
  while (!StopRequested()) {
    GetPlayerClient()->Read();
    if (!own.laser.IsFresh() || !own.position.IsValid()) continue;
    own.laser.NotFresh();
    const player_pose2d_t pose = own.position.GetPose();
    const player_pose3d_t mount = own.laser.GetPose();
    own.ranges.resize(own.laser.GetCount());
    for (std::size_t i = 0; i < own.ranges.size(); ++i) {
      own.ranges[i] = own.laser.GetRange(static_cast<std::uint32_t>(i));
    }
    Drive drive;
    bool command = false;
    {
      const std::lock_guard lock(own.mutex);
      own.running = true;
      own.time = own.laser.GetDataTime();
      drive = own.snd.Step({pose.px, pose.py, pose.pa}, {own.laser.GetMinAngle(),
                                                         own.laser.GetScanRes(),
                                                         own.laser.GetMaxRange(),
                                                         own.ranges,
                                                         {mount.px, mount.py, mount.pyaw}});
      own.last = drive;
      // Without a goal the robot is the program's; what the driver had commanded ends first.
      const bool busy = own.snd.goal().has_value() && !drive.at_goal;
      command = busy || own.driving;
      own.driving = busy;
    }
    if (command) own.position.SetSpeed(drive.speed, drive.turn_rate);
    own.changed.notify_all();
  }
  // Only this thread commands, so the flag cannot change between here and there.
  bool driving = false;
  {
    const std::lock_guard lock(own.mutex);
    std::swap(driving, own.driving);
  }
  if (driving) own.position.GetRobot().Stop();
}

}  // namespace CCMorse
