#include "base/json.h"
#include "libCCMorse/MorseArena.h"

namespace CCMorse {
namespace {

using ccmorse::Json;

Json ListOf(const std::vector<int>& ids) {
  Json::Array list;
  for (const int id : ids) list.emplace_back(id);
  return Json(std::move(list));
}

std::vector<int> IdsOf(const MorseValue& list) {
  std::vector<int> ids;
  for (const double id : list.GetDoubles("")) ids.push_back(static_cast<int>(id));
  return ids;
}

void AddAction(const MorseObstacleAction& action, Json& rule) {
  if (!action.preset.empty()) rule.Set("preset", Json(action.preset));
  if (!action.up.empty()) rule.Set("up", ListOf(action.up));
  if (!action.down.empty()) rule.Set("down", ListOf(action.down));
  if (!action.toggle.empty()) rule.Set("toggle", ListOf(action.toggle));
  if (!action.say.empty()) rule.Set("say", Json(action.say));
}

}  // namespace

MorseArena::MorseArena(MorseClient& client) : client_(client.shared_from_this()) {}

std::vector<MorseObstacle> MorseArena::GetObstacles() const {
  const MorseValue list = client_->Request("arena", "list");
  std::vector<MorseObstacle> obstacles;
  for (std::size_t i = 0; i < list.GetSize(); ++i) {
    const MorseValue item = list.At(i);
    MorseObstacle obstacle;
    obstacle.id = item.GetInt("id");
    obstacle.kind = item.GetString("kind");
    obstacle.pose.px = item.GetDouble("x");
    obstacle.pose.py = item.GetDouble("y");
    obstacle.pose.pa = item.GetDouble("yaw");
    obstacle.size_x = item.GetDouble("size_x");
    obstacle.size_y = item.GetDouble("size_y");
    obstacle.height = item.GetDouble("height");
    obstacle.raised = item.GetBool("raised");
    obstacle.waiting = item.GetBool("waiting");
    obstacles.push_back(obstacle);
  }
  return obstacles;
}

bool MorseArena::IsRaised(int id) const {
  for (const MorseObstacle& obstacle : GetObstacles()) {
    if (obstacle.id == id) return obstacle.raised;
  }
  throw MorseError("there is no dynamic obstacle " + std::to_string(id), "MorseArena::IsRaised()");
}

std::vector<int> MorseArena::Change(const char* service, const std::vector<int>& ids) {
  MorseArgs list;
  for (const int id : ids) list.Add(id);
  return IdsOf(client_->Request("arena", service, MorseArgs().Add(list)));
}

std::vector<int> MorseArena::Raise(const std::vector<int>& ids) { return Change("raise", ids); }
std::vector<int> MorseArena::Lower(const std::vector<int>& ids) { return Change("lower", ids); }
std::vector<int> MorseArena::Toggle(const std::vector<int>& ids) { return Change("toggle", ids); }

void MorseArena::Move(int id, const player_pose2d_t& pose) {
  client_->Request("arena", "move", MorseArgs(id, pose.px, pose.py, pose.pa));
}

std::map<std::string, std::vector<int>> MorseArena::GetPresets() const {
  const MorseValue answer = client_->Request("arena", "get_presets");
  std::map<std::string, std::vector<int>> presets;
  for (const std::string& name : answer.GetKeys()) presets[name] = IdsOf(answer.Member(name));
  return presets;
}

std::vector<int> MorseArena::LoadPreset(const std::string& name) {
  return IdsOf(client_->Request("arena", "load_preset", MorseArgs(name)));
}

std::vector<int> MorseArena::SavePreset(const std::string& name) {
  return IdsOf(client_->Request("arena", "save_preset", MorseArgs(name)));
}

void MorseArena::AddTimer(double at, const MorseObstacleAction& action, double every) {
  Json rule(Json::Object{{"at", at}});
  if (every != 0.0) rule.Set("every", Json(every));
  AddAction(action, rule);
  client_->Request("arena", "add_timer", MorseArgs().Add(MorseValue::Parse(rule.Dump())));
}

void MorseArena::AddTrap(const std::string& name, const std::vector<player_point_2d_t>& corners,
                         const MorseObstacleAction& action, const std::string& robot, bool once) {
  Json::Array region;
  for (const player_point_2d_t& corner : corners) {
    region.emplace_back(Json::Array{corner.px, corner.py});
  }
  Json rule(Json::Object{{"name", name}, {"region", std::move(region)}, {"once", once}});
  if (!robot.empty()) rule.Set("robot", Json(robot));
  AddAction(action, rule);
  client_->Request("arena", "add_trap", MorseArgs().Add(MorseValue::Parse(rule.Dump())));
}

}  // namespace CCMorse
