#include <algorithm>
#include <cmath>
#include <utility>

#include "base/line_cells.h"
#include "client/player/layers.h"
#include "libCCMorse/GridMap.h"
#include "libCCMorse/MorseError.h"
#include "navigation/occupancy_grid.h"

namespace CCMorse {

namespace {

constexpr int kFarthestMapCell = 1000000000;
constexpr double kFarthest = kFarthestMapCell;

int Held(int cell) { return std::clamp(cell, -kFarthestMapCell, kFarthestMapCell); }

bool Finite(const player_point_2d_t& point) {
  return std::isfinite(point.px) && std::isfinite(point.py);
}

}  // namespace

GridMap::GridMap(Layers& layers, const std::string& name, std::uint64_t serial)
    : layers_(layers),
      name_(name),
      serial_(serial),
      cells_(static_cast<std::size_t>(layers.width_) * static_cast<std::size_t>(layers.height_),
             0) {}

GridMap::~GridMap() = default;

// --- The layer

void GridMap::SetOwnColor(Color_t color) {
  const std::lock_guard lock(layers_.mutex_);
  if (color_ == color) return;
  color_ = color;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] == Layers::kOwn) layers_.Mark(i);
  }
}

Color_t GridMap::GetColor() const {
  const std::lock_guard lock(layers_.mutex_);
  return color_;
}

void GridMap::SetTransparency(double transparency) {
  if (!(transparency >= 0.0 && transparency <= 1.0)) {
    throw MorseError("a layer's transparency is from 0 to 1", "GridMap::SetTransparency()");
  }
  const std::lock_guard lock(layers_.mutex_);
  if (transparency_ == transparency) return;
  transparency_ = transparency;
  ShowAgain();
}

double GridMap::GetTransparency() const {
  const std::lock_guard lock(layers_.mutex_);
  return transparency_;
}

void GridMap::SetKey(std::optional<Color_t> color) {
  const std::lock_guard lock(layers_.mutex_);
  key_ = color;
  ShowAgain();
}

std::optional<Color_t> GridMap::GetTransparentColor() const {
  const std::lock_guard lock(layers_.mutex_);
  return key_;
}

void GridMap::SetPriority(int priority) {
  const std::lock_guard lock(layers_.mutex_);
  if (priority_ == priority) return;
  priority_ = priority;
  layers_.Order();
  layers_.list_changed_ = true;
  ShowAgain();
}

int GridMap::GetPriority() const {
  const std::lock_guard lock(layers_.mutex_);
  return priority_;
}

void GridMap::SetVisible(bool visible) {
  const std::lock_guard lock(layers_.mutex_);
  if (visible_ == visible) return;
  visible_ = visible;
  layers_.list_changed_ = true;
  ShowAgain();
}

bool GridMap::IsVisible() const {
  const std::lock_guard lock(layers_.mutex_);
  return visible_;
}

bool GridMap::IsShown() const {
  const std::lock_guard lock(layers_.mutex_);
  return shown_;
}

int GridMap::GetWidth() const {
  const std::lock_guard lock(layers_.mutex_);
  return layers_.width_;
}

int GridMap::GetHeight() const {
  const std::lock_guard lock(layers_.mutex_);
  return layers_.height_;
}

// --- Cells

void GridMap::SetPixel(int x, int y) {
  const std::lock_guard lock(layers_.mutex_);
  Set(x, y, Layers::kOwn);
}

void GridMap::SetLine(int x0, int y0, int x1, int y1) {
  const std::lock_guard lock(layers_.mutex_);
  ccmorse::ForEachLineCell(Held(x0), Held(y0), Held(x1), Held(y1), layers_.width_, layers_.height_,
                           [&](int x, int y) { Set(x, y, Layers::kOwn); });
}

void GridMap::DrawPixel(ImagePoint_t at, const Paint_t& paint) {
  const std::lock_guard lock(layers_.mutex_);
  Mix(at.x, at.y, paint);
}

void GridMap::DrawLine(ImagePoint_t from, ImagePoint_t to, const Paint_t& paint) {
  const std::lock_guard lock(layers_.mutex_);
  ccmorse::ForEachLineCell(Held(from.x), Held(from.y), Held(to.x), Held(to.y), layers_.width_,
                           layers_.height_, [&](int x, int y) { Mix(x, y, paint); });
}

std::optional<Color_t> GridMap::GetPixel(int x, int y) const {
  const std::lock_guard lock(layers_.mutex_);
  if (!Contains(x, y) || cells_[At(x, y)] == 0) return std::nullopt;
  return ColorOf(cells_[At(x, y)]);
}

