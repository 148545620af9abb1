#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ccmorse::test {

/// A simulator that follows a script: it listens on a port of its own on 127.0.0.1, answers as
/// MORSE or ccmorse would with S1R robots, and notes every line that comes in. It runs a thread of
/// its own; every method may be called from any thread.
class FakeServer {
 public:
  struct Options {
    bool ccmorse = true;                     ///< false: plain MORSE, which knows no `ccmorse`
    std::string pace = "lockstep";           ///< what `hello` tells
    std::vector<std::string> robots{"s1r"};  ///< each with the devices of an S1R
    bool properties = true;                  ///< whether robots carry RobotProperties
    bool pen = true;                         ///< whether the first robot carries a pen
    /// Further devices of the first robot: name, type.
    std::vector<std::pair<std::string, std::string>> extra;
  };

  FakeServer();
  explicit FakeServer(Options options);
  ~FakeServer();
  FakeServer(const FakeServer&) = delete;
  FakeServer& operator=(const FakeServer&) = delete;

  int port() const;

  /// What came in, without the ids: "s1r.motion set_speed [0.3, 0.0]".
  std::vector<std::string> Lines() const;
  /// How many lines begin with `start`.
  std::size_t Count(const std::string& start) const;
  void ClearLines();
  /// Waits up to 10 s for a line that begins with `start`.
  bool WaitForLine(const std::string& start) const;
  /// The ids in the order in which they came, over all connections.
  std::vector<std::string> Ids() const;
  /// Connections that are open.
  std::size_t Connections() const;
  /// Waits up to 10 s until that many connections are open.
  bool WaitForConnections(std::size_t count) const;

  /// Answers "component service" with this from now on ("SUCCESS [1]"); nullopt: never.
  void Answer(const std::string& request, std::optional<std::string> answer);
  /// The data of a sensor, without the timestamp: `"x": 1.0, "y": 2.0`.
  void SetData(const std::string& device, const std::string& members);
  /// Simulated seconds that a read adds; 0 lets time stand still.
  void SetStep(double seconds);
  /// Holds reads, and what follows them on their connection, until Release(); pings are answered.
  void Hold();
  void Release();
  /// From now on nothing is answered.
  void FallSilent();
  /// Closes every connection; `listen`: whether new ones are taken.
  void Disconnect(bool listen = true);
  /// Sends bytes to every client.
  void SendRaw(const std::string& bytes);
  /// Called in the server's thread with each line before it is answered.
  void OnLine(std::function<void(const std::string&)> hook);

 private:
  struct Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace ccmorse::test
