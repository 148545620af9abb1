// One drawing by every way there is to the canvas, from programs to a simulator of its own.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/image.h"
#include "libCCMorse/CCMorse.h"
#include "libplayerc++/graphics.h"
#include "libplayerc++/playerclient.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

using CCMorse::MorseClient;
using CCMorse::MorsePen;

constexpr double kCell = 0.02;  // m

/// One step of the drawing; places are cells.
struct Step {
  enum class Kind { kPoints, kPolyline, kMultiline, kBox };
  Kind kind;
  std::vector<CCMorse::ImagePoint_t> at;  // of a box, two opposite corners
  CCMorse::Color_t color;
  CCMorse::Color_t fill;  // of a box
};

std::vector<Step> Drawing() {
  return {{Step::Kind::kBox, {{20, 30}, {60, 70}}, {255, 0, 0}, {0, 0, 255}},
          {Step::Kind::kPolyline, {{5, 5}, {160, 40}, {90, 180}, {-20, 100}}, {0, 255, 0}, {}},
          {Step::Kind::kMultiline, {{100, 10}, {100, 90}, {110, 10}, {171, 185}}, {9, 8, 7}, {}},
          {Step::Kind::kPoints, {{0, 0}, {171, 185}, {40, 50}, {300, 300}}, {1, 200, 3}, {}}};
}

// The lines of a step by their ends. The inside of a box is for the ways that have no boxes: row by
// row.
std::vector<std::pair<CCMorse::ImagePoint_t, CCMorse::ImagePoint_t>> LinesOf(const Step& step) {
  std::vector<CCMorse::ImagePoint_t> at = step.at;
  if (step.kind == Step::Kind::kBox) {
    const auto [a, b] = std::pair(at[0], at[1]);
    at = {a, {b.x, a.y}, b, {a.x, b.y}, a};
  }
  std::vector<std::pair<CCMorse::ImagePoint_t, CCMorse::ImagePoint_t>> lines;
  const std::size_t every = step.kind == Step::Kind::kMultiline ? 2 : 1;
  for (std::size_t i = 0; i + 1 < at.size(); i += every) lines.emplace_back(at[i], at[i + 1]);
  return lines;
}

// MORSE's own protocol, line by line.
void DrawByLines(int port) {
  LineClient raw(port);
  const auto ask = [&](const std::string& service, const std::vector<int>& numbers,
                       CCMorse::Color_t color) {
    std::string list;
    for (const int number : numbers) list += std::to_string(number) + ", ";
    for (const int channel : {int{color.r}, int{color.g}, int{color.b}}) {
      list += std::to_string(channel) + ", ";
    }
    list.resize(list.size() - 2);
    EXPECT_EQ(raw.Ask("1 s1r.pen " + service + " [" + list + "]"), "1 SUCCESS");
  };
  for (const Step& step : Drawing()) {
    if (step.kind == Step::Kind::kPoints) {
      for (const auto& point : step.at) ask("set_pixel", {point.x, point.y}, step.color);
      continue;
    }
    if (step.kind == Step::Kind::kBox) {
      for (int y = step.at[0].y; y <= step.at[1].y; ++y) {
        ask("set_line", {step.at[0].x, y, step.at[1].x, y}, step.fill);
      }
    }
    for (const auto& [a, b] : LinesOf(step)) ask("set_line", {a.x, a.y, b.x, b.y}, step.color);
  }
}

// libCCMorse, over either link.
void DrawByPen(const std::string& link, int port) {
  if (link == "json") ::setenv("CCMORSE_LINK", "json", 1);
  const auto client = MorseClient::Share("localhost", port);
  ::unsetenv("CCMORSE_LINK");
  ASSERT_EQ(client->GetLink(), link);
  auto& pen = client->GetRobot("s1r").GetDevice<MorsePen>();
  for (const Step& step : Drawing()) {
    const CCMorse::Color_t color = step.color;
    if (step.kind == Step::Kind::kPoints) {
      for (const auto& at : step.at) pen.SetPixel(at.x, at.y, color.r, color.g, color.b);
      continue;
    }
    if (step.kind == Step::Kind::kBox) {
      std::vector<CCMorse::PixelUpdate_t> cells;
      for (int y = step.at[0].y; y <= step.at[1].y; ++y) {
        for (int x = step.at[0].x; x <= step.at[1].x; ++x) cells.push_back({{x, y}, step.fill});
      }
      pen.UpdateImageData(cells);
    }
    for (const auto& [a, b] : LinesOf(step)) {
      pen.SetLine(a.x, a.y, b.x, b.y, color.r, color.g, color.b);
    }
  }
  client->Read();
}

