#include "servers/record/recorder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "base/log.h"
#include "base/nearest_name.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "sim/sensors/laser_scanner.h"
#include "sim/sensors/pose.h"

namespace ccmorse::servers {
namespace {

// Foxglove's well-known messages, written as JSON.

Json TimeJson(std::uint64_t ns) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  return Json(Json::Object{{"sec", static_cast<std::int64_t>(ns / kSecond)},
                           {"nsec", static_cast<std::int64_t>(ns % kSecond)}});
}

Json VectorJson(Vec3 v) { return Json(Json::Object{{"x", v.x}, {"y", v.y}, {"z", v.z}}); }

// MORSE's Euler angles, rad: about x, then y, then z.
Json RotationJson(double roll, double pitch, double yaw) {
  const auto [sr, cr] = SinCos(roll / 2.0);
  const auto [sp, cp] = SinCos(pitch / 2.0);
  const auto [sy, cy] = SinCos(yaw / 2.0);
  return Json(Json::Object{{"x", sr * cp * cy - cr * sp * sy},
                           {"y", cr * sp * cy + sr * cp * sy},
                           {"z", cr * cp * sy - sr * sp * cy},
                           {"w", cr * cp * cy + sr * sp * sy}});
}

Json PoseJson(Vec3 position, double yaw) {
  return Json(Json::Object{{"position", VectorJson(position)},
                           {"orientation", RotationJson(0.0, 0.0, yaw)}});
}

Json CubeJson(Vec3 centre, double yaw, Vec3 size, Color color) {
  return Json(Json::Object{
      {"pose", PoseJson(centre, yaw)},
      {"size", VectorJson(size)},
      {"color",
       Json::Object{
           {"r", color.r / 255.0}, {"g", color.g / 255.0}, {"b", color.b / 255.0}, {"a", 1.0}}}});
}

Json EntityJson(const std::string& frame, const std::string& id, Json::Array cubes) {
  const Json none(Json::Array{});
  return Json(Json::Object{{"timestamp", TimeJson(0)},
                           {"frame_id", frame},
                           {"id", id},
                           {"lifetime", TimeJson(0)},  // for ever
                           {"frame_locked", true},
                           {"metadata", none},
                           {"arrows", none},
                           {"cubes", std::move(cubes)},
                           {"spheres", none},
                           {"cylinders", none},
                           {"lines", none},
                           {"triangles", none},
                           {"texts", none},
                           {"models", none}});
}

constexpr const char* kWorldFrame = "world";

void WriteData(std::string& out, sim::Sensor& sensor, std::uint64_t) { out = sensor.LocalData(); }

void WritePose(std::string& out, sim::Sensor& sensor, std::uint64_t log_time) {
  // What the sensor says, which need not be where the robot is.
  const Json data = Json::Parse(sensor.LocalData());
  const auto number = [&data](const char* key) { return data.Find(key)->AsDouble(); };
  out = Json(Json::Object{
                 {"timestamp", TimeJson(log_time)},
                 {"frame_id", kWorldFrame},
                 {"pose",
                  Json::Object{{"position", VectorJson({number("x"), number("y"), number("z")})},
                               {"orientation",
                                RotationJson(number("roll"), number("pitch"), number("yaw"))}}}})
            .Dump();
}

void WriteScan(std::string& out, sim::Sensor& sensor, std::uint64_t log_time) {
  const auto& scanner = dynamic_cast<const sim::LaserScanner&>(sensor);
  const scene::LaserDef& def = sensor.robot().def().laser;
  const double first = -Radians(def.scan_window_deg) / 2.0;
  const std::vector<double>& ranges = scanner.ranges();
  const double last = first + static_cast<double>(ranges.size() - 1) * Radians(def.resolution_deg);
  out = "{\"timestamp\": ";
  out += TimeJson(log_time).Dump();
  out += ", \"frame_id\": ";
  AppendJson(out, std::string_view(sensor.robot().name()));
  out += ", \"pose\": ";
  out += PoseJson(sensor.mount(), def.yaw).Dump();
  out += ", \"start_angle\": ";
  AppendJson(out, first);
  out += ", \"end_angle\": ";
  AppendJson(out, last);
  out += ", \"ranges\": [";
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, ranges[i]);
  }
  out += "], \"intensities\": []}";
}

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

// What --record-data names.
struct DataChoice {
  bool poses = false;
  std::vector<sim::Sensor*> sensors;  // one may come twice
};

DataChoice ChooseData(const sim::Simulation& simulation, const std::string& text) {
  DataChoice choice;
  if (text == "none") return choice;
  std::vector<std::string> known = {"none", "poses", "all"};
  std::vector<sim::Sensor*> sensors;
  for (sim::Component* component : simulation.components()) {
    auto* const sensor = dynamic_cast<sim::Sensor*>(component);
    if (sensor == nullptr) continue;
    sensors.push_back(sensor);
    known.push_back(sensor->full_name());
    known.push_back(sensor->name());
  }
  for (const std::string& word : SplitAtCommas(text)) {
    bool found = word == "poses" || word == "all";
    choice.poses = choice.poses || found;
    for (sim::Sensor* sensor : sensors) {
      if (word != "all" && word != sensor->full_name() && word != sensor->name()) continue;
      choice.sensors.push_back(sensor);
      found = true;
    }
    if (!found) {
      throw Error("'" + word + "' is no sensor whose data could be recorded" +
                  DidYouMean(word, known) + "; there are also 'poses', 'all' and 'none'");
    }
  }
  return choice;
}

