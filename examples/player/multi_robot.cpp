// Several robots in one program: each address is a robot of its own, and the indexes of one address
// are robots, too, where it has several. They turn on the spot, one after the other.
//   ./multi_robot host port [host port ...]

#include <libplayerc++/playerc++.h>

using namespace PlayerCc;

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: " << argv[0] << " host port [host port ...]" << std::endl;
    return 2;
  }
  try {
    std::list<PlayerClient*> servers;
    std::vector<Position2dProxy*> robots;
    for (int i = 1; i + 1 < argc; i += 2) {
      servers.push_back(new PlayerClient(argv[i], atoi(argv[i + 1])));
      servers.back()->RequestDeviceList();
      const std::list<playerc_device_info_t> devices = servers.back()->GetDeviceList();
      for (const playerc_device_info_t& device : devices) {
        if (device.addr.interf != PLAYER_POSITION2D_CODE) continue;
        std::cout << *servers.back() << ": " << device << std::endl;
        robots.push_back(new Position2dProxy(servers.back(), device.addr.index));
      }
    }
    for (Position2dProxy* robot : robots) {
      robot->SetSpeed(0.0, dtor(45));
      for (int round = 0; round < 10; ++round) {
        for (PlayerClient* server : servers) server->Read();
      }
      robot->SetSpeed(0.0, 0.0);
      std::cout << robot->GetDriverName() << " turned to " << rtod(robot->GetYaw()) << " degrees"
                << std::endl;
    }
    for (PlayerClient* server : servers) server->Read();
    for (PlayerClient* server : servers) delete server;  // before the proxies: that is safe here
    for (Position2dProxy* robot : robots) delete robot;
  } catch (PlayerError& error) {
    std::cerr << error << std::endl;
    return 1;
  }
  return 0;
}