// Player's Graphics2dProxy, in m.
void DrawByGraphics(const std::string& address, std::uint32_t index) {
  PlayerCc::PlayerClient client(address);
  PlayerCc::Graphics2dProxy graphics(&client, index);
  for (const Step& step : Drawing()) {
    std::vector<player_point_2d_t> points;
    for (const auto& at : step.at) points.push_back({(at.x + 0.5) * kCell, (at.y + 0.5) * kCell});
    graphics.Color(step.color.r, step.color.g, step.color.b, 255);
    const int count = static_cast<int>(points.size());
    switch (step.kind) {
      case Step::Kind::kPoints:
        graphics.DrawPoints(points.data(), count);
        break;
      case Step::Kind::kPolyline:
        graphics.DrawPolyline(points.data(), count);
        break;
      case Step::Kind::kMultiline:
        graphics.DrawMultiline(points.data(), count);
        break;
      case Step::Kind::kBox: {
        player_point_2d_t box[] = {
            points[0], {points[1].px, points[0].py}, points[1], {points[0].px, points[1].py}};
        graphics.DrawPolygon(box, 4, true, {255, step.fill.r, step.fill.g, step.fill.b});
        break;
      }
    }
  }
  client.RequestDeviceList();  // a Player server answers it after all that was drawn
}

TEST(P13, TheCopyIsTheSameByEveryWayToTheCanvas) {
  const std::map<std::string, std::function<void(Simulator&)>> ways{
      {"MORSE's lines", [](Simulator& simulator) { DrawByLines(simulator.port()); }},
      {"the fast link", [](Simulator& simulator) { DrawByPen("fast", simulator.port()); }},
      {"libCCMorse by JSON", [](Simulator& simulator) { DrawByPen("json", simulator.port()); }},
      {"Graphics2dProxy, player://",
       [](Simulator& simulator) {
         const int port = simulator.player_port();
         ASSERT_NE(port, 0) << simulator.process().output();
         DrawByGraphics("player://127.0.0.1:" + std::to_string(port), 1);  // 1: in the world
       }},
      {"Graphics2dProxy, morse://", [](Simulator& simulator) {
         DrawByGraphics("morse://127.0.0.1:" + std::to_string(simulator.port()), 0);
       }}};
  std::map<std::string, std::string> pictures;
  for (const auto& [way, draw] : ways) {
    SCOPED_TRACE(way);
    const TemporaryFolder folder;
    Simulator simulator({"syrotek", "--out", folder.path(), "--player-port", "0"});
    draw(simulator);
    LineClient raw(simulator.port());
    EXPECT_EQ(raw.Ask("1 s1r.pen save_image_copy [\"copy\"]"),
              "1 SUCCESS \"" + folder.path() + "/copy.png\"");
    pictures[way] = ReadFile(folder.path() + "/copy.png");
    const Image image = ReadPng(folder.path() + "/copy.png");
    ASSERT_EQ(image.width, 172);
    ASSERT_EQ(image.height, 186);
    const auto cell = [&](int x, int y) {
      return image.pixels[static_cast<std::size_t>(185 - y) * 172 + static_cast<std::size_t>(x)];
    };
    EXPECT_EQ(cell(21, 31), (Color{0, 0, 255}));
    EXPECT_EQ(cell(20, 30), (Color{255, 0, 0}));
    EXPECT_EQ(cell(100, 50), (Color{9, 8, 7}));
    EXPECT_EQ(cell(171, 185), (Color{1, 200, 3}));
  }
  ASSERT_EQ(pictures.size(), ways.size());
  for (const auto& [way, picture] : pictures) {
    EXPECT_TRUE(picture == pictures["MORSE's lines"]) << way;
  }
}

