// The range engine: both of its paths against brute force, and against each other.

#include "sim/rays/range_engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/polygon.h"
#include "base/rotation.h"
#include "base/trig.h"
#include "scene/mesh.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

using Real = long double;

struct RealVec {
  Real x, y, z;
};
RealVec operator-(const RealVec& a, const RealVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RealVec operator*(Real s, const RealVec& v) { return {s * v.x, s * v.y, s * v.z}; }
Real Dot(const RealVec& a, const RealVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RealVec Cross(const RealVec& a, const RealVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real Norm(const RealVec& v) { return std::sqrt(Dot(v, v)); }
RealVec Wide(const Vec3& v) { return {v.x, v.y, v.z}; }

// A world as the reference sees it: triangles made here, in long double, from the scene alone.
struct Reference {
  struct Triangle {
    RealVec a, b, c;
    bool one_sided;  // counts only when met from outside
    int robot;       // -1: none
  };
  std::vector<Triangle> triangles;

  void AddPrism(const std::vector<RealVec>& outline, Real bottom, Real top, int robot) {
    const auto at = [&](std::size_t i, Real z) {
      return RealVec{outline[i % outline.size()].x, outline[i % outline.size()].y, z};
    };
    for (std::size_t i = 0; i < outline.size(); ++i) {
      // Cut the other way round than the engine does.
      triangles.push_back({at(i, bottom), at(i + 1, bottom), at(i, top), true, robot});
      triangles.push_back({at(i + 1, bottom), at(i + 1, top), at(i, top), true, robot});
    }
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
      triangles.push_back({at(n - 1, top), at(i, top), at(i + 1, top), true, robot});
      triangles.push_back({at(n - 1, bottom), at(i + 1, bottom), at(i, bottom), true, robot});
    }
  }

  Reference(const scene::World& world, const std::vector<std::unique_ptr<Robot>>& robots) {
    const auto placed = [](Real x, Real y, Real yaw, Real px, Real py) {
      const Real s = std::sin(yaw);
      const Real c = std::cos(yaw);
      return RealVec{x + c * px - s * py, y + s * px + c * py, 0};
    };
    for (const scene::Box& box : world.boxes) {
      if (!box.raised) continue;
      std::vector<RealVec> outline;
      for (const auto& [sx, sy] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
        outline.push_back(
            placed(box.pose.x, box.pose.y, box.pose.yaw, sx * box.size_x / 2, sy * box.size_y / 2));
      }
      AddPrism(outline, 0, box.height, -1);
    }
    for (const auto& robot : robots) {
      for (const scene::HullPart& part : robot->model().hull) {
        std::vector<RealVec> outline;
        for (const Vec2 p : part.outline) {
          outline.push_back(placed(robot->pose().x, robot->pose().y, robot->pose().yaw, p.x, p.y));
        }
        AddPrism(outline, part.bottom, part.top, robot->index());
      }
    }
    for (const scene::Mesh& mesh : world.meshes) {
      const std::vector<Vec3> v = scene::PlacedVertices(mesh);
      for (const auto& t : mesh.triangles) {
        triangles.push_back({Wide(v[static_cast<std::size_t>(t[0])]),
                             Wide(v[static_cast<std::size_t>(t[1])]),
                             Wide(v[static_cast<std::size_t>(t[2])]), false, -1});
      }
    }
    if (world.size_x > 0) {
      const Real x = world.size_x;
      const Real y = world.size_y;
      triangles.push_back({{0, 0, 0}, {x, 0, 0}, {x, y, 0}, true, -1});
      triangles.push_back({{0, 0, 0}, {x, y, 0}, {0, y, 0}, true, -1});
    }
  }

  // Moeller and Trumbore's way, which the engine does not go.
  Real Cast(const RealVec& o, const RealVec& d, Real range, int self, bool* near_edge,
            bool lenient = false) const {
    Real nearest = range;
    for (const Triangle& t : triangles) {
      if (t.robot >= 0 && t.robot == self) continue;
      const RealVec e1 = t.b - t.a;
      const RealVec e2 = t.c - t.a;
      const RealVec normal = Cross(e1, e2);
      // What is seen end on to 2e-3 rad is an edge as a whole where floats find it
      // (embree_scene.h).
      const bool end_on = std::fabs(Dot(normal, d)) < 2e-3L * Norm(normal);
      const Real limit = end_on && lenient ? 1e-5L : 1e-9L;
      if (near_edge != nullptr &&
          (NearEdge(t.a - o, t.b - o, d, limit) || NearEdge(t.b - o, t.c - o, d, limit) ||
           NearEdge(t.c - o, t.a - o, d, limit))) {
        *near_edge = true;
      }
      const RealVec p = Cross(d, e2);
      const Real determinant = Dot(e1, p);
      if (determinant == 0 || (t.one_sided && determinant < 0)) continue;
      const RealVec s = o - t.a;
      const Real u = Dot(s, p) / determinant;
      const RealVec q = Cross(s, e1);
      const Real v = Dot(d, q) / determinant;
      const Real distance = Dot(e2, q) / determinant;
      if (u >= 0 && v >= 0 && u + v <= 1 && distance >= 0) nearest = std::min(nearest, distance);
    }
    return nearest;
  }

  // Does the edge from a to b, as seen from 0, pass within `limit` (rad) of the direction d?
  static bool NearEdge(const RealVec& a, const RealVec& b, const RealVec& d, Real limit) {
    const RealVec m = Cross(a, b);
    const Real length = Norm(m);
    if (std::fabs(Dot(m, d)) > limit * length) return false;
    return Dot(Cross(a, d), m) >= -limit * length * Norm(a) &&
           Dot(Cross(d, b), m) >= -limit * length * Norm(b);
  }
};

// Random worlds.
class RangeEngineTest : public ::testing::Test {
 protected:
  RangeEngineTest() { std::cout << "random seed " << seed_ << "\n"; }

  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int Integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }

  // A world of `size` m with boxes and robots that may overlap in every way.
  scene::World RandomBoxes(double size, int boxes) {
    scene::World world;
    world.name = "random";
    world.size_x = world.size_y = size;
    for (int i = 0; i < boxes; ++i) {
      scene::Box box;
      box.id = i + 1;
      box.pose = {Uniform(0, size), Uniform(0, size), Uniform(-4, 4)};
      if (i % 4 == 0) box.pose.yaw = 0.0;
      box.size_x = Uniform(0.005, 0.25) * size;
      box.size_y = Uniform(0.005, 0.25) * size;
      box.height = Uniform(0.05, 1.0);
      world.boxes.push_back(box);
    }
    return world;
  }

  void AddRandomMesh(scene::World& world) {
    scene::Mesh mesh;
    mesh.id = static_cast<int>(world.boxes.size() + world.meshes.size()) + 1;
    const double size = 0.2 * world.size_x;
    for (int i = Integer(3, 12); i > 0; --i) {
      mesh.vertices.push_back({Uniform(-size, size), Uniform(-size, size), Uniform(-0.5, 0.5)});
    }
    const int last = static_cast<int>(mesh.vertices.size()) - 1;
    for (int i = Integer(1, 20); i > 0; --i) {
      const std::array<int, 3> triangle = {Integer(0, last), Integer(0, last), Integer(0, last)};
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0]) {
        mesh.triangles.push_back(triangle);
      }
    }
    mesh.position = {Uniform(0, world.size_x), Uniform(0, world.size_y), Uniform(0, 0.5)};
    mesh.rotation = {Uniform(-3, 3), Uniform(-3, 3), Uniform(-3, 3)};
    world.meshes.push_back(mesh);
  }

  // Robots at random in the world, the first with `laser`.
  void MakeRobots(const World& world, int count, const scene::LaserDef& laser) {
    robots_.clear();
    for (int i = 0; i < count; ++i) {
      scene::RobotDef def;
      def.name = "robot";
      def.type = i % 2 == 0 ? "S1R" : "BoxRobot";
      def.laser = laser;
      def.pose = {Uniform(0, world.scene().size_x), Uniform(0, world.scene().size_y),
                  Uniform(-4, 4)};
      robots_.push_back(std::make_unique<Robot>(def, i));
    }
  }
  void SetRobots(World& world) {
    std::vector<const Robot*> seen;
    for (const auto& robot : robots_) seen.push_back(robot.get());
    world.SetRobots(seen);
  }

  // Beams of robot 0's laser that are off by more than the limit.
  int Wrong(const World& world, const scene::LaserDef& laser, double limit, bool lenient = false) {
    BeamFan fan(laser);
    std::vector<double> ranges(fan.count());
    const Robot& robot = *robots_[0];
    world.rays().Scan(fan, robot.pose(), robot.model().origin_height, 0, ranges);
    const Reference reference(world.scene(), robots_);
    const Rotation turned = FromEuler(0, 0, robot.pose().yaw);
    const RealVec origin = Wide(Vec3{robot.pose().x, robot.pose().y, robot.model().origin_height} +
                                Rotate(turned, laser.position));
    const Rotation mounted = FromEuler(laser.roll, laser.pitch, laser.yaw);
    int wrong = 0;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      bool near_edge = false;
      RealVec direction = Wide(Rotate(turned, Rotate(mounted, fan.Direction(i))));
      direction = (1 / Norm(direction)) * direction;
      const Real expected = reference.Cast(origin, direction, laser.range, 0, &near_edge, lenient);
      ++beams_;
      if (near_edge) {
        ++near_edges_;
        continue;
      }
      const double off = std::fabs(static_cast<double>(ranges[i] - expected));
      if (expected < laser.range) ++hits_;
      worst_ = std::max(worst_, off);
      if (off <= limit) continue;
      ++wrong;
      std::cout << "beam " << i << " is " << ranges[i] << ", the reference says "
                << static_cast<double>(expected) << "\n";
    }
    return wrong;
  }

  ~RangeEngineTest() override {
    if (beams_ > 0) {
      std::cout << beams_ << " beams, " << hits_ << " hit, " << near_edges_
                << " too near an edge; largest error " << worst_ << " m\n";
    }
  }

  // CCMORSE_SEED repeats a run.
  std::uint64_t seed_ = std::getenv("CCMORSE_SEED") != nullptr
                            ? std::stoull(std::getenv("CCMORSE_SEED"))
                            : std::random_device{}();
  std::mt19937_64 random_{seed_};
  std::vector<std::unique_ptr<Robot>> robots_;
  std::int64_t beams_ = 0;
  std::int64_t hits_ = 0;
  std::int64_t near_edges_ = 0;
  double worst_ = 0.0;
};

