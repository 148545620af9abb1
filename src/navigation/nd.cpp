#include "navigation/nd.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/polygon.h"

namespace ccmorse::navigation {
namespace {

constexpr double kSector = 2.0 * kPi / Nd::kSectors;
// A region as wide as this or wider is a wide one (90 degrees).
constexpr int kWideRegion = Nd::kSectors / 4;

int Wrap(int sector) { return ((sector % Nd::kSectors) + Nd::kSectors) % Nd::kSectors; }
std::size_t Index(int sector) { return static_cast<std::size_t>(Wrap(sector)); }
double AngleOf(int sector) {
  const int from_ahead = Wrap(sector) - Nd::kSectors / 2;
  return NormalizeAngle(from_ahead * kSector);
}
int SectorOf(double angle) {
  return Wrap(static_cast<int>(std::lround(angle / kSector)) + Nd::kSectors / 2);
}

}  // namespace

NdOptions NdOptionsForS1r() {
  NdOptions options;
  options.robot_radius = 0.098;
  options.goal_position_tol = 0.06;
  options.max_speed = 0.2;
  options.max_turn_rate = Radians(80.0);
  options.min_speed = 0.01;
  options.avoid_dist = 0.12;
  options.safety_dist = 0.01;
  options.rotate_stuck_time = 5.0;
  options.translate_stuck_time = 5.0;
  options.translate_stuck_dist = 0.05;
  return options;
}

Nd::Nd(const NdOptions& options) : options_(options) {
  const auto check = [](bool right, const char* what) {
    if (!right) throw Error(std::string("nd: ") + what);
  };
  check(options.robot_radius > 0.0, "robot_radius must be positive");
  check(options.goal_position_tol > 0.0 && options.goal_angle_tol > 0.0,
        "goal_tol must be positive");
  check(options.max_speed > 0.0 && options.max_turn_rate > 0.0, "max_speed must be positive");
  check(options.min_speed >= 0.0 && options.min_turn_rate >= 0.0, "min_speed must not be negative");
  check(options.min_speed <= options.max_speed && options.min_turn_rate <= options.max_turn_rate,
        "min_speed must not be above max_speed");
  check(options.avoid_dist > 0.0, "avoid_dist must be positive");
  check(options.safety_dist >= 0.0, "safety_dist must not be negative");
  check(options.laser_buffer >= 1 && options.laser_buffer <= 1000, "laser_buffer must be 1..1000");
  check(options.rotate_stuck_time > 0.0 && options.translate_stuck_time > 0.0,
        "the stuck times must be positive");
  distances_.assign(kSectors, kFree);
  points_.assign(kSectors, Vec2{});
}

void Nd::SetGoal(const Pose2& goal) {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || !std::isfinite(goal.yaw)) {
    throw Error("nd: a number of the goal is not finite");
  }
  goal_ = goal;
  reached_ = false;
  stuck_ = false;
  moved_time_.reset();
  turning_since_.reset();
  seen_.clear();
  going_.reset();
}

// Is the way of the robot's width free for `length` metres?
bool Nd::IsWayClear(double angle, double length) const {
  const auto [sine, cosine] = SinCos(angle);
  const double width = options_.robot_radius + options_.safety_dist;
  for (std::size_t i = 0; i < distances_.size(); ++i) {
    if (distances_[i] >= kFree) continue;
    const double along = Dot({cosine, sine}, points_[i]);
    const double across = Cross({cosine, sine}, points_[i]);
    if (along > 0.0 && along < length && std::abs(across) < width) return false;
  }
  return true;
}

