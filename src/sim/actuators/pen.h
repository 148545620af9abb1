#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "sim/canvas.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// The thesis's Pen (4.2.1): lets its robot draw on the canvas, by services only. Colours are
/// 0..255 a channel, alpha 0..1; cells outside the canvas are left out. save_image_copy writes a
/// PNG into the folder the simulator was told to use (`--out`), under the plain file name given.
/// set_layers, show_layer and get_layers are about the list of layers (canvas.h).
/// Two services take bytes, too: set_image_data 3 for each cell (red, green, blue), row by row from
/// the bottom; update_image_data rectangles, each of x, y (i32, little-endian), width, height (u16)
/// and 3 bytes for each of its cells.
class Pen : public Actuator {
 public:
  Pen(Robot& robot, const std::string& name, Canvas& canvas);
  void Act(const Instant&) override {}
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the canvas counts once, for all pens

 private:
  void AppendFields(std::string&) const override {}
  void AddLayerServices();
  void WriteImageData();
  void SetImage(std::string_view cells);
  void UpdateImage(std::string_view rectangles);
  void RequireAllCells(std::size_t pixels) const;  // throws WrongArgument

  Canvas& canvas_;
  std::string image_data_;  // the last answer of get_image_data, JSON
};

}  // namespace ccmorse::sim
