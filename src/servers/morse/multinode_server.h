#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>

namespace ccmorse::servers {

/// What runs between the simulators that share a scene (specs: morse.md A.7): each tells it in
/// every tick where its robots are, and is told of all others. Those that say how many they are to
/// be go in lock-step: nobody is answered before all of them have come and have told of the same
/// tick. Others, as MORSE's own nodes, are answered at once with what is known.
///
/// A client that sends what is no message is let go, with a line in the log; so is one that goes
/// away: the others go on without.
class MultinodeServer {
 public:
  /// Listens; port 0 takes any free one. Throws Error that names the port when it is taken.
  MultinodeServer(const std::string& bind, int port);
  ~MultinodeServer();
  MultinodeServer(const MultinodeServer&) = delete;
  MultinodeServer& operator=(const MultinodeServer&) = delete;

  int port() const;
  /// What it works in.
  boost::asio::io_context& io() { return io_; }
  /// Serves until Stop().
  void Run() { io_.run(); }
  /// From any thread.
  void Stop() { io_.stop(); }

 private:
  struct State;
  boost::asio::io_context io_;
  std::shared_ptr<State> state_;
};

}  // namespace ccmorse::servers
