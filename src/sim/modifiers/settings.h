#pragma once

#include <array>
#include <string>

#include "scene/scenario.h"

namespace ccmorse::sim {

/// The settings of a modifier. Each reader throws Error that names component, modifier and setting.
class ModifierSettings {
 public:
  /// `whose` is the component's full name. Both outlive it.
  ModifierSettings(const std::string& whose, const scene::ModifierDef& def)
      : whose_(whose), def_(def) {}

  bool Has(const char* name) const { return def_.settings.Find(name) != nullptr; }
  /// A number, or a text that is one (specs: morse.md B.5, "strings allowed").
  double Number(const char* name, double fallback, double low, double high) const;
  bool Flag(const char* name, bool fallback) const;
  /// A standard deviation for each of three: one number for all, or an object of them by these
  /// names, where what is left out has none.
  std::array<double, 3> Deviations(const char* name, double fallback,
                                   const std::array<const char*, 3>& parts) const;

  [[noreturn]] void Fail(const char* name, const std::string& what) const;

 private:
  const std::string& whose_;
  const scene::ModifierDef& def_;
};

}  // namespace ccmorse::sim
