#pragma once

#include <string>
#include <vector>

#include "imr-h/imr_exceptions.h"

namespace imr {

/// The map that a file holds. **Row 0 is the bottom row**, y grows upwards, as on the canvas and in
/// the world; files, whose first line is the top of the picture, are turned over as they are read.
/// This is the only place that turns anything: everything else in CCMorse and in the course's
/// programs counts rows from the bottom.
struct SMapFile {
  int width = 0;              ///< columns, cells
  int height = 0;             ///< rows, cells
  double cellSize = 0.0;      ///< m, side of a cell
  double originX = 0.0;       ///< m, left edge of column 0 in the world
  double originY = 0.0;       ///< m, lower edge of row 0 in the world
  std::vector<double> cells;  ///< height x width, row by row; 0 free, 0.5 unknown, 1 a wall
};

/// Cells of the course's maps, which do not say it themselves [m] (specs: syrotek.md B).
constexpr double MAP_CELL_SIZE = 0.02;

/// Reads a map. What it is follows from the name's ending:
///
///   .txt         the course's text maps: the number of rows, then the rows from the top, all of
///                one length; '.' is floor, '?' unknown, anything else a wall
///   .yaml .yml   ROS's map_server: image, resolution, origin, negate, occupied_thresh,
///                free_thresh and mode (trinary or scale); the image beside it is PGM or PNG
///   .pgm .png    a picture: dark is a wall, light is floor, what is between is unknown, by the
///                thresholds that map_server takes where none are given (0.65 and 0.196)
///
/// A .txt, .pgm or .png has cells of `cellSize` m, and lies at (0, 0).
/// Throws io_error that names the file, and the line where there is one, if it cannot be read or is
/// no such map, and argument_error if `cellSize` is not a positive number. At most 2^26 cells.
/// Any thread.
SMapFile loadMap(const std::string& file, double cellSize = MAP_CELL_SIZE);

/// Writes a map: `file` ends in .txt (floor below 0.35, walls above 0.65) or in .yaml, which gets a
/// .pgm of the same name beside it. loadMap() reads it back, each cell as floor, unknown or wall.
/// Throws io_error if it cannot be written, argument_error if `map` has not width x height cells
/// or the ending is another. Any thread.
void saveMap(const SMapFile& map, const std::string& file);

}  // namespace imr
