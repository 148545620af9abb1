#include "navigation/wavefront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include "base/error.h"

namespace ccmorse::navigation {
namespace {

struct Neighbour {
  int x;
  int y;
  double length;  // cells
};

const std::array<Neighbour, 8> kNeighbours = {{{1, 0, 1.0},
                                               {0, 1, 1.0},
                                               {-1, 0, 1.0},
                                               {0, -1, 1.0},
                                               {1, 1, 1.4142135623730951},
                                               {-1, 1, 1.4142135623730951},
                                               {-1, -1, 1.4142135623730951},
                                               {1, -1, 1.4142135623730951}}};

}  // namespace

WavefrontOptions WavefrontOptionsForS1r() {
  WavefrontOptions options;
  options.safety_dist = 0.11;
  options.max_radius = 0.3;
  options.dist_penalty = 3.0;
  options.distance_epsilon = 0.1;
  options.angle_epsilon = Radians(30.0);
  options.replan_dist_thresh = 0.3;
  options.add_rotational_waypoints = false;
  return options;
}

Wavefront::Wavefront(OccupancyGrid map, const WavefrontOptions& options)
    : map_(std::move(map)), options_(options) {
  const auto check = [](bool right, const char* what) {
    if (!right) throw Error(std::string("wavefront: ") + what);
  };
  check(options.safety_dist >= 0.0 && std::isfinite(options.safety_dist),
        "safety_dist must not be negative");
  check(options.max_radius > 0.0 && std::isfinite(options.max_radius),
        "max_radius must be positive");
  check(options.dist_penalty >= 0.0 && std::isfinite(options.dist_penalty),
        "dist_penalty must not be negative");
  check(options.distance_epsilon > 0.0, "distance_epsilon must be positive");
  check(options.angle_epsilon > 0.0, "angle_epsilon must be positive");
  check(options.replan_dist_thresh >= 0.0, "replan_dist_thresh must not be negative");
  reach_ = std::max(options.max_radius, options.safety_dist + map_.scale());
  distances_ = map_.ObstacleDistances(reach_);
  costs_.assign(distances_.size(), kUnreachable);
}

bool Wavefront::IsOpen(CellIndex cell) const {
  return map_.Contains(cell) && distances_[map_.IndexOf(cell)] > options_.safety_dist;
}

bool Wavefront::CanStep(CellIndex from, CellIndex to) const {
  // A diagonal step does not cut the corner of a closed cell.
  return IsOpen(to) && IsOpen({from.x, to.y}) && IsOpen({to.x, from.y});
}

double Wavefront::StepCost(CellIndex cell, double length) const {
  const double room = options_.max_radius - options_.safety_dist;
  double closeness = 0.0;
  if (room > 0.0) {
    closeness = std::max(0.0, (options_.max_radius - distances_[map_.IndexOf(cell)]) / room);
  }
  return length * (1.0 + options_.dist_penalty * closeness);
}

bool Wavefront::IsLineOpen(Vec2 from, Vec2 to) const {
  // All cells that the line passes through, by where it crosses the lines of the grid; at a corner
  // of four cells both of its sides count.
  CellIndex cell = map_.CellOf(from);
  const CellIndex end = map_.CellOf(to);
  if (!IsOpen(cell) || !IsOpen(end)) return false;
  const Vec2 start{(from.x - map_.origin().x) / map_.scale(),
                   (from.y - map_.origin().y) / map_.scale()};
  const Vec2 way{(to.x - from.x) / map_.scale(), (to.y - from.y) / map_.scale()};
  const int step_x = way.x > 0.0 ? 1 : -1;
  const int step_y = way.y > 0.0 ? 1 : -1;
  int left_x = std::abs(end.x - cell.x);
  int left_y = std::abs(end.y - cell.y);
  while (left_x > 0 || left_y > 0) {
    // Which border comes first? Compared without division: where along the way the next lines lie.
    const double border_x = (cell.x + (step_x > 0 ? 1 : 0)) - start.x;
    const double border_y = (cell.y + (step_y > 0 ? 1 : 0)) - start.y;
    const double first = std::abs(border_x * way.y);
    const double second = std::abs(border_y * way.x);
    if (left_x > 0 && left_y > 0 && std::abs(first - second) < 1e-9) {
      if (!IsOpen({cell.x + step_x, cell.y}) || !IsOpen({cell.x, cell.y + step_y})) return false;
      cell.x += step_x;
      cell.y += step_y;
      --left_x;
      --left_y;
    } else if (left_y == 0 || (left_x > 0 && first < second)) {
      cell.x += step_x;
      --left_x;
    } else {
      cell.y += step_y;
      --left_y;
    }
    if (!IsOpen(cell)) return false;
  }
  return true;
}

void Wavefront::SetGoal(const Pose2& goal) {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || !std::isfinite(goal.yaw)) {
    throw Error("wavefront: a number of the goal is not finite");
  }
  ClearGoal();
  goal_ = goal;
}

