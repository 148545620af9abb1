#include "tools/top_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

#include "base/convex_hull.h"
#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "scene/mesh.h"

namespace ccmorse::tools {
namespace {

using scene::Box;
using scene::Light;

// Each pixel is the mean of so many samples in x and in y.
constexpr int kSamples = 4;
// Rows of pixels painted at a time, which bounds the memory that the samples take.
constexpr int kBandRows = 32;
constexpr int kLargestSide = 8192;

constexpr Color kBackground{236, 239, 242};
constexpr double kGridStep = 0.5;      // m
constexpr double kGridShade = 0.93;    // of the floor's brightness
constexpr double kShadowDepth = 0.17;  // share of light that a shadow takes: lighter than any box
constexpr double kShadowBlur = 0.010;  // m, the width of its soft edge
constexpr double kBevel = 0.006;       // m, the lit or shaded rim of a box

Color Shade(Color color, double factor) {
  const auto channel = [factor](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(value * factor + 0.5, 0.0, 255.0));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

Color Blend(Color below, Color above, double alpha) {
  const auto channel = [alpha](std::uint8_t b, std::uint8_t a) {
    return static_cast<std::uint8_t>(std::lround(b + (a - b) * alpha));
  };
  return {channel(below.r, above.r), channel(below.g, above.g), channel(below.b, above.b)};
}

// A convex polygon in metres, painted over what is there.
struct Patch {
  std::vector<Vec2> outline;
  Color color;
  double alpha = 1.0;
};

// The way from metres to samples: x to the right, y down.
struct Frame {
  double scale = 0.0;  // samples a metre
  double left = 0.0;   // m, of the picture's left edge
  double top = 0.0;    // m, of its top edge
  int width = 0;       // samples
  int height = 0;      // samples

  Vec2 ToSamples(Vec2 point) const { return {(point.x - left) * scale, (top - point.y) * scale}; }
};

// Samples [first, last) of row `row` whose centres lie in the convex polygon (in samples).
std::pair<int, int> Span(std::span<const Vec2> polygon, int row, int width) {
  const double y = row + 0.5;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Vec2 a = polygon[i];
    Vec2 b = polygon[(i + 1) % polygon.size()];
    // The same order for both polygons that share an edge gives the same crossing: no seam.
    if (a.y > b.y || (a.y == b.y && a.x > b.x)) std::swap(a, b);
    if (y < a.y || y >= b.y) continue;
    const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (low > high) return {0, 0};
  const double limit = width;
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, limit)),
          static_cast<int>(std::clamp(std::ceil(high - 0.5), 0.0, limit))};
}

// Rows [first, last) that the polygon (in samples) can touch, within [from, to).
std::pair<int, int> Rows(std::span<const Vec2> polygon, int from, int to) {
  double low = polygon[0].y;
  double high = polygon[0].y;
  for (const Vec2 corner : polygon) {
    low = std::min(low, corner.y);
    high = std::max(high, corner.y);
  }
  const auto clamp = [from, to](double y) {
    return static_cast<int>(std::clamp(y, static_cast<double>(from), static_cast<double>(to)));
  };
  return {clamp(std::floor(low)), clamp(std::ceil(high))};
}

std::vector<Vec2> ToSamples(const Frame& frame, std::span<const Vec2> outline) {
  std::vector<Vec2> polygon;
  for (const Vec2 point : outline) polygon.push_back(frame.ToSamples(point));
  return polygon;
}

std::vector<Vec2> Placed(const Pose2& pose, std::span<const Vec2> outline) {
  std::vector<Vec2> placed;
  for (const Vec2 point : outline) placed.push_back(Transform(pose, point));
  return placed;
}

std::vector<Vec2> Circle(Vec2 centre, double radius) {
  constexpr int kCorners = 48;
  std::vector<Vec2> outline;
  for (int i = 0; i < kCorners; ++i) {
    const auto [s, c] = SinCos(2.0 * kPi * i / kCorners);
    outline.push_back({centre.x + radius * c, centre.y + radius * s});
  }
  return outline;
}

std::vector<Vec2> ScaledAbout(std::span<const Vec2> outline, double factor) {
  std::vector<Vec2> scaled;
  for (const Vec2 point : outline) scaled.push_back(factor * point);
  return scaled;
}

