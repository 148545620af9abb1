#include "servers/player/player_server.h"

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <deque>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "base/nearest_name.h"
#include "scene/field.h"
#include "servers/net/listener.h"
#include "servers/net/outbox.h"
#include "servers/net/stream_socket.h"
#include "servers/net/waiting.h"
#include "servers/net/warning_limit.h"
#include "servers/player/device_factory.h"
#include "servers/player/drivers/localization.h"
#include "servers/player/drivers/snd_driver.h"
#include "servers/player/drivers/wavefront_driver.h"

namespace ccmorse::servers::player {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using Clock = std::chrono::steady_clock;

constexpr auto kTurn = std::chrono::milliseconds(1);  // of one connection before others get theirs
// Bytes on their way to a client, from which on its data wait in its queue, where replace rules and
// limits hold.
constexpr std::size_t kOnTheWay = 64U << 10;
constexpr const char* kVersion = "3.1.0";  // Player's, whose protocol this is

// A port for each robot, in the scenario's order.
std::vector<PortSetup> DefaultSetup(const sim::Simulation& simulation, int first_port) {
  std::vector<PortSetup> setups;
  for (const scene::RobotDef& def : simulation.scenario().robots) {
    PortSetup& setup = setups.emplace_back();
    setup.port = first_port == 0 ? 0 : first_port + static_cast<int>(setups.size()) - 1;
    setup.name = def.name;
    for (const DeviceDef& device : DefaultDevices()) setup.devices.push_back({def.name, device});
    setup.drivers.push_back(TruePlace(def.name));
    if (def.type == "S1R" && def.front == "laser") {
      const auto settings = def.drivers.find("snd");
      setup.drivers.push_back(
          SyrotekSnd(settings == def.drivers.end() ? Json::Object{} : settings->second.AsObject()));
      setup.drivers.push_back(SyrotekPlanner());
    }
  }
  return setups;
}

DriverDevice ToDriverDevice(const scene::PlayerAddress& address) {
  return {address.key, address.interface, address.index};
}

// What the scenario's "player" or a .cfg asks for (docs/scenario.md).
std::vector<PortSetup> SetupOf(const scene::PlayerSetup& wanted, const sim::Simulation& simulation,
                               bool any_port) {
  std::vector<PortSetup> setups;
  for (const int port : wanted.Ports()) {
    PortSetup& setup = setups.emplace_back();
    setup.port = any_port ? 0 : port;
    const auto robot_or_first = [&](const std::string& robot) {
      return robot.empty() ? simulation.robots().front()->name() : robot;
    };
    for (const scene::PlayerDevice& device : wanted.devices) {
      if (device.port != port) continue;
      if (setup.name.empty()) setup.name = device.robot;
      DeviceDef def{device.interface, device.index, device.device};
      setup.devices.push_back({robot_or_first(device.robot), def});
    }
    for (const scene::PlayerDriver& driver : wanted.drivers) {
      if (driver.provided.empty() || driver.provided.front().port != port) continue;
      if (!IsDriver(driver.name)) {
        LogWarning("{}driver '{}' is not supported; its devices are left out",
                   driver.places.empty() ? "" : driver.places.front() + ": ", driver.name);
        continue;
      }
      DriverDef& def = setup.drivers.emplace_back();
      def.name = driver.name;
      for (const auto& address : driver.provided) def.provided.push_back(ToDriverDevice(address));
      for (const auto& address : driver.needed) {
        if (!address.host.empty() || address.port != port) {
          throw Error("driver " + driver.name + " requires " + ToText(address) +
                      ": devices of other ports and hosts are not supported");
        }
        def.required.push_back(ToDriverDevice(address));
      }
      def.options = {driver.options, driver.length_unit, driver.angle_unit, driver.places};
      def.robot = robot_or_first(setup.name);
      def.always_on = driver.always_on;
    }
  }
  return setups;
}

}  // namespace

