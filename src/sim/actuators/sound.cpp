#include "sim/actuators/sound.h"

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Sound::Sound(Robot& robot, const std::string& name) : Actuator(robot, name, "Sound", 60.0) {}

void Sound::Receive(const Json& message) {
  const Json* const mode = message.Find("mode");
  if (mode == nullptr ||
      (*mode != Json("play") && *mode != Json("pause") && *mode != Json("stop"))) {
    throw WrongArgument("'mode' must be \"play\", \"pause\" or \"stop\"");
  }
  mode_ = mode->AsString();
  DataChanged(timestamp());
}

void Sound::Reset() {
  Actuator::Reset();
  mode_ = "stop";
}

void Sound::AppendFields(std::string& out) const {
  AppendField(out, "mode", std::string_view(mode_));
}

}  // namespace ccmorse::sim
