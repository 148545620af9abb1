#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace CCMorse::core {

/// Where a program is to connect that asks for this host and port. A simulator's usual address,
/// localhost (or 127.0.0.1) with port 4000 or Player's 6665, gives way to the environment's
/// CCMORSE_HOST and CCMORSE_PORT, so that `ccmorse batch` can run many programs that have it built
/// in side by side; any other address stays. CCMORSE_HOST may be "sim:...". Throws MorseError when
/// CCMORSE_PORT is no port.
std::pair<std::string, int> AddressFor(const std::string& host, int port);

/// A simulator's own port, MORSE's.
inline constexpr int kMorsePort = 4000;
/// Player's.
inline constexpr int kPlayerPort = 6665;

/// An address in its parts.
struct Location {
  std::string scheme;  ///< "morse", "player", "sim", or "" for a plain host
  std::string host;    ///< of a simulation within the program all of it, "sim:" included
  int port = 0;        ///< 0 for a simulation within the program
};

/// Reads "player://host:6665", "morse://host", "host" or "sim:...". `port` holds where the address
/// has none; Player's own stands for MORSE's then if the scheme is "morse". Throws MorseError from
/// `function`.
Location ParseAddress(const std::string& address, int port, const char* function);

/// Does the address ask for a simulation within the program?
bool IsInProcess(std::string_view address);

/// "host:port", or "sim:..." as it is, for messages.
std::string AddressText(const std::string& host, int port);

/// An address "sim:SCENARIO?option=value&...": what is the connection's own, `protocol` and
/// `robot`, apart from what makes the simulation.
struct InProcessAddress {
  std::string simulation;          ///< without "sim:"; the other options in their order
  std::string protocol = "morse";  ///< or "player"
  std::string robot;               ///< with "player": whose devices; "" for the first
};

/// Throws MorseError from `function` for a protocol that is neither, and for a robot without one.
InProcessAddress ParseInProcess(std::string_view address, const char* function);

}  // namespace CCMorse::core