// What all connections use; it lives until the last handler of theirs has run.
struct PlayerServer::Shared {
  Shared(asio::io_context& io_in, sim::Simulation& simulation_in, ServiceDirectory& directory_in,
         const PlayerServerOptions& options_in)
      : io(io_in),
        simulation(simulation_in),
        context{simulation_in, directory_in},
        options(options_in) {}

  struct OpenPort {
    int number = 0;  // of the port; where it does not listen, the one that it would have
    std::string robot;
    DeviceList devices;
    std::vector<std::unique_ptr<Driver>> drivers;  // use the devices, so they go before them
    std::shared_ptr<Listener> listener;
    std::size_t clients = 0;
  };

  // A new client of a port, called `name` in the log.
  void Take(OpenPort& port, StreamSocket socket, std::string name);

  // Sends to all what is there for them. Connections may come to their end by it.
  void DeliverPending();

  asio::io_context& io;
  sim::Simulation& simulation;
  DeviceContext context;
  PlayerServerOptions options;
  std::deque<OpenPort> ports;
  std::vector<std::shared_ptr<Connection>> connections;  // in the order in which they came
  std::vector<std::shared_ptr<Connection>> told;         // scratch of DeliverPending()
  int readers_ever = 0;
  std::string ended;       // why data end, once the run is over
  bool always_on = false;  // a driver is
  WarningLimit warnings;
  bool closed = false;
};

// One client.
class PlayerServer::Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Shared& shared, Shared::OpenPort& port, StreamSocket socket, std::string name)
      : shared_(shared),
        port_(port),
        socket_(std::move(socket)),
        outbox_(socket_),
        session_(std::make_unique<PlayerSession>(
            port.devices, static_cast<std::uint32_t>(port.number),
            [&shared] { return shared.simulation.time(); }, shared.options.session)),
        name_(std::move(name)) {
    ++port_.clients;
  }

  void Start() {
    outbox_.text() += wire::Banner(kVersion);
    Flush();
    if (!left_) Read();
  }

  bool reads() const { return session_ != nullptr && session_->reads(); }
  bool waits() const { return session_ != nullptr && session_->waits(); }
  bool AwaitsDataAt(double time) const {
    return session_ != nullptr && session_->AwaitsDataAt(time);
  }
  Clock::time_point waits_since() const { return waits_since_; }
  Clock::time_point heard() const { return heard_; }
  const std::string& name() const { return name_; }

  bool pending() const { return session_ != nullptr && session_->pending(); }

  // Sends what may be sent. The connection may come to its end by it.
  void Deliver() {
    if (left_ || outbox_.size() > kOnTheWay) return;
    session_->Deliver(outbox_.text());
    Flush();
  }

  void Leave() {
    if (left_) return;
    left_ = true;
    const auto self = shared_from_this();
    session_ = nullptr;  // unsubscribes: what it drove stops
    --port_.clients;
    ErrorCode ignored;
    socket_.close(ignored);
    std::erase(shared_.connections, self);
  }

 private:
  void Read() {
    reading_ = true;
    block_.resize(kReadBlock);
    socket_.async_read_some(asio::buffer(block_),
                            [self = shared_from_this()](ErrorCode error, std::size_t size) {
                              self->reading_ = false;
                              if (self->left_) return;
                              if (error) return self->Leave();
                              self->heard_ = Clock::now();
                              self->session_->Take({self->block_.data(), size});
                              self->Process();
                            });
  }

  // Serves messages until there are no more, the client's replies pile up or it had its turn.
  void Process() {
    const auto until = Clock::now() + kTurn;
    bool more = false;
    const bool read_before = session_->reads();
    const bool waited_before = session_->waits();
    while (outbox_.size() + session_->queued_bytes() <= shared_.options.most_unread) {
      if (!session_->ServeNext()) break;
      if (Clock::now() > until) {
        more = true;
        break;
      }
    }
    if (session_->broken()) {
      shared_.warnings.Warn("Player client {} sent what is no message: it is let go", name_);
      return Leave();
    }
    if (!read_before && session_->reads()) ++shared_.readers_ever;
    Deliver();
    // What came may have been for others.
    shared_.DeliverPending();
    if (left_) return;
    if (!waited_before && session_->waits()) {
      waits_since_ = Clock::now();
      // Nothing will come any more; the client's Read() fails, as when a server has gone.
      if (!shared_.ended.empty()) return Leave();
    }
    if (more) {
      if (turn_posted_) return;
      turn_posted_ = true;
      asio::post(shared_.io, [self = shared_from_this()] {
        self->turn_posted_ = false;
        if (!self->left_) self->Process();
      });
      return;
    }
    if (!reading_ && outbox_.size() <= shared_.options.most_unread) Read();
  }

  void Flush() {
    outbox_.Flush(shared_from_this(), [this](ErrorCode error) {
      if (left_) return;
      if (error) return Leave();
      Process();
    });
  }

  Shared& shared_;
  Shared::OpenPort& port_;
  StreamSocket socket_;
  Outbox outbox_;
  std::unique_ptr<PlayerSession> session_;  // until it has left
  std::string name_;
  std::vector<char> block_;
  Clock::time_point waits_since_{};
  Clock::time_point heard_ = Clock::now();
  bool reading_ = false;
  bool turn_posted_ = false;
  bool left_ = false;
};

