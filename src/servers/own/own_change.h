#pragma once

#include <functional>
#include <vector>

#include "base/json.h"
#include "sim/own/own_component.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// What the code of a component of one's own has done in one go, as it comes from the code and as
/// it is recorded: an object with
///   data  its data, from now on
///   do    a list of what it does to the world, in order:
///         ["speed", vx, vy, wz]           its robot drives, m/s and rad/s, in the robot's frame
///         ["place", x, y, yaw]            its robot is put there, m and rad
///         ["pixel", x, y, r, g, b, alpha] on the canvas: cells; 0..255; alpha 0..1
///         ["line", x0, y0, x1, y1, r, g, b, alpha]
///         ["clear"], ["resize", width, height]
///   off   why it is switched off, for ever
/// each of which may be missing.
class OwnChange {
 public:
  /// Throws Error that says what is wrong.
  static OwnChange Parse(const Json& change);

  void Apply(sim::Simulation& simulation, sim::OwnComponent& component) const;

 private:
  using Deed = std::function<void(sim::Simulation&, sim::Component&)>;
  static Deed ParseDeed(const Json& deed);

  Json data_;  // null: as they were
  std::vector<Deed> deeds_;
  bool off_ = false;
};

}  // namespace ccmorse::servers