// How far a shadow reaches on the floor per metre of height: away from the sun.
Vec2 ShadowSlope(const scene::World& world) {
  for (const Light& light : world.lights) {
    if (light.kind == "sun" && light.shadows && light.position.z > 0.0) {
      return {-light.position.x / light.position.z, -light.position.y / light.position.z};
    }
  }
  return {};
}

// The shadow of an upright prism on the floor.
std::vector<Vec2> ShadowOf(std::span<const Vec2> outline, double height, Vec2 slope) {
  std::vector<Vec2> points(outline.begin(), outline.end());
  for (const Vec2 corner : outline) points.push_back(corner + height * slope);
  return ConvexHull(std::move(points));
}

// How much of the sun's light reaches each pixel, 0..1, row by row.
class ShadowMap {
 public:
  ShadowMap(int width, int height)
      : width_(width),
        height_(height),
        shade_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F) {}

  void Add(std::span<const Vec2> polygon) {
    const auto [first, last] = Rows(polygon, 0, height_);
    for (int row = first; row < last; ++row) {
      const auto [from, to] = Span(polygon, row, width_);
      for (int x = from; x < to; ++x) At(x, row) = 1.0F;
    }
  }

  // Two passes of a box blur each way come close to a Gaussian.
  void Blur(int radius) {
    for (int pass = 0; pass < 2; ++pass) {
      for (int row = 0; row < height_; ++row) BlurLine(&At(0, row), 1, width_, radius);
      for (int x = 0; x < width_; ++x) BlurLine(&At(x, 0), width_, height_, radius);
    }
  }

  float& At(int x, int row) {
    return shade_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x)];
  }

 private:
  void BlurLine(float* line, std::ptrdiff_t step, int count, int radius) {
    if (radius < 1) return;
    line_.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) line_[static_cast<std::size_t>(i)] = line[i * step];
    const auto source = [this, count](int i) {
      return line_[static_cast<std::size_t>(std::clamp(i, 0, count - 1))];
    };
    // Summed up anew for each sample: a running sum would gather rounding errors.
    const float share = 1.0F / static_cast<float>(2 * radius + 1);
    for (int i = 0; i < count; ++i) {
      float sum = 0.0F;
      for (int k = i - radius; k <= i + radius; ++k) sum += source(k);
      line[i * step] = sum * share;
    }
  }

  int width_;
  int height_;
  std::vector<float> shade_;
  std::vector<float> line_;
};

// The box's rim, four strips lit by the side that they face, and its top within the rim.
void AddBox(const Box& box, Vec2 slope, std::vector<Patch>& rims, std::vector<Patch>& tops) {
  const double rim = std::min({kBevel, box.size_x / 4.0, box.size_y / 4.0});
  const auto outer = BoxCorners(box.pose, box.size_x, box.size_y);
  const auto inner = BoxCorners(box.pose, box.size_x - 2.0 * rim, box.size_y - 2.0 * rim);
  const double length = std::sqrt(Dot(slope, slope));
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    const Vec2 edge = outer[k] - outer[i];
    const Vec2 normal = (1.0 / std::sqrt(Dot(edge, edge))) * Vec2{edge.y, -edge.x};
    // -1 where the rim faces the sun, 1 where it faces away.
    const double away = length > 0.0 ? Dot(normal, slope) / length : 0.0;
    const double light = away < 0.0 ? 0.86 - 0.22 * away : 0.86 - 0.24 * away;
    rims.push_back({{outer[i], outer[k], inner[k], inner[i]}, Shade(box.color, light), 1.0});
  }
  tops.push_back({{inner.begin(), inner.end()}, box.color, 1.0});
}

// A mesh from above: its triangles from the lowest up, darker the steeper they are.
void AddMesh(const scene::Mesh& mesh, std::vector<Patch>& patches) {
  if (!mesh.drawn) return;
  const std::vector<Vec3> vertices = scene::PlacedVertices(mesh);
  struct Triangle {
    std::array<Vec3, 3> corners;
    Color color;
  };
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    triangles.push_back(
        {{vertices[static_cast<std::size_t>(a)], vertices[static_cast<std::size_t>(b)],
          vertices[static_cast<std::size_t>(c)]},
         scene::ColorOf(mesh, i)});
  }
  const auto height = [](const Triangle& triangle) {
    return triangle.corners[0].z + triangle.corners[1].z + triangle.corners[2].z;
  };
  std::stable_sort(
      triangles.begin(), triangles.end(),
      [height](const Triangle& one, const Triangle& other) { return height(one) < height(other); });
  for (const Triangle& triangle : triangles) {
    const auto& [a, b, c] = triangle.corners;
    const Vec3 normal = Cross(b - a, c - a);
    const double level = std::fabs(normal.z) / std::sqrt(Dot(normal, normal));
    patches.push_back(
        {{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}, Shade(triangle.color, 0.5 + 0.5 * level), 1.0});
  }
}

