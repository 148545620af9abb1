#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "render/denoise.h"
#include "render/path_tracer.h"
#include "render/simulation_picture.h"
#include "scene/scenario.h"

namespace ccmorse::render {
namespace {

void ExpectNear(const Vec3& got, const Vec3& wanted, double tolerance) {
  EXPECT_NEAR(got.x, wanted.x, tolerance);
  EXPECT_NEAR(got.y, wanted.y, tolerance);
  EXPECT_NEAR(got.z, wanted.z, tolerance);
}

// A matt floor of 20 x 20 m around the origin, and nothing that shines.
constexpr Vec3 kFloor{0.5, 0.4, 0.3};
void AddFloor(PictureScene& scene) {
  const int matt = scene.AddMaterial({kFloor, 0.0, 0.5, false});
  scene.AddTriangle({Vec3{-10, -10, 0}, Vec3{10, -10, 0}, Vec3{10, 10, 0}}, matt);
  scene.AddTriangle({Vec3{-10, -10, 0}, Vec3{10, 10, 0}, Vec3{-10, 10, 0}}, matt);
  scene.sky = 0.0;
}

// What a camera 3 m above the origin sees in its middle.
Vec3 LightAtOrigin(PictureScene& scene, int samples) {
  scene.Build(10.0);
  RenderOptions options;
  options.width = 1;
  options.height = 1;
  options.samples = samples;
  Camera camera = Camera::LookAt({0, 0, 3}, {0, 0, 0});
  camera.fov_deg = 0.1;
  return TracePaths(scene, camera, options).light[0];
}

// The colour of what a camera 2 m above `at` sees of a simulation in its middle; `fov`: degrees.
Vec3 AlbedoFromAbove(const sim::Simulation& simulation, const Vec3& at, double fov,
                     const PictureOptions& shown = {}) {
  PictureScene scene;
  ShowSimulation(simulation, shown, scene);
  scene.Build(10.0);
  RenderOptions options;
  options.width = options.height = 1;
  options.samples = 1;
  Camera camera = Camera::LookAt(at + Vec3{0, 0, 2}, at);
  camera.fov_deg = fov;
  return TracePaths(scene, camera, options).albedo[0];
}

TEST(Camera, LooksWhereItIsTold) {
  const Camera camera = Camera::LookAt({1, 1, 1}, {4, 1, 1});
  ExpectNear(camera.Direction(0, 0), {1, 0, 0}, 1e-12);
  EXPECT_LT(camera.Direction(0.5, 0).y, 0.0);  // right of someone who looks along +x
  EXPECT_GT(camera.Direction(0, 0.5).z, 0.0);
  // The upper edge of the picture is half of the field of view off the middle.
  EXPECT_NEAR(std::acos(Dot(camera.Direction(0, 1), camera.Direction(0, 0))),
              Radians(camera.fov_deg / 2.0), 1e-12);
  EXPECT_THROW(Camera::LookAt({1, 2, 3}, {1, 2, 3}), Error);
}

TEST(Camera, StraightDownHasTheWorldsYUp) {
  const Camera camera = Camera::LookAt({1, 1, 5}, {1, 1, 0});
  ExpectNear(camera.Direction(0, 0), {0, 0, -1}, 1e-12);
  EXPECT_GT(camera.Direction(0, 0.5).y, 0.0);
  EXPECT_GT(camera.Direction(0.5, 0).x, 0.0);
}

TEST(PathTracer, ASunsLightGoesWithTheCosine) {
  for (const double angle : {0.0, 0.5, 1.2}) {
    PictureScene scene;
    AddFloor(scene);
    const auto [s, c] = SinCos(angle);
    scene.suns.push_back({{s, 0, c}, 0.8, 0.0});
    ExpectNear(LightAtOrigin(scene, 4), 0.8 * c * kFloor, 1e-9);
  }
}

TEST(PathTracer, ASpotsLightGoesWithTheSquareOfItsDistance) {
  for (const double height : {1.0, 2.0}) {
    PictureScene scene;
    AddFloor(scene);
    scene.spots.push_back({{0, 0, height}, 0.6, 0.0});
    // The lamp itself is nothing to be seen.
    ExpectNear(LightAtOrigin(scene, 4), (0.6 / (height * height)) * kFloor, 1e-4);
  }
}

TEST(PathTracer, TheSkyLightsAnOpenFloorByItsMean) {
  PictureScene scene;
  AddFloor(scene);
  scene.sky = 0.5;
  // The mean of its colours, weighed by the cosine: straight up counts two thirds.
  const double up = 0.25 * 2.0 / 3.0;
  const Vec3 mean{1.0 - up + up * 0.8, 1.0 - up + up * 0.95, 1.0 - up + up * 1.25};
  const Vec3 wanted{0.5 * mean.x * kFloor.x, 0.5 * mean.y * kFloor.y, 0.5 * mean.z * kFloor.z};
  ExpectNear(LightAtOrigin(scene, 4096), wanted, 0.002);
}

TEST(PathTracer, ABoxCastsAShadowWithASoftEdge) {
  PictureScene scene;
  AddFloor(scene);
  const auto [s, c] = SinCos(0.7);
  scene.suns.push_back({{s, 0, c}, 1.0, 0.05});
  // Its top edge is where the middle of the sun is seen from the origin.
  const double height = 0.5;
  const double edge = height * s / c;
  const int black = scene.AddMaterial({{0, 0, 0}, 0.0, 0.5, false});
  const std::vector<Vec2> outline = {{edge, -2}, {edge + 1, -2}, {edge + 1, 2}, {edge, 2}};
  scene.AddPrism({}, outline, 0.0, height, 0.0, black);
  EXPECT_NEAR(LightAtOrigin(scene, 1024).x, 0.5 * c * kFloor.x, 0.01);

  PictureScene covered;
  AddFloor(covered);
  covered.suns = scene.suns;
  const std::vector<Vec2> around = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  covered.AddPrism({}, around, 0.5, 0.6, 0.0, covered.AddMaterial({{0, 0, 0}, 0.0, 0.5, false}));
  covered.Build(10.0);
  RenderOptions options;
  options.width = options.height = 1;
  Camera camera = Camera::LookAt({3, 0, 0.3}, {0, 0, 0});  // looks under it
  camera.fov_deg = 0.1;
  ExpectNear(TracePaths(covered, camera, options).light[0], {}, 1e-12);
}

TEST(PathTracer, LightGoesFromSurfaceToSurface) {
  // A red wall beside the floor makes it red; without a second surface it would not.
  PictureScene scene;
  AddFloor(scene);
  scene.suns.push_back({{0.6, 0, 0.8}, 1.0, 0.0});
  const int red = scene.AddMaterial({{0.9, 0.0, 0.0}, 0.0, 0.5, false});
  const std::vector<Vec2> wall = {{-1.1, -2}, {-0.5, -2}, {-0.5, 2}, {-1.1, 2}};
  scene.AddPrism({}, wall, 0.0, 2.0, 0.0, red);
  const Vec3 light = LightAtOrigin(scene, 1024);
  EXPECT_GT(light.x, 0.8 * kFloor.x + 0.02);
  EXPECT_NEAR(light.y, 0.8 * kFloor.y, 1e-3);
}

TEST(PathTracer, AMetalShowsWhatItMirrors) {
  PictureScene scene;
  scene.sky = 1.0;
  const int mirror = scene.AddMaterial({{1.0, 0.5, 0.25}, 0.0, 0.02, true});
  scene.AddTriangle({Vec3{-9, -9, 0}, Vec3{9, -9, 0}, Vec3{0, 9, 0}}, mirror);
  const Vec3 light = LightAtOrigin(scene, 64);  // of the sky straight above
  ExpectNear(light, {0.95, 0.9875 * 0.5, 1.0625 * 0.25}, 0.01);
}

scene::Scenario SyrotekWith(const std::string& more) {
  return scene::ParseScenario("{\"world\": \"syrotek\"" + more + "}", "test.json");
}

TEST(RenderedPicture, DoesNotDependOnTheNumberOfThreads) {
  const sim::Simulation simulation(SyrotekWith(""));
  PictureScene scene;
  ShowSimulation(simulation, {}, scene);
  scene.Build(10.0);
  const Camera camera = FindCamera(simulation, "scene", 1.5);
  RenderOptions options;
  options.width = 60;
  options.height = 40;
  options.samples = 2;
  options.threads = 1;
  const Image one = RenderPicture(scene, camera, options);
  options.threads = 3;
  EXPECT_EQ(one.pixels, RenderPicture(scene, camera, options).pixels);
}

TEST(RenderedPicture, SmoothingComesNearerToManySamples) {
  const sim::Simulation simulation(SyrotekWith(""));
  PictureScene scene;
  ShowSimulation(simulation, {}, scene);
  scene.Build(10.0);
  const Camera camera = FindCamera(simulation, "follow", 1.5);
  RenderOptions options;
  options.width = 96;
  options.height = 64;
  options.samples = 256;
  const Radiance truth = TracePaths(scene, camera, options);
  options.samples = 8;
  options.seed = 2;
  Radiance few = TracePaths(scene, camera, options);
  // The median, as pixels with an edge in them are smoothed by more samples only.
  const auto error = [&truth](const Radiance& radiance) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < truth.light.size(); ++i) {
      const Vec3 off = radiance.light[i] - truth.light[i];
      errors.push_back(std::sqrt(Dot(off, off)));
    }
    std::nth_element(errors.begin(), errors.begin() + 3072, errors.end());
    return errors[3072];
  };
  const double rough = error(few);
  Denoise(few, 1);
  EXPECT_LT(error(few), 0.6 * rough);
}

