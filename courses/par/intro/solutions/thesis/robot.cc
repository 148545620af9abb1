// The control loop of the introduction task, after Appendix C.2 of the thesis.
//
// Where the thesis's parts are (its line numbers):
//   options, with their defaults for either platform   l.16-40    CRobot::getConfig()
//   connection, proxies, wait for the first scan       l.42-71    CRobot::CRobot()
//   end of the thread, clean-up                        l.73-91    ~CRobot(), release(), stop()
//   errors that end the thread                         l.93-109   threadBody()
//   control loop                                       l.111-283  navigation()
//     window, constants, state                         l.114-132  its beginning, avoidance.h
//     reading data                                     l.140-143  "All that has arrived"
//     position: save, log, draw                        l.146-181  "Position"
//     window drawing                                   l.161-178  inside it, under _MORSE
//     laser: log, set up on the first scan             l.183-201  "Laser", beamWindow()
//     nearest obstacle in either half                  l.203-229  "Laser"
//     velocities                                       l.231-264  avoid() in avoidance.h
//     command, quit request                            l.272-278  "Command"
//
// What differs from the thesis, and why:
//   - the options coords, x, y and yaw, which the thesis declares only, set the odometry;
//   - `alive`, never used there, says whether an error has ended the loop;
//   - the end of the simulation is not an error but an end;
//   - a constructor that fails gives back what it has made;
//   - the indexes of the nearest beams, never used there, are not kept.

#include "robot.h"

#include <cmath>
#include <cstdlib>

#include "avoidance.h"
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"

using namespace imr::robot;
using namespace CCMorse;

namespace {

// The index of a device from the option `name`; throws imr::argument_error if it is negative.
unsigned deviceIndex(imr::CConfig& config, const std::string& name) {
  const int index = config.get<int>(name);
  imr::assert_argument(index >= 0, "option --" + name + " must not be negative");
  return static_cast<unsigned>(index);
}

}  // namespace

imr::CConfig& CRobot::getConfig(imr::CConfig& config) {
#ifdef _MORSE
  config.add<std::string>("host", "morse server hostname", "localhost");
  config.add<int>("port", "morse server port", 4000);
#else
  config.add<std::string>("host", "syrotek server hostname", "syrotek.felk.cvut.cz");
  config.add<int>("port", "syrotek server port", 38000);
#endif  // _MORSE
  config.add<int>("laser-index", "laser index", 0);
  config.add<int>("position2d-index", "position2d index", 0);
  config.add<bool>("coords", "enable/disable settings of initial coords of the robot", false);
  config.add<double>("x", "initial x position of the robot", 0.0);
  config.add<double>("y", "initial y position of the robot", 0.0);
  config.add<double>("yaw", "initial yaw of the robot", 0.0);
  return config;
}

CRobot::CRobot(imr::CConfig& config)
    : ThreadBase(),
      cfg(config),
      client(nullptr),
      quit(false),
      alive(true),
      laser(nullptr),
      position2d(nullptr),
#ifdef _MORSE
      windowMade(false),
#endif
      secondsLimit(0.0) {
  try {
    client = new CCMorse::PlayerClient(cfg.get<std::string>("host"), cfg.get<int>("port"));
    laser = new LaserProxy(client, deviceIndex(cfg, "laser-index"));
    position2d = new Position2dProxy(client, deviceIndex(cfg, "position2d-index"));
#ifdef _MORSE
    // One pixel of the window is 2 cm of the arena.
    CCMorse::WindowProxy::GetInstance(client, 172, 186);
    windowMade = true;
#endif  // _MORSE

    assert_argument(laser, "Can not create laser proxy");
    assert_argument(position2d, "Can not create position2d proxy");

    // Data flow only after the proxies have been made; the loop below must not start without.
    while (!laser->IsFresh()) {
      client->Read();
      while (client->Peek(0)) {
        client->Read();
      }
    }

    if (cfg.get<bool>("coords")) {
      position2d->SetOdometry(cfg.get<double>("x"), cfg.get<double>("y"), cfg.get<double>("yaw"));
    }
  } catch (...) {
    release();  // no destructor runs for an object that was never complete
    throw;
  }
  DEBUG("CRobot: Done.");
}

CRobot::~CRobot() {
  stop();
  join();
  release();
}

void CRobot::release() {
#ifdef _MORSE
  if (windowMade) {
    try {
      delete &CCMorse::WindowProxy::GetInstance();
    } catch (CCMorse::MorseError&) {
      // Somebody else has deleted the window already, so nothing is left to do.
    }
  }
#endif  // _MORSE
  // The proxies use the connection, so it goes last.
  delete laser;
  delete position2d;
  delete client;
}

