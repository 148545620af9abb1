// The course's maps: files, the grid and the heap.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "base/image.h"
#include "imr-h/dijkstra_heap.h"
#include "imr-h/map_file.h"
#include "imr-h/map_grid.h"

namespace {

namespace fs = std::filesystem;
using imr::CMapGrid;
using imr::SMapFile;

class MapFile : public testing::Test {
 protected:
  MapFile() {
    std::string name = testing::TempDir() + "ccmorse_map_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) std::abort();
    root_ = name;
  }
  ~MapFile() override { fs::remove_all(root_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(root_ / name, std::ios::binary) << text;
    return (root_ / name).string();
  }

  // What reading says; "" when it succeeds.
  static std::string ErrorOf(const std::string& file) {
    try {
      imr::loadMap(file);
      return "";
    } catch (const imr::io_error& error) {
      return error.what();
    }
  }

  fs::path root_;
};

TEST_F(MapFile, TextsFirstLineIsTheTopmostRow) {
  const SMapFile map = imr::loadMap(Write("a.txt", "2\n.O?\n...\n"));
  EXPECT_EQ(map.width, 3);
  EXPECT_EQ(map.height, 2);
  EXPECT_EQ(map.cellSize, 0.02);
  EXPECT_EQ(map.cells, (std::vector<double>{0, 0, 0, 0, 1, 0.5}));
  // Windows' ends of lines, and none at the end of the file.
  EXPECT_EQ(imr::loadMap(Write("b.txt", "2\r\n.O?\r\n...")).cells, map.cells);
}

TEST_F(MapFile, ErrorsNameFileAndLine) {
  EXPECT_EQ(ErrorOf(Write("a.txt", "2\n...\n..\n")),
            root_.string() + "/a.txt: line 3: 2 cells, and 3 in the first row");
  EXPECT_EQ(ErrorOf(Write("b.txt", "x\n")),
            root_.string() + "/b.txt: line 1: must be the number of rows");
  EXPECT_EQ(ErrorOf(Write("c.txt", "3\n...\n")),
            root_.string() + "/c.txt: line 1 says 3 rows, and there are 1");
  EXPECT_EQ(ErrorOf(root_.string() + "/none.txt"), "cannot read " + root_.string() + "/none.txt");
  EXPECT_EQ(ErrorOf(Write("d.map", "")),
            root_.string() + "/d.map: a map is a .txt, .yaml, .pgm or .png");
  EXPECT_EQ(ErrorOf(Write("e.pgm", "P5 3 3 255 ")),
            root_.string() + "/e.pgm: the picture ends too early");
  EXPECT_EQ(ErrorOf(Write("f.yaml", "image: e.pgm\nresolution: 0.1\n")),
            root_.string() + "/f.yaml: origin is missing");
  EXPECT_EQ(ErrorOf(Write("g.txt", "")),
            root_.string() + "/g.txt: line 1: must be the number of rows");
  EXPECT_EQ(ErrorOf(Write("h.png", "\x89PNG\r\n\x1a\n")),
            root_.string() + "/h.png: the picture ends too early");
}

TEST_F(MapFile, MapServersYamlWithItsPgm) {
  Write("m.pgm", std::string("P5\n# a comment\n3 2\n255\n") + "\xfe\xcd\x01" + "\x01\xfe\xfe");
  const SMapFile map = imr::loadMap(Write(
      "m.yaml",
      "image: m.pgm  # beside it\nresolution: 0.050000\norigin: [-10.0, 2.5, 0.0]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  EXPECT_EQ(map.cellSize, 0.05);
  EXPECT_EQ(map.originX, -10.0);
  EXPECT_EQ(map.originY, 2.5);
  EXPECT_EQ(map.cells, (std::vector<double>{1, 0, 0, 0, 0.5, 1}));
  const SMapFile negated = imr::loadMap(
      Write("n.yaml", "image: \"m.pgm\"\nresolution: 1\norigin: [0, 0, 0]\nnegate: 1\n"));
  EXPECT_EQ(negated.cells, (std::vector<double>{0, 1, 1, 1, 1, 0}));
  Write("s.pgm", "P2 3 1 100\n90 50 10\n");
  const SMapFile scaled =
      imr::loadMap(Write("s.yaml",
                         "image: s.pgm\nresolution: 1\norigin: [0, 0, 0]\nmode: scale\n"
                         "occupied_thresh: 0.8\nfree_thresh: 0.2\n"));
  ASSERT_EQ(scaled.cells.size(), 3U);
  EXPECT_EQ(scaled.cells[0], 0.0);
  EXPECT_DOUBLE_EQ(scaled.cells[1], 0.5);
  EXPECT_EQ(scaled.cells[2], 1.0);
}

// libpng writes and our decoder reads: pictures of noise, of runs and of one colour, which take
// all kinds of blocks and filters.
TEST_F(MapFile, PngsAreReadAsTheyWereWritten) {
  std::mt19937 random(1);
  for (const int kind : {0, 1, 2}) {
    ccmorse::Image image{61, 37, {}};
    for (unsigned i = 0; i < 61 * 37; ++i) {
      const auto level = static_cast<std::uint8_t>(kind == 0   ? random() % 256
                                                   : kind == 1 ? (i / 50) * 37 % 256
                                                               : 255U);
      image.pixels.push_back({level, level, level});
    }
    const std::string file = (root_ / "p.png").string();
    ccmorse::WritePng(image, file);
    const SMapFile map = imr::loadMap(file);
    ASSERT_EQ(map.width, 61);
    ASSERT_EQ(map.height, 37);
    for (std::size_t y = 0; y < 37; ++y) {
      for (std::size_t x = 0; x < 61; ++x) {
        const int level = image.pixels[(std::size_t{36} - y) * 61 + x].r;
        const double dark = 1.0 - level / 255.0;
        const double expected = dark > 0.65 ? 1.0 : dark < 0.196 ? 0.0 : 0.5;
        ASSERT_EQ(map.cells[y * 61 + x], expected) << x << ' ' << y;
      }
    }
  }
}

TEST_F(MapFile, DamagedPngsAreRefusedOrRead) {
  ccmorse::Image image{40, 40, {}};
  std::mt19937 random(2);
  for (int i = 0; i < 1600; ++i) {
    image.pixels.push_back({static_cast<std::uint8_t>(random() % 7 * 40), 0, 0});
  }
  const std::string file = (root_ / "p.png").string();
  ccmorse::WritePng(image, file);
  std::ifstream in(file, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string bad = good;
    for (int n = 0; n < 3; ++n) bad[random() % bad.size()] = static_cast<char>(random());
    if (i % 4 == 0) bad.resize(random() % bad.size());
    refused += ErrorOf(Write("bad.png", bad)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

TEST_F(MapFile, WhatIsSavedIsReadBack) {
  CMapGrid grid(5, 3, 0.05);
  grid.setCell(0, 0, CMapGrid::WALL);
  grid.setCell(4, 2, CMapGrid::FLOOR);
  for (const char* name : {"a.txt", "b.yaml"}) {
    const std::string file = (root_ / name).string();
    grid.save(file);
    EXPECT_EQ(CMapGrid(file, 0.05).cells(), grid.cells()) << name;
    EXPECT_EQ(CMapGrid(file, 0.05).getCellSize(), 0.05) << name;
  }
  EXPECT_THROW(grid.save((root_ / "c.png").string()), imr::argument_error);
  EXPECT_THROW(grid.save((root_ / "none/c.txt").string()), imr::io_error);
}

TEST(MapGrid, NewCellsAreUnknownAndRowsCountFromTheBottom) {
  CMapGrid grid(10, 20, 0.5);
  EXPECT_EQ(grid.getCell(9, 19), CMapGrid::UNKNOWN);
  EXPECT_EQ(grid.getX(4.99), 9);
  EXPECT_EQ(grid.getY(0.0), 0);
  EXPECT_EQ(grid.getY(-0.01), -1);
  EXPECT_DOUBLE_EQ(grid.getPosY(19), 9.75);
  grid.setCell(1, 2, 0.25);
  const CMapGrid copy(grid);
  grid.fill(CMapGrid::FLOOR);
  EXPECT_EQ(copy.getCell(1, 2), 0.25);
  std::vector<double> cells(200, -1.0);
  copy.copyTo(cells.data());
  EXPECT_EQ(cells[21], 0.25);
  EXPECT_EQ(cells[199], CMapGrid::UNKNOWN);
}

TEST(MapGrid, RangesAreChecked) {
  CMapGrid grid(3, 2, 0.1);
  EXPECT_THROW(grid.getCell(3, 0), imr::argument_error);
  EXPECT_THROW(grid.getCell(0, -1), imr::argument_error);
  EXPECT_THROW(grid.setCell(0, 2, 0.0), imr::argument_error);
  EXPECT_THROW(grid.setCell(0, 0, 1.1), imr::argument_error);
  EXPECT_THROW(CMapGrid(0, 2, 0.1), imr::argument_error);
  EXPECT_THROW(CMapGrid(2, 2, 0.0), imr::argument_error);
  EXPECT_THROW(CMapGrid(1 << 14, 1 << 14, 0.1), imr::argument_error);
}

TEST(Heap, GivesTheCheapestFirstWhateverWasUpdated) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    imr::dijkstra::CHeap<int> heap(100);
    std::vector<int> cost(100, -1);
    for (int i = 0; i < 300; ++i) {
      const int n = static_cast<int>(random() % 100);
      cost[static_cast<std::size_t>(n)] = static_cast<int>(random() % 50);
      heap.update(n, cost[static_cast<std::size_t>(n)]);
      ASSERT_TRUE(heap.is_valid());
    }
    std::vector<int> expected;
    for (const int c : cost) {
      if (c >= 0) expected.push_back(c);
    }
    std::sort(expected.begin(), expected.end());
    for (const int c : expected) {
      const int n = heap.getFirst();
      ASSERT_NE(n, -1);
      EXPECT_EQ(cost[static_cast<std::size_t>(n)], c);
      EXPECT_EQ(heap.getIDX(n), -1);
    }
    EXPECT_EQ(heap.getFirst(), -1);
  }
}

TEST(Heap, RefusesWhatCannotBe) {
  imr::dijkstra::CHeap<double> heap(2);
  heap.add(1, 3.0);
  EXPECT_EQ(heap.getIDX(1), 0);
  EXPECT_EQ(heap.getCost(1), 3.0);
  EXPECT_THROW(heap.add(1, 2.0), imr::argument_error);
  EXPECT_THROW(heap.add(2, 2.0), imr::argument_error);
  EXPECT_THROW(heap.getIDX(-1), imr::argument_error);
}

}  // namespace
