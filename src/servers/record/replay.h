#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "scene/scenario.h"
#include "servers/morse/service_directory.h"
#include "servers/record/component_hashes.h"
#include "sim/simulation.h"
#include "wire/mcap.h"

namespace ccmorse::servers {

/// A file that is no record, or one that cannot be trusted. what() names the file and says why.
class RecordError : public Error {
 public:
  using Error::Error;
};

/// What a record says of its run.
struct RecordInfo {
  std::string version;  ///< of the ccmorse that wrote it
  scene::Scenario scenario;
  std::uint64_t ticks = 0;       ///< how many can be simulated again
  std::uint64_t hash_every = 1;  ///< ticks from one hash to the next
  bool contest = false;          ///< calls were refused (ServiceDirectory::set_contest())
  bool complete = false;         ///< false: the run was killed, and the record's end is missing
  // Of a complete one only:
  bool sensed = false;     ///< the sensors took one more look after the last tick
  std::uint64_t hash = 0;  ///< Simulation::Hash() at the end
};

/// Reads a whole record and checks every byte of it. Throws RecordError.
RecordInfo ReadRecordInfo(const std::string& file);

/// The first thing in which a replay is not its record.
struct Difference {
  std::uint64_t first_tick = 0;  ///< between these two ticks, both included, it came about;
  std::uint64_t last_tick = 0;   ///< the same where the record has the hash of every tick
  std::string component;         ///< "s1r.hokuyo", "canvas", "s1r"; "" for the state as a whole
  std::string driver;            ///< of a robot: the actuator that moves it; else ""
  std::string recorded;          ///< what the record says: a hash, or that there is none
  std::string simulated;
  std::size_t others = 0;  ///< components that differ in the same tick
};

/// Simulates a recorded run again from its scenario and inputs, tick by tick, and compares it with
/// the record's hashes as it goes: what a viewer shows of a record, and how a record is verified.
/// Sensors take their samples anew, so a replay shows more than was recorded. Not thread safe.
class Replay {
 public:
  /// Opens a record at its start. Throws RecordError, as all methods do when the file changes under
  /// their hands.
  ///
  /// `control` is what the replay's directory() gives those who ask it for the time; a record's
  /// inputs never do.
  explicit Replay(const std::string& file, RunControl control = {});

  const RecordInfo& info() const { return info_; }
  double duration() const;  ///< s of simulated time

  /// The run at the current tick; stays valid until a Seek() to an earlier time.
  const sim::Simulation& simulation() const { return *simulation_; }

  /// The services of simulation(), for questions: what else is called makes it another run. Valid
  /// as long as simulation().
  ServiceDirectory& directory() { return *directory_; }

  /// One tick further; false, and nothing happens but that what came after the last tick is
  /// applied, at the end.
  bool Step();

  /// To the tick at `seconds` of simulated time, cut to [0, duration()]: exactly the state that the
  /// run had then. Backwards it starts again from the beginning.
  void Seek(double seconds);

  /// How what was replayed so far differs from the record; nothing when it does not.
  const std::optional<Difference>& difference() const { return difference_; }

 private:
  void Start();
  void ReadMessage();
  void ApplyInputs();
  void Compare();
  std::optional<Difference> CompareHashes();
  void Finish();
  [[noreturn]] void Fail(const std::string& what) const;

  std::string file_;
  RunControl control_;
  RecordInfo info_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<ServiceDirectory> directory_;
  std::unique_ptr<ComponentHasher> hasher_;
  std::unique_ptr<std::ifstream> stream_;
  std::unique_ptr<wire::McapReader> reader_;
  Json message_;                    // the next input or hash; null at the end
  bool message_is_input_ = false;   // what it is
  std::uint64_t message_tick_ = 0;  // when it is due
  bool finished_ = false;
  std::uint64_t compared_tick_ = 0;  // of the last comparison
  std::optional<Difference> difference_;
};

}  // namespace ccmorse::servers