TEST(RenderedPicture, ShowsTheCanvasWhereItLies) {
  sim::Simulation simulation(SyrotekWith(R"(, "robots": [])"));
  sim::Canvas& canvas = simulation.canvas();
  const int x = canvas.width() / 2 + 10;
  const int y = canvas.height() / 2 - 20;
  for (int dx = -3; dx <= 3; ++dx) {
    for (int dy = -3; dy <= 3; ++dy) canvas.SetPixel(x + dx, y + dy, {0, 0, 255});
  }
  const Vec3 at{(x + 0.5) * canvas.cell_size(), (y + 0.5) * canvas.cell_size(), 0.0};
  const Vec3 drawn = AlbedoFromAbove(simulation, at, 0.1);
  EXPECT_GT(drawn.z, 0.5);
  EXPECT_LT(drawn.x, 0.01);
  EXPECT_GT(AlbedoFromAbove(simulation, at, 0.1, {false, false}).x, 0.3);
}

TEST(RenderedPicture, ShowsRaisedObstaclesOnly) {
  scene::Scenario scenario = SyrotekWith(R"(, "robots": [])");
  const auto triangles = [&scenario] {
    const sim::Simulation simulation(scenario);
    PictureScene scene;
    ShowSimulation(simulation, {}, scene);
    return scene.size();
  };
  const std::size_t down = triangles();
  for (scene::Box& box : scenario.world.boxes) box.raised = true;
  EXPECT_GT(triangles(), down);
}

