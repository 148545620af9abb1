#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "libCCMorse/GridMap.h"
#include "libCCMorse/MorsePen.h"

namespace CCMorse {

inline constexpr Color_t kWhite{255, 255, 255};

/// The layers of a window, and what they make together (thesis 4.2.2). Whoever changes a cell marks
/// it; Compose() works the marked ones out and sends those whose colour is another than before. The
/// simulator is told the list of layers whenever it changes, and asked once a simulated second
/// which of them people have switched off in its view (docs/canvas.md). Any thread.
class Layers : public std::enable_shared_from_this<Layers> {
 public:
  /// How a cell of a layer is kept: 0 is clear; the lowest 24 bits are a colour, 0xRRGGBB.
  static constexpr std::uint32_t kColored = 1U << 24U;  ///< a colour of its own
  static constexpr std::uint32_t kOwn = 2U << 24U;      ///< the layer's colour
  static std::uint32_t Pack(Color_t color) {
    return std::uint32_t{color.r} << 16U | std::uint32_t{color.g} << 8U | color.b;
  }
  static Color_t Unpack(std::uint32_t bits) {
    return {static_cast<unsigned char>(bits >> 16U), static_cast<unsigned char>(bits >> 8U),
            static_cast<unsigned char>(bits)};
  }

  /// `pen` outlives the layers.
  explicit Layers(MorsePen& pen);

  GridMap& Add(const std::string& name);         ///< throws MorseError when there is one
  GridMap* Find(const std::string& name) const;  ///< nullptr when there is none
  void Remove(const std::string& name);          ///< throws MorseError when there is none
  std::vector<std::string> Names() const;        ///< from the lowest to the topmost

  /// Clears all layers and takes the pen's size; what is on the canvas is taken as clear, too.
  void Restart();
  /// Queues all cells that have changed since the last call.
  void Compose();
  /// Has all cells sent again with the next Compose().
  void SendAll();
  /// To be called before each read: queues the list if it has changed, and has the read ask for the
  /// switches when it is time to.
  void Ask();
  /// Queues an empty list: there is nothing left to be switched.
  void Retire();

 private:
  friend class GridMap;

  void Order();   // after a change of priorities
  void Resize();  // to the pen's size
  void Mark(std::size_t cell) {
    marked_[cell] = 1;
    any_marked_ = true;
  }
  void MarkUnclear(const GridMap& map);  // all cells that are not clear in it
  void SendList();
  void Switch(const std::vector<CanvasLayer_t>& list);

  MorsePen& pen_;
  mutable std::mutex mutex_;  // guards the maps, too
  int width_ = 0;
  int height_ = 0;
  std::vector<std::unique_ptr<GridMap>> maps_;  // from the lowest to the topmost
  std::uint64_t made_ = 0;                      // maps so far
  bool any_marked_ = false;
  bool list_changed_ = false;
  double next_question_ = 0.0;          // s, simulated
  std::vector<unsigned char> marked_;   // by cell
  std::vector<std::uint32_t> sent_;     // by cell: kColored and a colour; 0 when never drawn
  std::vector<PixelUpdate_t> changes_;  // scratch
};

}  // namespace CCMorse
