#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/pose.h"
#include "scene/scenario.h"
#include "sim/ground.h"
#include "sim/physics/kinematics.h"
#include "sim/rays/planar_scan.h"
#include "sim/scene_objects.h"
#include "sim/spatial_grid.h"

namespace ccmorse::sim {

class RangeEngine;
class Robot;

/// What robots see and run into: the scene's boxes that stand, its meshes, and the robots. Several
/// threads may look at it while none changes it.
class World {
 public:
  explicit World(scene::World scene);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const scene::World& scene() const { return scene_; }

  /// Raises or lowers a dynamic box, by id, whoever may stand there: that is for the caller to see
  /// to. Throws Error on an unknown id or one that cannot move.
  void SetRaised(int box_id, bool raised);

  /// Puts a dynamic box somewhere else, likewise.
  void SetBoxPose(int box_id, const Pose2& pose);
  /// A box by id; nullptr when there is none.
  const scene::Box* FindBox(int box_id) const;

  /// The boxes that stand, and what of meshes is in the way, as obstacles to motion.
  std::span<const Obstacle> obstacles() const { return obstacles_; }

  /// Appends those that come within `reach` (m) of `point`. They are valid for one revision().
  void NearObstacles(Vec2 point, double reach, std::vector<const Obstacle*>& found) const {
    obstacle_grid_.ForNear(point, reach,
                           [&](std::uint32_t index) { found.push_back(&obstacles_[index]); });
  }

  /// The meshes to stand on and to run into, where the world has terrain; else empty, and meshes
  /// are among the obstacles().
  const Ground& ground() const { return ground_; }

  /// Changes whenever a box rises or goes down, or other robots are set.
  std::uint64_t revision() const { return revision_; }

  /// Changes whenever anything does that can be seen.
  std::uint64_t version() const { return revision_ + moves_; }

  /// Answers every question about distances.
  const RangeEngine& rays() const { return *rays_; }
  RangeEngine& rays() { return *rays_; }

  /// Is the straight way from one point to the other (m) free of boxes, meshes, robots and floor?
  bool LineOfSight(const Vec3& from, const Vec3& to) const;

  /// To be called before BoxesAt() and RobotsAt() at a height (m above the floor) by several
  /// threads.
  void PrepareCut(double height) const { CutAt(height); }

  /// The standing boxes cut at `height`. The reference stays valid; its content follows
  /// SetRaised().
  const PlanarWorld& BoxesAt(double height) const;

  /// The robots' hulls cut at `height`, at their current poses; made anew at each sensing phase in
  /// which somebody asks, once for all threads.
  const PlanarWorld& RobotsAt(double height) const;

  /// Sets whose hulls RobotsAt() shows. The robots outlive the world's use of them.
  void SetRobots(std::vector<const Robot*> robots);
  std::span<const Robot* const> robots() const { return robots_; }

  /// Robots and passive objects by name and property.
  const SceneObjects& objects() const { return objects_; }
  SceneObjects& objects() { return objects_; }

  /// Robots have moved: cuts made before are stale.
  void RobotsMoved() {
    robots_moved_ = true;
    ++moves_;
  }

  /// Distance in the plane along a ray from `from` in the unit direction `direction` at `height` to
  /// the first box or robot but `self`, and which robot (-1: a box); range if there is none. m.
  double CastRay(Vec2 from, Vec2 direction, double height, double range, int self,
                 int* hit_robot) const;

 private:
  struct Cut {
    double height;
    PlanarWorld boxes;
    PlanarWorld robots;
  };

  Cut& CutAt(double height) const;
  void FillBoxes(Cut& cut) const;
  void CutRobots() const;
  void CollectObstacles();
  scene::Box& DynamicBox(int box_id);
  void BoxesChanged();

  scene::World scene_;
  Ground ground_;
  std::vector<Obstacle> obstacles_;
  SpatialGrid obstacle_grid_;  // of obstacles_
  std::vector<Obstacle> mesh_obstacles_;
  std::uint64_t revision_ = 0;
  std::uint64_t moves_ = 0;  // of robots, so far
  std::vector<const Robot*> robots_;
  SceneObjects objects_;
  mutable std::vector<std::unique_ptr<Cut>> cuts_;  // a handful: one a height that scanners have
  mutable std::atomic<bool> robots_moved_ = true;
  mutable std::mutex cutting_;      // whoever makes the cuts of the robots anew
  mutable std::vector<Vec2> hull_;  // scratch of it
  std::unique_ptr<RangeEngine> rays_;
};

}  // namespace ccmorse::sim
