#include "sim/sensors/search_and_rescue.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "sim/robots/robot.h"

namespace ccmorse::sim {
namespace {

constexpr int kHealing = 10;  // activations

// The whole numbers of "1,2,3"; others are left out. A property may be a lone number, too.
std::vector<int> Numbers(std::string_view text) {
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

std::vector<int> Requirements(const SceneObject& victim) {
  const Json* const given = victim.properties.Find("Requirements");
  if (given == nullptr) return {};
  return Numbers(given->IsString() ? given->AsString() : given->Dump());
}

int Severity(const SceneObject& victim) {
  const Json* const given = victim.properties.Find("Severity");
  return given != nullptr && given->IsNumber() ? static_cast<int>(given->AsDouble()) : 0;
}

Json ListOf(const std::vector<int>& numbers) {
  return Json(Json::Array(numbers.begin(), numbers.end()));
}

std::string TextOf(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
  return text;
}

bool Contains(const std::vector<int>& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

}  // namespace

SearchAndRescue::SearchAndRescue(Robot& robot, const std::string& name, World& world)
    : Sensor(robot, name, "SearchAndRescue", 6.0), world_(world) {
  AddProperty("Heal_range", heal_range_, 0.0, 1e6);
  AddProperty("Abilities", abilities_);
  AddProperty("Angle", angle_, 0.0, 360.0);
  AddProperty("Distance", distance_, 0.0, 1e6);
  AddProperty("Freq", look_rate_, 1e-3, 1e6);
  AddQuery({"get_robot_abilities", {}, [this](Arguments) { return ListOf(Numbers(abilities_)); }});
  AddQuery({"get_victim_requirements", {}, [this](Arguments) {
              return ListOf(Requirements(*Nearest().object));
            }});
  AddQuery(
      {"get_victim_severity", {}, [this](Arguments) { return Json(Severity(*Nearest().object)); }});
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
  const std::vector<int> abilities = Numbers(abilities_);
  const std::vector<int> needed = Requirements(*victim.object);
  if (std::none_of(needed.begin(), needed.end(),
                   [&](int one) { return Contains(abilities, one); })) {
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
  const std::vector<int> abilities = Numbers(abilities_);
  std::vector<int> needed = Requirements(victim);
  std::erase_if(needed, [&](int one) { return Contains(abilities, one); });
  victim.properties.Set("Requirements", Json(TextOf(needed)));
  if (needed.empty()) {
    victim.properties.Set("Injured", Json(false));
    victim.properties.Set("Severity", Json(0));
  }
  Finish(Outcome::kSuccess,
         "Victim '" + victim.name + (needed.empty() ? "' healed" : "' partially healed"));
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
                     {"requirements", ListOf(Requirements(*victim.object))},
                     {"severity", Severity(*victim.object)}});
  }
  out += ", \"victim_dict\": " + Json(std::move(victims)).Dump();
}

}  // namespace ccmorse::sim
