// The range engine: both of its paths against brute force, and against each other.

#include "sim/rays/range_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <memory>
#include <queue>
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
    bool floor = false;
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
      triangles.push_back({{0, 0, 0}, {x, 0, 0}, {x, y, 0}, true, -1, true});
      triangles.push_back({{0, 0, 0}, {x, y, 0}, {0, y, 0}, true, -1, true});
    }
  }

  // Moeller and Trumbore's way, which the engine does not go.
  Real Cast(const RealVec& o, const RealVec& d, Real range, int self) const {
    Real nearest = range;
    for (const Triangle& t : triangles) {
      if (t.robot >= 0 && t.robot == self) continue;
      const RealVec e1 = t.b - t.a;
      const RealVec e2 = t.c - t.a;
      const RealVec p = Cross(d, e2);
      const Real determinant = Dot(e1, p);
      if (determinant == 0 || (t.one_sided && determinant < 0)) continue;
      const RealVec s = o - t.a;
      const Real u = Dot(s, p) / determinant;
      if (u < 0 || u > 1) continue;
      const RealVec q = Cross(s, e1);
      const Real v = Dot(d, q) / determinant;
      const Real distance = Dot(e2, q) / determinant;
      if (v >= 0 && u + v <= 1 && distance >= 0) nearest = std::min(nearest, distance);
    }
    return nearest;
  }

  // Does the direction pass an edge so closely that either answer is right? `floats`: by the
  // measure of what looks for candidates in float (embree_scene.h).
  bool PassesAnEdge(const RealVec& o, const RealVec& d, int self, bool floats) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
      if (t.robot >= 0 && t.robot == self) return false;
      const RealVec normal = Cross(t.b - t.a, t.c - t.a);
      const bool end_on = std::fabs(Dot(normal, d)) < 5e-3L * Norm(normal);
      const Real limit = floats && end_on ? 1e-5L : 1e-9L;
      return NearEdge(t.a - o, t.b - o, d, limit) || NearEdge(t.b - o, t.c - o, d, limit) ||
             NearEdge(t.c - o, t.a - o, d, limit);
    });
  }

  // The nearest point in the cone by cutting triangles into smaller ones, the most promising first;
  // right to 1e-4 m of a cone that is right to 1e-4 rad. `half`: half the opening, rad. Not the
  // floor.
  Real NearestInCone(const RealVec& apex, const RealVec& axis, Real half, Real range,
                     int self) const {
    struct Piece {
      Real bound;  // nothing of it is nearer
      RealVec a, b, c;
      bool operator<(const Piece& other) const { return bound > other.bound; }
    };
    Real best = range;
    std::priority_queue<Piece> pieces;
    const auto in_cone = [&](const RealVec& p) { return Dot(p, axis) >= Norm(p) * std::cos(half); };
    const auto add = [&](const RealVec& a, const RealVec& b, const RealVec& c) {
      const RealVec centre = (1 / Real{3}) * (a - (RealVec{0, 0, 0} - b) - (RealVec{0, 0, 0} - c));
      const Real radius = std::max({Norm(a - centre), Norm(b - centre), Norm(c - centre)});
      const Real along = Dot(centre, axis);
      const Real aside = std::sqrt(std::max(Real{0}, Dot(centre, centre) - along * along));
      if (aside * std::cos(half) - along * std::sin(half) > radius) return;
      for (const RealVec& p : {a, b, c, centre}) {
        if (in_cone(p)) best = std::min(best, Norm(p));
      }
      if (radius < std::min(2e-5L, 5e-5L * Norm(centre))) best = std::min(best, Norm(centre));
      if (Norm(centre) - radius < best - 5e-5L) pieces.push({Norm(centre) - radius, a, b, c});
    };
    for (const Triangle& t : triangles) {
      if (t.floor || (t.robot >= 0 && t.robot == self)) continue;
      const RealVec normal = Cross(t.b - t.a, t.c - t.a);
      if (t.one_sided && Dot(normal, t.a - apex) >= 0) continue;
      add(t.a - apex, t.b - apex, t.c - apex);
    }
    while (!pieces.empty() && pieces.top().bound < best - 5e-5L) {
      const Piece piece = pieces.top();
      pieces.pop();
      const auto middle = [](const RealVec& a, const RealVec& b) {
        return Real{0.5} * (a - (RealVec{0, 0, 0} - b));
      };
      const RealVec ab = middle(piece.a, piece.b);
      const RealVec bc = middle(piece.b, piece.c);
      const RealVec ca = middle(piece.c, piece.a);
      add(piece.a, ab, ca);
      add(ab, piece.b, bc);
      add(ca, bc, piece.c);
      add(ab, bc, ca);
    }
    return best;
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
  int Wrong(const World& world, const scene::LaserDef& laser, double limit, bool floats = false) {
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
      RealVec direction = Wide(Rotate(turned, Rotate(mounted, fan.Direction(i))));
      direction = (1 / Norm(direction)) * direction;
      const Real expected = reference.Cast(origin, direction, laser.range, 0);
      const double off = std::fabs(static_cast<double>(ranges[i] - expected));
      ++beams_;
      if (expected < laser.range) ++hits_;
      if (off > limit && reference.PassesAnEdge(origin, direction, 0, floats)) {
        ++near_edges_;
        continue;
      }
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
                << " off but too near an edge; largest error " << worst_ << " m\n";
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

TEST_F(RangeEngineTest, TheNearestPointInAConeIsFoundExactly) {
  int wrong = 0;
  // The reference takes a minute beneath the thread sanitizer, to which one thread is no news.
#if defined(__SANITIZE_THREAD__)
  constexpr int kScenes = 60;
#else
  constexpr int kScenes = 300;
#endif
  for (int i = 0; i < kScenes; ++i) {
    const double size = Uniform(2.0, 8.0);
    scene::World scene = RandomBoxes(size, Integer(0, 10));
    for (int k = Integer(0, 2); k > 0; --k) AddRandomMesh(scene);
    World world(std::move(scene));
    MakeRobots(world, Integer(1, 5), {});
    SetRobots(world);
    const Reference reference(world.scene(), robots_);
    const double half = Uniform(0.01, 1.2);
    const double range = Uniform(0.3, 5.0);
    const Rotation rotation = FromEuler(0, Uniform(-1, 1), Uniform(-4, 4));
    const Vec3 apex{Uniform(0, size), Uniform(0, size), Uniform(0.01, 0.6)};
    const auto [s, c] = SinCos(half);
    const double got = world.rays().Nearest({apex, rotation.x, c, s}, range, 0).distance;
    // Something may just touch the cone, so it is asked for a little wider and a little narrower.
    const auto expected = [&](Real by) {
      return reference.NearestInCone(Wide(apex), Wide(rotation.x), half + by, range, 0);
    };
    if (got >= expected(1e-4L) - 1e-4L && got <= expected(-1e-4L) + 1e-4L) continue;
    ++wrong;
    std::cout << "cone " << i << " gives " << got << ", the reference says "
              << static_cast<double>(expected(0)) << "\n";
  }
  EXPECT_EQ(wrong, 0);
}

TEST_F(RangeEngineTest, LinesOfSightAgreeWithBruteForce) {
  int wrong = 0;
  int free = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = Uniform(2.0, 8.0);
    scene::World scene = RandomBoxes(size, Integer(0, 10));
    AddRandomMesh(scene);
    World world(std::move(scene));
    MakeRobots(world, Integer(0, 5), {});
    SetRobots(world);
    const Reference reference(world.scene(), robots_);
    for (int k = 0; k < 20; ++k) {
      const Vec3 from{Uniform(0, size), Uniform(0, size), Uniform(-0.1, 1)};
      const Vec3 to{Uniform(0, size), Uniform(0, size), Uniform(-0.1, 1)};
      const RealVec way = Wide(to) - Wide(from);
      const Real length = Norm(way);
      const bool expected = reference.Cast(Wide(from), (1 / length) * way, length, -1) >= length;
      if (expected) ++free;
      if (world.LineOfSight(from, to) != expected) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(free, 100);
}

bool HasIsa(const std::string& isa) {
#if defined(__x86_64__)
  if (isa == "sse2") return true;
  if (isa == "sse4.2") return __builtin_cpu_supports("sse4.2");
  if (isa == "avx") return __builtin_cpu_supports("avx");
  if (isa == "avx2") return __builtin_cpu_supports("avx2");
  return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
#else
  return isa.empty();
#endif
}

TEST_F(RangeEngineTest, EveryInstructionSetGivesTheSameBits) {
  for (int i = 0; i < 30; ++i) {
    std::vector<TriangleSet> fixed(2);
    std::vector<TriangleSet> models(1);
    const double size = i % 3 == 0 ? 300.0 : 8.0;
    const auto corner = [&] { return Vec3{Uniform(0, size), Uniform(0, size), Uniform(0, 1)}; };
    for (int k = 0; k < 30; ++k) {
      const Pose2 pose{Uniform(0, size), Uniform(0, size), Uniform(-4, 4)};
      fixed[0].AddPrism(BoxCorners(pose, 0.1 * size, 0.1 * size), 0, 1, {HitKind::kBox, k, 0});
      fixed[1].Add(corner(), corner(), corner(), {HitKind::kMesh, 1, k});
    }
    fixed[1].closed = false;
    models[0].AddPrism(BoxCorners({}, 0.3, 0.2), 0, 1, {HitKind::kRobot, 0, 0});
    const std::vector<int> movers(20, 0);
    std::vector<Placement> placements;
    for (int k = 0; k < 20; ++k) {
      placements.push_back({{Uniform(0, size), Uniform(0, size), 0},
                            FromEuler(Uniform(-1, 1), Uniform(-1, 1), Uniform(-4, 4))});
    }
    std::vector<Ray> rays;
    const Vec3 from{placements[3].position.x, placements[3].position.y, 0.5};
    for (int k = 0; k < 700; ++k) {
      rays.push_back({from, Rotate(FromEuler(0, Uniform(-0.2, 0.2), 0.01 * k), {1, 0, 0})});
    }
    std::vector<RayHit> first;
    for (const std::string isa : {"sse2", "sse4.2", "avx", "avx2", "avx512"}) {
      if (!HasIsa(isa)) continue;
      EmbreeScene triangles(isa);
      triangles.Build(fixed, models, movers, size);
      for (int k = 0; k < 20; ++k) triangles.Place(k, placements[static_cast<std::size_t>(k)]);
      triangles.Commit();
      std::vector<RayHit> hits(rays.size());
      triangles.Trace(rays, size, 3, hits);
      hits.push_back(triangles.Nearest({from, {1, 0, 0}, 0.5, std::sqrt(0.75)}, size, 3));
      if (first.empty()) first = hits;
      for (std::size_t k = 0; k < hits.size(); ++k) {
        EXPECT_EQ(hits[k].distance, first[k].distance) << isa << " beam " << k;
        EXPECT_EQ(hits[k].surface, first[k].surface) << isa << " beam " << k;
      }
    }
  }
}

TEST_F(RangeEngineTest, BothPathsNameWhatTheyHit) {
  int named = 0;
  for (int i = 0; i < 100; ++i) {
    World world(RandomBoxes(Uniform(2.0, 6.0), Integer(1, 20)));
    scene::LaserDef laser = Laser(100, 300, 4.0);
    laser.position.z = Uniform(0, 0.2);
    MakeRobots(world, Integer(1, 6), laser);
    SetRobots(world);
    BeamFan fan(laser);
    const Robot& robot = *robots_[0];
    std::vector<RayHit> planar(fan.count());
    std::vector<RayHit> embree(fan.count());
    world.rays().Force(RayPath::kPlanar);
    world.rays().ScanHits(fan, robot.pose(), robot.model().origin_height, 0, planar);
    world.rays().Force(RayPath::kEmbree);
    world.rays().ScanHits(fan, robot.pose(), robot.model().origin_height, 0, embree);
    for (std::size_t k = 0; k < planar.size(); ++k) {
      EXPECT_NEAR(planar[k].distance, embree[k].distance, 1e-9);
      EXPECT_EQ(planar[k].surface, embree[k].surface) << "seed " << seed_ << " beam " << k;
      if (planar[k].surface.kind != HitKind::kNothing) ++named;
    }
  }
  EXPECT_GT(named, 1000);
}

scene::World OneBox() {
  scene::World world;
  world.size_x = world.size_y = 4.0;
  scene::Box box;
  box.id = 7;
  box.pose = {2.0, 2.0, 0.0};
  box.size_x = 1.0;
  box.size_y = 0.5;
  box.height = 0.5;
  box.dynamic = true;
  world.boxes.push_back(box);
  return world;
}

// What a ray meets that looks along `direction`.
RayHit Look(const World& world, const Vec3& from, double yaw, double pitch, double range = 10.0) {
  scene::LaserDef laser = Laser(2, 1e-12, range);
  laser.position = {};
  laser.yaw = yaw;
  laser.pitch = pitch;
  BeamFan fan(laser);
  std::vector<RayHit> hits(fan.count());
  world.rays().ScanHits(fan, {from.x, from.y, 0.0}, from.z, -1, hits);
  return hits[0];
}

TEST(RangeEngine, SurfacesAreNamedAsDocumented) {
  World world(OneBox());
  for (const RayPath path : {RayPath::kPlanar, RayPath::kEmbree}) {
    world.rays().Force(path);
    EXPECT_EQ(Look(world, {2, 3, 0.1}, -kPi / 2, 0).surface, (Surface{HitKind::kBox, 7, 0}));
    EXPECT_EQ(Look(world, {1, 2, 0.1}, 0, 0).surface, (Surface{HitKind::kBox, 7, 1}));
    EXPECT_EQ(Look(world, {2, 1, 0.1}, kPi / 2, 0).surface, (Surface{HitKind::kBox, 7, 2}));
    EXPECT_EQ(Look(world, {3, 2, 0.1}, kPi, 0).surface, (Surface{HitKind::kBox, 7, 3}));
    EXPECT_EQ(Look(world, {3, 2, 0.1}, 0, 0).surface, Surface{});
    EXPECT_EQ(Look(world, {3, 2, 0.1}, 0, 0).distance, 10.0);
  }
  world.rays().Force(RayPath::kAuto);
  EXPECT_EQ(Look(world, {2.1, 2, 1.5}, 0, kPi / 2).surface, (Surface{HitKind::kBox, 7, 4}));
  EXPECT_NEAR(Look(world, {2.1, 2, 1.5}, 0, kPi / 2).distance, 1.0, 1e-12);
  EXPECT_EQ(Look(world, {3.5, 2, 1.5}, 0, kPi / 2).surface, (Surface{HitKind::kFloor, 0, 0}));
  EXPECT_NEAR(Look(world, {3.5, 2, 1.5}, 0, kPi / 2).distance, 1.5, 1e-12);
  // Beside the floor there is nothing.
  EXPECT_EQ(Look(world, {4.5, 2, 1.5}, 0, kPi / 2).surface, Surface{});
}

TEST(RangeEngine, AScannerWithinABoxLooksOutOfIt) {
  World world(OneBox());
  for (const RayPath path : {RayPath::kPlanar, RayPath::kEmbree}) {
    world.rays().Force(path);
    EXPECT_EQ(Look(world, {2, 2, 0.1}, 0, 0).distance, 10.0);
  }
}

TEST(RangeEngine, ABoxThatGoesDownIsNoLongerSeen) {
  World world(OneBox());
  for (const RayPath path : {RayPath::kPlanar, RayPath::kEmbree}) {
    world.rays().Force(path);
    world.SetRaised(7, false);
    EXPECT_EQ(Look(world, {1, 2, 0.1}, 0, 0).distance, 10.0);
    world.SetRaised(7, true);
    EXPECT_NEAR(Look(world, {1, 2, 0.1}, 0, 0).distance, 0.5, 1e-12);
  }
}

TEST(RangeEngine, RobotsAreSeenWhereTheyAreNow) {
  World world(OneBox());
  scene::RobotDef def;
  def.pose = {3.5, 2.0, 0.0};
  Robot robot(def, 0);
  world.SetRobots({&robot});
  for (const RayPath path : {RayPath::kPlanar, RayPath::kEmbree}) {
    world.rays().Force(path);
    for (const double x : {3.5, 3.2, 1e4}) {
      robot.Place({x, 2.0, 0.0});
      world.RobotsMoved();
      const RayHit hit = Look(world, {2.7, 2, 0.03}, 0, 0, 2e4);
      EXPECT_NEAR(hit.distance, x - 2.7 - 0.087, 1e-9)
          << static_cast<int>(path) << " " << hit.surface.surface;
      EXPECT_EQ(hit.surface.kind, HitKind::kRobot);
    }
  }
}

TEST(RangeEngine, OfTwoSurfacesInOnePlaceTheFirstByNameIsSeen) {
  for (const bool swapped : {false, true}) {
    scene::World scene = OneBox();
    scene::Box other = scene.boxes[0];
    other.id = 3;
    other.size_y = 0.4;
    scene.boxes.insert(swapped ? scene.boxes.begin() : scene.boxes.end(), other);
    World world(scene);
    world.rays().Force(RayPath::kEmbree);
    EXPECT_EQ(Look(world, {1, 2, 0.1}, 0, 0).surface, (Surface{HitKind::kBox, 3, 1}));
  }
}

TEST(RangeEngine, ChoosesThePlanarPathWhereItCan) {
  scene::World scene = OneBox();
  scene::Mesh mesh;
  mesh.id = 8;
  mesh.vertices = {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 1.0}};
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  World world(scene);
  scene::LaserDef laser;
  EXPECT_EQ(world.rays().Choose(BeamFan(laser), 0.2), RayPath::kPlanar);
  EXPECT_EQ(world.rays().Choose(BeamFan(laser), 0.6), RayPath::kEmbree);  // the mesh is there
  laser.pitch = 0.1;
  EXPECT_EQ(world.rays().Choose(BeamFan(laser), 0.2), RayPath::kEmbree);
  laser.pitch = 0.0;
  laser.layers = 2;
  EXPECT_EQ(world.rays().Choose(BeamFan(laser), 0.2), RayPath::kEmbree);
  world.rays().Force(RayPath::kPlanar);
  EXPECT_THROW(world.rays().Choose(BeamFan(laser), 0.2), Error);
}

TEST(RangeEngine, AnyNumberOfThreadsMayAsk) {
  World world(OneBox());
  std::vector<std::unique_ptr<Robot>> robots;
  std::vector<const Robot*> seen;
  for (int i = 0; i < 4; ++i) {
    scene::RobotDef def;
    def.pose = {3.0, 0.5 + i, 0.0};
    robots.push_back(std::make_unique<Robot>(def, i));
    seen.push_back(robots.back().get());
  }
  world.SetRobots(seen);
  world.rays().Force(RayPath::kEmbree);
  for (int tick = 0; tick < 20; ++tick) {
    std::vector<std::thread> threads;
    std::vector<double> distances(4);
    for (std::size_t i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] {
        distances[i] = Look(world, {1.0, 0.5 + static_cast<double>(i), 0.03}, 0, 0).distance;
      });
    }
    for (std::thread& thread : threads) thread.join();
    const double x = robots[0]->pose().x;
    EXPECT_NEAR(distances[0], x - 1.0 - 0.087, 1e-9);
    for (const auto& robot : robots) robot->Place({x + 0.01, robot->pose().y, 0.0});
    world.RobotsMoved();
  }
}