TEST(RenderedPicture, FansAreTurnedAsTheirLasersAreOnTheRobot) {
  sim::Simulation simulation(SyrotekWith(
      R"(, "robots": [{"name": "r", "pose": {"x": 1.2, "y": 2, "yaw": 0.5}, "components": [
           {"name": "aside", "type": "LaserScanner", "rotation": [0, 0, 1.25]}]}])"));
  simulation.Sense();
  PictureScene scene;
  ShowSimulation(simulation, {true, true}, scene);
  ASSERT_EQ(scene.fans.size(), 1U);
  EXPECT_NEAR(scene.fans[0].yaw, 1.75, 1e-12);
}

// One that begins 5 m above the floor is as far away and as high as one that stands there.
TEST(Camera, FollowsARobotInTheAir) {
  const auto place = [](double up) {
    const auto height = [up](double z) { return std::to_string(up + z); };
    const sim::Simulation simulation(SyrotekWith(
        R"(, "robots": [{"name": "r", "type": "Custom", "pose": {"x": 1.2, "y": 2.0, "yaw": 0},
             "body": {"origin_height": )" +
        height(0.0) + R"(, "footprint": [[0.1, -0.1], [0.1, 0.1], [-0.1, 0.1], [-0.1, -0.1]],
             "hull": [{"outline": [[0.1, -0.1], [0.1, 0.1], [-0.1, 0.1], [-0.1, -0.1]],
             "bottom": )" +
        height(0.0) + R"(, "top": )" + height(0.3) + "}]}}]"));
    return FindCamera(simulation, "follow", 1.5);
  };
  const Camera standing = place(0.0);
  const Camera flying = place(5.0);
  ExpectNear(flying.position, standing.position + Vec3{0, 0, 5}, 1e-6);
  ExpectNear(flying.Direction(0, 0), standing.Direction(0, 0), 1e-6);
}

// A sheet that a gripper has: where it was there is the floor, and where it is, it is turned.
TEST(RenderedPicture, ShowsAThingWhereItsGripperHasIt) {
  sim::Simulation simulation(SyrotekWith(R"(, "robots": [{"name": "porter",
      "pose": {"x": 1.2, "y": 2.0, "yaw": 0}, "components": [{"name": "hand", "type": "Gripper"}]}],
      "props": [{"name": "sheet", "file": "", "position": [1.5, 2, 0.3], "rotation": [0, 0, 0.5],
                 "shape": [{"vertices": [[-0.1, 0, 0], [0.1, -0.02, 0], [0.1, 0.02, 0]],
                            "triangles": [[0, 1, 2]], "color": "#ff0000"}]}])"));
  const auto is_red = [&simulation](double x, double y) {
    const Vec3 albedo = AlbedoFromAbove(simulation, {x, y, 0}, 0.01);
    return albedo.x > 0.5 && albedo.y < 0.1;
  };
  // The tip of the sheet's broad end, from its middle.
  const Vec2 tip = Transform({0, 0, 0.5}, {0.09, 0});
  EXPECT_TRUE(is_red(1.5, 2.0));
  EXPECT_TRUE(is_red(1.5 + tip.x, 2.0 + tip.y));
  sim::SceneObjects::SetHolder(*simulation.world().objects().Find("sheet"),
                               simulation.FindComponent("porter.hand"));
  EXPECT_TRUE(is_red(1.5 + tip.x, 2.0 + tip.y)) << "not moved so far";
  simulation.robots()[0]->Place({2.0, 2.4, kPi / 2.0});
  EXPECT_FALSE(is_red(1.5, 2.0));
  EXPECT_TRUE(is_red(2.0, 2.7));
  EXPECT_TRUE(is_red(2.0 - tip.y, 2.7 + tip.x));
  simulation.ResetObjects();
  EXPECT_TRUE(is_red(1.5 + tip.x, 2.0 + tip.y));
}

