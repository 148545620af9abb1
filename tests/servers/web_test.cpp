#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/json.h"
#include "scene/scenario.h"
#include "servers/web/view_model.h"
#include "servers/web/web_server.h"
#include "tests/servers/view_client.h"
#include "tests/support/process.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;

// A simulation with a web server, ticked as fast as possible by a thread of its own.
class ServedView {
 public:
  explicit ServedView(WebServerOptions options = {}) {
    folder_ = std::make_unique<testing::TemporaryFolder>();
    std::ofstream(folder_->path() + "/index.html") << "<p>page";
    std::ofstream(folder_->path() + "/secret.key") << "secret";
    options.port = 0;
    options.folder = folder_->path();
    server_ = std::make_unique<WebServer>(io_, simulation_, directory_, options);
    port_ = server_->port();
    address_ = server_->address();
    thread_ = std::thread([this] {
      while (!stop_) {
        simulation_.Sense();
        io_.restart();
        for (int i = 0; i < 64 && io_.poll_one() > 0; ++i) {
        }
        simulation_.Act();
        server_->Acted();
        std::this_thread::yield();
      }
      server_->Close();
      io_.restart();
      io_.poll();
    });
  }
  ~ServedView() {
    stop_ = true;
    thread_.join();
  }
  int port() const { return port_; }
  const std::string& address() const { return address_; }

 private:
  asio::io_context io_;
  sim::Simulation simulation_{scene::ParseScenario(
      R"({"robots": [{"name": "b", "pose": {"x": 0.5, "y": 2.5, "yaw": 1}}, {"name": "a"}]})",
      "test.json")};
  ServiceDirectory directory_{simulation_, {}};
  std::unique_ptr<testing::TemporaryFolder> folder_;
  std::unique_ptr<WebServer> server_;
  int port_ = 0;
  std::string address_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

struct Answer {
  int status;
  std::string type;
  std::string body;
};

Answer Get(int port, const std::string& target, const std::string& host = "localhost",
           http::verb verb = http::verb::get) {
  asio::io_context io;
  beast::tcp_stream stream(io);
  stream.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)});
  http::request<http::empty_body> request(verb, target, 11);
  request.set(http::field::host, host + ":" + std::to_string(port));
  http::write(stream, request);
  beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(stream, buffer, response);
  const auto type = response[http::field::content_type];
  return {static_cast<int>(response.result_int()), {type.data(), type.size()}, response.body()};
}

float SingleAt(const std::string& frame, std::size_t at) {
  float value = 0;
  std::memcpy(&value, frame.data() + at, sizeof value);
  return value;
}

constexpr std::size_t kFirstRobot = 32;  // after kind, flags, time, speed, rate and a count

TEST(WebServer, ServesThePageAndNothingElseOfTheDisk) {
  const ServedView view;
  const Answer page = Get(view.port(), "/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.type, "text/html; charset=utf-8");
  EXPECT_EQ(page.body, "<p>page");
  EXPECT_EQ(Get(view.port(), "/index.html").status, 200);
  for (const char* wrong : {"/secret.key", "/no.html", "/../index.html", "//etc/passwd",
                            "/%2e%2e/x.html", "/a/b.html", "/.html/"}) {
    EXPECT_EQ(Get(view.port(), wrong).status, 404) << wrong;
  }
  EXPECT_EQ(Get(view.port(), "/", "localhost", http::verb::delete_).status, 405);
}

TEST(WebServer, RefusesOtherSitesAndNamesThatPointHere) {
  const ServedView view;
  EXPECT_EQ(Get(view.port(), "/", "evil.example").status, 403);
  EXPECT_THROW(ViewClient(view.port(), "http://evil.example"), std::exception);
  EXPECT_NO_THROW(ViewClient(view.port(), "http://localhost:" + std::to_string(view.port())));
}

TEST(WebServer, TellsTheSceneThenFramesThatGoOn) {
  const ServedView view;
  ViewClient client(view.port());
  const Json scene = Json::Parse(client.NextText());
  ASSERT_EQ(scene.Find("robots")->AsArray().size(), 2U);
  EXPECT_EQ(scene.Find("robots")->AsArray()[1].Find("name")->AsString(), "b");
  EXPECT_EQ(scene.Find("boxes")->AsArray().size(), 90U);
  EXPECT_EQ(scene.Find("lasers")->AsArray()[0].Find("samples")->AsInt(), 682);
  const std::string first = client.NextFrame();
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot), 1.2F);       // a
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 36), 0.5F);  // b
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 40), 2.5F);
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 44), 1.0F);
  double before = 0.0;
  double after = 0.0;
  std::memcpy(&before, first.data() + 8, sizeof before);
  const std::string second = client.NextFrame();
  std::memcpy(&after, second.data() + 8, sizeof after);
  EXPECT_GT(after, before);
}

