#include <cmath>

#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseMotionVW.h"

namespace CCMorse {

namespace {
const bool kMotionVwRegistered =
    RegisterMorseDevice({{"motion", "motionvw"}, {"MotionVW"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<MorseMotionVW>(info);
                         }});
}  // namespace

MorseMotionVW::MorseMotionVW(const MorseDeviceInfo& info) : MorseActuator(info) {}

void MorseMotionVW::SetSpeed(double v, double w) {
  if (!std::isfinite(v) || !std::isfinite(w)) {
    throw MorseError("a speed is no finite number", "MorseMotionVW::SetSpeed()");
  }
  CommandNumbers("set_speed", {v, w});
}

void MorseMotionVW::Stop() { SetSpeed(0.0, 0.0); }

}  // namespace CCMorse
