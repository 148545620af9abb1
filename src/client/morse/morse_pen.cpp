#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorsePen.h"

namespace CCMorse {

namespace {

const bool kRegistered = RegisterMorseDevice({{"pen"}, {"Pen"}, [](const MorseDeviceInfo& info) {
                                                return std::make_unique<MorsePen>(info);
                                              }});

// Not sent: the simulator takes a colour without alpha as covering.
constexpr double kOpaque = -1.0;

// The simulator takes cells in this range, on the canvas or not.
constexpr int kFarthestCell = 1000000000;

Color_t Color(int r, int g, int b) {
  const auto channel = [](int c) { return static_cast<unsigned char>(std::clamp(c, 0, 255)); };
  return Color_t{channel(r), channel(g), channel(b)};
}

// Channels 0..1; no number counts as 0.
Color_t Color(double r, double g, double b) {
  const auto channel = [](double c) {
    return static_cast<unsigned char>(c > 0.0 ? std::lround(std::min(c, 1.0) * 255.0) : 0);
  };
  return Color_t{channel(r), channel(g), channel(b)};
}

Color_t Color(const std::string& text, const char* function) {
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
    throw MorseError("\"" + text + "\" is no colour; write it as \"#34AAFF\"", function);
  }
  const auto value = std::strtoul(text.c_str() + 1, nullptr, 16);
  return Color_t{static_cast<unsigned char>(value >> 16U & 0xFFU),
                 static_cast<unsigned char>(value >> 8U & 0xFFU),
                 static_cast<unsigned char>(value & 0xFFU)};
}

Color_t Color(const MorseValue& value) {
  return Color(value.GetInt("0"), value.GetInt("1"), value.GetInt("2"));
}

// The index of the cell that holds a coordinate, of `count` cells of `size` m.
int Cell(double coordinate, double size, int count) {
  if (count <= 0 || !(size > 0.0)) return 0;
  const double cell = std::floor(coordinate / size);
  if (!(cell > 0.0)) return 0;
  return cell < count ? static_cast<int>(cell) : count - 1;
}

}  // namespace

MorsePen::MorsePen(const MorseDeviceInfo& info) : MorseActuator(info) {}

std::vector<std::string> MorsePen::SetupServices() const { return {"get_size", "get_cell_size"}; }

void MorsePen::OnSetup(const std::string& service, const MorseValue& answer) {
  if (service == "get_size") TakeSize(answer);
  if (service == "get_cell_size") {
    const std::lock_guard lock(DataMutex());
    cell_size_ = answer.GetDouble("");
  }
}

void MorsePen::TakeSize(const MorseValue& size) {
  const std::lock_guard lock(DataMutex());
  width_ = std::max(size.GetInt("0"), 0);
  height_ = std::max(size.GetInt("1"), 0);
}

void MorsePen::Draw(const char* service, const std::vector<int>& cells, Color_t color,
                    double alpha) {
  MorseArgs args;
  for (const int cell : cells) args.Add(std::clamp(cell, -kFarthestCell, kFarthestCell));
  args.Add(int{color.r}).Add(int{color.g}).Add(int{color.b});
  if (alpha != kOpaque) args.Add(alpha > 0.0 ? std::min(alpha, 1.0) : 0.0);
  Command(service, args);
}

void MorsePen::SetPixel(int x, int y, int r, int g, int b) {
  Draw("set_pixel", {x, y}, Color(r, g, b), kOpaque);
}

void MorsePen::SetPixel(int x, int y, int r, int g, int b, int alpha) {
  Draw("set_pixel", {x, y}, Color(r, g, b), alpha / 255.0);
}

void MorsePen::SetPixel(int x, int y, int r, int g, int b, double alpha) {
  Draw("set_pixel", {x, y}, Color(r, g, b), alpha);
}

void MorsePen::SetPixel(int x, int y, unsigned char r, unsigned char g, unsigned char b) {
  Draw("set_pixel", {x, y}, Color_t{r, g, b}, kOpaque);
}

void MorsePen::SetPixel(int x, int y, unsigned char r, unsigned char g, unsigned char b,
                        unsigned char alpha) {
  Draw("set_pixel", {x, y}, Color_t{r, g, b}, alpha / 255.0);
}

void MorsePen::SetPixel(int x, int y, double r, double g, double b) {
  Draw("set_pixel", {x, y}, Color(r, g, b), kOpaque);
}

void MorsePen::SetPixel(int x, int y, double r, double g, double b, double alpha) {
  Draw("set_pixel", {x, y}, Color(r, g, b), alpha);
}

void MorsePen::SetPixel(int x, int y, const std::string& color) {
  Draw("set_pixel", {x, y}, Color(color, "MorsePen::SetPixel()"), kOpaque);
}