TEST(P26, LayersAreTheSameByEitherLink) {
  std::map<std::string, std::string> pictures;
  for (const std::string link : {"fast", "json"}) {
    const TemporaryFolder folder;
    Simulator simulator({"syrotek", "--out", folder.path(), "--pace", "lockstep"});
    if (link == "json") ::setenv("CCMORSE_LINK", "json", 1);
    CCMorse::PlayerClient client("localhost", simulator.port());
    ::unsetenv("CCMORSE_LINK");
    ASSERT_EQ(MorseClient::GetInstance().GetLink(), link);
    CCMorse::LaserProxy laser(&client, 0);
    CCMorse::Position2dProxy position(&client, 0);
    // Large enough for more than one message.
    auto& window = CCMorse::WindowProxy::GetInstance(&client, 300, 320);
    auto& base = window.AddLayer("base");
    auto& inflated = window.AddLayer("inflated", CCMorse::LayerColor::kInflated, 1, 0.5);
    auto& scan = window.AddLayer("scan", CCMorse::LayerColor::kScan, 2, 0.6);
    auto& trace = window.AddLayer("trace", CCMorse::LayerColor::kTrace, 3);
    std::vector<double> occupancy(std::size_t{300} * 320, 0.5);
    for (std::size_t i = 0; i < 50000; ++i) occupancy[i] = i % 331 == 0 ? 1.0 : 0.0;
    base.SetOccupancy(occupancy);
    for (int i = 0; i < 30; ++i) {
      client.Read();
      position.SetSpeed(0.2, 0.5);
      if (i == 10) inflated.SetInflated(base, 0.05);
      if (i == 20) inflated.SetTransparency(0.25);
      scan.SetScan({position.GetXPos(), position.GetYPos(), position.GetYaw()}, laser);
      trace.AddToTrace(position.GetXPos(), position.GetYPos());
    }
    window.SaveImageCopy("layers");
    pictures[link] = ReadFile(folder.path() + "/layers.png");
    const auto image = window.GetImageData();
    const auto at = [&](double x, double y) {
      return image[static_cast<std::size_t>(window.GetY(y)) * 300 +
                   static_cast<std::size_t>(window.GetX(x))];
    };
    EXPECT_EQ(at(position.GetXPos(), position.GetYPos()), CCMorse::LayerColor::kTrace);
    EXPECT_EQ(image.back(), CCMorse::LayerColor::kUnknown);
    delete &window;
  }
  EXPECT_TRUE(pictures["fast"] == pictures["json"]);
}

// Whoever looks switches layers; the program that draws follows, whichever link it has.
TEST(P26, LayersThatPeopleSwitchOffGoWithinASimulatedSecond) {
  for (const std::string link : {"fast", "json"}) {
    SCOPED_TRACE(link);
    Simulator simulator({"syrotek", "--pace", "lockstep"});
    if (link == "json") ::setenv("CCMORSE_LINK", "json", 1);
    CCMorse::PlayerClient client("localhost", simulator.port());
    ::unsetenv("CCMORSE_LINK");
    ASSERT_EQ(MorseClient::GetInstance().GetLink(), link);
    LineClient viewer(simulator.port());
    auto& window = CCMorse::WindowProxy::GetInstance(&client, 20, 20);
    auto& base = window.AddLayer("base");
    auto& scan = window.AddLayer("scan", CCMorse::LayerColor::kScan, 2);
    base.SetPixel(3, 3);
    scan.SetPixel(3, 3);
    client.Read();
    EXPECT_EQ(viewer.Ask("1 s1r.pen get_layers"),
              R"(1 SUCCESS [["base", 0, true, true], ["scan", 2, true, true]])");
    EXPECT_EQ(window.GetPixel(3, 3), CCMorse::LayerColor::kScan);

    EXPECT_EQ(viewer.Ask(R"(2 s1r.pen show_layer ["scan", false])"), "2 SUCCESS");
    const double switched = MorseClient::GetInstance().GetTime();
    while (scan.IsShown() && MorseClient::GetInstance().GetTime() < switched + 5.0) client.Read();
    EXPECT_LE(MorseClient::GetInstance().GetTime(), switched + 1.2);
    EXPECT_FALSE(scan.IsShown());
    EXPECT_TRUE(scan.IsVisible()) << "that is up to the program";
    EXPECT_TRUE(base.IsShown());
    EXPECT_EQ(window.GetPixel(3, 3), (CCMorse::Color_t{0, 0, 0})) << "what lies beneath";

    // A change of the list switches nothing on again.
    window.AddLayer("trace", CCMorse::LayerColor::kTrace, 3).SetVisible(false);
    base.SetPriority(1);
    window.RemoveLayer("trace");
    window.AddLayer("path", CCMorse::LayerColor::kPath, 4).SetVisible(false);
    client.Read();
    EXPECT_EQ(viewer.Ask("3 s1r.pen get_layers"),
              R"(3 SUCCESS [["base", 1, true, true], ["scan", 2, true, false], )"
              R"(["path", 4, false, true]])");
    EXPECT_EQ(viewer.Ask(R"(4 s1r.pen show_layer ["scan", true])"), "4 SUCCESS");
    for (int i = 0; i < 12; ++i) client.Read();
    EXPECT_EQ(window.GetPixel(3, 3), CCMorse::LayerColor::kScan);

    delete &window;
    client.Read();
    EXPECT_EQ(viewer.Ask("5 s1r.pen get_layers"), "5 SUCCESS") << "as MORSE says an empty list";
  }
}

