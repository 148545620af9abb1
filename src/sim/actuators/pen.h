#pragma once

#include "sim/canvas.h"
#include "sim/component.h"

namespace ccmorse::sim {

/// The thesis's Pen (4.2.1): lets its robot draw on the canvas, by services only. Colours are
/// 0..255 a channel, alpha 0..1; cells outside the canvas are left out. save_image_copy writes a
/// PNG into the folder the simulator was told to use (`--out`), under the plain file name given.
class Pen : public Actuator {
 public:
  Pen(Robot& robot, const std::string& name, Canvas& canvas);
  void Act(const Instant&) override {}
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // the canvas counts once, for all pens

 private:
  void AppendFields(std::string&) const override {}
  void WriteImageData();

  Canvas& canvas_;
  std::string image_data_;  // the last answer of get_image_data, JSON
};

}  // namespace ccmorse::sim
