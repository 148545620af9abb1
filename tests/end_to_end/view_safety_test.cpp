// Who may see the live view, and what a viewer may cost: a simulator in a process of its own, so
// that its memory is its own.

#include <gtest/gtest.h>
#include <signal.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "base/json.h"
#include "tests/servers/view_client.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using servers::ViewClient;

class ServedRun {
 public:
  explicit ServedRun(const std::vector<std::string>& more = {}) : process_(Command(more)) {
    const auto line = process_.WaitForLine("View at ");
    if (!line) throw std::runtime_error("no view: " + process_.output());
    port_ = std::stoi(line->substr(line->rfind(':') + 1));
  }
  ~ServedRun() {
    process_.Signal(SIGINT);
    process_.Wait();
  }
  ServedRun(const ServedRun&) = delete;
  ServedRun& operator=(const ServedRun&) = delete;

  int port() const { return port_; }
  std::string host() const { return "localhost:" + std::to_string(port_); }

  long ResidentKilobytes() const {
    std::ifstream status("/proc/" + std::to_string(process_.pid()) + "/status");
    for (std::string word; status >> word;) {
      long kilobytes = 0;
      if (word == "VmRSS:" && status >> kilobytes) return kilobytes;
    }
    return 0;
  }

 private:
  static std::vector<std::string> Command(const std::vector<std::string>& more) {
    std::vector<std::string> command = {BuiltProgram("ccmorse"), "run",    "syrotek",
                                        "--no-player",           "--port", "0",
                                        "--stream-port",         "0"};
    command.insert(command.end(), more.begin(), more.end());
    return command;
  }

  Process process_;
  int port_ = 0;
};

// The status that a wish to become a viewer is answered with: 101 where it is granted.
unsigned Handshake(const ServedRun& run, const std::string& target, const std::string& origin,
                   const std::string& host) {
  namespace http = beast::http;
  asio::io_context io;
  tcp::socket socket(io);
  socket.connect(
      tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(run.port())));
  http::request<http::empty_body> request(http::verb::get, target, 11);
  request.set(http::field::host, host);
  request.set(http::field::connection, "Upgrade");
  request.set(http::field::upgrade, "websocket");
  request.set(http::field::sec_websocket_version, "13");
  request.set(http::field::sec_websocket_key, "AAAAAAAAAAAAAAAAAAAAAA==");
  if (!origin.empty()) request.set(http::field::origin, origin);
  http::write(socket, request);
  beast::flat_buffer buffer;
  http::response_parser<http::empty_body> response;
  http::read_header(socket, buffer, response);
  return response.get().result_int();
}

TEST(ViewSafety, OnlyAPageOfTheViewItselfBecomesAViewer) {
  const ServedRun run;
  const std::string own = "http://" + run.host();
  EXPECT_EQ(Handshake(run, "/view", own, run.host()), 101U);
  EXPECT_EQ(Handshake(run, "/view", "", run.host()), 101U) << "a program sends no Origin";
  for (const std::string& other :
       {std::string("http://evil.example"), std::string("null"), std::string("http://localhost"),
        std::string("http://localhost:1"), "https://" + run.host(), own + ".evil.example",
        "http://evil.example/" + own, "http://127.0.0.1:" + std::to_string(run.port())}) {
    EXPECT_EQ(Handshake(run, "/view", other, run.host()), 403U) << other;
  }
  // A name of another site that was made to point here: Origin and Host agree, and are not ours.
  const std::string rebound = "evil.example:" + std::to_string(run.port());
  EXPECT_EQ(Handshake(run, "/view", "http://" + rebound, rebound), 403U);
}

TEST(ViewSafety, AViewerWithoutTheTokenIsRefused) {
  const ServedRun run({"--token", "abc"});
  const std::string own = "http://" + run.host();
  for (const char* wrong : {"/view", "/view?", "/view?token=", "/view?token=ab", "/view?token=abcd",
                            "/view?Token=abc", "/view?token=%61bc"}) {
    EXPECT_EQ(Handshake(run, wrong, own, run.host()), 401U) << wrong;
  }
  EXPECT_EQ(Handshake(run, "/view?token=abc", "http://evil.example", run.host()), 403U);
  EXPECT_EQ(Handshake(run, "/view?token=abc", own, run.host()), 101U);
}

