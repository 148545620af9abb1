#include "assets/picture.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
// It needs FILE.
#include <jpeglib.h>

namespace ccmorse::assets {
namespace {

constexpr std::size_t kLargest = 16384;  // pixels a side
constexpr std::size_t kSmall = 256;      // likewise, of what is kept

// Rows from the top, as decoded: red, green, blue, and opacity where there are four channels.
struct Raw {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> bytes;
  std::size_t channels = 3;
};

std::optional<Raw> ReadPng(std::span<const std::uint8_t> bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return std::nullopt;
  if (png.width > kLargest || png.height > kLargest) {
    png_image_free(&png);
    return std::nullopt;
  }
  png.format = PNG_FORMAT_RGBA;
  Raw raw{png.width, png.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png)), 4};
  if (png_image_finish_read(&png, nullptr, raw.bytes.data(), 0, nullptr) == 0) return std::nullopt;
  return raw;
}

// libjpeg's way to fail is a call that must not return.
struct JpegError {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void JpegFails(j_common_ptr info) {
  std::longjmp(reinterpret_cast<JpegError*>(info->err)->back, 1);  // NOLINT(cert-err52-cpp)
}

void JpegIsSilent(j_common_ptr /*info*/) {}

// Only what needs no destructor may live across the jump: `raw` is the caller's.
bool DecodeJpeg(std::span<const std::uint8_t> bytes, Raw& raw) {
  jpeg_decompress_struct info{};
  JpegError error{};
  info.err = jpeg_std_error(&error.manager);
  error.manager.error_exit = JpegFails;
  error.manager.output_message = JpegIsSilent;
  if (setjmp(error.back) != 0) {  // NOLINT(cert-err52-cpp): libjpeg has no other way
    jpeg_destroy_decompress(&info);
    return false;
  }
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, bytes.data(), static_cast<unsigned long>(bytes.size()));  // NOLINT
  static_cast<void>(jpeg_read_header(&info, TRUE));
  if (info.image_width > kLargest || info.image_height > kLargest) {
    jpeg_destroy_decompress(&info);
    return false;
  }
  info.out_color_space = JCS_RGB;
  info.scale_num = 1;
  info.scale_denom = 1;
  while (info.scale_denom < 8 &&
         std::max(info.image_width, info.image_height) > 2 * kSmall * info.scale_denom) {
    info.scale_denom *= 2;
  }
  static_cast<void>(jpeg_start_decompress(&info));
  raw.width = info.output_width;
  raw.height = info.output_height;
  raw.bytes.resize(3 * raw.width * raw.height);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = raw.bytes.data() + 3 * raw.width * info.output_scanline;
    static_cast<void>(jpeg_read_scanlines(&info, &row, 1));
  }
  static_cast<void>(jpeg_finish_decompress(&info));
  jpeg_destroy_decompress(&info);
  return true;
}

// Colours as they are or in runs (Truevision, "TGA File Format Specification", 1991).
std::optional<Raw> ReadTga(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kHead = 18;
  if (bytes.size() < kHead) return std::nullopt;
  const std::uint8_t type = bytes[2];
  const std::size_t size = bytes[16] / 8U;
  Raw raw;
  raw.width = bytes[12] + 256U * bytes[13];
  raw.height = bytes[14] + 256U * bytes[15];
  if ((type != 2 && type != 10) || bytes[1] != 0 || (size != 3 && size != 4)) return std::nullopt;
  if (raw.width == 0 || raw.height == 0 || raw.width > kLargest || raw.height > kLargest) {
    return std::nullopt;
  }
  const bool from_top = (bytes[17] & 0x20U) != 0;
  const std::size_t count = raw.width * raw.height;
  // A run of 128 pixels takes five bytes: no small file asks for much memory.
  if (count / 128 > bytes.size()) return std::nullopt;
  raw.bytes.resize(3 * count);
  std::size_t at = kHead + bytes[0];
  std::size_t left = 0;  // pixels of the run
  bool repeats = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (type == 10 && left == 0) {
      if (at >= bytes.size()) return std::nullopt;
      repeats = (bytes[at] & 0x80U) != 0;
      left = (bytes[at] & 0x7FU) + 1U;
      ++at;
    }
    if (at + size > bytes.size()) return std::nullopt;
    const std::size_t row = i / raw.width;
    const std::size_t place =
        3 * ((from_top ? row : raw.height - 1 - row) * raw.width + i % raw.width);
    raw.bytes[place] = bytes[at + 2];
    raw.bytes[place + 1] = bytes[at + 1];
    raw.bytes[place + 2] = bytes[at];
    if (type == 10) --left;
    if (!repeats || left == 0) at += size;
  }
  return raw;
}

