// The fast link between libCCMorse and the simulator: as JSON, only faster.

#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>

#include <chrono>
#include <memory>
#include <optional>
#include <random>

#include "base/error.h"
#include "base/image.h"
#include "base/json.h"
#include "libCCMorse/CCMorse.h"
#include "tests/support/line_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

using namespace CCMorse;  // NOLINT(google-build-using-namespace): as the course's programs write it

/// Clients that connect while it is there use the link of that name.
class Link {
 public:
  explicit Link(const std::string& name) {
    if (name == "json") {
      ::setenv("CCMORSE_LINK", "json", 1);
    } else {
      ::unsetenv("CCMORSE_LINK");
    }
  }
  ~Link() { ::unsetenv("CCMORSE_LINK"); }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
};

constexpr const char* kLinks[] = {"fast", "json"};

struct Rig {
  Rig(const std::string& link, std::vector<std::string> arguments)
      : environment(link),
        simulator(std::move(arguments)),
        client(MorseClient::Share("localhost", simulator.port())) {
    EXPECT_EQ(client->GetLink(), link);
  }
  Link environment;
  Simulator simulator;
  std::shared_ptr<MorseClient> client;
};

// All that a program gets to see.
void Note(std::vector<double>& seen, const player_pose3d_t& pose) {
  seen.insert(seen.end(), {pose.px, pose.py, pose.pz, pose.proll, pose.ppitch, pose.pyaw});
}

std::vector<double> WhatAProgramSees(const std::string& link, std::string* hash) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  std::vector<double> seen;
  {
    Rig rig(link, {"course_map", "--pace", "lockstep", "--for", "60", "--report", report});
    PlayerClient client("localhost", rig.simulator.port());
    Position2dProxy position(&client, 0);
    LaserProxy laser(&client, 0);
    MorseRobot& robot = rig.client->GetRobot("s1r");
    int signals = 0;
    laser.ConnectReadSignal([&signals] { ++signals; });
    try {
      for (int i = 0;; ++i) {
        client.Read();
        seen.insert(
            seen.end(),
            {rig.client->GetTime(), laser.GetDataTime(), laser.GetElapsedTime(),
             1.0 * laser.IsFresh(), 1.0 * laser.IsValid(), 1.0 * position.IsFresh(), 1.0 * signals,
             position.GetXPos(), position.GetYPos(), position.GetYaw(), position.GetXSpeed(),
             position.GetYawSpeed(), 1.0 * position.GetStall(), laser.GetMinLeft()});
        laser.NotFresh();
        position.NotFresh();
        for (unsigned k = 0; k < laser.GetCount(); ++k) seen.push_back(laser[k]);
        Note(seen, robot.GetPose());
        if (i > 5) Note(seen, robot.GetDevice<MorseOdometry>().GetPose());  // late, but current
        if (i > 9) Note(seen, robot.GetDevice<MorseOdometry>().GetSpeed());
        position.SetSpeed(0.3, i % 50 < 25 ? 0.4 : -0.2);  // into the walls, in the end
      }
    } catch (const MorseError& error) {
      EXPECT_TRUE(error.SimulationEnded()) << error.GetErrorStr();
    }
    rig.client->Close();
    EXPECT_EQ(rig.simulator.process().Wait(), 0);
  }
  *hash = Json::Parse(ReadFile(report)).Find("hash")->AsString();
  return seen;
}

TEST(N05, AProgramSeesTheSameByEitherLinkToTheLastBit) {
  std::string fast_hash;
  std::string json_hash;
  const std::vector<double> fast = WhatAProgramSees("fast", &fast_hash);
  const std::vector<double> json = WhatAProgramSees("json", &json_hash);
  EXPECT_GT(fast.size(), 600U * 700U);
  EXPECT_TRUE(fast == json);
  EXPECT_EQ(fast_hash, json_hash);
}