void PlayerServer::Shared::Take(OpenPort& port, StreamSocket socket, std::string name) {
  if (port.clients >= options.most_clients) {
    warnings.Warn("more than {} Player clients of {}, one was refused", options.most_clients,
                  port.robot);
    return;
  }
  const auto connection =
      std::make_shared<Connection>(*this, port, std::move(socket), std::move(name));
  connections.push_back(connection);
  connection->Start();
}

void PlayerServer::Shared::DeliverPending() {
  for (const auto& connection : connections) {
    if (connection->pending()) told.push_back(connection);
  }
  for (const auto& connection : told) connection->Deliver();
  told.clear();
}

PlayerServer::PlayerServer(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

std::unique_ptr<PlayerServer> PlayerServer::Open(asio::io_context& io, sim::Simulation& simulation,
                                                 ServiceDirectory& directory,
                                                 const PlayerServerOptions& options) {
  std::unique_ptr<PlayerServer> server(
      new PlayerServer(std::make_shared<Shared>(io, simulation, directory, options)));
  Shared& shared = *server->shared_;
  for (const PortSetup& setup :
       !options.setup.empty() ? options.setup
       : simulation.scenario().player
           ? SetupOf(*simulation.scenario().player, simulation, options.port == 0)
           : DefaultSetup(simulation, options.port)) {
    const int number = setup.port;
    Shared::OpenPort& port = shared.ports.emplace_back();
    port.robot = setup.name;
    for (const auto& [name, device] : setup.devices) {
      const sim::Robot* const robot = simulation.FindRobot(name);
      if (robot == nullptr) throw Error("Player's devices: there is no robot '" + name + "'");
      auto made = MakeDevice(shared.context, *robot, device);
      if (made != nullptr) port.devices.Add(std::move(made));
    }
    for (const DriverDef& def : setup.drivers) {
      try {
        auto driver = MakeDriver(def, shared.context, port.devices);
        for (const auto& [option, value] : def.options.values) {
          if (def.options.asked.contains(option)) continue;
          LogWarning("{}'{}' of driver {} has no effect", def.options.Place(option), option,
                     def.name);
        }
        for (const auto& device : driver->provided()) port.devices.Add(device);
        if (def.always_on) {
          driver->KeepOn(true);
          shared.always_on = true;
        }
        port.drivers.push_back(std::move(driver));
      } catch (const Error& error) {
        if (!def.may_fail) throw;
        LogWarning("{}: no driver {} for Player's clients: {}", setup.name, def.name, error.what());
      }
    }
    port.number = number;
    if (!options.listen) continue;
    port.listener = std::make_shared<Listener>(io, [&shared, &port](tcp::socket socket) {
      std::string name = PeerName(socket);
      shared.Take(port, std::move(socket), std::move(name));
    });
    try {
      if (number > 65535) throw Error("there are no such ports");
      port.listener->Open(options.bind, number, false);
      port.number = port.listener->port();
    } catch (const Error&) {
      if (!options.may_be_taken) {
        throw Error("Player's protocol: cannot listen on " + options.bind + " port " +
                    std::to_string(number) + ", perhaps because another simulation runs there; " +
                    "choose another with --player-port, or none with --no-player");
      }
      LogWarning(
          "Player's protocol is not served: port {} of {} is taken, perhaps by another "
          "simulation; choose another with --player-port",
          number, options.bind);
      server->Close();
      return nullptr;
    }
  }
  return server;
}

PlayerServer::~PlayerServer() { Close(); }

std::vector<PlayerServer::Port> PlayerServer::ports() const {
  std::vector<Port> ports;
  for (const auto& port : shared_->ports) ports.push_back({port.number, port.robot});
  return ports;
}

int PlayerServer::Connect(const std::string& robot) {
  Shared::OpenPort* found = nullptr;
  std::vector<std::string> known;
  for (auto& port : shared_->ports) {
    known.push_back(port.robot);
    if (found == nullptr && (robot.empty() || port.robot == robot)) found = &port;
  }
  if (found == nullptr) {
    throw Error("Player's protocol is not served for a robot " + scene::Quoted(robot) +
                DidYouMean(robot, known) + "; it is for " + scene::Listed(known));
  }
  auto [server, client] = ConnectedPair(shared_->io);
  asio::post(shared_->io, [shared = shared_, found, socket = std::move(server)]() mutable {
    if (!shared->closed) shared->Take(*found, std::move(socket), "this program");
  });
  return client;
}

const DeviceList& PlayerServer::devices(std::size_t place) const {
  return shared_->ports.at(place).devices;
}

void PlayerServer::Sensed() {
  if (shared_->connections.empty() && !shared_->always_on) return;
  for (const auto& port : shared_->ports) {
    for (const auto& device : port.devices.all()) {
      if (device->subscribed()) device->Step();
    }
    for (const auto& driver : port.drivers) {
      if (driver->works()) driver->Step();
    }
  }
  shared_->DeliverPending();
}

int PlayerServer::ReadersEver() const { return shared_->readers_ever; }

bool PlayerServer::HasReaders() const {
  return std::any_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return c->reads(); });
}

