#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>

namespace ccmorse::servers {

/// MORSE's port of time synchronisation (specs: morse.md A.6): while a client is connected, every
/// tick waits until bytes come from it; what they are does not matter, and what one recv() of 2048
/// bytes brings is one tick. When the client leaves, time goes on by itself. A client that comes
/// while there is one waits until that one has left. Works in handlers of the io_context, on the
/// thread that runs it.
class SyncPort {
 public:
  /// Listens; port 0 takes any free one. Throws Error that names the port when it is taken.
  SyncPort(boost::asio::io_context& io, const std::string& bind, int port);
  ~SyncPort();
  SyncPort(const SyncPort&) = delete;
  SyncPort& operator=(const SyncPort&) = delete;

  int port() const;

  /// Is there a client whose bytes are to be waited for?
  bool connected() const;

  /// Takes what has come, up to 2048 bytes: the next tick may be. False while nothing has come;
  /// then something happens in the io_context when it does.
  bool TakeTick();

  void Close();

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace ccmorse::servers
