#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/json.h"
#include "base/pose.h"

namespace ccmorse::assets {

/// An affine map: where it takes the three axes and the origin. What a 4x4 matrix with the last row
/// 0 0 0 1 is.
struct Affine {
  Vec3 x{1.0, 0.0, 0.0};
  Vec3 y{0.0, 1.0, 0.0};
  Vec3 z{0.0, 0.0, 1.0};
  Vec3 position;

  /// Where a direction goes.
  constexpr Vec3 Turn(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
  /// Where a point goes.
  constexpr Vec3 operator()(const Vec3& v) const { return Turn(v) + position; }
  /// Volume of what a unit cube becomes; less than 0 when it mirrors.
  constexpr double Determinant() const { return Dot(x, Cross(y, z)); }
};

/// First b, then a.
constexpr Affine operator*(const Affine& a, const Affine& b) {
  return {a.Turn(b.x), a.Turn(b.y), a.Turn(b.z), a(b.position)};
}

/// A picture that materials use.
struct AssetImage {
  std::string name;
  std::string path;             ///< as the file has it ("//" in a .blend: beside it); "" for none
  std::size_t packed_size = 0;  ///< bytes, where the file itself holds the picture; else 0
};

/// How a surface looks, and in MORSE how slippery it is.
struct AssetMaterial {
  std::string name;
  Color color{204, 204, 204};  ///< diffuse, sRGB
  double specular = 0.0;       ///< intensity, 0..1: what MORSE's scanners call remission
  double alpha = 1.0;          ///< 0 clear .. 1 opaque
  double friction = 0.5;       ///< of contacts, >= 0 (Blender's default where a file has none)
  double restitution = 0.0;    ///< of contacts, 0..1
  int image = -1;              ///< index of images; -1: none
  /// Where its picture can be read: `color` and the picture's mean, mixed as the material says.
  std::optional<Color> pictured;
};

/// A game property of an object: MORSE's way to say what a thing is.
struct AssetProperty {
  std::string name;
  Json value;  ///< bool, integer, number or text
};

/// What the game engine's physics knew of an object (specs: morse.md H.1, I).
struct AssetPhysics {
  /// "NO_COLLISION", "STATIC", "DYNAMIC", "RIGID_BODY", "SOFT_BODY", "OCCLUDER", "SENSOR",
  /// "NAVMESH" or "CHARACTER", as Blender calls them.
  std::string type = "STATIC";
  bool actor = false;
  bool ghost = false;                 ///< gives way to everything
  double mass = 1.0;                  ///< kg
  double radius = 1.0;                ///< m, of bounds that are a ball
  double linear_damping = 0.04;       ///< share of speed lost in a second, 0..1
  double angular_damping = 0.1;       ///< likewise
  double margin = 0.04;               ///< m around the shape
  double form_factor = 0.4;           ///< of the inertia
  std::array<bool, 3> lock_move{};    ///< along x, y, z
  std::array<bool, 3> lock_rotate{};  ///< about x, y, z
  /// Shape that collides: "BOX", "SPHERE", "CYLINDER", "CONE", "TRIANGLE_MESH", "CONVEX_HULL" or
  /// "CAPSULE"; "" where the file leaves it to the type.
  std::string bounds;
  bool compound = false;  ///< the bounds of its children belong to it

  bool Collides() const { return type != "NO_COLLISION" && type != "OCCLUDER"; }
};

/// A lamp; it shines along its object's -z.
struct AssetLight {
  std::string kind;  ///< "POINT", "SUN", "SPOT", "HEMI" or "AREA"
  Color color{255, 255, 255};
  double energy = 1.0;      ///< relative
  double distance = 0.0;    ///< m at which half is left; 0: not said
  double spot_angle = 0.0;  ///< rad, full opening of a spot's cone; else 0
};

/// A camera; it looks along its object's -z, with +y up.
struct AssetCamera {
  double fov = 0.0;   ///< rad, of the picture's longer side; 0 for one without perspective
  double near = 0.0;  ///< m
  double far = 0.0;   ///< m
};

/// One thing of the scene: a mesh, a lamp, a camera, or a point that others hang on.
struct AssetObject {
  std::string name;
  std::string type;          ///< "MESH", "EMPTY", "LAMP", "CAMERA", "ARMATURE", "CURVE", ...
  int parent = -1;           ///< index of objects; -1: none
  Affine matrix;             ///< from its own frame to the world
  std::uint32_t layers = 1;  ///< bits of the layers that it is on
  /// The file's active scene shows it: only these are in the game at its start.
  bool shown = true;
  bool hidden = false;    ///< of those shown, not to be seen, but to be run into
  bool instance = false;  ///< made by the reader of a group that an object stands for

  std::vector<Vec3> vertices;                 ///< m, in the world
  std::vector<std::array<int, 3>> triangles;  ///< indexes of vertices; each has an area
  std::vector<int> material_of;               ///< by triangle an index of materials, -1 for none
  /// By triangle the mean colour of what its material's picture shows there, as far as a face of
  /// one colour can; empty where no material has a picture that is laid on by coordinates.
  std::vector<Color> color_of;
  int faces = 0;  ///< polygons that the triangles are pieces of

  AssetPhysics physics;
  std::vector<AssetProperty> properties;
  std::optional<AssetLight> light;
  std::optional<AssetCamera> camera;
};

/// What a file of shapes holds, in metres with z up.
struct AssetScene {
  std::string format;  ///< "Blender 2.74", "glTF 2.0", "Wavefront OBJ", "STL", "COLLADA 1.4.1"
  Vec3 gravity{0.0, 0.0, -9.81};  ///< m/s2
  std::vector<AssetObject> objects;
  std::vector<AssetMaterial> materials;
  std::vector<AssetImage> images;
  int camera = -1;                 ///< index of the object that the file looks through; -1: none
  std::vector<std::string> notes;  ///< what of the file was left out, in words
};

/// What may be read at most: a file of a few bytes can ask for a great deal.
struct AssetLimits {
  std::size_t bytes = std::size_t{1} << 30U;  ///< of a file, and of what a packed file unfolds to
  std::size_t triangles = 20'000'000;         ///< of all objects
  std::size_t objects = 200'000;
};

/// Smallest box around some objects, m; low > high for none.
struct Extent {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};
  bool empty() const { return low.x > high.x; }
  void Add(const Vec3& point);
};

Extent ExtentOf(const AssetObject& object);

/// A text that may hold names of a file, for a line of output: control characters become '?'.
std::string OneLine(std::string text);
/// Of all objects that are shown.
Extent ExtentOf(const AssetScene& scene);

}  // namespace ccmorse::assets
