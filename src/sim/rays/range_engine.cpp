#include "sim/rays/range_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/euler.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/mesh.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

TriangleSet BoxTriangles(const scene::World& world) {
  TriangleSet set;
  for (const scene::Box& box : world.boxes) {
    if (!box.raised || !box.visible) continue;
    set.AddPrism(BoxCorners(box.pose, box.size_x, box.size_y), 0.0, box.height,
                 {HitKind::kBox, box.id, 0});
  }
  return set;
}

TriangleSet MeshTriangles(const scene::Mesh& mesh) {
  TriangleSet set;
  set.closed = false;
  const std::vector<Vec3> vertices = scene::PlacedVertices(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    set.Add(vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)],
            vertices[static_cast<std::size_t>(c)], {HitKind::kMesh, mesh.id, static_cast<int>(i)});
  }
  return set;
}

TriangleSet HullTriangles(const scene::RobotModel& model) {
  TriangleSet set;
  int first = 0;
  for (const scene::HullPart& part : model.hull) {
    set.AddPrism(part.outline, part.bottom, part.top, {HitKind::kRobot, 0, first});
    first += PrismSurfaces(part.outline.size());
  }
  return set;
}

// An upright outline that a level beam may have met, and the name of its side 0.
struct Candidate {
  std::vector<Vec2> corners;
  Surface first;
};

}  // namespace

RangeEngine::RangeEngine(const World& world) : world_(world) {
  for (const scene::Mesh& mesh : world.scene().meshes) {
    Heights heights{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const Vec3& vertex : scene::PlacedVertices(mesh)) {
      heights.bottom = std::min(heights.bottom, vertex.z);
      heights.top = std::max(heights.top, vertex.z);
    }
    mesh_heights_.push_back(heights);
  }
}

RangeEngine::~RangeEngine() = default;

bool RangeEngine::Leans(int self) const {
  return self >= 0 && world_.robots()[static_cast<std::size_t>(self)]->tilted();
}

RayPath RangeEngine::Choose(const BeamFan& fan, double height, int self) const {
  const bool meets_mesh =
      std::any_of(mesh_heights_.begin(), mesh_heights_.end(), [height](const Heights& heights) {
        return heights.bottom <= height && height <= heights.top;
      });
  // On terrain robots are at all heights, and may lean.
  const bool planar = fan.upright() && !meets_mesh && !world_.scene().terrain && !Leans(self);
  if (forced_ == RayPath::kPlanar && !planar) {
    throw Error("a scan that is tilted, has layers or meets a mesh cannot take the planar path");
  }
  return planar && forced_ != RayPath::kEmbree ? RayPath::kPlanar : RayPath::kEmbree;
}

void RangeEngine::Scan(BeamFan& fan, const Pose2& robot, double origin_height, int self,
                       std::span<double> ranges) const {
  const double height = origin_height + fan.position().z;
  if (Choose(fan, height, self) == RayPath::kPlanar) {
    fan.planar().Scan(fan.PlanarPose(robot), world_.BoxesAt(height), world_.RobotsAt(height), self,
                      ranges);
    return;
  }
  thread_local std::vector<RayHit> hits;
  hits.resize(fan.count());
  Trace(fan, robot, origin_height, self, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) ranges[i] = hits[i].distance;
}

void RangeEngine::ScanHits(BeamFan& fan, const Pose2& robot, double origin_height, int self,
                           std::span<RayHit> hits) const {
  const double height = origin_height + fan.position().z;
  if (Choose(fan, height, self) == RayPath::kPlanar) {
    Identify(fan, robot, height, self, hits);
  } else {
    Trace(fan, robot, origin_height, self, hits);
  }
}

void RangeEngine::Trace(BeamFan& fan, const Pose2& robot, double origin_height, int self,
                        std::span<RayHit> hits) const {
  const EmbreeScene& triangles = Triangles();
  const Rotation turned = Leans(self) ? world_.robots()[static_cast<std::size_t>(self)]->rotation()
                                      : FromEuler(0.0, 0.0, robot.yaw);
  const Rotation rotation = Combined(turned, fan.rotation());
  const Vec3 origin = Vec3{robot.x, robot.y, origin_height} + Rotate(turned, fan.position());
  thread_local std::vector<Ray> rays;
  rays.resize(fan.count());
  const std::vector<Vec3>& directions = fan.directions();
  for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = {origin, Rotate(rotation, directions[i])};
  triangles.Trace(rays, fan.range(), self, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) MeetFloor(rays[i], hits[i]);
}

void RangeEngine::MeetFloor(const Ray& ray, RayHit& hit) const {
  const scene::World& world = world_.scene();
  if (!(ray.direction.z < 0.0) || !world.has_floor) return;
  const double distance = -ray.origin.z / ray.direction.z;
  if (!(distance >= 0.0 && distance < hit.distance)) return;
  const Vec3 at = ray.origin + distance * ray.direction;
  const Vec2 high = world.high();
  if (at.x < world.low.x || at.y < world.low.y || at.x > high.x || at.y > high.y) return;
  hit = {distance, {HitKind::kFloor, 0, 0}};
}

