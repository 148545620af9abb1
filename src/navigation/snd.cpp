#include "navigation/snd.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace ccmorse::navigation {
namespace {

double Limit(double value, double low, double high) { return std::clamp(value, low, high); }

std::size_t AsIndex(int sector) { return static_cast<std::size_t>(sector); }

int Round(double value) { return static_cast<int>(std::lround(value)); }

// Sectors from the valley's right end to its left end.
int WidthOf(const NearnessDiagram& diagram, const SndValley& valley) {
  return diagram.Wrap(valley.left - valley.right);
}

bool ContainsBehind(const NearnessDiagram& diagram, const SndValley& valley) {
  return diagram.Wrap(-valley.right) <= WidthOf(diagram, valley);
}

// Sectors from the rising edge in which nothing is nearer than its corner.
int OpenWidth(const NearnessDiagram& diagram, const SndValley& valley) {
  const int all = WidthOf(diagram, valley);
  int width = 0;
  while (width < all) {
    const int sector = diagram.Wrap(valley.rising.sector + valley.direction * (width + 1));
    if (diagram.distance[AsIndex(sector)] < valley.rising.distance) break;
    ++width;
  }
  return width;
}

}  // namespace

SndOptions SndOptionsForS1r() {
  SndOptions options;
  options.robot_radius = 0.098;
  options.min_gap_width = 0.18;
  options.obstacle_avoid_dist = 0.06;
  options.max_speed = 0.3;
  options.max_turn_rate = Radians(60.0);
  options.goal_position_tol = 0.05;
  options.goal_angle_tol = Radians(30.0);
  return options;
}

int NearnessDiagram::Between(int from, int to) const {
  const int steps = Wrap(to - from);
  return steps > count / 2 ? steps - count : steps;
}

NearnessDiagram MakeNearnessDiagram(const ScanView& scan, const SndOptions& options) {
  NearnessDiagram diagram;
  diagram.resolution = scan.resolution;
  diagram.range_max = scan.range_max;
  diagram.count = Round(2.0 * kPi / scan.resolution + 0.5);
  const int beams = static_cast<int>(scan.ranges.size());
  diagram.beams = std::min(beams, diagram.count);
  diagram.first = std::max(0, diagram.count / 2 - beams / 2);
  diagram.distance.assign(AsIndex(diagram.count), scan.range_max);
  for (int i = 0; i < diagram.count; ++i) {
    const int beam = i - diagram.count / 2 + beams / 2;
    if (beam < 0 || beam >= beams) continue;
    const double range = CleanRange(scan.ranges[AsIndex(beam)], scan.range_max);
    if (range >= options.min_range) diagram.distance[AsIndex(i)] = range;
  }
  diagram.nearness.resize(AsIndex(diagram.count));
  diagram.points.resize(AsIndex(diagram.count));
  diagram.nearest = scan.range_max;
  for (int i = 0; i < diagram.count; ++i) {
    const double distance = diagram.distance[AsIndex(i)];
    diagram.nearness[AsIndex(i)] =
        distance >= scan.range_max ? 0.0 : scan.range_max + 2.0 * options.robot_radius - distance;
    const int from_ahead = i - diagram.ahead();
    const auto [sine, cosine] = SinCos(from_ahead * scan.resolution);
    diagram.points[AsIndex(i)] = {distance * cosine, distance * sine};
    diagram.nearest = std::min(diagram.nearest, distance);
  }
  diagram.safety = Limit(5.0 * (diagram.nearest - options.robot_radius), 0.0,
                         options.obstacle_avoid_dist.value());
  return diagram;
}

std::vector<SndGap> FindGaps(const NearnessDiagram& diagram, const SndOptions& options) {
  const double jump = options.min_gap_width.value();
  std::vector<SndGap> found;
  const auto compare = [&](int right, int left) {
    const double rise = diagram.nearness[AsIndex(left)] - diagram.nearness[AsIndex(right)];
    if (rise > jump) found.push_back({right, 1, diagram.distance[AsIndex(left)]});
    if (rise < -jump) found.push_back({left, -1, diagram.distance[AsIndex(right)]});
  };
  const int last = diagram.first + diagram.beams - 1;
  if (diagram.beams == 0) return found;
  // What lies beyond the ends of a narrow scan is taken for free.
  if (diagram.full_circle()) {
    compare(diagram.Wrap(diagram.first - 1), diagram.first);
  } else {
    found.push_back({diagram.first, 1, diagram.distance[AsIndex(diagram.first)]});
  }
  for (int i = diagram.first + 1; i <= last; ++i) compare(i - 1, i);
  if (!diagram.full_circle()) {
    found.push_back({last, -1, diagram.distance[AsIndex(last)]});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const SndGap& a, const SndGap& b) { return a.sector < b.sector; });
  // A corner that takes two sectors is one.
  std::vector<SndGap> gaps;
  int last_sector = 0;
  for (const SndGap& gap : found) {
    const bool same =
        !gaps.empty() && gaps.back().direction == gap.direction && gap.sector - last_sector <= 1;
    last_sector = gap.sector;
    if (!same) {
      gaps.push_back(gap);
    } else if (gap.direction < 0) {
      gaps.back() = gap;  // right gaps keep the left one, left gaps the right one
    }
  }
  return gaps;
}

