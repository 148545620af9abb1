#include "sim/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/line_cells.h"

namespace ccmorse::sim {
namespace {

constexpr Color kWhite{255, 255, 255};

std::uint8_t Blend(std::uint8_t over, std::uint8_t under, double alpha) {
  return static_cast<std::uint8_t>(std::lround(alpha * over + (1.0 - alpha) * under));
}

}  // namespace

Canvas::Canvas(const scene::CanvasDef& def, double world_x, double world_y)
    : def_(def), world_x_(world_x), world_y_(world_y) {
  Reset();
}

double Canvas::cell_size() const { return std::max(world_x_ / width_, world_y_ / height_); }

void Canvas::Resize(int width, int height) {
  width_ = width;
  height_ = height;
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  cells_.assign(count, kWhite);
  drawn_.assign(count, false);
  ++revision_;
}

void Canvas::SetPixel(int x, int y, Color color, double alpha) {
  if (!Contains(x, y) || alpha <= 0.0) return;
  Color& cell = cells_[At(x, y)];
  drawn_[At(x, y)] = true;
  ++revision_;
  if (alpha >= 1.0) {
    cell = color;
    return;
  }
  cell = {Blend(color.r, cell.r, alpha), Blend(color.g, cell.g, alpha),
          Blend(color.b, cell.b, alpha)};
}

void Canvas::SetRectangle(int x, int y, int width, int height, std::span<const Color> colors) {
  const std::int64_t left = std::max(0, x);
  const std::int64_t right = std::min<std::int64_t>(width_, std::int64_t{x} + width);
  if (left >= right) return;
  const std::int64_t top = std::min<std::int64_t>(height_, std::int64_t{y} + height);
  for (std::int64_t row = std::max(0, y); row < top; ++row) {
    const auto from = colors.begin() + static_cast<std::ptrdiff_t>((row - y) * width + left - x);
    const auto at = static_cast<std::ptrdiff_t>(row * width_ + left);
    std::copy_n(from, right - left, cells_.begin() + at);
    std::fill_n(drawn_.begin() + at, right - left, true);
  }
  ++revision_;
}

Color Canvas::GetPixel(int x, int y) const { return cells_[At(x, y)]; }

bool Canvas::IsDrawn(int x, int y) const { return drawn_[At(x, y)]; }

void Canvas::DrawLine(int x0, int y0, int x1, int y1, Color color, double alpha) {
  ForEachLineCell(x0, y0, x1, y1, width_, height_,
                  [&](int x, int y) { SetPixel(x, y, color, alpha); });
}

void Canvas::AddToHash(StateHash& hash) const {
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!IsDrawn(x, y)) continue;
      const Color color = GetPixel(x, y);
      hash.Add(static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint64_t>(x));
      hash.Add(static_cast<std::uint64_t>(color.r) << 16 |
               static_cast<std::uint64_t>(color.g) << 8 | color.b);
    }
  }
}

void Canvas::Reset() { Resize(def_.width, def_.height); }

void Canvas::SetLayers(std::vector<CanvasLayer> layers) {
  for (CanvasLayer& layer : layers) {
    const auto before = std::find_if(layers_.begin(), layers_.end(),
                                     [&](const CanvasLayer& l) { return l.name == layer.name; });
    layer.shown = before == layers_.end() || before->shown;
  }
  if (layers == layers_) return;
  layers_ = std::move(layers);
  ++layers_revision_;
}

bool Canvas::ShowLayer(const std::string& name, bool shown) {
  const auto layer = std::find_if(layers_.begin(), layers_.end(),
                                  [&](const CanvasLayer& l) { return l.name == name; });
  if (layer == layers_.end()) return false;
  if (layer->shown != shown) ++layers_revision_;
  layer->shown = shown;
  return true;
}

std::string Canvas::SaveCopy(const std::string& name) const {
  if (name.empty() || name[0] == '.' || name.size() > 200 ||
      name.find_first_of(std::string_view("/\\\0", 3)) != std::string::npos) {
    throw Error("'" + name.substr(0, 200) +
                "' is not a plain file name; pictures go into the simulator's --out folder");
  }
  const bool has_ending = name.size() > 4 && name.compare(name.size() - 4, 4, ".png") == 0;
  const std::string path =
      (std::filesystem::path(picture_folder_) / (has_ending ? name : name + ".png")).string();
  WritePng(ToImage(), path);
  return path;
}

Image Canvas::ToImage() const {
  Image image{width_, height_, {}};
  image.pixels.reserve(cells_.size());
  for (int y = height_ - 1; y >= 0; --y) {
    const auto row = cells_.begin() + static_cast<std::ptrdiff_t>(At(0, y));
    image.pixels.insert(image.pixels.end(), row, row + width_);
  }
  return image;
}

}  // namespace ccmorse::sim
