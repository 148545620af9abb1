// PlayerSession over a simulation with all the devices that a robot serves: the input is a stream
// of Player's messages; whatever asks for data lets the simulation go on by a tick. What must hold:
// no message harms anything, what the session writes is a stream of whole messages, rounds end with
// a SYNCH only after data, and the queue stays within its limit.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/check.h"
#include "scene/scenario.h"
#include "servers/morse/service_directory.h"
#include "servers/player/device_factory.h"
#include "servers/player/player_session.h"
#include "sim/simulation.h"
#include "wire/player/frame.h"

namespace {

namespace player = ccmorse::servers::player;
namespace wire = ccmorse::wire::player;
using ccmorse::fuzz::Require;
using wire::MessageType;

constexpr int kMostMessages = 60;

ccmorse::servers::RunControl Control() {
  ccmorse::servers::RunControl control;
  control.stream_port = [](const ccmorse::sim::Component&) { return 0; };
  control.quit = [] {};
  control.time_mode = [] { return std::string("Best Effort"); };
  control.time_statistics = [] { return ccmorse::Json(); };
  control.set_time_scale = [](double) { return true; };
  return control;
}

// Reads what the session has written. `data`: have any come since the last SYNCH?
void Check(const std::string& out, bool& data) {
  wire::FrameReader reader;
  reader.Append(out);
  std::size_t size = 0;
  while (const auto message = reader.Next()) {
    size += wire::kHeaderSize + message->body.size();
    const wire::Header& header = message->header;
    if (header.type == MessageType::kData) {
      data = true;
      Require(header.time > 0.0, "data are stamped later than 0");
      Require(wire::Recode(header.address.interf, header.type, header.subtype, message->body)
                  .has_value(),
              "data are what their interface says");
    }
    if (header.type == MessageType::kSynch) {
      Require(data, "a SYNCH comes after data only");
      data = false;
    }
  }
  Require(size == out.size() && !reader.broken(), "messages are whole");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ccmorse::scene::Scenario scenario = ccmorse::scene::ParseScenario(
      R"({"world": {"name": "hall", "size": [4, 3], "boxes": [
           {"id": 1, "kind": "wall", "x": 2, "y": 0.05, "size": [4, 0.1], "height": 0.3,
            "color": "red"}]},
          "robots": [{"name": "a", "pose": {"x": 1, "y": 1}, "laser": {"samples": 9}, "ir": {},
                      "sonar": {}}],
          "canvas": {"width": 8, "height": 6}, "time": {"frequency": 20}})",
      "small.json");
  ccmorse::sim::Simulation simulation(scenario);
  ccmorse::servers::ServiceDirectory directory(simulation, Control());
  const player::DeviceContext context{simulation, directory};
  player::DeviceList devices;
  for (const player::DeviceDef& def : player::DefaultDevices()) {
    auto device = player::MakeDevice(context, *simulation.robots()[0], def);
    if (device != nullptr) devices.Add(std::move(device));
  }
  {
    player::PlayerSession session(devices, 6665, [&] { return simulation.time(); });
    bool data_seen = false;
    session.Take({reinterpret_cast<const char*>(data), size});
    simulation.Sense();
    for (int i = 0; i < kMostMessages && session.ServeNext(); ++i) {
      std::string out;
      session.Deliver(out);
      if (session.waits() || i % 4 == 3) {
        simulation.Act();
        directory.TimeAdvanced();
        simulation.Sense();
        for (const auto& device : devices.all()) {
          if (device->subscribed()) device->Step();
        }
        session.Deliver(out);
      }
      Check(out, data_seen);
      Require(session.queued() <= player::SessionLimits{}.most_queued + 1, "the queue is limited");
    }
  }
  for (const auto& device : devices.all()) {
    Require(!device->subscribed(), "a session that ends leaves nothing behind");
  }
  return 0;
}