// A box that is down: a tint and a thin line where it would stand.
void AddRetracted(const Box& box, std::vector<Patch>& patches) {
  constexpr double kLine = 0.004;
  const auto outer = BoxCorners(box.pose, box.size_x, box.size_y);
  const auto inner = BoxCorners(box.pose, box.size_x - 2.0 * kLine, box.size_y - 2.0 * kLine);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = (i + 1) % 4;
    patches.push_back({{outer[i], outer[k], inner[k], inner[i]}, box.color, 0.42});
  }
  patches.push_back({{inner.begin(), inner.end()}, box.color, 0.10});
}

void AddRobot(const TopViewRobot& robot, std::vector<Patch>& patches) {
  const scene::RobotModel& model = *robot.model;
  const auto add = [&patches, &robot](std::span<const Vec2> outline, Color color,
                                      double alpha = 1.0) {
    patches.push_back({Placed(robot.pose, outline), color, alpha});
  };
  // Body part by part from the floor up, each with a dark rim, so that the steps show.
  for (std::size_t i = 0; i < model.hull.size(); ++i) {
    const std::vector<Vec2>& outline = model.hull[i].outline;
    const bool is_top = i + 1 == model.hull.size();
    add(outline, Shade(robot.color, is_top ? 0.62 : 0.38));
    add(ScaledAbout(outline, is_top ? 0.93 : 0.955), Shade(robot.color, is_top ? 1.0 : 0.70));
    if (i > 0) continue;
    // The wheels stand in slots of the base, which the narrower parts above leave in sight.
    const double half = model.wheel_radius;
    for (const double side : {-0.5, 0.5}) {
      const double y = side * model.wheel_track;
      const double w = model.wheel_width / 2.0;
      const std::vector<Vec2> wheel = {
          {half, y - w}, {half, y + w}, {-half, y + w}, {-half, y - w}};
      add(wheel, {28, 30, 34});
    }
  }
  // The scanner, and an arrow head that points forward.
  const Vec3 mount = model.laser.position;
  add(Circle({mount.x, mount.y}, 0.020), {24, 26, 30});
  add(Circle({mount.x, mount.y}, 0.012), {92, 98, 108});
  const double length = model.length;
  const std::vector<Vec2> left_barb = {
      {0.02 * length, 0.0}, {-0.26 * length, 0.20 * length}, {-0.17 * length, 0.0}};
  const std::vector<Vec2> right_barb = {
      {0.02 * length, 0.0}, {-0.17 * length, 0.0}, {-0.26 * length, -0.20 * length}};
  add(left_barb, {255, 255, 255});
  add(right_barb, {255, 255, 255});
}

void AddScan(const TopViewRobot& robot, std::vector<Patch>& patches) {
  for (std::size_t i = 0; i + 1 < robot.scan.size(); ++i) {
    patches.push_back({{robot.scan_origin, robot.scan[i], robot.scan[i + 1]}, {70, 190, 90}, 0.22});
  }
}

void Check(const TopView& view) {
  if (view.world == nullptr) throw Error("a top view needs a world");
  if (!(view.pixels_per_metre >= 10.0 && view.pixels_per_metre <= 2000.0)) {
    throw Error(
        fmt::format("a top view has {} pixels a metre, must be 10..2000", view.pixels_per_metre));
  }
  if (!(view.margin >= 0.0)) {
    throw Error(fmt::format("a top view has a margin of {} m, must be 0 or more", view.margin));
  }
  const TopViewCanvas& canvas = view.canvas;
  if (canvas.width == 0) return;
  const auto cells = static_cast<std::size_t>(std::max(canvas.width, 0)) *
                     static_cast<std::size_t>(std::max(canvas.height, 0));
  if (cells == 0 || canvas.colors.size() != cells || canvas.alpha.size() != cells ||
      !(canvas.cell_size > 0.0)) {
    throw Error(fmt::format(
        "a top view's canvas of {} x {} cells of {} m has {} colours and {} "
        "alphas",
        canvas.width, canvas.height, canvas.cell_size, canvas.colors.size(), canvas.alpha.size()));
  }
}

