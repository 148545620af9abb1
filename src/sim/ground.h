#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/pose.h"
#include "scene/scenario.h"
#include "sim/physics/kinematics.h"

namespace ccmorse::sim {

/// How a robot stands: the plane that its wheels are on.
struct Stand {
  double z = 0.0;      ///< m, of the ground beneath its origin
  double roll = 0.0;   ///< rad
  double pitch = 0.0;  ///< rad, positive looks down
};

/// The solid meshes of a world as ground to stand on and as what is in the way there
/// (scene::World::terrain; docs/assets.md). A surface up to 50 degrees steep is ground, whichever
/// way its triangles turn; robots climb steps of 6 cm and drop down any. What of a mesh is higher
/// above a robot's plane is in its way, unless it is ground that goes up to there evenly. Reading
/// is thread safe. The same bits on every machine.
class Ground {
 public:
  /// Takes what it needs of the world; nothing where that has no terrain.
  explicit Ground(const scene::World& world);

  bool empty() const { return triangles_.empty(); }

  /// The highest ground at `at` that is not above `from` (m); nothing where there is none.
  std::optional<double> Below(Vec2 at, double from) const;

  /// Where a robot comes down that is let go with its ground at `from` (m): the ground below or,
  /// where there is none, the lowest above; 0 where there is none at all.
  double Land(Vec2 at, double from) const;

  /// How the robot stands at `pose` that stood at `z` (m) just before: on four points, where its
  /// wheels would be. Where one of them hangs beyond an edge it is as high as the middle.
  Stand StandAt(const Footprint& footprint, const Pose2& pose, double z) const;

  /// Appends what is in the way of a robot within `reach` (m) of its origin, seen from above: it
  /// stands on the plane `stand` at `pose` and has its body from `bottom` to `top` (m above that
  /// plane). `level`: it flies: the plane is z = 0, and nothing is ground.
  void Obstacles(const Pose2& pose, const Stand& stand, double reach, double bottom, double top,
                 bool level, std::vector<Obstacle>& found) const;

  static constexpr double kStep = 0.06;  ///< m that robots climb

 private:
  struct Triangle {
    std::array<Vec3, 3> corners;  // m
    int mesh = 0;                 // id
    bool walkable = false;
    Vec2 low, high;  // bounds, m
  };

  template <typename Visit>
  void ForNear(Vec2 low, Vec2 high, const Visit& visit) const;
  // Height of the ground at `to` for who goes there straight from `from`, whose ground is at z.
  double March(Vec2 from, double z, Vec2 to) const;
  std::size_t Column(double x) const;
  std::size_t Row(double y) const;

  std::vector<Triangle> triangles_;
  Vec2 corner_;  // m, of the grid
  double cell_ = 1.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::uint32_t> starts_;  // (cells + 1), first of each one's items
  std::vector<std::uint32_t> items_;   // triangles, by cell, ascending
};

}  // namespace ccmorse::sim