TEST(N05, TheIntroductionProgramsRunHasItsHashByEitherLink) {
  for (const char* name : kLinks) {
    const Link link(name);
    const TemporaryFolder folder;
    const std::string report = folder.path() + "/report.json";
    Simulator simulator({"syrotek", "--pace", "lockstep", "--for", "120", "--report", report});
    const Finished intro =
        RunToEnd({BuiltProgram("intro"), "--port", std::to_string(simulator.port())});
    EXPECT_EQ(intro.status, 0) << intro.output;
    EXPECT_EQ(simulator.process().Wait(), 0);
    EXPECT_EQ(Json::Parse(ReadFile(report)).Find("hash")->AsString(), "4bbd574f260aed50") << name;
  }
}

TEST(N05, DataAsTextAreTheSimulatorsOwn) {
  Rig rig("fast", {"course_map", "--pace", "lockstep"});
  LineClient raw(rig.simulator.port());
  MorseRobot& robot = rig.client->GetRobot("s1r");
  for (int i = 0; i < 3; ++i) {
    rig.client->Read();
    for (const char* name : {"hokuyo", "pose", "odometry"}) {
      const std::string reply = raw.Ask(std::string("1 s1r.") + name + " get_local_data");
      EXPECT_EQ("1 SUCCESS " + robot.GetDevice(name).GetData().ToString(), reply) << name;
    }
  }
  EXPECT_EQ(robot.GetDevice<MorseLaser>().GetCount(), 682U);
}

TEST(N05, OnlyDevicesInUseAreSent) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  {
    Rig rig("fast", {"docks", "--pace", "lockstep", "--for", "5", "--report", report});
    ASSERT_EQ(rig.client->GetRobots().size(), 13U);
    MorseLaser& laser = rig.client->GetRobots()[4]->GetDevice<MorseLaser>();
    EXPECT_THROW(
        {
          for (;;) {
            rig.client->Read();
            EXPECT_EQ(laser.GetCount(), 682U);
          }
        },
        MorseError);
    rig.client->Close();
    EXPECT_EQ(rig.simulator.process().Wait(), 0);
  }
  const Json text = Json::Parse(ReadFile(report));
  int used_once = 0;
  int used_always = 0;
  for (const auto& [name, robot] : text.Find("robots")->AsObject()) {
    const std::int64_t used = robot.Find("scans_used")->AsInt();
    used_once += used == 1 ? 1 : 0;  // the first Read() brings all
    used_always += used == robot.Find("scans")->AsInt() ? 1 : 0;
  }
  EXPECT_EQ(used_once, 12);
  EXPECT_EQ(used_always, 1);
}

TEST(N05, PolledAndNotPolledCountOnTheFastLinkToo) {
  Rig rig("fast", {"course_map", "--pace", "lockstep"});
  auto& laser = rig.client->GetRobot("s1r").GetDevice<MorseLaser>();
  laser.SetPolled(false);
  rig.client->Read();
  EXPECT_FALSE(laser.HasData());
  laser.SetPolled(true);
  rig.client->Read();
  EXPECT_TRUE(laser.HasData());
  const double time = laser.GetTimestamp();
  laser.SetPolled(false);
  rig.client->Read();
  EXPECT_EQ(laser.GetTimestamp(), time);
}

TEST(N05, ARefusedCommandComesOutOfTheNextRead) {
  for (const char* link : kLinks) {
    Rig rig(link, {"course_map", "--pace", "lockstep"});
    rig.client->Read();
    rig.client->Request("s1r.pen", "resize_canvas", MorseArgs(4, 4));
    // The client still believes in the size it was told when it connected.
    auto& pen = rig.client->GetRobot("s1r").GetDevice<MorsePen>();
    pen.SetImageData(std::vector<Color_t>(static_cast<std::size_t>(pen.GetWidth()) *
                                          static_cast<std::size_t>(pen.GetHeight())));
    try {
      rig.client->Read();
      ADD_FAILURE() << "nothing was refused by " << link;
    } catch (const MorseError& error) {
      EXPECT_EQ(error.GetErrorCode(), MorseError::kRefused);
      EXPECT_NE(error.GetErrorStr().find("s1r.pen set_image_data: Socket service manager: wrong "
                                         "parameter type for service set_image_data. the canvas "
                                         "has 16 cells"),
                std::string::npos)
          << error.GetErrorStr();
    }
    rig.client->Read();
  }
}

