#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/image.h"
#include "base/pose.h"
#include "sim/rays/embree_scene.h"

namespace ccmorse::render {

/// What a surface does with light: a coloured, matt base under a clear coat, or bare metal.
struct Material {
  Vec3 color{0.5, 0.5, 0.5};  ///< share of light that the base gives back, linear r, g, b, 0..1
  double coat = 0.04;         ///< share that the coat reflects of light from straight above, 0..1
  double roughness = 0.6;     ///< of the coat or metal, 0.02 (a mirror) .. 1
  bool metal = false;         ///< no base: all is reflected, in `color`
};

/// A lamp that is far away, such as the sun.
struct SunLight {
  Vec3 direction{0, 0, 1};  ///< unit vector to it
  double irradiance = 0.0;  ///< on a surface that faces it; 1 makes a white one as bright as white
  double radius = 0.02;     ///< rad: half of the angle under which it is seen; makes shadows soft
};

/// A lamp near by that shines down in a cone.
struct SpotLight {
  Vec3 position;           ///< m
  double intensity = 0.0;  ///< irradiance straight below at 1 m
  double radius = 0.08;    ///< m: its size; makes shadows soft
};

/// A translucent fan in the air, as the live view shows what a laser sees. Casts no shadow.
struct Fan {
  Vec3 origin;                 ///< m
  double yaw = 0.0;            ///< rad, of the scanner in the world
  double first = 0.0;          ///< rad, of the first beam, from yaw
  double step = 0.0;           ///< rad, from beam to beam, > 0
  std::vector<double> ranges;  ///< m
  Vec3 color;                  ///< linear
  double opacity = 0.15;       ///< 0..1
};

/// Linear r, g, b of an sRGB colour.
Vec3 Linear(const Color& color);

/// What a picture shows: triangles with materials, and lamps. Filled first, then asked by any
/// number of threads.
class PictureScene {
 public:
  int AddMaterial(const Material& material);

  /// A triangle, seen from both sides. Corners in m; normals, one a corner, unit vectors, so that
  /// what is round looks round.
  void AddTriangle(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
                   int material);
  /// The same with the triangle's own normal.
  void AddTriangle(const std::array<Vec3, 3>& corners, int material);
  /// An upright prism over a convex outline (m, counter-clockwise, in the frame `pose`) from
  /// `bottom` to `top` (m above the floor); its upper edges are bevelled by `bevel` (m).
  void AddPrism(const Pose2& pose, std::span<const Vec2> outline, double bottom, double top,
                double bevel, int material);
  /// A cylinder with flat ends between the middles of both, m.
  void AddCylinder(const Vec3& from, const Vec3& to, double radius, int material);

  std::vector<SunLight> suns;
  std::vector<SpotLight> spots;
  std::vector<Fan> fans;
  /// Colour (linear) of what has the floor's material, by place; the material's own where not set.
  std::function<Vec3(double x, double y)> floor_color;
  int floor_material = -1;
  int ground_material = -1;           ///< of the surroundings, which fade into the background
  Vec2 middle;                        ///< m: of the floor; from there distances for fading count
  double fade_from = 10.0;            ///< m
  Vec3 background{0.72, 0.76, 0.80};  ///< linear, behind everything
  double sky = 0.5;                   ///< radiance of the sky above

  /// To be called when all is there; `farthest`: m from the origin, of any camera.
  void Build(double farthest);

  /// What rays meet within `range` (m).
  void Trace(std::span<const sim::Ray> rays, double range, std::span<sim::RayHit> hits) const {
    triangles_.Trace(rays, range, -1, hits);
  }
  /// The normal of a hit's triangle at `point`, a unit vector.
  Vec3 Normal(const sim::RayHit& hit, const Vec3& point) const;
  /// Its triangle's own normal, a unit vector.
  Vec3 FlatNormal(const sim::RayHit& hit) const;
  int MaterialOf(const sim::RayHit& hit) const;
  const Material& material(int index) const { return materials_[static_cast<std::size_t>(index)]; }
  std::size_t size() const { return set_.size(); }  ///< triangles

 private:
  sim::TriangleSet set_;
  std::vector<std::array<Vec3, 3>> normals_;  // by triangle
  std::vector<int> material_of_;              // by triangle
  std::vector<Material> materials_;
  sim::EmbreeScene triangles_;
};

}  // namespace ccmorse::render
