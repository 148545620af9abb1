#include "tests/support/fake_server.h"

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <list>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

namespace ccmorse::test {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {

constexpr auto kPatience = std::chrono::seconds(10);

std::string Scan() {
  std::string ranges;
  for (int i = 0; i < 682; ++i) ranges += std::string(i ? ", " : "") + (i == 100 ? "0.5" : "5.0");
  return "\"point_list\": [], \"range_list\": [" + ranges + "]";
}

std::string Component(const std::string& name, const std::string& type,
                      const std::string& services) {
  return "\"" + name + "\": {\"type\": \"" + type + "\", \"services\": [" + services + "]}";
}

}  // namespace

struct FakeServer::Impl {
  struct Session {
    explicit Session(tcp::socket s) : socket(std::move(s)) {}
    tcp::socket socket;
    std::array<char, 65536> chunk{};
    std::string incoming;
    std::deque<std::string> held;  // requests behind a read that is held
    bool holding = false;
    bool open = true;
  };

  explicit Impl(Options o)
      : options(std::move(o)), acceptor(io, {asio::ip::address_v4::loopback(), 0}) {
    port = acceptor.local_endpoint().port();
    for (std::size_t i = 0; i < options.robots.size(); ++i) {
      const std::string& robot = options.robots[i];
      data[robot + ".pose"] =
          R"("x": 1.0, "y": 2.0, "z": 0.1, "yaw": 0.5, "pitch": 0.0, "roll": 0.0)";
      data[robot + ".odometry"] =
          R"("x": 0.25, "y": 0.5, "z": 0.0, "yaw": 0.125, "pitch": 0.0, "roll": 0.0, )"
          R"("vx": 0.3, "vy": 0.0, "vz": 0.0, "wz": 0.1, "wy": 0.0, "wx": 0.0, "stall": false)";
      data[robot + ".hokuyo"] = Scan();
      const std::string index = std::to_string(i);
      const std::string proxies =
          i == 0 ? R"("position2d": {"0": "pose", "2": "pose", "3": "odometry"}, )"
                   R"("laser": {"0": "hokuyo"})"
                 : "\"position2d\": {\"1" + index + "\": \"pose\"}, \"laser\": {\"1" + index +
                       "\": \"hokuyo\"}";
      data[robot + ".properties"] =
          "\"properties\": {\"name\": \"" + robot +
          R"(", "type": "S1R", "size": [0.174, 0.163, 0.18], "mass": 2.0, "wheel_radius": 0.032, )"
          R"("wheel_track": 0.125, "max_speed": 0.35, "max_turn_rate": 2.5, )"
          R"("color": [52, 170, 255], )"
          R"("pose": {"x": 1.0, "y": 2.0, "yaw": 0.5}, "drivers": {"snd": {"max_speed": 0.2}}, )"
          R"("canvas": {"mode": "ground"}, "proxies": {)" +
          proxies + "}}";
    }
    thread = std::thread([this] {
      Accept();
      const auto guard = asio::make_work_guard(io);
      io.run();
    });
  }

  ~Impl() {
    io.stop();
    thread.join();
  }

