#include "sim/sensors/semantic_camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/euler.h"
#include "base/trig.h"
#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/sensors/sensor_motion.h"

namespace ccmorse::sim {
namespace {

constexpr double kHalfLens = 16.0;  // half the width of what the picture falls on, as cam_focal is
constexpr double kNoDistance = 1e-6;  // m

// The box around a robot that is not turned, or the place of what has no body; low and high corner.
std::array<Vec3, 2> BoxAround(const SceneObject& object) {
  const Vec3 at = object.WorldPosition();
  if (object.robot == nullptr || object.robot->model().hull.empty()) return {at, at};
  Vec3 low = at;
  Vec3 high = at;
  for (const scene::HullPart& part : object.robot->model().hull) {
    for (const Vec2& corner : part.outline) {
      low = {std::min(low.x, at.x + corner.x), std::min(low.y, at.y + corner.y), low.z};
      high = {std::max(high.x, at.x + corner.x), std::max(high.y, at.y + corner.y), high.z};
    }
    low.z = std::min(low.z, part.bottom);
    high.z = std::max(high.z, part.top);
  }
  return {low, high};
}

// x, y, z, w; w is not negative.
std::array<double, 4> ToQuaternion(const Rotation& r) {
  const std::array<double, 4> squares = {1.0 + r.x.x - r.y.y - r.z.z, 1.0 - r.x.x + r.y.y - r.z.z,
                                         1.0 - r.x.x - r.y.y + r.z.z, 1.0 + r.x.x + r.y.y + r.z.z};
  // From the largest, as the square root of a small one is not exact.
  const auto largest =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double twice = std::sqrt(squares[largest]);
  const double share = 0.5 / twice;
  std::array<double, 4> q{};
  switch (largest) {
    case 0:
      q = {0.5 * twice, share * (r.x.y + r.y.x), share * (r.x.z + r.z.x), share * (r.y.z - r.z.y)};
      break;
    case 1:
      q = {share * (r.x.y + r.y.x), 0.5 * twice, share * (r.y.z + r.z.y), share * (r.z.x - r.x.z)};
      break;
    case 2:
      q = {share * (r.x.z + r.z.x), share * (r.y.z + r.z.y), 0.5 * twice, share * (r.x.y - r.y.x)};
      break;
    default:
      q = {share * (r.y.z - r.z.y), share * (r.z.x - r.x.z), share * (r.x.y - r.y.x), 0.5 * twice};
  }
  if (q[3] < 0.0) {
    for (double& part : q) part = 0.0 - part;
  }
  return q;
}

std::string TextOf(const SceneObject& object, const char* property) {
  const Json* const value = object.properties.Find(property);
  if (value == nullptr) return "";
  return value->IsString() ? value->AsString() : value->Dump();
}

}  // namespace

SemanticCamera::SemanticCamera(Robot& robot, const std::string& name, const World& world)
    : Sensor(robot, name, "SemanticCamera", 20.0), world_(world) {
  constexpr double kFarthest = 1e6;
  AddProperty("cam_width", width_, 1.0, 1e5);
  AddProperty("cam_height", height_, 1.0, 1e5);
  AddProperty("cam_focal", focal_, 1e-3, kFarthest);
  AddProperty("cam_near", near_, 0.0, kFarthest);
  AddProperty("cam_far", far_, 0.0, kFarthest);
  AddProperty("Vertical_Flip", flip_);
  AddProperty("retrieve_depth", depth_);
  AddProperty("retrieve_zbuffer", zbuffer_);
  AddProperty("relative", relative_);
  AddProperty("noocclusion", unhidden_);
  AddProperty("tag", tag_);
}

// The longer side of the picture sees all of the lens.
double SemanticCamera::HalfOf(double pixels) const {
  return kHalfLens / focal_ * pixels / std::max(width_, height_);
}

void SemanticCamera::Prepare() { world_.rays().Prepare(); }

bool SemanticCamera::IsTracked(const SceneObject& object) const {
  if (object.robot == &robot()) return false;
  const Json* const type = object.properties.Find("Type");
  return (type != nullptr && *type == Json(tag_)) || object.Is(tag_);
}

bool SemanticCamera::IsInView(const SceneObject& object, const Vec3& camera,
                              const Rotation& view) const {
  const double wide = half_width();
  const double high = half_height();
  const std::array<Vec3, 2> box = BoxAround(object);
  std::array<bool, 6> all_beyond{};
  all_beyond.fill(true);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 at = RotateBack(
        view,
        Vec3{box[corner & 1U].x, box[corner >> 1U & 1U].y, box[corner >> 2U & 1U].z} - camera);
    const std::array<bool, 6> beyond = {at.x<near_, at.x> far_, at.y > wide * at.x,
                                        at.y<-wide * at.x, at.z> high * at.x, at.z < -high * at.x};
    for (std::size_t i = 0; i < beyond.size(); ++i) all_beyond[i] = all_beyond[i] && beyond[i];
  }
  return std::none_of(all_beyond.begin(), all_beyond.end(), [](bool beyond) { return beyond; });
}