TEST(ViewSafety, OtherAddressesServeNoViewWithoutAToken) {
  const auto run = [](std::vector<std::string> more) {
    std::vector<std::string> command = {BuiltProgram("ccmorse"),
                                        "run",
                                        "syrotek",
                                        "--bind",
                                        "0.0.0.0",
                                        "--no-player",
                                        "--port",
                                        "0",
                                        "--stream-port",
                                        "0",
                                        "--pace",
                                        "max",
                                        "--for",
                                        "0.1"};
    command.insert(command.end(), more.begin(), more.end());
    return RunToEnd(command).output;
  };
  const std::string refused = run({});
  EXPECT_EQ(refused.find("View at"), std::string::npos) << refused;
  EXPECT_NE(refused.find("no live view"), std::string::npos) << refused;
  EXPECT_NE(refused.find("--bind 0.0.0.0"), std::string::npos) << refused;
  EXPECT_NE(refused.find("--token"), std::string::npos) << refused;
  const std::string served = run({"--token", "abc"});
  EXPECT_NE(served.find("View at http://0.0.0.0:"), std::string::npos) << served;
  EXPECT_NE(served.find("/?token=abc"), std::string::npos) << served;
}

TEST(ViewSafety, AMessageThatIsTooLongEndsItsViewerAndNoOther) {
  constexpr std::size_t kLongest = 64U << 10;
  const ServedRun run;
  ViewClient other(run.port());
  other.NextText();
  {
    ViewClient viewer(run.port());
    viewer.NextText();
    viewer.Send(std::string(kLongest, ' '));  // no JSON, and answered
    EXPECT_FALSE(Json::Parse(viewer.NextText()).Find("ok")->AsBool());
    EXPECT_THROW(
        {
          viewer.Send(std::string(kLongest + 1, ' '));
          for (;;) viewer.Next();
        },
        boost::system::system_error);
  }
  EXPECT_TRUE(other.Call(R"(["time", "now", []])").Find("ok")->AsBool());
}

// The requirement: a viewer that stops reading costs at most 1 MB.
TEST(ViewSafety, AViewerThatAsksAndNeverReadsIsLetGoAtOneMegabyte) {
  const std::string kAsk = R"(["s1r.hokuyo", "get_local_data", []])";
  constexpr int kCalls = 2000;  // some 20 KB each: more than the kernel keeps by far
  const ServedRun run;
  ViewClient good(run.port());
  good.NextText();
  std::size_t reply = 0;
  for (int i = 0; i < 5; ++i) reply = good.Call(kAsk).Dump().size();  // as much as it ever needs
  ASSERT_GT(reply * kCalls, 25'000'000U);
  const long before = run.ResidentKilobytes();
  ASSERT_GT(before, 0);

  asio::io_context io;
  beast::websocket::stream<beast::tcp_stream> silent(io);
  beast::get_lowest_layer(silent).connect(
      tcp::endpoint(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(run.port())));
  silent.handshake(run.host(), "/view");
  boost::system::error_code gone;
  for (int i = 0; i < kCalls && !gone; ++i) {
    silent.write(asio::buffer(R"({"id": 1, "call": )" + kAsk + "}"), gone);
  }
  // The most that it ever takes while the others go on; each call is a turn of the server.
  long most = 0;
  for (int i = 0; i < 300; ++i) {
    EXPECT_TRUE(good.Call(R"(["time", "now", []])").Find("ok")->AsBool());
    most = std::max(most, run.ResidentKilobytes());
  }
  std::printf("a viewer that does not read costs %ld KB\n", most - before);
#if !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)  // they keep memory of their own
  // 1 MiB of answers, two frames of 140 KB with the canvas, and what the allocator keeps.
  EXPECT_LT(most - before, 2048);
#endif
  // It was let go: what is left to read comes to an end.
  beast::flat_buffer buffer;
  boost::system::error_code error;
  std::size_t read = 0;
  while (!error) {
    buffer.clear();
    read += silent.read(buffer, error);
  }
  EXPECT_LT(read, reply * kCalls);
}

// How fast it is, is no test's business; that each figure is there, is.
TEST(CommandLine, TheViewBenchmarkPrintsItsFigures) {
  const std::string ccmorse = BuiltProgram("ccmorse");
  const Finished table = RunToEnd({ccmorse, "bench", "view", "--seconds", "0.1"});
  EXPECT_EQ(table.status, 0) << table.output;
  EXPECT_NE(table.output.find("20 viewers slow the tick by"), std::string::npos) << table.output;
  const Finished json = RunToEnd({ccmorse, "bench", "view", "--seconds", "0.1", "--json"});
  ASSERT_EQ(json.status, 0) << json.output;
  const Json figures = Json::Parse(json.output.substr(0, json.output.find('\n')));
  for (const char* name : {"frame_bytes", "frame_compressed", "first_page_byte_ms"}) {
    ASSERT_NE(figures.Find(name), nullptr) << name;
    EXPECT_GT(figures.Find(name)->AsDouble(), 0.0) << name;
  }
  // 13 scans of 682 beams are in it, and the requirement is kept.
  EXPECT_GT(figures.Find("frame_bytes")->AsDouble(), 13.0 * 682.0 * 2.0);
  EXPECT_LT(figures.Find("frame_bytes")->AsDouble(), 40'000.0);
  EXPECT_NE(figures.Find("viewers_slow_tick_percent"), nullptr);
}

}  // namespace
}  // namespace ccmorse::testing
