#include "servers/morse/multinode_server.h"

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "servers/net/listener.h"
#include "servers/net/outbox.h"
#include "servers/net/stream_socket.h"
#include "wire/morse_line.h"
#include "wire/multinode.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr std::size_t kMostNodes = 256;

}  // namespace

// Handlers that still run when the server has gone hold it.
struct MultinodeServer::State : std::enable_shared_from_this<MultinodeServer::State> {
  struct Node {
    explicit Node(StreamSocket socket_in)
        : socket(std::move(socket_in)), outbox(socket), lines(wire::kLongestNodeLine) {}
    bool in_lockstep() const { return scene.nodes > 0; }

    StreamSocket socket;
    Outbox outbox;
    wire::LineSplitter lines;
    std::array<char, kReadBlock> block{};
    std::string name;       // "" until it has told
    wire::NodeScene scene;  // the last that it told
    bool waits = false;     // for an answer
  };

  void Take(tcp::socket socket) {
    if (nodes.size() >= kMostNodes) {
      LogWarning("multinode: more than {} nodes, one was refused", kMostNodes);
      return;
    }
    nodes.push_back(std::make_shared<Node>(std::move(socket)));
    Read(nodes.back());
  }

  void Read(const std::shared_ptr<Node>& node) {
    node->socket.async_read_some(asio::buffer(node->block), [self = shared_from_this(), node](
                                                                ErrorCode error, std::size_t size) {
      if (self->closed) return;
      if (error) return self->Drop(node, "it has gone");
      node->lines.Append({node->block.data(), size});
      if (self->TakeLines(node)) self->Read(node);
    });
  }

  // False when the node was let go.
  bool TakeLines(const std::shared_ptr<Node>& node) {
    std::string_view line;
    for (;;) {
      switch (node->lines.Next(&line)) {
        case wire::LineSplitter::Result::kNeedMore:
          Answer();
          return true;
        case wire::LineSplitter::Result::kTooLong:
          Drop(node, "its line is too long");
          return false;
        case wire::LineSplitter::Result::kLine:
          break;
      }
      try {
        wire::NodeMessage message = wire::ParseNodeMessage(line);
        if (node->name.empty()) LogInfo("multinode: node {} has come", message.node);
        node->name = std::move(message.node);
        node->scene = std::move(message.scene);
        node->waits = true;
      } catch (const Error& error) {
        Drop(node, error.what());
        return false;
      }
      if (!node->in_lockstep()) AnswerOne(*node, node);
    }
  }

  // Whoever can be.
  void Answer() {
    std::vector<std::shared_ptr<Node>> round;
    std::size_t wanted = 0;
    bool all = true;
    for (const auto& node : nodes) {
      if (!node->in_lockstep()) continue;
      round.push_back(node);
      wanted = std::max(wanted, static_cast<std::size_t>(node->scene.nodes));
      all = all && node->waits;
    }
    complete = complete || round.size() >= wanted;  // one that leaves later is not waited for
    if (round.empty()) complete = false;
    if (!complete || !all) return;
    for (const auto& node : round) AnswerOne(*node, node);
  }

  void AnswerOne(Node& node, const std::shared_ptr<Node>& keep) {
    wire::NodeScene others;
    others.nodes = node.scene.nodes;
    others.time = node.scene.time;
    for (const auto& other : nodes) {
      if (other == keep) continue;
      others.robots.insert(other->scene.robots.begin(), other->scene.robots.end());
      if (others.time[0] < other->scene.time[0]) others.time = other->scene.time;
    }
    node.waits = false;
    node.outbox.text() += wire::NodeAnswerLine(others);
    node.outbox.Flush(keep, [self = shared_from_this(), keep](ErrorCode error) {
      if (!self->closed && error) self->Drop(keep, "it has gone");
    });
  }

  void Drop(const std::shared_ptr<Node>& node, const std::string& why) {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found == nodes.end()) return;
    nodes.erase(found);
    ErrorCode ignored;
    node->socket.close(ignored);
    LogInfo("multinode: node {} is let go: {}", node->name.empty() ? "without a name" : node->name,
            why);
    Answer();
  }

  std::shared_ptr<Listener> listener;
  std::vector<std::shared_ptr<Node>> nodes;  // in the order in which they came
  bool complete = false;                     // all that are to be in lock-step have come
  bool closed = false;
};

MultinodeServer::MultinodeServer(const std::string& bind, int port)
    : state_(std::make_shared<State>()) {
  state_->listener = std::make_shared<Listener>(
      io_, [state = state_.get()](tcp::socket socket) { state->Take(std::move(socket)); });
  state_->listener->Open(bind, port, false);
}

MultinodeServer::~MultinodeServer() {
  state_->closed = true;
  state_->listener->Close();
  for (const auto& node : state_->nodes) {
    ErrorCode ignored;
    node->socket.close(ignored);
  }
  state_->nodes.clear();
  // Handlers of the closed sockets still refer to what goes before the io_context: let them run.
  io_.restart();
  io_.poll();
}

int MultinodeServer::port() const { return state_->listener->port(); }

}  // namespace ccmorse::servers
