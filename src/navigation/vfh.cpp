#include "navigation/vfh.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace ccmorse::navigation {
namespace {

constexpr double kNoSpeed = kPi / 3.0;  // rad off its heading: it turns on the spot

// The magnitude of an occupied cell falls with its distance and is 0 from here on, m.
constexpr double kReach = 3.0;
// An opening as wide as this or wider is a wide one: its edges count, half of this from either
// side (Ulrich and Borenstein's s_max).
constexpr double kWideOpening = Radians(80.0);

double Between(double at_0, double at_1, double speed) {
  return at_0 + (at_1 - at_0) * std::clamp(speed, 0.0, 1.0);
}

}  // namespace

VfhOptions VfhOptionsForS1r() {
  VfhOptions options;
  options.robot_radius = 0.098;
  options.cell_size = 0.02;
  options.window_diameter = 81;
  options.safety_dist_0ms = 0.03;
  options.max_speed = 0.2;
  options.max_acceleration = 0.4;
  options.max_turnrate_0ms = Radians(80.0);
  // Two cells at any distance in the window.
  options.free_space_cutoff_0ms = 5e5;
  options.obs_cutoff_0ms = 6e5;
  options.distance_epsilon = 0.06;
  return options;
}

Vfh::Vfh(const VfhOptions& options) : options_(options) {
  VfhOptions& o = options_;
  if (!o.safety_dist_1ms) o.safety_dist_1ms = o.safety_dist_0ms;
  if (!o.max_speed_narrow_opening) o.max_speed_narrow_opening = o.max_speed;
  if (!o.max_speed_wide_opening) o.max_speed_wide_opening = o.max_speed;
  if (!o.max_turnrate_1ms) o.max_turnrate_1ms = o.max_turnrate_0ms;
  if (!o.free_space_cutoff_1ms) o.free_space_cutoff_1ms = o.free_space_cutoff_0ms;
  if (!o.obs_cutoff_0ms) o.obs_cutoff_0ms = o.free_space_cutoff_0ms;
  if (!o.obs_cutoff_1ms) o.obs_cutoff_1ms = o.obs_cutoff_0ms;
  const auto check = [](bool right, const char* what) {
    if (!right) throw Error(std::string("vfh: ") + what);
  };
  check(o.robot_radius > 0.0, "robot_radius must be positive");
  check(o.cell_size > 0.0, "cell_size must be positive");
  check(o.window_diameter >= 3 && o.window_diameter <= 1001 && o.window_diameter % 2 == 1,
        "window_diameter must be an odd number of 3..1001");
  check(o.sector_angle >= Radians(0.5) && o.sector_angle <= Radians(30.0),
        "sector_angle must be 0.5..30 degrees");
  check(o.safety_dist_0ms >= 0.0 && *o.safety_dist_1ms >= 0.0, "safety_dist must not be negative");
  check(o.max_speed > 0.0 && *o.max_speed_narrow_opening > 0.0 && *o.max_speed_wide_opening > 0.0,
        "max_speed must be positive");
  check(o.max_acceleration > 0.0, "max_acceleration must be positive");
  check(o.min_turnrate >= 0.0, "min_turnrate must not be negative");
  check(o.max_turnrate_0ms > 0.0 && *o.max_turnrate_1ms > 0.0, "max_turnrate must be positive");
  check(o.distance_epsilon > 0.0 && o.angle_epsilon > 0.0, "the epsilons must be positive");
  sectors_ = static_cast<int>(std::lround(2.0 * kPi / o.sector_angle));
  const auto count = static_cast<std::size_t>(sectors_);
  histogram_.assign(count, 0.0);
  blocked_.assign(count, false);
  masked_.assign(count, false);
  const auto side = static_cast<std::size_t>(o.window_diameter);
  grid_.assign(side * side, false);
}

void Vfh::SetGoal(const Pose2& goal) {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || !std::isfinite(goal.yaw)) {
    throw Error("vfh: a number of the goal is not finite");
  }
  goal_ = goal;
  reached_ = false;
}

std::size_t Vfh::SectorOf(double angle) const {
  const auto sector = std::lround(angle / (2.0 * kPi) * sectors_) % sectors_;
  return static_cast<std::size_t>(sector < 0 ? sector + sectors_ : sector);
}

double Vfh::MaxTurnRate(double speed) const {
  return Between(options_.max_turnrate_0ms, *options_.max_turnrate_1ms, speed);
}

