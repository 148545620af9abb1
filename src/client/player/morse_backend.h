#pragma once

#include <memory>
#include <string>

#include "client/player/backend.h"

namespace CCMorse::playerlink {

/// ccmorse or MORSE beneath Player's proxies, over the MorseClient of this address, which it shares
/// with everybody else who uses it (see MorseClient::Share()). It has position2d and laser by the
/// robots' tables (thesis 3.2), ranger for the scanners without a table, graphics2d over the pens,
/// and simulation. Throws MorseError.
std::unique_ptr<PlayerBackend> OpenSimulator(const std::string& host, int port);

}  // namespace CCMorse::playerlink
