#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/pose.h"
#include "sim/rays/beam_fan.h"
#include "sim/rays/embree_scene.h"

namespace ccmorse::sim {

class World;

/// How a scan is computed. Both ways give the same distances (to 1e-6 m, and far closer).
enum class RayPath {
  kAuto,    ///< the planar one where it can, else the general one
  kPlanar,  ///< no rays: the world cut at the scanner's height (planar_scan.h)
  kEmbree   ///< rays against triangles (embree_scene.h)
};

/// Answers every question about distances in a world: scans, cones, lines of sight (design: Rays).
/// Sees the boxes that stand, the meshes, the robots, and where beams point down, the floor. Any
/// number of threads may ask at the same time while the world does not change.
class RangeEngine {
 public:
  /// The world outlives it.
  explicit RangeEngine(const World& world);
  ~RangeEngine();
  RangeEngine(const RangeEngine&) = delete;
  RangeEngine& operator=(const RangeEngine&) = delete;

  /// Takes one way for all scans from now on, for tests. A scan that the planar way cannot do
  /// then throws Error.
  void Force(RayPath path) { forced_ = path; }

  /// The way that is taken for a fan whose scanner is at `height` (m above the floor) on robot
  /// `self` (-1: on none): planar for an upright one that no mesh reaches, else Embree.
  RayPath Choose(const BeamFan& fan, double height, int self = -1) const;

  /// Distances along all beams, m, (fan.count()), of a scanner on a robot at `robot` whose origin
  /// is `origin_height` (m) above the floor; the fan's range where there is nothing. Robot `self`
  /// is not seen (-1: all are); where it leans, the scanner does.
  void Scan(BeamFan& fan, const Pose2& robot, double origin_height, int self,
            std::span<double> ranges) const;

  /// The first, and what is hit. Slower on the planar way, which has to look for it afterwards.
  void ScanHits(BeamFan& fan, const Pose2& robot, double origin_height, int self,
                std::span<RayHit> hits) const;

  /// The nearest point of anything but the floor and robot `self` in the cone, within `range` (m).
  RayHit Nearest(const Cone& cone, double range, int self) const;

  /// Distance along one ray to anything but robot `self`, m; `range` (m) where there is nothing.
  double Cast(const Ray& ray, double range, int self) const;

  /// Is the straight way from one point to the other free of boxes, meshes, robots and floor?
  bool LineOfSight(const Vec3& from, const Vec3& to) const;

  /// Brings the triangles up to date with the world. Whoever asks first does so anyway while the
  /// others wait; before a parallel phase it costs no waiting.
  void Prepare() const { static_cast<void>(Triangles()); }

 private:
  const EmbreeScene& Triangles() const;
  void Build() const;
  bool PlaceRobots() const;
  bool Leans(int self) const;
  void Trace(BeamFan& fan, const Pose2& robot, double origin_height, int self,
             std::span<RayHit> hits) const;
  void Identify(BeamFan& fan, const Pose2& robot, double height, int self,
                std::span<RayHit> hits) const;
  void MeetFloor(const Ray& ray, RayHit& hit) const;

  const World& world_;
  RayPath forced_ = RayPath::kAuto;
  struct Heights {
    double bottom, top;
  };
  std::vector<Heights> mesh_heights_;  // m

  // Made when first needed.
  mutable std::mutex mutex_;                      // of all that follows
  mutable std::atomic<std::uint64_t> built_ = 0;  // version of the world that the triangles show
  mutable std::uint64_t built_revision_ = 0;      // of the world's boxes
  mutable double extent_ = 0.0;                   // m, asked of the scene
  mutable std::unique_ptr<EmbreeScene> triangles_;
};

}  // namespace ccmorse::sim