// The beam buffer keeps distances only, so what was hit is looked for: the side whose distance
// along the beam is what was measured.
void RangeEngine::Identify(BeamFan& fan, const Pose2& robot, double height, int self,
                           std::span<RayHit> hits) const {
  std::vector<double> ranges(fan.count());
  const Pose2 pose = fan.PlanarPose(robot);
  fan.planar().Scan(pose, world_.BoxesAt(height), world_.RobotsAt(height), self, ranges);
  std::vector<Candidate> candidates;
  for (const scene::Box& box : world_.scene().boxes) {
    if (!box.raised || !box.visible || box.height <= height) continue;
    const auto corners = BoxCorners(box.pose, box.size_x, box.size_y);
    candidates.push_back({{corners.begin(), corners.end()}, {HitKind::kBox, box.id, 0}});
  }
  for (const Robot* other : world_.robots()) {
    if (other->index() == self) continue;
    int first = 0;
    const double risen =
        other->dynamic() ? other->position().z - other->model().origin_height : 0.0;
    for (const scene::HullPart& part : other->model().hull) {
      if (part.bottom <= height - risen && height - risen < part.top) {
        std::vector<Vec2> corners(part.outline.size());
        Place(part.outline, other->pose(), corners);
        candidates.push_back({std::move(corners), {HitKind::kRobot, other->index(), first}});
      }
      first += PrismSurfaces(part.outline.size());
    }
  }
  const auto [s, c] = SinCos(pose.yaw);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i] = {ranges[i], {}};
    if (ranges[i] >= fan.range()) continue;
    const Vec3 local = fan.Direction(i);
    const Vec2 direction{c * local.x - s * local.y, s * local.x + c * local.y};
    double least = 1e-6;  // m between the distance measured and that of the side
    for (const Candidate& candidate : candidates) {
      for (std::size_t k = 0; k < candidate.corners.size(); ++k) {
        const Vec2 from = candidate.corners[k] - Vec2{pose.x, pose.y};
        const Vec2 edge =
            candidate.corners[(k + 1) % candidate.corners.size()] - candidate.corners[k];
        const double parallel = Cross(direction, edge);
        const double along = Cross(from, direction) / parallel;
        const double off = std::fabs(Cross(from, edge) / parallel - ranges[i]);
        if (!(parallel < 0.0 && along >= -1e-9 && along <= 1.0 + 1e-9 && off < least)) continue;
        least = off;
        hits[i].surface = candidate.first;
        hits[i].surface.surface += static_cast<int>(k);
      }
    }
  }
}

RayHit RangeEngine::Nearest(const Cone& cone, double range, int self) const {
  return Triangles().Nearest(cone, range, self);
}

double RangeEngine::Cast(const Ray& ray, double range, int self) const {
  RayHit hit;
  Triangles().Trace({&ray, 1}, range, self, {&hit, 1});
  MeetFloor(ray, hit);
  return hit.distance;
}

bool RangeEngine::LineOfSight(const Vec3& from, const Vec3& to) const {
  const Vec3 way = to - from;
  const double length = std::sqrt(Dot(way, way));
  if (!(length > 0.0)) return true;
  RayHit floor{length, {}};
  MeetFloor({from, (1.0 / length) * way}, floor);
  return floor.surface.kind == HitKind::kNothing && !Triangles().IsBlocked(from, to);
}

const EmbreeScene& RangeEngine::Triangles() const {
  const std::uint64_t wanted = world_.version();
  if (built_.load(std::memory_order_acquire) == wanted) return *triangles_;
  const std::lock_guard lock(mutex_);
  if (built_.load(std::memory_order_relaxed) == wanted) return *triangles_;
  if (!triangles_) triangles_ = std::make_unique<EmbreeScene>();
  if (built_revision_ != world_.revision()) Build();
  while (!PlaceRobots()) Build();
  triangles_->Commit();
  built_.store(wanted, std::memory_order_release);
  return *triangles_;
}

void RangeEngine::Build() const {
  const scene::World& world = world_.scene();
  std::vector<TriangleSet> fixed = {BoxTriangles(world)};
  for (const scene::Mesh& mesh : world.meshes) {
    if (mesh.visible) fixed.push_back(MeshTriangles(mesh));
  }
  std::vector<TriangleSet> models;
  std::map<std::string, int> model_of_type;
  std::vector<int> model_of;
  for (const Robot* robot : world_.robots()) {
    // A robot with a body of its own shares it with no other.
    const scene::RobotDef& def = robot->def();
    const std::string key = def.body ? "body of " + def.name : def.type;
    const auto [model, is_new] = model_of_type.emplace(key, static_cast<int>(models.size()));
    if (is_new) models.push_back(HullTriangles(robot->model()));
    model_of.push_back(model->second);
  }
  const double far_x = std::max(std::fabs(world.low.x), world.size_x + world.low.x);
  const double far_y = std::max(std::fabs(world.low.y), world.size_y + world.low.y);
  triangles_->Build(fixed, models, model_of, std::max({extent_, far_x, far_y}));
  built_revision_ = world_.revision();
}

// False when a robot is farther away than the triangles are prepared for.
bool RangeEngine::PlaceRobots() const {
  for (const Robot* robot : world_.robots()) {
    const Pose2& pose = robot->pose();
    const Vec3 foot = robot->foot();
    const double farthest =
        std::max({std::fabs(pose.x), std::fabs(pose.y), std::fabs(foot.z)}) + 1.0;
    if (farthest > triangles_->extent()) {
      extent_ = 2.0 * farthest;
      return false;
    }
    triangles_->Place(robot->index(), {foot, robot->rotation()});
  }
  return true;
}

}  // namespace ccmorse::sim