  void Accept() {
    acceptor.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
      if (error) return;
      socket.set_option(tcp::no_delay(true));
      sessions.emplace_back(std::move(socket));
      Changed([this] { ++connections; });
      Receive(sessions.back());
      Accept();
    });
  }

  void Receive(Session& session) {
    session.socket.async_read_some(
        asio::buffer(session.chunk),
        [this, &session](const boost::system::error_code& error, std::size_t count) {
          if (error) {
            CloseSession(session);
            return;
          }
          session.incoming.append(session.chunk.data(), count);
          std::size_t begin = 0;
          for (std::size_t end; (end = session.incoming.find('\n', begin)) != std::string::npos;
               begin = end + 1) {
            Take(session, session.incoming.substr(begin, end - begin));
          }
          session.incoming.erase(0, begin);
          if (session.open) Receive(session);
        });
  }

  void CloseSession(Session& session) {
    if (!session.open) return;
    session.open = false;
    boost::system::error_code ignored;
    session.socket.shutdown(tcp::socket::shutdown_both, ignored);
    session.socket.close(ignored);
    Changed([this] { --connections; });
  }

  void Write(Session& session, const std::string& text) {
    boost::system::error_code ignored;
    if (session.open) asio::write(session.socket, asio::buffer(text), ignored);
  }

  void Take(Session& session, const std::string& line) {
    const std::size_t blank = line.find(' ');
    const std::string id = line.substr(0, blank);
    const std::string request = blank == std::string::npos ? "" : line.substr(blank + 1);
    std::function<void(const std::string&)> hook;
    Changed([&] {
      lines.push_back(request);
      ids.push_back(id);
      hook = on_line;
    });
    if (hook) hook(request);
    if (!session.open || silent) return;
    if (request == "ccmorse ping") {
      Write(session, id + " SUCCESS \"pong\"\n");
      return;
    }
    if (session.holding || (hold && request == "ccmorse read")) {
      session.holding = true;
      session.held.push_back(line);
      return;
    }
    Reply(session, id, request);
  }

  void Reply(Session& session, const std::string& id, const std::string& request) {
    const std::optional<std::string> answer = Find(request);
    if (answer) Write(session, id + " " + *answer + "\n");
  }

  std::optional<std::string> Find(const std::string& request) {
    std::istringstream words(request);
    std::string component;
    std::string service;
    words >> component >> service;
    const auto scripted = answers.find(component + " " + service);
    if (scripted != answers.end()) return scripted->second;
    if (service == "list_robots") {
      std::string list;
      for (const std::string& robot : options.robots)
        list += (list.empty() ? "\"" : ", \"") + robot + "\"";
      return "SUCCESS [" + list + "]";
    }
    if (service == "details") return "SUCCESS " + Details();
    if (component == "ccmorse" && options.ccmorse) {
      if (service == "hello") {
        return "SUCCESS {\"server\": \"ccmorse 0.1.0\", \"protocol\": 1, \"pace\": \"" +
               options.pace + "\", \"frequency\": 60.0, \"read_period\": 0.1}";
      }
      if (service == "read") {
        time += step;
        return "SUCCESS {\"time\": " + std::to_string(time) + "}";
      }
      if (service == "peek") return "SUCCESS";
    }
    if (component == "time") {
      if (service == "now") return "SUCCESS " + std::to_string(time);
      if (service == "mode") return "SUCCESS \"Fixed Simulation Step\"";
      if (service == "set_time_scale") return "SUCCESS true";
      if (service == "statistics") {
        return R"(SUCCESS {"mean_time": 0.0166, "variance_time": 1e-9, "diff_real_time": 0.25})";
      }
    }
    if (service == "get_local_data" && data.count(component)) {
      if (!options.ccmorse) time += step / 10.0;
      return "SUCCESS {\"timestamp\": " + std::to_string(time) + ", " + data[component] + "}";
    }
    if (service == "get_configurations") {
      return R"(SUCCESS {"configurations": {"laser_range": 5.0, "resolution": 0.39589, )"
             R"("scan_window": 270, "frequency": 10.0, "object_to_robot": {)"
             R"("rotation": [[1, 0, 0], )"
             R"([0, 1, 0], [0, 0, 1]], "translation": [0.035, 0.0, 0.1]}}})";
    }
    if (service == "get_size")
      return "SUCCESS [" + std::to_string(width) + ", " + std::to_string(height) + "]";
    if (service == "get_cell_size") return "SUCCESS 0.02";
    if (service == "get_pixel") return "SUCCESS [1, 2, 3]";
    if (service == "resize_canvas") {
      char ignored = 0;
      words >> ignored >> width >> ignored >> height;
      return "SUCCESS";
    }
    if (service == "get_status") return "SUCCESS \"Transit\"";
    for (const char* known :
         {"set_speed", "setdest", "goto", "stop", "resume", "set_pixel", "set_line",
          "set_image_data", "update_image_data", "save_image_copy"}) {
      if (service == known) return "SUCCESS";
    }
    return "FAILED \"The request " + service +
           " has not been registered in Socket service manager\"";
  }

  std::string Details() const {
    std::string robots;
    for (const std::string& robot : options.robots) {
      const bool first = &robot == &options.robots.front();
      const std::string sensor = R"("get_local_data", "get_configurations")";
      std::string components = Component(robot + ".pose", "Pose", sensor);
      components += ", " + Component(robot + ".odometry", "IntegratedOdometry", sensor);
      components += ", " + Component(robot + ".hokuyo", "LaserScanner", sensor);
      components += ", " + Component(robot + ".motion", "MotionVW", R"("set_speed", "stop")");
      components += ", " + Component(robot + ".waypoint", "Waypoint",
                                     R"("goto", "setdest", "stop", "resume", "get_status")");
      if (options.properties) {
        components += ", " + Component(robot + ".properties", "RobotProperties", sensor);
      }
      if (options.pen && first) {
        components += ", " + Component(robot + ".pen", "Pen",
                                       R"("set_pixel", "get_pixel", "get_size", "get_cell_size")");
      }
      if (first) {
        for (const auto& [name, type] : options.extra) {
          components += ", " + Component(robot + "." + name, type, sensor);
        }
      }
      robots += (robots.empty() ? "" : ", ") + std::string("{\"name\": \"") + robot +
                "\", \"type\": \"Syrotek\", \"components\": {" + components + "}}";
    }
    return "{\"robots\": [" + robots + "], \"environment\": \"arena\"}";
  }

  template <class Change>
  void Changed(const Change& change) {
    {
      const std::lock_guard lock(mutex);
      change();
    }
    changed.notify_all();
  }

  // Runs in the server's thread; waits until it is done. At once in that thread itself.
  template <class Work>
  void Do(const Work& work) {
    if (std::this_thread::get_id() == thread.get_id()) {
      work();
      return;
    }
    std::promise<void> done;
    asio::post(io, [&] {
      work();
      done.set_value();
    });
    done.get_future().wait();
  }

  Options options;
  asio::io_context io;
  tcp::acceptor acceptor;
  int port = 0;
  std::thread thread;

  // The server's thread only.
  std::list<Session> sessions;
  std::map<std::string, std::optional<std::string>> answers;
  std::map<std::string, std::string> data;
  double time = 0.0;
  double step = 0.1;
  int width = 100;
  int height = 100;
  bool hold = false;
  bool silent = false;

  std::mutex mutex;  // what follows
  std::condition_variable changed;
  std::vector<std::string> lines;
  std::vector<std::string> ids;
  std::size_t connections = 0;
  std::function<void(const std::string&)> on_line;
};

