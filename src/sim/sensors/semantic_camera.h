#pragma once

#include <string>
#include <vector>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's SemanticCamera (specs: morse.md B.2): `visible_objects`, a list of {name, description,
/// type, position, orientation} of robots and passive objects whose property Type is `tag`, or that
/// have a true property of that name, as far as they are in the camera's view: between cam_near and
/// cam_far, m, within what a lens of cam_focal sees on 32 units of width, cam_width by cam_height.
/// A robot counts with the box around it, as if it were not turned, a passive object with its
/// origin. What stands before it hides it, unless `noocclusion`: a ray from the camera to its
/// origin decides. Places, m, and quaternions are the world's, or the camera's with `relative`.
/// The camera looks along its x. The name is the property Label, where there is one. 20 Hz.
class SemanticCamera : public Sensor {
 public:
  SemanticCamera(Robot& robot, const std::string& name, const World& world);
  void Prepare() override;
  void Sample(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;

  // The pyramid that it sees into, as its properties say now.
  double near() const { return near_; }                 ///< m along its x, where the pyramid begins
  double far() const { return far_; }                   ///< m, where it ends
  double half_width() const { return HalfOf(width_); }  ///< m to each side at 1 m
  double half_height() const { return HalfOf(height_); }  ///< m up and down at 1 m

 private:
  struct Seen {
    const SceneObject* object;
    Vec3 position;
    Rotation rotation;
  };

  void AppendFields(std::string& out) const override;
  double HalfOf(double pixels) const;
  bool IsTracked(const SceneObject& object) const;
  bool IsInView(const SceneObject& object, const Vec3& camera, const Rotation& view) const;
  bool IsHidden(const SceneObject& object, const Vec3& camera) const;

  const World& world_;
  double width_ = 256.0;   // cam_width, pixels
  double height_ = 256.0;  // cam_height, pixels
  double focal_ = 25.0;    // cam_focal
  double near_ = 0.1;      // cam_near, m
  double far_ = 100.0;     // cam_far, m
  bool flip_ = true;       // Vertical_Flip: of no effect, as there is no picture
  bool depth_ = false;     // retrieve_depth, likewise
  bool zbuffer_ = false;   // retrieve_zbuffer, likewise
  bool relative_ = false;  // relative
  bool unhidden_ = false;  // noocclusion
  std::string tag_ = "Object";
  std::vector<Seen> seen_;
};

}  // namespace ccmorse::sim
