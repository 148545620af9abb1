#include "wire/multinode.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/json.h"

namespace ccmorse::wire {
namespace {

constexpr int kMostNodes = 1000;
constexpr std::string_view kTime = "__time";
constexpr std::string_view kOurs = "__ccmorse";

using Three = std::array<double, 3>;

Json ToJson(const Three& numbers) { return Json(Json::Array(numbers.begin(), numbers.end())); }

Three ReadThree(const Json& json, const char* what) {
  if (!json.IsArray() || json.AsArray().size() != 3) {
    throw Error(fmt::format("{} must be three numbers", what));
  }
  Three numbers{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& number = json.AsArray()[i];
    if (!number.IsNumber() || !std::isfinite(number.AsDouble())) {
      throw Error(fmt::format("{} must be three finite numbers", what));
    }
    numbers[i] = number.AsDouble();
  }
  return numbers;
}

std::uint64_t ReadHash(const Json& json) {
  std::uint64_t hash = 0;
  if (json.IsString()) {
    const std::string& text = json.AsString();
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, hash, 16);
    if (read.ec == std::errc{} && read.ptr == end) return hash;
  }
  throw Error("a robot's hash must be hexadecimal digits");
}

Json SceneToJson(const NodeScene& scene) {
  Json object(Json::Object{});
  Json ours(Json::Object{});
  for (const auto& [name, robot] : scene.robots) {
    object.Set(name, Json::Array{ToJson(robot.position), ToJson(robot.rotation)});
    Json more(Json::Object{});
    if (robot.command) more.Set("command", ToJson(*robot.command));
    if (robot.hash) more.Set("hash", fmt::format("{:016x}", *robot.hash));
    if (!more.IsFalsy()) ours.Set(name, std::move(more));
  }
  object.Set(kTime, ToJson(scene.time));
  if (scene.nodes > 0) {
    object.Set(kOurs, Json::Object{{"nodes", scene.nodes}, {"robots", std::move(ours)}});
  }
  return object;
}

void ReadOurs(const Json& json, NodeScene& scene) {
  const Json* const nodes = json.Find("nodes");
  if (nodes == nullptr || !nodes->IsInt() || nodes->AsInt() < 1 || nodes->AsInt() > kMostNodes) {
    throw Error(fmt::format("nodes must be a number from 1 to {}", kMostNodes));
  }
  scene.nodes = static_cast<int>(nodes->AsInt());
  const Json* const robots = json.Find("robots");
  if (robots == nullptr || !robots->IsObject()) throw Error("robots must be an object");
  for (const auto& [name, more] : robots->AsObject()) {
    const auto robot = scene.robots.find(name);
    if (robot == scene.robots.end()) throw Error("a robot without a place");
    if (const Json* const command = more.Find("command")) {
      robot->second.command = ReadThree(*command, "a command");
    }
    if (const Json* const hash = more.Find("hash")) robot->second.hash = ReadHash(*hash);
  }
}

NodeScene ReadScene(const Json& json) {
  if (!json.IsObject()) throw Error("a scene must be an object");
  NodeScene scene;
  for (const auto& [name, value] : json.AsObject()) {
    if (name == kTime) {
      scene.time = ReadThree(value, "__time");
    } else if (!name.starts_with("__")) {
      if (!value.IsArray() || value.AsArray().size() != 2) {
        throw Error("a robot must be [[x, y, z], [roll, pitch, yaw]]");
      }
      NodeRobot& robot = scene.robots[name];
      robot.position = ReadThree(value.AsArray()[0], "a position");
      robot.rotation = ReadThree(value.AsArray()[1], "a rotation");
    }
  }
  if (const Json* const ours = json.Find(kOurs)) ReadOurs(*ours, scene);
  return scene;
}

}  // namespace

std::string NodeMessageLine(const NodeMessage& message) {
  return Json(Json::Array{message.node, SceneToJson(message.scene)}).Dump() + '\n';
}

NodeMessage ParseNodeMessage(std::string_view line) {
  try {
    const Json json = Json::Parse(line);
    if (!json.IsArray() || json.AsArray().size() != 2 || !json.AsArray()[0].IsString()) {
      throw Error("a message must be [name, scene]");
    }
    return {json.AsArray()[0].AsString(), ReadScene(json.AsArray()[1])};
  } catch (const JsonError& error) {
    throw Error(error.what());
  }
}

std::string NodeAnswerLine(const NodeScene& scene) { return SceneToJson(scene).Dump() + '\n'; }

NodeScene ParseNodeAnswer(std::string_view line) {
  try {
    return ReadScene(Json::Parse(line));
  } catch (const JsonError& error) {
    throw Error(error.what());
  }
}

}  // namespace ccmorse::wire
