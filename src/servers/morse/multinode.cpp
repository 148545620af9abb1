#include "servers/morse/multinode.h"

#include <fmt/format.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "servers/net/stream_socket.h"
#include "wire/morse_line.h"
#include "wire/multinode.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

}  // namespace

struct Multinode::State : std::enable_shared_from_this<Multinode::State> {
  State(asio::io_context& io_in, sim::Simulation& simulation_in, std::string node_in,
        std::function<bool()> goes_on_in)
      : io(io_in),
        simulation(simulation_in),
        node(std::move(node_in)),
        goes_on(std::move(goes_on_in)),
        socket(io),
        lines(wire::kLongestNodeLine) {}

  void Connect(const scene::MultinodeDef& def) {
    ErrorCode error;
    tcp::resolver resolver(io);
    const auto found = resolver.resolve(def.server, std::to_string(def.port), error);
    if (!error) asio::connect(socket, found, error);
    if (error) {
      throw Error(
          fmt::format("no multinode server at {} port {}: {}; `ccmorse multinode-server` is "
                      "one",
                      def.server, def.port, error.message()));
    }
    ErrorCode ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    Read();
  }

  void Read() {
    socket.async_read_some(asio::buffer(block),
                           [self = shared_from_this()](ErrorCode error, std::size_t size) {
                             if (error) {
                               self->gone = true;
                               return;
                             }
                             self->lines.Append({self->block.data(), size});
                             std::string_view line;
                             while (self->lines.Next(&line) == wire::LineSplitter::Result::kLine)
                               self->answer = line;
                             self->Read();
                           });
  }

  wire::NodeMessage Told(bool finished) const {
    wire::NodeMessage message;
    message.node = node;
    message.scene.nodes = nodes;
    const double wall =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    message.scene.time = {simulation.time(), 1.0 / simulation.scenario().time.frequency, wall};
    for (const auto& robot : simulation.robots()) {
      if (external.count(robot->name()) != 0) continue;
      wire::NodeRobot& told = message.scene.robots[robot->name()];
      const Vec3 place = robot->position();
      told.position = {place.x, place.y, place.z};
      told.rotation = {0.0, 0.0, robot->pose().yaw};
      const sim::Twist twist = robot->held() ? sim::Twist{} : robot->command();
      told.command = {twist.v, twist.w, twist.side};
      if (finished) told.hash = robot->hash().value();
    }
    return message;
  }

  // Tells, and waits until the others have told of the same tick. Nothing when the run is to end
  // before.
  std::optional<wire::NodeScene> Exchange(bool finished) {
    const std::string line = wire::NodeMessageLine(Told(finished));
    ErrorCode error;
    asio::write(socket, asio::buffer(line), error);
    if (error) gone = true;
    // Who pauses another node makes this one wait, and it answers its own clients meanwhile. What
    // they command then acts from the next tick on, as this one's commands are out.
    while (!answer && !gone && goes_on()) {
      io.restart();
      io.run_one();
    }
    if (!answer && gone) throw Error("the multinode server has gone");
    if (!answer) return std::nullopt;
    const std::string text = *std::exchange(answer, std::nullopt);
    return wire::ParseNodeAnswer(text);
  }

  // Before the robots move: the others' are where their nodes have them, and do what they do there.
  void BeforeMotion() {
    const std::optional<wire::NodeScene> others = Exchange(false);
    if (!others) return;
    bool moved = false;
    for (const std::string& name : external) {
      const auto told = others->robots.find(name);
      sim::Robot* const robot = simulation.FindRobot(name);
      if (told == others->robots.end() || robot == nullptr) continue;  // its node has left
      const Pose2 pose{told->second.position[0], told->second.position[1],
                       told->second.rotation[2]};
      const Pose2& here = robot->pose();
      if (pose.x != here.x || pose.y != here.y || pose.yaw != here.yaw) {
        robot->Place(pose);
        moved = true;
      }
      const std::array<double, 3> twist = told->second.command.value_or(std::array<double, 3>{});
      robot->Command({twist[0], twist[1], twist[2]}, nullptr);
    }
    if (moved) simulation.world().RobotsMoved();
  }

  asio::io_context& io;
  sim::Simulation& simulation;
  std::string node;
  std::function<bool()> goes_on;
  tcp::socket socket;
  wire::LineSplitter lines;
  std::array<char, kReadBlock> block{};
  std::optional<std::string> answer;  // that came and was not used yet
  bool gone = false;                  // the server
  std::set<std::string> external;
  int nodes = 0;
};

std::set<std::string> Multinode::External(const scene::MultinodeDef& def, const std::string& node) {
  std::set<std::string> external;
  for (const auto& [name, robots] : def.nodes) {
    if (name != node) external.insert(robots.begin(), robots.end());
  }
  return external;
}

Multinode::Multinode(asio::io_context& io, sim::Simulation& simulation,
                     const scene::MultinodeDef& def, const std::string& node,
                     std::function<bool()> goes_on)
    : state_(std::make_shared<State>(io, simulation, node, std::move(goes_on))) {
  state_->external = External(def, node);
  state_->nodes = static_cast<int>(def.nodes.size());
  state_->Connect(def);
  simulation.set_before_motion([state = state_] { state->BeforeMotion(); });
}

Multinode::~Multinode() {
  state_->simulation.set_before_motion(nullptr);
  ErrorCode ignored;
  state_->socket.close(ignored);
}

const std::set<std::string>& Multinode::external() const { return state_->external; }

void Multinode::Finish() {
  const std::optional<wire::NodeScene> others = state_->Exchange(true);
  if (!others) return;
  for (const auto& [name, told] : others->robots) {
    sim::Robot* const robot = state_->simulation.FindRobot(name);
    if (robot == nullptr || !told.hash || state_->external.count(name) == 0) continue;
    robot->hash() = sim::StateHash::From(*told.hash);
  }
}

}  // namespace ccmorse::servers
