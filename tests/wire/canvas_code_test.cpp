// The canvas's code: what comes out is what went in, whatever was sent before.

#include "wire/canvas_code.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <map>
#include <utility>

namespace ccmorse::wire {
namespace {

using Cells = std::vector<std::uint8_t>;

Cells Filled(int width, int height, std::uint8_t value) {
  return Cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kCellBytes,
               value);
}

// Pictures as they occur: noise, areas of one colour, and a few cells changed in either.
Cells DrawnOn(const Cells& before, int width, int height) {
  Cells cells = before;
  const auto pixel = [&](int x, int y, std::array<std::uint8_t, 3> color) {
    for (std::size_t c = 0; c < kCellBytes; ++c) {
      cells[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
             static_cast<std::size_t>(x)) *
                kCellBytes +
            c] = color[c];
    }
  };
  const int strokes = *rc::gen::inRange(0, 12);
  for (int i = 0; i < strokes; ++i) {
    const int left = *rc::gen::inRange(0, width);
    const int bottom = *rc::gen::inRange(0, height);
    const int right = *rc::gen::inRange(left, width) + 1;
    const int top = *rc::gen::inRange(bottom, height) + 1;
    const bool noise = *rc::gen::arbitrary<bool>();
    auto color = *rc::gen::arbitrary<std::array<std::uint8_t, 3>>();
    for (int y = bottom; y < top; ++y) {
      for (int x = left; x < right; ++x) {
        if (noise) color = *rc::gen::arbitrary<std::array<std::uint8_t, 3>>();
        pixel(x, y, color);
      }
    }
  }
  return cells;
}

TEST(N05, ChangesMakeTheBaseTheImage) {
  EXPECT_TRUE(rc::check("changes applied to the base give the image", [] {
    const int width = *rc::gen::inRange(1, 24);
    const int height = *rc::gen::inRange(1, 24);
    const Cells base = DrawnOn(Filled(width, height, 0), width, height);
    const Cells image = DrawnOn(base, width, height);
    std::string code;
    AppendChanges(code, base.data(), image.data(), width, height);
    RC_ASSERT(code.empty() == (base == image));
    Cells changed = base;
    RC_ASSERT(ApplyChanges(code, changed, width, height));
    RC_ASSERT(changed == image);
  }));
}

TEST(N05, ALargePictureOfOneColourIsAFewBytes) {
  const Cells base = Filled(1000, 1000, 0);
  const Cells image = Filled(1000, 1000, 7);
  std::string code;
  AppendChanges(code, base.data(), image.data(), 1000, 1000);
  EXPECT_LT(code.size(), 400U);
  Cells changed = base;
  ASSERT_TRUE(ApplyChanges(code, changed, 1000, 1000));
  EXPECT_EQ(changed, image);
}

TEST(N05, OneChangedCellIsOneSmallRectangle) {
  const Cells base = Filled(172, 186, 9);
  Cells image = base;
  image[3 * (172 * 100 + 50) + 1] = 77;
  std::string code;
  AppendChanges(code, base.data(), image.data(), 172, 186);
  EXPECT_EQ(code.size(), 12U + 2U + 3U);
}

TEST(N05, NoiseCostsHardlyMoreThanItsCells) {
  Cells image = Filled(172, 186, 0);
  std::uint32_t state = 1;
  for (std::uint8_t& byte : image) {
    state = state * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(state >> 24U);
  }
  std::string code;
  AppendChanges(code, Filled(172, 186, 0).data(), image.data(), 172, 186);
  EXPECT_LT(code.size(), image.size() + 100);
}

// An independent reading of what ExpandRectangles() gives: cell by cell, the last one wins.
std::map<std::pair<int, int>, std::array<std::uint8_t, 3>> Painted(const std::string& plain) {
  std::map<std::pair<int, int>, std::array<std::uint8_t, 3>> cells;
  std::size_t at = 0;
  const auto number = [&](int bytes) {
    std::int64_t value = 0;
    for (int i = 0; i < bytes; ++i) {
      value += std::int64_t{static_cast<unsigned char>(plain.at(at++))} << (8 * i);
    }
    return value;
  };
  while (at < plain.size()) {
    const int x = static_cast<std::int32_t>(number(4));
    const int y = static_cast<std::int32_t>(number(4));
    const auto width = static_cast<int>(number(2));
    const auto height = static_cast<int>(number(2));
    for (int i = 0; i < width * height; ++i) {
      auto& cell = cells[{x + i % width, y + i / width}];
      for (std::uint8_t& channel : cell) channel = static_cast<std::uint8_t>(number(1));
    }
  }
  return cells;
}

