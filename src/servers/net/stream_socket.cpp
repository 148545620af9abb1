#include "servers/net/stream_socket.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "base/error.h"

namespace ccmorse::servers {

namespace asio = boost::asio;

std::string PeerName(const asio::ip::tcp::socket& socket) {
  ErrorCode ignored;
  const asio::ip::tcp::endpoint peer = socket.remote_endpoint(ignored);
  return peer.address().to_string() + ":" + std::to_string(peer.port());
}

std::pair<StreamSocket, int> ConnectedPair(asio::io_context& io) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends.data()) != 0) {
    throw Error("cannot connect within the program: " + std::system_category().message(errno));
  }
  StreamSocket server(io, asio::generic::stream_protocol(AF_UNIX, 0), ends[0]);
  ErrorCode ignored;
  server.non_blocking(true, ignored);
  return {std::move(server), ends[1]};
}

}  // namespace ccmorse::servers