void Wavefront::ClearGoal() {
  goal_.reset();
  planned_at_.reset();
  planned_from_.reset();
  path_.clear();
  waypoints_.clear();
  current_ = 0;
  turning_ = false;
  done_ = false;
}

void Wavefront::ComputeCosts(CellIndex goal) {
  if (costs_of_ == goal) return;
  costs_of_ = goal;
  std::fill(costs_.begin(), costs_.end(), kUnreachable);
  // Cells of equal cost leave in order of their place, so the plan is one and the same everywhere.
  using Entry = std::tuple<double, std::size_t, CellIndex>;
  const auto later = [](const Entry& a, const Entry& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) > std::tie(std::get<0>(b), std::get<1>(b));
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> open(later);
  costs_[map_.IndexOf(goal)] = 0.0;
  open.emplace(0.0, map_.IndexOf(goal), goal);
  while (!open.empty()) {
    const auto [cost, index, cell] = open.top();
    open.pop();
    if (cost > costs_[index]) continue;  // an older, dearer way here
    for (const Neighbour& step : kNeighbours) {
      const CellIndex next{cell.x + step.x, cell.y + step.y};
      if (!CanStep(cell, next)) continue;
      // The robot walks the other way, from `next` into `cell`.
      const double total = cost + StepCost(cell, step.length * map_.scale());
      double& known = costs_[map_.IndexOf(next)];
      if (total >= known) continue;
      known = total;
      open.emplace(total, map_.IndexOf(next), next);
    }
  }
}

std::optional<CellIndex> Wavefront::NearestOpen(CellIndex from) const {
  std::optional<CellIndex> best;
  int best_square = 0;
  // As far out as the robot can be pushed into what is closed, and a little more.
  const int reach = static_cast<int>(std::ceil(2.0 * options_.safety_dist / map_.scale())) + 1;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const int square = x * x + y * y;
      if (best && square >= best_square) continue;
      const CellIndex cell{from.x + x, from.y + y};
      if (!IsOpen(cell) || costs_[map_.IndexOf(cell)] >= kUnreachable) continue;
      best = cell;
      best_square = square;
    }
  }
  return best;
}

bool Wavefront::Plan(const Pose2& start) {
  path_.clear();
  waypoints_.clear();
  current_ = 0;
  turning_ = false;
  if (!goal_) return false;
  const CellIndex goal = map_.CellOf({goal_->x, goal_->y});
  if (!IsOpen(goal)) return false;
  ComputeCosts(goal);
  CellIndex cell = map_.CellOf({start.x, start.y});
  const bool inside = IsOpen(cell) && costs_[map_.IndexOf(cell)] < kUnreachable;
  if (IsOpen(cell) && !inside) return false;
  if (!inside) {
    const auto way_out = NearestOpen(cell);
    if (!way_out) return false;
    cell = *way_out;
  }
  path_.push_back(cell);
  while (!(cell == goal)) {
    // Downhill: the neighbour over which the way to the goal is cheapest.
    CellIndex best = cell;
    double best_cost = kUnreachable;
    for (const Neighbour& step : kNeighbours) {
      const CellIndex next{cell.x + step.x, cell.y + step.y};
      if (!CanStep(cell, next) || costs_[map_.IndexOf(next)] >= costs_[map_.IndexOf(cell)]) {
        continue;
      }
      const double cost = costs_[map_.IndexOf(next)] + StepCost(next, step.length * map_.scale());
      if (cost < best_cost) {
        best_cost = cost;
        best = next;
      }
    }
    cell = best;
    path_.push_back(cell);
  }

  // Straight lines instead of steps, where the line is not much dearer for running nearer to
  // obstacles: a line is taken as long as all of it is open and it keeps the room its steps have.
  const auto point_of = [&](std::size_t k) {
    return k + 1 == path_.size() ? Vec2{goal_->x, goal_->y} : map_.CentreOf(path_[k]);
  };
  std::vector<Vec2> corners;
  Vec2 from = inside ? Vec2{start.x, start.y} : map_.CentreOf(path_.front());
  if (!inside) corners.push_back(from);
  std::size_t at = 0;
  while (at + 1 < path_.size()) {
    if (!IsLineOpen(from, point_of(at + 1))) {
      // Only the start and the goal are off the middles of their cells, where all steps are open.
      const Vec2 middle = map_.CentreOf(path_[at]);
      const bool off = from.x != middle.x || from.y != middle.y;
      if (!off) ++at;
      from = map_.CentreOf(path_[at]);
      corners.push_back(from);
      continue;
    }
    std::size_t best = at + 1;
    double walked = 0.0;
    for (std::size_t k = at + 1; k < path_.size(); ++k) {
      const Vec2 to = point_of(k);
      const Vec2 before = k == at + 1 ? from : map_.CentreOf(path_[k - 1]);
      const Vec2 step = to - before;
      walked += StepCost(path_[k], std::sqrt(Dot(step, step)));
      if (!IsLineOpen(from, to)) break;
      const Vec2 line = to - from;
      const double length = std::sqrt(Dot(line, line));
      const int samples = std::max(1, static_cast<int>(std::ceil(length / map_.scale())));
      double straight = 0.0;
      for (int i = 1; i <= samples; ++i) {
        straight += StepCost(map_.CellOf(from + (1.0 * i / samples) * line), length / samples);
      }
      constexpr double kDearer = 1.02;
      if (straight <= walked * kDearer) best = k;
    }
    at = best;
    from = point_of(at);
    if (at + 1 < path_.size()) corners.push_back(from);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 next = i + 1 < corners.size() ? corners[i + 1] : Vec2{goal_->x, goal_->y};
    const Vec2 way = next - corners[i];
    waypoints_.push_back({corners[i].x, corners[i].y, Atan2(way.y, way.x)});
  }
  waypoints_.push_back(*goal_);
  planned_from_ = Vec2{start.x, start.y};
  return true;
}

