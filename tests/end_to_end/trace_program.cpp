// A program that is compiled once and runs on whatever its address says: it steers by what laser
// and pose show, so that the smallest difference in what it is told or in what becomes of its
// commands grows, and prints all of it to the last bit.
//   trace_program ADDRESS [SECONDS [END]]
// END, what happens then: "return" (the default), "throw" without a catch, "exit" with all objects
// alive, "leave" the client on the heap.

#include <libplayerc++/playerc++.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>

using namespace PlayerCc;

namespace {

// Player's wire has ranges as floats: steered by those, the robot goes the same way by either.
double Seen(const LaserProxy& laser, uint32_t beam) {
  return static_cast<double>(static_cast<float>(laser.GetRange(beam)));
}

void Drive(PlayerClient& client, double seconds) {
  Position2dProxy base(&client, 0);    // takes speeds
  Position2dProxy camera(&client, 2);  // the pose in the world
  LaserProxy laser(&client, 0);
  double time = 0.0;
  while (time < seconds - 1e-6) {
    client.Read();
    time = laser.GetDataTime();
    if (time == 0.0) continue;  // a Player server's first data come a period later
    const uint32_t count = laser.GetCount();
    double ahead = 5.0;
    double balance = 0.0;
    for (uint32_t beam = 0; beam < count; ++beam) {
      if (beam >= count / 3 && beam < count - count / 3) ahead = min(ahead, Seen(laser, beam));
      balance += beam < count / 2 ? -Seen(laser, beam) : Seen(laser, beam);
    }
    const double turn = ahead < 0.35 ? 1.0 : balance / count + 0.2 * sin(camera.GetYaw());
    std::printf("%.17g %.17g %.17g %.17g %.17g %d", time, camera.GetDataTime(), camera.GetXPos(),
                camera.GetYPos(), camera.GetYaw(), base.GetStall() ? 1 : 0);
    for (uint32_t beam = 0; beam < count; beam += 31) std::printf(" %.17g", laser.GetRange(beam));
    std::printf("\n");
    base.SetSpeed(limit(0.5 * (ahead - 0.3), 0.0, 0.3), limit(turn, -1.0, 1.0));
  }
  base.SetSpeed(0.0, 0.0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const double seconds = argc > 2 ? atof(argv[2]) : 30.0;
  const std::string end = argc > 3 ? argv[3] : "return";
  try {
    auto client = std::make_unique<PlayerClient>(argv[1]);
    Drive(*client, seconds);
    if (end == "exit") std::exit(0);
    // A pointer stays, so that the address sanitizer does not call it a leak.
    [[maybe_unused]] static PlayerClient* volatile left = nullptr;
    if (end == "leave") left = client.release();
  } catch (const PlayerError& error) {
    std::fprintf(stderr, "%s: %s\n", error.GetErrorFun().c_str(), error.GetErrorStr().c_str());
    return 1;
  }
  if (end == "throw") {
    auto client = std::make_unique<PlayerClient>(argv[1]);
    throw std::runtime_error("the program's own");
  }
  return 0;
}
