// WindowProxy's grid maps in layers (thesis 4.2.2).

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <thread>
#include <type_traits>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

constexpr Color_t kWhite{255, 255, 255};
constexpr Color_t kGreen{0, 255, 0};
constexpr Color_t kRed{255, 0, 0};

/// A window, and the canvas as it comes out of what the simulator hears of it.
class Layered : public ::testing::Test {
 protected:
  static constexpr int kWidth = 12;
  static constexpr int kHeight = 9;
  static constexpr std::size_t kCells = std::size_t{kWidth} * kHeight;

  Layered() : window(WindowProxy::GetInstance(&client, kWidth, kHeight)) { Hear(); }
  ~Layered() override { delete &window; }

  // What has come since the last call, and how many cells it named.
  std::size_t Hear() {
    std::size_t count = 0;
    for (const std::string& line : server.Lines()) {
      const std::string start = "s1r.pen update_image_data ";
      if (line.rfind(start, 0) != 0) continue;
      const MorseValue pixels = MorseValue::Parse(line.substr(start.size())).At(0);
      for (std::size_t i = 0; i < pixels.GetSize(); ++i, ++count) {
        const MorseValue pixel = pixels.At(i);
        const auto byte = [&](const char* which) {
          return static_cast<unsigned char>(pixel.GetInt(which));
        };
        canvas[{pixel.GetInt("0"), pixel.GetInt("1")}] = {byte("2"), byte("3"), byte("4")};
      }
    }
    server.ClearLines();
    return count;
  }
  std::size_t Read() {
    client.Read();
    return Hear();
  }
  // White where nothing was drawn, as the canvas reads.
  Color_t Shown(int x, int y) const {
    const auto found = canvas.find({x, y});
    return found == canvas.end() ? kWhite : found->second;
  }

  FakeServer server;
  PlayerClient client{kHost, server.port()};
  WindowProxy& window;
  std::map<std::pair<int, int>, Color_t> canvas;
};
using P25 = Layered;
using P26 = Layered;
using P27 = Layered;
using P28 = Layered;
using P29 = Layered;

TEST_F(P25, TheWindowHasTheShapeOfAPlayerProxy) {
  EXPECT_TRUE((std::is_base_of_v<PlayerCc::ClientProxy, WindowProxy>));
  EXPECT_EQ(window.GetPlayerClient(), &client);
  EXPECT_EQ(window.GetIndex(), 0U);
  EXPECT_EQ(&WindowProxy::GetInstance(), &window);
}

TEST_F(P26, ManyMapsAreKeptByName) {
  for (int i = 0; i < 50; ++i) window.AddLayer("map " + std::to_string(i)).SetPixel(i % kWidth, 0);
  EXPECT_EQ(window.GetLayerNames().size(), 50U);
  EXPECT_EQ(window.GetLayer("map 7").GetPixel(7, 0), (Color_t{0, 0, 0}));
  EXPECT_EQ(window.GetLayer("map 7").GetPixel(8, 0), std::nullopt);
  EXPECT_THROW(window.AddLayer("map 7"), MorseError);
  window.RemoveLayer("map 7");
  EXPECT_FALSE(window.HasLayer("map 7"));
  EXPECT_THROW(window.RemoveLayer("map 7"), MorseError);
  window.AddLayer("base");
  for (int i = 0; i < 50; ++i) {
    if (i != 7) window.RemoveLayer("map " + std::to_string(i));
  }
  EXPECT_TRUE(Has(ErrorOf([&] { window.GetLayer("bass"); }).GetErrorStr(),
                  "there is no layer 'bass'; known are base"));
}

TEST_F(P26, OnlyWhatHasChangedLeavesWithTheNextRead) {
  GridMap& base = window.AddLayer("base");
  base.SetOccupancy(std::vector<double>(kCells, 0.5));
  EXPECT_EQ(Hear(), 0U);  // not before a Read()
  EXPECT_EQ(Read(), kCells);
  EXPECT_EQ(Read(), 0U);
  GridMap& scan = window.AddLayer("scan", kGreen, 1);
  scan.SetLine(0, 0, 3, 0);
  scan.SetLine(2, 0, 4, 0);
  EXPECT_EQ(Read(), 5U);
  // Beneath a layer that covers it, changed and changed back, or given the colour it has.
  base.SetPixel(0, 0, 1, 2, 3);
  scan.ClearPixel(1, 0);
  scan.SetPixel(1, 0);
  scan.SetPixel(2, 0, kGreen.r, kGreen.g, kGreen.b);
  EXPECT_EQ(Read(), 0U);
  scan.Clear();
  EXPECT_EQ(Read(), 5U);
  EXPECT_EQ(Shown(0, 0), (Color_t{1, 2, 3}));
  EXPECT_EQ(Shown(1, 0), LayerColor::kUnknown);
  window.Redraw();
  EXPECT_EQ(Read(), kCells);
}