FakeServer::FakeServer() : FakeServer(Options()) {}
FakeServer::FakeServer(Options options) : impl_(std::make_unique<Impl>(std::move(options))) {}
FakeServer::~FakeServer() = default;

int FakeServer::port() const { return impl_->port; }

std::vector<std::string> FakeServer::Lines() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->lines;
}

std::vector<std::string> FakeServer::Ids() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->ids;
}

std::size_t FakeServer::Count(const std::string& start) const {
  std::size_t count = 0;
  for (const std::string& line : Lines()) count += line.rfind(start, 0) == 0 ? 1U : 0U;
  return count;
}

void FakeServer::ClearLines() {
  const std::lock_guard lock(impl_->mutex);
  impl_->lines.clear();
}

bool FakeServer::WaitForLine(const std::string& start) const {
  std::unique_lock lock(impl_->mutex);
  return impl_->changed.wait_for(lock, kPatience, [&] {
    for (const std::string& line : impl_->lines) {
      if (line.rfind(start, 0) == 0) return true;
    }
    return false;
  });
}

std::size_t FakeServer::Connections() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->connections;
}

bool FakeServer::WaitForConnections(std::size_t count) const {
  std::unique_lock lock(impl_->mutex);
  return impl_->changed.wait_for(lock, kPatience, [&] { return impl_->connections == count; });
}

void FakeServer::Answer(const std::string& request, std::optional<std::string> answer) {
  impl_->Do([&] { impl_->answers[request] = std::move(answer); });
}

void FakeServer::SetData(const std::string& device, const std::string& members) {
  impl_->Do([&] { impl_->data[device] = members; });
}

void FakeServer::SetStep(double seconds) {
  impl_->Do([&] { impl_->step = seconds; });
}

void FakeServer::Hold() {
  impl_->Do([&] { impl_->hold = true; });
}

void FakeServer::Release() {
  impl_->Do([&] {
    impl_->hold = false;
    for (Impl::Session& session : impl_->sessions) {
      session.holding = false;
      for (const std::string& line : session.held) {
        const std::size_t blank = line.find(' ');
        impl_->Reply(session, line.substr(0, blank), line.substr(blank + 1));
      }
      session.held.clear();
    }
  });
}

void FakeServer::FallSilent() {
  impl_->Do([&] { impl_->silent = true; });
}

void FakeServer::Disconnect(bool listen) {
  impl_->Do([&] {
    for (Impl::Session& session : impl_->sessions) impl_->CloseSession(session);
    boost::system::error_code ignored;
    if (!listen) impl_->acceptor.close(ignored);
  });
}

void FakeServer::SendRaw(const std::string& bytes) {
  impl_->Do([&] {
    for (Impl::Session& session : impl_->sessions) impl_->Write(session, bytes);
  });
}

void FakeServer::OnLine(std::function<void(const std::string&)> hook) {
  const std::lock_guard lock(impl_->mutex);
  impl_->on_line = std::move(hook);
}

}  // namespace ccmorse::test
