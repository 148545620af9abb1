#include "servers/web/view_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>

#include "base/euler.h"
#include "base/trig.h"
#include "scene/scenario.h"

namespace ccmorse::servers {
namespace {

constexpr std::uint32_t kFrame = 1;  // the kind of message
constexpr double kSteps = 65535.0;   // a range is a part of the sensor's range in 16 bits
// Of a box.
constexpr unsigned kUp = 1;
constexpr unsigned kWaiting = 2;

// Little endian, as the browser's typed arrays are.
class FrameWriter {
 public:
  void Word(std::uint32_t word) { Put(&word, sizeof word); }
  void Single(double value) { Word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void Double(double value) { Put(&value, sizeof value); }
  void Short(std::uint16_t value) { Put(&value, sizeof value); }
  void Byte(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  /// A point, m, and roll, pitch, yaw, rad.
  void Place(const Vec3& at, const Vec3& euler) {
    for (const double value : {at.x, at.y, at.z, euler.x, euler.y, euler.z}) Single(value);
  }
  void Put(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  void Pad() { bytes_.resize((bytes_.size() + 3) / 4 * 4); }
  /// Overwrites the word at `place`.
  void SetWord(std::size_t place, std::uint32_t word) {
    std::memcpy(bytes_.data() + place, &word, sizeof word);
  }
  std::size_t size() const { return bytes_.size(); }
  std::string Take() { return std::move(bytes_); }

 private:
  static_assert(std::endian::native == std::endian::little);
  std::string bytes_;
};

Json Point(const Vec3& p) { return Json(Json::Array{p.x, p.y, p.z}); }

// To a tenth of a millimetre: shapes are most of a scene's text.
Json Near(const Vec3& p) {
  const auto round = [](double v) { return std::round(v * 1e4) / 1e4; };
  return Json(Json::Array{round(p.x), round(p.y), round(p.z)});
}

Json Hex(const Color& color) {
  return Json(static_cast<int>(color.r) << 16 | static_cast<int>(color.g) << 8 |
              static_cast<int>(color.b));
}

Json Outline(const std::vector<Vec2>& outline) {
  Json::Array points;
  for (const Vec2& point : outline) points.push_back(Json::Array{point.x, point.y});
  return Json(std::move(points));
}

Json MeshScene(const scene::Mesh& mesh) {
  Json::Array vertices;
  for (const Vec3& vertex : mesh.vertices) vertices.push_back(Near(vertex));
  Json::Array triangles;
  for (const auto& t : mesh.triangles) triangles.push_back(Json::Array{t[0], t[1], t[2]});
  Json::Array palette;
  for (const Color& color : mesh.palette) palette.push_back(Hex(color));
  return Json(Json::Object{{"id", mesh.id},
                           {"position", Point(mesh.position)},
                           {"rotation", Point(mesh.rotation)},
                           {"color", Hex(mesh.color)},
                           {"palette", std::move(palette)},
                           {"color_of", Json::Array(mesh.color_of.begin(), mesh.color_of.end())},
                           {"vertices", std::move(vertices)},
                           {"triangles", std::move(triangles)}});
}

bool SamePoint(const Vec3& p, const Vec3& q) { return p.x == q.x && p.y == q.y && p.z == q.z; }

// Robots alike share the text of their shape.
bool SameShape(const std::vector<scene::Mesh>& a, const std::vector<scene::Mesh>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::equal(a[i].vertices.begin(), a[i].vertices.end(), b[i].vertices.begin(),
                    b[i].vertices.end(), SamePoint) ||
        a[i].triangles != b[i].triangles || !(a[i].color == b[i].color) ||
        a[i].palette != b[i].palette || a[i].color_of != b[i].color_of ||
        !SamePoint(a[i].position, b[i].position) || !SamePoint(a[i].rotation, b[i].rotation)) {
      return false;
    }
  }
  return true;
}

// Above the floor, where the robot stands level on it.
Vec3 AboveFloor(const sim::Sensor& sensor, const Vec3& mount) {
  return {mount.x, mount.y, mount.z + sensor.robot().model().origin_height};
}

// What the page has to know of any sensor that something carries, maybe, as the run began.
Json SightScene(const sim::Sensor& sensor) {
  // Only what is carried moves; a scanner knows its own place otherwise.
  const sim::Mount mount = sensor.is_carried()
                               ? sensor.RestMount()
                               : sim::Mount{sensor.mount(), sensor.mount_rotation()};
  return Json(Json::Object{{"robot", sensor.robot().index()},
                           {"name", sensor.full_name()},
                           {"position", Point(AboveFloor(sensor, mount.position))},
                           {"rotation", Point(ToEuler(mount.rotation))}});
}

bool AtRest(const sim::Sensor& sensor) {
  const sim::Mount rest = sensor.RestMount();
  const Vec3 at = sensor.mount();
  const Rotation turned = sensor.mount_rotation();
  return SamePoint(at, rest.position) && SamePoint(turned.x, rest.rotation.x) &&
         SamePoint(turned.y, rest.rotation.y) && SamePoint(turned.z, rest.rotation.z);
}

void AppendRanges(FrameWriter& out, const std::vector<double>& ranges, double most) {
  out.Word(static_cast<std::uint32_t>(ranges.size()));
  for (const double range : ranges) {
    out.Short(static_cast<std::uint16_t>(std::lround(std::clamp(range / most, 0.0, 1.0) * kSteps)));
  }
  out.Pad();
}

}  // namespace

ViewModel::ViewModel(const sim::Simulation& simulation) : simulation_(simulation) {
  for (const auto& robot : simulation.robots()) {
    for (const auto& component : robot->components()) {
      if (const auto* laser = dynamic_cast<const sim::LaserScanner*>(component.get())) {
        lasers_.push_back(laser);
      } else if (const auto* ring = dynamic_cast<const sim::RangeRing*>(component.get())) {
        rings_.push_back(ring);
      } else if (const auto* camera = dynamic_cast<const sim::SemanticCamera*>(component.get())) {
        cameras_.push_back(camera);
      } else if (const auto* radar = dynamic_cast<const sim::SearchAndRescue*>(component.get())) {
        radars_.push_back(radar);
      }
    }
  }
  const auto carry = [this](std::size_t place, const sim::Sensor* sensor) {
    if (sensor->is_carried()) carried_.emplace_back(place, sensor);
  };
  for (std::size_t i = 0; i < cameras_.size(); ++i) carry(i, cameras_[i]);
  for (std::size_t i = 0; i < radars_.size(); ++i) carry(cameras_.size() + i, radars_[i]);
  const std::size_t sights = cameras_.size() + radars_.size();
  for (std::size_t i = 0; i < lasers_.size(); ++i) carry(sights + i, lasers_[i]);
  const auto drawn = [&meshes = simulation.scenario().world.meshes](int id) {
    return std::any_of(meshes.begin(), meshes.end(),
                       [id](const scene::Mesh& mesh) { return mesh.id == id && mesh.drawn; });
  };
  const std::span<const sim::SceneObject> objects = simulation.world().objects().all();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::vector<int>& parts = objects[i].start.meshes;
    if (std::any_of(parts.begin(), parts.end(), drawn)) things_.push_back(i);
  }
  const auto& boxes = simulation.scenario().world.boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].dynamic) dynamic_.push_back(i);
  }
}

