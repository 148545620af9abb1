#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libCCMorse/Paint.h"
#include "libCCMorse/Types.h"
#include "libplayerc++/ranging.h"

namespace CCMorse {

class Layers;

/// The colours of the thesis's figures 4.5 to 4.9, for layers that show the same.
namespace LayerColor {
inline constexpr Color_t kScan{0, 255, 0};         ///< what the laser sees: green
inline constexpr Color_t kTrace{255, 0, 0};        ///< where the robot was: red
inline constexpr Color_t kInflated{0, 0, 255};     ///< obstacles made larger: blue
inline constexpr Color_t kPath{0, 0, 160};         ///< a planned path: dark blue
inline constexpr Color_t kFree{255, 255, 255};     ///< explored and free: white
inline constexpr Color_t kUnknown{128, 128, 128};  ///< not explored yet: grey
inline constexpr Color_t kObstacle{0, 0, 0};       ///< black
}  // namespace LayerColor

/// A grid map that lies as a layer in WindowProxy (thesis 4.2.2): it has the window's cells, (0, 0)
/// in the bottom-left corner, and is clear at first. What its cells show on the canvas depends on
/// the layers above and beneath; the canvas shows it after the next Read(). Made by
/// WindowProxy::AddLayer() and owned by the window. Any thread.
///
/// A cell is clear, has a colour of its own, or has the layer's colour, which SetColor() changes
/// for all such cells. Cells outside the map are left out. Every call that takes a paint takes any
/// of Paint_t's ways and throws MorseError for text that is no colour.
class GridMap {
 public:
  ~GridMap();
  GridMap(const GridMap&) = delete;
  GridMap& operator=(const GridMap&) = delete;

  // --- The layer

  const std::string& GetName() const { return name_; }
  /// The colour of cells that were set without one; its alpha counts as full. Black at first.
  template <class... Paint>
  void SetColor(Paint... paint) {
    SetOwnColor(Paint_t(paint...).color());
  }
  void SetColor(Color_t color) { SetOwnColor(color); }
  Color_t GetColor() const;
  /// How much of the layers beneath shines through, 0 (nothing, as at first) to 1 (the layer is not
  /// seen). Throws MorseError outside of it.
  void SetTransparency(double transparency);
  double GetTransparency() const;
  /// Cells of this colour count as clear: they show what lies beneath. None at first.
  template <class... Paint>
  void SetTransparentColor(Paint... paint) {
    SetKey(Paint_t(paint...).color());
  }
  void SetTransparentColor(Color_t color) { SetKey(color); }
  void RemoveTransparentColor() { SetKey(std::nullopt); }
  std::optional<Color_t> GetTransparentColor() const;
  /// A layer of higher priority lies above; of equal ones, the one that was made later. 0 at first.
  void SetPriority(int priority);
  int GetPriority() const;
  /// Whether the layer is shown at all; true at first. It can be drawn on either way.
  void SetVisible(bool visible);
  bool IsVisible() const;
  /// Whether people who look at the simulator's view have the layer switched on, as they do at
  /// first. A switch takes effect with a Read() within a simulated second. A layer that is visible
  /// and shown is seen.
  bool IsShown() const;

  int GetWidth() const;   ///< cells, the window's
  int GetHeight() const;  ///< cells, the window's

  // --- Cells

  /// Gives a cell the layer's colour.
  void SetPixel(int x, int y);
  /// Gives a cell a colour of its own. An alpha mixes it with the cell's colour so far, as the
  /// canvas does (MorsePen), where clear counts as white.
  template <class... Paint>
  void SetPixel(int x, int y, Paint... paint) {
    DrawPixel({x, y}, Paint_t(paint...));
  }
  /// The cells of Bresenham's line, both ends included, in the layer's colour.
  void SetLine(int x0, int y0, int x1, int y1);
  /// The same in a colour of their own.
  template <class... Paint>
  void SetLine(int x0, int y0, int x1, int y1, Paint... paint) {
    DrawLine({x0, y0}, {x1, y1}, Paint_t(paint...));
  }
  void DrawPixel(ImagePoint_t at, const Paint_t& paint);                    ///< as SetPixel()
  void DrawLine(ImagePoint_t from, ImagePoint_t to, const Paint_t& paint);  ///< as SetLine()
  /// The colour of a cell in this layer; none where it is clear, or outside.
  std::optional<Color_t> GetPixel(int x, int y) const;
  void ClearPixel(int x, int y);
  /// Clears all cells.
  void Clear();

  // --- Whole maps. Only cells that change are drawn anew.

  /// An occupancy grid: what is known of each cell, from 0 (free, white) by 0.5 (unknown, grey) to
  /// 1 (an obstacle, black), row by row from the bottom; beyond, the nearest of these counts, and
  /// what is no number is unknown. Throws MorseError unless there are width times height.
  void SetOccupancy(const std::vector<double>& cells);
  /// One cell of it.
  void SetOccupancy(int x, int y, double occupancy);
  /// What a laser sees (thesis 4.2.1): all cells whose middles lie in the area between the scanner
  /// and the ends of its beams, in the layer's colour; all others are clear. `robot`: m, rad, in
  /// the world; where the scanner sits on it comes from the proxy. A beam without return reaches
  /// as far as the proxy says.
  void SetScan(const player_pose2d_t& robot, PlayerCc::LaserProxy& laser);
  /// The area within a polygon of corners in the world, m, in the layer's colour; all other cells
  /// are clear. Even-odd rule. Corners that are no numbers are left out.
  void SetArea(const std::vector<player_point_2d_t>& corners);
  /// Obstacles made larger (thesis 4.2.2): cells whose middle is within `radius`, m, of that of a
  /// black cell of `map`, in the layer's colour. The obstacles themselves are left clear, so that
  /// they can be told apart. `map` is of the same window. Throws MorseError for a negative radius.
  void SetInflated(const GridMap& map, double radius);
  /// A path of lines between points in the world, m; all other cells are clear.
  void SetPath(const std::vector<player_point_2d_t>& points);
  /// Draws on a trace of the robot: the line from the last point to this one, m in the world.
  /// Clear() begins a new one.
  void AddToTrace(double x, double y);

 private:
  friend class Layers;
  using Cell = std::uint32_t;  // 0: clear; else a colour and how it came (layers.h)

  GridMap(Layers& layers, const std::string& name, std::uint64_t serial);
  void SetOwnColor(Color_t color);
  void SetKey(std::optional<Color_t> color);
  // All under the mutex of the layers, which they share.
  std::size_t At(int x, int y) const;
  bool Contains(int x, int y) const;
  void Set(int x, int y, Cell cell);
  void Mix(int x, int y, const Paint_t& paint);
  void SetAt(std::size_t at, Cell cell);
  void Replace(const std::vector<Cell>& cells);
  void ShowAgain();
  Color_t ColorOf(Cell cell) const;
  // The cell of a point, m, which may be outside; none for what is no number.
  static std::optional<ImagePoint_t> CellOf(double x, double y, double size);
  static Cell Grey(double occupancy);

  Layers& layers_;
  const std::string name_;
  const std::uint64_t serial_;  // of two maps, the later one has the higher
  Color_t color_;
  double transparency_ = 0.0;
  std::optional<Color_t> key_;
  int priority_ = 0;
  bool visible_ = true;
  bool shown_ = true;        // as of the last answer to Layers::Ask()
  std::vector<Cell> cells_;  // (height x width), row 0 at the bottom
  std::optional<ImagePoint_t> trace_end_;
};

}  // namespace CCMorse
