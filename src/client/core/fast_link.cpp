#include "client/core/fast_link.h"

#include "wire/canvas_code.h"

namespace CCMorse::core {

namespace wire = ccmorse::wire;

namespace {

constexpr int kMostAcross = 65535;
constexpr std::size_t kMostPixelCells = wire::kMostCells / 2;  // then a frame of pixels is finished
constexpr std::size_t kMostPixelCode = std::size_t{1} << 20;   // bytes; the same
static_assert(kMostPixelCode + kMostPixelCells * (wire::kCellBytes + 1) <= wire::kMostClientFrame);
static_assert(sizeof(Color_t) == wire::kCellBytes);

}  // namespace

void FastLinkWriter::Lines(std::string& out, std::string_view lines) {
  Finish(out);
  wire::FrameWriter(out, wire::FrameType::kLines).Bytes(lines);
}

void FastLinkWriter::Read(std::string& out, const std::vector<Subscription>& changes) {
  Finish(out);
  for (const Subscription& change : changes) {
    wire::FrameWriter frame(out, wire::FrameType::kSubscribe);
    frame.Short(change.id);
    frame.Byte(static_cast<std::uint8_t>(change.form));
    frame.Bytes(*change.device);
  }
  const wire::FrameWriter frame(out, wire::FrameType::kRead);
}

bool FastLinkWriter::Number(std::string& out, const std::string& component,
                            const std::string& service, std::uint16_t* id) {
  auto of_component = numbers_.find(component);
  if (of_component != numbers_.end()) {
    const auto known = of_component->second.find(service);
    if (known != of_component->second.end()) {
      *id = known->second;
      return true;
    }
  }
  if (services_.size() >= wire::kMostDeclared || component.size() > 0xFFFF) return false;
  *id = static_cast<std::uint16_t>(services_.size());
  services_.emplace_back(component, service);
  numbers_[component][service] = *id;
  wire::FrameWriter frame(out, wire::FrameType::kDeclare);
  frame.Short(*id);
  frame.Short(static_cast<std::uint16_t>(component.size()));
  frame.Bytes(component);
  frame.Bytes(service);
  return true;
}

bool FastLinkWriter::Command(std::string& out, const std::string& component,
                             const std::string& service, const double* numbers, std::size_t count) {
  std::uint16_t id = 0;
  Finish(out);
  if (count > wire::kMostNumbers || !Number(out, component, service, &id)) return false;
  wire::FrameWriter frame(out, wire::FrameType::kCommand);
  frame.Short(id);
  frame.Doubles(numbers, count);
  return true;
}

bool FastLinkWriter::Image(std::string& out, const std::string& component,
                           const std::string& service, int width, int height,
                           const std::vector<Color_t>& image) {
  std::uint16_t id = 0;
  Finish(out);
  if (width < 1 || height < 1 || width > kMostAcross || height > kMostAcross ||
      image.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height) ||
      image.size() > wire::kMostCells || !Number(out, component, service, &id)) {
    return false;
  }
  const std::size_t bytes = image.size() * wire::kCellBytes;
  const auto* const cells = reinterpret_cast<const std::uint8_t*>(image.data());
  if (width != width_ || height != height_) {
    image_.assign(bytes, 0);
    width_ = width;
    height_ = height;
  }
  // Even the worst image of so many cells stays below the limit of a frame.
  static_assert(wire::kMostCells * (wire::kCellBytes + 1) <= wire::kMostClientFrame);
  {
    wire::FrameWriter frame(out, wire::FrameType::kImage);
    frame.Short(id);
    frame.Short(static_cast<std::uint16_t>(width));
    frame.Short(static_cast<std::uint16_t>(height));
    wire::AppendChanges(out, image_.data(), cells, width, height);
  }
  image_.assign(cells, cells + bytes);
  return true;
}

bool FastLinkWriter::Pixels(std::string& out, const std::string& component,
                            const std::string& service, const PixelUpdate_t* pixels,
                            std::size_t count) {
  std::uint16_t id = 0;
  if (!Number(out, component, service, &id)) return false;
  if (pixels_service_ != id) Finish(out);
  pixels_service_ = id;
  for (std::size_t i = 0; i < count; ++i) {
    AddPixel(pixels[i].point.x, pixels[i].point.y, pixels[i].color);
    if (++pixels_ >= kMostPixelCells || code_.size() >= kMostPixelCode) Finish(out);
  }
  return true;
}

// Cells that follow each other in a row, and rows of the same columns that follow each other
// upwards, make one rectangle.
void FastLinkWriter::AddPixel(int x, int y, Color_t color) {
  if (count_ > 0) {
    bool fits = false;
    if (columns_ == 0) {
      fits = y == y_ && x == x_ + count_ && count_ < kMostAcross;
      if (!fits && y == y_ + 1 && x == x_) {
        columns_ = count_;
        fits = true;
      }
    } else {
      fits = x == x_ + count_ % columns_ && y == y_ + count_ / columns_ &&
             count_ / columns_ < kMostAcross;
    }
    if (!fits) FinishRectangle();
  }
  if (count_ == 0) {
    x_ = x;
    y_ = y;
  }
  cells_.insert(cells_.end(), {color.r, color.g, color.b});
  ++count_;
}

void FastLinkWriter::FinishRectangle() {
  if (count_ == 0) return;
  const int columns = columns_ == 0 ? count_ : columns_;
  const int rows = count_ / columns;
  wire::AppendRectangle(code_, x_, y_, columns, rows, cells_.data());
  const int rest = count_ % columns;  // the start of a row
  if (rest > 0) {
    wire::AppendRectangle(code_, x_, y_ + rows, rest, 1,
                          cells_.data() + static_cast<std::size_t>(columns) *
                                              static_cast<std::size_t>(rows) * wire::kCellBytes);
  }
  cells_.clear();
  count_ = columns_ = 0;
}

void FastLinkWriter::Finish(std::string& out) {
  if (pixels_ == 0) return;
  pixels_ = 0;
  FinishRectangle();
  wire::FrameWriter frame(out, wire::FrameType::kPixels);
  frame.Short(pixels_service_);
  frame.Bytes(code_);
  code_.clear();
}

}  // namespace CCMorse::core
