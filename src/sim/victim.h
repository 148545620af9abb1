#pragma once

#include <string_view>
#include <vector>

#include "sim/scene_objects.h"

namespace ccmorse::sim {

// Victims: objects with MORSE's properties Injured, Requirements, whole numbers of which one
// stands for each thing that is to be done for them, and Severity (specs: morse.md B.2
// SearchAndRescue, B.4 Victim).

/// The whole numbers of "1,2,3"; what is none is left out.
std::vector<int> NumbersOf(std::string_view text);

/// What is to be done for a victim; nothing where it has no Requirements.
std::vector<int> RequirementsOf(const SceneObject& victim);

/// 0 where it has none.
int SeverityOf(const SceneObject& victim);

/// Does the victim require any of the abilities?
bool CanTreat(const SceneObject& victim, const std::vector<int>& abilities);

/// Takes the abilities off what it requires. Once that is nothing it is healed, and true comes
/// back.
bool Treat(SceneObject& victim, const std::vector<int>& abilities);

/// Requires nothing any more, is not injured, and its severity is 0.
void Heal(SceneObject& victim);

}  // namespace ccmorse::sim