scene::LaserDef Laser(int samples, double window_deg, double range) {
  scene::LaserDef laser;
  laser.samples = samples;
  laser.scan_window_deg = window_deg;
  laser.resolution_deg = window_deg / samples;
  laser.range = range;
  return laser;
}

TEST_F(RangeEngineTest, BothPathsAgreeWithBruteForceOnAThousandUprightScenes) {
  int wrong_planar = 0;
  int wrong_embree = 0;
  for (int i = 0; i < 1000; ++i) {
    const double size = i % 10 == 0 ? 300.0 : Uniform(2.0, 10.0);
    World world(RandomBoxes(size, Integer(0, 40)));
    scene::LaserDef laser = Laser(Integer(2, 150), Uniform(10, 360), Uniform(0.5, 1.0) * size);
    laser.yaw = Uniform(-3, 3);
    laser.position.z = Uniform(-0.02, 0.2);
    MakeRobots(world, Integer(1, 6), laser);
    SetRobots(world);
    world.rays().Force(RayPath::kPlanar);
    // The buffer keeps 1/range, so its error grows with the range.
    wrong_planar += Wrong(world, laser, 1e-9);
    world.rays().Force(RayPath::kEmbree);
    wrong_embree += Wrong(world, laser, 1e-9);
  }
  EXPECT_EQ(wrong_planar, 0);
  EXPECT_EQ(wrong_embree, 0);
}

