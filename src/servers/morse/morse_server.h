#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "servers/morse/service_directory.h"
#include "servers/protocol_server.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// Where and within which limits MORSE's protocol is served. Beyond a limit the one connection that
/// breaks it suffers, with a line in the log; the simulation goes on.
struct MorseServerOptions {
  /// False: no port is opened, neither for services nor for streams; clients come by Connect()
  /// only.
  bool listen = true;
  std::string bind = "127.0.0.1";  ///< address to listen on
  int port = 4000;                 ///< of the services; 0: any free one
  /// A TCP socket of this process that listens already, in place of bind and port; -1: none.
  int listen_socket = -1;
  int first_stream_port = 60000;   ///< streams take the next free ports from here; 0: any free ones
  std::size_t most_clients = 256;  ///< connections to the service port
  std::size_t most_stream_clients = 512;        ///< connections to all stream ports together
  std::size_t longest_request = 1U << 20;       ///< bytes of one line to the service port
  std::size_t longest_stream_line = 64U << 10;  ///< bytes of one line to an actuator's stream
  std::size_t most_unread = 16U << 20;          ///< bytes of replies a client may leave unread
};

/// MORSE's socket middleware for one simulation (specs: morse.md A): services on one port, a stream
/// port for each component that has one, the services of docs/protocols/ccmorse-services.md, and
/// the fast link for clients that ask for it (docs/protocols/fast-link.md). It
/// does its work in handlers of the io_context, on the thread that runs it, which must be the
/// thread that advances the simulation; each handler is short.
class MorseServer : public ProtocolServer {
 public:
  /// What `ccmorse hello` tells of the run.
  struct Pace {
    std::string name = "realtime";  ///< "realtime", "lockstep" or "max"
    double read_frequency = 10.0;   ///< Hz of simulated time
    /// Real time: when the newest data were due, what `ccmorse clock` tells of it; else null.
    std::function<Json()> clock = {};
  };

  /// Listens, unless the options say otherwise. Throws Error that names the port when it is taken.
  /// The directory outlives the server; its control's stream_port is to ask StreamPort().
  MorseServer(boost::asio::io_context& io, sim::Simulation& simulation, ServiceDirectory& directory,
              const Pace& pace, const MorseServerOptions& options);
  ~MorseServer() override;

  /// A client of the services within this program: its end of the connection, a non-blocking stream
  /// socket that the caller closes. Any thread. Throws Error when there are no file handles.
  int Connect();

  int port() const;  ///< of the services; 0 when it does not listen
  /// Lowest and highest port of the streams; 0 and 0 without any.
  std::pair<int, int> stream_ports() const;
  /// Of a component's stream; 0 when it has none.
  int StreamPort(const sim::Component& component) const;
  void Close() override;

  /// Sends the streams, and answers each `read` whose time has come.
  void Sensed() override;
  /// Gives actuators the newest line of their streams.
  void ApplyInputs() override;

  // A reader is a connection that has sent a `read`.
  int ReadersEver() const override;
  bool HasReaders() const override;
  bool ReadersAreWaiting() const override;
  bool AwaitsNext() const override;
  /// Is any client connected, to the services or to a stream?
  bool HasClients() const override;
  std::optional<TimePoint> WaitingSince() const override;
  std::optional<TimePoint> LetHangingGo(TimePoint waiting_since,
                                        std::chrono::steady_clock::duration limit) override;
  /// Answers every `read` with FAILED `reason`.
  void EndReads(const std::string& reason) override;

  /// How many samples of a sensor clients have fetched by get_local_data or a stream, each once.
  std::uint64_t SamplesUsed(const std::string& full_name) const;

 private:
  struct Shared;
  class ServiceConnection;
  class Stream;
  std::shared_ptr<Shared> shared_;
};

}  // namespace ccmorse::servers