// MORSE's arithmetic of beams (specs: morse.md H.4).

TEST(BeamFan, LayersAreMorses) {
  scene::LaserDef laser = Laser(3, 100.0, 30.0);
  laser.resolution_deg = 50.0;
  laser.layers = 4;
  laser.layer_separation = 0.8;
  laser.layer_offset = 0.125;
  const BeamFan fan(laser);
  ASSERT_EQ(fan.count(), 12U);
  const double elevations[] = {1.2, 0.4, -0.4, -1.2};
  for (std::size_t layer = 0; layer < 4; ++layer) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double bearing = -50.0 + 50.0 * static_cast<double>(i) + (layer % 2 == 0 ? 0.125 : 0.0);
      // The vertex (cos a, sin a, sin v), made a unit vector.
      const double rise = std::sin(Radians(elevations[layer]));
      const double length = std::sqrt(1.0 + rise * rise);
      const Vec3 direction = fan.Direction(3 * layer + i);
      EXPECT_NEAR(direction.x, std::cos(Radians(bearing)) / length, 1e-15);
      EXPECT_NEAR(direction.y, std::sin(Radians(bearing)) / length, 1e-15);
      EXPECT_NEAR(direction.z, rise / length, 1e-15);
    }
  }
}

TEST(BeamFan, ALoneLayerIsLevelAndNotTurned) {
  const scene::LaserDef laser;
  const BeamFan fan(laser);
  EXPECT_TRUE(fan.upright());
  EXPECT_EQ(fan.Direction(0).z, 0.0);
  EXPECT_NEAR(std::atan2(fan.Direction(0).y, fan.Direction(0).x), -Radians(135.0), 1e-12);
}