bool PlayerServer::ReadersAreWaiting() const {
  return std::all_of(shared_->connections.begin(), shared_->connections.end(),
                     [](const auto& c) { return !c->reads() || c->waits(); });
}

bool PlayerServer::AwaitsNext() const {
  const auto& simulation = shared_->simulation;
  const double next = simulation.time() + 1.0 / simulation.scenario().time.frequency;
  return std::any_of(shared_->connections.begin(), shared_->connections.end(),
                     [next](const auto& c) { return c->AwaitsDataAt(next); });
}

bool PlayerServer::HasClients() const { return !shared_->connections.empty(); }

std::optional<PlayerServer::TimePoint> PlayerServer::WaitingSince() const {
  return servers::WaitingSince(shared_->connections);
}

std::optional<PlayerServer::TimePoint> PlayerServer::LetHangingGo(TimePoint waiting_since,
                                                                  Clock::duration limit) {
  return servers::LetHangingGo(shared_->connections, waiting_since, limit, "Player client");
}

void PlayerServer::EndReads(const std::string& reason) {
  shared_->ended = reason;
  const auto connections = shared_->connections;
  for (const auto& connection : connections) {
    if (connection->waits()) connection->Leave();
  }
}

void PlayerServer::Close() {
  if (shared_->closed) return;
  shared_->closed = true;
  for (const auto& port : shared_->ports) {
    if (port.listener != nullptr) port.listener->Close();
  }
  const auto connections = shared_->connections;
  for (const auto& connection : connections) connection->Leave();
  for (const auto& port : shared_->ports) {
    for (const auto& driver : port.drivers) driver->KeepOn(false);
  }
  // Handlers of the closed sockets still refer to what is ours: let them run before it goes.
  shared_->io.restart();
  shared_->io.poll();
}

}  // namespace ccmorse::servers::player
