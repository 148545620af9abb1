#include "sim/canvas.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "scene/scenario.h"
#include "sim/simulation.h"

namespace ccmorse::sim {
namespace {

using Cell = std::pair<int, int>;

class PenTest : public ::testing::Test {
 protected:
  Json Ask(const std::string& name, const Json::Array& arguments) {
    for (const Service& service : simulation_.FindComponent("s1r.pen")->services()) {
      if (service.name != name) continue;
      return service.text ? Json::Parse(service.text()) : service.run(arguments);
    }
    throw std::runtime_error("no service " + name);
  }
  std::set<Cell> Drawn() {
    std::set<Cell> cells;
    const Canvas& canvas = simulation_.canvas();
    for (int y = 0; y < canvas.height(); ++y) {
      for (int x = 0; x < canvas.width(); ++x) {
        if (canvas.IsDrawn(x, y)) cells.insert({x, y});
      }
    }
    return cells;
  }
  Simulation simulation_{scene::ParseScenario("{}", "test.json")};
};

// The requirement ids of thesis 4.2 as test suites.
class P01 : public PenTest {};
class P02 : public PenTest {};
class P08 : public PenTest {};
class P09 : public PenTest {};
class P10 : public PenTest {};
class P11 : public PenTest {};
class P12 : public PenTest {};
class P13 : public PenTest {};
class P14 : public PenTest {};
class P26 : public PenTest {};

TEST_F(P01, AGridMapIsThePictureCellByCell) {
  // Free cells white, unknown ones grey, obstacles black: one of a pattern of its own.
  Ask("resize_canvas", {7, 5});
  std::vector<Color> cells;
  Json::Array pixels;
  for (int i = 0; i < 35; ++i) {
    const int level = i % 3 == 0 ? 255 : i % 5 == 0 ? 0 : 128;
    const auto byte = static_cast<std::uint8_t>(level);
    cells.push_back({byte, byte, byte});
    pixels.emplace_back(Json::Array{level, level, level});
  }
  Ask("set_image_data", {Json(pixels)});
  const Image image = simulation_.canvas().ToImage();
  ASSERT_EQ(image.width, 7);
  ASSERT_EQ(image.height, 5);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      EXPECT_EQ(image.pixels[static_cast<std::size_t>((4 - y) * 7 + x)],
                cells[static_cast<std::size_t>(y * 7 + x)])
          << x << " " << y;
    }
  }
}

TEST_F(P02, EveryRobotWithAPenDrawsOnTheOneCanvas) {
  Simulation two(scene::ParseScenario(
      R"({"robots": [{"name": "a", "pose": {"x": 1, "y": 2}}, {"name": "b", "pose": {"x": 2, "y": 2}}]})",
      "test.json"));
  const auto ask = [&](const std::string& pen, const std::string& name,
                       const Json::Array& arguments) {
    for (const Service& service : two.FindComponent(pen)->services()) {
      if (service.name == name) return service.run(arguments);
    }
    throw std::runtime_error("no service " + name);
  };
  const std::uint64_t before = two.canvas().revision();
  two.Sense();
  two.Act();
  EXPECT_EQ(two.canvas().revision(), before);  // passive: it changes by pens only
  ask("a.pen", "set_pixel", {1, 1, 1, 2, 3});
  ask("b.pen", "set_pixel", {2, 2, 4, 5, 6});
  for (const char* pen : {"a.pen", "b.pen"}) {
    EXPECT_EQ(ask(pen, "get_pixel", {1, 1}), Json::Parse("[1, 2, 3]"));
    EXPECT_EQ(ask(pen, "get_pixel", {2, 2}), Json::Parse("[4, 5, 6]"));
  }
}

TEST_F(P08, APixelThatIsSetIsWhatIsGot) {
  Ask("set_pixel", {3, 4, 10, 20, 30});
  EXPECT_EQ(Ask("get_pixel", {3, 4}), Json::Parse("[10, 20, 30]"));
  EXPECT_EQ(Ask("get_pixel", {4, 3}), Json::Parse("[255, 255, 255]"));
}

TEST_F(P08, OutsideIsLeftOutWhenDrawingAndRefusedWhenAsking) {
  EXPECT_NO_THROW(Ask("set_pixel", {-1, 4000, 1, 2, 3}));
  EXPECT_TRUE(Drawn().empty());
  EXPECT_THROW(Ask("get_pixel", {172, 0}), WrongArgument);
  EXPECT_THROW(Ask("set_pixel", {1, 1, 256, 0, 0}), WrongArgument);
  EXPECT_THROW(Ask("set_pixel", {1.5, 1, 0, 0, 0}), WrongArgument);
}