// The state of a robot that stands before a contact, with a sensor on its rim.
TEST(RangeEngine, ASensorThatAllButTouchesAWallSeesIt) {
  std::mt19937_64 random(4);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const double extent : {4.0, 100.0, 1000.0}) {
    for (int i = 0; i < 300; ++i) {
      const Pose2 wall{uniform(0.2, 0.8) * extent, uniform(0.2, 0.8) * extent, uniform(-4, 4)};
      const auto corners = BoxCorners(wall, 0.4, 1.0);
      TriangleSet set;
      set.AddPrism(corners, 0.0, 1.0, {HitKind::kBox, 1, 0});
      EmbreeScene triangles;
      triangles.Build({set}, {}, {}, extent);
      triangles.Commit();
      const double off = std::pow(10.0, uniform(-9, -5));
      const Vec2 at = Transform(wall, {-0.2 - off, uniform(-0.4, 0.4)});
      const auto [s, c] = SinCos(wall.yaw);
      const Ray ray{{at.x, at.y, 0.5}, {c, s, 0.0}};
      RayHit hit;
      triangles.Trace({&ray, 1}, 5.0, -1, {&hit, 1});
      ASSERT_NEAR(hit.distance, off, 1e-9) << "extent " << extent;
      ASSERT_GE(hit.distance, 0.0);
      const Vec3 behind = ray.origin + 0.1 * ray.direction;
      ASSERT_TRUE(triangles.IsBlocked(ray.origin, behind));

      PlanarWorld planar;
      planar.Add(corners);
      planar.Finish();
      PlanarScanner scanner(1, 0.0, 0.1, 5.0);
      double range = 0.0;
      scanner.Scan({at.x, at.y, wall.yaw}, planar, {}, -1, {&range, 1});
      ASSERT_NEAR(range, off, 1e-9);
    }
  }
  // So near that the edge and the sensor make no area.
  PlanarWorld planar;
  planar.Add(BoxCorners({1.0, 0.0, 0.0}, 0.2, 1.0));
  planar.Finish();
  PlanarScanner scanner(1, 0.0, 0.1, 5.0);
  double range = 0.0;
  scanner.Scan({0.9 - 1e-13, 0.1, 0.0}, planar, {}, -1, {&range, 1});
  EXPECT_NEAR(range, 0.0, 1e-9);
}

