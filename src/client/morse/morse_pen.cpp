#include <algorithm>
#include <cmath>

#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorsePen.h"

namespace CCMorse {

namespace {

const bool kPenRegistered = RegisterMorseDevice({{"pen"}, {"Pen"}, [](const MorseDeviceInfo& info) {
                                                   return std::make_unique<MorsePen>(info);
                                                 }});

// The simulator takes cells in this range, on the canvas or not.
constexpr int kFarthestCell = 1000000000;
// Cells of one line of text: each has at most 41 characters, and a line 1 MiB.
constexpr std::size_t kMostPixels = 25000;
// Cells of one line of a whole image: 17 characters each.
constexpr std::size_t kMostInImage = 60000;

ImagePoint_t Held(ImagePoint_t at) {
  return {std::clamp(at.x, -kFarthestCell, kFarthestCell),
          std::clamp(at.y, -kFarthestCell, kFarthestCell)};
}

Color_t Color(const MorseValue& value) {
  return Paint_t(value.GetInt("0"), value.GetInt("1"), value.GetInt("2")).color();
}

// The index of the cell that holds a coordinate, of `count` cells of `size` m.
int Cell(double coordinate, double size, int count) {
  if (count <= 0 || !(size > 0.0)) return 0;
  const double cell = std::floor(coordinate / size);
  if (!(cell > 0.0)) return 0;
  return cell < count ? static_cast<int>(cell) : count - 1;
}

std::vector<CanvasLayer_t> LayersOf(const MorseValue& answer) {
  std::vector<CanvasLayer_t> layers;
  for (std::size_t i = 0; i < answer.GetSize(); ++i) {
    const MorseValue layer = answer.At(i);
    layers.push_back({layer.GetString("0"), layer.GetInt("1"), layer.GetBool("2", true),
                      layer.GetBool("3", true)});
  }
  return layers;
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

void MorsePen::Draw(const char* service, const std::vector<int>& cells, const Paint_t& paint) {
  MorseArgs args;
  for (const int cell : cells) args.Add(std::clamp(cell, -kFarthestCell, kFarthestCell));
  args.Add(int{paint.color().r}).Add(int{paint.color().g}).Add(int{paint.color().b});
  if (paint.alpha() < 1.0) args.Add(paint.alpha());  // without alpha, the colour covers
  Command(service, args);
}

void MorsePen::DrawPixel(ImagePoint_t at, const Paint_t& paint) {
  const PixelUpdate_t pixel{Held(at), paint.color()};
  if (!(paint.alpha() < 1.0) && CommandPixels("update_image_data", &pixel, 1)) return;
  Draw("set_pixel", {at.x, at.y}, paint);
}

void MorsePen::DrawLine(ImagePoint_t from, ImagePoint_t to, const Paint_t& paint) {
  Draw("set_line", {from.x, from.y, to.x, to.y}, paint);
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
  const int width = GetWidth();
  if (CommandImage("set_image_data", width, GetHeight(), image)) return;
  if (image.size() > kMostInImage) {
    std::vector<PixelUpdate_t> cells;
    cells.reserve(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
      const int at = static_cast<int>(i);
      cells.push_back({{at % width, at / width}, image[i]});
    }
    UpdateImageData(cells);
    return;
  }
  MorseArgs pixels;
  for (const Color_t& color : image) {
    pixels.Add(MorseArgs(int{color.r}, int{color.g}, int{color.b}));
  }
  Command("set_image_data", MorseArgs().Add(pixels));
}

void MorsePen::UpdateImageData(const std::vector<PixelUpdate_t>& pixels) {
  if (pixels.empty()) return;
  // A cell too far off to be named is off the canvas as much as the farthest that can be.
  std::vector<PixelUpdate_t> held(pixels);
  for (PixelUpdate_t& pixel : held) pixel.point = Held(pixel.point);
  if (CommandPixels("update_image_data", held.data(), held.size())) return;
  for (std::size_t first = 0; first < held.size(); first += kMostPixels) {
    MorseArgs list;
    for (std::size_t i = first; i < std::min(held.size(), first + kMostPixels); ++i) {
      const PixelUpdate_t& pixel = held[i];
      list.Add(MorseArgs(pixel.point.x, pixel.point.y, int{pixel.color.r}, int{pixel.color.g},
                         int{pixel.color.b}));
    }
    Command("update_image_data", MorseArgs().Add(list));
  }
}

void MorsePen::SaveImageCopy(const std::string& name) {
  Request("save_image_copy", MorseArgs(name));
}

void MorsePen::SetLayers(const std::vector<CanvasLayer_t>& layers) {
  if (!HasService("set_layers")) return;
  MorseArgs list;
  for (const CanvasLayer_t& layer : layers) {
    list.Add(MorseArgs(layer.name, layer.priority, layer.visible));
  }
  Command("set_layers", MorseArgs().Add(list));
}

void MorsePen::ShowLayer(const std::string& name, bool shown) {
  if (HasService("show_layer")) Command("show_layer", MorseArgs(name, shown));
}

std::vector<CanvasLayer_t> MorsePen::GetLayers() {
  if (!HasService("get_layers")) return {};
  return LayersOf(Request("get_layers"));
}

void MorsePen::AskLayers(const std::function<void(const std::vector<CanvasLayer_t>&)>& take) {
  if (!HasService("get_layers")) return;
  AskWithRead("get_layers", [take](const MorseValue& answer) { take(LayersOf(answer)); });
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
