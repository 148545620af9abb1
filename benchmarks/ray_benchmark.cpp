// The range engine's general path against Embree itself, in one scene, on one thread: how many rays
// a second of lidar fans (specs: dependencies.md 2c; issue 3). Run: build/release/bin/ray_benchmark
//
// The scene: 2,004 triangles that stand in 100 x 100 m, four walls and 163 boxes, and N robots of
// 256 triangles; fans of 256 rays over 270 degrees, 30 m, each from the middle of another robot.

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "base/polygon.h"
#include "base/trig.h"
#include "sim/rays/embree_scene.h"

namespace {

using namespace ccmorse;  // NOLINT(google-build-using-namespace): a program of one file

constexpr double kRange = 30.0;                // m
constexpr double kRobotRadius = 0.3;           // m
constexpr double kSensorHeight = 0.3;          // m
constexpr std::size_t kRays = 256;             // a fan
constexpr const char* kInstructions = "avx2";  // what ours takes, too, where there is AVX2

struct BenchScene {
  sim::TriangleSet fixed;
  sim::TriangleSet robot;
  std::vector<Pose2> robots;
  std::vector<Pose2> sensors;  // where fans start from, 1000 of them
};

void AddBox(const Pose2& pose, double x, double y, sim::TriangleSet& set) {
  set.AddPrism(BoxCorners(pose, x, y), 0.0, 1.0, {sim::HitKind::kBox, 1, 0});
}

BenchScene MakeScene(int robots) {
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
  for (int i = 0; i < robots; ++i) {
    scene.robots.push_back({uniform(2, 98), uniform(2, 98), uniform(0, 6)});
  }
  for (int i = 0; i < 1000; ++i) {
    scene.sensors.push_back(robots > 0 ? scene.robots[static_cast<std::size_t>(i % robots)]
                                       : Pose2{uniform(2, 98), uniform(2, 98), uniform(0, 6)});
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

void LidarRawEmbree(benchmark::State& state) {
  const BenchScene scene = MakeScene(static_cast<int>(state.range(0)));
  const RawScene raw(scene);
  const auto fan = Fan();
  std::vector<RTCRayHit> rays(kRays);
  std::size_t next = 0;
  for (auto _ : state) {
    const Pose2 sensor = scene.sensors[next++ % scene.sensors.size()];
    TurnFan(fan, sensor, [&](std::size_t i, const Vec3& direction) {
      rays[i].ray = {static_cast<float>(sensor.x),
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
      rays[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
      rays[i].hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    });
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect1M(raw.scene(), &context, rays.data(), kRays, sizeof(RTCRayHit));
    benchmark::DoNotOptimize(rays.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRays));
}

void LidarRangeEngine(benchmark::State& state) {
  const BenchScene scene = MakeScene(static_cast<int>(state.range(0)));
  sim::EmbreeScene triangles;
  const std::vector<int> models(scene.robots.size(), 0);
  triangles.Build({scene.fixed}, {scene.robot}, models, 100.0);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const Pose2& pose = scene.robots[i];
    triangles.Place(static_cast<int>(i), {{pose.x, pose.y, 0.0}, FromEuler(0.0, 0.0, pose.yaw)});
  }
  triangles.Commit();
  const auto fan = Fan();
  std::vector<sim::Ray> rays(kRays);
  std::vector<sim::RayHit> hits(kRays);
  std::size_t next = 0;
  for (auto _ : state) {
    const std::size_t from = next++ % scene.sensors.size();
    const Pose2 sensor = scene.sensors[from];
    TurnFan(fan, sensor, [&](std::size_t i, const Vec3& direction) {
      rays[i] = {{sensor.x, sensor.y, kSensorHeight}, direction};
    });
    const int self = scene.robots.empty() ? -1 : static_cast<int>(from % scene.robots.size());
    triangles.Trace(rays, kRange, self, hits);
    benchmark::DoNotOptimize(hits.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRays));
}

// Moving all robots, before the first scan of a tick.
void MoveRobots(benchmark::State& state) {
  const BenchScene scene = MakeScene(static_cast<int>(state.range(0)));
  sim::EmbreeScene triangles;
  const std::vector<int> models(scene.robots.size(), 0);
  triangles.Build({scene.fixed}, {scene.robot}, models, 100.0);
  double shift = 0.0;
  for (auto _ : state) {
    shift = shift > 1.0 ? 0.0 : shift + 0.001;
    for (std::size_t i = 0; i < scene.robots.size(); ++i) {
      const Pose2& pose = scene.robots[i];
      triangles.Place(static_cast<int>(i),
                      {{pose.x + shift, pose.y, 0.0}, FromEuler(0.0, 0.0, pose.yaw)});
    }
    triangles.Commit();
  }
}

BENCHMARK(LidarRawEmbree)->Arg(0)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(LidarRangeEngine)->Arg(0)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);
BENCHMARK(MoveRobots)->Arg(10)->Arg(1000)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
