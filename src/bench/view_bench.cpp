// `ccmorse bench view`: what the live view costs, measured as a browser meets it, over TCP from a
// simulator in a process of its own (docs/view.md has the figures, docs/protocols/view.md the
// bytes). A program of its own, which `ccmorse` executes, so that it knows nothing of the server.

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/json.h"
#include "bench/simulator.h"

namespace {

using namespace ccmorse::bench;  // NOLINT(google-build-using-namespace): a program of one file
using ccmorse::Json;
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;

constexpr int kViewers = 20;
constexpr double kFramesPerSecond = 60.0;  // that a viewer gets at most
constexpr int kPages = 50;                 // requests whose median counts

tcp::endpoint Here(int port) {
  return {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)};
}

// Looks as the page does.
class Viewer {
 public:
  explicit Viewer(int port) : socket_(io_) {
    beast::get_lowest_layer(socket_).connect(Here(port));
    socket_.handshake("localhost:" + std::to_string(port), "/view");
    Next();  // the scene
  }

  // The next frame, not confirmed yet; answers to calls are left out.
  std::string Frame() {
    for (;;) {
      std::string message = Next();
      if (socket_.got_binary()) return message;
    }
  }
  void Confirm() { socket_.write(asio::buffer("k", 1)); }

  // Simulated time, s. To be called where no frames are confirmed, so that few lie before it.
  double Now() {
    const std::string call = R"({"id": 1, "call": ["time", "now", []]})";
    socket_.text(true);
    socket_.write(asio::buffer(call));
    for (;;) {
      const std::string message = Next();
      if (!socket_.got_binary()) return Json::Parse(message).Find("value")->AsDouble();
    }
  }

 private:
  std::string Next() {
    beast::flat_buffer buffer;
    socket_.read(buffer);
    return beast::buffers_to_string(buffer.data());
  }

  asio::io_context io_;
  beast::websocket::stream<beast::tcp_stream> socket_;
};

std::size_t Compressed(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<Bytef> out(size);
  if (compress2(out.data(), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 6) !=
      Z_OK) {
    throw std::runtime_error("cannot compress");
  }
  return size;
}

struct FrameSize {
  std::size_t bytes = 0;
  std::size_t compressed = 0;
};

// The largest frame that has no news of the canvas: one with every robot's scan, as scans are due
// at the same tick. The first frame tells the canvas.
FrameSize LargestFrame(int port, double seconds) {
  Viewer viewer(port);
  viewer.Frame();
  viewer.Confirm();
  FrameSize largest;
  const auto start = Clock::now();
  while (Since(start) < seconds || largest.bytes == 0) {
    const std::string frame = viewer.Frame();
    viewer.Confirm();
    if (frame.size() > largest.bytes) largest = {frame.size(), Compressed(frame)};
  }
  return largest;
}

struct Cost {
  double processor = 0.0;  // s
  double ticks = 0.0;
};

Cost operator-(const Cost& a, const Cost& b) {
  return {a.processor - b.processor, a.ticks - b.ticks};
}

// How much slower 20 viewers make the tick, as a share, where they get 60 rounds of frames a
// second: in processor time of the simulator, which runs as fast as it can, so that other programs
// that take the processor do not count, nor the viewers themselves.
double SlowedBy(const std::string& ccmorse, double seconds, double& round) {
  const Simulator simulator(ccmorse, "docks", "max", 0, Simulator::View::kServed);
  Viewer idle(
      simulator.view_port());  // confirms nothing: it gets two frames and then costs nothing
  const auto now = [&] { return Cost{simulator.ProcessorTime(), 60.0 * idle.Now()}; };
  const auto rest = [](double time) {
    std::this_thread::sleep_for(std::chrono::duration<double>(time));
  };
  Cost alone;
  Cost watched;
  double rounds = 0.0;
  constexpr int kTurns = 4;  // in turns, as the machine is not always as fast
  for (int turn = 0; turn < kTurns; ++turn) {
    Cost before = now();
    rest(seconds / kTurns);
    Cost spent = now() - before;
    alone = {alone.processor + spent.processor, alone.ticks + spent.ticks};

    std::atomic<bool> leave = false;
    std::atomic<bool> there = false;
    std::atomic<int> shown = 0;  // rounds of frames
    std::thread viewers([&] {
      std::vector<std::unique_ptr<Viewer>> all;
      for (int i = 0; i < kViewers; ++i) {
        all.push_back(std::make_unique<Viewer>(simulator.view_port()));
      }
      there = true;
      while (!leave) {
        for (const auto& viewer : all) {
          viewer->Frame();
          viewer->Confirm();
        }
        ++shown;
      }
    });
    while (!there || shown < 3) rest(0.01);
    const int shown_before = shown;
    before = now();
    rest(seconds / kTurns);
    spent = now() - before;
    rounds += shown - shown_before;
    watched = {watched.processor + spent.processor, watched.ticks + spent.ticks};
    leave = true;
    viewers.join();
  }
  const double of_ticks = watched.ticks * alone.processor / alone.ticks;
  round = std::max(0.0, watched.processor - of_ticks) / std::max(1.0, rounds);
  const double share = kFramesPerSecond * round;
  return share / std::max(1e-9, 1.0 - share);
}

