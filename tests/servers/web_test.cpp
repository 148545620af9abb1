#include <gtest/gtest.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/json.h"
#include "scene/scenario.h"
#include "servers/web/web_server.h"
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

class ViewClient {
 public:
  // Throws where the server refuses.
  explicit ViewClient(int port, const std::string& origin = "", const std::string& target = "/view")
      : socket_(io_) {
    beast::get_lowest_layer(socket_).connect(
        tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)));
    socket_.set_option(
        websocket::stream_base::decorator([origin](websocket::request_type& request) {
          if (!origin.empty()) request.set(http::field::origin, origin);
        }));
    socket_.handshake("localhost:" + std::to_string(port), target);
  }

  // The next message; binary ones are confirmed.
  std::string Next() {
    beast::flat_buffer buffer;
    socket_.read(buffer);
    binary_ = socket_.got_binary();
    if (binary_) Send("k");
    return beast::buffers_to_string(buffer.data());
  }
  std::string NextText() {
    for (;;) {
      std::string text = Next();
      if (!binary_) return text;
    }
  }
  std::string NextFrame() {
    for (;;) {
      std::string frame = Next();
      if (binary_) return frame;
    }
  }
  void Send(const std::string& text) {
    socket_.text(true);
    socket_.write(asio::buffer(text));
  }
  Json Call(const std::string& call) {
    Send(R"({"id": 7, "call": )" + call + "}");
    return Json::Parse(NextText());
  }

 private:
  asio::io_context io_;
  websocket::stream<beast::tcp_stream> socket_;
  bool binary_ = false;
};

float SingleAt(const std::string& frame, std::size_t at) {
  float value = 0;
  std::memcpy(&value, frame.data() + at, sizeof value);
  return value;
}

constexpr std::size_t kFirstRobot = 24;  // after kind, flags, time, rate and the count of robots

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
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 24), 0.5F);  // b
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 28), 2.5F);
  EXPECT_FLOAT_EQ(SingleAt(first, kFirstRobot + 32), 1.0F);
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
    if (SingleAt(frame, kFirstRobot + 24) == 0.6F) break;
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
  EXPECT_FALSE(client.Call(R"(["b.motion", "set_speed", [0.1, 0]])").Find("ok")->AsBool());
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

}  // namespace
}  // namespace ccmorse::servers