// A long low wall's triangles end in thin tips; this ray goes through one closely beside its edge.
TEST(RangeEngine, NoRaySlipsThroughBesideATipWhateverTheInstructionSet) {
  const double s = std::sin(0.3);
  const double c = std::cos(0.3);
  const auto at = [&](double x, double y) { return Vec2{3 + c * x - s * y, 10 + s * x + c * y}; };
  const Vec2 outline[] = {at(90, 0.2), at(0, 0.2), at(0, 0), at(90, 0)};
  TriangleSet set;
  set.AddPrism(outline, 0.0, 0.13, {HitKind::kBox, 1, 0});
  const Ray ray{{88.07845788656158, 36.212346599673054, 0.48531075730506085},
                {0.86056472647299431, 0.37009975761418612, -0.3499350239178432}};
  for (const char* const isa : {"sse2", "sse4.2", "avx2"}) {
    if (std::string(isa) == "avx2" && !__builtin_cpu_supports("avx2")) continue;
    EmbreeScene triangles(isa);
    triangles.Build({set}, {}, {}, 100.0);
    triangles.Commit();
    RayHit hit;
    triangles.Trace({&ray, 1}, 10.0, -1, {&hit, 1});
    EXPECT_NEAR(hit.distance, 1.01548274, 1e-6) << isa;
  }
}

}  // namespace
}  // namespace ccmorse::sim
