#include "sim/actuators/light.h"

#include "base/trig.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

Light::Light(Robot& robot, const std::string& name) : Actuator(robot, name, "Light", 60.0) {
  AddProperty("emit", emit_);
  AddProperty("distance", distance_, 0.0, 1e6);
  AddProperty("color", color_);
  AddProperty("size", size_, 0.0, kPi);
  AddProperty("energy", energy_, 0.0, 1e6);
  AddService({"toggle", {{"emit", true}}, [this](Arguments arguments) {
                Set(arguments.empty() || arguments[0].IsNull() ? Json(!shining_) : arguments[0]);
                return Json(true);
              }});
}

void Light::Set(const Json& emit) {
  if (!emit.IsBool()) {
    throw WrongArgument(std::string("emit must be true or false, not ") + emit.TypeName());
  }
  shining_ = emit.AsBool();
  DataChanged(timestamp());
}

void Light::Receive(const Json& message) {
  const Json* const emit = message.Find("emit");
  if (emit == nullptr) throw WrongArgument("'emit' is missing");
  Set(*emit);
}

void Light::Reset() {
  Actuator::Reset();
  shining_ = emit_;
}

void Light::AppendFields(std::string& out) const { AppendField(out, "emit", shining_); }

}  // namespace ccmorse::sim
