#include <cmath>

#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseWaypoint.h"

namespace CCMorse {

namespace {

const bool kWaypointRegistered =
    RegisterMorseDevice({{"waypoint"}, {"Waypoint"}, [](const MorseDeviceInfo& info) {
                           return std::make_unique<MorseWaypoint>(info);
                         }});

MorseArgs Goal(double x, double y, double tolerance, double speed, const char* function) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(tolerance) ||
      !std::isfinite(speed)) {
    throw MorseError("a number of the goal is not finite", function);
  }
  return MorseArgs(x, y, 0.0, tolerance, speed);
}

}  // namespace

MorseWaypoint::MorseWaypoint(const MorseDeviceInfo& info) : MorseActuator(info) {}

void MorseWaypoint::SetGoal(double x, double y, double tolerance, double speed) {
  Command("setdest", Goal(x, y, tolerance, speed, "MorseWaypoint::SetGoal()"));
}

bool MorseWaypoint::GoTo(double x, double y, double tolerance, double speed, double timeout) {
  try {
    Request("goto", Goal(x, y, tolerance, speed, "MorseWaypoint::GoTo()"), timeout);
    return true;
  } catch (const MorseError& error) {
    if (error.GetErrorCode() == MorseError::kPreempted) return false;
    throw;
  }
}

void MorseWaypoint::Stop() { Command("stop"); }
void MorseWaypoint::Resume() { Command("resume"); }
std::string MorseWaypoint::GetStatus() { return Request("get_status").GetString(""); }

}  // namespace CCMorse
