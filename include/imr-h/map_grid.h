#pragma once

#include <string>
#include <vector>

#include "imr-h/map_file.h"

namespace imr {

/// The grid map of the course's programs (specs: syrotek.md C): square cells that say how surely
/// there is a wall, from 0 (floor) by 0.5 (unknown) to 1 (a wall).
///
/// Cell (0, 0) is the bottom-left one, x to the right, y up, as on the canvas and in the world; a
/// file's first line becomes the topmost row (imr-h/map_file.h). A plain value: threads that share
/// one need a lock. Put right against the course's own class, whose interface this is: a map that
/// was read from a file knows the size of its cells, and 1 means a wall in code and comment.
class CMapGrid {
 public:
  static constexpr double FLOOR = 0.0;
  static constexpr double UNKNOWN = 0.5;
  static constexpr double WALL = 1.0;
  static constexpr double EMPTY = FLOOR;
  static constexpr double OCCUPIED = WALL;

  /// All cells unknown. `cellSize`: m. Throws argument_error unless all three are positive and
  /// there are at most 2^26 cells.
  CMapGrid(int width, int height, double cellSize);
  /// From a file that loadMap() reads; `cellSize`, m, counts for files that do not say it.
  /// Throws io_error if it cannot be read.
  explicit CMapGrid(const std::string& file, double cellSize = MAP_CELL_SIZE);

  int getWidth() const { return map_.width; }           ///< columns
  int getHeight() const { return map_.height; }         ///< rows
  double getCellSize() const { return map_.cellSize; }  ///< m
  bool contains(int x, int y) const {
    return x >= 0 && x < map_.width && y >= 0 && y < map_.height;
  }

  /// What is known of a cell, 0..1. Throws argument_error outside the map.
  double getCell(int x, int y) const { return map_.cells[checked(x, y)]; }
  /// Throws argument_error outside the map, and for a value outside of 0..1.
  void setCell(int x, int y, double value);
  /// Makes all cells `value`.
  void fill(double value);

  /// Takes in one measurement of one cell: `occupied` is what the sensor says of it, 0..1.
  ///
  /// **A task of the exploration: the program defines it**, in its own map_grid.cc; the library
  /// only declares it, and a program that never calls it needs none.
  void updateCell(int x, int y, double occupied);
  /// Takes in a beam of the laser: it went out in cell (rx, ry) and ended in cell (cx, cy), which
  /// may lie outside the map; `dist`: m, how far the obstacle there is from the laser, or infinity
  /// when the beam met none. All cells between the two are free, those of Bresenham's line.
  ///
  /// **A task of the exploration: the program defines it**, as updateCell().
  void updateCells(int rx, int ry, int cx, int cy, double dist);

  int getX(double metres) const;  ///< column that holds x [m], maybe outside the map
  int getY(double metres) const;  ///< row that holds y [m], maybe outside the map
  double getPosX(int x) const { return map_.originX + (x + 0.5) * map_.cellSize; }  ///< middle [m]
  double getPosY(int y) const { return map_.originY + (y + 0.5) * map_.cellSize; }  ///< middle [m]

  /// All cells row by row from the bottom, width x height of them.
  const std::vector<double>& cells() const { return map_.cells; }
  /// The same into memory for as many numbers.
  void copyTo(double* cells) const;
  /// Writes it as saveMap() does.
  void save(const std::string& file) const { saveMap(map_, file); }

 private:
  std::size_t checked(int x, int y) const;

  SMapFile map_;
};

}  // namespace imr
