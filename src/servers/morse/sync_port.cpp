#include "servers/morse/sync_port.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <deque>
#include <utility>

#include "base/log.h"
#include "servers/net/listener.h"
#include "servers/net/stream_socket.h"

namespace ccmorse::servers {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr std::size_t kOneTick = 2048;  // bytes that MORSE takes at once
constexpr std::size_t kMostWaiting = 16;

}  // namespace

// Handlers that still run when the port has gone hold it.
struct SyncPort::State : std::enable_shared_from_this<SyncPort::State> {
  void Take(tcp::socket socket) {
    if (clients.size() >= kMostWaiting) {
      LogWarning("more than {} connections to the port of time_sync, one was refused",
                 kMostWaiting);
      return;
    }
    clients.push_back(std::move(socket));
  }

  void Drop() {
    ErrorCode ignored;
    clients.front().close(ignored);
    clients.pop_front();
    waits = false;
    LogInfo("time_sync: the client has left, time goes on");
  }

  void Wait() {
    if (waits) return;
    waits = true;
    clients.front().async_wait(tcp::socket::wait_read,
                               [self = shared_from_this()](ErrorCode error) {
                                 if (!error) self->waits = false;
                               });
  }

  std::shared_ptr<Listener> listener;
  std::deque<tcp::socket> clients;  // the first one gives the time
  bool waits = false;               // for its bytes
};

SyncPort::SyncPort(asio::io_context& io, const std::string& bind, int port)
    : state_(std::make_shared<State>()) {
  state_->listener = std::make_shared<Listener>(
      io, [state = state_.get()](tcp::socket socket) { state->Take(std::move(socket)); });
  state_->listener->Open(bind, port, false);
}

SyncPort::~SyncPort() { Close(); }

int SyncPort::port() const { return state_->listener->port(); }

bool SyncPort::connected() const { return !state_->clients.empty(); }

bool SyncPort::TakeTick() {
  while (connected()) {
    std::array<char, kOneTick> bytes{};
    ErrorCode error;
    const std::size_t size = state_->clients.front().read_some(asio::buffer(bytes), error);
    if (!error && size > 0) return true;
    if (error == asio::error::would_block) {
      state_->Wait();
      return false;
    }
    state_->Drop();
  }
  return true;
}

void SyncPort::Close() {
  state_->listener->Close();
  ErrorCode ignored;
  for (tcp::socket& client : state_->clients) client.close(ignored);
  state_->clients.clear();
}

}  // namespace ccmorse::servers