std::optional<Nd::Region> Nd::ChooseRegion(double target, double last) const {
  const double diameter = 2.0 * (options_.robot_radius + options_.safety_dist);
  std::optional<Region> best;
  double best_off = 0.0;
  // A free region begins beside a corner: where the distance jumps by more than the robot's
  // diameter. It goes on, away from the corner, as long as nothing is nearer than that.
  for (int i = 0; i < kSectors; ++i) {
    for (const int side : {1, -1}) {
      const double corner = distances_[Index(i - side)];
      if (corner >= kFree || distances_[Index(i)] - corner <= diameter) continue;
      Region region{i, side, corner, 0};
      while (region.count < kSectors - 1 && distances_[Index(i + side * region.count)] > corner) {
        ++region.count;
      }
      // Passable: its mouth, at the corner's distance, is wide enough.
      const double opening = region.count * kSector;
      if (opening < kPi && 2.0 * corner * SinCos(opening / 2.0).sin < diameter) continue;
      // The corner nearest to the goal; of two that are about as near, the one it is going by
      // already: no to and fro before an obstacle in the middle.
      const double off = std::abs(NormalizeAngle(AngleOf(i) - target)) +
                         std::abs(NormalizeAngle(AngleOf(i) - last));
      if (best && off >= best_off) continue;
      best = region;
      best_off = off;
    }
  }
  return best;
}

bool Nd::IsStuck(const RobotState& state, const Drive& drive) {
  if (drive.speed != 0.0) {
    turning_since_.reset();
    const double distance = std::hypot(state.pose.x - moved_pose_.x, state.pose.y - moved_pose_.y);
    const double turn = std::abs(NormalizeAngle(state.pose.yaw - moved_pose_.yaw));
    if (!moved_time_ || distance > options_.translate_stuck_dist ||
        turn > options_.translate_stuck_angle) {
      moved_time_ = state.time;
      moved_pose_ = state.pose;
    }
    return state.time - *moved_time_ > options_.translate_stuck_time;
  }
  moved_time_.reset();
  if (drive.turn_rate == 0.0) {
    turning_since_.reset();
    return false;
  }
  // Turning on the spot gets on while what is left to turn shrinks.
  const double left = std::abs(direction_);
  if (!turning_since_ || left < turning_left_ - Radians(2.0)) {
    turning_since_ = state.time;
    turning_left_ = left;
  }
  return state.time - *turning_since_ > options_.rotate_stuck_time;
}