std::string ViewModel::Scene(const Json& more) const {
  const scene::Scenario& scenario = simulation_.scenario();
  // As the run began: what has changed since comes with each frame.
  const scene::World& world = scenario.world;
  Json::Array boxes;
  for (const scene::Box& box : world.boxes) {
    boxes.push_back(Json::Object{{"id", box.id},
                                 {"kind", box.kind},
                                 {"x", box.pose.x},
                                 {"y", box.pose.y},
                                 {"yaw", box.pose.yaw},
                                 {"size_x", box.size_x},
                                 {"size_y", box.size_y},
                                 {"height", box.height},
                                 {"color", Hex(box.color)},
                                 {"dynamic", box.dynamic}});
  }
  Json::Array meshes;
  for (const scene::Mesh& mesh : world.meshes) {
    if (mesh.drawn) meshes.push_back(MeshScene(mesh));
  }
  Json::Array lights;
  for (const scene::Light& light : world.lights) {
    lights.push_back(Json::Object{{"kind", light.kind},
                                  {"position", Point(light.position)},
                                  {"energy", light.energy},
                                  {"shadows", light.shadows}});
  }
  Json::Array robots;
  Json::Array shapes;
  std::vector<const std::vector<scene::Mesh>*> known;
  for (const auto& robot : simulation_.robots()) {
    Json one = RobotScene(*robot);
    if (robot->def().body && !robot->def().body->shape.empty()) {
      const std::vector<scene::Mesh>& shape = robot->def().body->shape;
      const auto same = std::find_if(known.begin(), known.end(), [&shape](const auto* other) {
        return SameShape(*other, shape);
      });
      one.Set("shape", Json(static_cast<int>(same - known.begin())));
      if (same == known.end()) {
        known.push_back(&shape);
        Json::Array meshes_of;
        for (const scene::Mesh& mesh : shape) meshes_of.push_back(MeshScene(mesh));
        shapes.emplace_back(std::move(meshes_of));
      }
    }
    robots.push_back(std::move(one));
  }
  Json::Array lasers;
  for (const sim::LaserScanner* laser : lasers_) {
    const sim::BeamFan& fan = laser->fan();
    const Vec3 first = fan.Direction(0);
    const Vec3 last = fan.Direction(fan.count() - 1);
    Json one = SightScene(*laser);
    one.Set("flat", first.z == 0.0 && last.z == 0.0);  // of layers one or the other is not
    one.Set("first", std::atan2(first.y, first.x));
    one.Set("last", std::atan2(last.y, last.x));
    one.Set("samples", static_cast<int>(fan.count()));
    one.Set("range", fan.range());
    lasers.push_back(std::move(one));
  }
  Json::Array rings;
  for (const sim::RangeRing* ring : rings_) {
    Json::Array poses;
    const double origin = ring->robot().model().origin_height;
    for (const scene::RingMount& mount : ring->mounts()) {
      const Vec3& at = mount.position;
      poses.push_back(Json::Array{at.x, at.y, origin + at.z, mount.yaw});
    }
    rings.push_back(Json::Object{{"robot", ring->robot().index()},
                                 {"name", ring->full_name()},
                                 {"range", ring->range()},
                                 {"cone", ring->cone()},
                                 {"poses", std::move(poses)}});
  }
  const scene::CanvasDef& canvas = scenario.canvas;
  Json whole(Json::Object{{"scene", scenario.name},
                          {"world", world.name},
                          {"size_x", world.size_x},
                          {"size_y", world.size_y},
                          {"low", Json::Array{world.low.x, world.low.y}},
                          {"floor", world.has_floor ? Json(Hex(world.floor)) : Json()},
                          {"boxes", std::move(boxes)},
                          {"meshes", std::move(meshes)},
                          {"things", ThingsScene()},
                          {"lights", std::move(lights)},
                          {"robots", std::move(robots)},
                          {"shapes", std::move(shapes)},
                          {"lasers", std::move(lasers)},
                          {"rings", std::move(rings)},
                          {"frusta", FrustaScene()},
                          {"radars", RadarsScene()},
                          {"camera", Json::Object{{"position", Point(scenario.camera.position)},
                                                  {"rotation", Point(scenario.camera.rotation)}}},
                          {"canvas", Json::Object{{"alpha", canvas.alpha},
                                                  {"mode", canvas.mode},
                                                  {"mode_switching", canvas.mode_switching}}}});
  for (const auto& [key, value] : more.AsObject()) whole.Set(key, value);
  return whole.Dump();
}