void Vfh::BuildHistograms(double speed, double goal_distance, std::span<const Vec2> hits) {
  const int side = options_.window_diameter;
  const int half = side / 2;
  std::fill(grid_.begin(), grid_.end(), false);
  for (const Vec2& hit : hits) {
    const double column = hit.x / options_.cell_size;
    const double row = hit.y / options_.cell_size;
    if (!(std::abs(column) <= half && std::abs(row) <= half)) continue;
    const auto x = static_cast<std::size_t>(std::lround(column) + half);
    const auto y = static_cast<std::size_t>(std::lround(row) + half);
    grid_[y * static_cast<std::size_t>(side) + x] = true;
  }

  // Each occupied cell counts in the sectors that the robot, with the safety distance around it,
  // cannot enter without touching it.
  const double enlarged =
      options_.robot_radius + Between(options_.safety_dist_0ms, *options_.safety_dist_1ms, speed);
  const double turn_radius =
      options_.min_turn_radius_safety_factor * std::max(0.0, speed) / MaxTurnRate(speed);
  std::fill(histogram_.begin(), histogram_.end(), 0.0);
  // How far to either side the turning circles allow it to go, rad.
  double left_limit = kPi;
  double right_limit = -kPi;
  for (int y = -half; y <= half; ++y) {
    for (int x = -half; x <= half; ++x) {
      if (!grid_[static_cast<std::size_t>(y + half) * static_cast<std::size_t>(side) +
                 static_cast<std::size_t>(x + half)]) {
        continue;
      }
      const Vec2 cell{x * options_.cell_size, y * options_.cell_size};
      const double distance = std::sqrt(Dot(cell, cell));
      if (distance >= kReach || distance == 0.0) continue;
      // What is beyond the goal is not in the way to it, as a wall just behind it would be.
      if (distance > goal_distance + enlarged) continue;
      const double base = 1000.0 * (kReach - distance);  // mm
      const double magnitude = base * base * base * base / 1e8;
      const double angle = Atan2(cell.y, cell.x);
      const double spread = distance > enlarged ? ArcSine(enlarged / distance) : kPi / 2.0;
      const auto first = std::lround((angle - spread) / (2.0 * kPi) * sectors_);
      const auto last = std::lround((angle + spread) / (2.0 * kPi) * sectors_);
      for (auto sector = first; sector <= last; ++sector) {
        const auto wrapped = ((sector % sectors_) + sectors_) % sectors_;
        histogram_[static_cast<std::size_t>(wrapped)] += magnitude;
      }
      // Would turning to the cell's side with this speed run into it?
      if (turn_radius > 0.0) {
        const Vec2 from_left{cell.x, cell.y - turn_radius};
        const Vec2 from_right{cell.x, cell.y + turn_radius};
        const double reach = turn_radius + enlarged;
        if (angle > 0.0 && Dot(from_left, from_left) < reach * reach) {
          left_limit = std::min(left_limit, angle);
        }
        if (angle <= 0.0 && Dot(from_right, from_right) < reach * reach) {
          right_limit = std::max(right_limit, angle);
        }
      }
    }
  }
  const double low =
      Between(options_.free_space_cutoff_0ms, *options_.free_space_cutoff_1ms, speed);
  const double high = Between(*options_.obs_cutoff_0ms, *options_.obs_cutoff_1ms, speed);
  for (std::size_t i = 0; i < histogram_.size(); ++i) {
    if (histogram_[i] > high) blocked_[i] = true;
    if (histogram_[i] < low) blocked_[i] = false;
    const double angle = NormalizeAngle(static_cast<double>(i) * 2.0 * kPi / sectors_);
    masked_[i] = blocked_[i] || angle > left_limit || angle < right_limit;
  }
}

void Vfh::FindCandidates(double target) {
  candidates_.clear();
  const auto start = std::find(masked_.begin(), masked_.end(), true);
  if (start == masked_.end()) {
    candidates_.push_back({target, false});
    return;
  }
  const double width = 2.0 * kPi / sectors_;  // rad, of a sector
  const auto first = static_cast<int>(start - masked_.begin());
  const auto is_open = [&](int sector) {
    return !masked_[static_cast<std::size_t>(sector % sectors_)];
  };
  for (int i = first; i < first + sectors_;) {
    if (!is_open(i)) {
      ++i;
      continue;
    }
    int end = i;  // beyond the opening
    while (end < first + sectors_ && is_open(end)) ++end;
    const double right = i * width;
    const double left = (end - 1) * width;
    // As wide as its sectors are; a lone one has a width, too.
    const double open = left - right + width;
    if (open < kWideOpening) {
      candidates_.push_back({NormalizeAngle((right + left) / 2.0), true});
    } else {
      candidates_.push_back({NormalizeAngle(right + kWideOpening / 2.0), false});
      candidates_.push_back({NormalizeAngle(left - kWideOpening / 2.0), false});
      double inside = std::fmod(target - right, 2.0 * kPi);
      if (inside < 0.0) inside += 2.0 * kPi;
      if (inside <= left - right) candidates_.push_back({target, false});
    }
    i = end;
  }
}

