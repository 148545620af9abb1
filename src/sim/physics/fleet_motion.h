#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/component.h"
#include "sim/physics/kinematics.h"
#include "sim/spatial_grid.h"
#include "sim/worker_pool.h"

namespace ccmorse::sim {

class Robot;
class World;

/// Moves kinematic robots among the world's boxes and each other, one after the other in their
/// order. A robot that no other can reach moves at the same time as others like it: whoever is
/// alone meets the same, whenever it moves. Remembers what is near each robot until it has moved
/// away from there. One thread at a time.
class FleetMotion {
 public:
  /// World and robots outlive this. From `shared_from` robots on that are alone, threads share
  /// them.
  FleetMotion(const World& world, const std::vector<std::unique_ptr<Robot>>& robots,
              std::size_t shared_from);

  /// One physics step of every robot.
  void Step(const Instant& now, WorkerPool& pool);

 private:
  // What a robot may run into while it is not far from where this was looked up.
  struct Around {
    std::uint64_t revision = 0;  // of the world; 0: never looked up
    Vec2 listed_at;
    std::vector<const Obstacle*> boxes;
    Vec2 cleared_at;
    double clear = 0.0;  // m from cleared_at that the robot's origin can go without touching a box
  };

  void FindNeighbours(double step);
  void Move(std::size_t index, const Instant& now, std::vector<const Obstacle*>& in_the_way);
  bool IsClear(std::size_t index, double step);

  const World& world_;
  const std::vector<std::unique_ptr<Robot>>& robots_;
  std::size_t shared_from_;
  double fastest_ = 0.0;        // m/s, of all robots
  std::vector<Around> around_;  // (robots)

  SpatialGrid grid_;                       // where robots were when neighbours were found
  std::vector<Circle> circles_;            // of the robots then
  std::vector<std::uint32_t> alone_;       // robots without neighbours
  std::vector<std::uint32_t> in_company_;  // the others
  std::vector<std::uint32_t> starts_;      // (in_company_ + 1), first of each one's neighbours
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::vector<const Obstacle*>> in_the_way_;  // (threads), scratch
};

}  // namespace ccmorse::sim