TEST(WebServer, CallsOfViewersAreServices) {
  const ServedView view;
  ViewClient client(view.port());
  client.NextText();
  const Json good = client.Call(R"(["simulation", "set_object_position", ["b", [0.6, 2.4, 0]]])");
  EXPECT_TRUE(good.Find("ok")->AsBool()) << good.Dump();
  EXPECT_EQ(good.Find("id")->AsInt(), 7);
  for (;;) {  // soon seen
    const std::string frame = client.NextFrame();
    if (SingleAt(frame, kFirstRobot + 36) == 0.6F) break;
  }
  for (const char* wrong : {R"(["b", "no_such", []])", R"([1, 2, 3])", R"("x")"}) {
    EXPECT_FALSE(client.Call(wrong).Find("ok")->AsBool()) << wrong;
  }
  client.Send("{ not JSON");
  EXPECT_FALSE(Json::Parse(client.NextText()).Find("ok")->AsBool());
}

TEST(WebServer, AReadOnlyViewOnlyLooks) {
  WebServerOptions options;
  options.read_only = true;
  const ServedView view(options);
  ViewClient client(view.port());
  client.NextText();
  const auto allowed = [&](const char* call) { return client.Call(call).Find("ok")->AsBool(); };
  for (const char* change :
       {R"(["b.motion", "set_speed", [0.1, 0]])", R"(["ccmorse", "pause", []])",
        R"(["ccmorse", "set_speed", ["max"]])", R"(["simulation", "reset_objects", []])",
        R"(["simulation", "quit", []])", R"(["simulation", "set_log_level", ["x", "ERROR"]])",
        R"(["time", "set_time_scale", [2]])", R"(["b.pen", "save_png", ["x.png"]])"}) {
    EXPECT_FALSE(allowed(change)) << change;
  }
  EXPECT_TRUE(allowed(R"(["b.pose", "get_local_data", []])"));
  EXPECT_TRUE(allowed(R"(["ccmorse", "log", []])"));
  EXPECT_TRUE(allowed(R"(["ccmorse", "time", []])"));
}

TEST(WebServer, AReadOnlyViewIsToldSo) {
  WebServerOptions options;
  options.read_only = true;
  const ServedView view(options);
  ViewClient client(view.port());
  const Json scene = Json::Parse(client.NextText());
  EXPECT_TRUE(scene.Find("read_only")->AsBool());
  EXPECT_TRUE(scene.Find("record")->IsNull());
}

// The requirement: 13 S1Rs with a scan each in less than 40 KB.
TEST(WebServer, AFrameOfThirteenRobotsWithTheirScansIsSmall) {
  sim::Simulation simulation(scene::LoadScenario(scene::FindScenario("docks")));
  ASSERT_EQ(simulation.robots().size(), 13U);
  simulation.Sense();
  ViewModel model(simulation);
  ViewModel::Seen seen;
  model.Frame(seen, 1.0, {});  // the first has the canvas, too
  for (int tick = 0; tick < 6; ++tick) {
    simulation.Act();
    simulation.Sense();
  }
  const std::string frame = model.Frame(seen, 1.0, {});
  EXPECT_GT(frame.size(), 13U * 682U * 2U) << "every scan is new";
  EXPECT_LT(frame.size(), 40'000U);
}

std::uint32_t WordAt(const std::string& frame, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, frame.data() + at, sizeof value);
  return value;
}

