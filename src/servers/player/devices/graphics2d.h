#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/pose.h"
#include "servers/player/device.h"
#include "servers/player/device_context.h"
#include "sim/robots/robot.h"

namespace ccmorse::servers::player {

/// graphics2d (specs: player.md B.7): draws on the simulation's canvas, in m: at index 0 in the
/// frame of the robot where it then is, else in the world's. What is drawn stays where it is.
/// Colours are opaque, whatever their alpha: programs often leave it 0. Of messages with more than
/// 10000 points, and of points that are not finite, nothing is drawn.
class Graphics2d : public Device {
 public:
  Graphics2d(DeviceContext context, const sim::Robot& robot, std::uint16_t index);

 protected:
  void Tell(std::uint8_t subtype, const wire::Body& body) override;

 private:
  struct Cell {
    int x, y;
  };
  // Where points are, in cells, not whole ones; false when they are not to be drawn.
  bool Place(const std::vector<wire::Point2d>& points);
  void DrawPoints(Color color);
  // A line to each next point; with `every` 2 between pairs of points only.
  void DrawLines(Color color, std::size_t every, bool closed);
  void Fill(Color color);
  void AddRectangle(int x, int y, int width, Color color);
  void SendRectangles();

  DeviceContext context_;
  const sim::Robot& robot_;
  std::string pen_;
  std::vector<Vec2> placed_;
  std::string rectangles_;
};

}  // namespace ccmorse::servers::player