// A line of the protocol has 1 MiB; a whole image of a large canvas has more.
TEST(P10, AWholeImageOfALargeCanvasGoesOverEitherLink) {
  constexpr int kWidth = 400;
  constexpr int kHeight = 301;
  for (const std::string link : {"fast", "json"}) {
    SCOPED_TRACE(link);
    Simulator simulator({"syrotek", "--pace", "lockstep"});
    if (link == "json") ::setenv("CCMORSE_LINK", "json", 1);
    const auto client = MorseClient::Share("localhost", simulator.port());
    ::unsetenv("CCMORSE_LINK");
    ASSERT_EQ(client->GetLink(), link);
    auto& pen = client->GetRobot("s1r").GetDevice<MorsePen>();
    pen.ResizeCanvas(kWidth, kHeight);
    std::vector<CCMorse::Color_t> image;
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const auto byte = [](int value) { return static_cast<unsigned char>(100 + value % 156); };
      image.push_back({byte(i), byte(i / 7), byte(i / 400)});
    }
    pen.SetImageData(image);
    client->Read();
    EXPECT_TRUE(pen.GetImageData() == image);
  }
}

// The example draws what figures 4.5 to 4.7 show: all of them at least once, and each where it
// belongs.
TEST(P28, TheExampleShowsScanInflatedMapPathAndTraceOnTheOccupancyGrid) {
  const TemporaryFolder folder;
  Simulator simulator({"syrotek", "--out", folder.path(), "--pace", "lockstep"});
  const Finished run = RunToEnd({BuiltProgram("layers"), std::to_string(simulator.port()), "34"});
  ASSERT_EQ(run.status, 0) << run.output;
  const Image image = ReadPng(folder.path() + "/layers.png");
  ASSERT_EQ(image.width, 172);
  ASSERT_EQ(image.height, 186);
  const auto count = [&](int r, int g, int b) {
    return std::count(image.pixels.begin(), image.pixels.end(),
                      Color{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                            static_cast<std::uint8_t>(b)});
  };
  EXPECT_GT(count(255, 255, 255), 1000);  // free
  EXPECT_GT(count(128, 128, 128), 1000);  // unknown
  EXPECT_GT(count(0, 0, 0), 100);         // obstacles
  EXPECT_GT(count(255, 0, 0), 100);       // trace
  EXPECT_GT(count(0, 0, 160), 10);        // way back
  EXPECT_GT(count(77, 77, 255), 100);     // inflated, over what is free
  EXPECT_GT(count(128, 255, 128), 1000);  // scan, over what is free (P29)
}

}  // namespace
}  // namespace ccmorse::testing