bool SemanticCamera::IsHidden(const SceneObject& object, const Vec3& camera) const {
  const Vec3 way = object.WorldPosition() - camera;
  const double distance = std::sqrt(Dot(way, way));
  if (!(distance > kNoDistance)) return false;
  // One beam of two, which a fan has at least. It is rolled so that it is traced as a ray.
  scene::LaserDef ray;
  ray.position = camera;
  ray.roll = 0.5;
  ray.pitch = Atan2(0.0 - way.z, std::sqrt(way.x * way.x + way.y * way.y));
  ray.yaw = Atan2(way.y, way.x);
  ray.range = distance;
  ray.samples = 2;
  ray.scan_window_deg = ray.resolution_deg = 1e-6;
  BeamFan fan(ray);
  std::array<RayHit, 2> hits{};
  world_.rays().ScanHits(fan, {}, 0.0, robot().index(), hits);
  const RayHit& hit = hits[0];
  if (hit.surface.kind == HitKind::kNothing || hit.distance >= distance - kNoDistance) return false;
  if (hit.surface.kind == HitKind::kRobot) {
    return object.robot == nullptr || hit.surface.object != object.robot->index();
  }
  if (hit.surface.kind != HitKind::kMesh) return true;
  return std::none_of(world_.scene().meshes.begin(), world_.scene().meshes.end(),
                      [&](const scene::Mesh& mesh) {
                        return mesh.id == hit.surface.object && mesh.name == object.name;
                      });
}

void SemanticCamera::Sample(const Instant& now) {
  const MountPlace here = PlaceOfMount(*this);
  seen_.clear();
  for (const SceneObject& object : world_.objects().all()) {
    if (!IsTracked(object) || !IsInView(object, here.position, here.rotation)) continue;
    if (!unhidden_ && IsHidden(object, here.position)) continue;
    Seen seen{&object, object.WorldPosition(), object.WorldRotation()};
    if (relative_) {
      seen.position = RotateBack(here.rotation, seen.position - here.position);
      const Rotation turned = seen.rotation;
      seen.rotation = {RotateBack(here.rotation, turned.x), RotateBack(here.rotation, turned.y),
                       RotateBack(here.rotation, turned.z)};
    }
    seen_.push_back(seen);
  }
  DataChanged(now.time);
}

void SemanticCamera::Reset() {
  Sensor::Reset();
  seen_.clear();
}

void SemanticCamera::AddToHash(StateHash& hash) const {
  for (const Seen& seen : seen_) {
    hash.Add(seen.object->name);
    hash.Add(seen.position.x);
    hash.Add(seen.position.y);
    hash.Add(seen.position.z);
  }
}

void SemanticCamera::AppendFields(std::string& out) const {
  Json::Array objects;
  for (const Seen& seen : seen_) {
    const std::string label = TextOf(*seen.object, "Label");
    const auto [x, y, z, w] = ToQuaternion(seen.rotation);
    objects.emplace_back(
        Json::Object{{"name", label.empty() ? seen.object->name : label},
                     {"description", TextOf(*seen.object, "Description")},
                     {"type", TextOf(*seen.object, "Type")},
                     {"position", Json::Array{seen.position.x, seen.position.y, seen.position.z}},
                     {"orientation", Json::Object{{"x", x}, {"y", y}, {"z", z}, {"w", w}}}});
  }
  out += ", \"visible_objects\": " + Json(std::move(objects)).Dump();
}

}  // namespace ccmorse::sim