void MorsePen::SetPixel(int x, int y, const std::string& color, int alpha) {
  Draw("set_pixel", {x, y}, Color(color, "MorsePen::SetPixel()"), alpha / 255.0);
}

void MorsePen::SetPixel(int x, int y, const std::string& color, double alpha) {
  Draw("set_pixel", {x, y}, Color(color, "MorsePen::SetPixel()"), alpha);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, int r, int g, int b) {
  Draw("set_line", {x0, y0, x1, y1}, Color(r, g, b), kOpaque);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, int r, int g, int b, int alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color(r, g, b), alpha / 255.0);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, int r, int g, int b, double alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color(r, g, b), alpha);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, unsigned char r, unsigned char g,
                       unsigned char b) {
  Draw("set_line", {x0, y0, x1, y1}, Color_t{r, g, b}, kOpaque);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, unsigned char r, unsigned char g,
                       unsigned char b, unsigned char alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color_t{r, g, b}, alpha / 255.0);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, double r, double g, double b) {
  Draw("set_line", {x0, y0, x1, y1}, Color(r, g, b), kOpaque);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, double r, double g, double b, double alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color(r, g, b), alpha);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, const std::string& color) {
  Draw("set_line", {x0, y0, x1, y1}, Color(color, "MorsePen::SetLine()"), kOpaque);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, const std::string& color, int alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color(color, "MorsePen::SetLine()"), alpha / 255.0);
}

void MorsePen::SetLine(int x0, int y0, int x1, int y1, const std::string& color, double alpha) {
  Draw("set_line", {x0, y0, x1, y1}, Color(color, "MorsePen::SetLine()"), alpha);
}

Color_t MorsePen::GetPixel(int x, int y) {
  const MorseValue answer = Request("get_pixel", MorseArgs(x, y));
  if (answer.GetSize() < 3) {
    throw MorseError("the simulator sent " + answer.ToString() + " for a colour",
                     "MorsePen::GetPixel()");
  }
  return Color(answer);
}

std::vector<Color_t> MorsePen::GetImageData() {
  const MorseValue answer = Request("get_image_data");
  std::vector<Color_t> image;
  const std::size_t count = answer.GetSize();
  image.reserve(count);
  for (std::size_t i = 0; i < count; ++i) image.push_back(Color(answer.At(i)));
  return image;
}

void MorsePen::SetImageData(const std::vector<Color_t>& image) {
  {
    const std::lock_guard lock(DataMutex());
    const auto cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    if (image.size() != cells) {
      throw MorseError("the canvas has " + std::to_string(cells) + " cells, the image " +
                           std::to_string(image.size()),
                       "MorsePen::SetImageData()");
    }
  }
  MorseArgs pixels;
  for (const Color_t& color : image) {
    pixels.Add(MorseArgs(int{color.r}, int{color.g}, int{color.b}));
  }
  Command("set_image_data", MorseArgs().Add(pixels));
}

void MorsePen::UpdateImageData(const std::vector<PixelUpdate_t>& pixels) {
  if (pixels.empty()) return;
  MorseArgs list;
  for (const PixelUpdate_t& pixel : pixels) {
    list.Add(MorseArgs(std::clamp(pixel.point.x, -kFarthestCell, kFarthestCell),
                       std::clamp(pixel.point.y, -kFarthestCell, kFarthestCell), int{pixel.color.r},
                       int{pixel.color.g}, int{pixel.color.b}));
  }
  Command("update_image_data", MorseArgs().Add(list));
}

void MorsePen::SaveImageCopy(const std::string& name) {
  Request("save_image_copy", MorseArgs(name));
}

void MorsePen::ResizeCanvas(int width, int height) {
  if (width < 1 || height < 1) {
    throw MorseError("a canvas has at least one cell across and up", "MorsePen::ResizeCanvas()");
  }
  Request("resize_canvas", MorseArgs(width, height));
  RefreshSize();
}

void MorsePen::RefreshSize() {
  const MorseValue size = Request("get_size");
  const double cell_size = Request("get_cell_size").GetDouble("");
  TakeSize(size);
  const std::lock_guard lock(DataMutex());
  cell_size_ = cell_size;
}

int MorsePen::GetWidth() const {
  const std::lock_guard lock(DataMutex());
  return width_;
}

int MorsePen::GetHeight() const {
  const std::lock_guard lock(DataMutex());
  return height_;
}

double MorsePen::GetCellSize() const {
  const std::lock_guard lock(DataMutex());
  return cell_size_;
}

int MorsePen::GetX(double x) const {
  const std::lock_guard lock(DataMutex());
  return Cell(x, cell_size_, width_);
}

int MorsePen::GetY(double y) const {
  const std::lock_guard lock(DataMutex());
  return Cell(y, cell_size_, height_);
}

}  // namespace CCMorse