// The textbook's integer algorithm, step by step, for the first octant and its mirror images.
std::set<Cell> TextbookLine(int x0, int y0, int x1, int y1) {
  std::set<Cell> cells;
  const int dx = std::abs(x1 - x0);
  const int dy = std::abs(y1 - y0);
  const bool steep = dy > dx;
  const int major = steep ? dy : dx;
  const int minor = steep ? dx : dy;
  int decision = 2 * minor - major;
  int side = 0;
  for (int k = 0; k <= major; ++k) {
    const int along_x = (x1 >= x0 ? 1 : -1) * (steep ? side : k);
    const int along_y = (y1 >= y0 ? 1 : -1) * (steep ? k : side);
    cells.insert({x0 + along_x, y0 + along_y});
    if (decision >= 0) {
      ++side;
      decision -= 2 * major;
    }
    decision += 2 * minor;
  }
  return cells;
}

TEST_F(P09, LinesAreBresenhamsCellForCell) {
  EXPECT_TRUE(rc::check("line against the textbook's loop", [this] {
    const int x0 = *rc::gen::inRange(0, 100);
    const int y0 = *rc::gen::inRange(0, 100);
    const int x1 = *rc::gen::inRange(0, 100);
    const int y1 = *rc::gen::inRange(0, 100);
    simulation_.canvas().Reset();
    Ask("set_line", {x0, y0, x1, y1, 0, 255, 0});
    RC_ASSERT(Drawn() == TextbookLine(x0, y0, x1, y1));
  }));
}

TEST_F(P09, ALineThatLeavesTheCanvasShowsItsPartInside) {
  Ask("set_line", {-1000000000, 5, 1000000000, 5, 0, 0, 0});
  EXPECT_EQ(Drawn().size(), 172U);
}

TEST_F(P10, WholeImagesAndSinglePixelsRoundTrip) {
  Ask("resize_canvas", {2, 3});
  const Json image = Json::Parse("[[1,2,3],[4,5,6],[7,8,9],[10,11,12],[13,14,15],[16,17,18]]");
  Ask("set_image_data", {image});
  EXPECT_EQ(Ask("get_image_data", {}), image);
  EXPECT_EQ(Ask("get_pixel", {1, 2}), Json::Parse("[16, 17, 18]"));
  Ask("update_image_data", {Json::Parse("[[0, 1, 0, 0, 0], [1, 1, 255, 255, 255]]")});
  EXPECT_EQ(Ask("get_image_data", {}),
            Json::Parse("[[1,2,3],[4,5,6],[0,0,0],[255,255,255],[13,14,15],[16,17,18]]"));
}

TEST_F(P10, AWrongPixelInAListChangesNothing) {
  EXPECT_THROW(Ask("set_image_data", {Json::Parse("[[1,2,3]]")}), WrongArgument);
  EXPECT_THROW(Ask("update_image_data", {Json::Parse("[[0,0,1,2,3],[0,0,1,2,-3]]")}),
               WrongArgument);
  EXPECT_TRUE(Drawn().empty());
}

TEST_F(P11, ResizingChangesTheResolution) {
  for (const auto& [width, height] : {Cell{172, 186}, Cell{200, 200}, Cell{1, 1}}) {
    Ask("resize_canvas", {width, height});
    EXPECT_EQ(Ask("get_size", {}), Json(Json::Array{width, height}));
  }
  EXPECT_THROW(Ask("resize_canvas", {0, 10}), WrongArgument);
  EXPECT_THROW(Ask("resize_canvas", {100000, 100000}), WrongArgument);
}

TEST_F(P12, CellSizeIsTwoCentimetresForTheArena) {
  EXPECT_NEAR(Ask("get_cell_size", {}).AsDouble(), 0.02, 1e-15);
  Ask("resize_canvas", {171, 186});
  EXPECT_NEAR(Ask("get_cell_size", {}).AsDouble(), 0.02, 1e-15);
}

