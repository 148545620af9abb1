// Proves that every call of the thesis's listing compiles against the library as the listing writes
// it: the same headers in the same order, the same qualified and unqualified names, the same
// argument types and literals. The program around the calls is not the listing's. Built with and
// without _MORSE. Line numbers are those of Appendix C.1 and C.2.
//
// Without arguments it prints its options; with a host and a port it makes every call once there.

// The includes stay in the listing's order.
// clang-format off
// C.1 l.4-15
#ifdef _MORSE
#include "libCCMorse/CCMorse.h"
#else
#include "libPlayer/Position2dProxy.h"
#include "libPlayer/LaserProxy.h"
#include "libPlayer/PlayerClient.h"
#define PI 3.14159265359
#endif

#include "imr-h/imr_config.h"
#include "imr-h/thread.h"
// clang-format on

struct SPosition {
  double x, y, yaw;
};

// C.1 l.17-43
namespace imr {
namespace robot {

class CRobot : public imr::concurrent::CThread {
  typedef imr::concurrent::CThread ThreadBase;

 public:
  static imr::CConfig& getConfig(imr::CConfig& config);
  CRobot(imr::CConfig& cfg);
  ~CRobot();
  void stop(void);

 protected:
  void threadBody(void);
  void navigation(void);

 private:
  imr::CConfig& cfg;
  CCMorse::PlayerClient* client;
  bool quit;
  bool alive;
  SPosition pos;
  CCMorse::LaserProxy* laser;
  CCMorse::Position2dProxy* position2d;
  Mutex mtx;
};

}  // namespace robot
}  // namespace imr

// clang-format off
// C.2 l.1-8
#include <unistd.h>
#include <fstream>
#include "imr-h/logging.h"
#include "imr-h/imr_exceptions.h"
#include "libCCMorse/MorseError.h"
// clang-format on

// C.2 l.10-13
using namespace imr::robot;
using namespace CCMorse;
typedef unsigned char uchar;

// C.2 l.16-39
imr::CConfig& CRobot::getConfig(imr::CConfig& config) {
#ifdef _MORSE
  config.add<std::string>("host", "server", "localhost");
  config.add<int>("port", "port", 4000);
#else
  config.add<std::string>("host", "server", "syrotek.felk.cvut.cz");
  config.add<int>("port", "port", 38000);
#endif
  config.add<int>("laser-index", "laser", 0);
  config.add<bool>("coords", "coords", false);
  config.add<double>("x", "x", 0.0);
  return config;
}

// C.2 l.42-71
CRobot::CRobot(imr::CConfig& cfg)
    : ThreadBase(), cfg(cfg), client(0), quit(false), alive(true), pos(), laser(0), position2d(0) {
  client = new CCMorse::PlayerClient(cfg.get<std::string>("host"), cfg.get<int>("port"));
  laser = new LaserProxy(client, cfg.get<int>("laser-index"));
  position2d = new Position2dProxy(client, cfg.get<int>("laser-index"));
#ifdef _MORSE
  CCMorse::WindowProxy::GetInstance(client, 172, 186);
#endif
  assert_argument(laser, "no laser");
  assert_argument(position2d, "no position2d");
  while (!laser->IsFresh()) {
    client->Read();
    while (client->Peek(0)) {
      client->Read();
    }
  }
  DEBUG("ready");
}

// C.2 l.73-86
CRobot::~CRobot() {
  stop();
  join();
  if (client) {
#ifdef _MORSE
    delete &CCMorse::WindowProxy::GetInstance();
#endif
    delete laser;
    delete position2d;
    delete client;
  }
}

// C.2 l.88-92
void CRobot::stop(void) {
  ScopedLock lk(mtx);
  quit = true;
}

// C.2 l.94-109
void CRobot::threadBody(void) {
  try {
    navigation();
  } catch (CCMorse::MorseError& e) {
    ERROR("error: " << e.GetErrorStr() << " in " << e.GetErrorFun());
  } catch (imr::exception& e) {
    ERROR("error: " << e.what());
    exit(-1);
  }
}

// C.2 l.111-283
void CRobot::navigation(void) {
  bool q = false;
#ifdef _MORSE
  WindowProxy& window = CCMorse::WindowProxy::GetInstance();
  ImagePoint_t last, current;
#endif
  double const HALF_FOV = (40 * (PI / 180));  // l.122
  unsigned edge = 340, center = 340;
  double v = 0.0, w = 0.0, maxRange = 5.0, lMin = 5.0, lMinAngle = 0.0;
  uchar beams = 0;

  position2d->SetMotorEnable(true);
  do {
    client->Read();
    while (client->Peek(0)) {
      client->Read();
    }
    if (position2d->IsFresh() && position2d->IsValid()) {
      pos.x = position2d->GetXPos();
      pos.y = position2d->GetYPos();
      pos.yaw = position2d->GetYaw();
      DEBUG("at " << pos.x << " " << pos.y << " " << pos.yaw);
      DEBUG("by " << position2d->GetXSpeed() << " " << position2d->GetYSpeed() << " "
                  << position2d->GetYawSpeed());
#ifdef _MORSE
      last = ImagePoint_t(window.GetX(pos.x), window.GetY(pos.y));
      current = last;
      current = ImagePoint_t(window.GetX(pos.x), window.GetY(pos.y));
      window.SetLine(last.x, last.y, current.x, current.y, 0, 255, 0);
      window.SetPixel(current.x, current.y, 255, 0, 255);
#endif
      position2d->NotFresh();
    }
    if (laser->IsFresh() && laser->IsValid()) {
      DEBUG("laser " << laser->GetMinAngle() << " " << laser->GetMaxAngle() << " "
                     << laser->GetCount());
      maxRange = laser->GetMaxRange();
      edge = (unsigned)(HALF_FOV / laser->GetScanRes());
      center = (unsigned)(laser->GetCount() / 2);
      lMin = maxRange;
      for (unsigned i = center - edge; i < center; i++) {
        if ((*laser)[i] < lMin) {
          lMin = (*laser)[i];
          lMinAngle = laser->GetBearing(i);
          beams++;
        }
      }
      DEBUG("nearest " << lMin << " at " << lMinAngle << " after " << int(beams));
      laser->NotFresh();
    }
    position2d->SetSpeed(v, w);
    ScopedLock lk(mtx);
    q |= quit;
  } while (!q && alive);
  position2d->SetMotorEnable(false);
  INFO("left");
}

int main(int argc, char** argv) {
  imr::CConfig config;
  CRobot::getConfig(config);
  if (argc < 3) {
    config.print(std::cout);
    return 0;
  }
  config.set<std::string>("host", argv[1]);
  config.setText("port", argv[2]);
  try {
    CRobot robot(config);
    robot.execute();
    usleep(300000);
  } catch (CCMorse::MorseError& e) {
    ERROR(e.GetErrorStr());
    return 1;
  }
  return 0;
}
