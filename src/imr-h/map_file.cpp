#include "imr-h/map_file.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>

#include "imr-h/png_gray.h"
#include "imr-h/trimmed.h"

namespace imr {
namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 26;
constexpr double kFree = 0.0;
constexpr double kUnknown = 0.5;
constexpr double kWall = 1.0;

std::string readFile(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::string block(65536, '\0');
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    text.append(block, 0, static_cast<std::size_t>(in.gcount()));
  }
  // A folder opens, and cannot be read.
  if (!in.is_open() || in.bad()) throw io_error("cannot read " + file);
  return text;
}

std::string endingOf(const std::string& file) {
  const std::size_t slash = file.find_last_of('/');
  const std::size_t dot = file.find_last_of('.');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = file.substr(dot);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

SMapFile emptyMap(std::int64_t width, std::int64_t height, double cellSize) {
  if (width < 1 || height < 1 || width > kMostCells || height > kMostCells / width) {
    throw io_error("a map must have between 1 and 2^26 cells");
  }
  SMapFile map;
  map.width = static_cast<int>(width);
  map.height = static_cast<int>(height);
  map.cellSize = cellSize;
  map.cells.assign(static_cast<std::size_t>(width * height), kFree);
  return map;
}

// Where a cell stands in SMapFile::cells; `line` counts from the top, as files do.
std::size_t indexOf(const SMapFile& map, int x, int line) {
  return static_cast<std::size_t>(map.height - 1 - line) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(x);
}

SMapFile parseText(const std::string& text, double cellSize) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  int rows = 0;
  const std::string first = lines.empty() ? "" : lines[0];
  const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), rows);
  if (error != std::errc() || end != first.data() + first.size() || rows < 1) {
    throw io_error("line 1: must be the number of rows");
  }
  if (lines.size() != static_cast<std::size_t>(rows) + 1) {
    throw io_error("line 1 says " + first + " rows, and there are " +
                   std::to_string(lines.size() - 1));
  }
  SMapFile map = emptyMap(static_cast<std::int64_t>(lines[1].size()), rows, cellSize);
  for (int row = 0; row < rows; ++row) {
    const std::string& line = lines[static_cast<std::size_t>(row) + 1];
    if (line.size() != lines[1].size()) {
      throw io_error("line " + std::to_string(row + 2) + ": " + std::to_string(line.size()) +
                     " cells, and " + std::to_string(lines[1].size()) + " in the first row");
    }
    for (int x = 0; x < map.width; ++x) {
      const char c = line[static_cast<std::size_t>(x)];
      map.cells[indexOf(map, x, row)] = c == '.' ? kFree : c == '?' ? kUnknown : kWall;
    }
  }
  return map;
}

// PGM, plain (P2) or raw (P5), 8 or 16 bits.
SGrayImage decodePgm(const std::string& bytes) {
  std::size_t at = 2;
  const bool plain = bytes.compare(0, 2, "P2") == 0;
  if (!plain && bytes.compare(0, 2, "P5") != 0) throw io_error("this is no PGM");
  const auto next = [&]() -> std::int64_t {
    while (at < bytes.size() &&
           (std::isspace(static_cast<unsigned char>(bytes[at])) != 0 || bytes[at] == '#')) {
      if (bytes[at] == '#') {
        while (at < bytes.size() && bytes[at] != '\n') ++at;
      } else {
        ++at;
      }
    }
    std::int64_t value = 0;
    const auto [end, error] =
        std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), value);
    if (error != std::errc() || value < 0) throw io_error("the picture is damaged");
    at = static_cast<std::size_t>(end - bytes.data());
    return value;
  };
  const std::int64_t width = next();
  const std::int64_t height = next();
  const std::int64_t most = next();
  if (width < 1 || height < 1 || width > kMostCells || height > kMostCells / width) {
    throw io_error("the picture must have between 1 and 2^26 pixels");
  }
  if (most < 1 || most > 65535) throw io_error("the picture is damaged");
  const auto count = static_cast<std::size_t>(width * height);
  const std::size_t size = most > 255 ? 2 : 1;
  ++at;  // the one blank behind the header
  if (!plain && (at > bytes.size() || (bytes.size() - at) / size < count)) {
    throw io_error("the picture ends too early");
  }
  SGrayImage image{static_cast<int>(width), static_cast<int>(height), {}};
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t level = 0;
    if (plain) {
      level = next();
    } else {
      for (std::size_t b = 0; b < size; ++b) {
        level = level * 256 + static_cast<unsigned char>(bytes[at++]);
      }
    }
    image.light.push_back(static_cast<double>(level) / static_cast<double>(most));
  }
  return image;
}

SGrayImage readPicture(const std::string& file) {
  const std::string bytes = readFile(file);
  try {
    return bytes.compare(0, 4, "\x89PNG") == 0 ? decodePng(bytes) : decodePgm(bytes);
  } catch (const io_error& error) {
    throw io_error(file + ": " + error.what());
  }
}

// What map_server does with the levels of a picture (ROS: map_server).
struct SLevels {
  double occupied = 0.65;
  double free = 0.196;
  bool negate = false;
  bool scale = false;  // levels in between are kept
};

SMapFile fromPicture(const SGrayImage& image, double cellSize, const SLevels& levels) {
  SMapFile map = emptyMap(image.width, image.height, cellSize);
  std::size_t i = 0;
  for (int line = 0; line < map.height; ++line) {
    for (int x = 0; x < map.width; ++x) {
      const double light = image.light[i++];
      const double wall = levels.negate ? light : 1.0 - light;
      map.cells[indexOf(map, x, line)] =
          wall > levels.occupied ? kWall
          : wall < levels.free   ? kFree
          : levels.scale         ? (wall - levels.free) / (levels.occupied - levels.free)
                                 : kUnknown;
    }
  }
  return map;
}

