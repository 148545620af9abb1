#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libCCMorse/MorseActuator.h"
#include "libCCMorse/Paint.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// The pen that draws on the simulation's canvas (thesis 4.2.1, 4.2.2): a window with its origin in
/// the bottom-left corner, over the floor of the world. Only simulators with a canvas have it.
/// Owned by the client; any thread.
class MorsePen : public MorseActuator {
 public:
  explicit MorsePen(const MorseDeviceInfo& info);

  // --- Drawing leaves with the next Read(), and the canvas shows it then. Cells outside the canvas
  // are left out. The colour is written in any of Paint_t's ways: (r, g, b), (r, g, b, alpha), each
  // 0..255 or 0..1, or "#34AAFF" with or without alpha. Throws MorseError for text that is no
  // colour.

  /// Colours a cell (thesis 4.2.2): SetPixel(x, y, 0, 255, 0).
  template <class... Paint>
  void SetPixel(int x, int y, Paint... paint) {
    DrawPixel({x, y}, Paint_t(paint...));
  }
  /// Colours the cells of a line from (x0, y0) to (x1, y1), both included (thesis 4.2.2).
  template <class... Paint>
  void SetLine(int x0, int y0, int x1, int y1, Paint... paint) {
    DrawLine({x0, y0}, {x1, y1}, Paint_t(paint...));
  }
  void DrawPixel(ImagePoint_t at, const Paint_t& paint);                    ///< as SetPixel()
  void DrawLine(ImagePoint_t from, ImagePoint_t to, const Paint_t& paint);  ///< as SetLine()

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

  // --- The list of layers that the simulator's view shows, with a switch for each. WindowProxy
  // sees to it by itself; a simulator without such a list, such as MORSE, is told nothing and has
  // none.

  /// Sends the layers, from the lowest to the topmost, with the next Read(); `shown` is not sent.
  void SetLayers(const std::vector<CanvasLayer_t>& layers);
  /// Switches a layer on or off, as people do in the view; leaves with the next Read().
  void ShowLayer(const std::string& name, bool shown);
  /// The list, asked from the simulator; throws MorseError without an answer.
  std::vector<CanvasLayer_t> GetLayers();
  /// Has the next Read() ask for the list as well, without waiting for anything more. `take` gets
  /// it from the thread that reads; not called when there is no answer.
  void AskLayers(const std::function<void(const std::vector<CanvasLayer_t>&)>& take);

  // --- The canvas

  /// Changes the resolution, cells; what was drawn is gone.
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

 protected:
  std::vector<std::string> SetupServices() const override;
  void OnSetup(const std::string& service, const MorseValue& answer) override;

 private:
  void Draw(const char* service, const std::vector<int>& cells, const Paint_t& paint);
  void TakeSize(const MorseValue& size);

  // Under the data mutex.
  int width_ = 0;
  int height_ = 0;
  double cell_size_ = 0.0;
};

}  // namespace CCMorse