Frame MakeFrame(const TopView& view) {
  const scene::World& world = *view.world;
  Frame frame;
  frame.scale = view.pixels_per_metre * kSamples;
  frame.left = world.low.x - view.margin;
  frame.top = world.high().y + view.margin;
  const auto side = [&view](double metres) {
    const double pixels = std::ceil((metres + 2.0 * view.margin) * view.pixels_per_metre - 1e-6);
    if (!(pixels <= kLargestSide)) {
      throw Error(
          fmt::format("a top view of {} pixels a side is too large, at most {}; take fewer "
                      "pixels a metre than {}",
                      pixels, kLargestSide, view.pixels_per_metre));
    }
    return std::max(1, static_cast<int>(pixels)) * kSamples;
  };
  frame.width = side(world.size_x);
  frame.height = side(world.size_y);
  return frame;
}

// Everything worked out before painting; the painting itself goes band by band.
class Painter {
 public:
  explicit Painter(const TopView& view)
      : view_(view),
        world_(*view.world),
        frame_(MakeFrame(view)),
        shadows_(frame_.width / kSamples, frame_.height / kSamples) {
    const Vec2 slope = ShadowSlope(world_);
    CastShadows(slope);
    for (const Box& box : world_.boxes) {
      if (!box.raised) AddRetracted(box, on_floor_);
    }
    for (const TopViewRobot& robot : view.robots) AddScan(robot, on_floor_);
    // All rims before all tops: where walls run into each other no line divides them. The first
    // boxes go on top: a world begins with its outer walls, into which others are let.
    std::vector<Patch> tops;
    for (auto box = world_.boxes.rbegin(); box != world_.boxes.rend(); ++box) {
      if (box->raised) AddBox(*box, slope, standing_, tops);
    }
    standing_.insert(standing_.end(), tops.begin(), tops.end());
    for (const scene::Mesh& mesh : world_.meshes) AddMesh(mesh, standing_);
    for (const TopViewRobot& robot : view.robots) AddRobot(robot, standing_);
    for (std::vector<Patch>* patches : {&on_floor_, &standing_}) {
      for (Patch& patch : *patches) patch.outline = ToSamples(frame_, patch.outline);
    }
  }

  Image Paint() {
    Image image;
    image.width = frame_.width / kSamples;
    image.height = frame_.height / kSamples;
    image.pixels.reserve(static_cast<std::size_t>(image.width) *
                         static_cast<std::size_t>(image.height));
    for (int row = 0; row < image.height; row += kBandRows) {
      const int rows = std::min(kBandRows, image.height - row);
      PaintBand(row * kSamples, (row + rows) * kSamples);
      Average(rows, image);
    }
    return image;
  }

 private:
  void CastShadows(Vec2 slope) {
    Frame pixels = frame_;
    pixels.scale = view_.pixels_per_metre;
    for (const Box& box : world_.boxes) {
      if (!box.raised) continue;
      const auto corners = BoxCorners(box.pose, box.size_x, box.size_y);
      shadows_.Add(ToSamples(pixels, ShadowOf(corners, box.height, slope)));
    }
    for (const TopViewRobot& robot : view_.robots) {
      for (const scene::HullPart& part : robot.model->hull) {
        const std::vector<Vec2> outline = Placed(robot.pose, part.outline);
        shadows_.Add(ToSamples(pixels, ShadowOf(outline, part.top, slope)));
      }
    }
    shadows_.Blur(static_cast<int>(std::lround(kShadowBlur * view_.pixels_per_metre)));
  }

  // Brightness of the floor under the spotlights, 0.95..1: enough to give it depth, and still
  // white.
  double FloorLight(Vec2 point) const {
    double light = 0.0;
    bool has_spots = false;
    for (const Light& spot : world_.lights) {
      if (spot.kind != "spot") continue;
      has_spots = true;
      const Vec2 d = point - Vec2{spot.position.x, spot.position.y};
      const double reach = 0.3 * spot.position.z * spot.position.z;
      light += reach / (reach + Dot(d, d));
    }
    return has_spots ? 0.95 + 0.05 * std::min(1.0, light / 1.9) : 1.0;
  }

  bool IsOnGrid(Vec2 point) const {
    const double half_line = 0.5 / view_.pixels_per_metre;
    const auto is_near = [half_line](double v) {
      const double offset = v - kGridStep * std::floor(v / kGridStep + 0.5);
      return std::abs(offset) < half_line;
    };
    return is_near(point.x) || is_near(point.y);
  }

