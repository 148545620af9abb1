#include "servers/record/record_format.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

#include "base/json.h"

namespace ccmorse::servers {
namespace {

using Fields = std::initializer_list<std::pair<const char*, Json>>;

Json Type(const char* name) { return Json(Json::Object{{"type", name}}); }

Json List(Json items) { return Json(Json::Object{{"type", "array"}, {"items", std::move(items)}}); }

Json Object(std::string_view title, Fields fields) {
  Json::Object properties;
  for (const auto& [name, schema] : fields) properties.emplace_back(name, schema);
  return Json(
      Json::Object{{"title", title}, {"type", "object"}, {"properties", std::move(properties)}});
}

std::map<std::string, std::string, std::less<>> MakeSchemas() {
  const Json number = Type("number");
  const Json integer = Type("integer");
  const Json text = Type("string");
  const Json truth = Type("boolean");
  const Json unused = List(Type("object"));
  const Json time = Object("time", {{"sec", integer}, {"nsec", integer}});
  const Json duration = Object("duration", {{"sec", integer}, {"nsec", integer}});
  const Json vector = Object("foxglove.Vector3", {{"x", number}, {"y", number}, {"z", number}});
  const Json rotation =
      Object("foxglove.Quaternion", {{"x", number}, {"y", number}, {"z", number}, {"w", number}});
  const Json color =
      Object("foxglove.Color", {{"r", number}, {"g", number}, {"b", number}, {"a", number}});
  const Json pose = Object("foxglove.Pose", {{"position", vector}, {"orientation", rotation}});
  const Json transform = Object("foxglove.FrameTransform", {{"timestamp", time},
                                                            {"parent_frame_id", text},
                                                            {"child_frame_id", text},
                                                            {"translation", vector},
                                                            {"rotation", rotation}});
  const Json cube =
      Object("foxglove.CubePrimitive", {{"pose", pose}, {"size", vector}, {"color", color}});
  const Json entity = Object("foxglove.SceneEntity", {{"timestamp", time},
                                                      {"frame_id", text},
                                                      {"id", text},
                                                      {"lifetime", duration},
                                                      {"frame_locked", truth},
                                                      {"metadata", unused},
                                                      {"arrows", unused},
                                                      {"cubes", List(cube)},
                                                      {"spheres", unused},
                                                      {"cylinders", unused},
                                                      {"lines", unused},
                                                      {"triangles", unused},
                                                      {"texts", unused},
                                                      {"models", unused}});
  const Json schemas[] = {
      Object(kStartSchema, {{"format", integer},
                            {"ccmorse", text},
                            {"name", text},
                            {"hash_every", integer},
                            {"contest", truth},
                            {"scenario", Type("object")}}),
      Object(kInputSchema, {{"tick", integer},
                            {"order", integer},
                            {"kind", text},
                            {"component", text},
                            {"service", text},
                            {"arguments", text}}),
      Object(kHashSchema, {{"tick", integer}, {"hash", text}, {"components", Type("object")}}),
      Object(kEndSchema, {{"tick", integer}, {"sensed", truth}, {"hash", text}}),
      Object(kDataSchema, {{"timestamp", number}}),
      Object(kLaserScanSchema, {{"timestamp", time},
                                {"frame_id", text},
                                {"pose", pose},
                                {"start_angle", number},
                                {"end_angle", number},
                                {"ranges", List(number)},
                                {"intensities", List(number)}}),
      Object(kPoseSchema, {{"timestamp", time}, {"frame_id", text}, {"pose", pose}}),
      Object(kTransformsSchema, {{"transforms", List(transform)}}),
      Object(kSceneSchema, {{"deletions", unused}, {"entities", List(entity)}})};
  std::map<std::string, std::string, std::less<>> texts;
  for (const Json& schema : schemas) texts[schema.Find("title")->AsString()] = schema.Dump();
  return texts;
}

}  // namespace

std::string SchemaText(std::string_view name) {
  static const std::map<std::string, std::string, std::less<>> schemas = MakeSchemas();
  return schemas.find(name)->second;
}

std::uint64_t LogTime(std::uint64_t tick, double frequency) {
  return static_cast<std::uint64_t>(std::llround(static_cast<double>(tick) * (1e9 / frequency)));
}

std::uint64_t TickOf(std::uint64_t log_time, double frequency) {
  return static_cast<std::uint64_t>(std::llround(static_cast<double>(log_time) * frequency / 1e9));
}

std::string HashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

bool ParseHash(std::string_view text, std::uint64_t* hash) {
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, *hash, 16);
  return text.size() == 16 && read.ec == std::errc{} && read.ptr == end;
}

}  // namespace ccmorse::servers
