// The pictures of materials: read small, by their mean and by coordinates.

#include "assets/picture.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>
// It needs FILE.
#include <jpeglib.h>

namespace ccmorse::assets {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Left half red, right half blue, but for a green bottom row's left half.
Bytes Pixels(std::size_t width, std::size_t height) {
  Bytes pixels;
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const bool left = x < width / 2;
      const bool bottom = y >= height / 2;
      const Bytes color = left ? (bottom ? Bytes{0, 255, 0} : Bytes{255, 0, 0}) : Bytes{0, 0, 255};
      pixels.insert(pixels.end(), color.begin(), color.end());
    }
  }
  return pixels;
}

Bytes Png(std::size_t width, std::size_t height) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(width);
  png.height = static_cast<png_uint_32>(height);
  png.format = PNG_FORMAT_RGB;
  const Bytes pixels = Pixels(width, height);
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&png, nullptr, &size, 0, pixels.data(), 0, nullptr);
  Bytes bytes(size);
  png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr);
  return bytes;
}

Bytes Jpeg(std::size_t width, std::size_t height) {
  jpeg_compress_struct info{};
  jpeg_error_mgr error{};
  info.err = jpeg_std_error(&error);
  jpeg_create_compress(&info);
  unsigned char* memory = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): libjpeg's
  jpeg_mem_dest(&info, &memory, &size);
  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);
  jpeg_start_compress(&info, TRUE);
  Bytes pixels = Pixels(width, height);
  while (info.next_scanline < info.image_height) {
    JSAMPROW row = pixels.data() + 3 * width * info.next_scanline;
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  Bytes bytes(memory, memory + size);
  std::free(memory);  // NOLINT: libjpeg made it so
  return bytes;
}

Bytes Tga(bool runs, bool from_top) {
  const std::size_t width = 4;
  const std::size_t height = 2;
  Bytes bytes(18, 0);
  bytes[2] = runs ? 10 : 2;
  bytes[12] = width;
  bytes[14] = height;
  bytes[16] = 24;
  bytes[17] = from_top ? 0x20 : 0;
  const Bytes pixels = Pixels(width, height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t row = from_top ? y : height - 1 - y;
    for (std::size_t x = 0; x < width; x += runs ? 2 : 1) {
      if (runs) bytes.push_back(0x81);
      const std::uint8_t* const pixel = &pixels[3 * (row * width + x)];
      bytes.insert(bytes.end(), {pixel[2], pixel[1], pixel[0]});
    }
  }
  return bytes;
}

void ExpectQuarters(const Picture& picture, int tolerance) {
  const auto near = [tolerance](Color a, Color b) {
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
  };
  near(picture.At(0.25, 0.75), {255, 0, 0});
  near(picture.At(0.75, 0.75), {0, 0, 255});
  near(picture.At(0.25, 0.25), {0, 255, 0});
  near(picture.At(-1.75, 3.25), {0, 255, 0});  // it repeats
  near(picture.mean, {63, 63, 127});
}

TEST(Picture, PngsAreRead) {
  const auto small = ReadPicture(Png(4, 2));
  ASSERT_TRUE(small);
  EXPECT_EQ(small->width, 4);
  ExpectQuarters(*small, 1);
  const auto large = ReadPicture(Png(1000, 600));
  ASSERT_TRUE(large);
  EXPECT_LE(large->width, 256);
  EXPECT_LE(large->height, 256);
  ExpectQuarters(*large, 2);
}

TEST(Picture, JpegsAreRead) {
  const auto small = ReadPicture(Jpeg(64, 32));
  ASSERT_TRUE(small);
  ExpectQuarters(*small, 12);
  const auto large = ReadPicture(Jpeg(2048, 1024));
  ASSERT_TRUE(large);
  EXPECT_LE(large->width, 256);
  ExpectQuarters(*large, 12);
}

TEST(Picture, TgasAreRead) {
  for (const bool runs : {false, true}) {
    for (const bool from_top : {false, true}) {
      const auto picture = ReadPicture(Tga(runs, from_top));
      ASSERT_TRUE(picture);
      ExpectQuarters(*picture, 1);
    }
  }
}

TEST(Picture, BrokenOnesAreNone) {
  EXPECT_FALSE(ReadPicture({}));
  EXPECT_FALSE(ReadPicture(Bytes{1, 2, 3}));
  EXPECT_FALSE(ReadPicture(Bytes(1000, 0)));
  for (const Bytes& whole : {Png(40, 20), Jpeg(40, 20), Tga(true, false), Tga(false, true)}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      // Cut short anywhere: nothing, or for a JPEG what is there; never more.
      const auto picture = ReadPicture(std::span(whole).first(size));
      if (picture) {
        EXPECT_LE(picture->width, 40);
      }
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
      Bytes changed = whole;
      changed[at] ^= 0xFFU;
      static_cast<void>(ReadPicture(changed));
    }
  }
}

}  // namespace
}  // namespace ccmorse::assets
