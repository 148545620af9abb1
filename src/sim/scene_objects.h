#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "base/pose.h"
#include "base/rotation.h"
#include "scene/scenario.h"

namespace ccmorse::sim {

class Component;
class Robot;

/// One thing of the scene that has a name and MORSE's properties: a robot or a passive object.
struct SceneObject {
  std::string name;
  const Robot* robot = nullptr;  ///< where it is one
  Json properties;               ///< as they are now
  scene::PropDef start;          ///< of a passive object, as the scenario has it

  // Of a passive object, where it is; in the frame of who has it while anybody has.
  const Component* holder = nullptr;  ///< the gripper that has it
  const Robot* bearer = nullptr;      ///< the robot that has it without a gripper, as a human does
  Vec3 position;                      ///< m
  Rotation rotation;

  /// Where it is in the world now.
  Vec3 WorldPosition() const;
  Rotation WorldRotation() const;
  /// Is a passive object elsewhere than at the start, or turned?
  bool HasMoved() const;

  /// Does anybody have it?
  bool held() const { return holder != nullptr || bearer != nullptr; }

  /// Has it the property, whatever its value? All robots have "Robot_Tag".
  bool Has(std::string_view property) const;
  /// Has it the property, and is that what Python calls true?
  bool Is(std::string_view property) const;
};

/// What sensors look for by name and property, and grippers take (specs: morse.md B.2, B.3, B.6):
/// robots in the order of their names, then passive objects as the scenario has them. Any number
/// of threads may look while none changes anything.
class SceneObjects {
 public:
  /// Makes it those of the scene. The robots outlive it.
  void Set(std::span<const Robot* const> robots, const std::vector<scene::PropDef>& props);

  std::span<const SceneObject> all() const { return objects_; }
  std::span<SceneObject> all() { return objects_; }
  /// nullptr when there is none of that name.
  SceneObject* Find(std::string_view name);
  const SceneObject* Find(std::string_view name) const;

  /// A passive object goes along with a gripper from now on, as it is now; nullptr: stays.
  static void SetHolder(SceneObject& object, const Component* holder);
  /// The same for a robot.
  static void SetBearer(SceneObject& object, const Robot* bearer);

  /// Places and properties as at the start, and nothing held.
  void Reset();

 private:
  std::vector<SceneObject> objects_;
};

/// A cone of sight: what is within `distance` (m) of a component's place and not farther than half
/// of `angle` (degrees, full aperture) from the direction of its x axis; Blender's radar sensor.
class SightCone {
 public:
  SightCone(const Component& component, double angle, double distance);
  /// The point's distance, m; nothing where it is outside.
  std::optional<double> DistanceOf(const Vec3& point) const;

 private:
  Vec3 apex_;
  Vec3 axis_;
  double least_cosine_;
  double distance_;
};

}  // namespace ccmorse::sim
