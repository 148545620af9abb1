#pragma once

#include <string>
#include <vector>

#include "assets/asset_scene.h"
#include "scene/scenario.h"

namespace ccmorse::scene {

/// How a file's objects become a thing: MORSE's PassiveObject (specs: morse.md B.6), whose first
/// object is the root that all others go with.
struct PropPlace {
  bool keep_pose = false;     ///< position and rotation are added to the root's own
  Vec3 scale{1.0, 1.0, 1.0};  ///< along the root's axes
  std::string physics;        ///< in place of the file's: MORSE's name of a type; "": the file's
};

/// The meshes of those of the file's objects whose names start with `prop.object` (all that the
/// file shows where it is empty), numbered from `first_id`: each in the root's frame, placed as
/// `prop` says. Collects what MORSE knows of the root into `prop.properties` where it has not been
/// given, and the ids into `prop.meshes`. With keep_pose `prop` afterwards says where it is. Throws
/// Error when there is no such object, or nothing with a surface.
std::vector<Mesh> MeshesOfProp(const assets::AssetScene& asset, const PropPlace& place,
                               int first_id, PropDef& prop);

/// Meshes in a prop's frame, placed as `place` and `prop` say; nothing touches or sees them unless
/// `place.physics` says otherwise.
std::vector<Mesh> PlacedShape(std::vector<Mesh> shape, const PropPlace& place, const PropDef& prop);

/// What a file of shapes makes of a robot.
struct RobotShape {
  std::vector<Mesh> shape;      ///< what viewers show, in the robot's frame, m
  std::vector<HullPart> hull;   ///< what sensors see, from the lowest point of it upwards
  std::vector<Vec2> footprint;  ///< what touches; 16 corners at most
  double lowest = 0.0;          ///< m, z of the hull's lowest point in the robot's frame
  double mass = 1.0;            ///< kg, of the root
  bool collides = true;         ///< the file's physics: else nothing touches or sees it
};

/// The robot whose root is the file's first object (specs: morse.md C.3). Its frame lies in the
/// root's origin along the file's axes. The hull: prisms one above the other, each the convex hull
/// of what collides at its height, so that hollows are filled. `physics` as in PropPlace. Throws
/// Error when there is nothing with a surface.
RobotShape RobotShapeOf(const assets::AssetScene& asset, const std::string& physics,
                        const Vec3& scale);

/// The hull of meshes as RobotShape has it: `z` of the parts counts from `lowest`.
std::vector<HullPart> SlicedHull(const std::vector<Mesh>& meshes, double lowest);

/// The convex hull of the points with at most `most` corners: those are left out that change it
/// least.
std::vector<Vec2> RoundedHull(std::vector<Vec2> points, std::size_t most);

/// Fewer triangles for views: corners nearer to each other than about `cell` (m) become one, until
/// there are at most `most` triangles. Only shapes that have more are changed.
Mesh Simplified(Mesh mesh, std::size_t most);

}  // namespace ccmorse::scene