Json ViewModel::FrustaScene() const {
  Json::Array frusta;
  for (const sim::SemanticCamera* camera : cameras_) {
    Json one = SightScene(*camera);
    one.Set("near", camera->near());
    one.Set("far", camera->far());
    one.Set("half_width", camera->half_width());
    one.Set("half_height", camera->half_height());
    frusta.push_back(std::move(one));
  }
  return Json(std::move(frusta));
}

Json ViewModel::RadarsScene() const {
  Json::Array radars;
  for (const sim::SearchAndRescue* radar : radars_) {
    Json one = SightScene(*radar);
    one.Set("angle", Radians(radar->angle()));
    one.Set("range", radar->distance());
    radars.push_back(std::move(one));
  }
  return Json(std::move(radars));
}

Json ViewModel::ThingsScene() const {
  Json::Array things;
  for (const std::size_t i : things_) {
    const scene::PropDef& start = simulation_.world().objects().all()[i].start;
    things.push_back(
        Json::Object{{"name", start.name},
                     {"position", Point(start.position)},
                     {"rotation", Point(start.rotation)},
                     {"meshes", Json::Array(start.meshes.begin(), start.meshes.end())}});
  }
  return Json(std::move(things));
}

Json ViewModel::RobotScene(const sim::Robot& robot) const {
  const scene::RobotModel& model = robot.model();
  Json::Array hull;
  for (const scene::HullPart& part : model.hull) {
    hull.push_back(Json::Object{
        {"outline", Outline(part.outline)}, {"bottom", part.bottom}, {"top", part.top}});
  }
  const Pose2& start = robot.def().pose;
  Json::Array devices;
  for (const auto& component : robot.components()) {
    devices.push_back(Json::Object{{"name", component->full_name()}, {"type", component->type()}});
  }
  return Json(Json::Object{{"name", robot.name()},
                           {"type", robot.def().type},
                           {"color", Hex(robot.def().color)},
                           {"hull", std::move(hull)},
                           {"length", model.length},
                           {"width", model.width},
                           {"height", model.height},
                           {"origin", model.origin_height},
                           {"shape", -1},
                           {"clearance", model.ground_clearance},
                           {"wheel_radius", model.wheel_radius},
                           {"wheel_width", model.wheel_width},
                           {"wheel_track", model.wheel_track},
                           {"max_speed", model.max_speed},
                           {"max_turn_rate", model.max_turn_rate},
                           {"start", Json::Array{start.x, start.y, start.yaw}},
                           {"devices", std::move(devices)}});
}

