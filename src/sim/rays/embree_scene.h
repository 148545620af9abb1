#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/pose.h"
#include "base/rotation.h"
#include "sim/rays/solid.h"
#include "sim/rays/triangle.h"

namespace ccmorse::sim {

struct Ray {
  Vec3 origin;     ///< m
  Vec3 direction;  ///< unit vector
};

/// What the nearest thing on a ray is.
struct RayHit {
  double distance = 0.0;  ///< m from the ray's origin; the ray's range when there is nothing
  Surface surface;
};

/// Where a thing that moves is: its frame in the world.
struct Placement {
  Vec3 position;  ///< m
  Rotation rotation;
};

/// The general path of the range engine: rays against triangles, by Embree 3.13 (design: Rays).
///
/// Embree computes with floats; the results here are exact in double. Embree gets every triangle a
/// little larger than it is (by what its rounding can be, relative to the extent of the scene) and
/// is told to search a little beyond what it has found, so whatever the ray may meet is offered to
/// a filter; there the ray's distance to the triangle, and where it passes an edge closely whether
/// it meets it at all, are computed in double, and the nearest wins. The answer therefore does not
/// depend on the instruction set, on the order of the triangles, nor on what Embree rounds.
/// Rays within 1e-9 rad of an edge may pass it on either side; so may rays within 1e-5 rad of the
/// edge of a surface that they would graze at less than 5e-3 rad (0.3 degrees), where what floats
/// round outgrows what triangles are enlarged by.
///
/// Changing it is for one thread; after Commit() any number of threads may ask.
class EmbreeScene {
 public:
  /// `isa`: Embree's name of the instruction set to use ("sse2", "sse4.2", "avx", "avx2",
  /// "avx512"), for tests; empty takes the fastest of the first two and avx2. Throws Error when
  /// Embree cannot be had.
  explicit EmbreeScene(const std::string& isa = "");
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Forgets what was there. `fixed` stands in the world's frame. Mover i is `models[model_of[i]]`,
  /// in its own frame, moved by Place(). `extent`, m: how far from the origin anything and any
  /// ray's origin may be, except for what the sets themselves hold.
  void Build(const std::vector<TriangleSet>& fixed, const std::vector<TriangleSet>& models,
             std::span<const int> model_of, double extent);

  /// Farthest from the world's origin along any axis that things and rays may be, m; beyond it,
  /// Build() anew.
  double extent() const;

  void Place(int mover, const Placement& placement);

  /// To be called when all has been built and placed, before the next question.
  void Commit();

  /// What each ray meets within `range` (m, > 0) that is not mover `self` (-1: all count), into
  /// `hits`, which holds as many. Consecutive rays that run alike are fastest: a scan in its order.
  void Trace(std::span<const Ray> rays, double range, int self, std::span<RayHit> hits) const;

  /// Does anything lie on the way from one point to the other?
  bool IsBlocked(const Vec3& from, const Vec3& to) const;

  /// The nearest point in the cone, within `range` (m), of anything but `self`. Exact: nothing is
  /// small enough to be missed.
  RayHit Nearest(const Cone& cone, double range, int self) const;

 private:
  struct State;  // all that is Embree's
  std::unique_ptr<State> state_;
};

}  // namespace ccmorse::sim
