#include "sim/physics/fleet_motion.h"

#include <algorithm>
#include <cmath>

#include "base/polygon.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

constexpr double kListed = 0.25;   // m that a robot may move before its lists are made anew
constexpr double kCleared = 0.01;  // m that it moves before its room is measured anew
constexpr double kRoom = 1e-9;     // m, so that rounding is no matter

// m/s, of its origin in any direction: no less than it can be.
double Fastest(const Robot& robot) {
  return robot.model().max_speed + robot.model().max_side_speed;
}

double Distance(Vec2 a, Vec2 b) { return std::sqrt(Dot(b - a, b - a)); }

}  // namespace

FleetMotion::FleetMotion(const World& world, const std::vector<std::unique_ptr<Robot>>& robots,
                         std::size_t shared_from)
    : world_(world), robots_(robots), shared_from_(shared_from), around_(robots.size()) {
  for (const auto& robot : robots) fastest_ = std::max(fastest_, Fastest(*robot));
  // Room enough that ticks hardly ever allocate.
  for (Around& around : around_) around.boxes.reserve(16);
  alone_.reserve(robots.size());
  in_company_.reserve(robots.size());
  starts_.reserve(robots.size() + 1);
  neighbours_.reserve(8 * robots.size());
}

void FleetMotion::Step(const Instant& now, WorkerPool& pool) {
  bool stale = circles_.size() != robots_.size();
  for (std::size_t i = 0; !stale && i < robots_.size(); ++i) {
    const Pose2& pose = robots_[i]->pose();
    stale = Distance(circles_[i].centre, {pose.x, pose.y}) > kListed / 2.0;
  }
  if (stale) FindNeighbours(fastest_ * now.step);

  if (in_the_way_.empty()) {
    in_the_way_.resize(static_cast<std::size_t>(pool.threads()));
    for (auto& scratch : in_the_way_) scratch.reserve(64);
  }
  const auto move_alone = [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t i = begin; i < end; ++i) {
      in_the_way_[part].clear();
      Move(alone_[i], now, in_the_way_[part]);
    }
  };
  if (alone_.size() < shared_from_ || pool.threads() == 1) {
    move_alone(0, alone_.size(), 0);
  } else {
    const auto threads = static_cast<std::size_t>(pool.threads());
    pool.Run([&](int part_number) {
      const auto part = static_cast<std::size_t>(part_number);
      move_alone(alone_.size() * part / threads, alone_.size() * (part + 1) / threads, part);
    });
  }
  for (std::size_t i = 0; i < in_company_.size(); ++i) {
    in_the_way_[0].clear();
    for (std::uint32_t k = starts_[i]; k < starts_[i + 1]; ++k) {
      in_the_way_[0].push_back(&robots_[neighbours_[k]]->outline());
    }
    Move(in_company_[i], now, in_the_way_[0]);
  }
}

void FleetMotion::FindNeighbours(double step) {
  circles_.clear();
  for (const auto& robot : robots_) {
    circles_.push_back({{robot->pose().x, robot->pose().y}, robot->footprint().radius});
  }
  grid_.Build(circles_);
  alone_.clear();
  in_company_.clear();
  starts_.clear();
  neighbours_.clear();
  for (std::uint32_t i = 0; i < circles_.size(); ++i) {
    const std::size_t before = neighbours_.size();
    // Both may have come nearer by half of kListed, and both take a step.
    grid_.ForNear(circles_[i].centre, circles_[i].radius + kListed + 2.0 * step + kRoom,
                  [this, i](std::uint32_t other) {
                    if (other != i) neighbours_.push_back(other);
                  });
    if (neighbours_.size() == before) {
      alone_.push_back(i);
    } else {
      in_company_.push_back(i);
      starts_.push_back(static_cast<std::uint32_t>(before));
    }
  }
  starts_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
}

void FleetMotion::Move(std::size_t index, const Instant& now,
                       std::vector<const Obstacle*>& in_the_way) {
  Robot& robot = *robots_[index];
  if (robot.dynamic()) return;  // moved by forces (dynamics.h)
  if (!IsClear(index, Fastest(robot) * now.step)) {
    const Around& around = around_[index];
    in_the_way.insert(in_the_way.end(), around.boxes.begin(), around.boxes.end());
  }
  robot.Move(now, in_the_way);
}

bool FleetMotion::IsClear(std::size_t index, double step) {
  const Robot& robot = *robots_[index];
  const Vec2 at{robot.pose().x, robot.pose().y};
  Around& around = around_[index];
  const bool listed =
      around.revision == world_.revision() && Distance(around.listed_at, at) <= kListed;
  if (!listed) {
    around.revision = world_.revision();
    around.listed_at = at;
    around.boxes.clear();
    world_.NearObstacles(at, robot.footprint().radius + step + kListed, around.boxes);
  } else {
    const double since = Distance(around.cleared_at, at);
    if (since + step < around.clear) return true;
    if (since < kCleared) return false;
  }
  around.cleared_at = at;
  around.clear = kListed - Distance(around.listed_at, at) + step;  // what is not listed is farther
  for (const Obstacle* box : around.boxes) {
    const double gap = DistanceBeyondEdges(box->outline, at) - robot.footprint().radius;
    around.clear = std::min(around.clear, gap - kRoom);
  }
  return step < around.clear;
}

}  // namespace ccmorse::sim
