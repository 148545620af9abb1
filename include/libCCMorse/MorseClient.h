#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "libCCMorse/MorseDevice.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseRobot.h"
#include "libCCMorse/MorseValue.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// The connection to a simulator and everything known about the simulation (thesis 3.1.1). It talks
/// to MORSE's service port and to ccmorse, which it recognises.
///
/// There is one client for each address: GetInstance() and Share() give the same object as long as
/// it is connected. The client owns the robots and devices. Every method may be called from any
/// thread: one may be inside Read() while others use getters, commands and requests. Data are
/// locked only while they are copied.
///
/// No method waits without a limit on a simulator that does not answer: after 3 s of silence, or at
/// once when the connection breaks, it throws MorseError. A Read() that waits for other clients of
/// a simulation in lock-step is no silence: the simulator answers pings meanwhile.
class MorseClient : public std::enable_shared_from_this<MorseClient> {
 public:
  /// The client of this address; connects when there is none yet. It stays connected until Close()
  /// or the end of the program. `port` 1..65535; CCMORSE_HOST and CCMORSE_PORT as for PlayerClient,
  /// so the host and port that the client then has may be others. `host` may be an address as well:
  /// "morse://HOST:PORT", or "sim:SCENARIO?option=value", a simulation within the program that
  /// starts with its first client and ends with the last (docs/player.md); then `port` has no
  /// meaning. Throws MorseError within 2 s when nobody answers; a simulation within the program
  /// takes as long as it takes to build.
  static MorseClient& GetInstance(const std::string& host, int port = 4000);
  /// The client that was made last. Throws MorseError when there is none.
  static MorseClient& GetInstance();
  /// As GetInstance(host, port), but counted: the connection closes when the last of those who
  /// share it lets go. This is what PlayerClient holds.
  static std::shared_ptr<MorseClient> Share(const std::string& host, int port = 4000);

  /// As Close().
  ~MorseClient();
  MorseClient(const MorseClient&) = delete;
  MorseClient& operator=(const MorseClient&) = delete;

  /// Sends the commands that still wait, then closes the connection. Robots, devices and their last
  /// data stay readable; commands are ignored from now on. Takes at most about 1 s. Never throws.
  void Close() noexcept;

  /// Whether the connection stands.
  bool Connected() const;
  std::string GetHostname() const;  ///< as it was given, or CCMORSE_HOST
  std::uint32_t GetPort() const;    ///< as it was given, or CCMORSE_PORT

  // --- The server connection as Player's PlayerClient has it (thesis 3.1.3)

  /// Sends the commands that wait and brings fresh data of every polled device (thesis 3.3): one
  /// message out, one query a device or, on a fast link, one for all that are in use; then the
  /// valid and fresh flags of all proxies. It returns at the next read time of the simulation, so
  /// it paces a loop. Throws MorseError when the connection breaks, when the simulation has ended
  /// (see MorseError::SimulationEnded()), and, after the data were taken, when the simulator
  /// refused an earlier command.
  void Read();
  /// Whether Read() would find something without waiting; waits up to `timeout_ms` for it. In a
  /// simulation in lock-step time stands still between two reads, and at the pace "max" there is
  /// always more to read: there, the first Peek(0) after a Read() is false and any further one
  /// true, so that `while (Peek(0)) Read();` ends and a program that polls goes on. On plain MORSE
  /// it is true when a tick, 1/60 s, has passed since the last Read(). Throws MorseError when the
  /// connection is lost.
  bool Peek(int timeout_ms = 0);
  /// Read() if Peek(0).
  void ReadIfWaiting();
  /// Reads in a loop in the calling thread, with `timeout_ms` of sleep between reads, until Stop().
  void Run(int timeout_ms = 10);
  /// Ends Run() and the loop of StartThread() after the current Read().
  void Stop();
  /// Starts a thread that reads in a loop. A refused command does not end it; the end of the
  /// simulation and a lost connection do, and the next Read() reports them. Nothing happens when it
  /// runs already.
  void StartThread();
  /// Ends that thread, even when its Read() still waits for other clients, and joins it.
  void StopThread();

