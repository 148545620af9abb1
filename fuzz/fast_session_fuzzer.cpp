// FastLinkSession over a simulation: the input is a stream of frames, between which a `kRead` lets
// the simulation go on by a tick. What must hold: no frame harms anything, data can be written at
// any time and read again, and a frame that is turned down ends the session as it would end a
// connection.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz/check.h"
#include "scene/scenario.h"
#include "servers/fast_link/fast_link_session.h"
#include "servers/morse/service_directory.h"
#include "sim/simulation.h"
#include "wire/fast_link.h"

namespace {

namespace wire = ccmorse::wire;
using ccmorse::fuzz::Require;

constexpr int kMostFrames = 60;

ccmorse::servers::RunControl Control() {
  ccmorse::servers::RunControl control;
  control.stream_port = [](const ccmorse::sim::Component&) { return 0; };
  control.quit = [] {};
  control.time_mode = [] { return std::string("Best Effort"); };
  control.time_statistics = [] { return ccmorse::Json(); };
  control.set_time_scale = [](double) { return true; };
  return control;
}

void CheckData(const std::string& out) {
  wire::FrameSplitter splitter(wire::kMostServerFrame);
  splitter.Append(out);
  wire::Frame frame;
  Require(splitter.Next(&frame) == wire::FrameSplitter::Result::kFrame &&
              frame.type == wire::FrameType::kData && splitter.buffered() == 0,
          "data are one frame");
  wire::ByteReader reader(frame.payload);
  reader.Double();
  wire::DataEntry entry;
  while (wire::NextDataEntry(reader, &entry)) {
    Require(entry.form != wire::DataForm::kNone, "data have a form");
  }
  Require(reader.ok() && reader.rest().empty(), "data are whole");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ccmorse::scene::Scenario scenario = ccmorse::scene::ParseScenario(
      R"({"world": {"name": "hall", "size": [4, 3], "boxes": [
           {"id": 1, "kind": "wall", "x": 2, "y": 0.05, "size": [4, 0.1], "height": 0.3,
            "color": "red"}]},
          "robots": [{"name": "a", "pose": {"x": 1, "y": 1}, "laser": {"samples": 9}}],
          "canvas": {"width": 8, "height": 6}, "time": {"frequency": 20}})",
      "small.json");
  ccmorse::sim::Simulation simulation(scenario);
  ccmorse::servers::ServiceDirectory directory(simulation, Control());
  const auto session = std::make_shared<ccmorse::servers::FastLinkSession>(
      simulation, directory, [](std::uint16_t, const ccmorse::Json& reason) {
        Require(reason.IsString() || reason.IsFalsy(), "a refusal's reason is text", reason.Dump());
      });
  wire::FrameSplitter splitter(wire::kMostClientFrame);
  splitter.Append(std::string(data, data + size));
  wire::Frame frame;
  simulation.Sense();
  for (int i = 0; i < kMostFrames; ++i) {
    if (splitter.Next(&frame) != wire::FrameSplitter::Result::kFrame) break;
    if (frame.type == wire::FrameType::kRead) {
      std::string out;
      session->AppendData(out, simulation.time());
      CheckData(out);
      simulation.Act();
      directory.TimeAdvanced();
      simulation.Sense();
    } else if (!session->Take(frame)) {
      break;
    }
  }
  Require(session->subscriptions().size() <= simulation.components().size(),
          "a device is subscribed to once");
  return 0;
}
