#include "sim/sensors/proximity.h"

#include <cmath>

#include "sim/robots/robot.h"

namespace ccmorse::sim {

Proximity::Proximity(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "Proximity", 12.0), world_(world) {
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
  for (const SceneObject& object : world_.objects().all()) {
    if (object.robot == &robot() || !object.Has(tag_)) continue;
    const Vec3 off = object.WorldPosition() - here;
    const double distance = std::sqrt(Dot(off, off));
    if (distance <= range_) near_.emplace_back(&object.name, distance);
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