TEST(N05, RectanglesComeOutAsTheyWentIn) {
  EXPECT_TRUE(rc::check("rectangles expand to their cells", [] {
    std::string code;
    std::map<std::pair<int, int>, std::array<std::uint8_t, 3>> expected;
    const int count = *rc::gen::inRange(0, 5);
    for (int i = 0; i < count; ++i) {
      const int x = *rc::gen::inRange(-1000000000, 1000000000);
      const int y = *rc::gen::inRange(-5, 5);
      const int width = *rc::gen::inRange(1, 9);
      const int height = *rc::gen::inRange(1, 9);
      const Cells cells = DrawnOn(Filled(width, height, 3), width, height);
      AppendRectangle(code, x, y, width, height, cells.data());
      for (int k = 0; k < width * height; ++k) {
        const auto at = static_cast<std::size_t>(k) * kCellBytes;
        expected[{x + k % width, y + k / width}] = {cells[at], cells[at + 1], cells[at + 2]};
      }
    }
    std::string plain;
    RC_ASSERT(ExpandRectangles(code, &plain));
    RC_ASSERT(Painted(plain) == expected);
  }));
}

std::string Head(int x, int y, int width, int height) {
  std::string code;
  for (const int value : {x, y}) {
    for (int i = 0; i < 4; ++i) code += static_cast<char>(value >> (8 * i) & 0xFF);
  }
  for (const int value : {width, height}) {
    for (int i = 0; i < 2; ++i) code += static_cast<char>(value >> (8 * i) & 0xFF);
  }
  return code;
}

TEST(N05, WhatIsNoCodeIsRefused) {
  const std::string run_of_one(
      "\x01\x40"
      "abc",
      5);
  const std::string keep_one("\x01\x80", 2);
  struct Case {
    const char* what;
    std::string code;
    bool as_changes;
    bool as_rectangles;
  };
  for (const Case& c : {
           Case{"nothing", "", true, true},
           Case{"one cell", Head(0, 0, 1, 1) + run_of_one, true, true},
           Case{"kept cells", Head(0, 0, 1, 1) + keep_one, true, false},
           Case{"cut short in the head", Head(0, 0, 1, 1).substr(0, 11), false, false},
           Case{"without cells", Head(0, 0, 1, 1), false, false},
           Case{"cut short in a colour", Head(0, 0, 1, 1) + run_of_one.substr(0, 4), false, false},
           Case{"no columns", Head(0, 0, 0, 1) + run_of_one, false, false},
           Case{"no rows", Head(0, 0, 1, 0) + run_of_one, false, false},
           Case{"left of the image", Head(-1, 0, 1, 1) + run_of_one, false, true},
           Case{"right of the image", Head(4, 0, 1, 1) + run_of_one, false, true},
           Case{"below the image", Head(0, -1, 1, 1) + run_of_one, false, true},
           Case{"above the image", Head(0, 4, 1, 1) + run_of_one, false, true},
           Case{"out by overflow", Head(0x7FFFFFFF, 0, 1, 1) + run_of_one, false, true},
           Case{"more cells than it has", Head(0, 0, 1, 1) + std::string("\x02\x40xyz", 5), false,
                false},
           Case{"an empty stretch", Head(0, 0, 1, 1) + std::string("\0\0", 2), false, false},
           Case{"an unknown stretch", Head(0, 0, 1, 1) + std::string("\x01\xC0xyz", 5), false,
                false},
       }) {
    Cells image = Filled(4, 4, 0);
    EXPECT_EQ(ApplyChanges(c.code, image, 4, 4), c.as_changes) << c.what;
    std::string plain;
    EXPECT_EQ(ExpandRectangles(c.code, &plain), c.as_rectangles) << c.what;
  }
}

TEST(N05, AFewBytesCannotStandForEndlesslyManyCells) {
  std::string code;
  for (int i = 0; i < 3; ++i) {
    code += Head(0, 0, 1000, 1000);
    for (int left = 1000000; left > 0; left -= 16383) {
      const int count = std::min(left, 16383);
      code += static_cast<char>(count & 0xFF);
      code += static_cast<char>(0x40 | count >> 8);
      code += "abc";
    }
  }
  std::string plain;
  EXPECT_FALSE(ExpandRectangles(code, &plain));
  EXPECT_LT(plain.size(), 4U << 20);
}

}  // namespace
}  // namespace ccmorse::wire
