#pragma once

// With _MORSE the program is for the simulator, without it for the real robot (thesis 3.4). The
// real robot's headers declare the same classes under the names that SyRoTek's programs include.
#ifdef _MORSE
#include "libCCMorse/CCMorse.h"
#else
#include "libPlayer/LaserProxy.h"
#include "libPlayer/PlayerClient.h"
#include "libPlayer/Position2dProxy.h"
#ifndef PI
#define PI 3.14159265359
#endif
#endif

#include "imr-h/imr_config.h"
#include "imr-h/thread.h"
#include "robot_types.h"

namespace imr {
namespace robot {

/// What a drive came to.
struct SSummary {
  double seconds = 0.0;     ///< From the first scan to the last, by the scans' own time [s].
  unsigned long scans = 0;  ///< Scans that were looked at.
  double distance = 0.0;    ///< Length of the path between the reported positions [m].
  double nearest = -1.0;    ///< Smallest range among the beams looked at [m]; -1 without a scan.
};

/// The robot of the introduction task: drives around and avoids obstacles by the laser
/// (thesis 3.4, Appendix C).
///
/// The constructor connects and waits for the first scan; execute() starts the control loop in a
/// thread of its own; stop() ends it. One thread, the owner's, may call the public functions while
/// the loop runs. The robot owns the connection, its proxies and, in the simulator, the window.
class CRobot : public imr::concurrent::CThread {
  typedef imr::concurrent::CThread ThreadBase;

 public:
  /// Adds the robot's options to `config`, and returns it (thesis C.2 l.16-39).
  /// Throws imr::bad_usage if one is there already.
  static imr::CConfig& getConfig(imr::CConfig& config);

  /// Connects to the server that the options name, and returns when the laser has sent a scan.
  /// Throws CCMorse::MorseError if there is no server or no such device; nothing stays open then.
  /// @param config Must hold the options of getConfig(), and outlive the robot.
  explicit CRobot(imr::CConfig& config);

  /// Stops the control loop, waits for its end and closes the connection.
  ~CRobot() override;

  /// Asks the control loop to end; it does within one cycle. Safe at any time.
  void stop(void) override;

  /// Makes the control loop end by itself so many seconds after its first scan, by the time of the
  /// scans: seconds of the simulation, however fast that runs. 0 means never. To be called before
  /// execute().
  void stopAfter(double seconds);

  /// False once an error has ended the control loop.
  bool isAlive();

  /// What has been driven up to now.
  SSummary getSummary();

 protected:
  void threadBody(void) override;

  /// The control loop; returns when stop() was called or the time is over.
  void navigation(void);

 private:
  void release();  // deletes what the robot owns; for the destructor and a failed constructor

  imr::CConfig& cfg;

  CCMorse::PlayerClient* client;
  bool quit;      // guarded by mtx
  bool alive;     // guarded by mtx
  SPosition pos;  // the last reported position; only the control loop uses it
  CCMorse::LaserProxy* laser;
  CCMorse::Position2dProxy* position2d;
#ifdef _MORSE
  bool windowMade;  // whether this robot made the window, and has to delete it
#endif
  double secondsLimit;
  SSummary summary;  // guarded by mtx
  Mutex mtx;
};

}  // namespace robot
}  // namespace imr
