#include "sim/victim.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace ccmorse::sim {
namespace {

bool IsAmong(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

void SetRequirements(SceneObject& victim, const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
  victim.properties.Set("Requirements", Json(text));
}

}  // namespace

std::vector<int> NumbersOf(std::string_view text) {
  std::vector<int> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    while (begin < end && text[begin] == ' ') ++begin;
    int number = 0;
    const auto result = std::from_chars(text.data() + begin, text.data() + end, number);
    if (result.ec == std::errc()) numbers.push_back(number);
    begin = end + 1;
  }
  return numbers;
}

std::vector<int> RequirementsOf(const SceneObject& victim) {
  const Json* const given = victim.properties.Find("Requirements");
  if (given == nullptr) return {};
  // A property may be a lone number, too.
  return NumbersOf(given->IsString() ? given->AsString() : given->Dump());
}

int SeverityOf(const SceneObject& victim) {
  const Json* const given = victim.properties.Find("Severity");
  return given != nullptr && given->IsNumber() ? static_cast<int>(given->AsDouble()) : 0;
}

bool CanTreat(const SceneObject& victim, const std::vector<int>& abilities) {
  const std::vector<int> needed = RequirementsOf(victim);
  return std::any_of(needed.begin(), needed.end(),
                     [&](int one) { return IsAmong(abilities, one); });
}

bool Treat(SceneObject& victim, const std::vector<int>& abilities) {
  std::vector<int> needed = RequirementsOf(victim);
  std::erase_if(needed, [&](int one) { return IsAmong(abilities, one); });
  if (needed.empty()) {
    Heal(victim);
  } else {
    SetRequirements(victim, needed);
  }
  return needed.empty();
}

void Heal(SceneObject& victim) {
  SetRequirements(victim, {});
  victim.properties.Set("Injured", Json(false));
  victim.properties.Set("Severity", Json(0));
}

}  // namespace ccmorse::sim
