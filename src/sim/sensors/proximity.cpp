#include "sim/sensors/proximity.h"

#include <cmath>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Proximity::Proximity(Robot& robot, const std::string& name, const scene::Scenario& scenario,
                     const World& world)
    : Sensor(robot, name, "Proximity", 12.0), world_(world), props_(scenario.props) {
  AddProperty("Range", range_, 0.0, 1e12);
  AddProperty("Track", tag_);
  AddService({"set_range", {{"range"}}, [this](Arguments arguments) {
                SetProperty("Range", arguments[0]);
                return Json();
              }});
  AddService({"set_tracked_tag", {{"tag"}}, [this](Arguments arguments) {
                SetProperty("Track", arguments[0]);
                return Json();
              }});
}

void Proximity::Sample(const Instant& now) {
  near_.clear();
  const Vec3 here = robot().position();
  const auto add = [&](const std::string& name, const Vec3& there) {
    const double distance = std::sqrt(Dot(there - here, there - here));
    if (distance <= range_) near_.emplace_back(&name, distance);
  };
  for (const Robot* other : world_.robots()) {
    if (other == &robot()) continue;
    if (tag_ == "Robot_Tag" || other->def().properties.Find(tag_) != nullptr) {
      add(other->name(), other->position());
    }
  }
  for (const scene::PropDef& prop : props_) {
    if (prop.properties.Find(tag_) != nullptr) add(prop.name, prop.position);
  }
  DataChanged(now.time);
}

void Proximity::Reset() {
  Sensor::Reset();
  near_.clear();
}

void Proximity::AddToHash(StateHash& hash) const {
  for (const auto& [name, distance] : near_) {
    hash.Add(*name);
    hash.Add(distance);
  }
}

void Proximity::AppendFields(std::string& out) const {
  for (const char* key : {", \"near_objects\": {", ", \"near_robots\": {"}) {
    out += key;
    bool first = true;
    for (const auto& [name, distance] : near_) {
      if (!first) out += ", ";
      first = false;
      AppendJson(out, std::string_view(*name));
      out += ": ";
      AppendJson(out, distance);
    }
    out += '}';
  }
}

}  // namespace ccmorse::sim