bool IsSafeGap(const NearnessDiagram& diagram, const SndGap& gap, const SndOptions& options) {
  const auto [sine, cosine] = SinCos((gap.sector - diagram.ahead()) * diagram.resolution);
  const Vec2 corner{gap.distance * cosine, gap.distance * sine};
  const double room = 2.2 * options.robot_radius;
  for (int k = 1; k <= diagram.count / 4; ++k) {
    const int sector = diagram.Wrap(gap.sector - gap.direction * k);
    if (diagram.distance[AsIndex(sector)] >= diagram.range_max) continue;
    const Vec2 apart = diagram.points[AsIndex(sector)] - corner;
    if (Dot(apart, apart) < room * room) return false;
  }
  return true;
}

std::vector<SndValley> FindValleys(const NearnessDiagram& diagram, const std::vector<SndGap>& gaps,
                                   int goal_sector, const SndOptions& options) {
  std::vector<SndValley> valleys;
  const auto off = [&](const SndGap& gap) {
    return std::abs(diagram.Between(gap.sector, goal_sector));
  };
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const SndGap& right = gaps[i];
    const SndGap& left = gaps[(i + 1) % gaps.size()];
    // The free space is between a right edge on the right and a left edge on the left; where only
    // one of them rises, the other end is a corner of something farther away.
    std::vector<const SndGap*> edges;
    if (right.direction < 0) edges.push_back(&right);
    if (left.direction > 0) edges.push_back(&left);
    if (edges.size() == 2 && off(left) < off(right)) std::swap(edges[0], edges[1]);
    for (const SndGap* edge : edges) {
      if (!IsSafeGap(diagram, *edge, options)) continue;
      valleys.push_back({right.sector, left.sector, *edge, -edge->direction});
      break;
    }
  }
  return valleys;
}

std::optional<SndValley> ChooseValley(const NearnessDiagram& diagram,
                                      const std::vector<SndValley>& valleys, int goal_sector) {
  std::optional<SndValley> best;
  int best_off = 0;
  const auto look = [&](bool also_behind) {
    for (const SndValley& valley : valleys) {
      if (!also_behind && ContainsBehind(diagram, valley)) continue;
      const int off = std::abs(diagram.Between(valley.rising.sector, goal_sector));
      if (best && off >= best_off) continue;
      best = valley;
      best_off = off;
    }
  };
  look(false);
  if (!best || best_off > diagram.count / 4 + 1) look(true);
  return best;
}

bool IsCorridorClear(const NearnessDiagram& diagram, int sector, double goal_distance,
                     const SndOptions& options) {
  const double length = std::min(diagram.range_max, goal_distance) - options.robot_radius;
  const auto [sine, cosine] = SinCos((sector - diagram.ahead()) * diagram.resolution);
  const Vec2 way{cosine, sine};
  for (int i = 0; i < diagram.count; ++i) {
    if (diagram.distance[AsIndex(i)] >= diagram.range_max) continue;
    const double along = Dot(way, diagram.points[AsIndex(i)]);
    const double across = Cross(way, diagram.points[AsIndex(i)]);
    if (along > 0.0 && along < length && std::abs(across) < options.robot_radius) return false;
  }
  return true;
}

int TargetSector(const NearnessDiagram& diagram, const std::optional<SndValley>& valley,
                 int goal_sector, double goal_distance, const SndOptions& options) {
  if (diagram.nearest < options.robot_radius) return diagram.ahead();
  if (!valley) {
    return IsCorridorClear(diagram, goal_sector, goal_distance, options) ? goal_sector : 0;
  }
  if (std::abs(goal_sector - diagram.ahead()) < std::min(diagram.count / 4, diagram.beams / 2) &&
      IsCorridorClear(diagram, goal_sector, goal_distance, options)) {
    return goal_sector;
  }
  const double clearance = options.obstacle_avoid_dist.value() + options.robot_radius;
  const double corner = valley->rising.distance;
  int offset = diagram.count / 4;
  if (corner >= clearance) offset = Round(ArcSine(clearance / corner) / diagram.resolution);
  offset = std::min(offset, diagram.beams / 3);
  const int middle = std::max(0, OpenWidth(diagram, *valley) / 2 - 1);
  return diagram.Wrap(valley->rising.sector + valley->direction * std::min(offset, middle));
}

