#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "scene/scenario.h"
#include "sim/state_hash.h"

namespace ccmorse::sim {

/// A layer of which the program that draws makes the canvas (thesis 4.2.2). The canvas only keeps
/// the list, so that people can switch layers: the picture is the program's.
struct CanvasLayer {
  std::string name;
  int priority = 0;     ///< a higher one lies above
  bool visible = true;  ///< as the program wants it
  bool shown = true;    ///< as people want it; seen is what both want
  bool operator==(const CanvasLayer&) const = default;
};

/// The grid map that robots draw on and people look at: one in a simulation, passive
/// (thesis 4.2.1). Cells are square; cell (0, 0) lies at the world's bottom-left corner, x to the
/// right, y up. A cell nobody has drawn on is clear: it shows the floor and reads as white. Not
/// thread safe.
class Canvas {
 public:
  Canvas(const scene::CanvasDef& def, double world_x, double world_y);

  int width() const { return width_; }    ///< cells
  int height() const { return height_; }  ///< cells
  /// Edge of one cell, m: the smallest square with which the canvas covers the whole world.
  double cell_size() const;

  /// A new resolution, 1..4096 each way; the canvas is clear then.
  void Resize(int width, int height);

  /// Draws a cell; alpha from 0 (nothing) to 1 (covers what was there). Outside the canvas:
  /// nothing.
  void SetPixel(int x, int y, Color color, double alpha = 1.0);
  /// Draws a rectangle of cells, `colors` (height x width) row by row from its bottom-left corner
  /// at (x, y). The part outside the canvas is left out. Precondition: width and height up to
  /// 65535.
  void SetRectangle(int x, int y, int width, int height, std::span<const Color> colors);
  /// White where nothing was drawn. Precondition: inside the canvas.
  Color GetPixel(int x, int y) const;
  bool IsDrawn(int x, int y) const;
  bool Contains(int x, int y) const { return x >= 0 && x < width_ && y >= 0 && y < height_; }

  /// Every cell of Bresenham's line once, both ends included (thesis 4.2.1, [32]). The part outside
  /// the canvas is left out and costs nothing. Precondition: coordinates within +-1e9.
  void DrawLine(int x0, int y0, int x1, int y1, Color color, double alpha = 1.0);

  /// Changes with every change of the canvas.
  std::uint64_t revision() const { return revision_; }

  /// Adds every cell that was drawn on, with its place and colour.
  void AddToHash(StateHash& hash) const;

  /// Clear, in the resolution of the start. The list of layers stays: programs send theirs only
  /// when it changes.
  void Reset();

  /// The layers, from the lowest to the topmost, as SetLayers() was told. No part of the hash: they
  /// change no cell.
  const std::vector<CanvasLayer>& layers() const { return layers_; }
  /// A new list of layers. Those that were there before stay shown or hidden, whatever `layers`
  /// says. Precondition: no name twice.
  void SetLayers(std::vector<CanvasLayer> layers);
  /// Switches a layer on or off. False when there is none of that name.
  bool ShowLayer(const std::string& name, bool shown);
  /// Changes with every change of the list.
  std::uint32_t layers_revision() const { return layers_revision_; }

  /// Folder that SaveCopy writes to; "." at start.
  void set_picture_folder(const std::string& folder) { picture_folder_ = folder; }

  /// Writes the canvas as a PNG under a plain file name into the picture folder, and returns the
  /// path. Clients may ask for it, so a name that leads elsewhere is refused. Throws Error.
  std::string SaveCopy(const std::string& name) const;

  /// As a picture, y up: row 0 of the image is the canvas's top row.
  Image ToImage() const;

 private:
  std::size_t At(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  scene::CanvasDef def_;
  std::string picture_folder_ = ".";
  double world_x_;
  double world_y_;
  int width_ = 0;
  int height_ = 0;
  std::uint64_t revision_ = 0;
  std::vector<Color> cells_;  // (height x width), row 0 at the bottom
  std::vector<bool> drawn_;   // (height x width)
  std::vector<CanvasLayer> layers_;
  std::uint32_t layers_revision_ = 0;
};

}  // namespace ccmorse::sim
