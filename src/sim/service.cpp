#include "sim/service.h"

#include <cmath>

namespace ccmorse::sim {
namespace {

double FiniteNumber(const Json& value, const char* name) {
  if (!value.IsNumber()) {
    throw WrongArgument(std::string(name) + " must be a number, not " + value.TypeName());
  }
  if (!std::isfinite(value.AsDouble())) {
    throw WrongArgument(std::string(name) + " must be finite, not " + value.Dump());
  }
  return value.AsDouble();
}

}  // namespace

double NumberArgument(Arguments arguments, std::size_t index, const char* name) {
  return FiniteNumber(arguments[index], name);
}

double NumberArgument(Arguments arguments, std::size_t index, const char* name, double fallback) {
  return index < arguments.size() ? FiniteNumber(arguments[index], name) : fallback;
}

int IntegerArgument(Arguments arguments, std::size_t index, const char* name, int low, int high) {
  const Json& value = arguments[index];
  if (!value.IsInt() || value.AsInt() < low || value.AsInt() > high) {
    throw WrongArgument(std::string(name) + " must be a whole number from " + std::to_string(low) +
                        " to " + std::to_string(high) + ", not " + value.Dump().substr(0, 40));
  }
  return static_cast<int>(value.AsInt());
}

const std::string& StringArgument(Arguments arguments, std::size_t index, const char* name) {
  const Json& value = arguments[index];
  if (!value.IsString()) {
    throw WrongArgument(std::string(name) + " must be a string, not " + value.TypeName());
  }
  return value.AsString();
}

double NumberMember(const Json& object, const char* key) {
  const Json* value = object.Find(key);
  if (value == nullptr) throw WrongArgument(std::string("'") + key + "' is missing");
  return FiniteNumber(*value, key);
}

}  // namespace ccmorse::sim
