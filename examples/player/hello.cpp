// The first program: where the robot is, and what its scanner sees straight ahead.
//   ./hello [host [port]]

#include <libplayerc++/playerc++.h>

int main(int argc, char** argv) {
  using namespace PlayerCc;
  const std::string host = argc > 1 ? argv[1] : PLAYER_HOSTNAME;
  const int port = argc > 2 ? atoi(argv[2]) : PLAYER_PORTNUM;
  try {
    PlayerClient robot(host, port);
    Position2dProxy position(&robot, 0);
    LaserProxy laser(&robot, 0);
    while (!position.IsFresh() || !laser.IsFresh()) robot.Read();
    std::cout << robot << "\n" << position;
    std::cout << laser.GetCount() << " beams, ahead " << laser[laser.GetCount() / 2] << " m\n";
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
