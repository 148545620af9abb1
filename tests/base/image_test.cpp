#include "base/image.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "base/error.h"

namespace ccmorse {
namespace {

TEST(Image, PngRoundTripKeepsEveryPixel) {
  Image image{3, 2, {{1, 2, 3}, {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {9, 9, 9}, {7, 8, 9}}};
  const std::string path = ::testing::TempDir() + "ccmorse_image_test.png";
  WritePng(image, path);
  const Image back = ReadPng(path);
  EXPECT_EQ(back.width, 3);
  EXPECT_EQ(back.height, 2);
  EXPECT_EQ(back.pixels, image.pixels);
  std::remove(path.c_str());
}

TEST(Image, ALinkIsFollowedAndADeviceStaysADevice) {
  const std::string target = ::testing::TempDir() + "ccmorse_image_target.png";
  const std::string link = ::testing::TempDir() + "ccmorse_image_link.png";
  std::filesystem::remove(link);
  std::filesystem::create_symlink(target, link);
  WritePng({1, 1, {{5, 6, 7}}}, link);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(ReadPng(target).pixels[0], (Color{5, 6, 7}));
  std::filesystem::remove(link);
  std::filesystem::remove(target);
  WritePng({1, 1, {{5, 6, 7}}}, "/dev/null");
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST(Image, AFolderThatIsNotThereIsAnErrorThatNamesThePath) {
  try {
    WritePng({1, 1, {{0, 0, 0}}}, "/no/such/folder/x.png");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/x.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace ccmorse
