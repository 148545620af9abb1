#pragma once

#include <memory>
#include <string>

struct CcmorseSim;

namespace CCMorse::core {

/// A simulation within the program, behind libccmorse-sim, which is opened when the first is asked
/// for. Addresses that differ in `protocol` and `robot` only mean the same simulation as long as
/// somebody holds it. It ends with the last who does; when the program exits before, it ends then.
/// Any thread.
class InProcess {
 public:
  /// Throws MorseError from `function`: no library, another version of it, or what the simulator
  /// says of scenario and options.
  static std::shared_ptr<InProcess> Open(const std::string& simulation, const char* function);
  /// See Open().
  explicit InProcess(CcmorseSim* simulation) : simulation_(simulation) {}
  ~InProcess();
  InProcess(const InProcess&) = delete;
  InProcess& operator=(const InProcess&) = delete;

  /// A connection, a stream socket that the caller closes; see ccmorse_sim_connect(). Throws
  /// MorseError from `function`.
  int Connect(const std::string& protocol, const std::string& robot, const char* function);

 private:
  CcmorseSim* const simulation_;
};

/// A connection to a simulation within the program.
struct InProcessSocket {
  std::shared_ptr<InProcess> simulation;  ///< to be held as long as the connection
  int handle = -1;                        ///< the caller closes it, then lets the simulation go
};

/// Connects to the address "sim:..."; `player`: it has to speak Player's protocol, else MORSE's.
/// Throws MorseError from `function`.
InProcessSocket ConnectInProcess(const std::string& address, bool player, const char* function);

}  // namespace CCMorse::core
