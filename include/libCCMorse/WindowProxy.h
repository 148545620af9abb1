#pragma once

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "libCCMorse/MorsePen.h"
#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// The simulation's canvas in the shape of a proxy (thesis 4.2.2), over the first pen that the
/// simulation has. The real robot has no such thing: programs for both use it inside #ifdef _MORSE.
///
/// There is at most one. GetInstance(client, width, height) makes it, `delete &GetInstance()` ends
/// it (thesis listing C.2, line 80), and a new one may follow. It may outlive the client: then
/// drawing is ignored. Any thread may draw; making and deleting is up to one.
class WindowProxy : public MorseProxy {
 public:
  /// Makes the window with `width` times `height` cells, or changes the one there is to that size.
  /// Throws MorseError when the simulation has no pen or refuses the size, and when there is a
  /// window of another client.
  static WindowProxy& GetInstance(PlayerClient* client, int width, int height);
  /// The window. Throws MorseError when there is none.
  static WindowProxy& GetInstance();
  ~WindowProxy() override;

  // --- Drawing. Cells outside the canvas are left out. Drawing leaves with the next Read(), and
  // the canvas shows it then. Integer channels and alpha run 0..255 (held within), decimal ones
  // 0..1; alpha mixes the colour with what is there: 0 leaves it, the highest value covers it.

  /// Colours a cell, channels 0..255 (thesis 4.2.2).
  void SetPixel(int x, int y, int r, int g, int b);
  void SetPixel(int x, int y, int r, int g, int b, int alpha);
  void SetPixel(int x, int y, int r, int g, int b, double alpha);
  void SetPixel(int x, int y, unsigned char r, unsigned char g, unsigned char b);
  void SetPixel(int x, int y, unsigned char r, unsigned char g, unsigned char b,
                unsigned char alpha);
  /// Channels 0..1.
  void SetPixel(int x, int y, double r, double g, double b);
  void SetPixel(int x, int y, double r, double g, double b, double alpha);
  /// Colour as "#34AAFF". Throws MorseError when the text is no such colour.
  void SetPixel(int x, int y, const std::string& color);
  void SetPixel(int x, int y, const std::string& color, int alpha);
  void SetPixel(int x, int y, const std::string& color, double alpha);
  /// Any mixture of numbers: all are taken as decimal when a channel is, as integers otherwise,
  /// when only alpha may be decimal.
  template <class R, class G, class B, class... Alpha>
  std::enable_if_t<kAreNumbers<R, G, B, Alpha...>> SetPixel(int x, int y, R r, G g, B b,
                                                            Alpha... alpha) {
    using Channel = Channel_t<R, G, B>;
    SetPixel(x, y, static_cast<Channel>(r), static_cast<Channel>(g), static_cast<Channel>(b),
             static_cast<Channel_t<Channel, Alpha>>(alpha)...);
  }

  /// Colours the cells of a line from (x0, y0) to (x1, y1), both included, channels 0..255.
  void SetLine(int x0, int y0, int x1, int y1, int r, int g, int b);
  void SetLine(int x0, int y0, int x1, int y1, int r, int g, int b, int alpha);
  void SetLine(int x0, int y0, int x1, int y1, int r, int g, int b, double alpha);
  void SetLine(int x0, int y0, int x1, int y1, unsigned char r, unsigned char g, unsigned char b);
  void SetLine(int x0, int y0, int x1, int y1, unsigned char r, unsigned char g, unsigned char b,
               unsigned char alpha);
  /// Channels 0..1.
  void SetLine(int x0, int y0, int x1, int y1, double r, double g, double b);
  void SetLine(int x0, int y0, int x1, int y1, double r, double g, double b, double alpha);
  /// Colour as "#34AAFF". Throws MorseError when the text is no such colour.
  void SetLine(int x0, int y0, int x1, int y1, const std::string& color);
  void SetLine(int x0, int y0, int x1, int y1, const std::string& color, int alpha);
  void SetLine(int x0, int y0, int x1, int y1, const std::string& color, double alpha);
  /// Any mixture of numbers, as SetPixel() takes it.
  template <class R, class G, class B, class... Alpha>
  std::enable_if_t<kAreNumbers<R, G, B, Alpha...>> SetLine(int x0, int y0, int x1, int y1, R r, G g,
                                                           B b, Alpha... alpha) {
    using Channel = Channel_t<R, G, B>;
    SetLine(x0, y0, x1, y1, static_cast<Channel>(r), static_cast<Channel>(g),
            static_cast<Channel>(b), static_cast<Channel_t<Channel, Alpha>>(alpha)...);
  }

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

 private:
  WindowProxy(PlayerClient* client, MorsePen& pen);
  MorsePen* const pen_;  // owned by the client object, which the base class keeps alive
};

}  // namespace CCMorse