Drive Vfh::Step(const RobotState& state, std::span<const Vec2> hits) {
  const double elapsed = time_ ? std::max(0.0, state.time - *time_) : 0.0;
  time_ = state.time;
  Drive drive;
  const auto stop = [&] {
    speed_ = 0.0;
    picked_ = 0.0;
  };
  if (!goal_) {
    stop();
    spot_side_ = 0.0;
    return drive;
  }
  const Vec2 to_goal{goal_->x - state.pose.x, goal_->y - state.pose.y};
  const double distance = std::sqrt(Dot(to_goal, to_goal));
  const auto turn_by = [&](double angle) {
    // Proportional, all of it from 75 degrees on, and never slower than the robot can.
    const double most = MaxTurnRate(speed_);
    const double rate = std::clamp(std::abs(angle) / Radians(75.0) * most,
                                   std::min(options_.min_turnrate, most), most);
    return angle < 0.0 ? -rate : rate;
  };
  // On the spot it goes on turning to the side to which it has begun: with the goal behind it, what
  // is best from one heading may lie to the left and from the next to the right, for ever.
  const auto turn_on_the_spot = [&](double angle) {
    if (spot_side_ == 0.0) spot_side_ = angle < 0.0 ? -1.0 : 1.0;
    return spot_side_ * std::abs(turn_by(angle));
  };
  if (reached_ || distance <= options_.distance_epsilon) {
    stop();
    spot_side_ = 0.0;
    const double turn = NormalizeAngle(goal_->yaw - state.pose.yaw);
    reached_ = reached_ || std::abs(turn) <= options_.angle_epsilon;
    drive.at_goal = reached_;
    if (!reached_) drive.turn_rate = turn_by(turn);
    return drive;
  }

  const bool can_escape = options_.escape_speed != 0.0 && options_.escape_time > 0.0;
  if (can_escape && state.stalled && !escape_until_) {
    escape_until_ = state.time + options_.escape_time;
    escape_side_ = -escape_side_;
  }
  if (escape_until_) {
    if (state.time < *escape_until_) {
      stop();
      drive.speed = options_.escape_speed;
      drive.turn_rate = escape_side_ * options_.escape_max_turnrate;
      drive.stalled = true;
      return drive;
    }
    escape_until_.reset();
  }

  const double target = NormalizeAngle(Atan2(to_goal.y, to_goal.x) - state.pose.yaw);
  BuildHistograms(std::max(0.0, state.speed), distance, hits);
  FindCandidates(target);
  const Candidate* best = nullptr;
  double best_cost = 0.0;
  for (const Candidate& candidate : candidates_) {
    const double cost =
        options_.weight_desired_dir * std::abs(NormalizeAngle(candidate.angle - target)) +
        options_.weight_current_dir * std::abs(NormalizeAngle(candidate.angle - picked_));
    if (best && cost >= best_cost) continue;
    best = &candidate;
    best_cost = cost;
  }
  if (!best) {
    // Nowhere to go at this speed: stand, and look for a way on the spot.
    stop();
    drive.stalled = true;
    drive.turn_rate = turn_on_the_spot(target);
    return drive;
  }
  // The direction is kept in the robot's frame, which turns beneath it.
  const double angle = best->angle;
  if (std::abs(angle) >= kNoSpeed) {
    drive.turn_rate = turn_on_the_spot(angle);
  } else {
    spot_side_ = 0.0;
    drive.turn_rate = std::abs(angle) < options_.sector_angle / 4.0 ? 0.0 : turn_by(angle);
  }
  double wanted =
      best->narrow ? *options_.max_speed_narrow_opening : *options_.max_speed_wide_opening;
  wanted = std::min(wanted, options_.max_speed);
  // All the speed straight ahead, none from kNoSpeed on; and less near the goal, which it could
  // not turn to any more.
  wanted *= std::clamp(1.0 - std::abs(angle) / kNoSpeed, 0.0, 1.0);
  wanted = std::min(wanted, std::max(0.02, distance));
  const double gain = options_.max_acceleration * elapsed;
  // It brakes at once.
  speed_ = std::min(wanted, std::max(0.0, speed_) + gain);
  drive.speed = speed_;
  picked_ = NormalizeAngle(angle - drive.turn_rate * elapsed);
  return drive;
}

}  // namespace ccmorse::navigation