TEST_F(P26, RequestsSeeTheLayersAndTheEndOfTheWindowKeepsThem) {
  GridMap& map = window.AddLayer("map");
  map.SetPixel(1, 1);
  window.SaveImageCopy("a.png");
  const Lines lines = server.Lines();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "s1r.pen update_image_data [[[1, 1, 0, 0, 0]]]");
  server.ClearLines();
  WindowProxy::GetInstance(&client, 3, 3).ResizeCanvas(5, 4);
  EXPECT_EQ(map.GetWidth(), 5);
  EXPECT_EQ(map.GetPixel(1, 1), std::nullopt);
  map.SetPixel(4, 3);
  client.Read();
  EXPECT_EQ(server.Count("s1r.pen update_image_data [[[4, 3, 0, 0, 0]]]"), 1U);
}

TEST_F(P27, NameAndColour) {
  GridMap& map = window.AddLayer("robot", kRed);
  EXPECT_EQ(map.GetName(), "robot");
  EXPECT_EQ(map.GetColor(), kRed);
  map.SetPixel(1, 1);
  map.SetPixel(2, 2, "#34AAFF");
  Read();
  EXPECT_EQ(Shown(1, 1), kRed);
  map.SetColor(0, 1, 0.0);  // cells in the layer's colour follow it, others keep theirs
  EXPECT_EQ(Read(), 1U);
  EXPECT_EQ(Shown(1, 1), kGreen);
  EXPECT_EQ(Shown(2, 2), (Color_t{0x34, 0xAA, 0xFF}));
  EXPECT_EQ(map.GetPixel(1, 1), kGreen);
}

TEST_F(P27, Transparency) {
  window.AddLayer("below", {100, 0, 200}).SetPixel(1, 1);
  GridMap& above = window.AddLayer("above", {200, 100, 0}, 1, 0.75);
  above.SetPixel(1, 1);
  above.SetPixel(2, 2);
  Read();
  EXPECT_EQ(Shown(1, 1), (Color_t{125, 25, 150}));
  EXPECT_EQ(Shown(2, 2), (Color_t{241, 216, 191}));  // over white
  above.SetTransparency(1.0);
  Read();
  EXPECT_EQ(Shown(1, 1), (Color_t{100, 0, 200}));
  EXPECT_EQ(Shown(2, 2), kWhite);
  for (const double wrong : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(above.SetTransparency(wrong), MorseError);
    EXPECT_THROW(window.AddLayer("wrong", kRed, 0, wrong), MorseError);
  }
  EXPECT_FALSE(window.HasLayer("wrong"));
  EXPECT_DOUBLE_EQ(above.GetTransparency(), 1.0);
}

TEST_F(P27, TransparentColour) {
  window.AddLayer("below", kRed).SetLine(0, 0, 3, 0);
  GridMap& above = window.AddLayer("above", kGreen);
  above.SetPixel(0, 0, 1, 2, 3);
  above.SetPixel(1, 0, 1, 2, 4);
  above.SetPixel(2, 0);
  above.SetTransparentColor(1, 2, 3);
  Read();
  EXPECT_EQ(Shown(0, 0), kRed);
  EXPECT_EQ(Shown(1, 0), (Color_t{1, 2, 4}));
  above.SetTransparentColor(kGreen);
  EXPECT_EQ(above.GetTransparentColor(), kGreen);
  Read();
  EXPECT_EQ(Shown(0, 0), (Color_t{1, 2, 3}));
  EXPECT_EQ(Shown(2, 0), kRed);
  above.RemoveTransparentColor();
  Read();
  EXPECT_EQ(Shown(2, 0), kGreen);
}