// docs/protocols/view.md: what a frame says of boxes and of the canvas's layers.
TEST(WebServer, AFrameTellsWhichBoxesStandWaitAndHaveMoved) {
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  ViewModel model(simulation);
  const std::string scene = model.Scene(Json(Json::Object{}));
  const auto& boxes = simulation.world().scene().boxes;
  const auto place_of = [&](int id) {
    return static_cast<std::size_t>(
        std::find_if(boxes.begin(), boxes.end(), [&](const auto& box) { return box.id == id; }) -
        boxes.begin());
  };
  const std::size_t flags_at = kFirstRobot + 36 * simulation.robots().size() + 4;
  const std::size_t moved_at = flags_at + (boxes.size() + 3) / 4 * 4;
  const auto frame = [&] {
    ViewModel::Seen seen;
    return model.Frame(seen, 1.0, {});
  };
  std::string at_start = frame();
  EXPECT_EQ(WordAt(at_start, flags_at - 4), boxes.size());
  EXPECT_EQ(at_start[flags_at + place_of(69)], 0);
  EXPECT_EQ(WordAt(at_start, moved_at), 0U);
  EXPECT_EQ(WordAt(at_start, moved_at + 4), 0U) << "no event so far";

  scene::ObstacleAction up;
  up.up = {69};
  simulation.arena().Apply(up, 0.0, "service");
  const Pose2 robot = simulation.robots()[0]->pose();
  simulation.arena().Move(70, robot, 0.0);  // it is down
  up.up = {70};
  simulation.arena().Apply(up, 0.0, "service");
  const std::string later = frame();
  EXPECT_EQ(later[flags_at + place_of(69)], 1);
  EXPECT_EQ(later[flags_at + place_of(70)], 2) << "a robot stands there";
  ASSERT_EQ(WordAt(later, moved_at), 1U);
  EXPECT_EQ(WordAt(later, moved_at + 4), place_of(70));
  EXPECT_EQ(SingleAt(later, moved_at + 8), static_cast<float>(robot.x));
  EXPECT_EQ(SingleAt(later, moved_at + 12), static_cast<float>(robot.y));
  EXPECT_EQ(SingleAt(later, moved_at + 16), static_cast<float>(robot.yaw));
  EXPECT_EQ(WordAt(later, moved_at + 20), 3U) << "events";
  EXPECT_EQ(later.size(), at_start.size() + 16);
  // Who comes later gets the same scene, and so the same poses.
  EXPECT_EQ(model.Scene(Json(Json::Object{})), scene);
}

TEST(WebServer, AFrameTellsWhenTheListOfLayersChanges) {
  sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  ViewModel model(simulation);
  ViewModel::Seen seen;
  model.Frame(seen, 1.0, {});
  // Without new rows a frame ends with the canvas's size, the list's number and no rows.
  const auto number = [&] {
    const std::string frame = model.Frame(seen, 1.0, {});
    EXPECT_EQ(WordAt(frame, frame.size() - 16), 172U);
    return WordAt(frame, frame.size() - 8);
  };
  EXPECT_EQ(number(), 0U);
  simulation.canvas().SetLayers({{"base"}, {"scan", 1}});
  EXPECT_EQ(number(), 1U);
  EXPECT_TRUE(simulation.canvas().ShowLayer("scan", false));
  EXPECT_EQ(number(), 2U);
}

TEST(WebServer, ViewersThatHaveSeenTheSameAreToldTheSame) {
  const ServedView view;
  ViewClient one(view.port());
  ViewClient two(view.port());
  std::map<double, std::string> seen;  // frames by time
  const auto time_of = [](const std::string& frame) {
    double time = 0.0;
    std::memcpy(&time, frame.data() + 8, sizeof time);
    return time;
  };
  int same = 0;
  for (int i = 0; i < 60; ++i) {
    for (ViewClient* viewer : {&one, &two}) {
      const std::string frame = viewer->NextFrame();
      const auto [found, is_new] = seen.emplace(time_of(frame), frame);
      if (is_new) continue;
      ++same;
      EXPECT_EQ(frame.substr(kFirstRobot, 72), found->second.substr(kFirstRobot, 72));
    }
  }
  EXPECT_GT(same, 5);
}

TEST(WebServer, ATokenOpensThePageAndTheSocket) {
  WebServerOptions options;
  options.token = "abc";
  const ServedView view(options);
  EXPECT_TRUE(view.address().ends_with("/?token=abc"));
  EXPECT_EQ(Get(view.port(), "/").status, 401);
  EXPECT_EQ(Get(view.port(), "/?token=abcd").status, 401);
  EXPECT_EQ(Get(view.port(), "/?token=abc").status, 200);
  EXPECT_THROW(ViewClient(view.port()), std::exception);
  EXPECT_NO_THROW(ViewClient(view.port(), "", "/view?token=abc"));
}

TEST(WebServer, OtherAddressesNeedAToken) {
  asio::io_context io;
  const sim::Simulation simulation(scene::ParseScenario("{}", "test.json"));
  sim::Simulation other(scene::ParseScenario("{}", "test.json"));
  ServiceDirectory directory(other, {});
  WebServerOptions options;
  options.port = 0;
  options.bind = "0.0.0.0";
  EXPECT_THROW(WebServer(io, simulation, directory, options), Error);
}