Picture Reduced(const Raw& raw) {
  Picture picture;
  const std::size_t step = (std::max(raw.width, raw.height) + kSmall - 1) / kSmall;
  picture.width = static_cast<int>((raw.width + step - 1) / step);
  picture.height = static_cast<int>((raw.height + step - 1) / step);
  // What is transparent has no colour: a leaf is green, whatever is around it in the picture.
  std::array<std::uint64_t, 3> all{};
  std::uint64_t whole = 0;
  std::vector<std::size_t> clear;
  for (std::size_t y = 0; y < raw.height; y += step) {
    for (std::size_t x = 0; x < raw.width; x += step) {
      std::array<std::uint64_t, 3> sum{};
      std::uint64_t weight = 0;
      for (std::size_t v = y; v < std::min(raw.height, y + step); ++v) {
        for (std::size_t u = x; u < std::min(raw.width, x + step); ++u) {
          const std::size_t at = raw.channels * (v * raw.width + u);
          const std::uint64_t opaque = raw.channels == 4 ? raw.bytes[at + 3] : 255U;
          for (std::size_t k = 0; k < 3; ++k) sum[k] += opaque * raw.bytes[at + k];
          weight += opaque;
        }
      }
      if (weight == 0) clear.push_back(picture.pixels.size());
      for (std::size_t k = 0; k < 3; ++k) {
        all[k] += sum[k];
        sum[k] /= std::max<std::uint64_t>(1, weight);
      }
      whole += weight;
      picture.pixels.push_back({static_cast<std::uint8_t>(sum[0]),
                                static_cast<std::uint8_t>(sum[1]),
                                static_cast<std::uint8_t>(sum[2])});
    }
  }
  whole = std::max<std::uint64_t>(1, whole);
  picture.mean = {static_cast<std::uint8_t>(all[0] / whole),
                  static_cast<std::uint8_t>(all[1] / whole),
                  static_cast<std::uint8_t>(all[2] / whole)};
  for (const std::size_t at : clear) picture.pixels[at] = picture.mean;
  return picture;
}

int Repeated(double at, int size) {
  const double share = at - std::floor(at);
  return std::min(static_cast<int>(share * size), size - 1);
}

}  // namespace

Color Picture::At(double u, double v) const {
  if (!std::isfinite(u) || !std::isfinite(v)) return mean;
  const int column = Repeated(u, width);
  const int row = height - 1 - Repeated(v, height);
  return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(column)];
}

std::optional<Picture> ReadPicture(std::span<const std::uint8_t> bytes) {
  std::optional<Raw> raw;
  if (bytes.size() > 8 && bytes[0] == 0x89 && bytes[1] == 'P') {
    raw = ReadPng(bytes);
  } else if (bytes.size() > 3 && bytes[0] == 0xFF && bytes[1] == 0xD8) {
    Raw jpeg;
    if (DecodeJpeg(bytes, jpeg)) raw = std::move(jpeg);
  } else {
    raw = ReadTga(bytes);
  }
  if (!raw || raw->bytes.empty()) return std::nullopt;
  return Reduced(*raw);
}

}  // namespace ccmorse::assets