  Color Ground(Vec2 point, double floor_light) const {
    const Vec2 high = world_.high();
    if (point.x < world_.low.x || point.y < world_.low.y || point.x > high.x || point.y > high.y) {
      return kBackground;
    }
    const Color floor =
        Shade(world_.floor, IsOnGrid(point) ? floor_light * kGridShade : floor_light);
    const TopViewCanvas& canvas = view_.canvas;
    if (canvas.width == 0) return floor;
    const auto x = static_cast<int>((point.x - world_.low.x) / canvas.cell_size);
    const auto y = static_cast<int>((point.y - world_.low.y) / canvas.cell_size);
    if (x >= canvas.width || y >= canvas.height) return floor;
    const auto cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width) +
                      static_cast<std::size_t>(x);
    return Blend(floor, canvas.colors[cell], canvas.alpha[cell] / 255.0);
  }

  void PaintBand(int first, int last) {
    first_ = first;
    band_.assign(static_cast<std::size_t>(frame_.width) * static_cast<std::size_t>(last - first),
                 kBackground);
    for (int row = first; row < last; ++row) {
      double floor_light = 1.0;
      for (int x = 0; x < frame_.width; ++x) {
        const Vec2 point{frame_.left + (x + 0.5) / frame_.scale,
                         frame_.top - (row + 0.5) / frame_.scale};
        // It changes so slowly that one value a pixel does.
        if (x % kSamples == 0) floor_light = FloorLight(point);
        At(x, row) = Ground(point, floor_light);
      }
    }
    for (const Patch& patch : on_floor_) Fill(patch, first, last);
    for (int row = first; row < last; ++row) {
      for (int x = 0; x < frame_.width; ++x) {
        const double shade = static_cast<double>(shadows_.At(x / kSamples, row / kSamples));
        if (shade > 0.0) At(x, row) = Shade(At(x, row), 1.0 - kShadowDepth * shade);
      }
    }
    for (const Patch& patch : standing_) Fill(patch, first, last);
  }

  void Fill(const Patch& patch, int first, int last) {
    const auto [from_row, to_row] = Rows(patch.outline, first, last);
    for (int row = from_row; row < to_row; ++row) {
      const auto [from, to] = Span(patch.outline, row, frame_.width);
      for (int x = from; x < to; ++x) {
        Color& sample = At(x, row);
        sample = patch.alpha == 1.0 ? patch.color : Blend(sample, patch.color, patch.alpha);
      }
    }
  }

  // Appends the band's pixels to the image.
  void Average(int rows, Image& image) {
    constexpr int kCount = kSamples * kSamples;
    const auto mean = [](int sum) {
      return static_cast<std::uint8_t>((sum + kCount / 2) / kCount);
    };
    for (int row = 0; row < rows; ++row) {
      for (int x = 0; x < image.width; ++x) {
        int r = 0;
        int g = 0;
        int b = 0;
        for (int i = 0; i < kCount; ++i) {
          const Color sample =
              At(x * kSamples + i % kSamples, first_ + row * kSamples + i / kSamples);
          r += sample.r;
          g += sample.g;
          b += sample.b;
        }
        image.pixels.push_back({mean(r), mean(g), mean(b)});
      }
    }
  }

  Color& At(int x, int row) {
    return band_[static_cast<std::size_t>(row - first_) * static_cast<std::size_t>(frame_.width) +
                 static_cast<std::size_t>(x)];
  }

  const TopView& view_;
  const scene::World& world_;
  Frame frame_;
  ShadowMap shadows_;            // a value a pixel
  std::vector<Patch> on_floor_;  // in samples; shadows fall on these
  std::vector<Patch> standing_;  // in samples; these stand above the shadows
  std::vector<Color> band_;      // samples of the rows being painted
  int first_ = 0;                // row of samples that the band starts with
};

}  // namespace

Image RenderTopView(const TopView& view) {
  Check(view);
  return Painter(view).Paint();
}

Pixel PixelOf(const TopView& view, Vec2 point) {
  const double x = (point.x - view.world->low.x + view.margin) * view.pixels_per_metre;
  const double y = (view.world->high().y + view.margin - point.y) * view.pixels_per_metre;
  return {static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))};
}

}  // namespace ccmorse::tools