TEST(WebServer, AViewerThatDoesNotConfirmGetsNoMoreFrames) {
  const ServedView view;
  asio::io_context io;
  websocket::stream<beast::tcp_stream> socket(io);
  beast::get_lowest_layer(socket).connect(
      tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(view.port())));
  socket.handshake("localhost:" + std::to_string(view.port()), "/view");
  beast::flat_buffer buffer;
  for (int i = 0; i < 3; ++i) {  // the scene and two frames
    buffer.clear();
    socket.read(buffer);
  }
  // Another viewer sees half a second of frames go by meanwhile.
  ViewClient client(view.port());
  for (int i = 0; i < 20; ++i) client.NextFrame();
  EXPECT_EQ(beast::get_lowest_layer(socket).socket().available(), 0U);
}

// The requirement: 20 viewers slow the tick by less than 5 %. At full speed, where the loop leaves
// no time unused. Counted in processor time that the loop's thread spends on the server a round of
// frames, 60 of which go out in a second: so other programs that take the processor do not count,
// nor what the viewers on the core beside it take from the simulation.
TEST(WebServer, TwentyViewersSlowTheTickByLessThanFivePercent) {
  if (std::string(CCMORSE_SANITIZE) != "")
    GTEST_SKIP() << "sanitizers slow one down, not the other";
  sim::Simulation simulation(scene::LoadScenario(scene::FindScenario("docks")), 1);
  ServiceDirectory directory(simulation, {});
  asio::io_context io;
  WebServerOptions options;
  options.port = 0;
  WebServer server(io, simulation, directory, options);
  struct Cost {
    double cpu = 0.0;  // s
    double ticks = 0.0;
  };
  const auto tick_for = [&](std::chrono::milliseconds time, Cost& cost) {
    const auto cpu = [] {
      timespec now{};
      ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
      return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    };
    const auto until = std::chrono::steady_clock::now() + time;
    for (; std::chrono::steady_clock::now() < until; ++cost.ticks) {
      simulation.Sense();
      const double begin = cpu();
      io.restart();
      for (int i = 0; i < 64 && io.poll_one() > 0; ++i) {
      }
      cost.cpu += cpu() - begin;
      simulation.Act();
      const double acted = cpu();
      server.Acted();
      cost.cpu += cpu() - acted;
    }
  };
  constexpr std::chrono::milliseconds kTurn(300);
  Cost uncounted;
  std::vector<double> costs;  // s a round of frames, by turn
  std::atomic<int> frames = 0;
  for (int turn = 0; turn < 9; ++turn) {  // in turns, as the machine is not always as fast
    Cost alone;
    Cost watched;
    tick_for(kTurn, alone);
    std::atomic<bool> leave = false;
    std::atomic<int> there = 0;
    std::thread viewers([&] {
      std::vector<std::unique_ptr<ViewClient>> all;
      for (int i = 0; i < 20; ++i) {
        all.push_back(std::make_unique<ViewClient>(server.port()));
        ++there;
      }
      while (!leave) {
        for (const auto& viewer : all) viewer->NextFrame();
        ++frames;
      }
    });
    while (there < 20 || frames == 0) tick_for(std::chrono::milliseconds(5), uncounted);
    const int before = frames;
    tick_for(kTurn, watched);
    const int rounds = frames - before;
    leave = true;
    std::atomic<bool> left = false;
    std::thread joiner([&] {
      viewers.join();
      left = true;
    });
    while (!left) tick_for(std::chrono::milliseconds(5), uncounted);
    joiner.join();
    ASSERT_GT(rounds, 10) << "they do watch";
    const double of_ticks = watched.ticks * alone.cpu / alone.ticks;
    costs.push_back((watched.cpu - of_ticks) / rounds);
  }
  std::sort(costs.begin(), costs.end());
  const double round = costs[costs.size() / 4];  // the lower quartile: others take their share, too
  const double share = 60.0 * round;
  const double slower = share / (1.0 - share);
  std::printf("a frame for 20 viewers takes %.0f us; 60 a second slow the tick by %.1f %%\n",
              1e6 * round, 100.0 * slower);
  EXPECT_LT(slower, 0.05);
}

}  // namespace
}  // namespace ccmorse::servers