void GridMap::ClearPixel(int x, int y) {
  const std::lock_guard lock(layers_.mutex_);
  Set(x, y, 0);
}

void GridMap::Clear() {
  const std::lock_guard lock(layers_.mutex_);
  layers_.MarkUnclear(*this);
  std::fill(cells_.begin(), cells_.end(), 0);
  trace_end_.reset();
}

// --- Whole maps

void GridMap::SetOccupancy(const std::vector<double>& cells) {
  const std::lock_guard lock(layers_.mutex_);
  if (cells.size() != cells_.size()) {
    throw MorseError("the map has " + std::to_string(cells_.size()) +
                         " cells, the occupancy grid " + std::to_string(cells.size()),
                     "GridMap::SetOccupancy()");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) SetAt(i, Grey(cells[i]));
}

void GridMap::SetOccupancy(int x, int y, double occupancy) {
  const std::lock_guard lock(layers_.mutex_);
  Set(x, y, Grey(occupancy));
}

void GridMap::SetScan(const player_pose2d_t& robot, PlayerCc::LaserProxy& laser) {
  const player_pose3d_t mount = laser.GetPose();
  const double cosine = std::cos(robot.pa);
  const double sine = std::sin(robot.pa);
  const player_point_2d_t scanner{robot.px + cosine * mount.px - sine * mount.py,
                                  robot.py + sine * mount.px + cosine * mount.py};
  std::vector<player_point_2d_t> corners{scanner};
  for (std::uint32_t i = 0; i < laser.GetCount(); ++i) {
    const double range = laser.GetRange(i);
    const double angle = robot.pa + mount.pyaw + laser.GetBearing(i);
    corners.push_back({scanner.px + range * std::cos(angle), scanner.py + range * std::sin(angle)});
  }
  SetArea(corners);
}

// Row by row: the cells whose middles lie within.
void GridMap::SetArea(const std::vector<player_point_2d_t>& corners) {
  // In cells; read before the lock is held, as it may be another's.
  const double size = layers_.pen_.GetCellSize();
  std::vector<player_point_2d_t> points;
  if (size > 0.0) {
    for (const player_point_2d_t& corner : corners) {
      if (Finite(corner)) points.push_back({corner.px / size, corner.py / size});
    }
  }
  const std::lock_guard lock(layers_.mutex_);
  const int width = layers_.width_;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(layers_.height_));
  for (std::size_t i = 0; i < points.size(); ++i) {
    player_point_2d_t low = points[i];
    player_point_2d_t high = points[(i + 1) % points.size()];
    if (low.py > high.py) std::swap(low, high);
    // Rows whose middle line the edge crosses, the upper end not included.
    const double first =
        std::clamp(std::ceil(low.py - 0.5), 0.0, static_cast<double>(layers_.height_));
    const double end =
        std::clamp(std::ceil(high.py - 0.5), 0.0, static_cast<double>(layers_.height_));
    for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(end); ++row) {
      const double part = (static_cast<double>(row) + 0.5 - low.py) / (high.py - low.py);
      crossings[row].push_back(low.px + part * (high.px - low.px));
    }
  }
  std::vector<Cell> cells(cells_.size(), 0);
  for (int y = 0; y < layers_.height_; ++y) {
    std::vector<double>& row = crossings[static_cast<std::size_t>(y)];
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const auto column = [&](double x) {
        return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
      };
      for (int x = column(row[i]); x < column(row[i + 1]); ++x) cells[At(x, y)] = Layers::kOwn;
    }
  }
  Replace(cells);
}

void GridMap::SetInflated(const GridMap& map, double radius) {
  if (!(radius >= 0.0)) {
    throw MorseError("obstacles are made larger by 0 m or more", "GridMap::SetInflated()");
  }
  if (&map.layers_ != &layers_) {
    throw MorseError("the map is of another window", "GridMap::SetInflated()");
  }
  const double size = layers_.pen_.GetCellSize();
  const std::lock_guard lock(layers_.mutex_);
  std::vector<Cell> cells(cells_.size(), 0);
  if (size > 0.0 && !cells.empty()) {
    using ccmorse::navigation::Cell;
    ccmorse::navigation::OccupancyGrid grid(layers_.width_, layers_.height_, size);
    std::vector<bool> obstacle(cells.size());
    for (int y = 0; y < layers_.height_; ++y) {
      for (int x = 0; x < layers_.width_; ++x) {
        const auto cell = map.cells_[At(x, y)];
        obstacle[At(x, y)] = cell != 0 && map.ColorOf(cell) == LayerColor::kObstacle;
        if (obstacle[At(x, y)]) grid.Set({x, y}, Cell::kOccupied);
      }
    }
    // Distances are multiples of the cell's size but for rounding; more than the map is as good.
    const double reach = std::min(radius, size * (layers_.width_ + layers_.height_));
    const std::vector<double> distances = grid.ObstacleDistances(reach + 2.0 * size);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!obstacle[i] && distances[i] <= reach + 1e-9) cells[i] = Layers::kOwn;
    }
  }
  Replace(cells);
}

