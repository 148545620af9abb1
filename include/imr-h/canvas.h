#pragma once

// For programs of the simulator, in #ifdef _MORSE: the real robot has no canvas.

#include <string>

#include "imr-h/map_grid.h"
#include "libCCMorse/WindowProxy.h"

namespace imr {

/// The course's canvas (specs: syrotek.md C) on the layers of CCMorse::WindowProxy: maps, lines and
/// pixels in cells, drawn in layers that lie on each other in the order in which they were made,
/// and shown after the client's next Read(). The view zooms, pans and takes the mode.
///
/// One at a time: it makes the simulation's window, and ends it. Any thread.
class CCanvas {
 public:
  /// The course's 18 colours, in its order and with its spelling.
  enum Color {
    Red = 2,
    Cyan,
    Blue,
    DarkBlue,
    LightBlue,
    Purple,
    Yellow,
    Lime,
    Magenta,
    White,
    Silver,
    Gray,
    Black,
    Orange,
    Brown,
    Marron,
    Green,
    Olive
  };

  /// What a colour looks like.
  static CCMorse::Color_t colorOf(Color color) {
    switch (color) {
      case Red:
        return {255, 0, 0};
      case Cyan:
        return {0, 255, 255};
      case Blue:
        return {0, 0, 255};
      case DarkBlue:
        return {0, 0, 160};
      case LightBlue:
        return {173, 216, 230};
      case Purple:
        return {128, 0, 128};
      case Yellow:
        return {255, 255, 0};
      case Lime:
        return {0, 255, 0};
      case Magenta:
        return {255, 0, 255};
      case White:
        return {255, 255, 255};
      case Silver:
        return {192, 192, 192};
      case Gray:
        return {128, 128, 128};
      case Black:
        return {0, 0, 0};
      case Orange:
        return {255, 165, 0};
      case Brown:
        return {165, 42, 42};
      case Marron:
        return {128, 0, 0};
      case Green:
        return {0, 128, 0};
      case Olive:
        return {128, 128, 0};
    }
    return {0, 0, 0};
  }

  /// Makes the window with as many cells. Throws CCMorse::MorseError when the simulation has no
  /// canvas, or the program has one already.
  CCanvas(CCMorse::PlayerClient* client, int width, int height)
      : window_(&CCMorse::WindowProxy::GetInstance(client, width, height)) {}
  ~CCanvas() { delete window_; }
  CCanvas(const CCanvas&) = delete;
  CCanvas& operator=(const CCanvas&) = delete;

  /// A map in the layer "map": floor white, unknown grey, walls black. Throws CCMorse::MorseError
  /// unless it has the canvas's size.
  void draw(const CMapGrid& map) { layer("map", Black).SetOccupancy(map.cells()); }

  /// A cell in a layer. What lies outside is left out.
  void drawPixel(int x, int y, Color color, const std::string& layerName = "drawing") {
    const CCMorse::Color_t c = colorOf(color);
    layer(layerName, color).SetPixel(x, y, int{c.r}, int{c.g}, int{c.b});
  }
  /// The cells of a line in a layer, both ends included.
  void drawLine(int x1, int y1, int x2, int y2, Color color,
                const std::string& layerName = "drawing") {
    const CCMorse::Color_t c = colorOf(color);
    layer(layerName, color).SetLine(x1, y1, x2, y2, int{c.r}, int{c.g}, int{c.b});
  }
  /// Takes all out of a layer.
  void clear(const std::string& layerName = "drawing") { layer(layerName, Black).Clear(); }

  /// The layer of that name, to draw on by itself; made on top of all others, with its colour and
  /// transparency (0 covers, 1 is not seen), where there is none.
  CCMorse::GridMap& layer(const std::string& name, Color color, double transparency = 0.0) {
    if (window_->HasLayer(name)) return window_->GetLayer(name);
    return window_->AddLayer(name, colorOf(color), next_++, transparency);
  }

  /// Has the simulator save a picture of the canvas, NAME.png.
  void save(const std::string& name) { window_->SaveImageCopy(name); }

  CCMorse::WindowProxy& window() { return *window_; }

 private:
  CCMorse::WindowProxy* const window_;
  int next_ = 0;  // priority of the next layer
};

}  // namespace imr