TEST_F(P27, PriorityAndWhetherItIsShown) {
  for (const char* name : {"a", "b", "c"}) window.AddLayer(name).SetPixel(0, 0);
  window.GetLayer("a").SetColor(kRed);
  window.GetLayer("b").SetColor(kGreen);
  EXPECT_EQ(window.GetLayerNames(), (Lines{"a", "b", "c"}));
  Read();
  EXPECT_EQ(Shown(0, 0), (Color_t{0, 0, 0}));  // of equal priority, the last one
  window.GetLayer("b").SetPriority(2);
  Read();
  EXPECT_EQ(Shown(0, 0), kGreen);
  window.GetLayer("b").SetVisible(false);
  window.GetLayer("a").SetPriority(1);
  EXPECT_EQ(window.GetLayerNames(), (Lines{"c", "a", "b"}));
  window.GetLayer("b").SetPriority(0);  // between those that were made before and after it
  EXPECT_EQ(window.GetLayerNames(), (Lines{"b", "c", "a"}));
  Read();
  EXPECT_EQ(Shown(0, 0), kRed);
  window.GetLayer("c").SetPriority(-5);
  EXPECT_EQ(Read(), 0U);
}

TEST_F(P28, OccupancyIsWhiteGreyAndBlack) {
  GridMap& base = window.AddLayer("base");
  std::vector<double> cells(kCells, 0.5);
  cells[0] = 0.0;
  cells[1] = 1.0;
  cells[2] = std::nan("");
  cells[3] = 7.0;
  cells[4] = 0.25;
  base.SetOccupancy(cells);
  base.SetOccupancy(0, 1, 0.0);
  base.SetOccupancy(-1, 1, 0.0);  // outside
  Read();
  EXPECT_EQ(Shown(0, 0), LayerColor::kFree);
  EXPECT_EQ(Shown(1, 0), LayerColor::kObstacle);
  EXPECT_EQ(Shown(2, 0), LayerColor::kUnknown);
  EXPECT_EQ(Shown(3, 0), LayerColor::kObstacle);
  EXPECT_EQ(Shown(4, 0), (Color_t{191, 191, 191}));
  EXPECT_EQ(Shown(0, 1), LayerColor::kFree);
  EXPECT_EQ(Shown(kWidth - 1, kHeight - 1), LayerColor::kUnknown);
  EXPECT_THROW(base.SetOccupancy({0.5}), MorseError);
}

TEST_F(P28, ObstaclesAreInflatedByADistanceBetweenMiddles) {
  GridMap& base = window.AddLayer("base");
  base.SetOccupancy(5, 4, 1.0);
  base.SetOccupancy(6, 4, 1.0);
  base.SetOccupancy(0, 0, 0.9);  // not certain
  GridMap& inflated = window.AddLayer("inflated", LayerColor::kInflated, 1);
  for (const double radius : {0.0, 0.02, 0.03, 0.0447, 0.06}) {  // m; a cell has 0.02
    inflated.SetInflated(base, radius);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double away = 0.02 * std::min(std::hypot(x - 5, y - 4), std::hypot(x - 6, y - 4));
        const bool wanted = away > 0.0 && away <= radius + 1e-9;
        EXPECT_EQ(inflated.GetPixel(x, y).has_value(), wanted) << x << " " << y << " " << radius;
      }
    }
  }
  inflated.SetInflated(base, 1e300);
  Read();
  EXPECT_EQ(Shown(0, kHeight - 1), LayerColor::kInflated);
  EXPECT_EQ(Shown(5, 4), LayerColor::kObstacle);
  EXPECT_THROW(inflated.SetInflated(base, -1.0), MorseError);
  EXPECT_THROW(inflated.SetInflated(base, std::nan("")), MorseError);
}

TEST_F(P28, ATraceGrowsAndAPathIsReplaced) {
  GridMap& trace = window.AddLayer("trace", LayerColor::kTrace);
  const auto cells = [&](const GridMap& map) {
    std::vector<std::pair<int, int>> set;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (map.GetPixel(x, y)) set.emplace_back(x, y);
      }
    }
    return set;
  };
  using Cells = std::vector<std::pair<int, int>>;
  trace.AddToTrace(0.03, 0.01);
  trace.AddToTrace(0.03, std::nan(""));
  EXPECT_EQ(cells(trace), (Cells{{1, 0}}));
  trace.AddToTrace(0.07, 0.01);
  EXPECT_EQ(cells(trace), (Cells{{1, 0}, {2, 0}, {3, 0}}));
  trace.Clear();
  trace.AddToTrace(0.01, 0.17);
  EXPECT_EQ(cells(trace), (Cells{{0, 8}}));
  GridMap& path = window.AddLayer("path", LayerColor::kPath);
  path.SetPath({{0.01, 0.01}, {0.05, 0.05}, {0.05, 0.07}});
  EXPECT_EQ(cells(path), (Cells{{0, 0}, {1, 1}, {2, 2}, {2, 3}}));
  path.SetPath({{-0.03, 0.01}, {0.03, 0.01}});
  EXPECT_EQ(cells(path), (Cells{{0, 0}, {1, 0}}));
  path.SetPath({});
  EXPECT_TRUE(cells(path).empty());
}

