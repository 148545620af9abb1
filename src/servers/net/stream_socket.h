#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/system/error_code.hpp>
#include <cstddef>
#include <string>
#include <utility>

namespace ccmorse::servers {

using ErrorCode = boost::system::error_code;

/// A connection of whatever kind: over TCP, or between two threads of one program.
using StreamSocket = boost::asio::generic::stream_protocol::socket;

/// Bytes that are read from a connection at once.
inline constexpr std::size_t kReadBlock = std::size_t{64} << 10;

/// "127.0.0.1:40312", for the log.
std::string PeerName(const boost::asio::ip::tcp::socket& socket);

/// A connection within this program: the server's end, as a Listener hands sockets on, and the
/// client's, a non-blocking stream socket that the caller closes. Throws Error when the system has
/// no file handles left. Any thread.
std::pair<StreamSocket, int> ConnectedPair(boost::asio::io_context& io);

}  // namespace ccmorse::servers
