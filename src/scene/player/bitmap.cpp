#include "scene/player/bitmap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/error.h"

namespace ccmorse::scene {
namespace {

constexpr std::int64_t kMostPixels = 64'000'000;

void CheckSize(std::int64_t width, std::int64_t height, const std::string& name) {
  if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels ||
      width * height > kMostPixels) {
    throw Error(fmt::format("{} has {} x {} pixels, must have 1 to {} million", name, width, height,
                            kMostPixels / 1'000'000));
  }
}

// Takes the numbers of a PNM's header and of the plain kinds: ASCII, with # comments.
class PnmReader {
 public:
  PnmReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  std::int64_t Number() {
    SkipBlanks();
    std::int64_t number = 0;
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9' && at_ - begin < 10) {
      number = 10 * number + (bytes_[at_++] - '0');
    }
    if (at_ == begin) throw Error(name_ + " is no whole PNM picture: a number is missing");
    return number;
  }

  // Of a plain PBM, whose digits need no blanks between them.
  bool Bit() {
    SkipBlanks();
    if (at_ == bytes_.size() || (bytes_[at_] != '0' && bytes_[at_] != '1')) {
      throw Error(name_ + " is no whole PNM picture: a pixel is missing");
    }
    return bytes_[at_++] == '1';
  }

  unsigned Byte() {
    if (at_ == bytes_.size()) throw Error(name_ + " is no whole PNM picture: it is cut short");
    return static_cast<unsigned char>(bytes_[at_++]);
  }

  std::size_t left() const { return bytes_.size() - at_; }

 private:
  void SkipBlanks() {
    while (at_ < bytes_.size()) {
      const char c = bytes_[at_];
      if (c == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
        return;
      } else {
        ++at_;
      }
    }
  }

  const std::string& bytes_;
  const std::string& name_;
  std::size_t at_ = 2;  // after "P5"
};

}  // namespace

Image ParsePnm(const std::string& bytes, const std::string& name) {
  if (bytes.size() < 3 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '6') {
    throw Error(name + " is no PNM picture");
  }
  const int kind = bytes[1] - '0';
  PnmReader reader(bytes, name);
  const std::int64_t width = reader.Number();
  const std::int64_t height = reader.Number();
  CheckSize(width, height, name);
  const bool bits = kind == 1 || kind == 4;
  const std::int64_t most = bits ? 1 : reader.Number();
  if (most < 1 || most > 65535) {
    throw Error(fmt::format("{} has a largest value of {}, must be 1..65535", name, most));
  }
  const bool plain = kind <= 3;
  if (!plain) reader.Byte();  // one blank ends the header
  const int channels = kind == 3 || kind == 6 ? 3 : 1;
  // Each pixel takes a bit or more, so a header cannot claim memory that the file has no bytes for.
  if (static_cast<std::int64_t>(reader.left()) * 8 < width * height) {
    throw Error(name + " is no whole PNM picture: it is cut short");
  }
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(static_cast<std::size_t>(width * height));
  const auto value = [&]() {
    std::int64_t number = 0;
    if (plain) {
      number = reader.Number();
    } else {
      number = reader.Byte();
      if (most > 255) number = 256 * number + reader.Byte();
    }
    return static_cast<std::uint8_t>(std::min(number, most) * 255 / most);
  };
  for (int y = 0; y < image.height; ++y) {
    unsigned byte = 0;
    for (int x = 0; x < image.width; ++x) {
      Color& pixel = image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x)];
      if (bits) {
        if (kind == 4 && x % 8 == 0) byte = reader.Byte();
        const bool black = kind == 1 ? reader.Bit() : ((byte >> (7 - x % 8)) & 1U) != 0;
        const std::uint8_t level = black ? 0 : 255;
        pixel = {level, level, level};
        continue;
      }
      pixel.r = value();
      pixel.g = channels == 3 ? value() : pixel.r;
      pixel.b = channels == 3 ? value() : pixel.r;
    }
  }
  return image;
}

Image ReadBitmap(const std::string& path) {
  const std::string bytes = ReadFile(path);
  if (bytes.size() >= 24 && bytes.compare(1, 3, "PNG") == 0) {
    const auto number = [&bytes](std::size_t at) {
      std::int64_t value = 0;
      for (std::size_t i = at; i < at + 4; ++i) {
        value = 256 * value + static_cast<unsigned char>(bytes[i]);
      }
      return value;
    };
    CheckSize(number(16), number(20), path);  // as its header says
    return ReadPng(path);
  }
  if (bytes.size() >= 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    return ParsePnm(bytes, path);
  }
  throw Error(path + " is neither a PNG nor a PNM picture; save it as one of them");
}

std::vector<PixelRect> DarkRectangles(const Image& image) {
  const int width = image.width;
  const int height = image.height;
  const auto index = [width](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  };
  const auto dark = [&](int x, int y) { return image.pixels[index(x, y)].r <= 127; };
  const auto row_dark = [&](int y, int x, int end) {
    for (; x < end; ++x) {
      if (!dark(x, y)) return false;
    }
    return true;
  };
  const auto column_dark = [&](int x, int y, int end) {
    for (; y < end; ++y) {
      if (!dark(x, y)) return false;
    }
    return true;
  };
  std::vector<bool> covered(image.pixels.size(), false);
  std::vector<PixelRect> rectangles;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!dark(x, y) || covered[index(x, y)]) continue;
      // First as wide as can be, then as high; and the other way round.
      int left = x;
      int right = x + 1;
      int top = y;
      int bottom = y + 1;
      while (left > 0 && dark(left - 1, y)) --left;
      while (right < width && dark(right, y)) ++right;
      while (top > 0 && row_dark(top - 1, left, right)) --top;
      while (bottom < height && row_dark(bottom, left, right)) ++bottom;
      const PixelRect wide{left, top, right - left, bottom - top};
      left = x;
      right = x + 1;
      top = y;
      bottom = y + 1;
      while (top > 0 && dark(x, top - 1)) --top;
      while (bottom < height && dark(x, bottom)) ++bottom;
      while (left > 0 && column_dark(left - 1, top, bottom)) --left;
      while (right < width && column_dark(right, top, bottom)) ++right;
      const PixelRect high{left, top, right - left, bottom - top};
      const auto area = [](const PixelRect& r) { return std::int64_t{r.width} * r.height; };
      const PixelRect& best = area(high) > area(wide) ? high : wide;
      for (int j = best.y; j < best.y + best.height; ++j) {
        for (int i = best.x; i < best.x + best.width; ++i) covered[index(i, j)] = true;
      }
      rectangles.push_back(best);
    }
  }
  return rectangles;
}

}  // namespace ccmorse::scene