void CRobot::stop(void) {
  ScopedLock lk(mtx);
  quit = true;
}

void CRobot::stopAfter(double seconds) { secondsLimit = seconds; }

bool CRobot::isAlive() {
  ScopedLock lk(mtx);
  return alive;
}

SSummary CRobot::getSummary() {
  ScopedLock lk(mtx);
  return summary;
}

void CRobot::threadBody(void) {
  try {
    navigation();
  } catch (CCMorse::MorseError& e) {
    if (e.SimulationEnded()) {
      INFO("The simulation has ended.");
      return;
    }
    ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
    ScopedLock lk(mtx);
    alive = false;
  } catch (imr::exception& e) {
    ERROR("Imr error: " << e.what());
    exit(-1);
  }
}

void CRobot::navigation(void) {
  bool q = false, laserFirst = true, poseFirst = true;
#ifdef _MORSE
  WindowProxy& window = CCMorse::WindowProxy::GetInstance();
  ImagePoint_t last, current;
#endif  // _MORSE

  SBeamWindow beams;
  double v = 0.0, w = 0.0, maxRange = 5.0, startTime = 0.0;

  DEBUG("Navigation started.");

  position2d->SetMotorEnable(true);
  do {
    // All that has arrived: Read() waits for news, and so sets the pace of this loop; Peek() tells
    // whether more is waiting already.
    client->Read();
    while (client->Peek(0)) {
      client->Read();
    }

    // Position: kept, logged and, in the simulator, drawn.
    if (position2d->IsFresh() && position2d->IsValid()) {
      const SPosition previous = pos;
      pos.x = position2d->GetXPos();
      pos.y = position2d->GetYPos();
      pos.yaw = position2d->GetYaw();
      DEBUG("POSITION " << pos.x << " " << pos.y << " " << pos.yaw);
      DEBUG("SPEED " << position2d->GetXSpeed() << " " << position2d->GetYSpeed() << " "
                     << position2d->GetYawSpeed());
      if (!poseFirst) {
        ScopedLock lk(mtx);
        summary.distance += std::hypot(pos.x - previous.x, pos.y - previous.y);
      }
#ifdef _MORSE
      if (poseFirst) {
        last = ImagePoint_t(window.GetX(pos.x), window.GetY(pos.y));
        current = last;
      }
      // The way since the last position in green, the position itself in magenta.
      current = ImagePoint_t(window.GetX(pos.x), window.GetY(pos.y));
      window.SetLine(last.x, last.y, current.x, current.y, 0, 255, 0);
      window.SetPixel(current.x, current.y, 255, 0, 255);
      last = current;
#endif  // _MORSE
      poseFirst = false;
      position2d->NotFresh();  // this position has been used
    }

    // Laser: new velocities from a new scan.
    if (laser->IsFresh() && laser->IsValid()) {
      DEBUG("laser " << laser->GetMinAngle() << " " << laser->GetMaxAngle() << " "
                     << laser->GetCount());
      if (laserFirst) {
        maxRange = laser->GetMaxRange();
        beams = beamWindow(laser->GetCount(), laser->GetScanRes());
        startTime = laser->GetDataTime();
        laserFirst = false;
      }

      // Without an obstacle a half has the laser's maximal range, which is far.
      SNearest left = {maxRange, 0.0}, right = {maxRange, 0.0};
      for (unsigned i = beams.left; i < beams.center; i++) {
        if ((*laser)[i] < left.range) {
          left.range = (*laser)[i];
          left.bearing = laser->GetBearing(i);
        }
      }
      for (unsigned i = beams.right; i > beams.center; i--) {
        if ((*laser)[i] < right.range) {
          right.range = (*laser)[i];
          right.bearing = laser->GetBearing(i);
        }
      }
      const SVelocity velocity = avoid(left, right);
      v = velocity.v;
      w = velocity.w;

      const double nearest = std::min(left.range, right.range);
      {
        ScopedLock lk(mtx);
        summary.nearest = summary.scans == 0 ? nearest : std::min(summary.nearest, nearest);
        summary.seconds = laser->GetDataTime() - startTime;
        ++summary.scans;
        // Half a millisecond less: times are sums of ticks, and may fall short by a rounding.
        if (secondsLimit > 0.0 && summary.seconds >= secondsLimit - 0.0005) quit = true;
      }
      laser->NotFresh();  // this scan has been used
    }

    // Command.
    position2d->SetSpeed(v, w);

    ScopedLock lk(mtx);  // is somebody asking us to end?
    q |= quit;
  } while (!q);

  position2d->SetMotorEnable(false);

  INFO("Main loop has been left");
}