TEST_F(P29, AnAreaHasTheCellsWhoseMiddlesLieWithin) {
  GridMap& map = window.AddLayer("area", kGreen);
  EXPECT_TRUE(rc::check("area against the crossing rule at each middle", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::uniform_real_distribution<double> place(-0.1, 0.35);
    std::vector<player_point_2d_t> corners(random() % 7);
    for (player_point_2d_t& corner : corners) corner = {place(random), place(random)};
    map.SetArea(corners);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        // By the winding of the angle, not by rows: odd windings are within.
        const double px = 0.02 * (x + 0.5);
        const double py = 0.02 * (y + 0.5);
        int crossings = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const player_point_2d_t a = corners[i];
          const player_point_2d_t b = corners[(i + 1) % corners.size()];
          if ((a.py <= py) == (b.py <= py)) continue;
          const double side = (b.px - a.px) * (py - a.py) - (b.py - a.py) * (px - a.px);
          if ((side > 0.0) == (b.py > a.py)) ++crossings;  // to the right of the point
        }
        RC_ASSERT(map.GetPixel(x, y).has_value() == (crossings % 2 == 1));
      }
    }
  }));
  map.SetArea({{std::nan(""), 0.0}, {INFINITY, 1.0}});
  EXPECT_EQ(map.GetPixel(0, 0), std::nullopt);
}

TEST_F(P29, TheScanIsAGreenArea) {
  // Beams of 0.052 m over 270 degrees, from (0.12, 0.09); the scanner sits 0.035 m before the
  // robot's middle.
  std::string ranges = "0.052";
  for (int i = 1; i < 682; ++i) ranges += ", 0.052";
  server.SetData("s1r.hokuyo", "\"range_list\": [" + ranges + "]");
  LaserProxy laser(&client, 0);
  GridMap& scan = window.AddLayer("scan", LayerColor::kScan);
  client.Read();
  ASSERT_EQ(laser.GetCount(), 682U);
  const double kTurn = 1.0;  // rad
  scan.SetScan({0.12 - 0.035 * std::cos(kTurn), 0.09 - 0.035 * std::sin(kTurn), kTurn}, laser);
  Read();
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double dx = 0.02 * (x + 0.5) - 0.12;
      const double dy = 0.02 * (y + 0.5) - 0.09;
      const double bearing = std::remainder(std::atan2(dy, dx) - kTurn, 2.0 * std::acos(-1.0));
      const bool wanted = std::hypot(dx, dy) <= 0.052 && std::abs(bearing) <= laser.GetMaxAngle();
      EXPECT_EQ(Shown(x, y), wanted ? LayerColor::kScan : kWhite) << x << " " << y;
    }
  }
  scan.SetArea({});
  Read();
  EXPECT_EQ(Shown(6, 4), kWhite);
}

// --- Composition against a reference

struct ReferenceLayer {
  std::string name;
  Color_t color;
  int priority = 0;
  double transparency = 0.0;
  bool visible = true;
  std::optional<Color_t> key;
  struct Cell {
    bool set = false;
    bool own = false;
    Color_t color;
  };
  std::vector<Cell> cells;
};

// What is to be seen in a cell, channel by channel, from the lowest layer upwards.
std::array<double, 3> Seen(const std::vector<ReferenceLayer>& layers, std::size_t cell) {
  std::vector<const ReferenceLayer*> order;
  for (const ReferenceLayer& layer : layers) order.push_back(&layer);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->priority < b->priority; });
  std::array<double, 3> seen{255.0, 255.0, 255.0};
  for (const ReferenceLayer* layer : order) {
    const ReferenceLayer::Cell& here = layer->cells[cell];
    const Color_t color = here.own ? layer->color : here.color;
    if (!here.set || !layer->visible || layer->key == color) continue;
    const double channels[] = {static_cast<double>(color.r), static_cast<double>(color.g),
                               static_cast<double>(color.b)};
    for (std::size_t i = 0; i < 3; ++i) {
      seen[i] = (1.0 - layer->transparency) * channels[i] + layer->transparency * seen[i];
    }
  }
  return seen;
}

