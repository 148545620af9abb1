// `ccmorse bench embree`: the range engine's general path against Embree itself, in one scene, on
// one thread: rays a second of lidar fans among many robots. It is a program of its own, which
// `ccmorse` executes, so that no Embree type has to leave src/sim/rays for the comparison.
//
// The scene: 2,004 triangles that stand in 100 x 100 m, four walls and 163 boxes, and 1,000 robots
// of 256 triangles; fans of 256 rays over 270 degrees, 30 m, each from the middle of another robot.

#include <embree3/rtcore.h>
#include <fmt/core.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "sim/rays/embree_scene.h"

namespace {

using namespace ccmorse;  // NOLINT(google-build-using-namespace): a program of one file
using Clock = std::chrono::steady_clock;

constexpr int kRobots = 1000;
constexpr double kRange = 30.0;                // m
constexpr double kRobotRadius = 0.3;           // m
constexpr double kSensorHeight = 0.3;          // m
constexpr std::size_t kRays = 256;             // a fan
constexpr const char* kInstructions = "avx2";  // what ours takes, too, where there is AVX2

struct BenchScene {
  sim::TriangleSet fixed;
  sim::TriangleSet robot;
  std::vector<Pose2> robots;
};

void AddBox(const Pose2& pose, double x, double y, sim::TriangleSet& set) {
  set.AddPrism(BoxCorners(pose, x, y), 0.0, 1.0, {sim::HitKind::kBox, 1, 0});
}

BenchScene MakeScene() {
  std::mt19937 random(1);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  BenchScene scene;
  for (const Pose2& wall :
       {Pose2{50, 0, 0}, Pose2{50, 100, 0}, Pose2{0, 50, kPi / 2}, Pose2{100, 50, kPi / 2}}) {
    AddBox(wall, 100.0, 0.1, scene.fixed);
  }
  for (int i = 0; i < 163; ++i) {
    AddBox({uniform(2, 98), uniform(2, 98), uniform(0, 6)}, uniform(0.2, 3), uniform(0.2, 3),
           scene.fixed);
  }
  // A round hull: 64 sides of two triangles, and a lid and a floor of 64 each around their middles.
  constexpr int kSides = 64;
  const auto at = [](int i, double z) {
    const auto [s, c] = SinCos(2.0 * kPi * i / kSides);
    return Vec3{kRobotRadius * c, kRobotRadius * s, z};
  };
  for (int i = 0; i < kSides; ++i) {
    const sim::Surface surface{sim::HitKind::kRobot, 0, i};
    scene.robot.Add(at(i, 0.05), at(i + 1, 0.05), at(i + 1, 0.5), surface);
    scene.robot.Add(at(i, 0.05), at(i + 1, 0.5), at(i, 0.5), surface);
    scene.robot.Add({0, 0, 0.5}, at(i, 0.5), at(i + 1, 0.5), surface);
    scene.robot.Add({0, 0, 0.05}, at(i + 1, 0.05), at(i, 0.05), surface);
  }
  for (int i = 0; i < kRobots; ++i) {
    scene.robots.push_back({uniform(2, 98), uniform(2, 98), uniform(0, 6)});
  }
  return scene;
}

// The fan's directions in the sensor's frame.
std::array<Vec2, kRays> Fan() {
  std::array<Vec2, kRays> fan;
  for (std::size_t i = 0; i < kRays; ++i) {
    const auto [s, c] = SinCos(Radians(-135.0 + 270.0 * static_cast<double>(i) / (kRays - 1)));
    fan[i] = {c, s};
  }
  return fan;
}

template <typename Emit>
void TurnFan(const std::array<Vec2, kRays>& fan, const Pose2& sensor, Emit emit) {
  const auto [s, c] = SinCos(sensor.yaw);
  for (std::size_t i = 0; i < kRays; ++i) {
    emit(i, Vec3{c * fan[i].x - s * fan[i].y, s * fan[i].x + c * fan[i].y, 0.0});
  }
}

// rtcIntersect1M on the same triangles, with nothing of ours. As it cannot leave the sensor's own
// robot out, its rays begin outside.
class RawScene {
 public:
  explicit RawScene(const BenchScene& scene) {
    device_ = rtcNewDevice((std::string("threads=1,isa=") + kInstructions).c_str());
    robot_ = rtcNewScene(device_);
    Attach(scene.robot, robot_);
    rtcCommitScene(robot_);
    scene_ = rtcNewScene(device_);
    for (const Pose2& pose : scene.robots) {
      const RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
      rtcSetGeometryInstancedScene(instance, robot_);
      const auto [s, c] = SinCos(pose.yaw);
      const std::array<double, 12> matrix = {c, s, 0, -s, c, 0, 0, 0, 1, pose.x, pose.y, 0};
      std::array<float, 12> rounded{};
      for (std::size_t i = 0; i < 12; ++i) rounded[i] = static_cast<float>(matrix[i]);
      rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, rounded.data());
      rtcCommitGeometry(instance);
      rtcAttachGeometry(scene_, instance);
      rtcReleaseGeometry(instance);
    }
    Attach(scene.fixed, scene_);
    rtcCommitScene(scene_);
  }
  ~RawScene() {
    rtcReleaseScene(scene_);
    rtcReleaseScene(robot_);
    rtcReleaseDevice(device_);
  }
  RawScene(const RawScene&) = delete;
  RawScene& operator=(const RawScene&) = delete;

