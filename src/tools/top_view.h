#pragma once

#include <cstdint>
#include <vector>

#include "base/image.h"
#include "base/pose.h"
#include "scene/robots.h"
#include "scene/scenario.h"

namespace ccmorse::tools {

/// A robot as a picture from above shows it.
struct TopViewRobot {
  const scene::RobotModel* model = nullptr;  ///< its shape; must outlive the call
  Pose2 pose;                                ///< m and rad
  Color color;
  /// Ends of the laser's beams in the world, m, counter-clockwise; empty for no fan.
  std::vector<Vec2> scan;
  Vec2 scan_origin;  ///< m, in the world: where the beams start
};

/// The canvas on the floor. Cell (x, y) is entry y * width + x; (0, 0) is the bottom-left one and
/// starts in the world's origin.
struct TopViewCanvas {
  int width = 0;                    ///< cells
  int height = 0;                   ///< cells
  double cell_size = 0.02;          ///< m, > 0
  std::vector<Color> colors;        ///< width * height
  std::vector<std::uint8_t> alpha;  ///< width * height; 0 leaves the floor as it is, 255 covers it
};

/// What a picture of the world straight from above shows (as thesis Fig. 4.1 and 4.8).
struct TopView {
  const scene::World* world = nullptr;  ///< must outlive the call
  std::vector<TopViewRobot> robots;
  TopViewCanvas canvas;             ///< none where its width is 0
  double pixels_per_metre = 220.0;  ///< 10..2000
  double margin = 0.05;             ///< m, >= 0, of background around the floor
};

/// Paints the view, +y upwards. Boxes that are down show as faint outlines. The same input gives
/// the same bytes on every machine. Throws Error for a picture of more than 8192 pixels a side, a
/// scale out of range, or canvas data of another size than it says.
Image RenderTopView(const TopView& view);

/// The pixel (column x, row y, row 0 at the top) of RenderTopView's picture in which `point` of the
/// world lies; outside the picture for points beyond the margin.
struct Pixel {
  int x = 0;
  int y = 0;
};
Pixel PixelOf(const TopView& view, Vec2 point);

}  // namespace ccmorse::tools
