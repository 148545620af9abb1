#include "servers/morse/arena_services.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/trig.h"
#include "scene/limits.h"
#include "scene/obstacle_rules.h"

namespace ccmorse::servers {
namespace {

using sim::Arguments;
using sim::Service;
using sim::ServiceFailed;
using sim::WrongArgument;

constexpr std::size_t kMostRules = 256;  // timers, traps or presets

Json Ids(const std::vector<int>& ids) {
  Json::Array list;
  for (const int id : ids) list.emplace_back(id);
  return Json(std::move(list));
}

// One id or a list of them.
std::vector<int> IdsArgument(Arguments arguments) {
  std::vector<int> ids;
  if (!arguments[0].IsArray()) return {sim::IntegerArgument(arguments, 0, "ids", 1, 1000000)};
  const Json::Array& list = arguments[0].AsArray();
  for (std::size_t i = 0; i < list.size(); ++i) {
    ids.push_back(sim::IntegerArgument(list, i, "ids", 1, 1000000));
  }
  return ids;
}

// What the arena or a reader of scenarios complains about is the caller's fault.
template <typename Do>
void Try(const Do& act) {
  try {
    act();
  } catch (const Error& error) {
    throw ServiceFailed(error.what());
  }
}

void CheckRoom(std::size_t size, const char* what) {
  if (size >= kMostRules) {
    throw ServiceFailed("There are " + std::to_string(kMostRules) + " " + what + " already.");
  }
}

Json List(const sim::Simulation& simulation) {
  const std::vector<int>& waiting = simulation.arena().waiting();
  Json::Array boxes;
  for (const scene::Box& box : simulation.world().scene().boxes) {
    if (!box.dynamic) continue;
    boxes.emplace_back(
        Json::Object{{"id", box.id},
                     {"kind", box.kind},
                     {"x", box.pose.x},
                     {"y", box.pose.y},
                     {"yaw", box.pose.yaw},
                     {"size_x", box.size_x},
                     {"size_y", box.size_y},
                     {"height", box.height},
                     {"raised", box.raised},
                     {"waiting", std::binary_search(waiting.begin(), waiting.end(), box.id)}});
  }
  return Json(std::move(boxes));
}

// With higher numbers than `after`; the first that ever happened has 1.
Json Events(const sim::ArenaController& arena, int after) {
  Json::Array events;
  std::uint64_t number = arena.event_count() - arena.events().size();
  for (const auto& [time, cause, what] : arena.events()) {
    if (++number <= static_cast<std::uint64_t>(after)) continue;
    events.emplace_back(Json::Object{{"number", static_cast<std::int64_t>(number)},
                                     {"time", time},
                                     {"cause", cause},
                                     {"what", what}});
  }
  return Json(std::move(events));
}

}  // namespace

std::vector<Service> ArenaServices(sim::Simulation& simulation) {
  sim::ArenaController& arena = simulation.arena();
  std::vector<Service> services;
  const auto add = [&services](const char* name, std::vector<sim::ServiceParameter> parameters,
                               std::function<Json(Arguments)> run) {
    services.push_back({name, std::move(parameters), std::move(run)});
  };
  const auto add_query = [&services](const char* name, std::function<Json(Arguments)> run) {
    services.push_back({name, {}, std::move(run)});
    services.back().changes_simulation = false;
  };
  const auto apply = [&simulation, &arena](const scene::ObstacleAction& action) {
    Try([&] { arena.Apply(action, simulation.time(), "service"); });
    return Ids(arena.waiting());
  };
  using Lists = std::vector<int> scene::ObstacleAction::*;
  const auto add_action = [&](const char* name, Lists list) {
    add(name, {{"ids"}}, [apply, list](Arguments arguments) {
      scene::ObstacleAction action;
      action.*list = IdsArgument(arguments);
      return apply(action);
    });
  };
  add_query("list", [&simulation](Arguments) { return List(simulation); });
  add_action("raise", &scene::ObstacleAction::up);
  add_action("lower", &scene::ObstacleAction::down);
  add_action("toggle", &scene::ObstacleAction::toggle);
  add("move", {{"id"}, {"x"}, {"y"}, {"yaw", true}}, [&simulation, &arena](Arguments arguments) {
    const int id = sim::IntegerArgument(arguments, 0, "id", 1, 1000000);
    const scene::Box* const box = simulation.world().FindBox(id);
    const double yaw = box != nullptr ? box->pose.yaw : 0.0;
    const Pose2 pose{sim::NumberArgument(arguments, 1, "x"), sim::NumberArgument(arguments, 2, "y"),
                     NormalizeAngle(sim::NumberArgument(arguments, 3, "yaw", yaw))};
    if (std::max(std::abs(pose.x), std::abs(pose.y)) > scene::kFarthest) {
      throw WrongArgument("x and y must lie within 1000 m of the origin");
    }
    Try([&] { arena.Move(id, pose, simulation.time()); });
    return Json();
  });
  add_query("get_presets", [&arena](Arguments) {
    Json presets(Json::Object{});
    for (const auto& [name, ids] : arena.presets()) presets.Set(name, Ids(ids));
    return presets;
  });
  add("load_preset", {{"name"}}, [apply](Arguments arguments) {
    scene::ObstacleAction action;
    action.preset = sim::StringArgument(arguments, 0, "name");
    return apply(action);
  });
  add("save_preset", {{"name"}}, [&arena](Arguments arguments) {
    const std::string& name = sim::StringArgument(arguments, 0, "name");
    if (name.empty() || name.size() > 100) throw WrongArgument("name must have 1 to 100 bytes");
    if (!arena.presets().contains(name)) CheckRoom(arena.presets().size(), "presets");
    arena.SavePreset(name);
    return Ids(arena.presets().at(name));
  });
  // What a scenario has in "timers" and "traps".
  const auto add_rule = [&](const char* name, const char* what, auto read, auto size) {
    add(name, {{what}}, [&simulation, &arena, name, what, read, size](Arguments arguments) {
      CheckRoom(size(), name);
      const std::string file = "arena";
      Try([&] {
        arena.Add(read(scene::Field(arguments[0], what, file), simulation.world().scene(),
                       arena.rules()));
      });
      return Json(static_cast<int>(size()));
    });
  };
  add_rule("add_timer", "timer", scene::ReadTimer,
           [&arena] { return arena.rules().timers.size(); });
  add_rule("add_trap", "trap", scene::ReadTrap, [&arena] { return arena.rules().traps.size(); });
  add_query("events", [&arena](Arguments arguments) {
    const int after = arguments.empty() ? 0
                                        : sim::IntegerArgument(arguments, 0, "after", 0,
                                                               std::numeric_limits<int>::max());
    return Events(arena, after);
  });
  services.back().parameters = {{"after", true}};
  return services;
}

}  // namespace ccmorse::servers