TEST_F(RangeEngineTest, TiltedAndLayeredScansAgreeWithBruteForceOnAThousandScenesWithMeshes) {
  int wrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const double size = i % 10 == 0 ? 300.0 : Uniform(2.0, 10.0);
    scene::World scene = RandomBoxes(size, Integer(0, 10));
    for (int k = Integer(0, 4); k > 0; --k) AddRandomMesh(scene);
    World world(std::move(scene));
    scene::LaserDef laser = Laser(Integer(2, 60), Uniform(10, 360), Uniform(0.5, 1.0) * size);
    laser.layers = Integer(1, 4);
    laser.layer_separation = Uniform(0.1, 20);
    laser.roll = Uniform(-0.5, 0.5);
    laser.pitch = Uniform(-1, 1);
    laser.yaw = Uniform(-3, 3);
    laser.position = {Uniform(-0.1, 0.1), Uniform(-0.1, 0.1), Uniform(0.0, 0.4)};
    MakeRobots(world, Integer(1, 6), laser);
    SetRobots(world);
    wrong += Wrong(world, laser, 1e-9);
  }
  EXPECT_EQ(wrong, 0);
}

// A point in space or on the ground plane seen from another, as a mount's yaw and pitch.
scene::LaserDef AimedAt(const Vec3& from, const Vec3& target, double off_yaw, double off_pitch) {
  const Vec3 way = target - from;
  scene::LaserDef laser = Laser(2, 1e-12, 30.0);
  laser.yaw = std::atan2(way.y, way.x) + off_yaw;
  laser.pitch = off_pitch == 0.0 ? 0.0 : -std::atan2(way.z, std::hypot(way.x, way.y)) + off_pitch;
  return laser;
}