// The same drawing, of every kind of call, over either link; the canvas after each part of it.
std::vector<std::vector<Color_t>> Drawn(const std::string& link, std::string* hash) {
  const TemporaryFolder folder;
  const std::string report = folder.path() + "/report.json";
  std::vector<std::vector<Color_t>> states;
  {
    Rig rig(link, {"two_robots", "--pace", "lockstep", "--for", "6", "--report", report});
    auto& pen = rig.client->GetRobots()[0]->GetDevice<MorsePen>();
    auto& other = rig.client->GetRobots()[1]->GetDevice<MorsePen>();
    LineClient raw(rig.simulator.port());
    std::mt19937 random(7);
    const auto in = [&random](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    const auto byte = [&] { return static_cast<unsigned char>(in(0, 255)); };
    int width = 40;
    int height = 30;
    pen.ResizeCanvas(width, height);
    other.RefreshSize();
    std::vector<Color_t> image;
    for (int part = 0; part < 50; ++part) {
      if (part % 20 == 19) {
        width = in(1, 60);
        height = in(1, 60);
        pen.ResizeCanvas(width, height);
        other.RefreshSize();
        image.clear();
      }
      image.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
      for (int i = in(1, 200); i > 0; --i) {
        const int x = in(-3, width + 3);
        const int y = in(-3, height + 3);
        const Color_t color{byte(), byte(), byte()};
        switch (in(0, 9)) {
          case 0:
            pen.SetLine(x, y, in(-9, width + 9), in(-9, height + 9), color.r, color.g, color.b);
            break;
          case 1:
            pen.SetPixel(x, y, color.r, color.g, color.b, 100);  // lets shine through
            break;
          case 2:
            other.SetPixel(x, y, color.r, color.g, color.b);
            break;
          case 3: {
            std::vector<PixelUpdate_t> pixels;
            for (int k = in(0, 80); k > 0; --k) {
              pixels.push_back({{in(0, 9) == 0 ? 2000000000 : x + k, y + k / 9},
                                k % 3 == 0 ? color : Color_t{byte(), byte(), byte()}});
            }
            pen.UpdateImageData(pixels);
            break;
          }
          case 4:
            if (in(0, 19) == 0) {
              for (Color_t& cell : image) {
                if (in(0, 2) == 0) cell = color;
              }
              (in(0, 1) == 0 ? pen : other).SetImageData(image);
            }
            break;
          default:  // rows, as programs draw maps
            for (int k = 0; k < 9; ++k) pen.SetPixel(x + k % 3, y + k / 3, k, k, k);
        }
      }
      if (part % 7 == 3) raw.Ask("1 " + pen.GetName() + " set_line [0, 0, 50, 50, 1, 2, 3]");
      rig.client->Read();
      states.push_back(pen.GetImageData());
    }
    EXPECT_THROW(
        {
          for (;;) rig.client->Read();
        },
        MorseError);
    rig.client->Close();
    EXPECT_EQ(rig.simulator.process().Wait(), 0);
  }
  *hash = Json::Parse(ReadFile(report)).Find("hash")->AsString();
  return states;
}

TEST(N05, TheCanvasIsTheSameByEitherLinkCellByCell) {
  std::string fast_hash;
  std::string json_hash;
  const auto fast = Drawn("fast", &fast_hash);
  const auto json = Drawn("json", &json_hash);
  ASSERT_EQ(fast.size(), json.size());
  for (std::size_t i = 0; i < fast.size(); ++i) {
    EXPECT_TRUE(fast[i] == json[i]) << "part " << i;
  }
  EXPECT_EQ(fast_hash, json_hash);  // it counts which cells were drawn on, too
}

TEST(N05, WhatWasDrawnLastIsNotLostWhenTheProgramEnds) {
  for (const char* link : kLinks) {
    Simulator simulator({"course_map", "--pace", "lockstep"});
    LineClient raw(simulator.port());
    {
      const Link environment(link);
      const auto client = MorseClient::Share("localhost", simulator.port());
      client->Read();
      client->GetRobot("s1r").GetDevice<MorsePen>().SetPixel(1, 2, 3, 4, 5);
      client->GetRobot("s1r").GetDevice<MorseMotionVW>().SetSpeed(0.25, 0.5);
    }
    EXPECT_EQ(raw.Ask("1 s1r.pen get_pixel [1, 2]"), "1 SUCCESS [3, 4, 5]") << link;
  }
}

TEST(Lockstep, ProgramsThatDieOrHangDoNotHoldTheOthersUp) {
  for (const char* name : kLinks) {
    const Link link(name);
    Simulator simulator({"two_robots", "--pace", "lockstep", "--clients", "3", "--for", "30",
                         "--client-timeout", "0.5"});
    const std::string port = std::to_string(simulator.port());
    Process dies({BuiltProgram("intro"), "--port", port});
    Process hangs(
        {BuiltProgram("intro"), "--port", port, "--laser-index", "10", "--position2d-index", "10"});
    PlayerClient client("localhost", simulator.port());
    LaserProxy laser(&client, 0);
    while (laser.GetDataTime() < 5.0) client.Read();
    hangs.Signal(SIGSTOP);
    while (laser.GetDataTime() < 10.0) client.Read();
    dies.Signal(SIGKILL);
    while (laser.GetDataTime() < 15.0) client.Read();
    hangs.Signal(SIGKILL);
    EXPECT_THROW(
        {
          for (;;) client.Read();
        },
        MorseError);
    EXPECT_EQ(simulator.process().Wait(), 0);
    const std::string& output = simulator.process().output();
    EXPECT_NE(output.find("\"libCCMorse\" \"intro\" has sent nothing for 0.5 s while others wait: "
                          "it is let go"),
              std::string::npos)
        << output;
    EXPECT_EQ(output.find("it is let go"), output.rfind("it is let go")) << output;
  }
}

TEST(Lockstep, AProgramThatWasLetGoIsToldSo) {
  Simulator simulator(
      {"two_robots", "--pace", "lockstep", "--clients", "2", "--client-timeout", "0.2"});
  PlayerClient client("localhost", simulator.port());
  client.Read();
  LineClient other(simulator.port());
  other.Ask("1 ccmorse read");
  other.Ask("2 ccmorse read");
  other.Send("3 ccmorse read\n4 ccmorse read\n");
  EXPECT_TRUE(other.ReadLine());
  EXPECT_TRUE(other.ReadLine());
  EXPECT_THROW(client.Read(), MorseError);
}

// How fast it is, is no test's business; that each figure is there, is.
void ExpectFigures(const std::string& benchmark, const std::vector<const char*>& names) {
  const Finished table =
      RunToEnd({BuiltProgram("ccmorse"), "bench", benchmark, "--seconds", "0.05"});
  EXPECT_EQ(table.status, 0) << table.output;
  const Finished json =
      RunToEnd({BuiltProgram("ccmorse"), "bench", benchmark, "--seconds", "0.05", "--json"});
  ASSERT_EQ(json.status, 0) << json.output;
  const Json figures = Json::Parse(json.output.substr(0, json.output.find('\n')));
  for (const char* name : names) {
    ASSERT_NE(figures.Find(name), nullptr) << name;
    EXPECT_GT(figures.Find(name)->AsDouble(), 0.0) << name;
  }
}

TEST(CommandLine, TheLinkBenchmarkPrintsItsFigures) {
  ExpectFigures("link",
                {"lockstep_sim_s_per_wall_s", "lockstep_json_sim_s_per_wall_s", "read_p50_us",
                 "read_p99_us", "canvas_update_us", "canvas_json_update_us", "canvas_ratio"});
}

TEST(CommandLine, ThePlayerBenchmarkPrintsItsFigures) {
  ExpectFigures("player", {"lockstep_sim_s_per_wall_s", "read_from_due_p50_us",
                           "read_from_due_p99_us", "fleet_rounds"});
}

}  // namespace
}  // namespace ccmorse::testing
