#include "base/image.h"

#include <png.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/error.h"

namespace ccmorse {

static_assert(sizeof(Color) == 3, "rows of Color are handed to libpng as packed RGB");

void WritePng(const Image& image, const std::string& path) {
  // A link is followed, and what is no plain file (a device) is written to as it is.
  std::error_code unknown;
  std::filesystem::path target = path;
  for (int links = 0; links < 16 && std::filesystem::is_symlink(target, unknown); ++links) {
    target = target.parent_path() / std::filesystem::read_symlink(target, unknown);
  }
  const bool special = std::filesystem::exists(target, unknown) &&
                       !std::filesystem::is_regular_file(target, unknown);
  const std::string temporary =
      special ? target.string() : target.string() + ".tmp" + std::to_string(::getpid());
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  errno = 0;
  if (png_image_write_to_file(&png, temporary.c_str(), 0, image.pixels.data(), 0, nullptr) == 0) {
    const std::string reason = errno != 0 ? std::strerror(errno) : png.message;
    if (!special) std::remove(temporary.c_str());
    throw Error("cannot write " + path + ": " + reason);
  }
  if (special) return;
  std::error_code failed;
  std::filesystem::rename(temporary, target, failed);
  if (failed) {
    std::remove(temporary.c_str());
    throw Error("cannot write " + path + ": " + failed.message());
  }
}

Image ReadPng(const std::string& path) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) {
    throw Error("cannot read " + path + ": " + png.message);
  }
  png.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixels.resize(std::size_t{png.width} * png.height);
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) {
    throw Error("cannot read " + path + ": " + png.message);
  }
  return image;
}

}  // namespace ccmorse