double Wavefront::DistanceFromPath(Vec2 point) const {
  double nearest = kUnreachable;
  Vec2 from = planned_from_.value_or(point);
  for (const Pose2& waypoint : waypoints_) {
    const Vec2 to{waypoint.x, waypoint.y};
    const Vec2 line = to - from;
    const double square = Dot(line, line);
    const double share =
        square > 0.0 ? std::clamp(Dot(point - from, line) / square, 0.0, 1.0) : 0.0;
    const Vec2 apart = point - (from + share * line);
    nearest = std::min(nearest, std::sqrt(Dot(apart, apart)));
    from = to;
  }
  return nearest;
}

WavefrontStatus Wavefront::Step(const Pose2& pose, double time) {
  WavefrontStatus status;
  if (!goal_) return status;
  const Vec2 here{pose.x, pose.y};
  if (done_) {
    status.valid = true;
    status.done = true;
    return status;
  }
  const bool first = !planned_at_;
  const bool may_replan = planned_at_ && options_.replan_min_time >= 0.0 &&
                          time - *planned_at_ >= options_.replan_min_time;
  if (first || (may_replan &&
                (waypoints_.empty() || DistanceFromPath(here) > options_.replan_dist_thresh))) {
    Plan(pose);
    planned_at_ = time;
    status.planned = true;
  }
  while (current_ < waypoints_.size()) {
    const Pose2& target = waypoints_[current_];
    const Vec2 way{target.x - here.x, target.y - here.y};
    const bool last = current_ + 1 == waypoints_.size();
    const bool near = std::sqrt(Dot(way, way)) <= options_.distance_epsilon;
    const bool turned = std::abs(NormalizeAngle(target.yaw - pose.yaw)) <= options_.angle_epsilon;
    if (!near && !turning_) break;
    if ((last || options_.add_rotational_waypoints) && !turned) {
      // On the spot: there, the position is done with, and only the heading still counts.
      turning_ = !last;
      break;
    }
    turning_ = false;
    ++current_;
  }
  if (!waypoints_.empty() && current_ == waypoints_.size()) done_ = true;
  status.valid = !waypoints_.empty();
  status.done = done_;
  if (status.valid && !done_) {
    status.current = static_cast<int>(current_);
    status.waypoint = waypoints_[current_];
    if (turning_) {
      status.waypoint = Pose2{pose.x, pose.y, waypoints_[current_].yaw};
    } else if (current_ + 1 < waypoints_.size() && !options_.add_rotational_waypoints) {
      // Nothing turns at a waypoint on the way: any heading will do.
      const Vec2 way{status.waypoint->x - pose.x, status.waypoint->y - pose.y};
      status.waypoint->yaw = Atan2(way.y, way.x);
    }
  }
  return status;
}

}  // namespace ccmorse::navigation
