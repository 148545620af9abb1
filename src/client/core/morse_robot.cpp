#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "client/core/subscription.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseRobot.h"

namespace CCMorse {

namespace {

// The first device of the robot that plays `Role`, or nullptr.
template <class Role>
Role* FindRole(const std::vector<MorseDevice*>& devices) {
  for (MorseDevice* device : devices) {
    if (Role* role = dynamic_cast<Role*>(device)) return role;
  }
  return nullptr;
}

void RequireFinite(double value, const char* what, const char* function) {
  if (!std::isfinite(value)) {
    throw MorseError(std::string(what) + " is " + (std::isnan(value) ? "not a number" : "infinite"),
                     function);
  }
}

}  // namespace

MorseRobot::MorseRobot(MorseClient& client, std::string name, std::string type)
    : client_(client), name_(std::move(name)), type_(std::move(type)) {}

MorseRobot::~MorseRobot() = default;

void MorseRobot::ThrowNoDevice(const std::string& name) const {
  std::string known;
  for (const MorseDevice* device : devices_) {
    known += (known.empty() ? "" : ", ") + device->GetShortName();
  }
  const std::string wanted =
      name.empty() ? "no device of this class" : "no such device \"" + name + "\"";
  throw MorseError(
      "robot " + name_ + " has " + wanted + "; it has " + (known.empty() ? "none" : known),
      "MorseRobot::GetDevice()");
}

std::vector<PlayerCc::ClientProxy*> MorseRobot::GetProxies() const {
  const std::lock_guard lock(client_.DataMutex());
  std::vector<PlayerCc::ClientProxy*> proxies;
  for (const auto& subscription : subscriptions_) proxies.push_back(subscription->proxy);
  return proxies;
}

void MorseRobot::AddSubscription(const std::shared_ptr<MorseSubscription>& subscription) {
  const std::lock_guard lock(client_.DataMutex());
  subscriptions_.push_back(subscription);
}

void MorseRobot::RemoveSubscription(const MorseSubscription* subscription) {
  const std::lock_guard lock(client_.DataMutex());
  subscriptions_.erase(
      std::remove_if(subscriptions_.begin(), subscriptions_.end(),
                     [&](const auto& entry) { return entry.get() == subscription; }),
      subscriptions_.end());
}

bool MorseRobot::HasProperties() const {
  return FindRole<MorsePropertySource>(devices_) != nullptr;
}

double MorseRobot::PropertyOr(const char* key, double fallback) const {
  const auto* source = FindRole<MorsePropertySource>(devices_);
  return source ? source->GetAll().GetDouble(key, fallback) : fallback;
}

double MorseRobot::Property(const char* key, const char* function) const {
  const double value = PropertyOr(key, std::numeric_limits<double>::quiet_NaN());
  if (std::isnan(value)) {
    throw MorseError("the simulator does not tell \"" + std::string(key) + "\" of robot " + name_,
                     function);
  }
  return value;
}

void MorseRobot::SetGoal(double x, double y, double tolerance, double speed) {
  constexpr char kFunction[] = "MorseRobot::SetGoal()";
  RequireFinite(x, "x", kFunction);
  RequireFinite(y, "y", kFunction);
  RequireFinite(tolerance, "the tolerance", kFunction);
  RequireFinite(speed, "the speed", kFunction);
  auto* control = FindRole<MorseGoalControl>(devices_);
  if (!control) throw MorseError("robot " + name_ + " has no waypoint actuator", kFunction);
  // Two actuators that both push the robot would fight.
  if (auto* motion = FindRole<MorseSpeedControl>(devices_)) motion->Stop();
  const double limit = PropertyOr("max_speed", 1.0);
  control->SetGoal(x, y, tolerance, speed > 0.0 ? speed : limit);
  goal_set_ = true;
}

void MorseRobot::SetSpeed(double v, double w) {
  constexpr char kFunction[] = "MorseRobot::SetSpeed()";
  RequireFinite(v, "the forward speed", kFunction);
  RequireFinite(w, "the turn rate", kFunction);
  auto* control = FindRole<MorseSpeedControl>(devices_);
  if (!control) throw MorseError("robot " + name_ + " has no motion actuator", kFunction);
  if (goal_set_.exchange(false)) {
    if (auto* goal = FindRole<MorseGoalControl>(devices_)) goal->Stop();
  }
  const double v_limit = std::abs(PropertyOr("max_speed", std::numeric_limits<double>::infinity()));
  const double w_limit =
      std::abs(PropertyOr("max_turn_rate", std::numeric_limits<double>::infinity()));
  control->SetSpeed(std::clamp(v, -v_limit, v_limit), std::clamp(w, -w_limit, w_limit));
}

void MorseRobot::Stop() {
  if (goal_set_.exchange(false)) {
    if (auto* goal = FindRole<MorseGoalControl>(devices_)) goal->Stop();
  }
  if (auto* control = FindRole<MorseSpeedControl>(devices_)) control->Stop();
  client_.Flush();
}

player_pose3d_t MorseRobot::GetPose() const {
  const auto* source = FindRole<MorsePoseSource>(devices_);
  if (!source) throw MorseError("robot " + name_ + " has no pose sensor", "MorseRobot::GetPose()");
  return source->GetPose();
}

double MorseRobot::GetWeight() const { return Property("mass", "MorseRobot::GetWeight()"); }

player_bbox3d_t MorseRobot::GetSize() const {
  constexpr char kFunction[] = "MorseRobot::GetSize()";
  player_bbox3d_t size{};
  size.sl = Property("size.0", kFunction);
  size.sw = Property("size.1", kFunction);
  size.sh = Property("size.2", kFunction);
  return size;
}

double MorseRobot::GetWheelRadius() const {
  return Property("wheel_radius", "MorseRobot::GetWheelRadius()");
}

double MorseRobot::GetWheelTrack() const {
  return Property("wheel_track", "MorseRobot::GetWheelTrack()");
}

double MorseRobot::GetMaxSpeed() const {
  return Property("max_speed", "MorseRobot::GetMaxSpeed()");
}

double MorseRobot::GetMaxTurnRate() const {
  return Property("max_turn_rate", "MorseRobot::GetMaxTurnRate()");
}

Color_t MorseRobot::GetColor() const {
  constexpr char kFunction[] = "MorseRobot::GetColor()";
  const auto channel = [&](const char* key) {
    return static_cast<unsigned char>(std::clamp(Property(key, kFunction), 0.0, 255.0));
  };
  return Color_t{channel("color.0"), channel("color.1"), channel("color.2")};
}

}  // namespace CCMorse