// The scenario without the places of its components' own code: equal runs give equal bytes wherever
// they are.
scene::Scenario WithoutPlaces(scene::Scenario scenario) {
  for (scene::RobotDef& robot : scenario.robots) {
    if (!robot.components) continue;
    for (scene::ComponentDef& component : *robot.components) {
      for (scene::OverlayDef& overlay : component.overlays) overlay.path.clear();
      if (!component.own) continue;
      component.own->path.clear();
      if (component.own->language != "c++") continue;
      component.own->code = std::filesystem::path(component.own->code).filename().string();
    }
  }
  return scenario;
}

const char* KindWord(Input::Kind kind) {
  switch (kind) {
    case Input::Kind::kService:
      return "service";
    case Input::Kind::kBytes:
      return "bytes";
    case Input::Kind::kStream:
      return "stream";
    case Input::Kind::kOwn:
      return "own";
    case Input::Kind::kInterrupt:
      break;
  }
  return "interrupt";
}

}  // namespace

Recorder::Recorder(const sim::Simulation& simulation, std::string file,
                   const RecordOptions& options)
    : simulation_(simulation), file_(std::move(file)), options_(options), hasher_(simulation) {
  const DataChoice choice = ChooseData(simulation, options.data);
  errno = 0;
  stream_.open(file_, std::ios::binary | std::ios::trunc);
  if (!stream_) throw Error("cannot write " + file_ + ": " + std::strerror(errno));
  const scene::TimeDef& time = simulation.scenario().time;
  ticks_per_transform_ = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::llround(time.frequency / time.read_frequency)));
  try {
    writer_ = std::make_unique<wire::McapWriter>(stream_, "ccmorse " CCMORSE_VERSION);
    WriteStart();
    input_ = AddTopic(kInputTopic, kInputSchema);
    hash_ = AddTopic(kHashTopic, kHashSchema);
    if (choice.poses) {
      transforms_ = AddTopic(kTransformTopic, kTransformsSchema);
      WriteScene();
    }
    for (sim::Sensor* sensor : choice.sensors) AddSensor(*sensor);
    end_ = AddTopic(kEndTopic, kEndSchema);
    // Whatever happens to the run, there is something to replay.
    writer_->EndChunk();
  } catch (const Error& error) {
    throw Error("cannot write " + file_ + ": " + error.what());
  }
}

// A record that cannot go on must not end the run.
template <typename Action>
void Recorder::Try(Action action) {
  if (!failure_.empty()) return;
  try {
    action();
  } catch (const Error& error) {
    failure_ = fmt::format("the record {} breaks off at {:.3f} s: {}", file_, simulation_.time(),
                           error.what());
    LogError("{}", failure_);
  }
}

Recorder::~Recorder() {
  if (!ended_) Try([this] { writer_->EndChunk(); });
}

std::uint16_t Recorder::AddTopic(std::string_view topic, std::string_view schema) {
  auto known = schemas_.find(schema);
  if (known == schemas_.end()) {
    const std::uint16_t id = writer_->AddSchema(schema, "jsonschema", SchemaText(schema));
    known = schemas_.emplace(schema, id).first;
  }
  return writer_->AddChannel(known->second, topic, "json");
}

void Recorder::WriteStart() {
  Json start(
      Json::Object{{"format", kRecordFormat},
                   {"ccmorse", CCMORSE_VERSION},
                   {"name", simulation_.scenario().name},
                   {"hash_every", static_cast<std::int64_t>(options_.hash_every.value_or(1))},
                   {"scenario", scene::ToJson(WithoutPlaces(simulation_.scenario()))}});
  if (options_.contest) start.Set("contest", true);
  writer_->Write(AddTopic(kStartTopic, kStartSchema), 0, start.Dump());
}

void Recorder::AddSensor(sim::Sensor& sensor) {
  if (sensors_.contains(&sensor)) return;
  std::string topic = "/" + sensor.full_name();
  std::replace(topic.begin(), topic.end(), '.', '/');
  std::string_view schema = kDataSchema;
  SensorTopic entry{0, WriteData};
  if (dynamic_cast<const sim::LaserScanner*>(&sensor) != nullptr) {
    schema = kLaserScanSchema;
    entry.write = WriteScan;
  } else if (dynamic_cast<const sim::PoseSensor*>(&sensor) != nullptr) {
    schema = kPoseSchema;
    entry.write = WritePose;
  }
  entry.channel = AddTopic(topic, schema);
  sensors_.emplace(&sensor, entry);
}

