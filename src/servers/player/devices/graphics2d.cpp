#include "servers/player/devices/graphics2d.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/polygon.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr std::size_t kMostPoints = 10000;
constexpr double kFarthest = 1e8;  // cells

Color ColorOf(const wire::Color& color) { return {color.red, color.green, color.blue}; }

int CellOf(double place) { return static_cast<int>(std::floor(place)); }

void AppendNumber(std::string& out, std::uint32_t value, unsigned size) {
  for (unsigned i = 0; i < size; ++i) out += static_cast<char>(value >> (8U * i) & 0xffU);
}

}  // namespace

Graphics2d::Graphics2d(DeviceContext context, const sim::Robot& robot, std::uint16_t index)
    : Device(wire::kGraphics2d, index, "ccmorse",
             {{MessageType::kCommand, wire::kGraphics2dCmdClear},
              {MessageType::kCommand, wire::kGraphics2dCmdPoints},
              {MessageType::kCommand, wire::kGraphics2dCmdPolyline},
              {MessageType::kCommand, wire::kGraphics2dCmdPolygon},
              {MessageType::kCommand, wire::kGraphics2dCmdMultiline}}),
      context_(context),
      robot_(robot),
      pen_(robot.name() + ".pen") {}

bool Graphics2d::Place(const std::vector<wire::Point2d>& points) {
  placed_.clear();
  if (points.size() > kMostPoints) return false;
  const double cell = context_.simulation.canvas().cell_size();
  for (const wire::Point2d& point : points) {
    Vec2 at{point.px, point.py};
    // The robot's frame, or the world's as its file had it.
    at = index() == 0 ? Transform(robot_.pose(), at)
                      : at + context_.simulation.world().scene().origin;
    at = (1.0 / cell) * (at - context_.simulation.world().scene().low);
    if (!(std::fabs(at.x) < kFarthest && std::fabs(at.y) < kFarthest)) return false;
    placed_.push_back(at);
  }
  return true;
}

void Graphics2d::Tell(std::uint8_t subtype, const wire::Body& body) {
  switch (subtype) {
    case wire::kGraphics2dCmdClear: {
      const sim::Canvas& canvas = context_.simulation.canvas();
      const std::array<Json, 2> size = {Json(canvas.width()), Json(canvas.height())};
      context_.Run(pen_, "resize_canvas", size);
      return;
    }
    case wire::kGraphics2dCmdPoints: {
      wire::Graphics2dCmdPoints command;
      if (body.To(command) && Place(command.points)) DrawPoints(ColorOf(command.color));
      return;
    }
    case wire::kGraphics2dCmdPolyline: {
      wire::Graphics2dCmdPolyline command;
      if (body.To(command) && Place(command.points)) DrawLines(ColorOf(command.color), 1, false);
      return;
    }
    case wire::kGraphics2dCmdMultiline: {
      wire::Graphics2dCmdMultiline command;
      if (body.To(command) && Place(command.points)) DrawLines(ColorOf(command.color), 2, false);
      return;
    }
    default: {
      wire::Graphics2dCmdPolygon command;
      if (!body.To(command) || !Place(command.points)) return;
      if (command.filled != 0) Fill(ColorOf(command.fill_color));
      DrawLines(ColorOf(command.color), 1, true);
      return;
    }
  }
}

void Graphics2d::AddRectangle(int x, int y, int width, Color color) {
  AppendNumber(rectangles_, static_cast<std::uint32_t>(x), 4);
  AppendNumber(rectangles_, static_cast<std::uint32_t>(y), 4);
  AppendNumber(rectangles_, static_cast<std::uint32_t>(width), 2);
  AppendNumber(rectangles_, 1, 2);
  for (int i = 0; i < width; ++i) {
    for (const std::uint8_t channel : {color.r, color.g, color.b}) {
      rectangles_ += static_cast<char>(channel);
    }
  }
}

void Graphics2d::SendRectangles() {
  const auto target = context_.directory.Find(pen_, "update_image_data");
  if (target.service != nullptr && !rectangles_.empty()) {
    context_.directory.RunBytes(target, rectangles_, [](const sim::ServiceResult&) {});
  }
  rectangles_.clear();
}

void Graphics2d::DrawPoints(Color color) {
  for (const Vec2& point : placed_) AddRectangle(CellOf(point.x), CellOf(point.y), 1, color);
  SendRectangles();
}

void Graphics2d::DrawLines(Color color, std::size_t every, bool closed) {
  const auto draw = [&](Vec2 a, Vec2 b) {
    const std::array<Json, 7> line = {Json(CellOf(a.x)), Json(CellOf(a.y)),  Json(CellOf(b.x)),
                                      Json(CellOf(b.y)), Json(int{color.r}), Json(int{color.g}),
                                      Json(int{color.b})};
    context_.Run(pen_, "set_line", line);
  };
  for (std::size_t i = 0; i + 1 < placed_.size(); i += every) draw(placed_[i], placed_[i + 1]);
  if (closed && placed_.size() > 2) draw(placed_.back(), placed_.front());
}

// Row by row: cells whose middle is inside, by the even-odd rule.
void Graphics2d::Fill(Color color) {
  const sim::Canvas& canvas = context_.simulation.canvas();
  std::vector<double> crossings;
  for (int y = 0; y < canvas.height(); ++y) {
    const double middle = y + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Vec2 a = placed_[i];
      const Vec2 b = placed_[(i + 1) % placed_.size()];
      if ((a.y <= middle) == (b.y <= middle)) continue;
      crossings.push_back(a.x + (b.x - a.x) * ((middle - a.y) / (b.y - a.y)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(crossings[i] - 0.5)));
      const int last =
          std::min(canvas.width() - 1, static_cast<int>(std::ceil(crossings[i + 1] - 0.5)) - 1);
      if (first <= last) AddRectangle(first, y, last - first + 1, color);
    }
  }
  SendRectangles();
}

}  // namespace ccmorse::servers::player