// Random beams seldom pass an edge so closely that floats cannot say on which side. These do.
TEST_F(RangeEngineTest, BeamsThatPassAnEdgeByLittleMoreThanNothingAreRight) {
  int wrong = 0;
  for (int i = 0; i < 600; ++i) {
    const bool level = i % 2 == 0;
    scene::World scene = RandomBoxes(i % 10 == 0 ? 300.0 : Uniform(2.0, 10.0), Integer(2, 12));
    if (!level) AddRandomMesh(scene);
    World world(scene);
    MakeRobots(world, 2, {});
    robots_[0]->Place({robots_[0]->pose().x, robots_[0]->pose().y, 0.0});
    SetRobots(world);
    // Corners and points on edges; for a level beam upright ones, and where walls run into each
    // other.
    std::vector<Vec3> targets;
    std::vector<std::array<Vec2, 4>> outlines;
    for (const scene::Box& box : scene.boxes) {
      outlines.push_back(BoxCorners(box.pose, box.size_x, box.size_y));
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 a = outlines.back()[k];
        const Vec2 b = outlines.back()[(k + 1) % 4];
        targets.push_back({a.x, a.y, box.height * Uniform(0, 1)});
        const Vec2 on = a + Uniform(0, 1) * (b - a);
        if (!level) targets.push_back({on.x, on.y, box.height});
        for (const auto& other : outlines) {
          for (std::size_t m = 0; m < 4; ++m) {
            const Vec2 edge = other[(m + 1) % 4] - other[m];
            const double part = Cross(other[m] - a, edge) / Cross(b - a, edge);
            const double along = Cross(other[m] - a, b - a) / Cross(b - a, edge);
            if (!(part > 0 && part < 1 && along > 0 && along < 1)) continue;
            const Vec2 at = a + part * (b - a);
            targets.push_back({at.x, at.y, Uniform(0, 0.1)});
          }
        }
      }
    }
    for (const scene::Mesh& mesh : scene.meshes) {
      const std::vector<Vec3> v = scene::PlacedVertices(mesh);
      for (const auto& t : mesh.triangles) {
        const Vec3& a = v[static_cast<std::size_t>(t[0])];
        targets.push_back(a);
        targets.push_back(a + Uniform(0, 1) * (v[static_cast<std::size_t>(t[1])] - a));
      }
    }
    const Vec3 from{robots_[0]->pose().x, robots_[0]->pose().y, 0.035};
    for (const Vec3& target : targets) {
      const double size = std::pow(10.0, Uniform(-8.5, -5.5));
      const double sign = Integer(0, 1) == 0 ? -1.0 : 1.0;
      scene::LaserDef laser =
          AimedAt(from, target, sign * size, level ? 0.0 : Uniform(-1, 1) * size);
      laser.position = {};
      laser.range = scene.size_x;
      for (const RayPath path : {RayPath::kPlanar, RayPath::kEmbree}) {
        if (!level && path == RayPath::kPlanar) continue;
        world.rays().Force(path);
        wrong += Wrong(world, laser, 1e-9, path == RayPath::kEmbree);
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace ccmorse::sim
