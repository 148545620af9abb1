#include "tools/render_command.h"

#include <fmt/core.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/error.h"
#include "base/image.h"
#include "render/path_tracer.h"
#include "render/simulation_picture.h"
#include "scene/player/import.h"
#include "servers/record/replay.h"
#include "tools/builder_script.h"

namespace ccmorse::tools {
namespace {

using WallClock = std::chrono::steady_clock;

// MCAP's first bytes (https://mcap.dev/spec).
bool IsRecord(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char first[5] = {};
  return file.read(first, sizeof first) && std::string(first, 5) == "\x89MCAP";
}

void SizeFrom(const std::string& text, render::RenderOptions& options) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, options.height);
    if (height.ec == std::errc() && height.ptr == end) return;
  }
  throw Error("--size is WIDTHxHEIGHT in pixels, such as 1280x720, not '" + text + "'");
}

render::Camera CameraFrom(const RenderArguments& arguments, const sim::Simulation& simulation,
                          double aspect) {
  if (arguments.from.empty()) {
    if (!arguments.at.empty()) throw Error("--at needs --from, the camera's place");
    return render::FindCamera(simulation, arguments.camera, aspect);
  }
  const auto& from = arguments.from;
  const scene::World& world = simulation.world().scene();
  Vec3 at{world.middle().x, world.middle().y, 0.0};
  if (!arguments.at.empty()) at = {arguments.at[0], arguments.at[1], arguments.at[2]};
  return render::Camera::LookAt({from[0], from[1], from[2]}, at);
}

// Shows on a terminal how far it is, and when it will be done.
class RenderProgress {
 public:
  explicit RenderProgress(bool quiet) : shown_(!quiet && ::isatty(STDERR_FILENO) == 1) {}
  ~RenderProgress() {
    if (shown_) std::fprintf(stderr, "\r\x1b[K");
  }
  RenderProgress(const RenderProgress&) = delete;
  RenderProgress& operator=(const RenderProgress&) = delete;

  void Show(double done) {
    if (!shown_) return;
    const auto now = WallClock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const double spent = std::chrono::duration<double>(now - start_).count();
    const double left = spent / done - spent;
    std::fprintf(stderr, "\rtracing light: %3.0f %%, %.0f s left\x1b[K", 100.0 * done, left);
  }

 private:
  bool shown_;
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point next_ = start_;
};

}  // namespace

int Render(const RenderArguments& arguments) {
  render::RenderOptions options;
  SizeFrom(arguments.size, options);
  options.samples = arguments.samples;
  options.threads = arguments.threads;
  options.denoise = !arguments.noise;

  std::unique_ptr<servers::Replay> replay;
  std::unique_ptr<sim::Simulation> own;
  std::string name;
  if (IsRecord(arguments.what)) {
    replay = std::make_unique<servers::Replay>(arguments.what);
    replay->Seek(arguments.time.value_or(replay->duration()));
    name = std::filesystem::path(arguments.what).stem().string();
  } else {
    own =
        std::make_unique<sim::Simulation>(ImportScene(arguments.what).scenario, arguments.threads);
    own->Sense();
    while (own->time() < arguments.time.value_or(0.0)) {
      own->Act();
      own->Sense();
    }
    name = own->scenario().name;
  }
  const sim::Simulation& simulation = replay ? replay->simulation() : *own;

  render::PictureScene scene;
  render::ShowSimulation(simulation, {arguments.lasers, arguments.canvas}, scene);
  const render::Camera camera =
      CameraFrom(arguments, simulation, static_cast<double>(options.width) / options.height);
  scene.Build(std::sqrt(Dot(camera.position, camera.position)));
  const auto start = WallClock::now();
  Image image;
  {
    RenderProgress progress(arguments.quiet);
    options.progress = [&progress](double done) { progress.Show(done); };
    image = render::RenderPicture(scene, camera, options);
  }
  const std::string out = arguments.out.empty() ? name + ".png" : arguments.out;
  WritePng(image, out);
  if (!arguments.quiet) {
    fmt::print("{}: {} x {} pixels, {} at {:.3f} s, {} triangles, {:.1f} s of work\n", out,
               image.width, image.height, name, simulation.time(), scene.size(),
               std::chrono::duration<double>(WallClock::now() - start).count());
  }
  return 0;
}

}  // namespace ccmorse::tools
