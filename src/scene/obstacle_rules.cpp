#include "scene/obstacle_rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/nearest_name.h"
#include "scene/limits.h"
#include "scene/world_file.h"

namespace ccmorse::scene {
namespace {

constexpr double kLongest = 1e9;  // s
constexpr std::size_t kAreaCorners = 64;

std::string DynamicIds(const World& world) {
  std::string ids;
  for (const Box& box : world.boxes) {
    if (box.dynamic) ids += (ids.empty() ? "" : ", ") + std::to_string(box.id);
  }
  return ids.empty() ? "this world has none" : "dynamic are " + ids;
}

// The id of a dynamic box.
int ReadDynamicId(const Field& item, const World& world) {
  const auto id = static_cast<int>(item.Integer(1, 1000000));
  const auto box = std::find_if(world.boxes.begin(), world.boxes.end(),
                                [id](const Box& candidate) { return candidate.id == id; });
  if (box == world.boxes.end()) {
    item.FailHere(fmt::format("is {}, which is no obstacle of world '{}'; {}", id, world.name,
                              DynamicIds(world)));
  }
  if (!box->dynamic) {
    item.FailHere(fmt::format("is {}, a box of kind '{}', which cannot be moved; {}", id, box->kind,
                              DynamicIds(world)));
  }
  return id;
}

std::vector<int> ReadIds(ObjectReader& reader, const char* key, const World& world) {
  return reader.Has(key) ? ReadDynamicIds(reader.Require(key), world) : std::vector<int>();
}

std::string ReadPresetName(ObjectReader& reader, const ObstacleRules& rules) {
  if (!reader.Has("preset")) return "";
  const Field field = reader.Require("preset");
  if (rules.presets.contains(field.Text())) return field.Text();
  std::vector<std::string> known;
  for (const auto& [name, ids] : rules.presets) known.push_back(name);
  field.FailHere(fmt::format("is {}, which is no preset{}", Quoted(field.Text()),
                             DidYouMean(field.Text(), known)));
}

// A box cannot be told two things at once.
void CheckOnce(const Field& field, const ObstacleAction& action) {
  std::set<int> seen;
  for (const auto* ids : {&action.up, &action.down, &action.toggle}) {
    for (const int id : *ids) {
      if (!seen.insert(id).second) {
        field.FailHere(fmt::format("says {} twice; remove one", id));
      }
    }
  }
}

ObstacleAction ReadAction(ObjectReader& reader, const World& world, const ObstacleRules& rules) {
  ObstacleAction action;
  action.preset = ReadPresetName(reader, rules);
  action.up = ReadIds(reader, "up", world);
  action.down = ReadIds(reader, "down", world);
  action.toggle = ReadIds(reader, "toggle", world);
  if (reader.Has("say")) action.say = reader.Require("say").Text();
  CheckOnce(reader.field(), action);
  if (action.preset.empty() && action.up.empty() && action.down.empty() && action.toggle.empty() &&
      action.say.empty()) {
    reader.field().FailHere("does nothing: give it a preset, up, down, toggle or say");
  }
  return action;
}

// [x_low, y_low, x_high, y_high] or a list of corners [x, y].
std::vector<Vec2> ReadRegion(const Field& field) {
  const Range within{-kFarthest, kFarthest};
  const std::vector<Field> items = field.Items();
  if (items.size() == 4 && items[0].value().IsNumber()) {
    const Vec2 low{items[0].Number(within), items[1].Number(within)};
    const Vec2 high{items[2].Number(within), items[3].Number(within)};
    if (!(low.x < high.x && low.y < high.y)) {
      field.FailHere("must be [x_low, y_low, x_high, y_high], m, low before high");
    }
    return {low, {high.x, low.y}, high, {low.x, high.y}};
  }
  std::vector<Vec2> corners;
  for (const Field& item : items) {
    const std::vector<Field> parts = item.Items();
    if (parts.size() != 2) item.FailHere("must be a corner [x, y], m");
    corners.push_back({parts[0].Number(within), parts[1].Number(within)});
  }
  if (corners.size() < 3 || corners.size() > kAreaCorners) {
    field.FailHere(fmt::format("must be [x_low, y_low, x_high, y_high] or 3 to {} corners [x, y]",
                               kAreaCorners));
  }
  return corners;
}

ObstaclePath ReadPath(const Field& field, const World& world) {
  ObjectReader reader(field);
  ObstaclePath path;
  path.box = ReadDynamicId(reader.Require("box"), world);
  path.repeat = reader.Bool("repeat", false);
  const Field points = reader.Require("points");
  for (const Field& item : points.Items()) {
    // A point is a pose and a time.
    ObjectReader point(item);
    ObstaclePath::Point at;
    at.time = point.Require("at").Number({0.0, kLongest});
    at.pose.x = point.Require("x").Number({-kFarthest, kFarthest});
    at.pose.y = point.Require("y").Number({-kFarthest, kFarthest});
    at.pose.yaw = point.Angle("yaw", 0.0);
    point.Finish();
    if (!path.points.empty() && at.time <= path.points.back().time) {
      item.FailHere("must be later than the point before it");
    }
    path.points.push_back(at);
  }
  if (path.points.size() < 2) points.FailHere("must be two points at least");
  reader.Finish();
  return path;
}

Json IdsToJson(const std::vector<int>& ids) {
  Json::Array list;
  for (const int id : ids) list.emplace_back(id);
  return Json(std::move(list));
}

void AddAction(const ObstacleAction& action, Json& object) {
  if (!action.preset.empty()) object.Set("preset", Json(action.preset));
  if (!action.up.empty()) object.Set("up", IdsToJson(action.up));
  if (!action.down.empty()) object.Set("down", IdsToJson(action.down));
  if (!action.toggle.empty()) object.Set("toggle", IdsToJson(action.toggle));
  if (!action.say.empty()) object.Set("say", Json(action.say));
}

void Raise(const std::vector<int>& ids, bool raised, World& world) {
  for (Box& box : world.boxes) {
    if (std::find(ids.begin(), ids.end(), box.id) != ids.end()) box.raised = raised;
  }
}

}  // namespace

std::vector<int> ReadDynamicIds(const Field& list, const World& world) {
  std::vector<int> ids;
  for (const Field& item : list.Items()) ids.push_back(ReadDynamicId(item, world));
  return ids;
}

ObstacleTimer ReadTimer(const Field& field, const World& world, const ObstacleRules& rules) {
  ObjectReader reader(field);
  ObstacleTimer timer;
  timer.at = reader.Require("at").Number({0.0, kLongest});
  if (reader.Has("every")) timer.every = reader.Require("every").Number({0.0, kLongest, true});
  timer.action = ReadAction(reader, world, rules);
  reader.Finish();
  return timer;
}

ObstacleTrap ReadTrap(const Field& field, const World& world, const ObstacleRules& rules) {
  ObjectReader reader(field);
  ObstacleTrap trap;
  trap.name = reader.Require("name").Text();
  trap.region = ReadRegion(reader.Require("region"));
  if (reader.Has("robot")) trap.robot = reader.Require("robot").Identifier();
  trap.once = reader.Bool("once", false);
  trap.action = ReadAction(reader, world, rules);
  reader.Finish();
  return trap;
}

ObstacleRules ReadObstacles(const Field& field, World& world) {
  ObjectReader reader(field);
  ObstacleRules rules;
  if (reader.Has("presets")) {
    const Field presets = reader.Require("presets");
    if (!presets.value().IsObject()) presets.FailHere("must be an object: name to list of ids");
    for (const auto& [name, ids] : presets.value().AsObject()) {
      rules.presets[name] =
          ReadDynamicIds(Field(ids, presets.path() + "." + name, presets.file()), world);
    }
  }
  const std::string preset = ReadPresetName(reader, rules);
  if (!preset.empty()) {
    for (Box& box : world.boxes) {
      if (box.dynamic) box.raised = false;
    }
    Raise(rules.presets[preset], true, world);
  }
  const std::vector<int> up = ReadIds(reader, "up", world);
  const std::vector<int> down = ReadIds(reader, "down", world);
  for (std::size_t i = 0; i < down.size(); ++i) {
    if (std::find(up.begin(), up.end(), down[i]) == up.end()) continue;
    reader.Require("down").Items()[i].FailHere(
        fmt::format("is {}, which is also in 'up'; remove one", down[i]));
  }
  Raise(up, true, world);
  Raise(down, false, world);
  if (reader.Has("timers")) {
    for (const Field& item : reader.Require("timers").Items()) {
      rules.timers.push_back(ReadTimer(item, world, rules));
    }
  }
  if (reader.Has("traps")) {
    for (const Field& item : reader.Require("traps").Items()) {
      rules.traps.push_back(ReadTrap(item, world, rules));
    }
  }
  if (reader.Has("paths")) {
    for (const Field& item : reader.Require("paths").Items()) {
      rules.paths.push_back(ReadPath(item, world));
    }
  }
  reader.Finish();
  return rules;
}

Json ToJson(const ObstacleTimer& timer) {
  Json object(Json::Object{{"at", timer.at}});
  if (timer.every > 0.0) object.Set("every", Json(timer.every));
  AddAction(timer.action, object);
  return object;
}

Json ToJson(const ObstacleTrap& trap) {
  Json::Array region;
  for (const Vec2& corner : trap.region) region.emplace_back(Json::Array{corner.x, corner.y});
  Json object(Json::Object{{"name", trap.name}, {"region", std::move(region)}});
  if (!trap.robot.empty()) object.Set("robot", Json(trap.robot));
  if (trap.once) object.Set("once", Json(true));
  AddAction(trap.action, object);
  return object;
}

Json ObstaclesToJson(const ObstacleRules& rules, const World& world) {
  std::vector<int> up;
  for (const Box& box : world.boxes) {
    if (box.dynamic && box.raised) up.push_back(box.id);
  }
  Json object(Json::Object{{"up", IdsToJson(up)}});
  if (!rules.presets.empty()) {
    Json presets(Json::Object{});
    for (const auto& [name, ids] : rules.presets) presets.Set(name, IdsToJson(ids));
    object.Set("presets", std::move(presets));
  }
  const auto add = [&object](const char* key, Json::Array list) {
    if (!list.empty()) object.Set(key, Json(std::move(list)));
  };
  Json::Array timers;
  for (const ObstacleTimer& timer : rules.timers) timers.push_back(ToJson(timer));
  add("timers", std::move(timers));
  Json::Array traps;
  for (const ObstacleTrap& trap : rules.traps) traps.push_back(ToJson(trap));
  add("traps", std::move(traps));
  Json::Array paths;
  for (const ObstaclePath& path : rules.paths) {
    Json::Array points;
    for (const ObstaclePath::Point& point : path.points) {
      Json pose = PoseToJson(point.pose);
      pose.Set("at", Json(point.time));
      points.push_back(std::move(pose));
    }
    paths.emplace_back(
        Json::Object{{"box", path.box}, {"repeat", path.repeat}, {"points", std::move(points)}});
  }
  add("paths", std::move(paths));
  return object;
}

}  // namespace ccmorse::scene