void Recorder::WriteScene() {
  const scene::World& world = simulation_.world().scene();
  Json::Array cubes;
  constexpr double kThin = 0.001;  // m
  if (world.has_floor) {
    cubes.push_back(
        CubeJson({world.low.x + world.size_x / 2.0, world.low.y + world.size_y / 2.0, -kThin / 2.0},
                 0.0, {world.size_x, world.size_y, kThin}, world.floor));
  }
  for (const scene::Box& box : world.boxes) {
    if (!box.raised) continue;
    cubes.push_back(CubeJson({box.pose.x, box.pose.y, box.height / 2.0}, box.pose.yaw,
                             {box.size_x, box.size_y, box.height}, box.color));
  }
  Json::Array entities;
  entities.push_back(EntityJson(kWorldFrame, "world", std::move(cubes)));
  for (const auto& robot : simulation_.robots()) {
    const scene::RobotModel& model = robot->model();
    const Vec3 centre{0.0, 0.0, model.height / 2.0 - model.origin_height};
    entities.push_back(EntityJson(
        robot->name(), robot->name(),
        {CubeJson(centre, 0.0, {model.length, model.width, model.height}, robot->def().color)}));
  }
  const Json update(Json::Object{{"deletions", Json::Array{}}, {"entities", std::move(entities)}});
  writer_->Write(AddTopic(kSceneTopic, kSceneSchema), 0, update.Dump());
}

std::uint64_t Recorder::Now() const {
  return LogTime(simulation_.tick(), simulation_.scenario().time.frequency);
}

void Recorder::WriteTransforms() {
  Json::Array transforms;
  for (const auto& robot : simulation_.robots()) {
    const Vec3 euler = robot->euler();
    transforms.push_back(Json::Object{{"timestamp", TimeJson(Now())},
                                      {"parent_frame_id", kWorldFrame},
                                      {"child_frame_id", robot->name()},
                                      {"translation", VectorJson(robot->position())},
                                      {"rotation", RotationJson(euler.x, euler.y, euler.z)}});
  }
  writer_->Write(transforms_, Now(),
                 Json(Json::Object{{"transforms", std::move(transforms)}}).Dump());
}

void Recorder::Sensed() {
  Try([this] {
    if (transforms_ != 0 && simulation_.tick() % ticks_per_transform_ == 0) WriteTransforms();
    if (sensors_.empty()) return;
    for (sim::Sensor* sensor : simulation_.sampled()) {
      const auto topic = sensors_.find(sensor);
      if (topic == sensors_.end()) continue;
      topic->second.write(text_, *sensor, Now());
      writer_->Write(topic->second.channel, Now(), text_);
    }
  });
}

void Recorder::Incoming(const Input& input) {
  Try([this, &input] {
    if (input_tick_ != simulation_.tick()) input_order_ = 0;
    input_tick_ = simulation_.tick();
    text_ = "{\"tick\": ";
    AppendJson(text_, static_cast<std::int64_t>(input_tick_));
    text_ += ", \"order\": ";
    AppendJson(text_, input_order_++);
    text_ += ", \"kind\": ";
    AppendJson(text_, std::string_view(KindWord(input.kind)));
    text_ += ", \"component\": ";
    AppendJson(text_, input.component);
    if (input.kind == Input::Kind::kService || input.kind == Input::Kind::kBytes) {
      text_ += ", \"service\": ";
      AppendJson(text_, input.service);
    }
    if (input.kind != Input::Kind::kInterrupt) {
      text_ += ", \"arguments\": ";
      AppendJson(text_, std::string_view(input.arguments));
    }
    text_ += '}';
    writer_->Write(input_, Now(), text_);
  });
}

void Recorder::Acted() {
  const std::uint64_t tick = simulation_.tick();
  if (tick % options_.hash_every.value_or(1) != 0) return;
  Try([this, tick] {
    text_ = "{\"tick\": ";
    AppendJson(text_, static_cast<std::int64_t>(tick));
    if (options_.hash_every) {
      text_ += ", \"hash\": ";
      AppendJson(text_, std::string_view(HashText(simulation_.Hash())));
    }
    text_ += ", \"components\": {";
    bool first = true;
    for (const ComponentHash& hash : hasher_.Take()) {
      if (!first) text_ += ", ";
      first = false;
      AppendJson(text_, std::string_view(hash.name));
      text_ += ": ";
      AppendJson(text_, std::string_view(HashText(hash.value)));
    }
    text_ += "}}";
    writer_->Write(hash_, Now(), text_);
  });
}

void Recorder::Ended(bool sensed) {
  Try([this, sensed] {
    const Json end(Json::Object{{"tick", static_cast<std::int64_t>(simulation_.tick())},
                                {"sensed", sensed},
                                {"hash", HashText(simulation_.Hash())}});
    writer_->Write(end_, Now(), end.Dump());
    writer_->Finish();
    ended_ = true;
    stream_.close();
    if (!stream_) throw Error(std::strerror(errno));
  });
}

}  // namespace ccmorse::servers
