#include "navigation/occupancy_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/trig.h"

namespace ccmorse::navigation {
namespace {

constexpr double kFar = 1e20;  // squared cells; more than any distance in a map

// Lower envelope of parabolas: squared distances along one line of `count` cells from the squared
// distances across it. `places` and `borders` are scratch.
void DistanceAlongLine(const std::vector<double>& across, std::vector<double>& along, int count,
                       std::vector<int>& places, std::vector<double>& borders) {
  int last = -1;
  for (int q = 0; q < count; ++q) {
    const double height = across[static_cast<std::size_t>(q)];
    if (height >= kFar) continue;
    double border = -kFar;
    while (last >= 0) {
      const int p = places[static_cast<std::size_t>(last)];
      border = ((height + 1.0 * q * q) - (across[static_cast<std::size_t>(p)] + 1.0 * p * p)) /
               (2.0 * (q - p));
      if (border > borders[static_cast<std::size_t>(last)]) break;
      --last;
      border = -kFar;
    }
    ++last;
    places[static_cast<std::size_t>(last)] = q;
    borders[static_cast<std::size_t>(last)] = border;
  }
  if (last < 0) {
    std::fill(along.begin(), along.begin() + count, kFar);
    return;
  }
  int k = 0;
  for (int q = 0; q < count; ++q) {
    while (k < last && borders[static_cast<std::size_t>(k) + 1] < q) ++k;
    const int p = places[static_cast<std::size_t>(k)];
    along[static_cast<std::size_t>(q)] =
        1.0 * (q - p) * (q - p) + across[static_cast<std::size_t>(p)];
  }
}

}  // namespace

OccupancyGrid::OccupancyGrid(int width, int height, double scale, Vec2 origin)
    : width_(width), height_(height), scale_(scale), origin_(origin) {
  constexpr std::int64_t kMostCells = std::int64_t{1} << 28;
  if (width <= 0 || height <= 0 || std::int64_t{width} * height > kMostCells) {
    throw Error("a map must have between 1 and 2^28 cells");
  }
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    throw Error("the cells of a map must have a positive size");
  }
  cells_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Cell::kUnknown);
}

OccupancyGrid OccupancyGrid::FromImage(const Image& image, double scale, bool negate, Vec2 origin) {
  OccupancyGrid grid(image.width, image.height, scale, origin);
  for (int y = 0; y < grid.height_; ++y) {
    for (int x = 0; x < grid.width_; ++x) {
      const Color& color = image.pixels[grid.IndexOf({x, image.height - 1 - y})];
      const double light = (color.r + color.g + color.b) / (3.0 * 255.0);
      const double occupied = negate ? light : 1.0 - light;
      // Thresholds between "surely" and "unknown": grey, as map makers draw what they did not see,
      // must be neither.
      constexpr double kSurelyOccupied = 0.65;
      constexpr double kSurelyFree = 0.2;
      grid.Set({x, y}, occupied > kSurelyOccupied ? Cell::kOccupied
                       : occupied < kSurelyFree   ? Cell::kFree
                                                  : Cell::kUnknown);
    }
  }
  return grid;
}

CellIndex OccupancyGrid::CellOf(Vec2 point) const {
  const auto cell = [](double metres) {
    // Far outside is outside; converting would overflow.
    return static_cast<int>(std::floor(std::clamp(metres, -1e9, 1e9)));
  };
  return {cell((point.x - origin_.x) / scale_), cell((point.y - origin_.y) / scale_)};
}

Vec2 OccupancyGrid::CentreOf(CellIndex cell) const {
  return {origin_.x + (cell.x + 0.5) * scale_, origin_.y + (cell.y + 0.5) * scale_};
}

std::vector<double> OccupancyGrid::ObstacleDistances(double limit) const {
  const auto most = static_cast<std::size_t>(std::max(width_, height_));
  std::vector<double> squares(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    squares[i] = cells_[i] == Cell::kOccupied ? 0.0 : kFar;
  }
  std::vector<double> in(most);
  std::vector<double> out(most);
  std::vector<int> places(most);
  std::vector<double> borders(most);
  for (int x = 0; x < width_; ++x) {
    for (int y = 0; y < height_; ++y) in[static_cast<std::size_t>(y)] = squares[IndexOf({x, y})];
    DistanceAlongLine(in, out, height_, places, borders);
    for (int y = 0; y < height_; ++y) squares[IndexOf({x, y})] = out[static_cast<std::size_t>(y)];
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) in[static_cast<std::size_t>(x)] = squares[IndexOf({x, y})];
    DistanceAlongLine(in, out, width_, places, borders);
    for (int x = 0; x < width_; ++x) squares[IndexOf({x, y})] = out[static_cast<std::size_t>(x)];
  }
  for (double& square : squares) square = std::min(limit, scale_ * std::sqrt(square));
  return squares;
}

OccupancyGrid OccupancyGrid::Inflated(double radius) const {
  OccupancyGrid grid = *this;
  if (!(radius > 0.0)) return grid;
  const std::vector<double> distances = ObstacleDistances(2.0 * radius);
  // What is exactly `radius` away counts, however the product above was rounded.
  const double reach = radius * (1.0 + 1e-12);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] <= reach) grid.cells_[i] = Cell::kOccupied;
  }
  return grid;
}

double OccupancyGrid::CastRay(Vec2 from, double angle, double range) const {
  const auto [sine, cosine] = SinCos(angle);
  const Vec2 start{(from.x - origin_.x) / scale_, (from.y - origin_.y) / scale_};
  const double length = range / scale_;
  CellIndex cell = CellOf(from);
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const int step_x = cosine > 0.0 ? 1 : -1;
  const int step_y = sine > 0.0 ? 1 : -1;
  const double delta_x = cosine != 0.0 ? 1.0 / std::abs(cosine) : kNever;
  const double delta_y = sine != 0.0 ? 1.0 / std::abs(sine) : kNever;
  double next_x =
      cosine != 0.0 ? (cosine > 0.0 ? cell.x + 1 - start.x : start.x - cell.x) * delta_x : kNever;
  double next_y =
      sine != 0.0 ? (sine > 0.0 ? cell.y + 1 - start.y : start.y - cell.y) * delta_y : kNever;
  double travelled = 0.0;
  while (travelled < length) {
    if (At(cell) == Cell::kOccupied) return travelled * scale_;
    // Beyond the map and on the way out there is nothing more to meet.
    if ((cell.x < 0 && step_x < 0) || (cell.x >= width_ && step_x > 0) ||
        (cell.y < 0 && step_y < 0) || (cell.y >= height_ && step_y > 0)) {
      return range;
    }
    if (next_x < next_y) {
      travelled = next_x;
      next_x += delta_x;
      cell.x += step_x;
    } else {
      travelled = next_y;
      next_y += delta_y;
      cell.y += step_y;
    }
  }
  return range;
}

}  // namespace ccmorse::navigation
