#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "servers/morse/service_directory.h"
#include "servers/player/device.h"
#include "servers/player/device_factory.h"
#include "servers/player/drivers/driver.h"
#include "servers/player/player_session.h"
#include "servers/protocol_server.h"
#include "sim/simulation.h"

namespace ccmorse::servers::player {

inline constexpr int kDefaultPort = 6665;

/// What one port serves.
struct PortSetup {
  int port = kDefaultPort;  ///< 0: any free one
  std::string name;         ///< for people: the robot's
  struct OfRobot {
    std::string robot;  ///< of the scenario; world devices ask for any
    DeviceDef device;
  };
  std::vector<OfRobot> devices;
  std::vector<DriverDef> drivers;  ///< each may require the devices of those before it
};

/// Where and within which limits Player's protocol is served. Beyond a limit the one connection
/// that breaks it suffers, with a line in the log; the simulation goes on.
struct PlayerServerOptions {
  bool listen = true;              ///< false: no port is opened, clients come by Connect() only
  std::string bind = "127.0.0.1";  ///< address to listen on
  /// Of the scenario's first robot; the n-th is on the port n - 1 higher. 0: any free ones.
  int port = kDefaultPort;
  /// Goes on without Player's protocol, with a warning, where a port is taken: by another
  /// simulation, if nobody has asked for this port.
  bool may_be_taken = false;
  std::size_t most_clients = 256;       ///< connections to each port
  std::size_t most_unread = 16U << 20;  ///< bytes of replies a client may leave unread
  SessionLimits session = {};
  /// What is served; where empty, a port for each robot with DefaultDevices().
  std::vector<PortSetup> setup = {};
};

/// Player's TCP protocol for one simulation (specs: player.md B; docs/protocols/player.md): one
/// port for each robot. Works in handlers of the io_context, on the thread that runs it, which must
/// be the thread that advances the simulation; each handler is short.
class PlayerServer : public ProtocolServer {
 public:
  /// Listens, unless the options say otherwise. Throws Error that names the port when it is taken
  /// (nullptr when it may be), and for a setup that cannot be. All references outlive the server.
  static std::unique_ptr<PlayerServer> Open(boost::asio::io_context& io,
                                            sim::Simulation& simulation,
                                            ServiceDirectory& directory,
                                            const PlayerServerOptions& options);
  ~PlayerServer() override;

  /// A client within this program of the port of `robot`, "" being the first: its end of the
  /// connection, a non-blocking stream socket that the caller closes. Any thread. Throws Error when
  /// there is no such robot, or no file handle.
  int Connect(const std::string& robot);

  /// A port and the robot behind it, in the scenario's order.
  struct Port {
    int port = 0;
    std::string robot;
  };
  std::vector<Port> ports() const;
  /// The devices of a port, for those within the program; by place in ports().
  const DeviceList& devices(std::size_t place) const;

  void Sensed() override;
  // A reader is a connection that has asked for data, as one does in the data mode PULL.
  int ReadersEver() const override;
  bool HasReaders() const override;
  bool ReadersAreWaiting() const override;
  bool AwaitsNext() const override;
  bool HasClients() const override;
  std::optional<TimePoint> WaitingSince() const override;
  std::optional<TimePoint> LetHangingGo(TimePoint waiting_since,
                                        std::chrono::steady_clock::duration limit) override;
  /// Player has no words for it: closes the connections of those who wait for data.
  void EndReads(const std::string& reason) override;
  void Close() override;

 private:
  struct Shared;
  class Connection;
  explicit PlayerServer(std::shared_ptr<Shared> shared);
  std::shared_ptr<Shared> shared_;
};

}  // namespace ccmorse::servers::player
