// A pen in C++: draws a trace of its robot on the canvas, wider the faster it goes.
//
// Built by `make` in this folder; cpp.py mounts it. How to write one: docs/components.md of CCMorse.

#include <ccmorse/plugin.h>

#include <cmath>

class Brush : public ccmorse::Actuator {
 public:
  Brush() {
    // Clients send lines with these fields; the last one holds until the next.
    AddData("down", true);
    AddProperty("CellSize", &cell_size_);
    AddProperty("Left", &left_);
    AddProperty("Bottom", &bottom_);
    AddService("line", "x0 y0 x1 y1", [this](const ccmorse::Values& at) {
      DrawLine(Cell(at[0]), Cell(at[1]), Cell(at[2]), Cell(at[3]), 30, 120, 30);
      return ccmorse::Value();
    });
    AddService("clear", "", [this](const ccmorse::Values&) {
      ClearCanvas();
      return ccmorse::Value();
    });
    // Answers when the robot has drawn so many metres.
    AddAsyncService("draw", "metres", [this](const ccmorse::Values& arguments) {
      drawn_ = 0.0;
      wanted_ = arguments[0].Number();
    });
  }

  void DefaultAction() override {
    const ccmorse::Pose here = GetRobotPose();
    const double way = moved_ ? std::hypot(here.x - last_.x, here.y - last_.y) : 0.0;
    last_ = here;
    moved_ = true;
    if (!Get("down").Flag()) return;
    const int x = static_cast<int>(std::floor((here.x - left_) / cell_size_));
    const int y = static_cast<int>(std::floor((here.y - bottom_) / cell_size_));
    const int wide = way > 0.01 ? 2 : 1;
    DrawLine(x, y - wide, x, y + wide, 200, 30, 30);
    drawn_ += way;
    if (drawn_ >= wanted_) Complete(ccmorse::Status::kSuccess, drawn_);
  }

 private:
  static int Cell(const ccmorse::Value& value) { return static_cast<int>(value.Number()); }

  double cell_size_ = 0.25;  // m, of the canvas
  double left_ = -20.0;      // m: where the canvas's bottom-left corner lies
  double bottom_ = -20.0;
  double drawn_ = 0.0;       // m, since `draw` was called
  double wanted_ = 0.0;      // m
  bool moved_ = false;       // last_ is known
  ccmorse::Pose last_{};
};

CCMORSE_PLUGIN(Brush)
