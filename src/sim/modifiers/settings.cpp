#include "sim/modifiers/settings.h"

#include <charconv>
#include <optional>

#include "base/error.h"

namespace ccmorse::sim {
namespace {

constexpr double kWidest = 1e9;  // standard deviation

std::optional<double> AsNumber(const Json& value) {
  if (value.IsNumber()) return value.AsDouble();
  if (!value.IsString()) return std::nullopt;
  const std::string& text = value.AsString();
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

void ModifierSettings::Fail(const char* name, const std::string& what) const {
  throw Error(whose_ + ": the modifier " + def_.type + ": " + name + " must be " + what + ", not " +
              def_.settings.Find(name)->Dump().substr(0, 40));
}

double ModifierSettings::Number(const char* name, double fallback, double low, double high) const {
  const Json* const given = def_.settings.Find(name);
  if (given == nullptr) return fallback;
  const std::optional<double> number = AsNumber(*given);
  if (!number || !(*number >= low) || !(*number <= high)) {
    Fail(name, "a number from " + Json(low).Dump() + " to " + Json(high).Dump());
  }
  return *number;
}

bool ModifierSettings::Flag(const char* name, bool fallback) const {
  const Json* const given = def_.settings.Find(name);
  if (given == nullptr) return fallback;
  if (!given->IsBool()) Fail(name, "true or false");
  return given->AsBool();
}

std::array<double, 3> ModifierSettings::Deviations(const char* name, double fallback,
                                                   const std::array<const char*, 3>& parts) const {
  const Json* const given = def_.settings.Find(name);
  if (given == nullptr || !given->IsObject()) {
    const double all = Number(name, fallback, 0.0, kWidest);
    return {all, all, all};
  }
  std::array<double, 3> deviations{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Json* const one = given->Find(parts[i]);
    if (one == nullptr) continue;
    const std::optional<double> number = AsNumber(*one);
    if (!number || !(*number >= 0.0) || !(*number <= kWidest)) {
      Fail(name, "a number of 0 or more, or one for each part");
    }
    deviations[i] = *number;
  }
  return deviations;
}

}  // namespace ccmorse::sim