// From the call of connect() to the page's first byte, s, and all the bytes of a file.
double FirstByte(int port, const std::string& target, std::string& body) {
  asio::io_context io;
  const auto start = Clock::now();
  beast::tcp_stream stream(io);
  stream.connect(Here(port));
  http::request<http::empty_body> request(http::verb::get, target, 11);
  request.set(http::field::host, "localhost:" + std::to_string(port));
  http::write(stream, request);
  stream.socket().wait(tcp::socket::wait_read);
  const double first = Since(start);
  beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(stream, buffer, response);
  body = response.result() == http::status::ok ? response.body() : "";
  return first;
}

int Run(const std::string& ccmorse, double seconds, bool as_json) {
  FrameSize frame;
  std::vector<double> first_bytes;
  std::size_t bundle = 0;
  {
    const Simulator simulator(ccmorse, "docks", "real", 0, Simulator::View::kServed);
    frame = LargestFrame(simulator.view_port(), seconds);
    std::string body;
    for (int i = 0; i < kPages; ++i) {
      first_bytes.push_back(FirstByte(simulator.view_port(), "/", body));
    }
    for (const char* file : {"/", "/view.js", "/view.css"}) {
      FirstByte(simulator.view_port(), file, body);
      bundle += body.empty() ? 0 : Compressed(body);
    }
  }
  double round = 0.0;
  const double slowed = SlowedBy(ccmorse, 4.0 * seconds, round);
  const double first = Quantile(first_bytes, 0.5);
  if (as_json) {
    fmt::print("{}\n",
               Json(Json::Object{{"frame_bytes", static_cast<double>(frame.bytes)},
                                 {"frame_compressed", static_cast<double>(frame.compressed)},
                                 {"viewers_slow_tick_percent", 100.0 * slowed},
                                 {"viewers_round_us", 1e6 * round},
                                 {"first_page_byte_ms", 1e3 * first},
                                 {"page_compressed", static_cast<double>(bundle)}})
                   .Dump());
    return 0;
  }
  const auto row = [](const char* what, const std::string& measured, const char* required) {
    fmt::print("{:<58} {:>12} {:>12}\n", what, measured, required);
  };
  row("the live view of 13 S1R with a scan each", "measured", "required");
  row("a frame with all scans, KB", fmt::format("{:.1f}", 1e-3 * static_cast<double>(frame.bytes)),
      "< 40");
  row("  the same, compressed (deflate), KB",
      fmt::format("{:.1f}", 1e-3 * static_cast<double>(frame.compressed)), "");
  row("20 viewers slow the tick by, %", fmt::format("{:.1f}", 100.0 * slowed), "< 5");
  row("  a round of frames for them takes, us", fmt::format("{:.0f}", 1e6 * round), "");
  row("first byte of the page, ms", fmt::format("{:.2f}", 1e3 * first), "< 1000");
  row("the page, compressed, KB",
      bundle == 0 ? "not built" : fmt::format("{:.0f}", 1e-3 * static_cast<double>(bundle)),
      "< 1000");
  return 0;
}

}  // namespace

// Arguments, as `ccmorse bench view` passes them on: path of ccmorse, seconds, "json" or "table".
int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: ccmorse bench view\n");
    return 2;
  }
  try {
    return Run(argv[1], std::atof(argv[2]), std::string(argv[3]) == "json");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ccmorse bench view: %s\n", error.what());
  }
  return 1;
}
