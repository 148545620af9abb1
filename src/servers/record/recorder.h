#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "servers/record/component_hashes.h"
#include "servers/record/record_format.h"
#include "servers/run_watcher.h"
#include "sim/simulation.h"
#include "wire/mcap.h"

namespace ccmorse::servers {

struct RecordOptions {
  /// Data beside what a replay needs: "none"; or a list, parted by commas, of "poses" (where robots
  /// are, and the scene, for a viewer), "all" (that and every sensor), a sensor ("s1r.hokuyo") or
  /// the sensors of one name on every robot ("hokuyo").
  std::string data = "poses";
  /// Hashes every so many ticks, the state's own among them; without it those of the components
  /// every tick.
  std::optional<std::uint64_t> hash_every;
  /// The run is a contest (ServiceDirectory::set_contest()).
  bool contest = false;
};

/// Writes the record of a run (docs/records.md). Equal runs give equal bytes: no wall-clock time,
/// no path and no port is in it. Once the disk is full it says so in the log and stops recording;
/// the run goes on. Not thread safe.
class Recorder : public RunWatcher {
 public:
  /// Begins the file with the simulation's scenario; an existing one is replaced. The simulation
  /// outlives the recorder and has not ticked yet. Throws Error: the file, or an unknown sensor.
  Recorder(const sim::Simulation& simulation, std::string file, const RecordOptions& options);
  /// Without Ended() the record counts as broken off; what was recorded so far is in it.
  ~Recorder() override;

  void Sensed() override;
  bool WantsInputs() const override { return true; }
  void Incoming(const Input& input) override;
  void Acted() override;
  void Ended(bool sensed) override;

  const std::string& file() const { return file_; }
  std::uint64_t bytes() const { return writer_->bytes(); }  ///< of the file
  /// Why the record is incomplete; "" while it is not.
  const std::string& failure() const { return failure_; }

 private:
  struct SensorTopic {
    std::uint16_t channel = 0;
    void (*write)(std::string& out, sim::Sensor& sensor, std::uint64_t log_time) = nullptr;
  };

  void AddSensor(sim::Sensor& sensor);
  std::uint16_t AddTopic(std::string_view topic, std::string_view schema);
  void WriteStart();
  void WriteScene();
  void WriteTransforms();
  template <typename Action>
  void Try(Action action);
  std::uint64_t Now() const;  // ns

  const sim::Simulation& simulation_;
  std::string file_;
  RecordOptions options_;
  std::ofstream stream_;
  std::unique_ptr<wire::McapWriter> writer_;
  std::map<std::string_view, std::uint16_t> schemas_;  // name of record_format.h -> id
  std::uint16_t input_ = 0;                            // topics
  std::uint16_t hash_ = 0;
  std::uint16_t end_ = 0;
  std::uint16_t transforms_ = 0;  // 0: not wanted
  std::unordered_map<const sim::Sensor*, SensorTopic> sensors_;
  std::uint64_t ticks_per_transform_ = 1;
  ComponentHasher hasher_;
  std::uint64_t input_tick_ = 0;  // of the input before
  std::int64_t input_order_ = 0;  // of the next one in that tick
  std::string text_;              // scratch: the message
  std::string failure_;
  bool ended_ = false;
};

}  // namespace ccmorse::servers
