#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/image.h"
#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/rays/beam_fan.h"
#include "sim/rays/range_engine.h"
#include "sim/rays/solid.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {

/// What a robot sees of the world from its own middle, 0.1 m above its origin, looking forward:
/// what each beam of a level fan meets. Colours are the scene's.
class Sight {
 public:
  /// `beams` from edge to edge of `view` (rad), which see as far as `range` (m).
  Sight(DeviceContext context, const sim::Robot& robot, int beams, double view, double range);

  /// From the right-most beam counter-clockwise, (beams); valid until the next call.
  const std::vector<sim::RayHit>& Look();

  /// Of what was met; black where it is nothing.
  Color ColorOf(const sim::Surface& surface) const;
  /// Height of its top above the floor, m.
  double TopOf(const sim::Surface& surface) const;
  /// Where it is in the world, m and rad; nothing for what has no middle: meshes and the floor.
  std::optional<Pose2> PoseOf(const sim::Surface& surface) const;
  double height() const;  ///< of the eye above the floor, m

 private:
  const scene::Box* FindBox(int id) const;

  DeviceContext context_;
  const sim::Robot& robot_;
  sim::BeamFan fan_;
  std::vector<sim::RayHit> hits_;
};

/// blobfinder (specs: player.md B.7): an image of 80 x 60 points over 60 degrees, 12 m far, in
/// which what is side by side and of one colour makes a blob.
class Blobfinder : public Device {
 public:
  Blobfinder(DeviceContext context, const sim::Robot& robot, std::uint16_t index, double frequency);
  void Step() override;

 private:
  DeviceContext context_;
  const sim::Robot& robot_;
  PublishRate rate_;
  std::optional<Sight> sight_;  // made when first needed, as it costs
};

/// fiducial (specs: player.md B.7): all boxes and robots that are seen, by id: boxes have their
/// own, robots 1001 and on in the order of their names. SET_FOV changes how far and how wide it
/// looks, up to 20 m and a whole turn.
class Fiducial : public Device {
 public:
  Fiducial(DeviceContext context, const sim::Robot& robot, std::uint16_t index, double frequency);
  void Step() override;

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  DeviceContext context_;
  const sim::Robot& robot_;
  PublishRate rate_;
  wire::FiducialFov view_;
  std::optional<Sight> sight_;  // made when first needed
};

}  // namespace ccmorse::servers::player
