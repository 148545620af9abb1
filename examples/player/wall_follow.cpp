// Follows the wall on its right at half a metre or less.
//   ./wall_follow [host [port [seconds]]]

#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

int main(int argc, char** argv) {
  const std::string host = argc > 1 ? argv[1] : PLAYER_HOSTNAME;
  const int port = argc > 2 ? atoi(argv[2]) : PLAYER_PORTNUM;
  const double seconds = argc > 3 ? atof(argv[3]) : 60.0;
  const double wanted = 0.3;  // m
  try {
    PlayerClient robot(host, port);
    Position2dProxy position(&robot, 0);
    LaserProxy laser(&robot, 0);
    robot.Read();
    const double start = laser.GetDataTime();
    while (laser.GetDataTime() - start < seconds) {
      robot.Read();
      double right = laser.GetMaxRange();  // nearest at the right
      double ahead = right;                // and straight on
      for (uint32_t i = 0; i < laser.GetCount(); ++i) {
        const double bearing = laser.GetBearing(i);
        if (bearing < dtor(-45) && bearing > dtor(-115)) right = min(right, laser[i]);
        if (fabs(bearing) < dtor(20)) ahead = min(ahead, laser[i]);
      }
      const double turn = limit(2.0 * (wanted - right), -0.6, 0.6);
      if (ahead < wanted + 0.1) {
        position.SetSpeed(0.0, 0.8);  // a corner: turn left on the spot
      } else {
        position.SetSpeed(limit(0.4 * ahead, 0.05, 0.2), turn);
      }
    }
    position.SetSpeed(0, 0);
    robot.Read();
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
