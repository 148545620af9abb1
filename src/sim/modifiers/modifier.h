#pragma once

#include <memory>
#include <span>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/service.h"

namespace ccmorse::sim {

/// Changes numbers of a component's data: on their way out, after each sample of a sensor, or on
/// their way in, in each message to an actuator (specs: morse.md B.5). What it looks for and does
/// not find it leaves alone. Belongs to its component; one thread at a time.
class Modifier {
 public:
  Modifier() = default;
  virtual ~Modifier() = default;
  Modifier(const Modifier&) = delete;
  Modifier& operator=(const Modifier&) = delete;

  virtual void Apply(std::span<const DataField> data, const Instant& now) = 0;
  /// Back to the state at the start of the simulation.
  virtual void Reset() {}
  /// Services that the component has of it.
  virtual std::vector<Service> Services() { return {}; }
};

/// The number of that name; nullptr where there is none, or a vector.
double* FindNumber(std::span<const DataField> data, std::string_view name);

/// Makes the modifier for a component of the scenario; `place` is its number among the component's.
/// Throws Error where a setting is none or out of range, or where it has to know where on the Earth
/// the world lies and nothing says so.
std::unique_ptr<Modifier> MakeModifier(const Component& component, const scene::ModifierDef& def,
                                       const scene::Scenario& scenario, std::size_t place);

}  // namespace ccmorse::sim
