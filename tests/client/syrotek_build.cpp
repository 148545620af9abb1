// A program as it is built for the real robot (thesis 3.4): without _MORSE, with SyRoTek's headers
// and a PI of its own. It succeeds when a connection that nobody answers is a MorseError.

#include "libPlayer/LaserProxy.h"
#include "libPlayer/PlayerClient.h"
#include "libPlayer/Position2dProxy.h"
#define PI 3.14159265359

#include <iostream>

#include "libCCMorse/MorseError.h"

using namespace CCMorse;

int main() {
  try {
    PlayerClient client("127.0.0.1", 1);
    LaserProxy laser(&client, 0);
    Position2dProxy position2d(&client, 0);
    position2d.SetSpeed(0.0, PI / 180);
  } catch (CCMorse::MorseError& e) {
    std::cout << e.GetErrorStr() << " function: " << e.GetErrorFun() << "\n";
    return 0;
  }
  return 1;
}
