#include "sim/modifiers/modifier.h"

#include <string>

#include "base/error.h"
#include "sim/modifiers/coordinates.h"
#include "sim/modifiers/noise_modifiers.h"
#include "sim/modifiers/settings.h"
#include "sim/noise.h"

namespace ccmorse::sim {

double* FindNumber(std::span<const DataField> data, std::string_view name) {
  for (const DataField& field : data) {
    if (field.name == name && field.numbers.size() == 1) return field.numbers.data();
  }
  return nullptr;
}

std::unique_ptr<Modifier> MakeModifier(const Component& component, const scene::ModifierDef& def,
                                       const scene::Scenario& scenario, std::size_t place) {
  if (auto changed = MakeCoordinateModifier(component, def, scenario)) return changed;
  // One's own noise for each, so that two of a kind do not err alike.
  const Noise noise(scenario.seed, component.full_name() + "/" + std::to_string(place));
  const ModifierSettings settings(component.full_name(), def);
  if (def.type == "PoseNoise") return std::make_unique<PoseNoise>(noise, settings);
  if (def.type == "IMUNoise") return std::make_unique<ImuNoise>(noise, settings);
  if (def.type == "OdometryNoise") return std::make_unique<OdometryNoise>(noise, settings);
  throw Error("there is no modifier of type '" + def.type + "'");
}

}  // namespace ccmorse::sim
