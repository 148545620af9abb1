#pragma once

#include <atomic>
#include <exception>
#include <string>
#include <thread>

#include "libCCMorse/MorseValue.h"

namespace CCMorse {

class PlayerClient;

/// Base of drivers: algorithms that take control of the robot in a thread of their own (thesis
/// 3.1.3). A driver derives, writes Main(), and calls Stop() and Join() in its own destructor,
/// because its members are gone when this class's destructor runs. Owned by the program. Start(),
/// Stop() and Join() are for one thread at a time; the rest for any.
class MorseDriver {
 public:
  /// `name`: under which the robot's configuration has the driver's settings, "snd"; `robot`: name
  /// of the robot, empty for the first. Throws MorseError when there is no such robot.
  MorseDriver(PlayerClient* client, std::string name, const std::string& robot = "");
  virtual ~MorseDriver();
  MorseDriver(const MorseDriver&) = delete;
  MorseDriver& operator=(const MorseDriver&) = delete;

  const std::string& GetName() const { return name_; }  ///< as given to the constructor
  /// The driver's settings in the robot's configuration (thesis 3.2); null when there are none.
  const MorseValue& GetConfiguration() const { return configuration_; }

  /// Runs Main() in a new thread. Throws MorseError when it runs already.
  void Start();
  /// Asks Main() to end, and returns at once.
  void Stop();
  /// Waits until Main() has ended; throws what it threw. Nothing happens without a thread.
  void Join();
  /// Whether Main() runs.
  bool IsRunning() const { return running_; }

 protected:
  /// The driver's work; ends soon after StopRequested().
  virtual void Main() = 0;
  /// Whether Stop() was called since Start().
  bool StopRequested() const { return stop_; }
  /// The client given to the constructor.
  PlayerClient* GetPlayerClient() const { return client_; }

 private:
  PlayerClient* const client_;
  const std::string name_;
  MorseValue configuration_;
  std::thread thread_;
  std::atomic<bool> running_{false};
  std::atomic<bool> stop_{false};
  std::exception_ptr error_;  // of Main(); read after the join
};

}  // namespace CCMorse