Drive Nd::Step(const RobotState& state, std::span<const Vec2> hits) {
  Drive drive;
  situation_ = NdSituation::kNone;
  direction_ = 0.0;
  if (!goal_) return drive;
  const auto turn_at = [&](double angle) {
    const double rate = std::clamp(options_.max_turn_rate * 2.0 * std::abs(angle) / kPi,
                                   options_.min_turn_rate, options_.max_turn_rate);
    return angle < 0.0 ? -rate : rate;
  };
  const Vec2 to_goal{goal_->x - state.pose.x, goal_->y - state.pose.y};
  const double goal_distance = std::sqrt(Dot(to_goal, to_goal));
  if (reached_ || goal_distance <= options_.goal_position_tol) {
    const double turn = NormalizeAngle(goal_->yaw - state.pose.yaw);
    reached_ = reached_ || std::abs(turn) <= options_.goal_angle_tol;
    drive.at_goal = reached_;
    direction_ = turn;
    if (!reached_) drive.turn_rate = turn_at(turn);
    if (stuck_ || (!reached_ && IsStuck(state, drive))) {
      stuck_ = true;
      drive.turn_rate = 0.0;
      drive.stalled = !reached_;
    }
    return drive;
  }
  if (stuck_ || (options_.wait_on_stall && state.stalled)) {
    drive.stalled = true;
    return drive;
  }

  std::fill(distances_.begin(), distances_.end(), kFree);
  std::vector<Vec2> placed(hits.size());
  Place(hits, state.pose, placed);
  seen_.push_back(std::move(placed));
  while (static_cast<int>(seen_.size()) > options_.laser_buffer) seen_.pop_front();
  for (const std::vector<Vec2>& step : seen_) {
    for (const Vec2& point : step) {
      const Vec2 hit = InverseTransform(state.pose, point);
      const double distance = std::sqrt(Dot(hit, hit));
      const std::size_t sector = Index(SectorOf(Atan2(hit.y, hit.x)));
      if (distance >= distances_[sector]) continue;
      distances_[sector] = distance;
      points_[sector] = hit;
    }
  }

  const double target = NormalizeAngle(Atan2(to_goal.y, to_goal.x) - state.pose.yaw);
  // Where it was going, as the robot has turned since.
  const double going = going_ ? NormalizeAngle(*going_ - state.pose.yaw) : target;
  const bool goal_free = IsWayClear(target, goal_distance);
  std::optional<Region> region;
  if (!goal_free) {
    region = ChooseRegion(target, going);
    if (!region) {
      drive.stalled = true;
      return drive;
    }
  }

  // The direction with nothing in the security zone.
  const double radius = options_.robot_radius + options_.safety_dist;
  const double zone = radius + options_.avoid_dist;
  double angle = target;
  NdSituation high = NdSituation::kHighSafetyGoal;
  if (region) {
    double offset = region->count * kSector / 2.0;
    high = NdSituation::kHighSafetyNarrow;
    if (region->count >= kWideRegion) {
      // Past the corner, at the zone's distance from it.
      high = NdSituation::kHighSafetyWide;
      const double clear = region->corner > zone ? ArcSine(zone / region->corner) : kPi / 2.0;
      offset = std::min(offset, clear);
    }
    angle = NormalizeAngle(AngleOf(region->edge) + region->side * offset);
  }
  going_ = NormalizeAngle(angle + state.pose.yaw);

  // What is in the zone, and on which side of that direction.
  double left_share = 0.0;  // of the zone, 1: touching
  double right_share = 0.0;
  double left_angle = 0.0;  // of the nearest there, relative to the direction
  double right_angle = 0.0;
  for (int i = 0; i < kSectors; ++i) {
    const double distance = distances_[Index(i)];
    if (distance >= zone) continue;
    const double relative = NormalizeAngle(AngleOf(i) - angle);
    // What lies behind is left behind.
    if (std::abs(relative) > Radians(120.0)) continue;
    const double share = std::clamp((zone - distance) / options_.avoid_dist, 0.0, 1.0);
    if (relative >= 0.0 && share > left_share) {
      left_share = share;
      left_angle = relative;
    }
    if (relative < 0.0 && share > right_share) {
      right_share = share;
      right_angle = relative;
    }
  }
  situation_ = high;
  if (left_share > 0.0 && right_share > 0.0) {
    // LS2: towards the middle between the two, the more the nearer one of them is.
    situation_ = NdSituation::kLowSafety2;
    const double push = (left_share - right_share) / std::max(left_share, right_share);
    const double room = push > 0.0 ? kPi - left_angle : kPi + right_angle;
    angle -= push * std::max(left_share, right_share) * room / 2.0;
  } else if (left_share > 0.0) {
    // LS1: away from it, at most to the direction opposite to it.
    situation_ = NdSituation::kLowSafety1;
    angle -= left_share * (kPi - left_angle) / 2.0;
  } else if (right_share > 0.0) {
    situation_ = NdSituation::kLowSafety1;
    angle += right_share * (kPi + right_angle) / 2.0;
  }
  direction_ = std::clamp(NormalizeAngle(angle), -kPi, kPi);

  // Full speed straight ahead with a free zone; on the spot from a quarter turn on.
  const double turn = std::clamp(direction_, -kPi / 2.0, kPi / 2.0);
  drive.turn_rate = options_.max_turn_rate * 2.0 * turn / kPi;
  double front = kFree;  // the nearest that is before the robot as it moves now
  for (int i = 0; i < kSectors; ++i) {
    if (std::abs(AngleOf(i)) < kPi / 2.0) front = std::min(front, distances_[Index(i)]);
  }
  const double room = std::clamp((front - radius) / options_.avoid_dist, 0.0, 1.0);
  drive.speed = options_.max_speed * std::min(1.0, 2.0 * goal_distance) * room *
                std::max(0.0, 1.0 - std::abs(turn) / Radians(45.0));
  if (drive.speed < options_.min_speed) {
    // Too slow to move: on the spot, fast enough to turn.
    drive.speed = room > 0.0 && std::abs(turn) < Radians(10.0) ? options_.min_speed : 0.0;
    if (drive.speed == 0.0 && std::abs(drive.turn_rate) < options_.min_turn_rate) {
      drive.turn_rate = drive.turn_rate < 0.0 ? -options_.min_turn_rate : options_.min_turn_rate;
    }
  }
  if (IsStuck(state, drive)) {
    stuck_ = true;
    situation_ = NdSituation::kNone;
    drive = {};
    drive.stalled = true;
  }
  return drive;
}

}  // namespace ccmorse::navigation