double Deflection(const NearnessDiagram& diagram, int target, double robot_radius) {
  if (diagram.safety <= 0.0) return 0.0;
  double sum = 0.0;
  double weights = 0.0;
  for (int i = 0; i < diagram.count; ++i) {
    const double weight = Limit(
        (diagram.safety + robot_radius - diagram.distance[AsIndex(i)]) / diagram.safety, 0.0, 1.0);
    if (weight <= 0.0) continue;
    const int away = diagram.Between(target, i + diagram.count / 2);
    sum += weight * weight * weight * away;
    weights += weight * weight;
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

Drive SndSpeeds(double angle, double goal_distance, double nearest, const SndOptions& options) {
  Drive drive;
  drive.turn_rate = options.max_turn_rate * 2.0 * Limit(angle, -kPi / 2.0, kPi / 2.0) / kPi;
  drive.speed =
      options.max_speed * Limit(2.0 * goal_distance, 0.0, 1.0) *
      Limit((nearest - options.robot_radius) / options.obstacle_avoid_dist.value(), 0.0, 1.0) *
      Limit((kPi / 6.0 - std::abs(angle)) / (kPi / 6.0), 0.0, 1.0);
  return drive;
}

SndOptions Snd::Resolved(SndOptions options) {
  const double radius = options.robot_radius;
  if (!options.min_gap_width) options.min_gap_width = 2.0 * radius;
  if (!options.obstacle_avoid_dist) options.obstacle_avoid_dist = 4.0 * radius;
  if (!options.goal_position_tol) options.goal_position_tol = radius / 2.0;
  const auto check = [](double value, const char* name) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw Error(std::string("snd: ") + name + " must be a positive number");
    }
  };
  check(radius, "robot_radius");
  check(*options.min_gap_width, "min_gap_width");
  check(*options.obstacle_avoid_dist, "obstacle_avoid_dist");
  check(options.max_speed, "max_speed");
  check(options.max_turn_rate, "max_turn_rate");
  check(*options.goal_position_tol, "goal_position_tol");
  check(options.goal_angle_tol, "goal_angle_tol");
  if (!(options.min_range >= 0.0)) throw Error("snd: min_range must not be negative");
  return options;
}

Snd::Snd(const SndOptions& options) : options_(Resolved(options)) {}

void Snd::SetGoal(const Pose2& goal) {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || !std::isfinite(goal.yaw)) {
    throw Error("snd: a number of the goal is not finite");
  }
  goal_ = goal;
  reached_ = false;
}

Drive Snd::Step(const Pose2& pose, const ScanView& scan) {
  if (!goal_ || !(scan.resolution > 0.0) || scan.ranges.empty()) return {};
  const Vec2 to_goal{goal_->x - pose.x, goal_->y - pose.y};
  const double distance = std::max(0.01, std::sqrt(Dot(to_goal, to_goal)));
  const double turn = NormalizeAngle(goal_->yaw - pose.yaw);
  if (reached_ || distance < *options_.goal_position_tol) {
    Drive drive;
    reached_ = reached_ || std::abs(turn) < options_.goal_angle_tol;
    drive.at_goal = reached_;
    if (!reached_) {
      drive.turn_rate = Limit(turn / 3.0, -options_.max_turn_rate, options_.max_turn_rate);
    }
    return drive;
  }
  constexpr double kDirectionOnly = 1000.0;  // m
  const double bearing =
      distance >= kDirectionOnly ? turn : NormalizeAngle(Atan2(to_goal.y, to_goal.x) - pose.yaw);

  Scan centred;
  ScanView view = scan;
  // The sectors take the middle beam for straight ahead.
  const double middle =
      scan.min_angle + 0.5 * static_cast<double>(scan.ranges.size() - 1) * scan.resolution;
  if (scan.mount.x != 0.0 || scan.mount.y != 0.0 || scan.mount.yaw != 0.0 ||
      std::abs(middle) > scan.resolution) {
    centred = CentreScan(scan);
    view = centred.View();
  }
  const NearnessDiagram diagram = MakeNearnessDiagram(view, options_);
  const int goal_sector = diagram.Wrap(Round(diagram.ahead() + bearing / diagram.resolution));
  const auto valley = ChooseValley(
      diagram, FindValleys(diagram, FindGaps(diagram, options_), goal_sector, options_),
      goal_sector);
  const int target = TargetSector(diagram, valley, goal_sector, distance, options_);
  const int heading = std::clamp(Round(target + Deflection(diagram, target, options_.robot_radius)),
                                 0, diagram.count - 1);
  Drive drive = SndSpeeds(diagram.resolution * (heading - diagram.ahead()), distance,
                          diagram.nearest, options_);
  drive.stalled = diagram.nearest <= options_.robot_radius;
  return drive;
}

}  // namespace ccmorse::navigation