  /// How long a request may take, s (default 5). Throws MorseError unless above 0.
  void SetRequestTimeout(double seconds);
  double GetRequestTimeout() const;  ///< s
  /// Kept for Player's programs: the client never reconnects by itself. Default 0.
  void SetRetryLimit(int limit);
  int GetRetryLimit() const;  ///< as set
  /// Kept for Player's programs, s. Default 2.
  void SetRetryTime(double seconds);
  double GetRetryTime() const;  ///< s, as set
  /// No effect: data are always pulled, and only the latest are kept. 1 push, 2 pull.
  void SetDataMode(int mode);
  /// No effect: only the latest data are ever kept.
  void SetReplaceRule(bool replace, int type = -1, int subtype = -1, int interf = -1);
  /// No effect: the list is known since the connection was made.
  void RequestDeviceList();
  /// The devices that proxies can be made for, by the robots' configuration (thesis 3.2).
  std::list<playerc_device_info_t> GetDeviceList() const;
  /// Interface code of a name: 4 for "position2d", 6 for "laser", 0xFFFF when unknown.
  int LookupCode(const std::string& name) const;
  /// Name of an interface code; "unknown" when unknown.
  std::string LookupName(int code) const;
  /// Messages lost on the way: 0, nothing is ever dropped.
  std::uint32_t GetOverflowCount();

  // --- The simulation

  /// All robots, in the order in which the simulator lists them.
  const std::vector<MorseRobot*>& GetRobots() const;
  /// The robot of that name. Throws MorseError that lists the robots when there is none.
  MorseRobot& GetRobot(const std::string& name) const;
  /// All devices of all robots.
  std::vector<MorseDevice*> GetDevices() const;

  /// Whether the server is ccmorse; else it is plain MORSE.
  bool IsCCMorse() const;
  /// What the server calls itself, "ccmorse 0.1.0"; "MORSE" for plain MORSE.
  std::string GetServerName() const;
  /// "realtime", "lockstep" or "max"; "realtime" for plain MORSE.
  std::string GetPace() const;
  /// "fast" when data come as ccmorse's binary frames (docs/protocols/fast-link.md), "json" when
  /// they come as MORSE's lines. The client and the simulator agree by themselves; the environment
  /// variable CCMORSE_LINK=json keeps a program to lines. What a program sees is the same.
  std::string GetLink() const;
  /// Ticks a simulated second; 60 for plain MORSE.
  double GetFrequency() const;
  /// Simulated seconds between two reads; one tick for plain MORSE.
  double GetReadPeriod() const;
  /// Simulated time of the last Read(), s; 0 before the first.
  double GetTime() const;

  /// Queues a one-way command for a component; see MorseDevice::Command(). More than 1 MiB of
  /// waiting commands are sent at once.
  void Command(const std::string& component, const std::string& service,
               const MorseArgs& args = MorseArgs());
  /// Calls a service of a component and waits for the answer, after the commands that wait were
  /// sent; see MorseDevice::Request().
  MorseValue Request(const std::string& component, const std::string& service,
                     const MorseArgs& args = MorseArgs(), double timeout = -1.0);
  /// Sends the commands that wait now.
  void Flush();
  /// Has `prepare` called at the start of every Read(), in the thread that reads, until the handle
  /// goes: for commands that leave with this Read(). `prepare` may use commands and getters, no
  /// Read(); it must not throw. A call that is on its way when the handle goes is finished.
  [[nodiscard]] std::shared_ptr<void> BeforeRead(std::function<void()> prepare);

 private:
  friend class MorseDevice;
  friend class MorseRobot;
  struct Impl;
  MorseClient(const std::string& host, int port);
  std::mutex& DataMutex() const;
  void Connect();
  void ReadOnce(bool may_abandon);
  // On a fast link: data of a device that was not asked for so far, unless the next Read() brings
  // them anyway. `text`: as text, whatever it takes.
  void Fetch(const std::string& device, bool text);
  void AskWithRead(const std::string& component, const std::string& service,
                   std::function<void(const MorseValue&)> take);
  bool QueueNumbers(const std::string& component, const std::string& service, const double* numbers,
                    std::size_t count);
  bool QueueImage(const std::string& component, const std::string& service, int width, int height,
                  const std::vector<Color_t>& image);
  bool QueuePixels(const std::string& component, const std::string& service,
                   const PixelUpdate_t* pixels, std::size_t count);

  const std::unique_ptr<Impl> impl_;
};

}  // namespace CCMorse
