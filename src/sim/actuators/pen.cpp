#include "sim/actuators/pen.h"

#include <limits>
#include <set>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/image.h"
#include "base/nearest_name.h"

namespace ccmorse::sim {
namespace {

constexpr int kFar = 1'000'000'000;
constexpr int kMostCells = 4096;
constexpr int kMostListed = 1'000'000;
constexpr std::size_t kMostLayers = 256;
constexpr std::size_t kLongestName = 100;  // bytes, of a layer

int Cell(Arguments arguments, std::size_t index, const char* name) {
  return IntegerArgument(arguments, index, name, -kFar, kFar);
}

Color ColorArgument(Arguments arguments, std::size_t first) {
  const auto channel = [&](std::size_t index, const char* name) {
    return static_cast<std::uint8_t>(IntegerArgument(arguments, index, name, 0, 255));
  };
  return {channel(first, "r"), channel(first + 1, "g"), channel(first + 2, "b")};
}

double AlphaArgument(Arguments arguments, std::size_t index) {
  const double alpha = NumberArgument(arguments, index, "alpha", 1.0);
  if (alpha < 0.0 || alpha > 1.0) throw WrongArgument("alpha must be from 0 to 1");
  return alpha;
}

struct Vec2i {
  int x;
  int y;
};

Json ToJson(Color color) { return Json(Json::Array{int{color.r}, int{color.g}, int{color.b}}); }

// Bytes that are cells: 3 bytes each, red, green, blue.
std::span<const Color> Colors(std::string_view cells) {
  static_assert(sizeof(Color) == 3 && std::is_trivially_copyable_v<Color>);
  return {reinterpret_cast<const Color*>(cells.data()), cells.size() / sizeof(Color)};
}

constexpr std::size_t kRectangleHead = 12;

std::uint32_t Number(std::string_view bytes, std::size_t at, unsigned size) {
  std::uint32_t value = 0;
  for (unsigned i = size; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

const Json::Array& ListOf(const Json& value, const char* what, std::size_t length) {
  if (!value.IsArray() || value.AsArray().size() != length) {
    throw WrongArgument(std::string("each pixel must be ") + what);
  }
  return value.AsArray();
}

const Json::Array& ListArgument(Arguments arguments, const char* name) {
  if (!arguments[0].IsArray()) {
    throw WrongArgument(std::string(name) + " must be a list, not " + arguments[0].TypeName());
  }
  return arguments[0].AsArray();
}

bool BoolArgument(Arguments arguments, std::size_t index, const char* name) {
  if (!arguments[index].IsBool()) {
    throw WrongArgument(std::string(name) + " must be true or false, not " +
                        arguments[index].TypeName());
  }
  return arguments[index].AsBool();
}

// [[name, priority, visible], ...]
std::vector<CanvasLayer> LayersArgument(Arguments arguments) {
  const Json::Array& list = ListArgument(arguments, "layers");
  if (list.size() > kMostLayers) {
    throw WrongArgument("there may be " + std::to_string(kMostLayers) + " layers at most");
  }
  std::vector<CanvasLayer> layers;
  std::set<std::string> names;
  for (const Json& item : list) {
    if (!item.IsArray() || item.AsArray().size() != 3) {
      throw WrongArgument("each layer must be [name, priority, visible]");
    }
    const Json::Array& parts = item.AsArray();
    CanvasLayer layer;
    layer.name = StringArgument(parts, 0, "name");
    if (layer.name.empty() || layer.name.size() > kLongestName) {
      throw WrongArgument("name must have 1 to " + std::to_string(kLongestName) + " bytes");
    }
    if (!names.insert(layer.name).second) {
      throw WrongArgument("name '" + layer.name + "' is there twice");
    }
    layer.priority = IntegerArgument(parts, 1, "priority", std::numeric_limits<int>::min(),
                                     std::numeric_limits<int>::max());
    layer.visible = BoolArgument(parts, 2, "visible");
    layers.push_back(std::move(layer));
  }
  return layers;
}

}  // namespace

Pen::Pen(Robot& robot, const std::string& name, Canvas& canvas)
    : Actuator(robot, name, "Pen", 60.0), canvas_(canvas) {
  const ServiceParameter alpha{"alpha", true};
  AddService({"set_pixel", {{"x"}, {"y"}, {"r"}, {"g"}, {"b"}, alpha}, [this](Arguments arguments) {
                canvas_.SetPixel(Cell(arguments, 0, "x"), Cell(arguments, 1, "y"),
                                 ColorArgument(arguments, 2), AlphaArgument(arguments, 5));
                return Json();
              }});
  AddQuery({"get_pixel", {{"x"}, {"y"}}, [this](Arguments arguments) {
              return ToJson(
                  canvas_.GetPixel(IntegerArgument(arguments, 0, "x", 0, canvas_.width() - 1),
                                   IntegerArgument(arguments, 1, "y", 0, canvas_.height() - 1)));
            }});
  AddService({"set_line",
              {{"x0"}, {"y0"}, {"x1"}, {"y1"}, {"r"}, {"g"}, {"b"}, alpha},
              [this](Arguments arguments) {
                canvas_.DrawLine(Cell(arguments, 0, "x0"), Cell(arguments, 1, "y0"),
                                 Cell(arguments, 2, "x1"), Cell(arguments, 3, "y1"),
                                 ColorArgument(arguments, 4), AlphaArgument(arguments, 7));
                return Json();
              }});
  // Written straight to text: as a tree of values a large canvas would hold up the tick.
  AddQuery({"get_image_data", {}, nullptr, nullptr, [this]() -> const std::string& {
              WriteImageData();
              return image_data_;
            }});
  AddService({"set_image_data",
              {{"pixels"}},
              [this](Arguments arguments) {
                const Json::Array& pixels = ListArgument(arguments, "pixels");
                RequireAllCells(pixels.size());
                std::vector<Color> colors;
                for (const Json& pixel : pixels) {
                  colors.push_back(ColorArgument(ListOf(pixel, "[r, g, b]", 3), 0));
                }
                canvas_.SetRectangle(0, 0, canvas_.width(), canvas_.height(), colors);
                return Json();
              },
              {},
              {},
              [this](std::string_view cells) { SetImage(cells); }});
  AddService(
      {"update_image_data",
       {{"pixels"}},
       [this](Arguments arguments) {
         // All or nothing: a wrong pixel changes no cell.
         std::vector<std::pair<Vec2i, Color>> changes;
         for (const Json& pixel : ListArgument(arguments, "pixels")) {
           const Json::Array& parts = ListOf(pixel, "[x, y, r, g, b]", 5);
           changes.push_back({{Cell(parts, 0, "x"), Cell(parts, 1, "y")}, ColorArgument(parts, 2)});
         }
         for (const auto& [at, color] : changes) canvas_.SetPixel(at.x, at.y, color);
         return Json();
       },
       {},
       {},
       [this](std::string_view rectangles) { UpdateImage(rectangles); }});
  AddService({"resize_canvas", {{"width"}, {"height"}}, [this](Arguments arguments) {
                canvas_.Resize(IntegerArgument(arguments, 0, "width", 1, kMostCells),
                               IntegerArgument(arguments, 1, "height", 1, kMostCells));
                return Json();
              }});
  AddQuery({"get_size", {}, [this](Arguments) {
              return Json(Json::Array{canvas_.width(), canvas_.height()});
            }});
  AddQuery({"get_cell_size", {}, [this](Arguments) { return Json(canvas_.cell_size()); }});
  AddQuery({"save_image_copy", {{"name"}}, [this](Arguments arguments) {
              try {
                return Json(canvas_.SaveCopy(StringArgument(arguments, 0, "name")));
              } catch (const Error& error) {
                throw ServiceFailed(error.what());
              }
            }});
  AddLayerServices();
}

void Pen::AddLayerServices() {
  AddService({"set_layers", {{"layers"}}, [this](Arguments arguments) {
                canvas_.SetLayers(LayersArgument(arguments));
                return Json();
              }});
  AddService({"show_layer", {{"name"}, {"shown"}}, [this](Arguments arguments) {
                const std::string& name = StringArgument(arguments, 0, "name");
                if (!canvas_.ShowLayer(name, BoolArgument(arguments, 1, "shown"))) {
                  std::vector<std::string> known;
                  for (const CanvasLayer& layer : canvas_.layers()) known.push_back(layer.name);
                  throw ServiceFailed("There is no layer '" + name.substr(0, kLongestName) + "'" +
                                      DidYouMean(name, known));
                }
                return Json();
              }});
  AddQuery(
      {"get_layers", {}, [this](Arguments) {
         Json::Array list;
         for (const CanvasLayer& layer : canvas_.layers()) {
           list.emplace_back(Json::Array{layer.name, layer.priority, layer.visible, layer.shown});
         }
         return Json(std::move(list));
       }});
}

void Pen::RequireAllCells(std::size_t pixels) const {
  const auto cells =
      static_cast<std::size_t>(canvas_.width()) * static_cast<std::size_t>(canvas_.height());
  if (pixels != cells) {
    throw WrongArgument("the canvas has " + std::to_string(cells) + " cells, but " +
                        std::to_string(pixels) + " pixels came");
  }
}

void Pen::SetImage(std::string_view cells) {
  if (cells.size() % sizeof(Color) != 0) throw WrongArgument("a cell has three bytes");
  RequireAllCells(cells.size() / sizeof(Color));
  canvas_.SetRectangle(0, 0, canvas_.width(), canvas_.height(), Colors(cells));
}

void Pen::UpdateImage(std::string_view rectangles) {
  // All or nothing, as with pixels.
  for (const bool draw : {false, true}) {
    std::string_view rest = rectangles;
    while (!rest.empty()) {
      if (rest.size() < kRectangleHead) throw WrongArgument("a rectangle is cut short");
      const int x = static_cast<int>(Number(rest, 0, 4));
      const int y = static_cast<int>(Number(rest, 4, 4));
      const std::uint32_t width = Number(rest, 8, 2);
      const std::uint32_t height = Number(rest, 10, 2);
      rest.remove_prefix(kRectangleHead);
      const std::size_t size = std::size_t{width} * height * sizeof(Color);
      if (size > rest.size()) throw WrongArgument("a rectangle is cut short");
      if (draw) {
        canvas_.SetRectangle(x, y, static_cast<int>(width), static_cast<int>(height),
                             Colors(rest.substr(0, size)));
      }
      rest.remove_prefix(size);
    }
  }
}

void Pen::WriteImageData() {
  if (canvas_.width() * canvas_.height() > kMostListed) {
    throw ServiceFailed(
        "the canvas has more than 1000000 cells, too many for one message; use get_pixel or "
        "save_image_copy");
  }
  image_data_ = "[";
  for (int y = 0; y < canvas_.height(); ++y) {
    for (int x = 0; x < canvas_.width(); ++x) {
      const Color color = canvas_.GetPixel(x, y);
      image_data_ += image_data_.size() == 1 ? "[" : ", [";
      AppendJson(image_data_, std::int64_t{color.r});
      image_data_ += ", ";
      AppendJson(image_data_, std::int64_t{color.g});
      image_data_ += ", ";
      AppendJson(image_data_, std::int64_t{color.b});
      image_data_ += ']';
    }
  }
  image_data_ += ']';
}

void Pen::Receive(const Json&) {
  throw WrongArgument("a pen takes services (set_pixel, set_line, ...), not stream messages");
}

}  // namespace ccmorse::sim