// The flat "key: value" lines that map_server writes; an origin may be in brackets.
std::map<std::string, std::string> parseYaml(const std::string& text) {
  std::map<std::string, std::string> values;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::size_t comment = line.find('#');
    if (comment == 0 || (comment != std::string::npos && line[comment - 1] == ' ')) {
      line.resize(comment);
    }
    line = trimmed(line);
    if (line.empty() || line == "---") continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) {
      throw io_error("line " + std::to_string(number) + ": must be key: value");
    }
    std::string value = trimmed(line.substr(colon + 1));
    if (value.size() > 1 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0]) {
      value = value.substr(1, value.size() - 2);
    }
    values[trimmed(line.substr(0, colon))] = value;
  }
  return values;
}

double toNumber(const std::string& key, const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw io_error(key + ": \"" + text + "\" is no number");
  }
  return value;
}

SMapFile loadYaml(const std::string& file) {
  std::map<std::string, std::string> values = parseYaml(readFile(file));
  for (const char* key : {"image", "resolution", "origin"}) {
    if (values[key].empty()) throw io_error(std::string(key) + " is missing");
  }
  const double cell = toNumber("resolution", values["resolution"]);
  if (cell <= 0.0) throw io_error("resolution must be more than 0");
  SLevels levels;
  if (!values["occupied_thresh"].empty()) {
    levels.occupied = toNumber("occupied_thresh", values["occupied_thresh"]);
  }
  if (!values["free_thresh"].empty()) {
    levels.free = toNumber("free_thresh", values["free_thresh"]);
  }
  if (!(levels.free < levels.occupied)) {
    throw io_error("free_thresh must be less than occupied_thresh");
  }
  const std::string negate = values["negate"];
  levels.negate = negate == "1" || negate == "true";
  const std::string mode = values["mode"].empty() ? "trinary" : values["mode"];
  if (mode != "trinary" && mode != "scale") {
    throw io_error("mode: \"" + mode + "\" is not known; it may be trinary or scale");
  }
  levels.scale = mode == "scale";
  std::string origin = values["origin"];
  for (char& c : origin) {
    if (c == '[' || c == ']' || c == ',') c = ' ';
  }
  std::istringstream numbers(origin);
  std::string x;
  std::string y;
  std::string yaw = "0";
  if (!(numbers >> x >> y)) throw io_error("origin: must be [x, y, yaw]");
  numbers >> yaw;
  if (toNumber("origin", yaw) != 0.0) throw io_error("origin: a map that is turned cannot be read");
  std::string image = values["image"];
  if (image[0] != '/' && file.find('/') != std::string::npos) {
    image = file.substr(0, file.find_last_of('/') + 1) + image;
  }
  SMapFile map = fromPicture(readPicture(image), cell, levels);
  map.originX = toNumber("origin", x);
  map.originY = toNumber("origin", y);
  return map;
}

void writeFile(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw io_error("cannot write " + file);
}

}  // namespace

SMapFile loadMap(const std::string& file, double cellSize) {
  assert_argument(std::isfinite(cellSize) && cellSize > 0.0,
                  "the cells of a map must have a positive size");
  const std::string ending = endingOf(file);
  if (ending == ".pgm" || ending == ".png") {
    return fromPicture(readPicture(file), cellSize, SLevels());
  }
  try {
    if (ending == ".txt") return parseText(readFile(file), cellSize);
    if (ending == ".yaml" || ending == ".yml") return loadYaml(file);
  } catch (const io_error& error) {
    const std::string text = error.what();
    throw io_error(text.find(file) != std::string::npos ? text : file + ": " + text);
  }
  throw io_error(file + ": a map is a .txt, .yaml, .pgm or .png");
}

void saveMap(const SMapFile& map, const std::string& file) {
  assert_argument(map.width > 0 && map.height > 0 &&
                      map.cells.size() == static_cast<std::size_t>(map.width) *
                                              static_cast<std::size_t>(map.height),
                  "a map must have width x height cells");
  const std::string ending = endingOf(file);
  assert_argument(ending == ".txt" || ending == ".yaml", file + ": must end in .txt or .yaml");
  const bool text = ending == ".txt";
  std::string cells;
  for (int line = 0; line < map.height; ++line) {
    for (int x = 0; x < map.width; ++x) {
      const double cell = map.cells[indexOf(map, x, line)];
      const char* symbols = text ? ".?O" : "\xfe\xcd\x01";  // the levels that map_saver writes
      cells += symbols[cell < 0.35 ? 0 : cell > 0.65 ? 2 : 1];
    }
    if (text) cells += '\n';
  }
  if (text) {
    writeFile(file, std::to_string(map.height) + "\n" + cells);
    return;
  }
  const std::string image = file.substr(0, file.size() - ending.size()) + ".pgm";
  writeFile(image, "P5\n" + std::to_string(map.width) + " " + std::to_string(map.height) +
                       "\n255\n" + cells);
  std::ostringstream yaml;
  yaml.precision(17);
  yaml << "image: " << image.substr(image.find_last_of('/') + 1) << "\nresolution: " << map.cellSize
       << "\norigin: [" << map.originX << ", " << map.originY
       << ", 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  writeFile(file, yaml.str());
}

}  // namespace imr
