#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "servers/morse/service_directory.h"
#include "sim/simulation.h"
#include "wire/fast_link.h"

namespace ccmorse::servers {

/// The simulator's side of one fast link (docs/protocols/fast-link.md): what a client has declared,
/// subscribed to and last sent as its canvas. Turns frames into calls of services, as lines are,
/// and writes the data of a read. Knows no socket. One thread.
class FastLinkSession : public std::enable_shared_from_this<FastLinkSession> {
 public:
  /// Called when a command, image or pixels failed, at once or, for a service that takes its time,
  /// later: the number of the service and what it said.
  using Refuse = std::function<void(std::uint16_t service, const Json& reason)>;

  /// Both outlive the session. Made by make_shared.
  FastLinkSession(sim::Simulation& simulation, ServiceDirectory& directory, Refuse refuse);

  /// Takes kCommand, kDeclare, kSubscribe, kImage or kPixels. False when it is none of these or
  /// its payload is broken: the connection is of no use any more.
  bool Take(const wire::Frame& frame);

  /// Appends the frame that answers a read: every subscribed device's data.
  void AppendData(std::string& out, double time);

  struct Subscription {
    std::uint16_t id = 0;
    wire::DataForm form = wire::DataForm::kText;
    sim::Sensor* sensor = nullptr;
  };
  /// At most one for each sensor of the simulation.
  const std::vector<Subscription>& subscriptions() const { return subscriptions_; }

 private:
  struct Declared {
    ServiceDirectory::Target target;
    std::string name;      // of the service, as it was declared
    sim::Completion done;  // made once, so that a call needs no memory
  };

  bool TakeCommand(std::string_view payload);
  bool TakeDeclare(std::string_view payload);
  bool TakeSubscribe(std::string_view payload);
  bool TakeImage(std::string_view payload);
  bool TakePixels(std::string_view payload);
  const Declared* Find(std::uint16_t service) const;  // nullptr: never declared
  void RunBytes(const Declared& declared, std::string_view bytes);

  sim::Simulation& simulation_;
  ServiceDirectory& directory_;
  Refuse refuse_;
  std::vector<std::unique_ptr<Declared>> declared_;  // by number; nullptr where there is none
  std::vector<Subscription> subscriptions_;
  // The canvas as the client last sent it.
  std::vector<std::uint8_t> image_;
  int image_width_ = 0;
  int image_height_ = 0;
  // Scratch, so that a round needs no memory.
  Json::Array arguments_;
  std::vector<double> numbers_;
  std::string plain_;
};

}  // namespace ccmorse::servers