TEST(RenderedPicture, LasersAreFansBeforeWhatIsBehind) {
  sim::Simulation simulation(SyrotekWith(""));
  simulation.Sense();
  PictureScene scene;
  ShowSimulation(simulation, {true, true}, scene);
  ASSERT_EQ(scene.fans.size(), 1U);
  scene.Build(10.0);
  RenderOptions options;
  options.width = options.height = 1;
  options.samples = 4;
  // From above, just before the robot.
  const Pose2& pose = simulation.robots()[0]->pose();
  const auto [s, c] = SinCos(pose.yaw);
  const Vec3 at{pose.x + 0.2 * c, pose.y + 0.2 * s, 0.0};
  Camera camera = Camera::LookAt(at + Vec3{0, 0, 2}, at);
  camera.fov_deg = 0.1;
  EXPECT_NEAR(TracePaths(scene, camera, options).film_through[0], 1.0 - scene.fans[0].opacity,
              1e-9);
}

TEST(RenderedPicture, CamerasAreFoundByName) {
  const sim::Simulation simulation(SyrotekWith(""));
  for (const char* name : {"scene", "top", "follow", "robot", "follow:s1r", "robot:s1r"}) {
    EXPECT_NO_THROW(FindCamera(simulation, name, 1.5)) << name;
  }
  try {
    FindCamera(simulation, "robot:s1", 1.5);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 's1r'"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(FindCamera(simulation, "behind", 1.5), Error);
}

}  // namespace
}  // namespace ccmorse::render
