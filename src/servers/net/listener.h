#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>

#include "servers/net/warning_limit.h"

namespace ccmorse::servers {

/// A listening socket that hands on every accepted one, non-blocking and without Nagle's delay, and
/// waits a little when the system has no more file handles, instead of asking without end. Works in
/// handlers of the io_context.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  using Taker = std::function<void(boost::asio::ip::tcp::socket)>;

  Listener(boost::asio::io_context& io, Taker take);

  /// Port 0 takes any free one. With `search`, taken ports are passed over. Throws Error that names
  /// address and port.
  void Open(const std::string& address, int port, bool search);
  /// Takes over a TCP socket that listens already; it is the listener's from now on. Throws Error
  /// when it is none.
  void Adopt(int socket);
  /// Of the open listener.
  int port() const;
  void Close();

 private:
  void Accept();

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  Taker take_;
  WarningLimit warnings_;
};

}  // namespace ccmorse::servers
