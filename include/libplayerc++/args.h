#pragma once

// The options that Player's own example programs share (specs: player.md A.1, H17): -h HOST,
// -p PORT, -i INDEX, -d DEBUG, -u UPDATE_RATE, -g USE_GPS, -m DATAMODE. parse_args(argc, argv) sets
// the globals below; include it in one file of a program.

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include "libplayerc++/playerc++.h"

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables,cert-err58-cpp,misc-definitions-in-headers)
#define DEFAULT_HOST PlayerCc::PLAYER_HOSTNAME
#define DEFAULT_PORT PlayerCc::PLAYER_PORTNUM
#define DEFAULT_DEBUG 0
#define DEFAULT_INDEX 0
#define DEFAULT_FREQ 0
#define DEFAULT_DATAMODE PLAYER_DATAMODE_PUSH

std::string gHostname(DEFAULT_HOST);
std::uint32_t gPort(DEFAULT_PORT);
std::uint32_t gIndex(DEFAULT_INDEX);
std::uint32_t gDebug(DEFAULT_DEBUG);
std::uint32_t gFrequency(DEFAULT_FREQ);
std::uint32_t gDataMode(DEFAULT_DATAMODE);
bool gUseLaser(false);

/// Prints the options.
inline void print_usage(int /*argc*/, char** argv) {
  std::cerr << "USAGE:  " << argv[0] << " [options]\n\n"
            << "  -h HOST    host of the server, " << DEFAULT_HOST << "\n"
            << "  -p PORT    its port, " << DEFAULT_PORT << "\n"
            << "  -i INDEX   index of the device, " << DEFAULT_INDEX << "\n"
            << "  -d LEVEL   how much to print, " << DEFAULT_DEBUG << "\n"
            << "  -u RATE    updates a second, " << DEFAULT_FREQ << "\n"
            << "  -l         use the laser\n"
            << "  -m MODE    data mode, 1 push, 2 pull, " << DEFAULT_DATAMODE << "\n";
}

/// Reads the options; 0, or -1 when one is unknown. `-?` prints them and ends the program.
inline int parse_args(int argc, char** argv) {
  const auto number = [] { return static_cast<std::uint32_t>(std::strtoul(optarg, nullptr, 10)); };
  for (int option = 0; (option = getopt(argc, argv, "h:p:i:d:u:lm:?")) != -1;) {
    switch (option) {
      case 'h':
        gHostname = optarg;
        break;
      case 'p':
        gPort = number();
        break;
      case 'i':
        gIndex = number();
        break;
      case 'd':
        gDebug = number();
        break;
      case 'u':
        gFrequency = number();
        break;
      case 'l':
        gUseLaser = true;
        break;
      case 'm':
        gDataMode = number();
        break;
      default:
        print_usage(argc, argv);
        return -1;
    }
  }
  return 0;
}
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables,cert-err58-cpp,misc-definitions-in-headers)