  RTCScene scene() const { return scene_; }

 private:
  void Attach(const sim::TriangleSet& set, RTCScene into) {
    const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, set.corners.size()));
    for (const Vec3& corner : set.corners) {
      *corners++ = static_cast<float>(corner.x);
      *corners++ = static_cast<float>(corner.y);
      *corners++ = static_cast<float>(corner.z);
    }
    auto* indexes = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, set.size()));
    for (std::uint32_t i = 0; i < 3 * set.size(); ++i) indexes[i] = i;
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(into, mesh);
    rtcReleaseGeometry(mesh);
  }

  RTCDevice device_;
  RTCScene robot_;
  RTCScene scene_;
};

// One fan by Embree alone.
class RawFans {
 public:
  explicit RawFans(const BenchScene& scene) : raw_(scene), rays_(kRays) {}

  void Scan(const std::array<Vec2, kRays>& fan, const Pose2& sensor, int /*self*/) {
    TurnFan(fan, sensor, [&](std::size_t i, const Vec3& direction) {
      rays_[i].ray = {static_cast<float>(sensor.x),
                      static_cast<float>(sensor.y),
                      static_cast<float>(kSensorHeight),
                      static_cast<float>(kRobotRadius + 0.001),
                      static_cast<float>(direction.x),
                      static_cast<float>(direction.y),
                      0.0F,
                      0.0F,
                      static_cast<float>(kRange),
                      0xFFFFFFFFU,
                      0,
                      0};
      rays_[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rays_[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    });
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1M(raw_.scene(), &context, rays_.data(), kRays, sizeof(RTCRayHit));
  }

 private:
  RawScene raw_;
  std::vector<RTCRayHit> rays_;
};

// One fan by the range engine: distances in double, and what was hit.
class EngineFans {
 public:
  explicit EngineFans(const BenchScene& scene) : rays_(kRays), hits_(kRays) {
    triangles_.Build({scene.fixed}, {scene.robot}, std::vector<int>(scene.robots.size(), 0), 100.0);
    Move(scene, 0.0);
  }

  void Move(const BenchScene& scene, double shift) {
    for (std::size_t i = 0; i < scene.robots.size(); ++i) {
      const Pose2& pose = scene.robots[i];
      triangles_.Place(static_cast<int>(i),
                       {{pose.x + shift, pose.y, 0.0}, FromEuler(0.0, 0.0, pose.yaw)});
    }
    triangles_.Commit();
  }

  void Scan(const std::array<Vec2, kRays>& fan, const Pose2& sensor, int self) {
    TurnFan(fan, sensor, [&](std::size_t i, const Vec3& direction) {
      rays_[i] = {{sensor.x, sensor.y, kSensorHeight}, direction};
    });
    triangles_.Trace(rays_, kRange, self, hits_);
  }

 private:
  sim::EmbreeScene triangles_;
  std::vector<sim::Ray> rays_;
  std::vector<sim::RayHit> hits_;
};

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Seconds for one fan from each robot.
template <typename Fans>
double Round(const BenchScene& scene, const std::array<Vec2, kRays>& fan, Fans& fans) {
  const auto start = Clock::now();
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    fans.Scan(fan, scene.robots[i], static_cast<int>(i));
  }
  return Since(start);
}

int Run(double seconds, bool json) {
  const BenchScene scene = MakeScene();
  const auto fan = Fan();
  RawFans raw(scene);
  EngineFans engine(scene);
  double raw_seconds = 0.0;
  double engine_seconds = 0.0;
  double move_seconds = 0.0;
  int rounds = 0;
  // In turns, so that whatever else the machine does falls on both.
  for (const auto start = Clock::now(); rounds == 0 || Since(start) < 2.0 * seconds; ++rounds) {
    raw_seconds += Round(scene, fan, raw);
    engine_seconds += Round(scene, fan, engine);
    const auto moving = Clock::now();
    engine.Move(scene, 0.0);
    move_seconds += Since(moving);
  }
  const double rays = static_cast<double>(rounds) * kRobots * kRays;
  const double rate = rays / engine_seconds;
  const double raw_rate = rays / raw_seconds;
  const double move = move_seconds / rounds;
  if (json) {
    fmt::print("{}\n", Json(Json::Object{{"rays_per_s", rate},
                                         {"raw_rays_per_s", raw_rate},
                                         {"move_1000_robots_us", move * 1e6}})
                           .Dump());
  } else {
    fmt::print("lidar fans among 1,000 robots on one core, rays per second\n");
    fmt::print("range engine, exact in double  {:.2f} M, {:.0f} % of Embree alone\n", rate * 1e-6,
               100.0 * rate / raw_rate);
    fmt::print("Embree alone                   {:.2f} M\n", raw_rate * 1e-6);
    fmt::print("moving all robots              {:.0f} us\n", move * 1e6);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: ccmorse bench embree\n");
    return 2;
  }
  try {
    return Run(std::atof(argv[2]), std::string(argv[3]) == "json");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ccmorse bench embree: %s\n", error.what());
  }
  return 1;
}