void GridMap::SetPath(const std::vector<player_point_2d_t>& points) {
  const double size = layers_.pen_.GetCellSize();
  const std::lock_guard lock(layers_.mutex_);
  std::vector<Cell> cells(cells_.size(), 0);
  std::optional<ImagePoint_t> last;
  for (const player_point_2d_t& point : points) {
    const std::optional<ImagePoint_t> here = CellOf(point.px, point.py, size);
    if (!here) continue;
    const ImagePoint_t from = last.value_or(*here);
    ccmorse::ForEachLineCell(from.x, from.y, here->x, here->y, layers_.width_, layers_.height_,
                             [&](int x, int y) { cells[At(x, y)] = Layers::kOwn; });
    last = here;
  }
  Replace(cells);
}

void GridMap::AddToTrace(double x, double y) {
  const double size = layers_.pen_.GetCellSize();
  const std::lock_guard lock(layers_.mutex_);
  const std::optional<ImagePoint_t> here = CellOf(x, y, size);
  if (!here) return;
  const ImagePoint_t from = trace_end_.value_or(*here);
  ccmorse::ForEachLineCell(from.x, from.y, here->x, here->y, layers_.width_, layers_.height_,
                           [&](int column, int row) { Set(column, row, Layers::kOwn); });
  trace_end_ = here;
}

// --- Under the mutex

std::size_t GridMap::At(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(layers_.width_) +
         static_cast<std::size_t>(x);
}

bool GridMap::Contains(int x, int y) const {
  return x >= 0 && x < layers_.width_ && y >= 0 && y < layers_.height_;
}

void GridMap::Set(int x, int y, Cell cell) {
  if (Contains(x, y)) SetAt(At(x, y), cell);
}

void GridMap::SetAt(std::size_t at, Cell cell) {
  if (cells_[at] == cell) return;
  cells_[at] = cell;
  layers_.Mark(at);
}

void GridMap::Mix(int x, int y, const Paint_t& paint) {
  if (!Contains(x, y) || paint.alpha() <= 0.0) return;
  Color_t color = paint.color();
  if (paint.alpha() < 1.0) {
    const Cell cell = cells_[At(x, y)];
    const Color_t under = cell == 0 ? kWhite : ColorOf(cell);
    const auto mix = [&](unsigned char a, unsigned char b) {
      return static_cast<unsigned char>(std::lround(paint.alpha() * a + (1.0 - paint.alpha()) * b));
    };
    color = {mix(color.r, under.r), mix(color.g, under.g), mix(color.b, under.b)};
  }
  SetAt(At(x, y), Layers::kColored | Layers::Pack(color));
}

void GridMap::Replace(const std::vector<Cell>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) SetAt(i, cells[i]);
}

void GridMap::ShowAgain() { layers_.MarkUnclear(*this); }

std::optional<ImagePoint_t> GridMap::CellOf(double x, double y, double size) {
  if (!std::isfinite(x) || !std::isfinite(y) || !(size > 0.0)) return std::nullopt;
  const auto cell = [&](double coordinate) {
    return static_cast<int>(std::clamp(std::floor(coordinate / size), -kFarthest, kFarthest));
  };
  return ImagePoint_t(cell(x), cell(y));
}

Color_t GridMap::ColorOf(Cell cell) const {
  return cell == Layers::kOwn ? color_ : Layers::Unpack(cell);
}

// White for free, grey for unknown, black for obstacles.
GridMap::Cell GridMap::Grey(double occupancy) {
  if (std::isnan(occupancy)) occupancy = 0.5;
  const auto level =
      static_cast<unsigned char>(std::lround(255.0 * (1.0 - std::clamp(occupancy, 0.0, 1.0))));
  return Layers::kColored | Layers::Pack({level, level, level});
}

}  // namespace CCMorse