std::string ViewModel::Frame(Seen& seen, double rate, const TimeState& time) {
  StampCanvas();
  seen.samples.resize(lasers_.size() + rings_.size(), 0);
  FrameWriter out;
  out.Word(kFrame);
  out.Word(time.paused ? 1 : 0);
  out.Double(simulation_.time());
  out.Double(time.speed);
  out.Single(rate);
  out.Word(static_cast<std::uint32_t>(simulation_.robots().size()));
  for (const auto& robot : simulation_.robots()) {
    out.Single(robot->pose().x);
    out.Single(robot->pose().y);
    out.Single(robot->pose().yaw);
    out.Single(robot->twist().v);
    out.Single(robot->twist().w);
    out.Word(robot->stalled() ? 1 : 0);
    out.Single(robot->lift());
    const Vec3 euler = robot->euler();
    out.Single(euler.x);
    out.Single(euler.y);
  }
  const auto& boxes = simulation_.world().scene().boxes;
  out.Word(static_cast<std::uint32_t>(boxes.size()));
  const sim::ArenaController& arena = simulation_.arena();
  const std::vector<int>& waiting = arena.waiting();
  for (const scene::Box& box : boxes) {
    const bool waits = std::binary_search(waiting.begin(), waiting.end(), box.id);
    out.Byte(static_cast<std::uint8_t>((box.raised ? kUp : 0U) | (waits ? kWaiting : 0U)));
  }
  out.Pad();
  const std::size_t moved_at = out.size();
  std::uint32_t moved = 0;
  out.Word(0);
  for (const std::size_t i : dynamic_) {
    const Pose2& at = boxes[i].pose;
    const Pose2& start = simulation_.scenario().world.boxes[i].pose;
    if (at.x == start.x && at.y == start.y && at.yaw == start.yaw) continue;
    ++moved;
    out.Word(static_cast<std::uint32_t>(i));
    out.Single(at.x);
    out.Single(at.y);
    out.Single(at.yaw);
  }
  out.SetWord(moved_at, moved);
  out.Word(static_cast<std::uint32_t>(arena.event_count()));
  const std::size_t turned_at = out.size();
  std::uint32_t turned = 0;
  out.Word(0);
  for (const auto& [place, sensor] : carried_) {
    if (AtRest(*sensor)) continue;
    ++turned;
    out.Word(static_cast<std::uint32_t>(place));
    out.Place(AboveFloor(*sensor, sensor->mount()), ToEuler(sensor->mount_rotation()));
  }
  out.SetWord(turned_at, turned);
  const std::size_t carried_at = out.size();
  std::uint32_t carried = 0;
  out.Word(0);
  for (std::size_t i = 0; i < things_.size(); ++i) {
    const sim::SceneObject& thing = simulation_.world().objects().all()[things_[i]];
    if (!thing.HasMoved()) continue;
    ++carried;
    out.Word(static_cast<std::uint32_t>(i));
    out.Place(thing.WorldPosition(), ToEuler(thing.WorldRotation()));
  }
  out.SetWord(carried_at, carried);

  const std::size_t scans_at = out.size();
  std::uint32_t scans = 0;
  out.Word(0);
  const auto is_new = [&](std::size_t i, const sim::Sensor& sensor) {
    if (sensor.samples() == seen.samples[i]) return false;
    seen.samples[i] = sensor.samples();
    out.Word(static_cast<std::uint32_t>(i));
    ++scans;
    return true;
  };
  for (std::size_t i = 0; i < lasers_.size(); ++i) {
    if (is_new(i, *lasers_[i])) AppendRanges(out, lasers_[i]->ranges(), lasers_[i]->fan().range());
  }
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    if (is_new(lasers_.size() + i, *rings_[i])) {
      AppendRanges(out, rings_[i]->ranges(), rings_[i]->range());
    }
  }
  out.SetWord(scans_at, scans);

  out.Word(static_cast<std::uint32_t>(canvas_width_));
  out.Word(static_cast<std::uint32_t>(canvas_height_));
  out.Word(simulation_.canvas().layers_revision());
  const std::size_t rows_at = out.size();
  std::uint32_t rows = 0;
  out.Word(0);
  for (std::size_t y = 0; y < row_stamps_.size(); ++y) {
    if (row_stamps_[y] <= seen.canvas) continue;
    ++rows;
    out.Word(static_cast<std::uint32_t>(y));
    out.Put(canvas_copy_.data() + y * static_cast<std::size_t>(canvas_width_),
            static_cast<std::size_t>(canvas_width_) * sizeof(std::uint32_t));
  }
  out.SetWord(rows_at, rows);
  seen.canvas = stamp_;
  return out.Take();
}

void ViewModel::StampCanvas() {
  const sim::Canvas& canvas = simulation_.canvas();
  if (!row_stamps_.empty() && canvas.revision() == canvas_revision_) return;
  canvas_revision_ = canvas.revision();
  ++stamp_;
  const auto height = static_cast<std::size_t>(canvas.height());
  const auto width = static_cast<std::size_t>(canvas.width());
  if (canvas_width_ != canvas.width() || canvas_height_ != canvas.height()) {
    canvas_width_ = canvas.width();
    canvas_height_ = canvas.height();
    row_stamps_.assign(height, stamp_);
    canvas_copy_.assign(width * height, 0);
  }
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const int column = static_cast<int>(x);
      const int row = static_cast<int>(y);
      std::uint32_t rgba = 0;
      if (canvas.IsDrawn(column, row)) {
        const Color color = canvas.GetPixel(column, row);
        rgba = 0xFF000000U | std::uint32_t{color.b} << 16U | std::uint32_t{color.g} << 8U | color.r;
      }
      std::uint32_t& copy = canvas_copy_[y * width + x];
      if (copy == rgba) continue;
      copy = rgba;
      row_stamps_[y] = stamp_;
    }
  }
}

}  // namespace ccmorse::servers