TEST_F(P13, ACopyIsAPngOnDisk) {
  simulation_.canvas().set_picture_folder(::testing::TempDir());
  Ask("set_pixel", {0, 0, 9, 8, 7});
  const std::string path = Ask("save_image_copy", {"p13_copy"}).AsString();
  const Image image = ReadPng(path);
  EXPECT_EQ(image.width, 172);
  EXPECT_EQ(image.height, 186);
  // Cell (0, 0) is the arena's bottom-left corner, so the picture's last row.
  EXPECT_EQ(image.pixels[std::size_t{185} * 172], (Color{9, 8, 7}));
  std::filesystem::remove(path);
}

TEST_F(P13, AClientCannotWriteElsewhere) {
  for (const char* name : {"../x", "/tmp/x", "", ".hidden", "a/b"}) {
    EXPECT_THROW(Ask("save_image_copy", {name}), ServiceFailed) << name;
  }
}

TEST_F(P14, TransparencyBlendsWithWhatWasThere) {
  Ask("set_pixel", {1, 1, 100, 0, 200});
  Ask("set_pixel", {1, 1, 200, 100, 0, 0.25});
  EXPECT_EQ(Ask("get_pixel", {1, 1}), Json::Parse("[125, 25, 150]"));
  Ask("set_pixel", {2, 2, 0, 0, 0, 0.0});
  EXPECT_EQ(Drawn().size(), 1U);
  EXPECT_THROW(Ask("set_pixel", {1, 1, 0, 0, 0, 1.5}), WrongArgument);
}

TEST_F(P26, TheListOfLayersKeepsItsSwitchesAndChangesNoCell) {
  const std::uint64_t hash = simulation_.Hash();
  const std::uint32_t none = simulation_.canvas().layers_revision();
  EXPECT_EQ(none, 0U);
  EXPECT_EQ(Ask("get_layers", {}), Json::Parse("[]"));
  Ask("set_layers", {Json::Parse(R"([["base", 0, true], ["scan", 2, false]])")});
  EXPECT_EQ(Ask("get_layers", {}),
            Json::Parse(R"([["base", 0, true, true], ["scan", 2, false, true]])"));
  Ask("show_layer", {"scan", false});
  // A program that sends another list does not switch on what people have switched off.
  Ask("set_layers", {Json::Parse(R"([["scan", 2, true], ["trace", 3, true]])")});
  const Json after = Json::Parse(R"([["scan", 2, true, false], ["trace", 3, true, true]])");
  EXPECT_EQ(Ask("get_layers", {}), after);
  const std::uint32_t revision = simulation_.canvas().layers_revision();
  EXPECT_EQ(revision, 3U);
  Ask("set_layers", {Json::Parse(R"([["scan", 2, true], ["trace", 3, true]])")});
  Ask("show_layer", {"trace", true});
  EXPECT_EQ(simulation_.canvas().layers_revision(), revision) << "nothing has changed";
  simulation_.ResetObjects();
  simulation_.canvas().Reset();
  EXPECT_EQ(Ask("get_layers", {}), after);
  EXPECT_EQ(simulation_.Hash(), hash);
}

TEST_F(P26, AWrongListOfLayersIsRefusedAsAWhole) {
  Ask("set_layers", {Json::Parse(R"([["base", 0, true]])")});
  for (const char* wrong :
       {"7", R"([["a", 0]])", R"([["", 0, true]])", R"([["a", 0.5, true]])", R"([["a", 0, 1]])",
        R"([[1, 0, true]])", R"([["a", 0, true], ["a", 1, true]])",
        R"([["a", 3000000000, true]])"}) {
    EXPECT_THROW(Ask("set_layers", {Json::Parse(wrong)}), WrongArgument) << wrong;
  }
  Json::Array many;
  for (int i = 0; i < 257; ++i) many.emplace_back(Json::Array{std::to_string(i), 0, true});
  EXPECT_THROW(Ask("set_layers", {Json(many)}), WrongArgument);
  EXPECT_THROW(Ask("set_layers", {Json(Json::Array{Json::Array{std::string(101, 'a'), 0, true}})}),
               WrongArgument);
  EXPECT_EQ(Ask("get_layers", {}), Json::Parse(R"([["base", 0, true, true]])"));
  EXPECT_THROW(Ask("show_layer", {"base", 1}), WrongArgument);
  try {
    Ask("show_layer", {"bass", false});
    FAIL() << "there is no such layer";
  } catch (const ServiceFailed& failed) {
    EXPECT_NE(std::string(failed.what()).find("'base'"), std::string::npos) << failed.what();
  }
}

}  // namespace
}  // namespace ccmorse::sim
