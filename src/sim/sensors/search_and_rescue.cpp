#include "sim/sensors/search_and_rescue.h"

#include <algorithm>
#include <utility>

#include "sim/robots/robot.h"
#include "sim/victim.h"

namespace ccmorse::sim {
namespace {

constexpr int kHealing = 10;  // activations

Json ListOf(const std::vector<int>& numbers) {
  return Json(Json::Array(numbers.begin(), numbers.end()));
}

}  // namespace

SearchAndRescue::SearchAndRescue(Robot& robot, const std::string& name, World& world)
    : Sensor(robot, name, "SearchAndRescue", 6.0), world_(world) {
  AddProperty("Heal_range", heal_range_, 0.0, 1e6);
  AddProperty("Abilities", abilities_);
  AddProperty("Angle", angle_, 0.0, 360.0);
  AddProperty("Distance", distance_, 0.0, 1e6);
  AddProperty("Freq", look_rate_, 1e-3, 1e6);
  AddQuery(
      {"get_robot_abilities", {}, [this](Arguments) { return ListOf(NumbersOf(abilities_)); }});
  AddQuery({"get_victim_requirements", {}, [this](Arguments) {
              return ListOf(RequirementsOf(*Nearest().object));
            }});
  AddQuery({"get_victim_severity", {}, [this](Arguments) {
              return Json(SeverityOf(*Nearest().object));
            }});
  AddService(
      {"heal", {}, nullptr, [this](Arguments, Completion done) { StartHealing(std::move(done)); }});
}

// Nobody is left to answer when the simulation is taken down.
SearchAndRescue::~SearchAndRescue() { pending_ = nullptr; }

std::vector<SearchAndRescue::Victim> SearchAndRescue::Look() {
  std::vector<Victim> seen;
  const SightCone cone(*this, angle_, distance_);
  for (SceneObject& object : world_.objects().all()) {
    if (object.robot == &robot() || !object.Is("Injured")) continue;
    const Vec3 position = object.WorldPosition();
    if (const auto distance = cone.DistanceOf(position)) {
      seen.push_back({&object, *distance, position});
    }
  }
  return seen;
}

SearchAndRescue::Victim SearchAndRescue::Nearest() {
  const std::vector<Victim> seen = Look();
  const auto nearest =
      std::min_element(seen.begin(), seen.end(),
                       [](const Victim& a, const Victim& b) { return a.distance < b.distance; });
  if (nearest == seen.end()) throw ServiceFailed("No victim within sight of " + full_name());
  return *nearest;
}

void SearchAndRescue::StartHealing(Completion done) {
  if (pending_) {
    throw ServiceFailed("A service (heal) is already running. I do not know what to do.");
  }
  const Victim victim = Nearest();
  const std::string whom = "Victim '" + victim.object->name + "'";
  if (victim.distance >= heal_range_) throw ServiceFailed(whom + " is too far away to be healed");
  if (!CanTreat(*victim.object, NumbersOf(abilities_))) {
    throw ServiceFailed(whom + " needs what the robot cannot do");
  }
  healing_ = victim.object;
  activations_ = 0;
  pending_ = std::move(done);
}

void SearchAndRescue::Sample(const Instant& now) {
  // Half a tick of grace, as sums of fractions are not exact.
  if (now.time >= next_look_ - 0.5 * now.step) {
    seen_ = Look();
    next_look_ = now.time + 1.0 / look_rate_;
  }
  DataChanged(now.time);
}

void SearchAndRescue::Conclude(const Instant& /*now*/) {
  if (!pending_ || ++activations_ < kHealing) return;
  SceneObject& victim = *healing_;
  const bool healed = Treat(victim, NumbersOf(abilities_));
  Finish(Outcome::kSuccess,
         "Victim '" + victim.name + (healed ? "' healed" : "' partially healed"));
}

void SearchAndRescue::Finish(Outcome outcome, const std::string& text) {
  if (!pending_) return;
  healing_ = nullptr;
  const Completion done = std::exchange(pending_, nullptr);
  done({outcome, text.empty() ? Json() : Json(text)});
}

void SearchAndRescue::Interrupt() { Finish(Outcome::kPreempted, ""); }

void SearchAndRescue::Reset() {
  Sensor::Reset();
  Interrupt();
  seen_.clear();
  next_look_ = 0.0;
}

void SearchAndRescue::AddToHash(StateHash& hash) const {
  for (const Victim& victim : seen_) {
    hash.Add(victim.object->name);
    hash.Add(victim.position.x);
    hash.Add(victim.position.y);
    hash.Add(victim.position.z);
  }
}

void SearchAndRescue::AppendFields(std::string& out) const {
  Json::Object victims;
  for (const Victim& victim : seen_) {
    const Vec3& at = victim.position;
    victims.emplace_back(
        victim.object->name,
        Json::Object{{"coordinate", Json::Object{{"x", at.x}, {"y", at.y}, {"z", at.z}}},
                     {"requirements", ListOf(RequirementsOf(*victim.object))},
                     {"severity", SeverityOf(*victim.object)}});
  }
  out += ", \"victim_dict\": " + Json(std::move(victims)).Dump();
}

}  // namespace ccmorse::sim
