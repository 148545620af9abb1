#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "servers/morse/service_directory.h"
#include "servers/run_watcher.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// A record that is shown in place of a run.
struct ShownRecord {
  std::string file;
  double seconds = 0.0;  ///< how long it is, simulated
};

/// Where and within which limits the view is served.
struct WebServerOptions {
  std::string bind = "127.0.0.1";  ///< address to listen on; any other than loopback needs a token
  int port = 8000;                 ///< 0: any free one
  bool search = true;              ///< take the next free port where `port` is taken
  std::string token;       ///< what the page's address must carry as ?token=; empty: nothing
  bool read_only = false;  ///< viewers only look
  /// Where given, viewers only control the time.
  std::optional<ShownRecord> record = {};
  std::string folder;                    ///< of the built page: index.html and what it loads
  std::size_t most_viewers = 64;         ///< at a time; more are answered 503
  std::size_t longest_call = 64U << 10;  ///< bytes of a message from a viewer
};

/// The live view (docs/view.md): a web server for the page and, over a WebSocket, what it shows
/// (docs/protocols/view.md). Viewers call the services of the ServiceDirectory, so what they do is
/// an input like any other and goes into a record.
///
/// A viewer gets a frame when something has happened, 60 times a second at most, and none before it
/// has confirmed the last but one: a slow one skips frames. A page of another site cannot talk to
/// it: Origin and Host are checked. Works in handlers of `io`, on the simulation's thread.
class WebServer : public RunWatcher {
 public:
  /// Everything outlives the server. Throws Error that names the port when it is taken, and when
  /// `bind` needs a token.
  WebServer(boost::asio::io_context& io, const sim::Simulation& simulation,
            ServiceDirectory& directory, const WebServerOptions& options);
  ~WebServer() override;
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  int port() const;
  /// What to type into a browser, "http://127.0.0.1:8000/".
  std::string address() const;

  /// Shows another simulation of the same scenario from now on, or the same at another time. Both
  /// outlive the server, or the next call.
  void Show(const sim::Simulation& simulation, ServiceDirectory& directory);

  /// Sends the frames that are due. While time stands still, there are some without this.
  void Acted() override;
  void Close();

 private:
  struct Shared;
  class Session;
  class Viewer;
  std::shared_ptr<Shared> shared_;
};

/// Is it this machine only: "localhost", "127.0.0.1", "::1"?
bool IsLoopback(const std::string& host);

/// The folder of the built page: $CCMORSE_WEB, ../share/ccmorse/web from the program's folder, or
/// web/dist of the source tree; empty when there is none.
std::string FindWebFolder();

}  // namespace ccmorse::servers
