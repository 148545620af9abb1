// Sends the robot to places by the goal driver of position2d:1 (SND on SyRoTek and ccmorse's Player
// server); with index 0 by the robot's own position control.
//   ./goto_snd host port index x y [x y ...]

#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

int main(int argc, char** argv) {
  if (argc < 6) {
    std::cerr << "usage: " << argv[0] << " host port index x y [x y ...]" << std::endl;
    return 2;
  }
  const double tolerance = 0.1;  // m
  const double patience = 120;   // s for a goal
  try {
    PlayerClient robot(argv[1], atoi(argv[2]));
    Position2dProxy position(&robot, atoi(argv[3]));
    position.SetMotorEnable(true);
    robot.Read();
    for (int i = 4; i + 1 < argc; i += 2) {
      const double x = atof(argv[i]);
      const double y = atof(argv[i + 1]);
      const double start = position.GetDataTime();
      position.GoTo(x, y, 0);
      while (hypot(position.GetXPos() - x, position.GetYPos() - y) > tolerance) {
        robot.Read();
        if (position.GetDataTime() - start > patience) {
          std::cerr << "the goal " << x << ", " << y << " was not reached" << std::endl;
          return 1;
        }
      }
      std::cout << "at " << position.GetXPos() << ", " << position.GetYPos() << std::endl;
    }
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
