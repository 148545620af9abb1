#include "servers/net/listener.h"

#include <sys/socket.h>

#include <chrono>
#include <cstdint>
#include <utility>

#include "base/error.h"
#include "servers/net/stream_socket.h"

namespace ccmorse::servers {

namespace asio = boost::asio;
using asio::ip::tcp;

namespace {
constexpr auto kAcceptPause = std::chrono::milliseconds(100);
}  // namespace

Listener::Listener(asio::io_context& io, Taker take)
    : acceptor_(io), pause_(io), take_(std::move(take)) {}

void Listener::Open(const std::string& address, int port, bool search) {
  ErrorCode error;
  const auto ip = asio::ip::make_address(address, error);
  if (error) throw Error("cannot listen on '" + address + "': it is not an IP address");
  for (;; ++port) {
    const tcp::endpoint endpoint(ip, static_cast<std::uint16_t>(port));
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
    if (!error) break;
    acceptor_.close();
    if (!search || error != asio::error::address_in_use || port >= 65535) {
      throw Error("cannot listen on " + address + " port " + std::to_string(port) + ": " +
                  error.message() +
                  (error == asio::error::address_in_use
                       ? "; another simulation may be running there, choose another with --port"
                       : ""));
    }
  }
  Accept();
}

void Listener::Adopt(int socket) {
  int listens = 0;
  socklen_t size = sizeof listens;
  if (::getsockopt(socket, SOL_SOCKET, SO_ACCEPTCONN, &listens, &size) != 0 || listens == 0) {
    throw Error("file descriptor " + std::to_string(socket) + " is no socket that listens");
  }
  ErrorCode error;
  acceptor_.assign(tcp::v4(), socket, error);
  if (error) throw Error("cannot listen on the given socket: " + error.message());
  Accept();
}

int Listener::port() const {
  ErrorCode ignored;
  return acceptor_.local_endpoint(ignored).port();
}

void Listener::Close() {
  ErrorCode ignored;
  acceptor_.close(ignored);
  pause_.cancel();
  take_ = nullptr;
}

void Listener::Accept() {
  acceptor_.async_accept([self = shared_from_this()](ErrorCode error, tcp::socket socket) {
    if (!self->take_ || error == asio::error::operation_aborted) return;
    if (error) {
      self->warnings_.Warn("cannot accept a connection: {}", error.message());
      self->pause_.expires_after(kAcceptPause);
      self->pause_.async_wait([self](ErrorCode stopped) {
        if (!stopped && self->take_) self->Accept();
      });
      return;
    }
    ErrorCode ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    socket.non_blocking(true, ignored);
    self->take_(std::move(socket));
    self->Accept();
  });
}

}  // namespace ccmorse::servers
