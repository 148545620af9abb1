#pragma once

#include <algorithm>
#include <cstdint>

namespace ccmorse {

/// Calls `visit(int x, int y)` for every cell of Bresenham's line from (x0, y0) to (x1, y1), both
/// included, that lies in a grid of width x height cells (J. E. Bresenham, "Algorithm for computer
/// control of a digital plotter", 1965). What lies outside costs nothing. Precondition: coordinates
/// within +-1e9.
template <class Visit>
void ForEachLineCell(int x0, int y0, int x1, int y1, int width, int height, const Visit& visit) {
  const std::int64_t dx = std::max(std::int64_t{x1} - x0, std::int64_t{x0} - x1);
  const std::int64_t dy = std::max(std::int64_t{y1} - y0, std::int64_t{y0} - y1);
  const int sign_x = x1 >= x0 ? 1 : -1;
  const int sign_y = y1 >= y0 ? 1 : -1;
  // In closed form: after k steps along the longer axis the shorter one has made
  // floor((2 k short + long) / (2 long)). So a far-away end costs nothing: steps outside are
  // skipped.
  const bool steep = dy > dx;
  const std::int64_t steps = std::max(dx, dy);
  const std::int64_t minor = std::min(dx, dy);
  // The steps for which start + sign * k lies in the grid.
  const std::int64_t start = steep ? y0 : x0;
  const std::int64_t size = steep ? height : width;
  const bool up = (steep ? sign_y : sign_x) > 0;
  const std::int64_t first = std::max<std::int64_t>(0, up ? -start : start - (size - 1));
  const std::int64_t last = std::min(steps, up ? size - 1 - start : start);
  for (std::int64_t k = first; k <= last; ++k) {
    const std::int64_t side = steps == 0 ? 0 : (2 * k * minor + steps) / (2 * steps);
    const std::int64_t x = x0 + sign_x * (steep ? side : k);
    const std::int64_t y = y0 + sign_y * (steep ? k : side);
    if (x < 0 || x >= width || y < 0 || y >= height) continue;
    visit(static_cast<int>(x), static_cast<int>(y));
  }
}

}  // namespace ccmorse
