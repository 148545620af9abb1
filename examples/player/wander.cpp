// Drives about and turns away from what is near.
//   ./wander [host [port [seconds]]]

#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

namespace {

// The shortest range between two bearings, rad.
double Nearest(const LaserProxy& laser, double from, double to) {
  double nearest = laser.GetMaxRange();
  for (uint32_t i = 0; i < laser.GetCount(); ++i) {
    const double bearing = laser.GetBearing(i);
    if (bearing >= from && bearing <= to && laser[i] < nearest) nearest = laser[i];
  }
  return nearest;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string host = argc > 1 ? argv[1] : PLAYER_HOSTNAME;
  const int port = argc > 2 ? atoi(argv[2]) : PLAYER_PORTNUM;
  const double seconds = argc > 3 ? atof(argv[3]) : 60.0;
  const double near = 0.35;  // m
  try {
    PlayerClient robot(host, port);
    Position2dProxy position(&robot, 0);
    LaserProxy laser(&robot, 0);
    position.SetMotorEnable(true);
    robot.Read();
    const double start = laser.GetDataTime();
    double turn = 0.0;  // rad/s; kept while something is in the way, so that it gets out of corners
    while (laser.GetDataTime() - start < seconds) {
      robot.Read();
      const double ahead = Nearest(laser, dtor(-30), dtor(30));
      if (ahead > near && !position.GetStall()) {
        turn = 0.0;
      } else if (turn == 0.0) {
        turn = laser.GetMinLeft() < laser.GetMinRight() ? dtor(-60) : dtor(60);
      }
      position.SetSpeed(turn == 0.0 ? limit(0.5 * (ahead - 0.1), 0.05, 0.3) : 0.0, turn);
    }
    position.SetSpeed(0, 0);
    robot.Read();
    std::cout << "ended at " << position.GetXPos() << ", " << position.GetYPos() << std::endl;
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
