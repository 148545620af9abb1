#include "sim/world.h"

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "base/polygon.h"
#include "scene/mesh.h"
#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"

namespace ccmorse::sim {

World::World(scene::World scene) : scene_(std::move(scene)), ground_(scene_) {
  for (const scene::Mesh& mesh : scene_.meshes) {
    if (scene_.terrain) break;  // it depends on the robot what of them is in its way
    for (std::vector<Vec2>& outline : scene::MeshOutlines(mesh)) {
      mesh_obstacles_.push_back(Obstacle::Make(std::move(outline), mesh.id));
    }
  }
  CollectObstacles();
  rays_ = std::make_unique<RangeEngine>(*this);
}

World::~World() = default;

void World::SetRobots(std::vector<const Robot*> robots) {
  robots_ = std::move(robots);
  ++revision_;
  RobotsMoved();
}

bool World::LineOfSight(const Vec3& from, const Vec3& to) const {
  return rays_->LineOfSight(from, to);
}

void World::CollectObstacles() {
  obstacles_.clear();
  for (const scene::Box& box : scene_.boxes) {
    if (!box.raised || !box.solid) continue;
    const auto corners = BoxCorners(box.pose, box.size_x, box.size_y);
    obstacles_.push_back(Obstacle::Make({corners.begin(), corners.end()}, box.id));
  }
  obstacles_.insert(obstacles_.end(), mesh_obstacles_.begin(), mesh_obstacles_.end());
  std::vector<Circle> circles;
  for (const Obstacle& obstacle : obstacles_) circles.push_back({obstacle.centre, obstacle.radius});
  obstacle_grid_.Build(circles);
  ++revision_;
}

const scene::Box* World::FindBox(int box_id) const {
  const auto box = std::find_if(scene_.boxes.begin(), scene_.boxes.end(),
                                [box_id](const scene::Box& b) { return b.id == box_id; });
  return box != scene_.boxes.end() ? &*box : nullptr;
}

scene::Box& World::DynamicBox(int box_id) {
  const scene::Box* const box = FindBox(box_id);
  if (box == nullptr) throw Error("the world has no box with id " + std::to_string(box_id));
  if (!box->dynamic) {
    throw Error("box " + std::to_string(box_id) + " is " + box->kind + " and cannot be moved");
  }
  return scene_.boxes[static_cast<std::size_t>(box - scene_.boxes.data())];
}

void World::BoxesChanged() {
  CollectObstacles();
  for (const auto& cut : cuts_) FillBoxes(*cut);
}

void World::SetRaised(int box_id, bool raised) {
  DynamicBox(box_id).raised = raised;
  BoxesChanged();
}

void World::SetBoxPose(int box_id, const Pose2& pose) {
  DynamicBox(box_id).pose = pose;
  BoxesChanged();
}

void World::FillBoxes(Cut& cut) const {
  cut.boxes.Clear();
  for (const scene::Box& box : scene_.boxes) {
    if (!box.raised || !box.visible || box.height <= cut.height) continue;
    cut.boxes.Add(BoxCorners(box.pose, box.size_x, box.size_y));
  }
  cut.boxes.Finish();
}

World::Cut& World::CutAt(double height) const {
  for (const auto& cut : cuts_) {
    if (cut->height == height) return *cut;
  }
  cuts_.push_back(std::make_unique<Cut>(Cut{height, {}, {}}));
  FillBoxes(*cuts_.back());
  robots_moved_ = true;
  return *cuts_.back();
}

const PlanarWorld& World::BoxesAt(double height) const { return CutAt(height).boxes; }

const PlanarWorld& World::RobotsAt(double height) const {
  Cut& wanted = CutAt(height);
  if (robots_moved_.load(std::memory_order_acquire)) {
    const std::lock_guard lock(cutting_);
    if (robots_moved_.load(std::memory_order_relaxed)) {
      CutRobots();
      robots_moved_.store(false, std::memory_order_release);
    }
  }
  return wanted.robots;
}

void World::CutRobots() const {
  for (const auto& cut : cuts_) {
    cut->robots.Clear();
    for (const Robot* robot : robots_) {
      // How much higher than at the start; of a dynamic robot that is tilted the cut is as if it
      // were not.
      const double risen =
          robot->dynamic() ? robot->position().z - robot->model().origin_height : 0.0;
      for (const scene::HullPart& part : robot->model().hull) {
        const double height = cut->height - risen;
        if (height < part.bottom || height >= part.top) continue;
        hull_.resize(part.outline.size());
        Place(part.outline, robot->pose(), hull_);
        cut->robots.Add(hull_, robot->index());
      }
    }
    cut->robots.Finish();
  }
}

double World::CastRay(Vec2 from, Vec2 direction, double height, double range, int self,
                      int* hit_robot) const {
  double nearest = range;
  *hit_robot = -1;
  const auto cast = [&](const PlanarWorld& world) {
    for (const PlanarWorld::Outline& outline : world.outlines()) {
      if (outline.owner >= 0 && outline.owner == self) continue;
      const std::span<const Vec2> corners = world.Corners(outline);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 a = corners[i] - from;
        const Vec2 edge = corners[(i + 1) % corners.size()] - corners[i];
        const double parallel = Cross(direction, edge);
        if (parallel == 0.0) continue;
        const double distance = Cross(a, edge) / parallel;
        const double along = Cross(a, direction) / parallel;
        if (distance >= 0.0 && distance < nearest && along >= 0.0 && along <= 1.0) {
          nearest = distance;
          *hit_robot = outline.owner;
        }
      }
    }
  };
  cast(BoxesAt(height));
  cast(RobotsAt(height));
  return nearest;
}

}  // namespace ccmorse::sim
