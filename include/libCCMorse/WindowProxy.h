#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libCCMorse/GridMap.h"
#include "libCCMorse/MorsePen.h"
#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// The simulation's canvas in the shape of a proxy (thesis 4.2.2), over the first pen that the
/// simulation has. The real robot has no such thing: programs for both use it inside #ifdef _MORSE.
///
/// There is at most one. GetInstance(client, width, height) makes it, `delete &GetInstance()` ends
/// it (thesis listing C.2, line 80), and a new one may follow. It may outlive the client: then
/// drawing is ignored. Any thread may draw; making and deleting is up to one.
///
/// The window draws straight on the canvas, as the pen does, or manages grid maps in layers:
/// AddLayer() makes one, and each Read() brings what all of them show together to the canvas, only
/// the cells that have changed. Beneath the lowest layer there is white; a cell that no layer ever
/// coloured is left alone. What is drawn straight on the canvas stays until a layer changes
/// that cell.
class WindowProxy : public MorseProxy {
 public:
  /// Makes the window with `width` times `height` cells, or changes the one there is to that size.
  /// Throws MorseError when the simulation has no pen or refuses the size, and when there is a
  /// window of another client.
  static WindowProxy& GetInstance(PlayerClient* client, int width, int height);
  /// The window. Throws MorseError when there is none.
  static WindowProxy& GetInstance();
  ~WindowProxy() override;

  // --- Drawing, as MorsePen does it: it leaves with the next Read(), cells outside the canvas are
  // left out, and the colour is written in any of Paint_t's ways, such as 0, 255, 0.

  /// Colours a cell (thesis 4.2.2).
  template <class... Paint>
  void SetPixel(int x, int y, Paint... paint) {
    pen_->SetPixel(x, y, paint...);
  }
  /// Colours the cells of a line from (x0, y0) to (x1, y1), both included (thesis 4.2.2).
  template <class... Paint>
  void SetLine(int x0, int y0, int x1, int y1, Paint... paint) {
    pen_->SetLine(x0, y0, x1, y1, paint...);
  }

  // --- What is on the canvas. Layers are brought up to date first.

  /// Colour of a cell, asked from the simulator. Throws MorseError outside the canvas or without an
  /// answer; so do the following requests.
  Color_t GetPixel(int x, int y);
  /// The whole image, row by row from the bottom, each from the left.
  std::vector<Color_t> GetImageData();
  /// Replaces the whole image; leaves with the next Read(). Throws MorseError unless it has
  /// width times height cells.
  void SetImageData(const std::vector<Color_t>& image);
  /// Colours the given cells; leaves with the next Read().
  void UpdateImageData(const std::vector<PixelUpdate_t>& pixels);
  /// Saves the canvas as PNG under `name`, where the simulator runs.
  void SaveImageCopy(const std::string& name);

  // --- Layers of grid maps (thesis 4.2.2)

  /// Makes a layer, clear and of the window's size. `color`: of cells that are set without a colour
  /// of their own; `priority`: layers of a higher one lie above; `transparency`: 0 (covers) to 1.
  /// The layer is the window's, until RemoveLayer(). Throws MorseError when there is one of that
  /// name, or for a transparency out of its range.
  GridMap& AddLayer(const std::string& name, Color_t color = Color_t(), int priority = 0,
                    double transparency = 0.0);
  /// The layer of that name. Throws MorseError that lists the layers when there is none.
  GridMap& GetLayer(const std::string& name) const;
  bool HasLayer(const std::string& name) const;
  /// The names of all layers, from the lowest to the topmost.
  std::vector<std::string> GetLayerNames() const;
  /// Ends a layer. Throws MorseError when there is none of that name.
  void RemoveLayer(const std::string& name);
  /// Has all cells of all layers drawn again with the next Read(), over whatever was drawn straight
  /// on the canvas or by others, and after the simulation was reset.
  void Redraw();

  // --- The canvas

  /// Changes the resolution, cells; what was drawn is gone, in the layers, too.
  void ResizeCanvas(int width, int height);
  /// Cells across and up, as of the last ResizeCanvas() or RefreshSize().
  int GetWidth() const;
  int GetHeight() const;
  /// Edge of a cell, m.
  double GetCellSize() const;
  /// Asks the simulator for size and cell size, should another client have changed them.
  void RefreshSize();
  /// Column of the cell that holds x, m in the world, held within the canvas; 0 for no number.
  int GetX(double x) const;
  /// Row of the cell that holds y, m in the world, held within the canvas; 0 for no number.
  int GetY(double y) const;

 private:
  WindowProxy(PlayerClient* client, MorsePen& pen);
  MorsePen* const pen_;  // owned by the client object, which the base class keeps alive
  const std::shared_ptr<Layers> layers_;
  std::shared_ptr<void> before_read_;
};

}  // namespace CCMorse