TEST_F(P26, RandomLayersAreComposedAsTheReferenceDoes) {
  EXPECT_TRUE(rc::check("layers against a reference in double", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto in = [&](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    const auto color = [&] {  // few of them, so that they meet
      const auto byte = [&] { return static_cast<unsigned char>(in(0, 2) * 127); };
      return Color_t{byte(), byte(), byte()};
    };
    for (const std::string& name : window.GetLayerNames()) window.RemoveLayer(name);
    window.ResizeCanvas(kWidth, kHeight);
    canvas.clear();
    Hear();
    std::vector<ReferenceLayer> layers;
    int named = 0;
    for (int step = 0; step < 60; ++step) {
      if (layers.empty() || in(0, 9) == 0) {
        ReferenceLayer layer;
        layer.name = std::to_string(named++);
        layer.color = color();
        layer.priority = in(-2, 2);
        layer.transparency = in(0, 1) == 0 ? 0.0 : in(0, 100) / 100.0;
        layer.cells.resize(kCells);
        window.AddLayer(layer.name, layer.color, layer.priority, layer.transparency);
        layers.push_back(layer);
      }
      const auto which = static_cast<std::size_t>(in(0, static_cast<int>(layers.size()) - 1));
      ReferenceLayer& layer = layers[which];
      GridMap& map = window.GetLayer(layer.name);
      switch (in(0, 9)) {
        case 0:
          map.SetColor(layer.color = color());
          break;
        case 1:
          map.SetTransparency(layer.transparency = in(0, 4) / 4.0);
          break;
        case 2:
          map.SetVisible(layer.visible = in(0, 1) == 1);
          break;
        case 3:
          layer.key = in(0, 2) == 0 ? std::nullopt : std::optional(color());
          if (layer.key) {
            map.SetTransparentColor(*layer.key);
          } else {
            map.RemoveTransparentColor();
          }
          break;
        case 4:
          map.SetPriority(layer.priority = in(-2, 2));
          break;
        case 5:
          if (in(0, 3) == 0) {
            map.Clear();
            layer.cells.assign(layer.cells.size(), {});
          } else if (in(0, 3) == 0) {
            window.RemoveLayer(layer.name);
            layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(which));
          }
          break;
        default:
          for (int i = in(1, 60); i > 0; --i) {
            const int x = in(-1, kWidth);
            const int y = in(-1, kHeight);
            ReferenceLayer::Cell cell{in(0, 3) != 0, in(0, 1) == 0, color()};
            if (!cell.set) {
              map.ClearPixel(x, y);
            } else if (cell.own) {
              map.SetPixel(x, y);
            } else {
              map.SetPixel(x, y, cell.color.r, cell.color.g, cell.color.b);
            }
            if (x < 0 || x >= kWidth || y < 0 || y >= kHeight) continue;
            layer.cells[static_cast<std::size_t>(y * kWidth + x)] = cell;
          }
      }
      if (in(0, 2) != 0) continue;
      Read();
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const auto seen = Seen(layers, static_cast<std::size_t>(y * kWidth + x));
          const Color_t shown = Shown(x, y);
          const double channels[] = {static_cast<double>(shown.r), static_cast<double>(shown.g),
                                     static_cast<double>(shown.b)};
          for (std::size_t i = 0; i < 3; ++i) {
            // Rounded to the nearest; a half may go either way.
            RC_ASSERT(std::abs(channels[i] - seen[i]) <= 0.5 + 1e-9);
          }
        }
      }
      RC_ASSERT(Read() == 0U);
    }
  }));
}

TEST_F(P26, ManyThreadsDrawWhileAnotherReads) {
  GridMap& map = window.AddLayer("map");
  GridMap& other = window.AddLayer("other", kRed, 1);
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 300; ++i) {
        map.SetPixel((i + t) % kWidth, i % kHeight, i % 256, t, 7);
        if (t == 0) other.SetTransparency(i % 2 / 2.0);
        if (t == 1) other.SetLine(0, i % kHeight, kWidth, t);
        if (t == 2) other.SetPriority(i % 3 - 1);
      }
    });
  }
  for (int i = 0; i < 100; ++i) client.Read();
  for (std::thread& thread : threads) thread.join();
  Read();
  other.SetPriority(1);
  other.SetTransparency(0.0);
  Read();
  for (int x = 0; x < kWidth; ++x) EXPECT_EQ(Shown(x, 1), kRed);
}

}  // namespace
}  // namespace ccmorse::test
