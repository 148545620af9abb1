#pragma once

#include <string>
#include <vector>

#include "assets/asset_scene.h"

namespace ccmorse::assets {

/// What the readers of exchange formats share: faces become triangles of an object, within limits.
class ShapeBuilder {
 public:
  /// `name` is the file's, for messages. All three must outlive it.
  ShapeBuilder(AssetScene& scene, const std::string& name, const AssetLimits& limits)
      : scene_(scene), name_(name), limits_(limits) {}

  /// A new, empty object of type "MESH" (or another), the scene's last. Throws Error beyond limits.
  AssetObject& AddObject(const std::string& name, const Affine& matrix,
                         const std::string& type = "MESH");

  /// Adds a vertex to an object, in the world. Throws Error when it is not finite.
  void AddVertex(const Vec3& vertex, AssetObject& object);

  /// Adds a polygon of the object's vertices. Throws Error for an index beyond them and beyond
  /// limits.
  void AddFace(const std::vector<int>& face, int material, AssetObject& object);

  /// Throws Error "FILE: text".
  [[noreturn]] void Fail(const std::string& text) const;

 private:
  AssetScene& scene_;
  const std::string& name_;
  const AssetLimits& limits_;
  std::size_t vertices_ = 0;
  std::size_t triangles_ = 0;
};

/// The rotation that a quaternion of any length but 0 means; none for 0.
Affine FromQuaternion(double w, Vec3 v);

/// An sRGB channel of 0..255 for a share of light of 0..1 (IEC 61966-2-1).
std::uint8_t FromLinear(double share);
/// The same without the curve, for colours that already have it.
std::uint8_t FromShare(double share);

}  // namespace ccmorse::assets
