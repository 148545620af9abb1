// A record in the live view: `ccmorse replay FILE`.

#include "servers/record/replay_server.h"

#include <gtest/gtest.h>

#include <boost/asio/post.hpp>
#include <cstring>
#include <filesystem>
#include <thread>

#include "tests/servers/served_simulation.h"
#include "tests/servers/view_client.h"
#include "tests/support/line_client.h"

namespace ccmorse::servers {
namespace {

// A lock-step run of two seconds in which a robot drives a curve and draws.
std::string MakeRecord(const std::string& folder) {
  const std::string kept = folder + "/kept.mcap";
  ServedSimulation served(R"({"robots": [{"pose": {"x": 1.2, "y": 2.0}}]})", Pace::kLockstep, 2.0);
  {
    testing::LineClient client(served.port());
    for (int i = 0; i < 21; ++i) {
      client.Send("1 s1r.motion set_speed [0.2, 0.4]\n2 s1r.pen set_pixel [" + std::to_string(i) +
                  ", 3, 255, 0, 0]\n3 ccmorse read\n");
      for (int k = 0; k < 3; ++k) client.ReadLine();
    }
  }
  served.Join();
  std::filesystem::copy_file(served.record(), kept);
  return kept;
}

class ShownReplay {
 public:
  explicit ShownReplay(double speed = 1.0, std::optional<double> to = {}, double from = 0.0)
      : file_(MakeRecord(folder_.path())),
        server_(file_, Options(speed, to, from)),
        thread_([this] { server_.Run(); }),
        view_(server_.web().port()) {
    scene_ = Json::Parse(view_.NextText());
  }
  ~ShownReplay() {
    boost::asio::post(server_.io(), [this] { server_.Stop(); });
    thread_.join();
  }
  const Json& scene() const { return scene_; }
  ViewClient& view() { return view_; }
  const std::string& file() const { return file_; }

  bool Ask(const std::string& call) { return view_.Call(call).Find("ok")->AsBool(); }
  struct Shown {
    bool paused;
    double time;
    float x;
    float y;
  };
  Shown Next() {
    const std::string frame = view_.NextFrame();
    Shown shown{};
    std::uint32_t flags = 0;
    std::memcpy(&flags, frame.data() + 4, sizeof flags);
    shown.paused = flags == 1;
    std::memcpy(&shown.time, frame.data() + 8, sizeof shown.time);
    std::memcpy(&shown.x, frame.data() + 32, sizeof shown.x);
    std::memcpy(&shown.y, frame.data() + 36, sizeof shown.y);
    return shown;
  }
  // The next frame of about that time.
  Shown WaitFor(double time) {
    for (;;) {
      const Shown shown = Next();
      if (std::abs(shown.time - time) < 1e-6) return shown;
    }
  }

 private:
  static ReplayServerOptions Options(double speed, std::optional<double> to, double from) {
    ReplayServerOptions options;
    options.speed = speed;
    options.to = to;
    options.from = from;
    options.web.port = 0;
    return options;
  }

  testing::TemporaryFolder folder_;
  std::string file_;
  ReplayServer server_;
  std::thread thread_;
  ViewClient view_;
  Json scene_;
};

TEST(ReplayServer, SaysThatItIsARecordAndHowLong) {
  ShownReplay shown;
  EXPECT_EQ(shown.scene().Find("record")->Find("file")->AsString(), shown.file());
  EXPECT_NEAR(shown.scene().Find("record")->Find("seconds")->AsDouble(), 2.0, 1e-9);
}

TEST(ReplayServer, PlaysToTheEndAndStopsThereAndBeginsAgain) {
  ShownReplay shown(std::numeric_limits<double>::infinity());
  while (!shown.Next().paused) {
  }
  const auto end = shown.Next();
  EXPECT_TRUE(end.paused);
  EXPECT_NEAR(end.time, 2.0, 1e-9);
  Replay replay(shown.file());
  replay.Seek(2.0);
  EXPECT_FLOAT_EQ(end.x, static_cast<float>(replay.simulation().robots()[0]->pose().x));
  EXPECT_TRUE(shown.Ask(R"(["ccmorse", "set_speed", [0.1]])"));
  EXPECT_TRUE(shown.Ask(R"(["ccmorse", "resume", []])"));
  double least = 2.0;
  while (least > 0.5) least = std::min(least, shown.Next().time);
}

TEST(ReplayServer, JumpsAnywhereAndShowsExactlyWhatWasThen) {
  ShownReplay shown;
  ASSERT_TRUE(shown.Ask(R"(["ccmorse", "pause", []])"));
  Replay replay(shown.file());
  for (const double time : {1.5, 0.25, 2.0, 0.0, 1.0}) {
    ASSERT_TRUE(shown.Ask(R"(["ccmorse", "seek", [)" + std::to_string(time) + "]]"));
    const auto at = shown.WaitFor(time);
    replay.Seek(time);
    EXPECT_FLOAT_EQ(at.x, static_cast<float>(replay.simulation().robots()[0]->pose().x)) << time;
    EXPECT_FLOAT_EQ(at.y, static_cast<float>(replay.simulation().robots()[0]->pose().y)) << time;
    EXPECT_TRUE(at.paused) << "a jump does not start it";
  }
}

TEST(ReplayServer, StepsAndStopsWhereItIsTold) {
  ShownReplay shown(1.0, 1.0, 0.9);  // from 0.9 to 1.0 s
  shown.WaitFor(1.0);
  while (!shown.Next().paused) {
  }
  ASSERT_TRUE(shown.Ask(R"(["ccmorse", "step", [3]])"));
  shown.WaitFor(1.05);
  ASSERT_TRUE(shown.Ask(R"(["ccmorse", "step", [1000000]])"));  // to the end, and answered
  shown.WaitFor(2.0);
  ASSERT_TRUE(shown.Ask(R"(["ccmorse", "step", []])"));
}

TEST(ReplayServer, NothingChangesARecord) {
  ShownReplay shown;
  for (const char* change :
       {R"(["s1r.motion", "set_speed", [0.1, 0]])", R"(["simulation", "reset_objects", []])",
        R"(["simulation", "set_object_position", ["s1r", [1, 1, 0]]])",
        R"(["simulation", "quit", []])", R"(["s1r.pen", "set_pixel", [1, 1, 0, 0, 0]])"}) {
    EXPECT_FALSE(shown.Ask(change)) << change;
  }
  EXPECT_TRUE(shown.Ask(R"(["s1r.pose", "get_local_data", []])"));
}

TEST(ReplayServer, AFileThatIsNoRecordIsRefused) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() + "/no.mcap") << "no";
  EXPECT_THROW(ReplayServer(folder.path() + "/no.mcap", {}), RecordError);
}

}  // namespace
}  // namespace ccmorse::servers
